// SPDX-License-Identifier: LGPL-2.1-or-later
#include "kept_factor.hpp"

namespace funicular {

KeptFactor::KeptFactor(const Equilibrium &equilibrium) : blocks_(equilibrium.member_coupling()) {
    const Scene &scene = equilibrium.scene();
    for (Index node = 0; node < scene.net().node_count(); ++node)
        first_unknown_.push_back(scene.freedoms().offset(node));
    first_unknown_.push_back(scene.freedoms().size());
}

bool KeptFactor::prepare(const Points & /*x*/, const Equilibrium &equilibrium, double floor) {
    const Scene &scene = equilibrium.scene();
    blocks_.set_zero();
    const auto &members = scene.net().members();
    for (std::size_t e = 0; e < members.size(); ++e) {
        const auto [i, j] = members[e];
        const Matrix3 block = equilibrium.member_tangents()[e].block();
        blocks_.add(i, i, block);
        blocks_.add(j, j, block);
        blocks_.add(i, j, -block);
        blocks_.add(j, i, -block);
    }
    for (const auto &support : scene.elastic_supports())
        blocks_.add(support.node, support.node, support.stiffness);
    // Symmetric, so that column-major storage holds the matrix itself.
    blocks_.reduce(scene.freedoms(), tangent_);
    for (Index unknown = 0; unknown < tangent_.rows(); ++unknown)
        tangent_.coeffRef(unknown, unknown) += notional_ground * floor;
    return factor_.factorise(tangent_, first_unknown_);
}

} // namespace funicular
