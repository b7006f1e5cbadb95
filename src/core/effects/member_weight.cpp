// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/member_weight.hpp"

#include "errors.hpp"

#include <cmath>

namespace funicular {

MemberLoads::MemberLoads(const Net &net, const MemberWeight &description, const Scale &scale)
    : net_(net), half_weight_(standard_gravity * description.per_length * scale.length / scale.force / 2) {
    if (!(description.per_length >= 0) || !std::isfinite(description.per_length))
        throw InvalidInput("MemberWeight: weight must be zero or positive and finite, in kg/m");
}

void MemberLoads::add_forces(const Points &x, Points &forces) const {
    for (const auto &[i, j] : net_.members()) {
        const double load = half_weight_ * (x.row(j) - x.row(i)).norm();
        forces(i, 2) += load;
        forces(j, 2) += load;
    }
}

void MemberLoads::couple(Coupling &coupling) const {
    for (const Member &member : net_.members())
        coupling.add(member);
}

void MemberLoads::add_tangent(const Points &x, BlockMatrix &tangent) const {
    for (const auto &[i, j] : net_.members()) {
        const Vector3 along = (x.row(j) - x.row(i)).transpose();
        const double length = along.norm();
        if (length == 0)
            continue;
        Matrix3 block = Matrix3::Zero();
        block.row(2) = half_weight_ / length * along.transpose();
        for (const Index end : {i, j}) {
            tangent.add(end, i, block);
            tangent.add(end, j, -block);
        }
    }
}

} // namespace funicular
