// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice_levels.hpp"
#include "line_smoother.hpp"
#include "preconditioner.hpp"

#include <Eigen/Cholesky>

#include <memory>
#include <vector>

namespace funicular {

/// One multigrid V-cycle on the members' tangent: lines are smoothed, what is left is handed to the net of
/// every second line, whose tangent is that of its own members between the same places in space, and the
/// coarsest net is solved directly. Time and memory grow with the number of nodes.
///
/// Coarse tangents are not the Galerkin product of the fine one: between two coarse nodes that net bends, and
/// bilinear interpolation would stretch its members where they only turn.
class Multigrid final : public Preconditioner {
public:
    /// \param levels the coarser nets of the scene, one at least
    Multigrid(const Scene &scene, const CoarserLevels &levels);
    ~Multigrid() override;

    bool prepare(const Points &x, const Equilibrium &equilibrium, double floor) override;
    void apply(const Eigen::VectorXd &residual, Eigen::VectorXd &motion) override;

private:
    struct Level;
    bool prepare(Level &level, const std::vector<AxialForces::MemberTangent> &tangents, double floor);
    bool factorise_coarsest(const std::vector<AxialForces::MemberTangent> &tangents);
    void solve_coarsest();
    void cycle(std::size_t level);

    std::vector<std::unique_ptr<Level>> levels_;
    Eigen::LDLT<Eigen::MatrixXd> coarsest_;
};

} // namespace funicular
