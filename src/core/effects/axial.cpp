// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/axial.hpp"

#include "errors.hpp"

#include <cmath>
#include <string>

namespace funicular {

AxialForces::AxialForces(const Net &net, const AxialStiffness &description,
                         const Eigen::VectorXd &rest_lengths, const Scale &scale)
    : net_(net), rest_lengths_(rest_lengths / scale.length), compression_only_(description.compression_only) {
    const auto &given = description.stiffness;
    const Index member_count = net.member_count();
    if (given.size() != 1 && given.size() != member_count)
        throw InvalidInput("AxialStiffness: stiffness has " + std::to_string(given.size()) +
                           " values; give one, or one for each of the " + std::to_string(member_count) +
                           " members");
    for (Index e = 0; e < given.size(); ++e)
        if (!(given[e] > 0) || !std::isfinite(given[e]))
            throw InvalidInput("AxialStiffness: stiffness[" + std::to_string(e) +
                               "] must be positive and finite, in " + (description.per_spring ? "N/m" : "N"));
    stiffness_.resize(member_count);
    for (Index e = 0; e < member_count; ++e) {
        const double value = given[given.size() == 1 ? 0 : e];
        if (!description.per_spring && rest_lengths_[e] == 0)
            throw InvalidInput(
                "rest_lengths[" + std::to_string(e) +
                "] is zero, so EA / r is infinite: give a positive length, or stiffness per spring");
        stiffness_[e] = description.per_spring ? value * scale.length / scale.force
                                               : value / scale.force / rest_lengths_[e];
        if (!std::isfinite(stiffness_[e]) || stiffness_[e] == 0)
            throw InvalidInput("AxialStiffness: member " + std::to_string(e) +
                               " has a stiffness beyond what numbers hold: check its rest length, the "
                               "stiffness and the loads");
    }
}

void AxialForces::add_forces(const Points &x, Points &forces) const {
    for (Index e = 0; e < net_.member_count(); ++e) {
        const auto [i, j] = net_.members()[e];
        const Vector3 along = (x.row(j) - x.row(i)).transpose();
        const double length = along.norm();
        // Ends that coincide give the pull no direction, and so no force.
        if (is_slack(e, length) || length == 0)
            continue;
        const Vector3 pull = (stiffness_[e] * (length - rest_lengths_[e]) / length) * along;
        forces.row(i) += pull.transpose();
        forces.row(j) -= pull.transpose();
    }
}

void AxialForces::couple(Coupling &coupling) const {
    for (const Member &member : net_.members())
        coupling.add(member);
}

void AxialForces::add_tangent(const Points &x, Regularisation regularisation, BlockMatrix &tangent) const {
    for (Index e = 0; e < net_.member_count(); ++e) {
        const auto [i, j] = net_.members()[e];
        const Vector3 along = (x.row(j) - x.row(i)).transpose();
        const double length = along.norm();
        const bool carries = !is_slack(e, length);
        double sideways = carries && length > 0 ? stiffness_[e] * (length - rest_lengths_[e]) / length : 0;
        if ((regularisation.convex ? sideways : std::abs(sideways)) < regularisation.floor)
            sideways = regularisation.floor;
        // ∂(T d)/∂x = k d dᵀ + (T / l) (I - d dᵀ)
        Matrix3 block = sideways * Matrix3::Identity();
        if (carries && length > 0) {
            const Vector3 direction = along / length;
            block += (stiffness_[e] - sideways) * direction * direction.transpose();
        } else if (carries) {
            // A member of no length and no rest length is a spring that pulls alike in every direction.
            block = stiffness_[e] * Matrix3::Identity();
        }
        tangent.add(i, i, block);
        tangent.add(j, j, block);
        tangent.add(i, j, -block);
        tangent.add(j, i, -block);
    }
}

void AxialForces::tensions(const Points &x, Eigen::VectorXd &tensions) const {
    tensions.resize(net_.member_count());
    for (Index e = 0; e < net_.member_count(); ++e) {
        const auto [i, j] = net_.members()[e];
        const double length = (x.row(j) - x.row(i)).norm();
        tensions[e] = is_slack(e, length) ? 0 : stiffness_[e] * (length - rest_lengths_[e]);
    }
}

} // namespace funicular
