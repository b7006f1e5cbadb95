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
            throw InvalidInput("AxialStiffness: stiffness" +
                               (given.size() == 1 ? "" : "[" + std::to_string(e) + "]") +
                               " must be positive and finite, in " + (description.per_spring ? "N/m" : "N"));
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

Vector3 AxialForces::pull(Index member, const Points &x) const {
    const auto [i, j] = net_.members()[member];
    const Vector3 along = (x.row(j) - x.row(i)).transpose();
    const double length = along.norm();
    // Ends that coincide give the pull no direction, and so no force.
    if (is_slack(member, length) || length == 0)
        return Vector3::Zero();
    return (stiffness_[member] * (length - rest_lengths_[member]) / length) * along;
}

void AxialForces::add_forces(const Points &x, Points &forces) const {
    for (Index e = 0; e < net_.member_count(); ++e) {
        const auto [i, j] = net_.members()[e];
        const Vector3 force = pull(e, x);
        forces.row(i) += force.transpose();
        forces.row(j) -= force.transpose();
    }
}

void AxialForces::couple(Coupling &coupling) const {
    for (const Member &member : net_.members())
        coupling.add(member);
}

AxialForces::MemberTangent AxialForces::tangent(Index member, const Points &x,
                                                Regularisation regularisation) const {
    const auto [i, j] = net_.members()[member];
    const Vector3 along = (x.row(j) - x.row(i)).transpose();
    const double length = along.norm();
    const double k = stiffness_[member];
    const bool carries = !is_slack(member, length);
    // A member of no length and no rest length is a spring that pulls alike in every direction.
    if (carries && length == 0)
        return {.direction = Vector3::Zero(), .along = 0, .around = k};
    double sideways = carries ? k * (length - rest_lengths_[member]) / length : 0;
    if ((regularisation.convex ? sideways : std::abs(sideways)) < regularisation.floor)
        sideways = regularisation.floor;
    if (!carries)
        return {.direction = Vector3::Zero(), .along = 0, .around = sideways};
    return {.direction = along / length, .along = k - sideways, .around = sideways};
}

void AxialForces::add_tangent(const Points &x, Regularisation regularisation, BlockMatrix &tangents) const {
    for (Index e = 0; e < net_.member_count(); ++e) {
        const auto [i, j] = net_.members()[e];
        const Matrix3 block = tangent(e, x, regularisation).block();
        tangents.add(i, i, block);
        tangents.add(j, j, block);
        tangents.add(i, j, -block);
        tangents.add(j, i, -block);
    }
}

void AxialForces::add_tangent_product(const Points &x, const Points &motion, Points &product) const {
    for (Index e = 0; e < net_.member_count(); ++e) {
        const auto [i, j] = net_.members()[e];
        const Vector3 force =
            tangent(e, x, {.floor = 0, .convex = false}) * (motion.row(i) - motion.row(j)).transpose();
        product.row(i) += force.transpose();
        product.row(j) -= force.transpose();
    }
}

void AxialForces::linearise(const Points &x, Regularisation regularisation,
                            std::vector<MemberTangent> &tangents) const {
    tangents.resize(net_.member_count());
    for (Index e = 0; e < net_.member_count(); ++e)
        tangents[e] = tangent(e, x, regularisation);
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
