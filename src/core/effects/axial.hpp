// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "effects/effect.hpp"
#include "net.hpp"
#include "scale.hpp"
#include "scene_parts.hpp"

#include <vector>

namespace funicular {

/// Pull of the members: T_e = k_e (l_e - r_e), and never below zero if compression-only.
///
/// Compression-only members have the convex energy sum ½ k max(0, l - r)²; two-way members do not, as one
/// that pushes buckles sideways.
class AxialForces final : public Effect {
public:
    /// \param rest_lengths one for each member [m]
    /// \throws InvalidInput for a stiffness that is not positive and finite, or of the wrong count, or for a
    /// rest length
    ///         of zero unless stiffness is given per spring.
    AxialForces(const Net &net, const AxialStiffness &description, const Eigen::VectorXd &rest_lengths,
                const Scale &scale);

    [[nodiscard]] std::string_view name() const override { return "axial"; }
    [[nodiscard]] std::size_t bytes() const override {
        return sizeof(*this) +
               sizeof(double) * static_cast<std::size_t>(stiffness_.size() + rest_lengths_.size());
    }
    [[nodiscard]] bool is_load() const override { return false; }
    void add_forces(const Points &x, Points &forces) const override;
    void couple(Coupling &coupling) const override;
    void add_tangent(const Points &x, BlockMatrix &tangent) const override {
        add_tangent(x, {.floor = 0, .convex = false}, tangent);
    }

    void add_tangent_product(const Points &x, const Points &motion, Points &product) const override;

    /// What a small motion of its ends makes of a member's pull: k d dᵀ + (T / l) (I - d dᵀ), kept as
    /// `around` I + `along` d dᵀ.
    struct MemberTangent {
        Vector3 direction;
        double along;
        double around;
        [[nodiscard]] Vector3 operator*(const Vector3 &stretch) const {
            return around * stretch + (along * direction.dot(stretch)) * direction;
        }
        [[nodiscard]] Matrix3 block() const {
            return around * Matrix3::Identity() + along * direction * direction.transpose();
        }
    };
    /// What to add where members give a node no stiffness: as if each were under a small notional pull.
    struct Regularisation {
        /// Least force density T / l of a member's sideways stiffness.
        double floor = 0;
        /// Also raise the negative stiffness of members that push, so that the matrix is positive definite.
        bool convex = true;
    };
    void add_tangent(const Points &x, Regularisation regularisation, BlockMatrix &tangent) const;
    [[nodiscard]] MemberTangent tangent(Index member, const Points &x, Regularisation regularisation) const;
    /// The pull of a member on its first end.
    [[nodiscard]] Vector3 pull(Index member, const Points &x) const;
    /// The same, member by member.
    void linearise(const Points &x, Regularisation regularisation,
                   std::vector<MemberTangent> &tangents) const;

    /// T of each member.
    void tensions(const Points &x, Eigen::VectorXd &tensions) const;
    /// k of each member.
    [[nodiscard]] const Eigen::VectorXd &stiffness() const { return stiffness_; }
    /// r of each member.
    [[nodiscard]] const Eigen::VectorXd &rest_lengths() const { return rest_lengths_; }
    [[nodiscard]] bool is_compression_only() const { return compression_only_; }

private:
    [[nodiscard]] bool is_slack(Index member, double length) const {
        return compression_only_ && length < rest_lengths_[member];
    }

    const Net &net_;
    Eigen::VectorXd stiffness_;
    Eigen::VectorXd rest_lengths_;
    bool compression_only_;
};

} // namespace funicular
