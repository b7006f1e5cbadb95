// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/corner_areas.hpp"

#include "effects/voronoi_share.hpp"

#include <complex>
#include <numeric>

namespace funicular {

const std::vector<double> &CornerAreas::areas(const Points &x, std::span<const Index> corners) {
    panel_.place(x, corners);
    const int count = panel_.corner_count();
    switch (share_) {
    case CornerShare::angle: {
        panel_.angles(areas_);
        const double sum = std::accumulate(areas_.begin(), areas_.end(), 0.0);
        const double area = panel_.area();
        for (double &angle : areas_)
            angle = sum > 0 ? area * angle / sum : area / count;
        break;
    }
    case CornerShare::equal:
        areas_.assign(count, panel_.area() / count);
        break;
    case CornerShare::voronoi: {
        std::vector<VoronoiPoint<double>> points(count);
        for (int k = 0; k < count; ++k)
            points[k] = {panel_.corner(k)[0], panel_.corner(k)[1], panel_.corner(k)[2]};
        areas_ = voronoi_areas(points);
        break;
    }
    }
    return areas_;
}

const std::vector<Vector3> &CornerAreas::gradients(const Points &x, std::span<const Index> corners) {
    panel_.place(x, corners);
    const int count = panel_.corner_count();
    gradients_.assign(static_cast<std::size_t>(count) * count, Vector3::Zero());
    switch (share_) {
    case CornerShare::angle:
        angle_gradients();
        break;
    case CornerShare::equal:
        panel_.area_gradient(area_gradient_);
        for (int k = 0; k < count; ++k)
            for (int m = 0; m < count; ++m)
                gradients_[k * count + m] = area_gradient_[m] / count;
        break;
    case CornerShare::voronoi:
        voronoi_gradients();
        break;
    }
    return gradients_;
}

/// A_k = A θ_k / Σθ, so dA_k = θ_k / Σθ dA + A / Σθ (dθ_k - θ_k / Σθ Σdθ).
void CornerAreas::angle_gradients() {
    const int count = panel_.corner_count();
    panel_.angles(angles_);
    panel_.area_gradient(area_gradient_);
    const double sum = std::accumulate(angles_.begin(), angles_.end(), 0.0);
    const double area = panel_.area();
    if (sum == 0)
        return;
    for (int of = 0; of < count; ++of) {
        const auto gradient = panel_.angle_gradient(of);
        const Vector3 by_itself = -(gradient.before + gradient.after);
        for (int k = 0; k < count; ++k) {
            const double weight = area / sum * ((k == of ? 1.0 : 0.0) - angles_[k] / sum);
            gradients_[k * count + panel_.before(of)] += weight * gradient.before;
            gradients_[k * count + panel_.after(of)] += weight * gradient.after;
            gradients_[k * count + of] += weight * by_itself;
        }
    }
    for (int k = 0; k < count; ++k)
        for (int m = 0; m < count; ++m)
            gradients_[k * count + m] += angles_[k] / sum * area_gradient_[m];
}

/// By a complex step, which is exact to rounding and spares the derivatives of the clipping.
void CornerAreas::voronoi_gradients() {
    using Complex = std::complex<double>;
    constexpr double step = 1e-30;
    const int count = panel_.corner_count();
    std::vector<VoronoiPoint<Complex>> points(count);
    for (int k = 0; k < count; ++k)
        points[k] = {panel_.corner(k)[0], panel_.corner(k)[1], panel_.corner(k)[2]};
    for (int m = 0; m < count; ++m)
        for (int axis = 0; axis < 3; ++axis) {
            const Complex kept = points[m][axis];
            points[m][axis] += Complex(0, step);
            const auto areas = voronoi_areas(points);
            points[m][axis] = kept;
            for (int k = 0; k < count; ++k)
                gradients_[k * count + m][axis] = areas[k].imag() / step;
        }
}

} // namespace funicular
