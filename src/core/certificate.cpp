// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate.hpp"

#include "certificate_loads.hpp"
#include "errors.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace funicular {

namespace {

// Smaller than this part of the largest member force, a force is rounding.
constexpr double negligible_force = 1e-9;

/// N of each member in the built structure, straight from the law.
std::vector<double> member_forces(const Scene &scene, const Points &nodes, double &stiffest) {
    const AxialStiffness *axial = nullptr;
    for (const auto &effect : scene.effects())
        if (const auto *found = std::get_if<AxialStiffness>(&effect))
            axial = found;
    const Net &net = scene.net();
    std::vector<double> forces(net.member_count());
    for (Index e = 0; e < net.member_count(); ++e) {
        const double given = axial->stiffness[axial->stiffness.size() == 1 ? 0 : e];
        const double rest = scene.rest_lengths()[e];
        const double k = axial->per_spring ? given : given / rest;
        const Vector3 span = (nodes.row(net.members()[e][1]) - nodes.row(net.members()[e][0])).transpose();
        const double stretch = std::hypot(span.x(), span.y(), span.z()) - rest;
        forces[e] = axial->compression_only && stretch < 0 ? 0 : -k * stretch;
        stiffest = std::max(stiffest, k);
    }
    return forces;
}

/// An orthonormal set of the directions that a node's rigid supports hold, grown one direction at a time.
class HeldDirections {
public:
    void hold(const Support &support) {
        const Vector3 along = support.direction / support.direction.stableNorm();
        if (support.kind == SupportKind::on_plane)
            return hold(along);
        for (int axis = 0; axis < 3; ++axis) {
            Vector3 direction = Vector3::Unit(axis);
            if (support.kind == SupportKind::on_line)
                direction -= along * along[axis];
            hold(direction);
        }
    }
    [[nodiscard]] Vector3 held_part(const Vector3 &vector) const {
        Vector3 part = Vector3::Zero();
        for (const Vector3 &direction : directions_)
            part += direction.dot(vector) * direction;
        return part;
    }

private:
    void hold(Vector3 direction) {
        // Planes that meet at less than about 1e-4 rad count as one.
        for (const Vector3 &held : directions_)
            direction -= held.dot(direction) * held;
        if (directions_.size() < 3 && direction.norm() > 1e-4)
            directions_.push_back(direction.normalized());
    }
    std::vector<Vector3> directions_;
};

/// Force of a support that yields on the built structure.
Vector3 elastic_reaction(const Support &support, const Vector3 &motion) {
    const Vector3 along = support.direction / support.direction.stableNorm();
    switch (support.kind) {
    case SupportKind::on_plane:
        return support.stiffness * along.dot(motion) * along;
    case SupportKind::on_line:
        return support.stiffness * (motion - along.dot(motion) * along);
    case SupportKind::fixed:
        break;
    }
    return support.stiffness * motion;
}

bool is_elastic(const Support &support) {
    return std::isfinite(support.stiffness) && support.stiffness > 0;
}

} // namespace

Certificate certify(const Scene &scene, const Points &centred_nodes, const Points *reactions,
                    double tolerance) {
    const Net &net = scene.net();
    const Index n = net.node_count();
    if (centred_nodes.rows() != n)
        throw InvalidInput("result has " + std::to_string(centred_nodes.rows()) +
                           " nodes, but the scene's net has " + std::to_string(n));
    Certificate certificate;
    certificate.tolerance = tolerance;

    double stiffest = 0;
    const auto forces = member_forces(scene, centred_nodes, stiffest);
    double largest = 0;
    for (const double force : forces)
        largest = std::max(largest, std::abs(force));
    for (Index e = 0; e < net.member_count(); ++e) {
        if (forces[e] > negligible_force * largest) {
            certificate.tension_members.push_back(e);
            certificate.worst_tension = std::max(certificate.worst_tension, forces[e]);
        } else if (forces[e] >= -negligible_force * largest) {
            certificate.slack_members.push_back(e);
        }
    }

    // Members push on their ends when in compression; then loads; what is left, supports have to give.
    const Points loads = certificate_loads(net, scene.effects(), centred_nodes);
    Points unbalanced = loads;
    for (Index e = 0; e < net.member_count(); ++e) {
        const auto [i, j] = net.members()[e];
        const Vector3 span = (centred_nodes.row(j) - centred_nodes.row(i)).transpose();
        if (span.isZero(0))
            continue;
        const Vector3 push = forces[e] / span.norm() * span;
        unbalanced.row(i) += push.transpose();
        unbalanced.row(j) -= push.transpose();
    }
    std::vector<HeldDirections> held(n);
    Points recomputed = Points::Zero(n, 3);
    for (const Support &support : scene.supports())
        for (const Index node : support.nodes) {
            if (std::isinf(support.stiffness)) {
                held[node].hold(support);
            } else if (is_elastic(support)) {
                const Vector3 motion =
                    (centred_nodes.row(node) - net.nodes().row(node)).transpose() + net.centre();
                const Vector3 reaction = elastic_reaction(support, motion);
                recomputed.row(node) += reaction.transpose();
                unbalanced.row(node) += reaction.transpose();
            }
        }
    double worst = 0;
    for (Index i = 0; i < n; ++i) {
        const Vector3 rest = unbalanced.row(i).transpose();
        const Vector3 taken = held[i].held_part(rest);
        recomputed.row(i) -= taken.transpose();
        worst = std::max(worst, (rest - taken).norm());
    }

    double load_sum = 0;
    for (Index i = 0; i < n; ++i)
        load_sum += loads.row(i).norm();
    double force_sum = 0;
    for (const double force : forces)
        force_sum += std::abs(force);
    const double unit = load_sum > 0 ? load_sum / n : force_sum / net.member_count();
    certificate.max_residual = worst > 0 ? worst / unit : 0;
    const double reach = centred_nodes.cwiseAbs().maxCoeff();
    const double rounding =
        unit > 0 ? 64 * std::numeric_limits<double>::epsilon() * stiffest * reach / unit : 0;
    certificate.in_equilibrium = certificate.max_residual <= std::max(tolerance, rounding);
    certificate.compression_only = certificate.in_equilibrium && certificate.tension_members.empty();

    const Points &given = reactions != nullptr ? *reactions : recomputed;
    Vector3 moment = Vector3::Zero();
    for (Index i = 0; i < n; ++i) {
        certificate.total_load += loads.row(i).transpose();
        certificate.reaction_sum += given.row(i).transpose();
        const Vector3 both = (loads.row(i) + given.row(i)).transpose();
        moment += Vector3(centred_nodes.row(i).transpose()).cross(both);
    }
    const double all = load_sum > 0 ? load_sum : force_sum;
    if (all > 0) {
        certificate.balance = (certificate.total_load + certificate.reaction_sum).norm() / all;
        certificate.moment_balance = moment.norm() / (all * net.size());
    }
    return certificate;
}

std::string Certificate::summary() const {
    if (!in_equilibrium)
        return "Not in equilibrium: the largest residual is " + to_text(max_residual) +
               " of the mean nodal load, where " + to_text(tolerance) + " was asked for.";
    std::string text;
    if (compression_only)
        text = "Compression only";
    else
        text = std::to_string(tension_members.size()) +
               (tension_members.size() == 1 ? " member is in tension, "
                                            : " members are in tension, the worst ") +
               (tension_members.size() == 1 ? "of " : "") + to_text(worst_tension) + " N";
    if (!slack_members.empty())
        text += "; " + std::to_string(slack_members.size()) +
                (slack_members.size() == 1 ? " member is" : " members are") + " slack and can be left out";
    return text + ".";
}

} // namespace funicular
