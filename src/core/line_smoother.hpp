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
                 const std::vector<Matrix3> &diagonals, const Freedoms &freedoms);

    enum class Order { forward, backward };
    /// Solves line after line for the motion under the forces.
    void sweep(const std::vector<ShortMemberTangent> &tangents, const Vectors3r &forces, Order order,
               Vectors3r &motion);

private:
    /// A symmetric 3 x 3 block.
    struct Pivot {
        Real xx, xy, xz, yy, yz, zz;
        [[nodiscard]] Vector3r operator*(const Vector3r &force) const {
            return {xx * force[0] + xy * force[1] + xz * force[2],
                    xy * force[0] + yy * force[1] + yz * force[2],
                    xz * force[0] + yz * force[1] + zz * force[2]};
        }
    };
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
    std::vector<Pivot> inverse_pivots_;
    Vectors3r partial_;
};

} // namespace funicular
