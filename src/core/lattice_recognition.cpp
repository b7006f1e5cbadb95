// SPDX-License-Identifier: LGPL-2.1-or-later
#include "lattice_recognition.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace funicular {

namespace {

constexpr Index nowhere = -1;

/// Members around each node of a net in which no node has more than four.
class Neighbours {
public:
    struct Arm {
        Index node, member;
    };

    explicit Neighbours(const Net &net) : counts_(net.node_count(), 0), arms_(net.node_count()) {
        for (Index e = 0; e < net.member_count() && fits_; ++e) {
            const auto [a, b] = net.members()[e];
            add(a, {.node = b, .member = e});
            add(b, {.node = a, .member = e});
        }
    }
    [[nodiscard]] bool fits() const { return fits_; }
    [[nodiscard]] int count(Index node) const { return counts_[node]; }
    [[nodiscard]] std::span<const Arm> of(Index node) const {
        return {arms_[node].data(), static_cast<std::size_t>(counts_[node])};
    }
    /// The member between two nodes, or -1.
    [[nodiscard]] Index member(Index a, Index b) const {
        for (const Arm &arm : of(a))
            if (arm.node == b)
                return arm.member;
        return nowhere;
    }

private:
    void add(Index node, Arm arm) {
        if (counts_[node] == 4)
            fits_ = false;
        else
            arms_[node][counts_[node]++] = arm;
    }
    std::vector<int> counts_;
    std::vector<std::array<Arm, 4>> arms_;
    bool fits_ = true;
};

bool is_before(const Points &nodes, Index a, Index b) {
    return std::lexicographical_compare(nodes.row(a).begin(), nodes.row(a).end(), nodes.row(b).begin(),
                                        nodes.row(b).end());
}

/// The corner of the least coordinates; -1 unless four nodes have two members and none has fewer.
Index first_corner(const Points &nodes, const Neighbours &neighbours) {
    Index first = nowhere;
    int corners = 0;
    for (Index node = 0; node < nodes.rows(); ++node) {
        if (neighbours.count(node) < 2)
            return nowhere;
        if (neighbours.count(node) > 2)
            continue;
        ++corners;
        if (first == nowhere || is_before(nodes, node, first))
            first = node;
    }
    return corners == 4 ? first : nowhere;
}

/// The net's nodes row by row, from one corner on.
class Rows {
public:
    Rows(const Neighbours &neighbours, Index node_count)
        : neighbours_(neighbours), seen_(node_count, false) {}

    /// The border from a corner through the node beside it to the next corner.
    bool begin(Index corner, Index beside) {
        take(corner);
        for (Index node = beside; node != nowhere;) {
            take(node);
            if (neighbours_.count(node) == 2)
                break;
            Index next = nowhere;
            for (const auto &arm : neighbours_.of(node)) {
                if (seen_[arm.node] || neighbours_.count(arm.node) == 4)
                    continue;
                if (next != nowhere) // the long side of a strip of one cell
                    return false;
                next = arm.node;
            }
            node = next;
        }
        width_ = static_cast<Index>(nodes_.size());
        return neighbours_.count(nodes_.back()) == 2;
    }
    /// The row behind the last one: what each of its nodes leads to and was not met before.
    bool add_next() {
        const auto before = static_cast<Index>(nodes_.size()) - width_;
        for (Index k = 0; k < width_; ++k) {
            Index next = nowhere;
            for (const auto &arm : neighbours_.of(nodes_[before + k])) {
                if (seen_[arm.node])
                    continue;
                if (next != nowhere)
                    return false;
                next = arm.node;
            }
            if (next == nowhere)
                return false;
            nodes_.push_back(next);
            // Not yet: its neighbour in this row is no member of the row before.
        }
        for (Index k = 0; k < width_; ++k) {
            const Index node = nodes_[before + width_ + k];
            if (seen_[node])
                return false;
            seen_[node] = true;
        }
        return true;
    }
    [[nodiscard]] Index width() const { return width_; }
    [[nodiscard]] const std::vector<Index> &nodes() const { return nodes_; }

private:
    void take(Index node) {
        seen_[node] = true;
        nodes_.push_back(node);
    }
    const Neighbours &neighbours_;
    std::vector<bool> seen_;
    std::vector<Index> nodes_;
    Index width_ = 0;
};

/// The net's member for each of the lattice's; none if one is missing.
std::vector<Index> members_of(const Lattice &lattice, const std::vector<Index> &nodes,
                              const Neighbours &neighbours) {
    std::vector<Index> members;
    members.reserve(lattice.members().size());
    for (const auto &[a, b] : lattice.members()) {
        const Index member = neighbours.member(nodes[a], nodes[b]);
        if (member == nowhere)
            return {};
        members.push_back(member);
    }
    return members;
}

} // namespace

std::shared_ptr<const Lattice> recognised_lattice(const Net &net) {
    const Neighbours neighbours(net);
    if (!neighbours.fits())
        return nullptr;
    const Index corner = first_corner(net.nodes(), neighbours);
    if (corner == nowhere)
        return nullptr;
    Index along = neighbours.of(corner)[0].node;
    Index across = neighbours.of(corner)[1].node;
    if (is_before(net.nodes(), along, across))
        std::swap(along, across);

    std::optional<Rows> rows(std::in_place, neighbours, net.node_count());
    if (!rows->begin(corner, along) && !rows.emplace(neighbours, net.node_count()).begin(corner, across))
        return nullptr;
    const Index width = rows->width();
    if (net.node_count() % width != 0)
        return nullptr;
    const Index height = net.node_count() / width;
    if (height < 2 || static_cast<double>(width - 1) * (height - 1) > max_lattice_cells ||
        net.member_count() != 2 * width * height - width - height)
        return nullptr;
    for (Index row = 1; row < height; ++row)
        if (!rows->add_next())
            return nullptr;

    LatticeRecipe recipe;
    recipe.cells_u = width - 1;
    recipe.cells_v = height - 1;
    const Lattice lattice(std::move(recipe));
    auto members = members_of(lattice, rows->nodes(), neighbours);
    if (members.empty())
        return nullptr;
    return std::make_shared<const Lattice>(lattice.renumbered(rows->nodes(), std::move(members)));
}

} // namespace funicular
