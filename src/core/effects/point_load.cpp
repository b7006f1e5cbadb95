// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/point_load.hpp"

#include "errors.hpp"

#include <algorithm>
#include <string>

namespace funicular {

PointLoads::PointLoads(const Net &net, const PointLoad &description, const Scale &scale)
    : nodes_(description.nodes), force_(-description.force / scale.force) {
    if (!description.force.allFinite())
        throw InvalidInput("PointLoad: force must be finite, in N");
    for (std::size_t k = 0; k < nodes_.size(); ++k)
        if (nodes_[k] < 0 || nodes_[k] >= net.node_count())
            throw InvalidInput("PointLoad: ids[" + std::to_string(k) + "] is " + std::to_string(nodes_[k]) +
                               ", but the net has nodes 0 to " + std::to_string(net.node_count() - 1));
    auto sorted = nodes_;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        throw InvalidInput("PointLoad: ids names node " + std::to_string(*twice) +
                           " twice: give another PointLoad for it");
}

void PointLoads::add_forces(const Points & /*x*/, Points &forces) const {
    for (const Index node : nodes_)
        forces.row(node) += force_.transpose();
}

} // namespace funicular
