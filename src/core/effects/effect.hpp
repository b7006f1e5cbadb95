// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.hpp"
#include "types.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace funicular {

/// How the upward load on a node grows with the place of another.
struct LoadGradient {
    Index node, by;
    Vector3 gradient;
};

/// One cause of nodal forces, in the scene's own units and in the sense of form finding: members pull,
/// gravity is turned round. Holds what it needs of the scene and nothing that changes, so that several
/// threads may share it.
class Effect {
public:
    Effect() = default;
    Effect(const Effect &) = delete;
    Effect &operator=(const Effect &) = delete;
    virtual ~Effect() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;
    /// Memory that it holds [bytes], of the net apart, which all share.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
    /// Whether the forces are loads, which carry weight, rather than what resists them.
    [[nodiscard]] virtual bool is_load() const { return true; }
    /// Adds the force on every node at x.
    virtual void add_forces(const Points &x, Points &forces) const = 0;
    /// Names the pairs of nodes whose force depends on one another's position.
    virtual void couple(Coupling &coupling) const = 0;
    /// Adds minus the derivative of the forces by the positions. It need not be symmetric.
    virtual void add_tangent(const Points &x, BlockMatrix &tangent) const = 0;
    /// Adds minus what a small motion of the nodes makes of the forces: the tangent times the motion, of
    /// which no matrix is made.
    virtual void add_tangent_product(const Points &x, const Points &motion, Points &product) const = 0;
    /// Adds its gradients at x where products are had from them in less time than anew.
    /// \returns whether it did
    virtual bool keep_gradients(const Points & /*x*/, std::vector<LoadGradient> & /*kept*/) const {
        return false;
    }
};

} // namespace funicular
