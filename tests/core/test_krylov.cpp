// SPDX-License-Identifier: LGPL-2.1-or-later
#include "krylov.hpp"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace funicular::test {

namespace {

TEST(ConjugateResiduals, SolvesAnUnsymmetricSystem) {
    std::srand(3);
    for (const int size : {1, 5, 40}) {
        const Eigen::MatrixXd matrix = 4 * Eigen::MatrixXd::Identity(size, size) +
                                       3 * Eigen::MatrixXd::Random(size, size) / std::sqrt(size);
        const Eigen::VectorXd right = Eigen::VectorXd::Random(size);
        for (const double tolerance : {1e-2, 1e-6, 1e-11}) {
            Eigen::VectorXd x = Eigen::VectorXd::Zero(size);
            ConjugateResiduals residuals;
            for (const bool is_begun : {false, true}) { // anew, and from what is known
                const auto progress = residuals.solve(
                    [&](const Eigen::VectorXd &v, Eigen::VectorXd &image) { image = matrix * v; },
                    [](const Eigen::VectorXd &v, Eigen::VectorXd &image) { image = v; }, right, tolerance,
                    200, x);
                EXPECT_LE(progress.residual, tolerance);
                EXPECT_NEAR((right - matrix * x).norm() / right.norm(), progress.residual, 1e-13);
                EXPECT_EQ(progress.iterations == 0, is_begun);
            }
        }
    }
}

TEST(ConjugateResiduals, SayWhatIsLeftWhereTheyStop) {
    const Eigen::MatrixXd matrix = Eigen::VectorXd::LinSpaced(50, 1, 1e4).asDiagonal();
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(50);
    const auto identity = [](const Eigen::VectorXd &v, Eigen::VectorXd &image) { image = v; };
    Eigen::VectorXd x = Eigen::VectorXd::Zero(50);
    const auto progress = ConjugateResiduals().solve(
        [&](const Eigen::VectorXd &v, Eigen::VectorXd &image) { image = matrix * v; }, identity, right, 1e-9,
        20, x);
    EXPECT_EQ(progress.iterations, 20);
    EXPECT_GT(progress.residual, 1e-9);
    EXPECT_NEAR((right - matrix * x).norm() / right.norm(), progress.residual, 1e-12);
    x.setZero();
    const auto nowhere =
        ConjugateResiduals().solve([](const Eigen::VectorXd &v, Eigen::VectorXd &image) { image = 0 * v; },
                                   identity, right, 1e-9, 20, x);
    EXPECT_EQ(nowhere.iterations, 0);
    EXPECT_EQ(nowhere.residual, 1);
    EXPECT_TRUE(x.isZero(0));
}

} // namespace
} // namespace funicular::test
