// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "equilibrium.hpp"
#include "lattice_levels.hpp"
#include "method.hpp"

#include <limits>
#include <memory>
#include <string>

namespace funicular {

/// A net on its way to this many times its size has no equilibrium that anyone would build.
inline constexpr double runaway_growth = 1e5;
/// On a large net each step of the way costs as much as a solve of a small one.
inline constexpr double runaway_growth_of_large_net = 100;
[[nodiscard]] double runaway_growth_of(const Scene &scene);
/// The figure that is named for what a net can carry is what it carries without growing to more than this
/// many times its size. Near the limit of existence nets grow exponentially with their loads: where that ends
/// would be a matter of patience and rounding, and of use to nobody.
inline constexpr double most_growth = 10;

/// Looks for the largest part of its loads that a scene can carry, once it has turned out not to carry them
/// all.
///
/// Weights grow with the shape that they stretch, so that from some weight on there is no equilibrium. The
/// figure is the largest part of the loads, to two per cent of it, under which there is an equilibrium and
/// the net is no more than `most_growth` times its size. Size is the diagonal of the net's box, compared with
/// that of the source net, or of one enlarged to its rest lengths where these are longer.
///
/// Newton's method is tried at smaller and smaller parts from the source net until one is carried, then
/// between what is carried and what is not, each time from the shapes found nearest to it: near the limit
/// that is the only start from which the equilibrium is reached. The last thing tried is the whole, where it
/// is not far: it may be carried by a net that has grown more.
///
/// It may be left and entered again between Newton steps, of which there are at most `most_steps`.
class LoadLimitSearch {
public:
    static constexpr int most_steps = 300;

    /// \param start shape of the source net on its supports, in the scene's own units
    /// \param levels coarser nets of the scene's, if there are any
    LoadLimitSearch(std::shared_ptr<const Scene> scene, Points start, CoarserLevels levels = {});

    /// Makes a Newton step. Returns whether the search has ended.
    bool step();
    [[nodiscard]] bool has_ended() const { return has_ended_; }

    /// The largest part of the loads for which an equilibrium of that size was found; zero if there was none.
    /// One if the whole has an equilibrium after all, of whatever size.
    [[nodiscard]] double carried() const { return carried_.part; }
    /// The equilibrium under that part, in the scene's own units.
    [[nodiscard]] const Points &shape() const { return shape_; }

    /// Why there is no equilibrium, and what there would be one for, in the units of the scene's description.
    [[nodiscard]] std::string message() const;

private:
    /// A part of the loads, and how many times its size the net has under it; infinite if unknown.
    struct Trial {
        double part, growth;
    };

    void try_part(double part);
    void try_next();
    void end_trial(bool is_at_rest);
    void carry(const Trial &trial);
    /// From two equilibria, linear in ln (part).
    [[nodiscard]] Points start_for(double part) const;
    [[nodiscard]] double part_between() const;
    [[nodiscard]] double growth_of(const Points &x) const;

    std::shared_ptr<const Scene> scene_;
    CoarserLevels levels_;
    Points start_, shape_;
    double size_;           ///< box diagonal that growth is told by, in the scene's own units
    double other_part_ = 0; ///< of the loads, under which there is an equilibrium too
    Points other_shape_;
    Trial carried_{0, 1};
    Trial refused_{1, std::numeric_limits<double>::infinity()};
    double refused_from_ = 0; ///< part carried by the shape from which `refused_` was tried last
    double descent_;          ///< from a part refused to the next below that is tried
    double stride_;           ///< from a part carried to the next above that is tried
    bool has_found_ = false, has_ended_ = false;
    int steps_ = 0;

    // The present trial.
    double part_ = 0;
    Points x_;
    std::unique_ptr<Equilibrium> equilibrium_;
    std::unique_ptr<Iteration> iteration_;
    int steps_of_trial_ = 0;
};

} // namespace funicular
