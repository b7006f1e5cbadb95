// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"
#include "supports.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace funicular {

class AxialForces;
class Effect;

/// A net with its supports and effects. Checked once, then immutable: what is here can be solved, by several
/// threads at once.
class Scene {
public:
    /// An effect whose weight, pressure or force is zero is left out, as if it had not been given.
    /// \param rest_lengths one for each member [m]; the source lengths if not given
    /// \throws InvalidInput if a part contradicts the net (see the parts), the members have no stiffness or
    /// two, or a
    ///         connected part of the net is not held.
    Scene(std::shared_ptr<const Net> net, std::vector<Support> supports,
          const std::vector<EffectDescription> &effects,
          std::optional<Eigen::VectorXd> rest_lengths = std::nullopt);

    [[nodiscard]] const Net &net() const { return *net_; }
    [[nodiscard]] const std::shared_ptr<const Net> &shared_net() const { return net_; }
    [[nodiscard]] const std::vector<Support> &supports() const { return supports_; }
    [[nodiscard]] const std::vector<EffectDescription> &effects() const { return descriptions_; }
    /// [m]
    [[nodiscard]] const Eigen::VectorXd &rest_lengths() const { return rest_lengths_; }
    /// The same scene with other rest lengths [m].
    [[nodiscard]] Scene with_rest_lengths(Eigen::VectorXd rest_lengths) const {
        return {net_, supports_, descriptions_, std::move(rest_lengths)};
    }
    /// The same scene with no member stiffer than k r = `most` [N], r its rest length.
    [[nodiscard]] Scene with_stiffness_up_to(double most) const;
    /// The same scene with every weight, pressure and force times this factor. A shape in one scene's own
    /// units is the same shape in the other's. \throws InvalidInput for a negative factor, or one that takes
    /// a load beyond what numbers hold
    [[nodiscard]] Scene with_loads_times(double factor) const;

    /// Moves supported nodes to where their supports let them be; in the scene's own units.
    [[nodiscard]] Points on_supports(const Points &local) const;

    // For the solver, in the scene's own units.
    [[nodiscard]] const Scale &scale() const { return scale_; }
    [[nodiscard]] const Freedoms &freedoms() const { return freedoms_; }
    [[nodiscard]] const std::vector<ElasticSupport> &elastic_supports() const { return elastic_supports_; }
    /// What acts, the members' pull first.
    [[nodiscard]] const std::vector<std::shared_ptr<const Effect>> &acting() const { return acting_; }
    [[nodiscard]] const AxialForces &axial() const { return *axial_; }

private:
    std::shared_ptr<const Net> net_;
    std::vector<Support> supports_;
    std::vector<EffectDescription> descriptions_;
    Eigen::VectorXd rest_lengths_;
    Scale scale_;
    Freedoms freedoms_;
    std::vector<ElasticSupport> elastic_supports_;
    std::vector<std::shared_ptr<const Effect>> acting_;
    std::shared_ptr<const AxialForces> axial_;
};

} // namespace funicular
