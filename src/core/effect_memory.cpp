// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effect_memory.hpp"

#include "block_matrix.hpp"
#include "effects/effect.hpp"

namespace funicular {

namespace {

constexpr std::size_t bytes_per_block = sizeof(Matrix3) + sizeof(Index);

/// Blocks of the tangent without the effects of one name; with all of them if it is empty.
std::size_t blocks_without(const Scene &scene, std::string_view name) {
    Coupling coupling(scene.net().node_count());
    for (const auto &effect : scene.acting())
        if (effect->name() != name)
            effect->couple(coupling);
    return BlockMatrix(std::move(coupling)).block_count();
}

} // namespace

std::map<std::string, std::size_t> effect_memory(const Scene &scene) {
    const std::size_t all = blocks_without(scene, "");
    std::map<std::string, std::size_t> bytes;
    for (const auto &effect : scene.acting()) {
        const auto [entry, is_new] = bytes.try_emplace(std::string(effect->name()), 0);
        entry->second += effect->bytes();
        if (is_new)
            entry->second += bytes_per_block * (all - blocks_without(scene, effect->name()));
    }
    return bytes;
}

} // namespace funicular
