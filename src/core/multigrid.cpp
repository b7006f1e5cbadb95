// SPDX-License-Identifier: LGPL-2.1-or-later
#include "multigrid.hpp"

#include <utility>

namespace funicular {

namespace {

/// A piece of a fine residual on its way to a coarse node and back.
struct Transfer {
    Index node;
    Real part;
};

} // namespace

struct Multigrid::Level {
    Level(std::shared_ptr<const Net> of, const Lattice &lattice, std::vector<Support> held_by)
        : net(std::move(of)), supports(std::move(held_by)), freedoms(*net, supports),
          along_u(lattice, net->members(), LineSmoother::Direction::u),
          along_v(lattice, net->members(), LineSmoother::Direction::v), short_tangents(net->member_count()),
          forces(net->node_count()), motion(net->node_count()), left(net->node_count()) {}

    std::shared_ptr<const Net> net;
    std::vector<Support> supports;
    Freedoms freedoms;
    std::vector<ElasticSupport> elastic_supports;
    /// Makes the tangents of this coarser net's members from those of the finer one: of two in a row as of
    /// springs in series, side by side they add up.
    void gather(const std::vector<AxialForces::MemberTangent> &finer);

    // Of a coarser net than the scene's own.
    Points x;
    std::vector<Index> fine_nodes;
    std::vector<Coarsening::Strand> strands;

    LineSmoother along_u, along_v;
    std::vector<ShortMemberTangent> short_tangents;
    std::vector<AxialForces::MemberTangent> tangents; ///< of a coarser net than the scene's own
    std::vector<SymmetricBlock<double>> diagonals;
    Vectors3r forces, motion, left;

    // To the next coarser level, if there is one.
    std::vector<Index> transfers_of{0};
    std::vector<Transfer> transfers;
};

Multigrid::~Multigrid() = default;

Multigrid::Multigrid(const Scene &scene, const CoarserLevels &levels) {
    levels_.push_back(
        std::make_unique<Level>(scene.shared_net(), *levels[0].coarsening.fine(), scene.supports()));
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const LatticeLevel &coarse = levels[k];
        Level &fine = *levels_.back();
        for (Index node = 0; node < fine.net->node_count(); ++node) {
            for (const auto &[parent, part] : coarse.coarsening.parents(node))
                fine.transfers.push_back({parent, static_cast<Real>(part)});
            fine.transfers_of.push_back(static_cast<Index>(fine.transfers.size()));
        }
        levels_.push_back(std::make_unique<Level>(coarse.net, *coarse.net->lattice(), coarse.supports));
        Level &level = *levels_.back();
        level.fine_nodes = coarse.coarsening.fine_nodes();
        level.strands = coarse.coarsening.strands();
        level.x.resize(coarse.net->node_count(), 3);
    }
}

bool Multigrid::prepare(const Points &x, const Equilibrium &equilibrium, double floor) {
    // The scene may be another one than that it was made for, on the same net and supports but in other
    // units.
    const Scene &scene = equilibrium.scene();
    levels_.front()->elastic_supports = scene.elastic_supports();
    for (std::size_t k = 1; k < levels_.size(); ++k)
        levels_[k]->elastic_supports =
            elastic_supports_of(*levels_[k]->net, levels_[k]->supports, scene.scale());
    bool is_definite = prepare(*levels_.front(), equilibrium.member_tangents(), floor);
    const Points *finer = &x;
    const auto *tangents = &equilibrium.member_tangents();
    for (std::size_t k = 1; k < levels_.size(); ++k) {
        Level &level = *levels_[k];
        for (Index node = 0; node < level.x.rows(); ++node)
            level.x.row(node) = finer->row(level.fine_nodes[node]);
        level.gather(*tangents);
        tangents = &level.tangents;
        is_definite = prepare(level, *tangents, floor) && is_definite;
        finer = &level.x;
    }
    return factorise_coarsest(*tangents) && is_definite;
}

void Multigrid::Level::gather(const std::vector<AxialForces::MemberTangent> &finer) {
    const auto in_series = [](double a, double b) { return a * b / (a + b); };
    tangents.assign(net->member_count(), {.direction = Vector3::Zero(), .along = 0, .around = 0});
    for (const auto &[member, first, second, part] : strands) {
        double around = finer[first].around;
        double whole = around + finer[first].along;
        if (second >= 0) {
            around = in_series(around, finer[second].around);
            whole = in_series(whole, finer[second].around + finer[second].along);
        }
        tangents[member].around += part * around;
        tangents[member].along += part * (whole - around);
    }
    for (Index e = 0; e < net->member_count(); ++e) {
        const auto [i, j] = net->members()[e];
        const Vector3 along = (x.row(j) - x.row(i)).transpose();
        if (const double length = along.norm(); length > 0)
            tangents[e].direction = along / length;
    }
}

bool Multigrid::prepare(Level &level, const std::vector<AxialForces::MemberTangent> &tangents, double floor) {
    const double ground = notional_ground * floor;
    level.diagonals.assign(level.net->node_count(),
                           {.xx = ground, .xy = 0, .xz = 0, .yy = ground, .yz = 0, .zz = ground});
    for (const auto &support : level.elastic_supports) {
        auto &diagonal = level.diagonals[support.node];
        diagonal.xx += support.stiffness(0, 0);
        diagonal.xy += support.stiffness(0, 1);
        diagonal.xz += support.stiffness(0, 2);
        diagonal.yy += support.stiffness(1, 1);
        diagonal.yz += support.stiffness(1, 2);
        diagonal.zz += support.stiffness(2, 2);
    }
    for (std::size_t e = 0; e < tangents.size(); ++e) {
        const auto &tangent = tangents[e];
        for (const Index end : level.net->members()[e])
            level.diagonals[end].add(tangent.around, tangent.along, tangent.direction);
        level.short_tangents[e] = {.direction = tangent.direction.cast<Real>(),
                                   .along = static_cast<Real>(tangent.along),
                                   .around = static_cast<Real>(tangent.around)};
    }
    const bool u_is_definite = level.along_u.prepare(tangents, level.diagonals, level.freedoms);
    return level.along_v.prepare(tangents, level.diagonals, level.freedoms) && u_is_definite;
}

bool Multigrid::factorise_coarsest(const std::vector<AxialForces::MemberTangent> &tangents) {
    const Level &level = *levels_.back();
    const Freedoms &freedoms = level.freedoms;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(freedoms.size(), freedoms.size());
    const auto add = [&](Index row, Index column, const Matrix3 &block) {
        stiffness.block(freedoms.offset(row), freedoms.offset(column), freedoms.count(row),
                        freedoms.count(column)) +=
            freedoms.basis(row).leftCols(freedoms.count(row)).transpose() * block *
            freedoms.basis(column).leftCols(freedoms.count(column));
    };
    for (Index node = 0; node < level.net->node_count(); ++node)
        add(node, node, level.diagonals[node].matrix());
    for (std::size_t e = 0; e < tangents.size(); ++e) {
        const auto [i, j] = level.net->members()[e];
        add(i, j, -tangents[e].block());
        add(j, i, -tangents[e].block());
    }
    coarsest_.compute(stiffness);
    return freedoms.size() == 0 || (coarsest_.info() == Eigen::Success && coarsest_.isPositive());
}

void Multigrid::apply(const Eigen::VectorXd &residual, Eigen::VectorXd &motion) {
    Level &level = *levels_.front();
    const Freedoms &freedoms = level.freedoms;
    for (Index node = 0; node < level.net->node_count(); ++node) {
        const Index count = freedoms.count(node);
        level.forces[node] =
            (freedoms.basis(node).leftCols(count) * residual.segment(freedoms.offset(node), count))
                .cast<Real>();
    }
    cycle(0);
    motion.resize(residual.size());
    for (Index node = 0; node < level.net->node_count(); ++node) {
        const Index count = freedoms.count(node);
        motion.segment(freedoms.offset(node), count) =
            freedoms.basis(node).leftCols(count).transpose() * level.motion[node].cast<double>();
    }
}

void Multigrid::solve_coarsest() {
    Level &level = *levels_.back();
    const Freedoms &freedoms = level.freedoms;
    Eigen::VectorXd right(freedoms.size());
    for (Index node = 0; node < level.net->node_count(); ++node)
        right.segment(freedoms.offset(node), freedoms.count(node)) =
            freedoms.basis(node).leftCols(freedoms.count(node)).transpose() *
            level.forces[node].cast<double>();
    const Eigen::VectorXd solution = coarsest_.solve(right);
    for (Index node = 0; node < level.net->node_count(); ++node)
        level.motion[node] = (freedoms.basis(node).leftCols(freedoms.count(node)) *
                              solution.segment(freedoms.offset(node), freedoms.count(node)))
                                 .cast<Real>();
}

void Multigrid::cycle(std::size_t depth) {
    if (depth + 1 == levels_.size())
        return solve_coarsest();
    Level &level = *levels_[depth];
    Level &coarse = *levels_[depth + 1];
    std::fill(level.motion.begin(), level.motion.end(), Vector3r::Zero());
    level.along_u.sweep(level.short_tangents, level.forces, LineSmoother::Order::forward, level.motion);
    level.along_v.sweep(level.short_tangents, level.forces, LineSmoother::Order::forward, level.motion);

    level.left = level.forces;
    for (std::size_t e = 0; e < level.short_tangents.size(); ++e) {
        const auto [i, j] = level.net->members()[e];
        const Vector3r force = level.short_tangents[e] * (level.motion[i] - level.motion[j]);
        level.left[i] -= force;
        level.left[j] += force;
    }
    for (const auto &support : level.elastic_supports)
        level.left[support.node] -= support.stiffness.cast<Real>() * level.motion[support.node];
    std::fill(coarse.forces.begin(), coarse.forces.end(), Vector3r::Zero());
    for (std::size_t node = 0; node < level.left.size(); ++node)
        if (const auto left = level.freedoms.project(static_cast<Index>(node), level.left[node]);
            !left.isZero(0))
            for (Index k = level.transfers_of[node]; k < level.transfers_of[node + 1]; ++k)
                coarse.forces[level.transfers[k].node] += level.transfers[k].part * left;

    cycle(depth + 1);
    for (std::size_t node = 0; node < level.motion.size(); ++node) {
        Vector3r carried = Vector3r::Zero();
        for (Index k = level.transfers_of[node]; k < level.transfers_of[node + 1]; ++k)
            carried += level.transfers[k].part * coarse.motion[level.transfers[k].node];
        level.motion[node] += level.freedoms.project(static_cast<Index>(node), carried);
    }
    level.along_v.sweep(level.short_tangents, level.forces, LineSmoother::Order::backward, level.motion);
    level.along_u.sweep(level.short_tangents, level.forces, LineSmoother::Order::backward, level.motion);
}

} // namespace funicular
