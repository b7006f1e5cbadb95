// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/axial.hpp"
#include "lattice.hpp"
#include "supports.hpp"

#include <vector>

namespace funicular {

/// Numbers of a preconditioner: half the memory of double, which is where a sweep's time goes.
using Real = float;
using Vector3r = Eigen::Matrix<Real, 3, 1>;
using Vectors3r = std::vector<Vector3r>;

/// What a small motion of a member's ends makes of its pull: `around` I + `along` d dᵀ.
struct ShortMemberTangent {
    Vector3r direction;
    Real along, around;
    [[nodiscard]] Vector3r operator*(const Vector3r &stretch) const {
        return around * stretch + (along * direction.dot(stretch)) * direction;
    }
};

/// A symmetric 3 x 3 block.
template <class Number>
struct SymmetricBlock {
    Number xx, xy, xz, yy, yz, zz;

    [[nodiscard]] Eigen::Matrix<Number, 3, 1> operator*(const Eigen::Matrix<Number, 3, 1> &vector) const {
        return {xx * vector[0] + xy * vector[1] + xz * vector[2],
                xy * vector[0] + yy * vector[1] + yz * vector[2],
                xz * vector[0] + yz * vector[1] + zz * vector[2]};
    }
    [[nodiscard]] Eigen::Matrix<Number, 3, 3> matrix() const {
        Eigen::Matrix<Number, 3, 3> whole;
        whole << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        return whole;
    }
    /// Adds `all_round` I + `along` d dᵀ.
    void add(Number all_round, Number along, const Eigen::Matrix<Number, 3, 1> &d) {
        xx += all_round + along * d[0] * d[0];
        xy += along * d[0] * d[1];
        xz += along * d[0] * d[2];
        yy += all_round + along * d[1] * d[1];
        yz += along * d[1] * d[2];
        zz += all_round + along * d[2] * d[2];
    }
};

/// Gauss-Seidel by the lines of a lattice: each line's equilibrium is solved as a whole while its neighbours
/// rest.
///
/// A member is far stiffer along itself than sideways, and members follow the lines. Node by node it would
/// take as many sweeps as that ratio is large; line by line it takes none (line relaxation: Trottenberg,
/// Oosterlee and Schüller, "Multigrid", 2001, section 5.1).
class LineSmoother {
public:
    enum class Direction { u, v };

    LineSmoother(const Lattice &lattice, const std::vector<Member> &members, Direction direction);

    /// Factorises every line.
    /// \param diagonals the tangent's block of each node with itself
    /// \returns whether each was positive definite
    bool prepare(const std::vector<AxialForces::MemberTangent> &tangents,
                 const std::vector<SymmetricBlock<double>> &diagonals, const Freedoms &freedoms);

    enum class Order { forward, backward };
    /// Solves line after line for the motion under the forces.
    void sweep(const std::vector<ShortMemberTangent> &tangents, const Vectors3r &forces, Order order,
               Vectors3r &motion);

private:
    /// A member to a node beside the line.
    struct Arm {
        Index node, member;
    };

    void solve_line(std::size_t line, const std::vector<ShortMemberTangent> &tangents,
                    const Vectors3r &forces, Vectors3r &motion);

    // Lines one after another, node by node.
    std::vector<Index> lines_{0};
    std::vector<Index> nodes_;
    /// Member from the node before on the line, or -1.
    std::vector<Index> members_;
    std::vector<Index> arms_of_{0};
    std::vector<Arm> arms_;
    std::vector<SymmetricBlock<Real>> inverse_pivots_;
    /// L M, L the inverse pivot of a node and M the tangent of the member to the next one on its line: kept,
    /// as a sweep has to wait for each product with it.
    std::vector<Eigen::Matrix<Real, 3, 3>> carries_;
    Vectors3r partial_;
};

} // namespace funicular
