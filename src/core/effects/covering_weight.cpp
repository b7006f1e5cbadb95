// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/covering_weight.hpp"

#include "effects/corner_areas.hpp"
#include "errors.hpp"

#include <cmath>

namespace funicular {

CoveringLoads::CoveringLoads(const Net &net, const CoveringWeight &description, const Scale &scale)
    : net_(net), share_(description.share),
      weight_(standard_gravity * description.per_area * scale.length * scale.length / scale.force) {
    if (!(description.per_area >= 0) || !std::isfinite(description.per_area))
        throw InvalidInput("CoveringWeight: weight must be zero or positive and finite, in kg/m²");
    if (net.panels().empty())
        throw InvalidInput(
            "CoveringWeight: the net has no panels to cover; give it panels, or leave the covering out");
}

void CoveringLoads::add_forces(const Points &x, Points &forces) const {
    CornerAreas corner_areas(share_);
    for (Index f = 0; f < net_.panels().size(); ++f) {
        const auto corners = net_.panels()[f];
        const auto &areas = corner_areas.areas(x, corners);
        for (std::size_t k = 0; k < corners.size(); ++k)
            forces(corners[k], 2) += weight_ * areas[k];
    }
}

void CoveringLoads::couple(Coupling &coupling) const {
    for (Index f = 0; f < net_.panels().size(); ++f)
        coupling.add(net_.panels()[f]);
}

template <class Add>
void CoveringLoads::differentiate(const Points &x, const Add &add) const {
    CornerAreas corner_areas(share_);
    for (Index f = 0; f < net_.panels().size(); ++f) {
        const auto corners = net_.panels()[f];
        const auto &gradients = corner_areas.gradients(x, corners);
        for (std::size_t k = 0; k < corners.size(); ++k)
            for (std::size_t m = 0; m < corners.size(); ++m)
                add(corners[k], corners[m], weight_ * gradients[k * corners.size() + m]);
    }
}

void CoveringLoads::add_tangent(const Points &x, BlockMatrix &tangent) const {
    differentiate(x, [&tangent](Index node, Index by, const Vector3 &gradient) {
        tangent.add_vertical(node, by, -gradient);
    });
}

void CoveringLoads::add_tangent_product(const Points &x, const Points &motion, Points &product) const {
    differentiate(x, [&motion, &product](Index node, Index by, const Vector3 &gradient) {
        product(node, 2) -= gradient.dot(motion.row(by));
    });
}

bool CoveringLoads::keep_gradients(const Points &x, std::vector<LoadGradient> &kept) const {
    differentiate(x, [&kept](Index node, Index by, const Vector3 &gradient) {
        kept.push_back({.node = node, .by = by, .gradient = gradient});
    });
    return true;
}

} // namespace funicular
