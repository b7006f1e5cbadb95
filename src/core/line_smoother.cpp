// SPDX-License-Identifier: LGPL-2.1-or-later
#include "line_smoother.hpp"

#include <Eigen/Cholesky>

#include <numeric>

namespace funicular {

namespace {

/// Inverse on the directions that a node is free in, nothing on the others.
/// \returns whether the block is positive definite there
bool invert(const SymmetricBlock<double> &block, const Freedoms &freedoms, Index node,
            SymmetricBlock<double> &inverse) {
    const Index count = freedoms.count(node);
    if (count == 3) {
        const double xx = block.yy * block.zz - block.yz * block.yz;
        const double xy = block.xz * block.yz - block.xy * block.zz;
        const double xz = block.xy * block.yz - block.xz * block.yy;
        const double determinant = block.xx * xx + block.xy * xy + block.xz * xz;
        const double scale = 1 / determinant;
        const double minor = block.xx * block.yy - block.xy * block.xy;
        inverse = {.xx = scale * xx,
                   .xy = scale * xy,
                   .xz = scale * xz,
                   .yy = scale * (block.xx * block.zz - block.xz * block.xz),
                   .yz = scale * (block.xy * block.xz - block.xx * block.yz),
                   .zz = scale * minor};
        return block.xx > 0 && minor > 0 && determinant > 0;
    }
    inverse = {};
    const auto free = freedoms.basis(node).leftCols(count);
    const Eigen::MatrixXd reduced = free.transpose() * block.matrix() * free;
    const Eigen::LDLT<Eigen::MatrixXd> factor(reduced);
    const Matrix3 result = free * factor.solve(Eigen::MatrixXd::Identity(count, count)) * free.transpose();
    inverse = {.xx = result(0, 0),
               .xy = result(0, 1),
               .xz = result(0, 2),
               .yy = result(1, 1),
               .yz = result(1, 2),
               .zz = result(2, 2)};
    return count == 0 || (factor.info() == Eigen::Success && factor.isPositive());
}

/// Takes away what a member hands on of the node before: M L M, M the member's tangent and L the inverse of
/// that node's pivot.
void eliminate(const AxialForces::MemberTangent &member, const SymmetricBlock<double> &inverse,
               SymmetricBlock<double> &pivot) {
    const Vector3 &d = member.direction;
    const Vector3 u = inverse * d;
    const double both = member.around * member.along;
    const double along = member.along * member.along * d.dot(u);
    const double around = member.around * member.around;
    pivot.xx -= around * inverse.xx + 2 * both * d[0] * u[0] + along * d[0] * d[0];
    pivot.xy -= around * inverse.xy + both * (d[0] * u[1] + d[1] * u[0]) + along * d[0] * d[1];
    pivot.xz -= around * inverse.xz + both * (d[0] * u[2] + d[2] * u[0]) + along * d[0] * d[2];
    pivot.yy -= around * inverse.yy + 2 * both * d[1] * u[1] + along * d[1] * d[1];
    pivot.yz -= around * inverse.yz + both * (d[1] * u[2] + d[2] * u[1]) + along * d[1] * d[2];
    pivot.zz -= around * inverse.zz + 2 * both * d[2] * u[2] + along * d[2] * d[2];
}

} // namespace

LineSmoother::LineSmoother(const Lattice &lattice, const std::vector<Member> &members, Direction direction) {
    std::vector<std::vector<Index>> lines;
    std::vector<bool> is_pole(lattice.uv().rows(), false);
    for (const Side side : lattice.recipe().poles) {
        const bool is_first = side == Side::u_min || side == Side::v_min;
        const Index pole = is_first ? lattice.node_at(0, 0)
                                    : lattice.node_at(lattice.recipe().cells_u, lattice.recipe().cells_v);
        is_pole[pole] = true;
        lines.push_back({pole});
    }
    const bool along_u = direction == Direction::u;
    for (Index line = 0; line < (along_u ? lattice.lines_v() : lattice.lines_u()); ++line) {
        lines.emplace_back();
        for (Index k = 0; k < (along_u ? lattice.lines_u() : lattice.lines_v()); ++k) {
            const Index node = along_u ? lattice.node_at(k, line) : lattice.node_at(line, k);
            if (!is_pole[node])
                lines.back().push_back(node);
        }
    }

    std::vector<Index> first(is_pole.size() + 1, 0);
    for (const Member &member : members)
        for (const Index end : member)
            ++first[end + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Arm> around(2 * members.size());
    auto next = first;
    for (Index e = 0; e < static_cast<Index>(members.size()); ++e) {
        const auto [i, j] = members[e];
        around[next[i]++] = {.node = j, .member = e};
        around[next[j]++] = {.node = i, .member = e};
    }

    for (const auto &line : lines) {
        if (line.empty())
            continue;
        for (std::size_t k = 0; k < line.size(); ++k) {
            const Index before = k > 0 ? line[k - 1] : -1;
            const Index after = k + 1 < line.size() ? line[k + 1] : -1;
            nodes_.push_back(line[k]);
            members_.push_back(-1);
            for (Index arm = first[line[k]]; arm < first[line[k] + 1]; ++arm) {
                if (around[arm].node == before)
                    members_.back() = around[arm].member;
                else if (around[arm].node != after)
                    arms_.push_back(around[arm]);
            }
            arms_of_.push_back(static_cast<Index>(arms_.size()));
        }
        lines_.push_back(static_cast<Index>(nodes_.size()));
    }
    inverse_pivots_.resize(nodes_.size());
    carries_.resize(nodes_.size());
    partial_.resize(nodes_.size());
}

bool LineSmoother::prepare(const std::vector<AxialForces::MemberTangent> &tangents,
                           const std::vector<SymmetricBlock<double>> &diagonals, const Freedoms &freedoms) {
    SymmetricBlock<double> inverse{};
    bool is_definite = true;
    for (std::size_t at = 0; at < nodes_.size(); ++at) {
        SymmetricBlock<double> pivot = diagonals[nodes_[at]];
        if (members_[at] >= 0) {
            const auto &member = tangents[members_[at]];
            eliminate(member, inverse, pivot);
            const Vector3 u = member.along * (inverse * member.direction);
            carries_[at - 1] =
                (member.around * inverse.matrix() + u * member.direction.transpose()).cast<Real>();
        }
        is_definite = invert(pivot, freedoms, nodes_[at], inverse) && is_definite;
        inverse_pivots_[at] = {.xx = static_cast<Real>(inverse.xx),
                               .xy = static_cast<Real>(inverse.xy),
                               .xz = static_cast<Real>(inverse.xz),
                               .yy = static_cast<Real>(inverse.yy),
                               .yz = static_cast<Real>(inverse.yz),
                               .zz = static_cast<Real>(inverse.zz)};
    }
    return is_definite;
}

void LineSmoother::sweep(const std::vector<ShortMemberTangent> &tangents, const Vectors3r &forces,
                         Order order, Vectors3r &motion) {
    const std::size_t count = lines_.size() - 1;
    for (std::size_t k = 0; k < count; ++k)
        solve_line(order == Order::forward ? k : count - 1 - k, tangents, forces, motion);
}

void LineSmoother::solve_line(std::size_t line, const std::vector<ShortMemberTangent> &tangents,
                              const Vectors3r &forces, Vectors3r &motion) {
    const Index begin = lines_[line];
    const Index end = lines_[line + 1];
    Vector3r before = Vector3r::Zero();
    for (Index at = begin; at < end; ++at) {
        Vector3r force = forces[nodes_[at]];
        for (Index arm = arms_of_[at]; arm < arms_of_[at + 1]; ++arm)
            force += tangents[arms_[arm].member] * motion[arms_[arm].node];
        if (members_[at] >= 0)
            force.noalias() += carries_[at - 1].transpose() * before;
        partial_[at] = before = force;
    }
    Vector3r after = Vector3r::Zero();
    for (Index at = end - 1; at >= begin; --at) {
        Vector3r moved = inverse_pivots_[at] * partial_[at];
        if (at + 1 < end && members_[at + 1] >= 0)
            moved.noalias() += carries_[at] * after;
        motion[nodes_[at]] = after = moved;
    }
}

} // namespace funicular
