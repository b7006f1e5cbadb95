// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice_levels.hpp"
#include "local_settling.hpp"
#include "method.hpp"
#include "newton_direction.hpp"

#include <memory>

namespace funicular {

/// Whether members are so stiff for the loads that which of them go slack is settled by hairs. Inexact steps
/// wander there for long, where exact ones arrive.
[[nodiscard]] bool calls_for_exact_steps(const Equilibrium &equilibrium);

/// Newton's method with a line search on the work of the residual.
///
/// The load depends on the shape and has no potential, so that no energy can judge a step. What exists is the
/// work that the out-of-balance force does along the step, G(t) = r(x + t d)·d: a step ends where it has
/// nearly vanished (Matthies and Strang, "The solution of nonlinear finite element equations", 1979).
///
/// Far from equilibrium, stiff members allow only short steps, as every rotation stretches them. When that
/// happens the scene is solved with its stiffest members softened first, and then with stiffer ones from
/// there: the error left by a stage falls with the strain, so that the factor between stages may be squared
/// each time.
class Newton final : public Iteration {
public:
    /// \param levels coarser nets of the scene's; where there are some, multigrid solves the linear equations
    ///               of a step, and a factorisation where there are none
    explicit Newton(const Equilibrium &equilibrium, CoarserLevels levels = {});

    /// The largest node's motion in the Newton step from x; infinite if that step could not be had.
    [[nodiscard]] double position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) override;
    Move move(Points &x, Equilibrium &equilibrium) override;
    /// Keeps the factorisation or the multigrid levels.
    [[nodiscard]] bool restart() override;

private:
    /// Moves along the direction. Returns the part of the wished step that was taken, zero if none could be.
    double search(Points &x, Equilibrium &stage);
    double work_at(double step, Points &x, Equilibrium &stage) const;
    void soften(const Points &x, const Equilibrium &equilibrium);
    void stiffen(const Points &x, Equilibrium &equilibrium);
    void enter_stage(const Points &x, const Equilibrium &equilibrium);

    CoarserLevels levels_;
    static constexpr double first_reach = 0.1;
    NewtonDirection direction_;
    LocalSettling settling_;
    Points start_, start_of_stage_;
    /// Largest motion of a node in one step, in the scene's own units; grows while steps fall short.
    double reach_ = first_reach;

    std::unique_ptr<Equilibrium> softened_; ///< of the present stage; none at full stiffness
    double stiffness_limit_ = 0;            ///< of the present stage [N]
    double stage_ratio_ = 1;
    int short_steps_ = 0;
    int direct_steps_ = 0;
    bool has_softened_ = false;
};

} // namespace funicular
