// SPDX-License-Identifier: LGPL-2.1-or-later
#include "line_smoother.hpp"

#include <Eigen/LU>

#include <numeric>

namespace funicular {

namespace {

/// Inverse on the directions that a node is free in, nothing on the others.
/// \returns whether the block is positive definite there
bool invert(const Matrix3 &block, const Freedoms &freedoms, Index node, Matrix3 &inverse) {
    const auto is_positive = [](double determinant, double trace) { return determinant > 0 && trace > 0; };
    const Matrix3 &basis = freedoms.basis(node);
    switch (freedoms.count(node)) {
    case 0:
        inverse.setZero();
        return true;
    case 1: {
        const double stiffness = basis.col(0).dot(block * basis.col(0));
        inverse = basis.col(0) * basis.col(0).transpose() / stiffness;
        return stiffness > 0;
    }
    case 2: {
        const Eigen::Matrix<double, 3, 2> free = basis.leftCols<2>();
        const Eigen::Matrix2d reduced = free.transpose() * block * free;
        inverse = free * reduced.inverse() * free.transpose();
        return is_positive(reduced.determinant(), reduced.trace());
    }
    default:
        inverse = block.inverse();
        return is_positive(block.determinant(), block.trace()) && inverse.trace() > 0;
    }
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
    partial_.resize(nodes_.size());
}

bool LineSmoother::prepare(const std::vector<AxialForces::MemberTangent> &tangents,
                           const std::vector<Matrix3> &diagonals, const Freedoms &freedoms) {
    Matrix3 inverse = Matrix3::Zero();
    bool is_definite = true;
    for (std::size_t at = 0; at < nodes_.size(); ++at) {
        Matrix3 pivot = diagonals[nodes_[at]];
        if (members_[at] >= 0) {
            const Matrix3 coupling = tangents[members_[at]].block();
            pivot.noalias() -= coupling * inverse * coupling;
        }
        is_definite = invert(pivot, freedoms, nodes_[at], inverse) && is_definite;
        const auto entry = [&inverse](int row, int column) {
            return static_cast<Real>(inverse(row, column));
        };
        inverse_pivots_[at] = {.xx = entry(0, 0),
                               .xy = entry(0, 1),
                               .xz = entry(0, 2),
                               .yy = entry(1, 1),
                               .yz = entry(1, 2),
                               .zz = entry(2, 2)};
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
    for (Index at = begin; at < end; ++at) {
        Vector3r force = forces[nodes_[at]];
        for (Index arm = arms_of_[at]; arm < arms_of_[at + 1]; ++arm)
            force += tangents[arms_[arm].member] * motion[arms_[arm].node];
        if (members_[at] >= 0)
            force += tangents[members_[at]] * partial_[at - 1];
        partial_[at] = inverse_pivots_[at] * force;
    }
    motion[nodes_[end - 1]] = partial_[end - 1];
    for (Index at = end - 2; at >= begin; --at)
        if (members_[at + 1] >= 0)
            motion[nodes_[at]] =
                partial_[at] + inverse_pivots_[at] * (tangents[members_[at + 1]] * motion[nodes_[at + 1]]);
        else
            motion[nodes_[at]] = partial_[at];
}

} // namespace funicular
