// SPDX-License-Identifier: LGPL-2.1-or-later
#include "yardstick.hpp"

#include "equilibrium.hpp"
#include "measure.hpp"

#include <Eigen/SparseCholesky>
#ifdef FUNICULAR_BENCH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace funicular::bench {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Factorisation = std::function<FactorTimes(const Matrix &, const Eigen::VectorXd &)>;

// Of the members' mean stiffness.
constexpr double notional_pull = 1e-9;
constexpr double close_to_best = 2;

template <class Solver>
FactorTimes run_with(Solver &solver, const Matrix &matrix, const Eigen::VectorXd &right) {
    FactorTimes times;
    Eigen::VectorXd solution;
    times.analyse = timed([&] { solver.analyzePattern(matrix); }).cpu;
    times.factorise = timed([&] { solver.factorize(matrix); }).cpu;
    times.solve = timed([&] { solution = solver.solve(right); }).cpu;
    times.residual = solver.info() == Eigen::Success ? (matrix * solution - right).norm() / right.norm()
                                                     : std::numeric_limits<double>::infinity();
    return times;
}

#ifdef FUNICULAR_BENCH_CHOLMOD
template <class Solver>
Factorisation cholmod(int ordering) {
    return [ordering](const Matrix &matrix, const Eigen::VectorXd &right) {
        Solver solver;
        solver.cholmod().nmethods = 1;
        solver.cholmod().method[0].ordering = ordering;
        solver.cholmod().print = 0;
        return run_with(solver, matrix, right);
    };
}
#endif

const std::vector<std::pair<std::string, Factorisation>> &factorisations() {
    static const std::vector<std::pair<std::string, Factorisation>> all{
        {"eigen_ldlt_amd",
         [](const Matrix &matrix, const Eigen::VectorXd &right) {
             Eigen::SimplicialLDLT<Matrix> solver;
             return run_with(solver, matrix, right);
         }},
#ifdef FUNICULAR_BENCH_CHOLMOD
        {"cholmod_simplicial_amd", cholmod<Eigen::CholmodSimplicialLDLT<Matrix>>(CHOLMOD_AMD)},
        {"cholmod_simplicial_metis", cholmod<Eigen::CholmodSimplicialLDLT<Matrix>>(CHOLMOD_METIS)},
        {"cholmod_supernodal_amd", cholmod<Eigen::CholmodSupernodalLLT<Matrix>>(CHOLMOD_AMD)},
        {"cholmod_supernodal_metis", cholmod<Eigen::CholmodSupernodalLLT<Matrix>>(CHOLMOD_METIS)},
        {"cholmod_supernodal_nesdis", cholmod<Eigen::CholmodSupernodalLLT<Matrix>>(CHOLMOD_NESDIS)},
#endif
    };
    return all;
}

} // namespace

Yardstick::Yardstick(const ScenePtr &scene, const Points &centred_nodes) {
    const Points x = centred_nodes / scene->scale().length;
    Equilibrium equilibrium(scene);
    equilibrium.evaluate(x);
    BlockMatrix blocks(equilibrium.member_coupling());
    const double floor = notional_pull * scene->axial().stiffness().mean();
    equilibrium.member_tangent(x, {.floor = floor, .convex = true}, blocks);
    blocks.reduce(scene->freedoms(), tangent_);
    scene->freedoms().reduce(equilibrium.loads(), load_);
}

std::vector<std::string> Yardstick::backends() {
    std::vector<std::string> names;
    for (const auto &[name, factorisation] : factorisations())
        names.push_back(name);
    return names;
}

FactorTimes Yardstick::run(const std::string &backend) const {
    for (const auto &[name, factorisation] : factorisations())
        if (name == backend)
            return factorisation(tangent_, load_);
    throw std::invalid_argument("no factorisation is called '" + backend + "'");
}

std::string Yardstick::best() const {
    std::map<std::string, double> totals;
    double least = std::numeric_limits<double>::infinity();
    const auto look_at = [&](const std::string &backend) {
        double &total = totals.try_emplace(backend, std::numeric_limits<double>::infinity()).first->second;
        total = std::min(total, run(backend).total());
        least = std::min(least, total);
    };
    for (const auto &backend : backends())
        look_at(backend);
    // A hiccup of the machine must not decide between those that are close.
    for (const auto &backend : backends())
        if (totals[backend] < close_to_best * least)
            look_at(backend);
    return std::min_element(totals.begin(), totals.end(),
                            [](const auto &a, const auto &b) { return a.second < b.second; })
        ->first;
}

} // namespace funicular::bench
