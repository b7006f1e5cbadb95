// SPDX-License-Identifier: LGPL-2.1-or-later
#include "net.hpp"

#include "errors.hpp"
#include "lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace funicular {

namespace {

// Shorter than this part of the net's size, a member has no direction left to compute with.
constexpr double zero_length = 1e-12;

std::string name_of(const char *argument, Index at) {
    return std::string(argument) + "[" + std::to_string(at) + "]";
}

/// An edge whatever its direction, as one sortable number.
std::uint64_t edge_key(Index a, Index b) {
    const auto [low, high] = std::minmax(a, b);
    return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high);
}

void check_node_number(Index node, Index node_count, const char *argument, Index at) {
    if (node < 0 || node >= node_count)
        throw InvalidInput(name_of(argument, at) + " refers to node " + std::to_string(node) +
                           ", but the net has nodes 0 to " + std::to_string(node_count - 1));
}

void check_nodes(const Points &nodes) {
    if (nodes.rows() == 0)
        throw InvalidInput("nodes is empty: a net needs at least two nodes");
    for (Index i = 0; i < nodes.rows(); ++i)
        if (!nodes.row(i).allFinite())
            throw InvalidInput(name_of("nodes", i) + " is not finite: give every coordinate in metres");
}

void check_members(const std::vector<Member> &members, Index node_count) {
    if (members.empty())
        throw InvalidInput("members is empty: a net needs at least one member");
    std::vector<std::pair<std::uint64_t, Index>> edges;
    edges.reserve(members.size());
    for (Index e = 0; e < static_cast<Index>(members.size()); ++e) {
        const auto [i, j] = members[e];
        check_node_number(i, node_count, "members", e);
        check_node_number(j, node_count, "members", e);
        if (i == j)
            throw InvalidInput(name_of("members", e) + " joins node " + std::to_string(i) +
                               " to itself: remove it");
        edges.emplace_back(edge_key(i, j), e);
    }
    std::sort(edges.begin(), edges.end());
    Index first_repeat = std::numeric_limits<Index>::max();
    Index original = 0;
    for (std::size_t k = 1; k < edges.size(); ++k)
        if (edges[k].first == edges[k - 1].first && edges[k].second < first_repeat) {
            first_repeat = edges[k].second;
            original = edges[k - 1].second;
        }
    if (first_repeat != std::numeric_limits<Index>::max())
        throw InvalidInput(name_of("members", first_repeat) + " joins the same nodes as " +
                           name_of("members", original) + ": keep one of them");
}

void check_panels(const Panels &panels, Index node_count) {
    for (Index f = 0; f < panels.size(); ++f) {
        const auto corners = panels[f];
        if (corners.size() < 3)
            throw InvalidInput(name_of("panels", f) + " has " + std::to_string(corners.size()) +
                               " corners: a panel needs at least three");
        for (const Index node : corners) {
            check_node_number(node, node_count, "panels", f);
            if (std::count(corners.begin(), corners.end(), node) > 1)
                throw InvalidInput(name_of("panels", f) + " names node " + std::to_string(node) +
                                   " twice: list each corner once");
        }
    }
}

} // namespace

void Panels::add(std::span<const Index> corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    offsets_.push_back(static_cast<Index>(corners_.size()));
}

std::span<const Index> Panels::operator[](Index panel) const {
    return {corners_.data() + offsets_[panel],
            static_cast<std::size_t>(offsets_[panel + 1] - offsets_[panel])};
}

Net::Net(Points nodes, std::vector<Member> members, Panels panels, std::shared_ptr<const Lattice> lattice)
    : nodes_(std::move(nodes)), members_(std::move(members)), panels_(std::move(panels)),
      lattice_(std::move(lattice)) {
    check_nodes(nodes_);
    check_members(members_, node_count());
    check_panels(panels_, node_count());

    const Vector3 low = nodes_.colwise().minCoeff();
    const Vector3 high = nodes_.colwise().maxCoeff();
    centre_ = low + (high - low) / 2;
    size_ = (high - low).norm();
    if (!std::isfinite(size_))
        throw InvalidInput("nodes span more than a floating-point number holds: give coordinates in metres");

    source_lengths_.resize(member_count());
    for (Index e = 0; e < member_count(); ++e) {
        const auto [i, j] = members_[e];
        source_lengths_[e] = (nodes_.row(j) - nodes_.row(i)).norm();
        if (source_lengths_[e] <= zero_length * size_)
            throw InvalidInput(name_of("members", e) + " has no length: its nodes " + std::to_string(i) +
                               " and " + std::to_string(j) + " coincide; merge them");
    }
}

std::vector<Index> Net::border() const {
    std::vector<std::uint64_t> edges;
    for (Index f = 0; f < panels_.size(); ++f) {
        const auto corners = panels_[f];
        for (std::size_t k = 0; k < corners.size(); ++k)
            edges.push_back(edge_key(corners[k], corners[(k + 1) % corners.size()]));
    }
    std::sort(edges.begin(), edges.end());

    std::vector<Index> border;
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end] == edges[begin])
            ++end;
        if (end - begin == 1) {
            border.push_back(static_cast<Index>(edges[begin] >> 32U));
            border.push_back(static_cast<Index>(edges[begin] & 0xffffffffU));
        }
    }
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    return border;
}

std::shared_ptr<const Net> flat_sheet(double width, double depth, double step, const char *pattern) {
    for (const auto &[extent, name] : {std::pair{width, "width"}, std::pair{depth, "depth"}}) {
        if (!(extent > 0) || !std::isfinite(extent))
            throw InvalidInput(std::string(name) + " must be positive and finite, in metres");
        if (!(step > 0))
            throw InvalidInput("step must be positive, in metres");
        if (step > extent)
            throw InvalidInput("step is larger than " + std::string(name) + ": choose a smaller step");
    }
    LatticeRecipe recipe;
    recipe.pattern = pattern_from_name(pattern);
    const auto extent_of_cell = cell_extent(recipe.pattern);
    const auto cells = [step](double extent, double cell, const char *name) {
        const double count = std::max(1.0, std::round(extent / (cell * step)));
        if (count > max_lattice_cells)
            throw InvalidInput("step is too small: it makes more than " + std::to_string(max_lattice_cells) +
                               " cells along " + name);
        return static_cast<Index>(count);
    };
    recipe.cells_u = cells(width, extent_of_cell[0], "width");
    recipe.cells_v = cells(depth, extent_of_cell[1], "depth");

    auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes = Points::Zero(lattice->uv().rows(), 3);
    nodes.col(0) = width * lattice->uv().col(0);
    nodes.col(1) = depth * lattice->uv().col(1);
    return make_net(std::move(lattice), std::move(nodes));
}

} // namespace funicular
