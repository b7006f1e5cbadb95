// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/effect.hpp"
#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"

namespace funicular {

/// A pressure on each panel's area in plan: that of the triangles between its edges and the mean of its
/// corners, as its covering's area is (see PanelGeometry). A panel seen from below bears snow all the same,
/// and so does the part of one that is folded on itself in plan, as where a warped wall tips over: no load
/// lifts, and none jumps. Each triangle gives a third of its load to each of its points, the mean's third
/// going to all corners alike: force and moments are those of the pressure.
class SnowLoads final : public Effect {
public:
    /// \throws InvalidInput for a pressure that is negative or not finite.
    SnowLoads(const Net &net, const Snow &description, const Scale &scale);

    [[nodiscard]] std::string_view name() const override { return "snow"; }
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
    double pressure_;
};

} // namespace funicular
