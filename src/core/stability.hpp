// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"

#include <optional>

namespace funicular {

/// An equilibrium that would not last.
///
/// Two-way members can balance their loads as struts: a net that should stand may hang from props. With the
/// loads held as they are, an equilibrium is where the energy Σ ½ k (l - r)² + supports - p·x is stationary,
/// and stable where its second derivative, the tangent of members and supports, is positive definite. That
/// tangent is symmetric, so that a factorisation counts its negative eigenvalues (Sylvester). The loads' own
/// change with the shape is left out on purpose: it has no potential, the structure that is built does not
/// know it, and near the limit of existence it makes the symmetric part of the whole tangent indefinite where
/// nothing buckles.
struct Instability {
    /// Of negative curvature, along the free directions, for the largest motion of a node of one; the loads
    /// do no negative work along it. Given where a node that can move is propped: whatever carries there
    /// pushes. Then the net is in the wrong sign, or buckles there. Where something pulls at each node, as
    /// the ribs of a dome do at hoops that push, it is the form that was asked for, though slender parts of
    /// it would buckle.
    std::optional<Eigen::VectorXd> way_out;
};

/// Whether the equilibrium at x, where it was evaluated, is unstable. Costs a pass over the members where
/// none pushes, as their tangent Q ⊗ I + Σ (k r / l) d dᵀ, Q the matrix of force densities, is positive
/// semidefinite then; otherwise a factorisation, and about ten if there is a way out.
[[nodiscard]] std::optional<Instability> find_instability(const Points &x, Equilibrium &equilibrium);

/// Moves x along the direction for as long as the forces do work along it, and evaluates there.
void leave_along(const Eigen::VectorXd &direction, Points &x, Equilibrium &equilibrium);

/// Members that push in form finding: they are in tension in the built structure.
[[nodiscard]] Index count_pushing(const Points &x, const Equilibrium &equilibrium);
/// Nodes that can move and have members, all of them slack: nothing holds them where they are.
[[nodiscard]] Index count_loose_nodes(const Points &x, const Equilibrium &equilibrium);

} // namespace funicular
