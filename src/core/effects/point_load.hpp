// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/effect.hpp"
#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"

#include <vector>

namespace funicular {

/// A force that stays as it is whatever the shape.
class PointLoads final : public Effect {
public:
    /// \throws InvalidInput for a node out of range or a force that is not finite.
    PointLoads(const Net &net, const PointLoad &description, const Scale &scale);

    [[nodiscard]] std::string_view name() const override { return "point_load"; }
    [[nodiscard]] std::size_t bytes() const override { return sizeof(*this) + sizeof(Index) * nodes_.size(); }
    void add_forces(const Points &x, Points &forces) const override;
    void couple(Coupling & /*coupling*/) const override {}
    void add_tangent(const Points & /*x*/, BlockMatrix & /*tangent*/) const override {}
    void add_tangent_product(const Points & /*x*/, const Points & /*motion*/,
                             Points & /*product*/) const override {}

private:
    std::vector<Index> nodes_;
    /// Of form finding: the built structure's, turned round.
    Vector3 force_;
};

} // namespace funicular
