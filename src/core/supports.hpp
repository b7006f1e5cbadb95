// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"

#include <vector>

namespace funicular {

/// What each node may still do: the directions that the rigid supports leave it. Supports on one node add up:
/// two vertical planes leave the line where they meet.
class Freedoms {
public:
    /// \throws InvalidInput naming the support and index for a node out of range, a direction of no length,
    /// or a
    ///         stiffness that is negative or not a number.
    Freedoms(const Net &net, const std::vector<Support> &supports);

    /// Number of unknowns.
    [[nodiscard]] Index size() const { return offsets_.back(); }
    /// Place of a node's first unknown; the node has offset(node + 1) - offset(node) of them.
    [[nodiscard]] Index offset(Index node) const { return offsets_[node]; }
    [[nodiscard]] Index count(Index node) const { return offsets_[node + 1] - offsets_[node]; }
    /// The first count(node) columns are the orthonormal directions that a node is free in.
    [[nodiscard]] const Matrix3 &basis(Index node) const { return bases_[basis_of_[node]]; }

    /// What is left of a vector on a node along the directions that the node is free in.
    template <class Vector>
    [[nodiscard]] Vector project(Index node, const Vector &vector) const {
        const Index free = count(node);
        if (free == 3)
            return vector;
        if (free == 0)
            return Vector::Zero();
        const auto directions = basis(node).leftCols(free).cast<typename Vector::Scalar>();
        return directions * (directions.transpose() * vector);
    }

    /// Components of nodal vectors along the free directions.
    void reduce(const Points &vectors, Eigen::VectorXd &unknowns) const;
    /// The nodal vectors that have these components along the free directions and none along others.
    void expand(const Eigen::VectorXd &unknowns, Points &vectors) const;

private:
    std::vector<Index> offsets_;
    std::vector<Index> basis_of_;
    std::vector<Matrix3> bases_;
};

/// The directions that a support takes away, as a projection: what it holds of a motion.
[[nodiscard]] Matrix3 held_directions(const Support &support);

/// A support that yields: force -stiffness (x - anchor), in the scene's own units.
struct ElasticSupport {
    Index node;
    Matrix3 stiffness;
    Vector3 anchor;
};

/// The supports that yield.
[[nodiscard]] std::vector<ElasticSupport>
elastic_supports_of(const Net &net, const std::vector<Support> &supports, const Scale &scale);

/// \throws InvalidInput if a connected part of the net has no support, or nothing that holds it vertically,
/// or if a node without members is left free to move.
void check_every_component_is_held(const Net &net, const std::vector<Support> &supports,
                                   const Freedoms &freedoms);

} // namespace funicular
