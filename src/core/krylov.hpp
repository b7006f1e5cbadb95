// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace funicular {

/// How a linear iteration ended.
struct LinearProgress {
    int iterations = 0;
    /// |b - A x| / |b|
    double residual = 1;
};

/// Solves A x = b by generalised conjugate residuals: of all combinations of the directions so far, the one
/// with the least residual. A need not be symmetric, nor the preconditioner be the same from step to step
/// (Eisenstat, Elman and Schultz, "Variational iterative methods for nonsymmetric systems of linear
/// equations", 1983).
class ConjugateResiduals {
public:
    /// \param multiply     multiply(v, result): result = A v
    /// \param precondition precondition(v, result): result comes near to A⁻¹ v
    /// \param tolerance    of |b - A x| / |b|
    /// \param x            zero, or what is known of the solution
    template <class Multiply, class Precondition>
    LinearProgress solve(const Multiply &multiply, const Precondition &precondition, const Eigen::VectorXd &b,
                         double tolerance, int most_iterations, Eigen::VectorXd &x);

private:
    // The oldest beyond so many are given up: they fill the memory, and those of a nearly symmetric matrix
    // hardly count.
    static constexpr std::size_t most_directions = 16;
    std::vector<Eigen::VectorXd> directions_, images_;
    Eigen::VectorXd residual_, image_;
};

template <class Multiply, class Precondition>
LinearProgress ConjugateResiduals::solve(const Multiply &multiply, const Precondition &precondition,
                                         const Eigen::VectorXd &b, double tolerance, int most_iterations,
                                         Eigen::VectorXd &x) {
    LinearProgress progress;
    const double whole = b.norm();
    residual_ = b;
    if (!x.isZero(0)) {
        multiply(x, image_);
        residual_ -= image_;
    }
    progress.residual = whole > 0 ? residual_.norm() / whole : 0;
    std::size_t kept = 0;
    while (progress.residual > tolerance && progress.iterations < most_iterations) {
        const std::size_t next = progress.iterations % most_directions;
        if (directions_.size() == next) {
            directions_.emplace_back();
            images_.emplace_back();
        }
        Eigen::VectorXd &direction = directions_[next];
        Eigen::VectorXd &image = images_[next];
        precondition(residual_, direction);
        multiply(direction, image);
        for (std::size_t k = 0; k < kept; ++k) {
            if (k == next)
                continue;
            const double part = images_[k].dot(image);
            image -= part * images_[k];
            direction -= part * directions_[k];
        }
        const double size = image.norm();
        if (!(size > 0) || !std::isfinite(size))
            break;
        image /= size;
        direction /= size;
        const double along = image.dot(residual_);
        x += along * direction;
        residual_ -= along * image;
        kept = std::max(kept, next + 1);
        ++progress.iterations;
        progress.residual = residual_.norm() / whole;
    }
    return progress;
}

} // namespace funicular
