// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate.hpp"

#include "certificate_loads.hpp"
#include "errors.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace funicular {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Smaller than this part of the largest member force, a force is rounding.
constexpr double negligible_force = 1e-9;
// What rounding may excuse at a node: so many units in the last place of the largest coordinate, turned into
// forces by all members and supports there, but never more than a part of the mean nodal load. Twice what the
// solver excuses, which rounds in its own way.
constexpr double units_in_last_place = 8;
constexpr double most_excused_residual = 1e-3;
// Supports are where they should be, and reactions balance the loads, to this part of the net's size and of
// the loads, or to the tolerance where that is coarser.
constexpr double small = 1e-6;
// What the members would pull with at this strain is the least measure of forces in a net without loads.
constexpr double least_strain = 1e-6;

struct MemberForces {
    std::vector<double> forces;    ///< N of the built structure
    std::vector<double> stiffness; ///< k
    double mean_at_least_strain = 0;
};

/// Straight from the law.
MemberForces member_forces(const Scene &scene, const Points &nodes) {
    const AxialStiffness *axial = nullptr;
    for (const auto &effect : scene.effects())
        if (const auto *found = std::get_if<AxialStiffness>(&effect))
            axial = found;
    const Net &net = scene.net();
    MemberForces members;
    members.forces.resize(net.member_count());
    members.stiffness.resize(net.member_count());
    for (Index e = 0; e < net.member_count(); ++e) {
        const double given = axial->stiffness[axial->stiffness.size() == 1 ? 0 : e];
        const double rest = scene.rest_lengths()[e];
        const double k = axial->per_spring ? given : given / rest;
        const Vector3 span = (nodes.row(net.members()[e][1]) - nodes.row(net.members()[e][0])).transpose();
        const double stretch = std::hypot(span.x(), span.y(), span.z()) - rest;
        members.forces[e] = axial->compression_only && stretch < 0 ? 0 : -k * stretch;
        members.stiffness[e] = k;
        members.mean_at_least_strain += least_strain * k * rest / net.member_count();
    }
    return members;
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
    [[nodiscard]] std::size_t count() const { return directions_.size(); }
    [[nodiscard]] Vector3 held_part(const Vector3 &vector) const {
        // The whole of it, without what rounding leaves of a sum over directions.
        if (directions_.size() == 3)
            return vector;
        Vector3 part = Vector3::Zero();
        for (const Vector3 &direction : directions_)
            part += direction.dot(vector) * direction;
        return part;
    }

private:
    void hold(Vector3 direction) {
        // The first support wins: a direction that is no farther than this (the sine of an angle) from those
        // held before is one of them, here as in the scene.
        for (const Vector3 &held : directions_)
            direction -= held.dot(direction) * held;
        if (directions_.size() < 3 && direction.norm() > 1.4142e-4)
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

    const auto members = member_forces(scene, centred_nodes);
    const auto &forces = members.forces;
    const double unit_in_last_place =
        std::numeric_limits<double>::epsilon() * centred_nodes.cwiseAbs().maxCoeff();
    double largest = 0;
    for (const double force : forces)
        largest = std::max(largest, std::abs(force));
    for (Index e = 0; e < net.member_count(); ++e) {
        const double negligible = std::max(negligible_force * largest,
                                           units_in_last_place * unit_in_last_place * members.stiffness[e]);
        if (forces[e] > negligible) {
            certificate.tension_members.push_back(e);
            certificate.worst_tension = std::max(certificate.worst_tension, forces[e]);
        } else if (forces[e] >= -negligible) {
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
    // A unit in the last place of a position, turned into a force by all that is fastened there.
    Eigen::VectorXd rounding = Eigen::VectorXd::Zero(n);
    for (Index e = 0; e < net.member_count(); ++e)
        for (const Index end : net.members()[e])
            rounding[end] += units_in_last_place * unit_in_last_place * members.stiffness[e];
    std::vector<HeldDirections> held(n);
    Points recomputed = Points::Zero(n, 3);
    const auto motion_of = [&](Index node) -> Vector3 {
        return (centred_nodes.row(node) - (net.nodes().row(node) - net.centre().transpose())).transpose();
    };
    for (const Support &support : scene.supports())
        for (const Index node : support.nodes) {
            if (std::isinf(support.stiffness)) {
                held[node].hold(support);
            } else if (is_elastic(support)) {
                const Vector3 reaction = elastic_reaction(support, motion_of(node));
                // Three times, as it may act along three axes.
                rounding[node] += 3 * units_in_last_place * unit_in_last_place * support.stiffness;
                recomputed.row(node) += reaction.transpose();
                unbalanced.row(node) += reaction.transpose();
            }
        }
    double load_sum = 0;
    double movable_load = 0;
    Index movable = 0;
    for (Index i = 0; i < n; ++i) {
        load_sum += loads.row(i).norm();
        if (held[i].count() < 3) {
            movable_load += loads.row(i).norm();
            ++movable;
        }
    }
    double force_sum = 0;
    for (const double force : forces)
        force_sum += std::abs(force);
    const double unit = movable_load > 0
                            ? movable_load / movable
                            : std::max({force_sum / net.member_count(), members.mean_at_least_strain,
                                        rounding.maxCoeff() / most_excused_residual});

    for (Index i = 0; i < n; ++i) {
        const Vector3 rest = unbalanced.row(i).transpose();
        const Vector3 taken = held[i].held_part(rest);
        recomputed.row(i) -= taken.transpose();
        const double force = (rest - taken).norm();
        if (force == 0)
            continue;
        // Written so that what is not a number counts as the worst.
        const double relative = force <= std::numeric_limits<double>::max() ? force / unit : infinite;
        certificate.max_residual = std::max(certificate.max_residual, relative);
        if (!(relative - std::min(rounding[i] / unit, most_excused_residual) <= tolerance))
            certificate.unexcused_residual = std::max(certificate.unexcused_residual, relative);
    }
    for (Index i = 0; i < n; ++i)
        certificate.support_error =
            std::max(certificate.support_error, held[i].held_part(motion_of(i)).norm());

    const Points &given = reactions != nullptr ? *reactions : recomputed;
    Vector3 moment = Vector3::Zero();
    for (Index i = 0; i < n; ++i) {
        certificate.total_load += loads.row(i).transpose();
        certificate.reaction_sum += given.row(i).transpose();
        const Vector3 both = (loads.row(i) + given.row(i)).transpose();
        moment += Vector3(centred_nodes.row(i).transpose()).cross(both);
    }
    // Residuals within the tolerance at every node that can move may add up to `unit` times it at each.
    const double all = std::max(load_sum > 0 ? load_sum : force_sum, unit * static_cast<double>(movable));
    certificate.most_imbalance = std::max(small, tolerance);
    if (all > 0) {
        const double extent = std::max(net.size(), centred_nodes.rowwise().norm().maxCoeff());
        certificate.balance = (certificate.total_load + certificate.reaction_sum).norm() / all;
        certificate.moment_balance = moment.norm() / extent / all;
        // What is excused at the nodes is excused in their sum.
        certificate.most_imbalance += std::min(rounding.sum() / all, most_excused_residual);
    }
    certificate.in_equilibrium = certificate.unexcused_residual == 0 &&
                                 certificate.support_error <= small * net.size() &&
                                 certificate.balance <= certificate.most_imbalance &&
                                 certificate.moment_balance <= certificate.most_imbalance;
    const bool something_carries = std::cmp_less(certificate.slack_members.size(), net.member_count());
    certificate.compression_only =
        certificate.in_equilibrium && certificate.tension_members.empty() && something_carries;
    return certificate;
}

std::string Certificate::summary() const {
    if (!in_equilibrium && unexcused_residual > 0)
        return "Not in equilibrium: the largest residual is " + to_text(unexcused_residual) +
               " of the mean nodal load, where " + to_text(tolerance) + " was asked for.";
    if (!in_equilibrium && std::max(balance, moment_balance) > most_imbalance)
        return "Not in equilibrium: reactions and loads differ by " +
               to_text(std::max(balance, moment_balance)) + " of the loads.";
    if (!in_equilibrium)
        return "Not this scene's equilibrium: a supported node is " + to_text(support_error) +
               " m off its support.";
    std::string text;
    const std::size_t tied = tension_members.size();
    if (compression_only)
        text = "Compression only";
    else if (tied == 0)
        return "Nothing carries: no member is under load.";
    else
        text = std::to_string(tied) +
               (tied == 1 ? " member is in tension, of " : " members are in tension, the worst ") +
               to_text(worst_tension) + " N";
    if (!slack_members.empty())
        text +=
            "; " + std::to_string(slack_members.size()) +
            (slack_members.size() == 1 ? " member is slack and carries" : " members are slack and carry") +
            " nothing";
    return text + ". The largest residual is " + to_text(max_residual) + " of the mean nodal load.";
}

} // namespace funicular
