// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"
#include "newton.hpp"

#include <memory>
#include <string>
#include <vector>

namespace funicular {

/// A net that has grown to this many times its size has no equilibrium that anyone would build. Where it ends
/// is part of what the limit means: a long strand under weights that grow with it grows exponentially with
/// them, and would come to rest far beyond.
inline constexpr double runaway_growth = 1e5;

/// Looks for the largest part of its loads that a scene can carry, once it has turned out not to carry them
/// all.
///
/// Weights grow with the shape that they stretch, so that from some weight on there is no equilibrium.
/// Newton's method is tried at a part of the loads, first from the source net and with smaller and smaller
/// parts until one is carried, then between what is carried and what is not, each time from the shape of the
/// largest part carried yet: near the limit that is the only start from which the equilibrium is reached. The
/// last thing tried is the smallest part refused, from close below it, so that a refusal for want of a good
/// start does not stand. If what ends there is not the equilibrium but a moderate growth of the net, the
/// limit is told from how that grows: the last decades before the runaway are costly, and of use to nobody.
///
/// It may be left and entered again between Newton steps, of which there are at most `most_steps`.
class LoadLimitSearch {
public:
    static constexpr int most_steps = 500;
    /// Of a net of a thousand nodes and more.
    static constexpr int most_steps_of_large_net = 200;

    /// \param start shape of the source net on its supports, in the scene's own units
    LoadLimitSearch(std::shared_ptr<const Scene> scene, Points start);

    /// Makes a Newton step. Returns whether the search has ended.
    bool step();
    [[nodiscard]] bool has_ended() const { return has_ended_; }

    /// The largest part of the loads for which an equilibrium was found; zero if there was none. One if the
    /// whole is carried after all.
    [[nodiscard]] double carried() const { return carried_; }
    /// The part of the loads under which the net runs away, to a few per cent, and never below `carried`. Of
    /// a net of more than 1000 nodes that has grown thirtyfold it is what is carried there.
    [[nodiscard]] double limit() const;
    /// The equilibrium under that part, in the scene's own units.
    [[nodiscard]] const Points &shape() const { return shape_; }

    /// Why there is no equilibrium, and what there would be one for, in the units of the scene's description.
    [[nodiscard]] std::string message() const;

private:
    /// A part of the loads, and ln (diagonal of the net's box) under it.
    struct Growth {
        double part, log_size;
    };

    void try_part(double part);
    [[nodiscard]] double growth() const;
    [[nodiscard]] double log_size(const Points &x) const;
    void end_trial(bool is_carried);

    std::shared_ptr<const Scene> scene_;
    Points start_, shape_;
    double extent_;
    double carried_ = 0;
    double refused_ = 1;
    double refused_from_ = 0; ///< part carried by the shape from which `refused_` was tried last
    double stride_;           ///< from a part carried to the next above that is tried
    bool has_ended_ = false;
    std::vector<Growth> growths_; ///< of every part carried, rising
    int steps_ = 0;

    // The present trial.
    double part_ = 0;
    Points x_;
    std::unique_ptr<Equilibrium> equilibrium_;
    std::unique_ptr<Newton> newton_;
    int steps_of_trial_ = 0;
};

} // namespace funicular
