// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/effect.hpp"
#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"

namespace funicular {

/// wA g A of each panel, A its present area, shared among its corners (paper section 4.1).
class CoveringLoads final : public Effect {
public:
    /// \throws InvalidInput for a weight that is negative or not finite.
    CoveringLoads(const Net &net, const CoveringWeight &description, const Scale &scale);

    [[nodiscard]] std::string_view name() const override { return "covering_weight"; }
    [[nodiscard]] std::size_t bytes() const override { return sizeof(*this); }
    void add_forces(const Points &x, Points &forces) const override;
    void couple(Coupling &coupling) const override;
    void add_tangent(const Points &x, BlockMatrix &tangent) const override;
    void add_tangent_product(const Points &x, const Points &motion, Points &product) const override;
    bool keep_gradients(const Points &x, std::vector<LoadGradient> &kept) const override;

private:
    /// Calls add(node, by, gradient) for each derivative of a node's upward load by the place of another.
    template <class Add>
    void differentiate(const Points &x, const Add &add) const;

    const Net &net_;
    CornerShare share_;
    double weight_; ///< per area
};

} // namespace funicular
