// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/snow.hpp"

#include "errors.hpp"

#include <cmath>
#include <vector>

namespace funicular {

namespace {

using Vector2 = Eigen::Vector2d;

double cross(const Vector2 &a, const Vector2 &b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A panel seen from above.
class Plan {
public:
    void place(const Points &x, std::span<const Index> corners) {
        corners_.resize(corners.size());
        middle_.setZero();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            corners_[k] = x.row(corners[k]).head<2>().transpose();
            middle_ += corners_[k];
        }
        middle_ /= static_cast<double>(corners.size());
    }

    [[nodiscard]] std::size_t after(std::size_t k) const { return k + 1 == corners_.size() ? 0 : k + 1; }
    [[nodiscard]] double triangle(std::size_t k) const { return std::abs(doubled(k)) / 2; }
    /// Derivatives of triangle k by its two corners; by the middle, minus their sum.
    [[nodiscard]] Vector2 by_first(std::size_t k) const {
        const Vector2 b = from_middle(after(k));
        return sense(k) / 2 * Vector2(b.y(), -b.x());
    }
    [[nodiscard]] Vector2 by_second(std::size_t k) const {
        const Vector2 a = from_middle(k);
        return sense(k) / 2 * Vector2(-a.y(), a.x());
    }

private:
    /// Twice the area of the triangle between edge k and the middle, negative where it is seen from below.
    [[nodiscard]] double doubled(std::size_t k) const { return cross(from_middle(k), from_middle(after(k))); }
    [[nodiscard]] double sense(std::size_t k) const { return doubled(k) < 0 ? -1 : 1; }
    [[nodiscard]] Vector2 from_middle(std::size_t k) const { return corners_[k] - middle_; }

    std::vector<Vector2> corners_;
    Vector2 middle_;
};

} // namespace

SnowLoads::SnowLoads(const Net &net, const Snow &description, const Scale &scale)
    : net_(net), pressure_(description.pressure * scale.length * scale.length / scale.force) {
    if (!(description.pressure >= 0) || !std::isfinite(description.pressure))
        throw InvalidInput("Snow: pressure must be zero or positive and finite, in N/m²");
    if (net.panels().empty())
        throw InvalidInput(
            "Snow: the net has no panels for snow to lie on; give it panels, or leave the snow out");
}

void SnowLoads::add_forces(const Points &x, Points &forces) const {
    Plan plan;
    for (Index f = 0; f < net_.panels().size(); ++f) {
        const auto corners = net_.panels()[f];
        plan.place(x, corners);
        double total = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const double third = pressure_ * plan.triangle(k) / 3;
            forces(corners[k], 2) += third;
            forces(corners[plan.after(k)], 2) += third;
            total += third;
        }
        for (const Index corner : corners)
            forces(corner, 2) += total / static_cast<double>(corners.size());
    }
}

void SnowLoads::couple(Coupling &coupling) const {
    for (Index f = 0; f < net_.panels().size(); ++f)
        coupling.add(net_.panels()[f]);
}

template <class Add>
void SnowLoads::differentiate(const Points &x, const Add &add) const {
    Plan plan;
    Vector3 gradient = Vector3::Zero();
    for (Index f = 0; f < net_.panels().size(); ++f) {
        const auto corners = net_.panels()[f];
        const auto count = static_cast<double>(corners.size());
        plan.place(x, corners);
        for (std::size_t edge = 0; edge < corners.size(); ++edge) {
            const Vector2 first = plan.by_first(edge);
            const Vector2 second = plan.by_second(edge);
            for (std::size_t m = 0; m < corners.size(); ++m) {
                Vector2 by_corner = -(first + second) / count;
                if (m == edge)
                    by_corner += first;
                if (m == plan.after(edge))
                    by_corner += second;
                for (std::size_t k = 0; k < corners.size(); ++k) {
                    const double share = ((k == edge || k == plan.after(edge) ? 1 : 0) + 1 / count) / 3;
                    gradient.head<2>() = pressure_ * share * by_corner;
                    add(corners[k], corners[m], gradient);
                }
            }
        }
    }
}

void SnowLoads::add_tangent(const Points &x, BlockMatrix &tangent) const {
    differentiate(x, [&tangent](Index node, Index by, const Vector3 &gradient) {
        tangent.add_vertical(node, by, -gradient);
    });
}

void SnowLoads::add_tangent_product(const Points &x, const Points &motion, Points &product) const {
    differentiate(x, [&motion, &product](Index node, Index by, const Vector3 &gradient) {
        product(node, 2) -= gradient.dot(motion.row(by));
    });
}

bool SnowLoads::keep_gradients(const Points &x, std::vector<LoadGradient> &kept) const {
    differentiate(x, [&kept](Index node, Index by, const Vector3 &gradient) {
        kept.push_back({.node = node, .by = by, .gradient = gradient});
    });
    return true;
}

} // namespace funicular
