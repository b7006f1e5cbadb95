// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// What a scene is put together from: plain descriptions in SI units, in the sense of the built structure.
#pragma once

#include "types.hpp"

#include <limits>
#include <variant>
#include <vector>

namespace funicular {

enum class SupportKind { fixed, on_line, on_plane };

/// Takes away motion of nodes from where they are in the source net (paper section 5.2).
struct Support {
    SupportKind kind = SupportKind::fixed;
    std::vector<Index> nodes;
    /// Direction of the line, or normal of the plane; unused by a fixed point. Need not be of unit length.
    Vector3 direction = Vector3::UnitZ();
    /// Infinite: rigid. Finite: a spring [N/m] against the motion that is taken away, which weakens the
    /// support.
    double stiffness = std::numeric_limits<double>::infinity();

    bool operator==(const Support &) const = default;
};

/// Members are springs (paper section 2): T = k (l - r).
struct AxialStiffness {
    /// EA [N], so that k = EA / r and refining a net does not soften it; or k itself [N/m] if `per_spring`
    /// (the paper's constant). One value for all members, or one each.
    Eigen::VectorXd stiffness;
    /// A member that would be pulled in the built structure carries nothing: T = max(0, k (l - r)).
    bool compression_only = true;
    bool per_spring = false;
};

/// wL [kg/m]: each end of a member carries half of the weight of its present length (paper section 3.3).
struct MemberWeight {
    double per_length = 0;
    /// How many members each one stands for; one if not given.
    Eigen::VectorXd lines = {};
};

/// How a panel's weight is shared among its corners.
enum class CornerShare {
    angle,  ///< in proportion to the interior angles (paper section 4.1)
    equal,  ///< the same to each
    voronoi ///< the part of the panel that is nearest to the corner
};

/// wA [kg/m²]: weight of the panels' present area (paper section 4.1). The area of a panel that is not plane
/// is that of the triangles between its edges and the mean of its corners.
struct CoveringWeight {
    double per_area = 0;
    CornerShare share = CornerShare::angle;
};

/// A force [N] on each of some nodes, as the built structure sees it: down is negative z.
struct PointLoad {
    std::vector<Index> nodes;
    Vector3 force = Vector3::Zero();
};

/// A load [N/m²] on the panels' area in plan.
struct Snow {
    double pressure = 0;
};

using EffectDescription = std::variant<AxialStiffness, MemberWeight, CoveringWeight, PointLoad, Snow>;

} // namespace funicular
