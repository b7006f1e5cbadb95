// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/member_weight.hpp"

#include "errors.hpp"

#include <cmath>

namespace funicular {

MemberLoads::MemberLoads(const Net &net, const MemberWeight &description, const Scale &scale)
    : net_(net), half_weight_(standard_gravity * description.per_length * scale.length / scale.force / 2),
      lines_(description.lines) {
    if (!(description.per_length >= 0) || !std::isfinite(description.per_length))
        throw InvalidInput("MemberWeight: weight must be zero or positive and finite, in kg/m");
}

void MemberLoads::add_forces(const Points &x, Points &forces) const {
    for (std::size_t e = 0; e < net_.members().size(); ++e) {
        const auto [i, j] = net_.members()[e];
        const double load = half_weight(e) * (x.row(j) - x.row(i)).norm();
        forces(i, 2) += load;
        forces(j, 2) += load;
    }
}

void MemberLoads::couple(Coupling &coupling) const {
    for (const Member &member : net_.members())
        coupling.add(member);
}

template <class Add>
void MemberLoads::differentiate(const Points &x, const Add &add) const {
    for (std::size_t e = 0; e < net_.members().size(); ++e) {
        const auto [i, j] = net_.members()[e];
        const Vector3 along = (x.row(j) - x.row(i)).transpose();
        const double length = along.norm();
        if (length == 0)
            continue;
        const Vector3 by_far_end = half_weight(e) / length * along;
        for (const Index end : {i, j}) {
            add(end, j, by_far_end);
            add(end, i, -by_far_end);
        }
    }
}

void MemberLoads::add_tangent(const Points &x, BlockMatrix &tangent) const {
    differentiate(x, [&tangent](Index node, Index by, const Vector3 &gradient) {
        tangent.add_vertical(node, by, -gradient);
    });
}

void MemberLoads::add_tangent_product(const Points &x, const Points &motion, Points &product) const {
    differentiate(x, [&motion, &product](Index node, Index by, const Vector3 &gradient) {
        product(node, 2) -= gradient.dot(motion.row(by));
    });
}

} // namespace funicular
