// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "existence.hpp"
#include "lattice_levels.hpp"
#include "method.hpp"
#include "result.hpp"
#include "stability.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace funicular {

struct SolveOptions {
    double accuracy = 1e-3;  ///< largest position error [m]
    double tolerance = 1e-6; ///< largest relative residual
    Method method = Method::automatic;
    double max_seconds = std::numeric_limits<double>::infinity();
    /// Not given: 1000 Newton steps, 10 million of relaxation.
    std::optional<long> max_iterations;
    /// Shape to begin with [m], brought onto the supports; the source net if not given.
    std::optional<Points> start;
    /// Told of every Newton step, and of the relaxation every 10 ms; returning false cancels.
    std::function<bool(const Report &)> on_progress;
};

/// The one loop of form finding, which can be left and entered again between iterations.
class Solver {
public:
    /// \throws InvalidInput for an accuracy, tolerance, limit or start that cannot be meant.
    Solver(std::shared_ptr<const Scene> scene, SolveOptions options = {});

    /// Goes on for this time, give or take an iteration, and for one iteration at least. Other threads that
    /// advance, replace or ask for the result wait for it.
    /// \returns whether the solve has ended
    bool advance(double max_seconds = std::numeric_limits<double>::infinity());
    /// Goes on from the present shape with another scene, which must have as many nodes; from that scene's
    /// net where the present shape has run away.
    ///
    /// \throws InvalidInput for another number of nodes
    void replace(std::shared_ptr<const Scene> scene);
    /// The latest shape [m]. May be asked from another thread at any time, and does not wait.
    [[nodiscard]] Points nodes() const;
    [[nodiscard]] Result result() const;

private:
    void begin(const Points &local_start, bool is_cold);
    void rest_without_loads();
    void use(Method method);
    void publish();
    bool told(const Report &report);
    [[nodiscard]] std::string limit_message(const std::string &limit, const std::string &advice) const;
    [[nodiscard]] bool has_run_away() const;
    [[nodiscard]] bool has_moved_as_a_whole() const;
    bool end_or_look_for_limit();
    bool look_for_limit();
    bool end_converged();
    bool end(Status status, std::string message);
    bool measure();
    bool has_stalled();
    bool end_if_decided();
    bool make_move();
    [[nodiscard]] long iteration_limit() const;
    [[nodiscard]] double seconds() const;

    std::shared_ptr<const Scene> scene_;
    SolveOptions options_;
    Goal goal_;
    /// For the fast way of solving on a lattice.
    CoarserLevels levels_;
    std::unique_ptr<Equilibrium> equilibrium_;
    std::unique_ptr<Iteration> iteration_;
    Method method_ = Method::newton;
    bool has_path_ = false; ///< whether the scene is solved along an interior-point path
    Points start_, x_;
    double extent_ = 0; ///< of the start shape, in the scene's own units
    Report report_;
    Report halved_; ///< when the relaxation that follows Newton's method last halved the residual
    std::unique_ptr<LoadLimitSearch> load_limit_; ///< once the net has run away
    std::optional<Instability> instability_;      ///< of the present shape, if it is an equilibrium
    int departures_ = 0;                          ///< from equilibria in the wrong sign
    bool is_measured_ = false;
    std::optional<Status> status_;
    std::string message_;
    double seconds_before_ = 0;
    std::optional<double> entered_;
    double last_told_ = -std::numeric_limits<double>::infinity();
    std::vector<Report> history_;
    long history_stride_ = 1;

    /// Held while an iteration runs or the solver is changed; whoever only looks at `published_` need not
    /// wait for it.
    mutable std::mutex working_;
    mutable std::mutex published_guard_;
    Points published_;
};

/// Solves a scene: the form in which it stands in equilibrium.
[[nodiscard]] Result solve(std::shared_ptr<const Scene> scene, SolveOptions options = {});

} // namespace funicular
