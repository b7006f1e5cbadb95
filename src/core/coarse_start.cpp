// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarse_start.hpp"

#include "coarser_scene.hpp"
#include "errors.hpp"

#include <limits>
#include <utility>

namespace funicular {

namespace {

// On fewer nodes a shape says little of the one that is looked for.
constexpr Index least_nodes = 60;
// The error that a coarse net has of itself is larger than what this leaves.
constexpr double residual_of_stage = 1e-2;
constexpr int most_steps_of_stage = 200;
// A shape that was close would have led to rest by then.
constexpr int most_steps_from_coarse_shape = 60;
constexpr double most_growth = 100; // in the scene's own units, in which the net has a size of about one

/// The scene on each level, as far as it can be solved there.
std::vector<std::shared_ptr<const Scene>> coarser_scenes(const Scene &scene, const CoarserLevels &levels) {
    std::vector<std::shared_ptr<const Scene>> scenes;
    auto effects = scene.effects();
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const LatticeLevel &level = levels[k];
        if (level.net->node_count() < least_nodes)
            break;
        effects = effects_on(level, effects);
        try {
            scenes.push_back(
                std::make_shared<const Scene>(level.net, level.supports, effects, level.rest_lengths));
        } catch (const InvalidInput &) {
            break; // what the finer net could bear, such as a number at the end of its range
        }
    }
    return scenes;
}

} // namespace

CoarseToFine::Stage::Stage(std::shared_ptr<const Scene> scene, const Points &metres, CoarserLevels levels)
    : equilibrium(std::move(scene)), newton(equilibrium, std::move(levels)),
      x(equilibrium.scene().on_supports(equilibrium.scene().scale().to_local(metres))) {
    equilibrium.evaluate(x);
}

CoarseToFine::CoarseToFine(const Equilibrium &equilibrium, CoarserLevels levels)
    : levels_(std::move(levels)), scenes_(coarser_scenes(equilibrium.scene(), levels_)),
      level_(scenes_.size()), newton_(std::in_place, equilibrium, levels_) {}

Points CoarseToFine::metres_on_level(std::size_t level, const Points &fine) const {
    Points nodes = fine;
    for (std::size_t k = 0; k <= level; ++k) {
        const auto &kept = levels_[k].coarsening.fine_nodes();
        Points coarse(static_cast<Eigen::Index>(kept.size()), 3);
        for (std::size_t node = 0; node < kept.size(); ++node)
            coarse.row(static_cast<Eigen::Index>(node)) = nodes.row(kept[node]);
        nodes = std::move(coarse);
    }
    return nodes;
}

double CoarseToFine::position_error(const Points &x, Equilibrium &equilibrium, const Goal &goal) {
    if (level_ == 0)
        return newton_->position_error(x, equilibrium, goal);
    return std::numeric_limits<double>::infinity();
}

CoarseToFine::Progress CoarseToFine::advance(Stage &stage) {
    if (stage.equilibrium.relative_residual() <= residual_of_stage)
        return Progress::at_rest;
    if (++stage.steps > most_steps_of_stage || !(stage.x.cwiseAbs().maxCoeff() < most_growth))
        return Progress::lost;
    (void)stage.newton.position_error(stage.x, stage.equilibrium, {.tolerance = residual_of_stage});
    return stage.newton.move(stage.x, stage.equilibrium) == Move::made ? Progress::under_way : Progress::lost;
}

void CoarseToFine::enter_stage(const Points &metres) {
    stage_ = std::make_unique<Stage>(scenes_[level_ - 1], metres, levels_.below(level_ - 1));
}

Iteration::Move CoarseToFine::move(Points &x, Equilibrium &equilibrium) {
    if (level_ == 0) {
        if (++steps_ == most_steps_from_coarse_shape && start_.size() > 0) {
            x = start_;
            equilibrium.evaluate(x);
            newton_.emplace(equilibrium);
            has_begun_anew_ = true;
            return Move::made;
        }
        return newton_->move(x, equilibrium);
    }
    if (start_.size() == 0)
        start_ = x;
    const Scale &scale = equilibrium.scene().scale();
    if (!stage_)
        enter_stage(metres_on_level(level_ - 1, scale.to_metres(x)));
    const Progress progress = advance(*stage_);
    if (progress == Progress::under_way)
        return Move::made;
    equilibrium.add_costs(stage_->equilibrium.costs());
    if (progress == Progress::lost) {
        // The scene's own net may still have an equilibrium, and says why if it has none.
        level_ = 0;
        has_begun_anew_ = true;
        stage_.reset();
        return Move::made;
    }
    Points metres = stage_->equilibrium.scene().scale().to_metres(stage_->x);
    Points finer;
    levels_[--level_].coarsening.interpolate(metres, finer);
    if (level_ > 0) {
        enter_stage(finer);
    } else {
        stage_.reset();
        x = equilibrium.scene().on_supports(scale.to_local(finer));
        equilibrium.evaluate(x);
    }
    return Move::made;
}

} // namespace funicular
