// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene.hpp"
#include "types.hpp"

#include <string>
#include <vector>

namespace funicular {

/// What an independent recomputation says of a shape. SI units, in the sense of the built structure.
///
/// Recomputed from the net's nodes, the parts of the scene as they were described, and this file's own
/// formulas; it includes nothing of the solver. It is not a proof that the structure is safe: members are
/// straight bars on pin joints here.
struct Certificate {
    /// In equilibrium, no member in tension, and some in compression.
    bool compression_only = false;
    /// The residual is within the tolerance at every node, on top of what rounding lets one tell there;
    /// supported nodes are on their supports, and the reactions balance the loads.
    bool in_equilibrium = false;
    std::vector<Index> tension_members;
    /// Largest tension [N]; zero if there is none.
    double worst_tension = 0;
    /// Members that carry nothing; without weight of their own, they can be left out.
    std::vector<Index> slack_members;
    /// max |r_i| / mean load on the nodes that can move; infinite where a force is not a number. Where those
    /// bear no load, the mean force of the members stands for it, or what they would pull with at a strain of
    /// 1e-6 or can be told from rounding, if that is more.
    double max_residual = 0;
    /// The same of the nodes where it is beyond the tolerance and rounding; zero if there are none.
    double unexcused_residual = 0;
    /// Largest distance of a node from where its rigid supports hold it [m].
    double support_error = 0;
    double tolerance = 0;
    /// |sum of reactions + sum of loads| / sum of |loads|; without loads, of the members' |forces|
    double balance = 0;
    /// The same of their moments about the net's centre, over the farthest node's distance from there (the
    /// net's size, if that is more).
    double moment_balance = 0;
    /// The most of these two that counts as balanced.
    double most_imbalance = 0;
    Vector3 total_load = Vector3::Zero();   ///< [N]
    Vector3 reaction_sum = Vector3::Zero(); ///< [N]

    /// One sentence for a person.
    [[nodiscard]] std::string summary() const;
};

/// Certifies a shape, given relative to the net's centre [m], with the reactions [N] that go with it; they
/// are recomputed if null. Up to `tolerance` a relative residual counts as equilibrium.
///
/// \throws InvalidInput if the shape does not fit the scene's net
[[nodiscard]] Certificate certify(const Scene &scene, const Points &centred_nodes, const Points *reactions,
                                  double tolerance);

} // namespace funicular
