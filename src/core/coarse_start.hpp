// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "lattice_levels.hpp"
#include "method.hpp"
#include "newton.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace funicular {

/// Newton's method on a lattice, from coarse to fine (nested iteration): the net of the fewest lines is
/// solved from the start shape, and every finer one from the shape that was found before. Large motions are
/// made where they cost nothing; the scene's own net needs a few steps only.
class CoarseToFine final : public Iteration {
public:
    /// \param levels coarser nets of the scene's
    CoarseToFine(const Equilibrium &equilibrium, CoarserLevels levels);

    /// Infinite before the scene's own net is reached.
    [[nodiscard]] double position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) override;
    /// Moves a coarser net until all have come to rest, and the scene's own from there.
    Move move(Points &x, Equilibrium &equilibrium) override;
    [[nodiscard]] bool restart() override {
        has_begun_anew_ = false;
        return level_ == 0 && newton_->restart();
    }
    [[nodiscard]] bool has_begun_anew() const override { return has_begun_anew_; }

private:
    /// A coarser net on its way to equilibrium.
    struct Stage {
        Stage(std::shared_ptr<const Scene> scene, const Points &metres, CoarserLevels levels);
        Equilibrium equilibrium;
        Newton newton;
        Points x;
        int steps = 0;
    };
    enum class Progress { under_way, at_rest, lost };
    void enter_stage(const Points &metres);
    static Progress advance(Stage &stage);
    [[nodiscard]] Points metres_on_level(std::size_t level, const Points &fine) const;

    CoarserLevels levels_;
    /// Scene of each level.
    std::vector<std::shared_ptr<const Scene>> scenes_;
    /// Coarser nets that are still to be solved.
    std::size_t level_ = 0;
    std::unique_ptr<Stage> stage_;
    std::optional<Newton> newton_;
    /// To go back to if what coarser nets led to comes to nothing.
    Points start_;
    int steps_ = 0;
    bool has_begun_anew_ = false;
};

} // namespace funicular
