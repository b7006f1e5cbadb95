// SPDX-License-Identifier: LGPL-2.1-or-later
#include "effects/axial.hpp"
#include "effects/covering_weight.hpp"
#include "effects/member_weight.hpp"
#include "effects/point_load.hpp"
#include "effects/snow.hpp"
#include "equilibrium.hpp"
#include "scenes.hpp"

namespace funicular::test {

namespace {

/// Panels of three to five corners, warped, one not convex and one upside down.
NetPtr odd_net() {
    Points nodes(9, 3);
    nodes << 0, 0, 0, 1, 0, 0.2, 2, 0.1, 0, 0, 1, 0.3, 1.1, 0.9, 0.6, 2.2, 1, 0.15, 0.1, 2, 0, 1.2, 1.4, 0.5,
        2, 2.1, -0.1;
    Panels panels;
    for (const std::vector<Index> &corners : std::vector<std::vector<Index>>{
             {0, 1, 4, 3}, {1, 2, 5}, {4, 1, 5}, {3, 4, 5, 8, 7}, {3, 7, 6}, {6, 7, 4, 8}})
        panels.add(corners);
    const std::vector<Member> members{{0, 1}, {1, 2}, {3, 4}, {4, 5}, {0, 3}, {1, 4},
                                      {2, 5}, {3, 6}, {4, 7}, {5, 8}, {6, 7}, {7, 8}};
    return std::make_shared<const Net>(nodes, members, panels);
}

Eigen::VectorXd flat(const Points &points) {
    return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size());
}

Eigen::VectorXd forces(const Effect &effect, const Points &x) {
    Points sum = Points::Zero(x.rows(), 3);
    effect.add_forces(x, sum);
    return flat(sum);
}

Eigen::MatrixXd dense(const BlockMatrix &blocks, Index node_count) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * node_count, 3 * node_count);
    for (Index row = 0; row < node_count; ++row)
        for (const Index column : blocks.columns(row))
            matrix.block<3, 3>(3 * row, 3 * column) = blocks.block(row, column);
    return matrix;
}

/// Minus the derivative of the forces, by central differences.
Eigen::MatrixXd differences(const Effect &effect, const Points &x) {
    constexpr double step = 1e-5;
    Eigen::MatrixXd matrix(x.size(), x.size());
    for (Index column = 0; column < x.size(); ++column) {
        Points forward = x;
        Points backward = x;
        forward.data()[column] += step;
        backward.data()[column] -= step;
        matrix.col(column) = (forces(effect, backward) - forces(effect, forward)) / (2 * step);
    }
    return matrix;
}

void expect_tangent_of_forces(const Effect &effect, const Points &x) {
    const auto node_count = static_cast<Index>(x.rows());
    Coupling coupling(node_count);
    effect.couple(coupling);
    BlockMatrix tangent(std::move(coupling));
    effect.add_tangent(x, tangent);
    const Eigen::MatrixXd expected = differences(effect, x);
    const double scale = std::max(1e-12, expected.cwiseAbs().maxCoeff());
    EXPECT_LT((dense(tangent, node_count) - expected).cwiseAbs().maxCoeff() / scale, 1e-8) << effect.name();

    // The product is added to what is there, and needs no matrix.
    const Points motion = Points::Random(node_count, 3);
    const Points before = Points::Random(node_count, 3);
    Points product = before;
    effect.add_tangent_product(x, motion, product);
    EXPECT_LT((flat(product - before) - dense(tangent, node_count) * flat(motion)).cwiseAbs().maxCoeff() /
                  scale,
              1e-13)
        << effect.name();
}

const Scale unit{};

TEST(Tangent, OfAxialForces) {
    const auto net = odd_net();
    // Some members are longer than their rest length, some shorter.
    Eigen::VectorXd rest = net->source_lengths();
    for (Index e = 0; e < rest.size(); ++e)
        rest[e] *= e % 3 == 0 ? 1.1 : 0.8;
    for (const bool compression_only : {true, false})
        for (const bool per_spring : {true, false}) {
            const AxialForces axial(*net, {Eigen::VectorXd::Constant(1, 7), compression_only, per_spring},
                                    rest, unit);
            expect_tangent_of_forces(axial, net->nodes());
        }
}

TEST(Tangent, OfSpringsOfNoRestLength) {
    const auto net = odd_net();
    const AxialForces axial(*net, {Eigen::VectorXd::LinSpaced(12, 1, 2), true, true},
                            Eigen::VectorXd::Zero(12), unit);
    expect_tangent_of_forces(axial, net->nodes());
    Points collapsed = net->nodes();
    collapsed.row(1) = collapsed.row(0);
    expect_tangent_of_forces(axial, collapsed);
}

TEST(Tangent, OfMemberWeight) {
    const auto net = odd_net();
    expect_tangent_of_forces(MemberLoads(*net, {12}, unit), net->nodes());
}

TEST(Tangent, OfCoveringWeightByEachShare) {
    const auto net = odd_net();
    for (const auto share : {CornerShare::angle, CornerShare::equal, CornerShare::voronoi}) {
        SCOPED_TRACE(static_cast<int>(share));
        expect_tangent_of_forces(CoveringLoads(*net, {30, share}, unit), net->nodes());
    }
}

TEST(Tangent, OfSnow) {
    const auto net = odd_net();
    expect_tangent_of_forces(SnowLoads(*net, {700}, unit), net->nodes());
}

TEST(Tangent, OfPointLoadIsNothing) {
    const auto net = odd_net();
    expect_tangent_of_forces(PointLoads(*net, {{3, 5}, {1, 2, -3}}, unit), net->nodes());
}

TEST(Tangent, OfTheWholeSceneIsThatOfItsResidual) {
    const auto scene = warped_roof();
    Equilibrium equilibrium(scene);
    const Points x =
        scene->scale().to_local(scene->net().nodes()) + 0.01 * Points::Random(scene->net().node_count(), 3);
    BlockMatrix blocks(equilibrium.coupling());
    equilibrium.tangent(x, {.floor = 0, .convex = false}, blocks);
    Eigen::SparseMatrix<double, Eigen::RowMajor> tangent;
    blocks.reduce(scene->freedoms(), tangent);

    constexpr double step = 1e-6;
    Points motion(x.rows(), 3);
    for (const Index unknown : {0, 5, 40, 77, scene->freedoms().size() - 1}) {
        const Eigen::VectorXd direction = Eigen::VectorXd::Unit(scene->freedoms().size(), unknown);
        scene->freedoms().expand(direction, motion);
        equilibrium.evaluate(x + step * motion);
        const Eigen::VectorXd forward = equilibrium.residual();
        equilibrium.evaluate(x - step * motion);
        const Eigen::VectorXd column = (equilibrium.residual() - forward) / (2 * step);
        EXPECT_LT((tangent * direction - column).norm(), 1e-7 * column.norm()) << "unknown " << unknown;
    }
}

TEST(AxialForces, SlackMembersCarryNothing) {
    const auto net = straight_chain(2, 2);
    const Eigen::VectorXd rest = (Eigen::VectorXd(2) << 0.5, 2).finished();
    Eigen::VectorXd tensions;
    AxialForces(*net, {Eigen::VectorXd::Constant(1, 10), true}, rest, unit).tensions(net->nodes(), tensions);
    EXPECT_DOUBLE_EQ(tensions[0], 10); // k = EA / r = 20, stretched by 0.5
    EXPECT_DOUBLE_EQ(tensions[1], 0);
    AxialForces(*net, {Eigen::VectorXd::Constant(1, 10), false}, rest, unit).tensions(net->nodes(), tensions);
    EXPECT_DOUBLE_EQ(tensions[1], -5);
}

TEST(Effects, RefuseWhatCannotBeMeant) {
    const auto net = odd_net();
    const auto no_panels = straight_chain(2, 2);
    const auto &rest = net->source_lengths();
    const auto axial = [&](const Eigen::VectorXd &stiffness, const Eigen::VectorXd &lengths) {
        AxialForces(*net, {stiffness}, lengths, unit);
    };
    expect_invalid([&] { axial(Eigen::VectorXd::Constant(1, 0), rest); },
                   {"AxialStiffness", "stiffness must be positive"});
    expect_invalid([&] { axial(Eigen::VectorXd::Constant(5, 1), rest); },
                   {"AxialStiffness", "5 values", "12 members"});
    expect_invalid([&] { axial(Eigen::VectorXd::Constant(1, 1), Eigen::VectorXd::Zero(12)); },
                   {"rest_lengths[0]", "zero"});
    expect_invalid([&] { MemberLoads(*net, {-1}, unit); }, {"MemberWeight"});
    expect_invalid([&] { CoveringLoads(*net, {std::nan("")}, unit); }, {"CoveringWeight"});
    expect_invalid([&] { CoveringLoads(*no_panels, {1}, unit); }, {"CoveringWeight", "no panels"});
    expect_invalid([&] { SnowLoads(*net, {-5}, unit); }, {"Snow"});
    expect_invalid([&] { SnowLoads(*no_panels, {5}, unit); }, {"Snow", "no panels"});
    expect_invalid([&] { PointLoads(*net, {{1, 9}, {0, 0, 1}}, unit); }, {"PointLoad", "ids[1] is 9"});
    expect_invalid([&] { PointLoads(*net, {{1}, {0, 0, std::nan("")}}, unit); }, {"PointLoad", "force"});
    expect_invalid([&] { PointLoads(*net, {{3, 5, 3}, {0, 0, 1}}, unit); }, {"PointLoad", "node 3 twice"});
}

} // namespace
} // namespace funicular::test
