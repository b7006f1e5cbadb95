// SPDX-License-Identifier: LGPL-2.1-or-later
#include "local_settling.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <numeric>

namespace funicular {

namespace {

// Of the largest residual.
constexpr double restless_part = 0.03;
// More than one node in so many are not a few.
constexpr Index one_in_nodes = 10;
// Sweeps go on for as long as they cost less than a step of the whole net.
constexpr Index nodes_per_update = 4;
constexpr Index least_sweeps = 10;
constexpr Index most_sweeps = 50;
constexpr double longest_step = 0.2; // of the shortest member of a node

} // namespace

LocalSettling::LocalSettling(const Net &net)
    : first_(net.node_count() + 1, 0), members_(2 * net.member_count()) {
    for (const Member &member : net.members())
        for (const Index end : member)
            ++first_[end + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    auto next = first_;
    for (Index e = 0; e < net.member_count(); ++e)
        for (const Index end : net.members()[e])
            members_[next[end]++] = e;
}

void LocalSettling::settle(Points &x, Equilibrium &equilibrium, double floor) {
    const Freedoms &freedoms = equilibrium.scene().freedoms();
    const double limit = restless_part * equilibrium.relative_residual() * equilibrium.mean_nodal_load();
    restless_.clear();
    for (Index node = 0; node < x.rows(); ++node)
        if (equilibrium.residual().segment(freedoms.offset(node), freedoms.count(node)).norm() > limit)
            restless_.push_back(node);
    if (static_cast<Index>(restless_.size()) > x.rows() / one_in_nodes)
        return;
    kept_ = x;
    const double before = equilibrium.relative_residual();
    if (restless_.empty())
        return;
    const Index wished = x.rows() / (nodes_per_update * static_cast<Index>(restless_.size()));
    const Index sweeps = std::clamp(wished, least_sweeps, most_sweeps);
    for (Index k = 0; k < sweeps; ++k)
        sweep(x, equilibrium, floor);
    equilibrium.evaluate(x);
    if (!(equilibrium.relative_residual() < before)) {
        x = kept_;
        equilibrium.evaluate(x);
    }
}

void LocalSettling::sweep(Points &x, const Equilibrium &equilibrium, double floor) {
    const Scene &scene = equilibrium.scene();
    const Freedoms &freedoms = scene.freedoms();
    for (const Index node : restless_) {
        // Loads change little where members still swing.
        Vector3 force = equilibrium.loads().row(node).transpose();
        Matrix3 stiffness = Matrix3::Zero();
        double shortest = scene.net().size();
        for (Index k = first_[node]; k < first_[node + 1]; ++k) {
            const Index e = members_[k];
            const auto [i, j] = scene.net().members()[e];
            const Vector3 pull = scene.axial().pull(e, x);
            force += node == i ? pull : Vector3(-pull);
            stiffness += scene.axial().tangent(e, x, {.floor = floor, .convex = true}).block();
            shortest = std::min(shortest, (x.row(j) - x.row(i)).norm());
        }
        const Index count = freedoms.count(node);
        const auto free = freedoms.basis(node).leftCols(count);
        const Eigen::MatrixXd reduced = free.transpose() * stiffness * free;
        Vector3 motion = free * reduced.ldlt().solve(free.transpose() * force);
        const double length = motion.norm();
        if (length > longest_step * shortest)
            motion *= longest_step * shortest / length;
        x.row(node) += motion.transpose();
    }
}

} // namespace funicular
