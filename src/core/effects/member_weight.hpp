// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/effect.hpp"
#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"

namespace funicular {

/// ½ wL g l on each end of each member, l its present length (paper section 3.3).
class MemberLoads final : public Effect {
public:
    /// \throws InvalidInput for a weight that is negative or not finite.
    MemberLoads(const Net &net, const MemberWeight &description, const Scale &scale);

    [[nodiscard]] std::string_view name() const override { return "member_weight"; }
    [[nodiscard]] std::size_t bytes() const override {
        return sizeof(*this) + sizeof(double) * static_cast<std::size_t>(lines_.size());
    }
    void add_forces(const Points &x, Points &forces) const override;
    void couple(Coupling &coupling) const override;
    void add_tangent(const Points &x, BlockMatrix &tangent) const override;
    void add_tangent_product(const Points &x, const Points &motion, Points &product) const override;

private:
    [[nodiscard]] double half_weight(std::size_t member) const {
        return lines_.size() == 0 ? half_weight_ : half_weight_ * lines_[static_cast<Index>(member)];
    }
    /// Calls add(node, by, gradient) for each derivative of a node's upward load by the place of another.
    template <class Add>
    void differentiate(const Points &x, const Add &add) const;

    const Net &net_;
    double half_weight_;
    Eigen::VectorXd lines_;
};

} // namespace funicular
