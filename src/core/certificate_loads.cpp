// SPDX-License-Identifier: LGPL-2.1-or-later
#include "certificate_loads.hpp"

#include <cmath>

namespace funicular {

namespace {

using Vector2 = Eigen::Vector2d;

std::vector<Vector3> corners_of(const Net &net, Index panel, const Points &nodes) {
    std::vector<Vector3> corners;
    for (const Index node : net.panels()[panel])
        corners.emplace_back(nodes.row(node).transpose());
    return corners;
}

Vector3 mean(const std::vector<Vector3> &points) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3 &point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

/// Area of a triangle, its base times its height. From its three sides (Heron's formula) a flat one's would
/// have half of the digits only.
double triangle_area(const Vector3 &p, const Vector3 &q, const Vector3 &r) {
    const Vector3 base = q - p;
    const double length = base.stableNorm();
    if (length == 0)
        return 0;
    const Vector3 along = base / length;
    const Vector3 side = r - p;
    return length * (side - along.dot(side) * along).norm() / 2;
}

double fan_area(const std::vector<Vector3> &corners) {
    const Vector3 middle = mean(corners);
    double area = 0;
    for (std::size_t k = 0; k < corners.size(); ++k)
        area += triangle_area(middle, corners[k], corners[(k + 1) % corners.size()]);
    return area;
}

/// Twice the area vector by the shoelace sum.
Vector3 area_vector(const std::vector<Vector3> &corners) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
    return sum;
}

std::vector<double> angle_shares(const std::vector<Vector3> &corners) {
    const std::size_t count = corners.size();
    std::vector<double> shares(count);
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const Vector3 out = corners[(k + 1) % count] - corners[k];
        const Vector3 back = corners[(k + count - 1) % count] - corners[k];
        // Kahan's angle between vectors, good for small and for flat ones.
        const Vector3 a = out * back.norm();
        const Vector3 b = back * out.norm();
        shares[k] = 2 * std::atan2((a - b).norm(), (a + b).norm());
        sum += shares[k];
    }
    for (double &share : shares)
        share = sum > 0 ? share / sum : 1.0 / static_cast<double>(count);
    return shares;
}

/// Part of a plane polygon where `normal`·p <= `limit`.
std::vector<Vector2> half_plane_part(const std::vector<Vector2> &polygon, const Vector2 &normal,
                                     double limit) {
    std::vector<Vector2> part;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector2 &from = polygon[k];
        const Vector2 &to = polygon[(k + 1) % polygon.size()];
        const double height_from = normal.dot(from) - limit;
        const double height_to = normal.dot(to) - limit;
        if (height_from <= 0)
            part.push_back(from);
        if ((height_from < 0 && height_to > 0) || (height_from > 0 && height_to < 0))
            part.emplace_back((height_to * from - height_from * to) / (height_to - height_from));
    }
    return part;
}

double plane_area(const std::vector<Vector2> &polygon) {
    double doubled = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector2 &p = polygon[k];
        const Vector2 &q = polygon[(k + 1) % polygon.size()];
        doubled += p.x() * q.y() - p.y() * q.x();
    }
    return std::abs(doubled) / 2;
}

/// Area nearest to each corner, each triangle of the fan laid out flat in a frame of its own.
std::vector<double> nearest_areas(const std::vector<Vector3> &corners) {
    const std::size_t count = corners.size();
    const Vector3 middle = mean(corners);
    std::vector<double> areas(count, 0.0);
    for (std::size_t edge = 0; edge < count; ++edge) {
        const Vector3 from = corners[edge] - middle;
        const Vector3 to = corners[(edge + 1) % count] - middle;
        const Vector3 normal = from.cross(to);
        if (normal.norm() == 0)
            continue;
        const Vector3 first = from.normalized();
        const Vector3 second = normal.cross(from).normalized();
        const std::vector<Vector2> triangle{
            Vector2::Zero(), {first.dot(from), second.dot(from)}, {first.dot(to), second.dot(to)}};
        for (std::size_t own = 0; own < count; ++own) {
            std::vector<Vector2> cell = triangle;
            for (std::size_t other = 0; other < count; ++other) {
                // |p - own|² <= |p - other|²  <=>  2 p·(other - own) <= |other|² - |own|²
                const Vector3 a = corners[own] - middle;
                const Vector3 b = corners[other] - middle;
                if (other != own)
                    cell = half_plane_part(cell, {2 * first.dot(b - a), 2 * second.dot(b - a)},
                                           b.squaredNorm() - a.squaredNorm());
            }
            areas[own] += plane_area(cell);
        }
    }
    return areas;
}

void add(const AxialStiffness & /*effect*/, const Net & /*net*/, const Points & /*nodes*/,
         Points & /*loads*/) {}

void add(const MemberWeight &effect, const Net &net, const Points &nodes, Points &loads) {
    for (Index e = 0; e < net.member_count(); ++e) {
        const auto [i, j] = net.members()[e];
        const Vector3 span = (nodes.row(j) - nodes.row(i)).transpose();
        const double lines = effect.lines.size() == 0 ? 1 : effect.lines[e];
        const double weight =
            lines * effect.per_length * standard_gravity * std::hypot(span.x(), span.y(), span.z());
        loads(i, 2) -= weight / 2;
        loads(j, 2) -= weight / 2;
    }
}

void add(const CoveringWeight &effect, const Net &net, const Points &nodes, Points &loads) {
    for (Index f = 0; f < net.panels().size(); ++f) {
        const auto corners = corners_of(net, f, nodes);
        std::vector<double> areas(corners.size(), fan_area(corners) / static_cast<double>(corners.size()));
        if (effect.share == CornerShare::voronoi)
            areas = nearest_areas(corners);
        else if (effect.share == CornerShare::angle)
            for (std::size_t k = 0; const double share : angle_shares(corners))
                areas[k++] *= share * static_cast<double>(corners.size());
        for (std::size_t k = 0; k < corners.size(); ++k)
            loads(net.panels()[f][k], 2) -= effect.per_area * standard_gravity * areas[k];
    }
}

void add(const PointLoad &effect, const Net & /*net*/, const Points & /*nodes*/, Points &loads) {
    for (const Index node : effect.nodes)
        loads.row(node) += effect.force.transpose();
}

void add(const Snow &effect, const Net &net, const Points &nodes, Points &loads) {
    for (Index f = 0; f < net.panels().size(); ++f) {
        auto corners = corners_of(net, f, nodes);
        for (Vector3 &corner : corners)
            corner.z() = 0;
        const std::size_t count = corners.size();
        const Vector3 middle = mean(corners);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = (k + 1) % count;
            const double area = std::abs(area_vector({middle, corners[k], corners[next]}).z()) / 2;
            const double third = effect.pressure * area / 3;
            loads(net.panels()[f][k], 2) -= third;
            loads(net.panels()[f][next], 2) -= third;
            for (const Index corner : net.panels()[f])
                loads(corner, 2) -= third / static_cast<double>(count);
        }
    }
}

} // namespace

Points certificate_loads(const Net &net, const std::vector<EffectDescription> &effects,
                         const Points &centred_nodes) {
    Points loads = Points::Zero(net.node_count(), 3);
    for (const auto &effect : effects)
        std::visit([&](const auto &part) { add(part, net, centred_nodes, loads); }, effect);
    return loads;
}

} // namespace funicular
