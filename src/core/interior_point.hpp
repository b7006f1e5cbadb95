// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "kept_factor.hpp"
#include "method.hpp"
#include "newton.hpp"
#include "tangent_equations.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace funicular {

/// Form finding of compression-only nets whose members are far stiffer than their loads.
///
/// There a member hardly lengthens: what is looked for is which members are taut and what they carry, and
/// Newton's method on positions loses its way, as every rotation stretches members by more than they will
/// bear in the end. So each member's force density q = T / l is an unknown of its own, besides the positions
/// and what the member is short of being taut, its slack s (an area). At equilibrium
///
///     sum_e q_e (x_j - x_i) + p(x) = 0                   at every node, along what its support leaves free
///     l² / 2 + s = r² / (2 (1 - q/k)²)                   T = k (l - r) for a taut member
///     q ≥ 0, s ≥ 0, q s = 0                              slack or taut
///
/// Under loads that did not change with the shape this would be the optimum of a convex problem. It is
/// reached along the path q s = μ as μ vanishes, on which no member has yet to be called slack or taut; a
/// step costs one factorisation, and its length does not fall with the stiffness (Mehrotra, "On the
/// implementation of a primal-dual interior point method", 1992). The loads are those of each step's shape.
class InteriorPoint final : public Iteration {
public:
    /// Whether the scene is one of stiff, compression-only members that bear loads.
    [[nodiscard]] static bool is_for(const Equilibrium &equilibrium);

    /// \param levels coarser nets of the scene's, for multigrid; a factorisation where there are none
    InteriorPoint(const Equilibrium &equilibrium, const CoarserLevels &levels);

    /// On the path, the largest node's motion in the step to its end; infinite while that leads too far.
    [[nodiscard]] double position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) override;
    /// A step along the path. Newton's method makes the steps from a shape that is near, and where there is
    /// no path.
    Move move(Points &x, Equilibrium &equilibrium) override;
    /// Keeps the structure of factors.
    [[nodiscard]] bool restart() override;

private:
    /// If so much of a step to the end of the path can be taken, it tells how far that is.
    static constexpr double length_near_end = 0.9;
    /// Far above what members will carry in the end: from there the path is short. The shape of another scene
    /// is nearer to it than a source.
    static constexpr double first_density_from_afar = 300, first_density_from_near = 30;
    enum class Phase { begun, newton, path, newton_at_last };
    struct Step {
        Points motion;
        Eigen::VectorXd densities, slacks;
        /// How much of it can be taken before a slack or a force density vanishes.
        double slack_length = 0, density_length = 0;
    };

    void use_newton(Phase phase, const Equilibrium &equilibrium);
    void begin_path(const Points &x, const Equilibrium &equilibrium);
    void linearise(const Points &x, Equilibrium &equilibrium);
    bool prepare(const Points &x, const Equilibrium &equilibrium);
    /// Solves for the step after which q s would be `products_`.
    bool compute_step(const Points &x, Equilibrium &equilibrium);
    bool solve(const Points &x, Equilibrium &equilibrium);
    [[nodiscard]] bool leads_to_end() const {
        return std::min(step_.slack_length, step_.density_length) >= length_near_end;
    }
    [[nodiscard]] double largest_motion() const { return step_.motion.rowwise().norm().maxCoeff(); }
    bool jump_to_end(Points &x, Equilibrium &equilibrium);
    /// The mean of q s after these parts of the present step.
    [[nodiscard]] double parameter_after(double density_length, double slack_length) const;
    bool follow_path(Points &x, Equilibrium &equilibrium);

    std::unique_ptr<Preconditioner> preconditioner_;
    bool is_factor_;
    TangentEquations equations_;
    std::optional<Newton> newton_;
    Points start_;
    Phase phase_ = Phase::begun;
    bool has_step_ = false;
    /// When all of a step to the end of the path was taken.
    std::optional<double> last_motion_;
    Goal goal_;
    int steps_ = 0;
    /// In typical ones, when the path is begun next.
    double first_density_ = first_density_from_afar;
    /// How often it was begun.
    int beginnings_ = 0;
    int short_steps_ = 0;

    Eigen::VectorXd densities_, slacks_; ///< q, s of each member
    double typical_density_ = 1;
    double typical_product_ = 1; ///< of q s

    // At the present shape.
    Points unbalanced_;           ///< sum of forces on each node, members pulling with q
    std::vector<Vector3> spans_;  ///< x_j - x_i of each member
    Eigen::VectorXd gaps_;        ///< by how much each member misses its law
    Eigen::VectorXd compliances_; ///< of each member's law, slack included
    Eigen::VectorXd products_;
    Step step_;
    Points forces_;
    Eigen::VectorXd right_, unknowns_;
};

} // namespace funicular
