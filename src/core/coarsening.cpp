// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarsening.hpp"

#include <utility>

namespace funicular {

namespace {

// A direction of fewer cells is left as it is.
constexpr Index least_cells = 4;

bool has_lines_along_u(const Lattice &lattice) {
    return lattice.recipe().pattern != Pattern::ribs_v;
}
bool has_lines_along_v(const Lattice &lattice) {
    return lattice.recipe().pattern != Pattern::ribs_u;
}

} // namespace

LineMembers::LineMembers(const Lattice &lattice)
    : cells_u_(lattice.recipe().cells_u), lines_u_(lattice.lines_u()),
      along_u_(static_cast<std::size_t>(cells_u_) * lattice.lines_v(), -1),
      along_v_(static_cast<std::size_t>(lines_u_) * lattice.recipe().cells_v, -1) {
    // Members were laid in this order, those along u first.
    Index next = 0;
    for (Index j = 0; has_lines_along_u(lattice) && j < lattice.lines_v(); ++j)
        for (Index i = 0; i < cells_u_; ++i)
            if (lattice.node_at(i, j) != lattice.node_at(i + 1, j))
                along_u_[j * cells_u_ + i] = lattice.laid(next++);
    for (Index j = 0; has_lines_along_v(lattice) && j < lattice.recipe().cells_v; ++j)
        for (Index i = 0; i < lines_u_; ++i)
            if (lattice.node_at(i, j) != lattice.node_at(i, j + 1))
                along_v_[j * lines_u_ + i] = lattice.laid(next++);
}

std::optional<Coarsening> Coarsening::of(const std::shared_ptr<const Lattice> &fine) {
    if (!fine)
        return std::nullopt;
    const Pattern pattern = fine->recipe().pattern;
    if (pattern != Pattern::quad && pattern != Pattern::ribs_u && pattern != Pattern::ribs_v)
        return std::nullopt;
    const auto thinned = [](Index cells, bool closed, bool is_divided) {
        const bool halved = is_divided && cells >= (closed ? 2 : 1) * least_cells;
        return Direction{.cells = cells,
                         .coarse_cells = halved ? (cells + 1) / 2 : cells,
                         .closed = closed,
                         .halved = halved};
    };
    const Direction u = thinned(fine->recipe().cells_u, fine->recipe().closed_u, has_lines_along_u(*fine));
    const Direction v = thinned(fine->recipe().cells_v, fine->recipe().closed_v, has_lines_along_v(*fine));
    if (!u.halved && !v.halved)
        return std::nullopt;
    return Coarsening(fine, u, v);
}

Coarsening::Coarsening(std::shared_ptr<const Lattice> fine, Direction u, Direction v)
    : u_(u), v_(v), fine_(std::move(fine)) {
    LatticeRecipe recipe = fine_->recipe();
    recipe.cells_u = u_.coarse_cells;
    recipe.cells_v = v_.coarse_cells;
    coarse_ = std::make_shared<const Lattice>(std::move(recipe));
    find_parents();
    find_strands();
}

std::array<Coarsening::Parent, 2> Coarsening::Direction::parents(Index line) const {
    if (!halved)
        return {{{line, 1}, {line, 0}}};
    if (line % 2 == 0)
        return {{{line / 2, 1}, {line / 2, 0}}};
    if (line == cells) // an odd number of cells leaves the last one as it is
        return {{{coarse_cells, 1}, {coarse_cells, 0}}};
    const Index after = line / 2 + 1;
    return {{{line / 2, 0.5}, {closed && after == coarse_cells ? 0 : after, 0.5}}};
}

std::array<Coarsening::Parent, 4> Coarsening::Direction::interpolation(Index line) const {
    const auto [before, after] = parents(line);
    if (after.part == 0)
        return {{before, {0, 0}, {0, 0}, {0, 0}}};
    // Where the last cell was left single, lines no longer stand at equal steps.
    const bool has_before = closed ? cells % 2 == 0 : before.node > 0;
    const bool has_after =
        closed ? cells % 2 == 0 : after.node + 1 < coarse_lines() && 2 * (after.node + 1) <= cells;
    const auto wrapped = [this](Index at) { return (at + coarse_lines()) % coarse_lines(); };
    const Parent outer_before{wrapped(before.node - 1), has_before ? (has_after ? -1.0 / 16 : -1.0 / 8) : 0};
    const Parent outer_after{wrapped(after.node + 1), has_after ? (has_before ? -1.0 / 16 : -1.0 / 8) : 0};
    const double near = has_before && has_after ? 9.0 / 16 : has_before || has_after ? 6.0 / 8 : 1.0 / 2;
    const double far = has_before && has_after ? 9.0 / 16 : has_before || has_after ? 3.0 / 8 : 1.0 / 2;
    return {{outer_before,
             {before.node, has_before ? near : far},
             {after.node, has_before ? far : near},
             outer_after}};
}

void Coarsening::find_parents() {
    fine_nodes_.assign(coarse_->uv().rows(), -1);
    for (Index j = 0; j < v_.coarse_lines(); ++j)
        for (Index i = 0; i < u_.coarse_lines(); ++i)
            fine_nodes_[coarse_->node_at(i, j)] = fine_->node_at(u_.fine_line(i), v_.fine_line(j));

    struct Place {
        Index i = -1, j = -1;
    };
    std::vector<Place> places(fine_->uv().rows());
    for (Index j = v_.lines() - 1; j >= 0; --j)
        for (Index i = u_.lines() - 1; i >= 0; --i)
            places[fine_->node_at(i, j)] = {.i = i, .j = j};

    offsets_.assign(1, 0);
    for (const auto &[i, j] : places) {
        const auto first = static_cast<std::ptrdiff_t>(parents_.size());
        for (const Parent &along_v : v_.parents(j))
            for (const Parent &along_u : u_.parents(i)) {
                const double part = along_u.part * along_v.part;
                if (part == 0)
                    continue;
                const Index node = coarse_->node_at(along_u.node, along_v.node);
                const auto same = std::find_if(parents_.begin() + first, parents_.end(),
                                               [node](const Parent &parent) { return parent.node == node; });
                if (same == parents_.end())
                    parents_.push_back({node, part});
                else
                    same->part += part;
            }
        offsets_.push_back(static_cast<Index>(parents_.size()));
    }
}

void Coarsening::find_strands() {
    const LineMembers fine(*fine_);
    const LineMembers coarse(*coarse_);
    const auto add = [this](Index coarse_member, Index first, Index second, double part) {
        if (coarse_member >= 0 && first >= 0 && part > 0)
            strands_.push_back({coarse_member, first, second, part});
    };
    // A coarse cell spans two fine ones, but for a last single one.
    const auto second_cell = [](const Direction &along, Index coarse_cell) {
        const Index cell = 2 * coarse_cell + 1;
        return along.halved && cell < along.cells ? cell : -1;
    };
    for (Index j = 0; j < v_.lines(); ++j)
        for (const Parent &line : v_.parents(j))
            for (Index cell = 0; cell < u_.coarse_cells; ++cell) {
                const Index second = second_cell(u_, cell);
                add(coarse.along_u(cell, line.node), fine.along_u(u_.fine_line(cell), j),
                    second < 0 ? -1 : fine.along_u(second, j), line.part);
            }
    for (Index i = 0; i < u_.lines(); ++i)
        for (const Parent &line : u_.parents(i))
            for (Index cell = 0; cell < v_.coarse_cells; ++cell) {
                const Index second = second_cell(v_, cell);
                add(coarse.along_v(line.node, cell), fine.along_v(i, v_.fine_line(cell)),
                    second < 0 ? -1 : fine.along_v(i, second), line.part);
            }
}

void Coarsening::interpolate(const Points &coarse, Points &fine) const {
    // Along u on the lines that both lattices have, then along v.
    Points between(static_cast<Eigen::Index>(v_.coarse_lines()) * u_.lines(), 3);
    for (Index i = 0; i < u_.lines(); ++i) {
        const auto sources = u_.interpolation(i);
        for (Index j = 0; j < v_.coarse_lines(); ++j) {
            auto point = between.row(j * u_.lines() + i);
            point.setZero();
            for (const auto &[line, part] : sources)
                if (part != 0)
                    point += part * coarse.row(coarse_->node_at(line, j));
        }
    }
    fine.resize(fine_->uv().rows(), 3);
    for (Index j = 0; j < v_.lines(); ++j) {
        const auto sources = v_.interpolation(j);
        for (Index i = 0; i < u_.lines(); ++i) {
            auto point = fine.row(fine_->node_at(i, j));
            point.setZero();
            for (const auto &[line, part] : sources)
                if (part != 0)
                    point += part * between.row(line * u_.lines() + i);
        }
    }
}

} // namespace funicular
