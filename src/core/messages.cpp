// SPDX-License-Identifier: LGPL-2.1-or-later
#include "messages.hpp"

#include "stability.hpp"
#include "text.hpp"

namespace funicular {

std::string steps_text(long most_steps) {
    return "the limit of " + std::to_string(most_steps) + " iterations";
}

std::string seconds_text(double most_seconds) {
    return "the limit of " + to_text(most_seconds) + " seconds";
}

std::string missed_message(const Report &report, double tolerance, double accuracy) {
    return report.residual > tolerance
               ? "The relative residual is " + to_text(report.residual) + ", where " + to_text(tolerance) +
                     " was asked for: this is not an equilibrium."
               : "The residual is small, but nodes may be " + to_text(report.position_error) +
                     " m from equilibrium, where " + to_text(accuracy) + " m was asked for.";
}

std::string rounding_message(const Report &report) {
    return "Members or supports are so stiff for their load that rounding makes a relative residual of " +
           to_text(report.residual) + ": their forces cannot be told. Lower the stiffness.";
}

std::string unstable_message(const std::string &limit) {
    return "Stopped at " + limit +
           ". It has found an unstable equilibrium, in which two-way members hold loads up as struts or "
           "would "
           "buckle. Start from a shape on the other side, or take compression-only members.";
}

std::string equilibrium_message(const Points &x, const Equilibrium &equilibrium, const Report &report,
                                double tolerance, bool is_unstable) {
    std::string text = "In equilibrium";
    if (report.residual > tolerance)
        text += " as far as rounding lets one tell: members or supports are too stiff for a residual below " +
                to_text(report.residual);
    text += ".";
    if (is_unstable)
        text += " It is an unstable one: " + std::to_string(count_pushing(x, equilibrium)) +
                " two-way members hold it as struts (tension members of the built structure), and a "
                "disturbance would take it elsewhere. Compression-only members have no such state.";
    if (const Index loose = count_loose_nodes(x, equilibrium); loose > 0)
        text += " At " + std::to_string(loose) + (loose == 1 ? " node" : " nodes") +
                " every member is slack: nothing holds " + (loose == 1 ? "it" : "them") + " in place.";
    return text;
}

} // namespace funicular
