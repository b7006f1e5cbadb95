// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.hpp"
#include "effects/axial.hpp"
#include "scene.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace funicular {

/// How often an effect was evaluated, and how long that took in all.
struct Cost {
    long evaluations = 0;
    double seconds = 0;
};

/// Forces and tangent at a shape, of the effects that are present and no others; counts what each one costs.
/// In the scene's own units and in the sense of form finding.
class Equilibrium {
public:
    explicit Equilibrium(std::shared_ptr<const Scene> scene);

    [[nodiscard]] const Scene &scene() const { return *scene_; }

    /// Computes forces and loads at x.
    void evaluate(const Points &x);
    /// Sum of pull, loads and elastic supports on each node, at the shape of the last evaluation.
    [[nodiscard]] const Points &forces() const { return forces_; }
    /// The loads among them.
    [[nodiscard]] const Points &loads() const { return loads_; }
    /// r_i = P_i (sum of forces on node i), as components along the free directions.
    [[nodiscard]] const Eigen::VectorXd &residual() const { return residual_; }
    /// Mean of |load| over the nodes that can move; of the members' pull if they bear none, or of
    /// that at a strain of 1e-6 if it is more, so that a residual can be relative.
    [[nodiscard]] double mean_nodal_load() const { return mean_nodal_load_; }
    /// max_i |r_i| / mean nodal load; without loads, over what pull can be told from rounding, if that is
    /// more.
    [[nodiscard]] double relative_residual() const { return relative_residual_; }
    /// The same of the nodes whose residual is more than the rounding of positions makes of it: a stiff
    /// member turns a unit in the last place of its ends into a force. What rounding may excuse is bounded.
    [[nodiscard]] double significant_residual() const { return significant_residual_; }
    /// Whether the residual is rounding at every node where it exceeds the tolerance, be that excusable or
    /// not.
    [[nodiscard]] bool is_hidden_by_rounding(double tolerance) const { return beyond_rounding_ <= tolerance; }
    /// Adds what elastic supports push back with at x.
    void add_elastic_supports(const Points &x, Points &forces) const;
    /// Sum of k_e over the members at each node, with its supports that yield.
    [[nodiscard]] const Eigen::VectorXd &nodal_stiffness() const { return nodal_stiffness_; }

    /// The pairs of nodes that the effects present couple, and no others.
    [[nodiscard]] Coupling coupling() const;
    /// The pairs that members couple.
    [[nodiscard]] Coupling member_coupling() const;
    /// -∂(forces)/∂x at x. With a regularisation it is that of a net whose members are all under a notional
    /// pull.
    void tangent(const Points &x, AxialForces::Regularisation regularisation, BlockMatrix &tangent);
    /// The symmetric part that members and elastic supports give.
    void member_tangent(const Points &x, AxialForces::Regularisation regularisation, BlockMatrix &tangent);
    /// Keeps the members' part of the tangent at x for the products to come.
    void linearise(const Points &x, AxialForces::Regularisation regularisation);
    /// The same with other tangents in their place, which `fill` is given to set, one for each member.
    template <class Fill>
    void linearise_as(const Fill &fill) {
        timed(0, [&] {
            member_tangents_.resize(scene_->net().member_count());
            fill(member_tangents_);
        });
    }
    /// Keeps the loads' part, where that is worth its memory.
    void linearise_loads(const Points &x);
    /// The tangent at x times a motion of the nodes, in the sense of `tangent`.
    /// \pre linearise and linearise_loads were called at x
    void tangent_product(const Points &x, const Points &motion, Points &product);
    /// The same of members and elastic supports alone, for which linearise is enough.
    void member_product(const Points &motion, Points &product) const;
    /// The members' part that was kept.
    [[nodiscard]] const std::vector<AxialForces::MemberTangent> &member_tangents() const {
        return member_tangents_;
    }

    /// By name of effect: only effects in the scene appear.
    [[nodiscard]] std::map<std::string, Cost> costs() const;
    /// Counts what another equilibrium of the same effects has cost as this one's.
    void add_costs(const std::map<std::string, Cost> &other);

private:
    template <class Work>
    void timed(std::size_t effect, const Work &work) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        ++costs_[effect].evaluations;
        costs_[effect].seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    void measure_residual(const Points &x);

    std::shared_ptr<const Scene> scene_;
    std::vector<Cost> costs_;
    Eigen::VectorXd nodal_stiffness_;
    Points forces_, loads_;
    Eigen::VectorXd residual_;
    std::vector<AxialForces::MemberTangent> member_tangents_;
    std::vector<LoadGradient> load_gradients_;
    std::vector<bool> are_gradients_kept_;
    double mean_nodal_load_ = 0;
    double relative_residual_ = 0;
    double significant_residual_ = 0;
    double beyond_rounding_ = 0;
};

} // namespace funicular
