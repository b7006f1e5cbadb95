// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace funicular::test {

NetPtr chain_net(const Points &nodes) {
    std::vector<Member> members;
    for (Index i = 0; i + 1 < nodes.rows(); ++i)
        members.push_back({i, i + 1});
    return std::make_shared<const Net>(nodes, members);
}

NetPtr straight_chain(Index n, double span) {
    Points nodes = Points::Zero(n + 1, 3);
    nodes.col(0).setLinSpaced(0, span);
    return chain_net(nodes);
}

ScenePtr catenary(Index n, double span, double rest, double ea, double weight) {
    return std::make_shared<const Scene>(
        straight_chain(n, span), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0, n}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea)},
                                       MemberWeight{weight / standard_gravity}},
        Eigen::VectorXd::Constant(n, rest / n));
}

ScenePtr strand(Index n, double length, double ea, double weight) {
    Points nodes = Points::Zero(n + 1, 3);
    nodes.col(2).setLinSpaced(0, length);
    return std::make_shared<const Scene>(
        chain_net(nodes), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = {0}}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea)},
                                       MemberWeight{weight / standard_gravity}});
}

ScenePtr hemisphere(Index around, Index up, double radius, double ea, bool compression_only,
                    double member_weight, double covering_weight) {
    LatticeRecipe recipe;
    recipe.cells_u = around;
    recipe.cells_v = up;
    recipe.closed_u = true;
    recipe.poles = {Side::v_max};
    auto lattice = std::make_shared<const Lattice>(recipe);
    Points nodes(lattice->uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i) {
        const double azimuth = 2 * std::numbers::pi * lattice->uv()(i, 0);
        const double height = std::numbers::pi / 2 * lattice->uv()(i, 1);
        nodes.row(i) << radius * std::cos(height) * std::cos(azimuth),
            radius * std::cos(height) * std::sin(azimuth), radius * std::sin(height);
    }
    const auto base = lattice->sides().at(Side::v_min);
    return std::make_shared<const Scene>(
        make_net(lattice, nodes), std::vector<Support>{{.kind = SupportKind::fixed, .nodes = base}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, ea), compression_only},
                                       MemberWeight{member_weight}, CoveringWeight{covering_weight}});
}

ScenePtr warped_roof(bool compression_only) {
    const auto flat = flat_sheet(8, 6, 1);
    Points nodes = flat->nodes();
    for (Index i = 0; i < nodes.rows(); ++i)
        nodes(i, 2) = 0.3 * std::sin(nodes(i, 0)) + 0.2 * std::cos(1.3 * nodes(i, 1) + 0.4 * nodes(i, 0));
    auto net = make_net(flat->lattice(), nodes);
    const auto corners = flat->lattice()->corners();
    return std::make_shared<const Scene>(
        net, std::vector<Support>{{.kind = SupportKind::fixed, .nodes = corners}},
        std::vector<EffectDescription>{AxialStiffness{Eigen::VectorXd::Constant(1, 1e5), compression_only},
                                       MemberWeight{12}, CoveringWeight{30},
                                       PointLoad{{20, 31}, {100, -50, -400}}, Snow{700}});
}

Result solved(const ScenePtr &scene, Method method) {
    SolveOptions options;
    options.tolerance = 1e-12;
    options.accuracy = 1e-12 * scene->net().size();
    options.method = method;
    return solve(scene, options);
}

double distance(const Points &a, const Points &b) {
    return (a - b).rowwise().norm().maxCoeff();
}

void expect_invalid(const std::function<void()> &work, const std::vector<std::string> &words) {
    try {
        work();
        FAIL() << "nothing was thrown; expected a message with: " << words.front();
    } catch (const InvalidInput &error) {
        const std::string message = error.what();
        for (const auto &word : words)
            EXPECT_NE(message.find(word), std::string::npos) << "no '" << word << "' in: " << message;
    }
}

} // namespace funicular::test
