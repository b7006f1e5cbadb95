// SPDX-License-Identifier: LGPL-2.1-or-later
#include "supports.hpp"

#include "errors.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

namespace funicular {

namespace {

// A direction no farther than this from those held before (the sine of an angle) is one of them: two planes
// that meet at a smaller angle are the first of them, as their line of intersection would be noise.
constexpr double same_direction = 1.4142e-4;
// What is held upwards by less than this part (a cosine, squared) is not held vertically.
constexpr double least_upward = 1e-8;

void check_supports(const Net &net, const std::vector<Support> &supports) {
    for (std::size_t s = 0; s < supports.size(); ++s) {
        const Support &support = supports[s];
        const std::string name = "supports[" + std::to_string(s) + "]";
        for (std::size_t k = 0; k < support.nodes.size(); ++k)
            if (support.nodes[k] < 0 || support.nodes[k] >= net.node_count())
                throw InvalidInput(name + ": ids[" + std::to_string(k) + "] is " +
                                   std::to_string(support.nodes[k]) + ", but the net has nodes 0 to " +
                                   std::to_string(net.node_count() - 1));
        if (!(support.stiffness >= 0))
            throw InvalidInput(name + ": stiffness must be zero, positive or infinite, in N/m");
        if (support.kind != SupportKind::fixed &&
            !(support.direction.allFinite() && support.direction.stableNorm() > 0))
            throw InvalidInput(name + (support.kind == SupportKind::on_line ? ": direction" : ": normal") +
                               " must be finite and not zero");
    }
}

/// Parts of the net that no member joins: for each node the lowest node of its part.
std::vector<Index> components(const Net &net) {
    std::vector<Index> parent(net.node_count());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](Index node) {
        while (parent[node] != node)
            node = parent[node] = parent[parent[node]];
        return node;
    };
    for (const auto &[i, j] : net.members()) {
        const Index a = root(i);
        const Index b = root(j);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (Index node = 0; node < net.node_count(); ++node)
        parent[node] = root(node);
    return parent;
}

std::string component_in_words(const std::vector<Index> &component_of, Index component) {
    const auto count = std::count(component_of.begin(), component_of.end(), component);
    return "the component of " + std::to_string(count) + (count == 1 ? " node" : " nodes");
}

/// The first nodes of a component, for a person to find it by, and the way out.
std::string list_to_fix(const std::vector<Index> &component_of, Index component) {
    constexpr Index shown = 5;
    std::string text;
    Index count = 0;
    for (Index node = 0; node < static_cast<Index>(component_of.size()); ++node)
        if (component_of[node] == component && count++ < shown)
            text += (count > 1 ? ", " : "") + std::to_string(node);
    if (count == 1)
        return ": node " + text + "; fix it";
    return ": nodes " + text + (count > shown ? ", …" : "") + "; fix at least one of them";
}

/// Adds what a support holds to what those before it hold, both as projections.
void hold(const Support &support, Matrix3 &held) {
    const auto add = [&held](const Vector3 &direction) {
        const Vector3 beyond = direction - held * direction;
        if (beyond.norm() > same_direction)
            held += beyond.normalized() * beyond.normalized().transpose();
    };
    if (support.kind == SupportKind::on_plane)
        return add(support.direction.stableNormalized());
    const Matrix3 directions = held_directions(support);
    for (Index axis = 0; axis < 3; ++axis)
        add(directions.col(axis));
}

} // namespace

Matrix3 held_directions(const Support &support) {
    const Vector3 unit = support.direction.stableNormalized();
    switch (support.kind) {
    case SupportKind::on_line:
        return Matrix3::Identity() - unit * unit.transpose();
    case SupportKind::on_plane:
        return unit * unit.transpose();
    case SupportKind::fixed:
        break;
    }
    return Matrix3::Identity();
}

Freedoms::Freedoms(const Net &net, const std::vector<Support> &supports)
    : offsets_(net.node_count() + 1, 0), basis_of_(net.node_count(), 0), bases_{Matrix3::Identity()} {
    check_supports(net, supports);

    std::map<Index, Matrix3> held; // as projections
    for (const Support &support : supports) {
        if (!std::isinf(support.stiffness))
            continue;
        for (const Index node : support.nodes)
            hold(support, held.try_emplace(node, Matrix3::Zero()).first->second);
    }
    for (Index node = 0; node < net.node_count(); ++node) {
        Index free = 3;
        if (const auto found = held.find(node); found != held.end()) {
            // Eigenvalues ascend, so the directions that nothing holds come first.
            const Eigen::SelfAdjointEigenSolver<Matrix3> solver(found->second);
            free = static_cast<Index>((solver.eigenvalues().array() < 0.5).count());
            if (free > 0) {
                basis_of_[node] = static_cast<Index>(bases_.size());
                bases_.push_back(solver.eigenvectors());
            }
        }
        offsets_[node + 1] = offsets_[node] + free;
    }
}

void Freedoms::reduce(const Points &vectors, Eigen::VectorXd &unknowns) const {
    unknowns.resize(size());
    for (Index node = 0; node < vectors.rows(); ++node) {
        const Index free = count(node);
        if (basis_of_[node] == 0)
            unknowns.segment(offset(node), free) = vectors.row(node).head(free).transpose();
        else
            unknowns.segment(offset(node), free).noalias() =
                basis(node).leftCols(free).transpose() * vectors.row(node).transpose();
    }
}

void Freedoms::expand(const Eigen::VectorXd &unknowns, Points &vectors) const {
    for (Index node = 0; node < vectors.rows(); ++node) {
        const Index free = count(node);
        if (free == 0)
            vectors.row(node).setZero();
        else
            vectors.row(node).transpose().noalias() =
                basis(node).leftCols(free) * unknowns.segment(offset(node), free);
    }
}

std::vector<ElasticSupport> elastic_supports_of(const Net &net, const std::vector<Support> &supports,
                                                const Scale &scale) {
    std::vector<ElasticSupport> elastic;
    for (const Support &support : supports) {
        if (std::isinf(support.stiffness) || support.stiffness == 0)
            continue;
        const Matrix3 stiffness = support.stiffness * scale.length / scale.force * held_directions(support);
        for (const Index node : support.nodes)
            elastic.push_back(
                {node, stiffness, (net.nodes().row(node).transpose() - scale.origin) / scale.length});
    }
    return elastic;
}

void check_every_component_is_held(const Net &net, const std::vector<Support> &supports,
                                   const Freedoms &freedoms) {
    const auto component_of = components(net);
    std::vector<bool> has_members(net.node_count(), false);
    for (const auto &[i, j] : net.members())
        has_members[i] = has_members[j] = true;
    const auto is_alone = [&has_members](Index node) { return !has_members[node]; };
    std::vector<double> held_up(net.node_count(), -1.0);
    for (const Support &support : supports) {
        if (support.stiffness == 0)
            continue;
        const double up = held_directions(support)(2, 2);
        for (const Index node : support.nodes)
            held_up[component_of[node]] = std::max(held_up[component_of[node]], up);
    }
    for (Index component = 0; component < net.node_count(); ++component) {
        if (component_of[component] != component)
            continue;
        if (held_up[component] < 0)
            throw InvalidInput("supports: " + component_in_words(component_of, component) +
                               " has no support" + list_to_fix(component_of, component));
        if (is_alone(component) && freedoms.count(component) > 0)
            throw InvalidInput("supports: node " + std::to_string(component) +
                               " has no members, so that nothing brings it to rest: fix it, or leave it out");
        if (held_up[component] < least_upward)
            throw InvalidInput("supports: nothing holds " + component_in_words(component_of, component) +
                               " vertically" + list_to_fix(component_of, component));
    }
}

} // namespace funicular
