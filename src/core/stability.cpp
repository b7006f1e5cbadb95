// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stability.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace funicular {

namespace {

using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

// Smaller than this part of the largest, a member's pull is rounding.
constexpr double negligible = 1e-9;
constexpr double units_of_rounding = 8;
// A curvature within this part of the bound on negative ones is none.
constexpr double neutral = 1e-6;
// The largest negative curvature is sought to this factor, which leaves inverse iteration well ahead of every
// mode that does not curve downwards.
constexpr double known_closely = 1.5;
constexpr int inverse_iterations = 30;
constexpr double first_departure = 1e-6;

/// T of each member, with what is rounding set to zero.
Eigen::VectorXd significant_tensions(const Points &x, const Equilibrium &equilibrium) {
    const AxialForces &axial = equilibrium.scene().axial();
    Eigen::VectorXd tensions;
    axial.tensions(x, tensions);
    const double smallest = negligible * tensions.cwiseAbs().maxCoeff();
    const double rounding =
        units_of_rounding * std::numeric_limits<double>::epsilon() * x.cwiseAbs().maxCoeff();
    for (Index e = 0; e < tensions.size(); ++e)
        if (std::abs(tensions[e]) <= std::max(smallest, rounding * axial.stiffness()[e]))
            tensions[e] = 0;
    return tensions;
}

struct NodalPull {
    Eigen::VectorXd pushed; ///< sum of |T| / l over the members that push
    std::vector<bool> is_pulled, is_pushed;
};

NodalPull nodal_pull(const Points &x, const Eigen::VectorXd &tensions, const Net &net) {
    NodalPull nodes{Eigen::VectorXd::Zero(net.node_count()), std::vector<bool>(net.node_count(), false),
                    std::vector<bool>(net.node_count(), false)};
    for (Index e = 0; e < net.member_count(); ++e) {
        const auto [i, j] = net.members()[e];
        const double length = (x.row(j) - x.row(i)).norm();
        for (const Index end : {i, j}) {
            if (tensions[e] > 0)
                nodes.is_pulled[end] = true;
            if (tensions[e] < 0) {
                nodes.is_pushed[end] = true;
                // Ends that coincide push one another nowhere.
                nodes.pushed[end] += length > 0 ? -tensions[e] / length : 0;
            }
        }
    }
    return nodes;
}

bool has_propped_node(const NodalPull &nodes, const Freedoms &freedoms) {
    for (Index node = 0; node < static_cast<Index>(nodes.is_pushed.size()); ++node)
        if (nodes.is_pushed[node] && !nodes.is_pulled[node] && freedoms.count(node) > 0)
            return true;
    return false;
}

bool is_positive_definite(Factor &factor, const Eigen::SparseMatrix<double> &tangent, double shift) {
    factor.setShift(shift);
    factor.factorize(tangent);
    return factor.info() == Eigen::Success && (factor.vectorD().array() > 0).all();
}

/// A motion without any symmetry, that depends on where nodes are and not on their numbers.
Eigen::VectorXd uneven_motion(const Points &x, const Freedoms &freedoms) {
    Points motion(x.rows(), 3);
    for (Index node = 0; node < x.rows(); ++node) {
        const double phase = 2.1 * x(node, 0) + 3.3 * x(node, 1) + 1.7 * x(node, 2);
        motion.row(node) << std::sin(phase + 0.4), std::cos(1.3 * phase + 0.9), std::sin(1.9 * phase + 1.2);
    }
    Eigen::VectorXd unknowns;
    freedoms.reduce(motion, unknowns);
    return unknowns;
}

} // namespace

std::optional<Instability> find_instability(const Points &x, Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const auto tensions = significant_tensions(x, equilibrium);
    if (tensions.size() == 0 || tensions.minCoeff() >= 0)
        return std::nullopt;
    const auto nodes = nodal_pull(x, tensions, scene.net());
    BlockMatrix blocks(equilibrium.member_coupling());
    equilibrium.member_tangent(x, {.floor = 0, .convex = false}, blocks);
    Eigen::SparseMatrix<double> tangent;
    blocks.reduce(scene.freedoms(), tangent);
    if (tangent.rows() == 0)
        return std::nullopt;
    // Gershgorin, of what pushing members take away; and what rounding may.
    const double rounding =
        units_of_rounding * std::numeric_limits<double>::epsilon() * tangent.diagonal().maxCoeff();
    double above = 2 * nodes.pushed.maxCoeff() + rounding;
    double below = std::max(neutral * above, rounding);
    Factor factor;
    factor.analyzePattern(tangent);
    if (is_positive_definite(factor, tangent, below))
        return std::nullopt;
    if (!has_propped_node(nodes, scene.freedoms()))
        return Instability{};

    while (above > known_closely * below) {
        const double middle = std::sqrt(above * below);
        (is_positive_definite(factor, tangent, middle) ? above : below) = middle;
    }
    if (!is_positive_definite(factor, tangent, known_closely * above))
        return Instability{};
    Eigen::VectorXd direction = uneven_motion(x, scene.freedoms());
    for (int k = 0; k < inverse_iterations; ++k)
        direction = factor.solve(direction).normalized();

    Points motion(x.rows(), 3);
    scene.freedoms().expand(direction, motion);
    direction /= motion.rowwise().norm().maxCoeff();
    Eigen::VectorXd loads;
    scene.freedoms().reduce(equilibrium.loads(), loads);
    if (loads.dot(direction) < -neutral * loads.norm() * direction.norm())
        direction = -direction;
    return Instability{direction};
}

void leave_along(const Eigen::VectorXd &direction, Points &x, Equilibrium &equilibrium) {
    Points motion(x.rows(), 3);
    equilibrium.scene().freedoms().expand(direction, motion);
    const Points from = x;
    const double farthest = equilibrium.scene().net().size() / equilibrium.scene().scale().length;
    double step = first_departure;
    do {
        step *= 2;
        x = from + step * motion;
        equilibrium.evaluate(x);
    } while (step < farthest && equilibrium.residual().dot(direction) > 0);
}

Index count_pushing(const Points &x, const Equilibrium &equilibrium) {
    return static_cast<Index>((significant_tensions(x, equilibrium).array() < 0).count());
}

Index count_loose_nodes(const Points &x, const Equilibrium &equilibrium) {
    const Scene &scene = equilibrium.scene();
    const auto tensions = significant_tensions(x, equilibrium);
    std::vector<bool> is_held(scene.net().node_count(), false);
    for (Index e = 0; e < scene.net().member_count(); ++e) {
        const auto [i, j] = scene.net().members()[e];
        const double length = (x.row(j) - x.row(i)).norm() * scene.scale().length;
        // One that has just its rest length is not slack: it holds as soon as its ends move apart.
        if (tensions[e] != 0 || length >= (1 - negligible) * scene.rest_lengths()[e])
            is_held[i] = is_held[j] = true;
    }
    Index loose = 0;
    for (Index node = 0; node < scene.net().node_count(); ++node)
        if (!is_held[node] && scene.freedoms().count(node) == 3)
            ++loose;
    return loose;
}

} // namespace funicular
