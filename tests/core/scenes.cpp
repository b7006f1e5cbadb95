// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scenes.hpp"

#include "certificate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

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

NetPtr braced_sheet(double width, double depth, Index cells_u, Index cells_v) {
    LatticeRecipe recipe;
    recipe.cells_u = cells_u;
    recipe.cells_v = cells_v;
    const Lattice lattice(recipe);
    Points nodes = Points::Zero(lattice.uv().rows(), 3);
    nodes.col(0) = width * lattice.uv().col(0);
    nodes.col(1) = depth * lattice.uv().col(1);
    auto members = lattice.members();
    for (Index f = 0; f < lattice.panels().size(); ++f) {
        const auto corners = lattice.panels()[f];
        members.push_back({corners[0], corners[2]});
        members.push_back({corners[1], corners[3]});
    }
    return std::make_shared<const Net>(nodes, members, lattice.panels());
}

ScenePtr SceneParts::scene() const {
    return std::make_shared<const Scene>(std::make_shared<const Net>(nodes, members, panels), supports,
                                         effects, rest_lengths);
}

SceneParts parts_of(const Scene &scene) {
    return {scene.net().nodes(), scene.net().members(), scene.net().panels(),
            scene.supports(),    scene.effects(),       scene.rest_lengths()};
}

ScenePtr renumbered(const Scene &scene, unsigned seed, std::vector<Index> &number) {
    std::mt19937 random(seed);
    const auto shuffled = [&random](Index count) {
        std::vector<Index> order(count);
        std::iota(order.begin(), order.end(), 0);
        std::shuffle(order.begin(), order.end(), random);
        return order;
    };
    const SceneParts from = parts_of(scene);
    SceneParts to = from;
    number = shuffled(scene.net().node_count());
    for (Index i = 0; i < from.nodes.rows(); ++i)
        to.nodes.row(number[i]) = from.nodes.row(i);
    const auto member_order = shuffled(scene.net().member_count());
    for (Index e = 0; e < scene.net().member_count(); ++e) {
        const auto [i, j] = from.members[member_order[e]];
        to.members[e] = random() % 2 == 0 ? Member{number[i], number[j]} : Member{number[j], number[i]};
        to.rest_lengths[e] = from.rest_lengths[member_order[e]];
    }
    to.panels = {};
    for (const Index f : shuffled(from.panels.size())) {
        std::vector<Index> corners;
        for (const Index node : from.panels[f])
            corners.push_back(number[node]);
        std::rotate(corners.begin(), corners.begin() + random() % corners.size(), corners.end());
        to.panels.add(corners);
    }
    for (auto &support : to.supports)
        for (Index &node : support.nodes)
            node = number[node];
    for (auto &effect : to.effects) {
        if (auto *load = std::get_if<PointLoad>(&effect))
            for (Index &node : load->nodes)
                node = number[node];
        if (auto *axial = std::get_if<AxialStiffness>(&effect); axial && axial->stiffness.size() > 1) {
            const Eigen::VectorXd given = axial->stiffness;
            for (Index e = 0; e < given.size(); ++e)
                axial->stiffness[e] = given[member_order[e]];
        }
    }
    return to.scene();
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

void expect_certified(const ScenePtr &scene, const Result &result, double tolerance) {
    EXPECT_EQ(result.status, Status::converged) << result.message;
    EXPECT_TRUE(result.nodes.allFinite() && result.member_forces.allFinite() &&
                result.member_lengths.allFinite() && result.reactions.allFinite());
    const auto certificate = certify(*scene, result.centred_nodes, &result.reactions, tolerance);
    EXPECT_TRUE(certificate.in_equilibrium) << certificate.summary();
    // The sums cannot differ by more than their parts, of which rounding may excuse more than the tolerance.
    EXPECT_LE(certificate.balance, certificate.max_residual + 1e-9);
    EXPECT_LE(certificate.moment_balance, certificate.max_residual + 1e-9);
}

Result solved_in_any_numbering(const ScenePtr &scene, double agreed) {
    auto result = solved(scene);
    expect_certified(scene, result);
    for (const unsigned seed : {1U, 2U, 3U}) {
        std::vector<Index> number;
        const auto other = solved(renumbered(*scene, seed, number));
        EXPECT_EQ(other.status, result.status) << other.message;
        double apart = 0;
        for (Index i = 0; i < scene->net().node_count(); ++i)
            apart = std::max(apart, (other.nodes.row(number[i]) - result.nodes.row(i)).norm());
        EXPECT_LE(apart, agreed * scene->net().size()) << "numbering " << seed;
    }
    return result;
}

void expect_no_equilibrium(const ScenePtr &scene, const std::vector<std::string> &words) {
    std::vector<Index> number;
    for (const auto &numbered : {scene, renumbered(*scene, 1, number)}) {
        const auto result = solve(numbered);
        EXPECT_EQ(result.status, Status::no_equilibrium) << result.message;
        EXPECT_TRUE(result.nodes.allFinite());
        expect_words(result.message, words);
    }
}

void expect_words(const std::string &text, const std::vector<std::string> &words) {
    for (const auto &word : words)
        EXPECT_NE(text.find(word), std::string::npos) << "no '" << word << "' in: " << text;
}

void expect_invalid(const std::function<void()> &work, const std::vector<std::string> &words) {
    try {
        work();
        FAIL() << "nothing was thrown; expected a message with: " << words.front();
    } catch (const InvalidInput &error) {
        expect_words(error.what(), words);
    }
}

} // namespace funicular::test
