// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// The factorisation, by whichever backend the core was built with.
#include "scenes.hpp"
#include "sparse_cholesky.hpp"

#include <Eigen/SparseCholesky>

#include <random>
#include <thread>

#ifdef FUNICULAR_CHOLMOD
extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int threads);
}
#endif

namespace funicular::test {

namespace {

struct Matrices {
    SparseCholesky::Matrix whole, lower;
    std::vector<Index> first_unknown;
};

/// Springs of random stiffness between neighbours of a grid of nodes with 0 to 3 unknowns each.
Matrices random_stiffness(Index side, unsigned seed, double ground = 1e-3) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> entry(-1, 1);
    Matrices result;
    for (Index node = 0; node < side * side; ++node)
        result.first_unknown.push_back(
            node == 0 ? 0 : result.first_unknown.back() + (node % 5 == 0 ? (node / 5) % 3 : 3));
    result.first_unknown.push_back(result.first_unknown.back() + 3);
    const auto size = result.first_unknown.back();
    std::vector<Eigen::Triplet<double>> triplets;
    for (Index unknown = 0; unknown < size; ++unknown)
        triplets.emplace_back(unknown, unknown, ground);
    const auto tie = [&](Index a, Index b) {
        std::vector<std::pair<Index, double>> row;
        for (const Index node : {a, b})
            for (Index u = result.first_unknown[node]; u < result.first_unknown[node + 1]; ++u)
                row.emplace_back(u, entry(random));
        for (const auto &[i, value_i] : row)
            for (const auto &[j, value_j] : row)
                triplets.emplace_back(i, j, value_i * value_j);
    };
    for (Index j = 0; j < side; ++j)
        for (Index i = 0; i < side; ++i)
            for (int k = 0; k < 4; ++k) {
                if (i + 1 < side)
                    tie(j * side + i, j * side + i + 1);
                if (j + 1 < side)
                    tie(j * side + i, j * side + i + side);
            }
    result.whole.resize(size, size);
    result.whole.setFromTriplets(triplets.begin(), triplets.end());
    result.lower = result.whole.triangularView<Eigen::Lower>();
    return result;
}

Eigen::VectorXd solution_of(const Matrices &matrices) {
    SparseCholesky factor;
    EXPECT_TRUE(factor.factorise(matrices.lower, matrices.first_unknown));
    Eigen::VectorXd solution;
    factor.solve(Eigen::VectorXd::LinSpaced(matrices.lower.rows(), -1, 2), solution);
    return solution;
}

TEST(SparseCholesky, SolvesAsEigenDoes) {
    for (const Index side : {2, 7, sized(80, 12)}) {
        const Matrices matrices = random_stiffness(side, 3);
        const Eigen::SimplicialLDLT<SparseCholesky::Matrix> eigen(matrices.whole);
        const Eigen::VectorXd expected =
            eigen.solve(Eigen::VectorXd::LinSpaced(matrices.lower.rows(), -1, 2));
        EXPECT_LT((solution_of(matrices) - expected).norm(), 1e-9 * expected.norm());
    }
}

TEST(SparseCholesky, SolvesWhereNestedDissectionOrders) {
    const Matrices matrices = random_stiffness(sized(250, 20), 3);
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrices.lower.rows(), -1, 2);
    EXPECT_LT((matrices.whole * solution_of(matrices) - right).norm(), 1e-9 * right.norm());
}

TEST(SparseCholesky, FactorisesOtherValuesOfOneStructure) {
    SparseCholesky factor;
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Matrices matrices = random_stiffness(9, seed);
        ASSERT_TRUE(factor.factorise(matrices.lower, matrices.first_unknown));
        const Eigen::VectorXd right = Eigen::VectorXd::Ones(matrices.lower.rows());
        Eigen::VectorXd solution;
        factor.solve(right, solution);
        EXPECT_LT((matrices.whole * solution - right).norm(), 1e-9 * right.norm());
    }
}

TEST(SparseCholesky, RefusesWhatIsNotPositiveDefiniteAndGoesOn) {
    SparseCholesky factor;
    const Matrices bad = random_stiffness(9, 1, -5);
    const Matrices good = random_stiffness(9, 1);
    EXPECT_FALSE(factor.factorise(bad.lower, bad.first_unknown));
    ASSERT_TRUE(factor.factorise(good.lower, good.first_unknown));
    Eigen::VectorXd solution;
    factor.solve(Eigen::VectorXd::LinSpaced(good.lower.rows(), -1, 2), solution);
    EXPECT_EQ((solution - solution_of(good)).norm(), 0);
}

TEST(SparseCholesky, RefusesNumbersThatAreNone) {
    Matrices matrices = random_stiffness(5, 1);
    matrices.lower.coeffRef(7, 7) = std::numeric_limits<double>::quiet_NaN();
    SparseCholesky factor;
    EXPECT_FALSE(factor.factorise(matrices.lower, matrices.first_unknown));
}

TEST(SparseCholesky, NothingToSolveIsSolved) {
    SparseCholesky factor;
    const std::vector<Index> none{0, 0, 0};
    ASSERT_TRUE(factor.factorise(SparseCholesky::Matrix(0, 0), none));
    Eigen::VectorXd solution;
    factor.solve(Eigen::VectorXd(), solution);
    EXPECT_EQ(solution.size(), 0);
}

TEST(SparseCholesky, SeveralAtOnceGiveTheSameBits) {
    const Matrices matrices = random_stiffness(sized(70, 12), 5);
    const Eigen::VectorXd expected = solution_of(matrices);
    std::vector<Eigen::VectorXd> solutions(4);
    std::vector<std::thread> threads;
    for (auto &solution : solutions)
        threads.emplace_back([&matrices, &solution] { solution = solution_of(matrices); });
    for (auto &thread : threads)
        thread.join();
    for (const auto &solution : solutions)
        EXPECT_EQ((solution - expected).norm(), 0);
}

#ifdef FUNICULAR_CHOLMOD
TEST(SparseCholesky, ThreadsOfOpenBlasChangeNoBitAndStayAsTheyWere) {
    const Matrices matrices = random_stiffness(sized(80, 20), 5);
    const int before = openblas_get_num_threads();
    openblas_set_num_threads(1);
    const Eigen::VectorXd expected = solution_of(matrices);
    openblas_set_num_threads(2);
    EXPECT_EQ((solution_of(matrices) - expected).norm(), 0);
    EXPECT_EQ(openblas_get_num_threads(), 2);
    openblas_set_num_threads(before);
}
#endif

} // namespace

} // namespace funicular::test
