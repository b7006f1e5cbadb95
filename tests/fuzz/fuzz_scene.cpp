// SPDX-License-Identifier: LGPL-2.1-or-later
/// \file
/// Bytes → net, supports, effects, start, options → a short solve → certificate.
///
/// The only thing that may be thrown is InvalidInput. A result has no NaN, a status that was reached, and
/// numbers that are finite; "converged" is what the certificate, which shares nothing with the solver, calls
/// an equilibrium; and the same input gives the same bits, whether solved in one go or in slices.
#include "bytes.hpp"

#include "certificate.hpp"
#include "errors.hpp"
#include "lattice.hpp"
#include "scene.hpp"
#include "solve.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

namespace funicular::fuzz {

namespace {

// So many nodes make every topology there is; more only make the fuzzer slow.
constexpr Index most_nodes = 24;
constexpr long most_iterations = 60;

void require(bool holds, const char *property, const std::string &detail = "") {
    if (holds)
        return;
    std::fprintf(stderr, "property broken: %s %s\n", property, detail.c_str());
    std::abort();
}

/// The unit square's (u, v) laid on something between a sheet, a tube and a dome.
Points lay_out(const Lattice &lattice, Bytes &bytes) {
    const double twist = bytes.unit();
    const double height = bytes.unit() - 0.5;
    Points nodes(lattice.uv().rows(), 3);
    for (Index i = 0; i < nodes.rows(); ++i) {
        const double u = 6.28 * lattice.uv()(i, 0);
        const double v = lattice.uv()(i, 1);
        const double radius = lattice.recipe().closed_v ? 2 + std::cos(6.28 * v) : 1 - twist * v;
        nodes.row(i) << radius * std::cos(u), radius * std::sin(u), height * std::sin(3 * v);
    }
    return nodes;
}

std::shared_ptr<const Net> net_from(Bytes &bytes) {
    const double scale = std::exp2(bytes.between(-20, 10));
    const double offset = bytes.one_in(4) ? 1e6 : 0;
    if (bytes.one_in(2)) {
        LatticeRecipe recipe;
        recipe.cells_u = bytes.between(0, 4);
        recipe.cells_v = bytes.between(0, 4);
        recipe.closed_u = bytes.one_in(2);
        recipe.closed_v = bytes.one_in(4);
        for (const Side side : {Side::u_min, Side::u_max, Side::v_min, Side::v_max})
            if (bytes.one_in(4))
                recipe.poles.push_back(side);
        const auto lattice = std::make_shared<const Lattice>(recipe);
        return make_net(lattice, (lay_out(*lattice, bytes) * scale).array() + offset);
    }
    Points nodes(bytes.between(0, most_nodes), 3);
    for (Index i = 0; i < nodes.rows(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            nodes(i, axis) = offset + scale * bytes.coordinate();
    std::vector<Member> members(bytes.between(0, 2 * most_nodes));
    for (Member &member : members)
        member = {bytes.between(0, most_nodes), bytes.between(0, most_nodes)};
    Panels panels;
    for (int left = bytes.between(0, most_nodes); left > 0; --left) {
        std::vector<Index> corners(bytes.between(2, 6));
        for (Index &corner : corners)
            corner = bytes.between(0, most_nodes);
        panels.add(corners);
    }
    return std::make_shared<const Net>(std::move(nodes), std::move(members), std::move(panels));
}

std::vector<Index> ids_from(Bytes &bytes, Index node_count) {
    std::vector<Index> ids;
    for (int left = bytes.between(0, 6); left > 0; --left)
        ids.push_back(bytes.one_in(64) ? bytes.between(-2, most_nodes + 2)
                                       : bytes.between(0, node_count - 1));
    return ids;
}

std::vector<Support> supports_from(Bytes &bytes, Index node_count) {
    std::vector<Support> supports;
    for (int left = bytes.between(1, 4); left > 0; --left) {
        Support support;
        support.kind = static_cast<SupportKind>(bytes.between(0, 2));
        support.nodes = ids_from(bytes, node_count);
        if (bytes.one_in(2))
            support.direction = {bytes.coordinate(), bytes.coordinate(), bytes.coordinate()};
        if (bytes.one_in(4))
            support.stiffness = bytes.magnitude(-3, 9);
        supports.push_back(support);
    }
    return supports;
}

std::vector<EffectDescription> effects_from(Bytes &bytes, const Net &net) {
    std::vector<EffectDescription> effects;
    AxialStiffness axial;
    axial.stiffness.resize(bytes.one_in(8) ? net.member_count() : 1);
    for (double &value : axial.stiffness)
        value = bytes.magnitude(-2, 12);
    axial.compression_only = !bytes.one_in(3);
    axial.per_spring = bytes.one_in(4);
    effects.emplace_back(std::move(axial));
    if (!bytes.one_in(3))
        effects.emplace_back(MemberWeight{bytes.magnitude(-3, 4)});
    if (bytes.one_in(2))
        effects.emplace_back(
            CoveringWeight{bytes.magnitude(-3, 4), static_cast<CornerShare>(bytes.between(0, 2))});
    if (bytes.one_in(2))
        effects.emplace_back(Snow{bytes.magnitude(-3, 5)});
    for (int left = bytes.between(0, 2); left > 0; --left)
        effects.emplace_back(PointLoad{
            ids_from(bytes, net.node_count()),
            bytes.magnitude(-3, 6) * Vector3(bytes.coordinate(), bytes.coordinate(), bytes.coordinate())});
    return effects;
}

std::optional<Eigen::VectorXd> rest_lengths_from(Bytes &bytes, const Net &net) {
    if (!bytes.one_in(3))
        return std::nullopt;
    Eigen::VectorXd lengths = net.source_lengths();
    for (double &length : lengths)
        length *= bytes.magnitude(-3, 3);
    return lengths;
}

SolveOptions options_from(Bytes &bytes, const Net &net) {
    SolveOptions options;
    options.tolerance = bytes.magnitude(-12, -1);
    options.accuracy = net.size() * bytes.magnitude(-12, 0);
    options.method = static_cast<Method>(bytes.between(0, 2));
    options.max_iterations = bytes.between(0, most_iterations);
    if (bytes.one_in(3)) {
        Points start = net.nodes();
        const double spread = net.size() * bytes.magnitude(-6, 3);
        for (Index i = 0; i < start.rows(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                start(i, axis) += spread * bytes.coordinate();
        options.start = start;
    }
    return options;
}

void check_result(const Scene &scene, const Result &result) {
    const Index nodes = scene.net().node_count();
    require(result.nodes.rows() == nodes && result.reactions.rows() == nodes &&
                result.member_forces.size() == scene.net().member_count() &&
                result.member_lengths.size() == scene.net().member_count(),
            "arrays fit the net");
    require(result.nodes.allFinite() && result.centred_nodes.allFinite() && result.reactions.allFinite() &&
                result.member_forces.allFinite() && result.member_lengths.allFinite(),
            "numbers are finite;", status_name(result.status) + (": " + result.message));
    require(result.residual >= 0, "the residual is a number");
    require(result.position_error >= 0, "the position error is a number");
    require(!result.message.empty(), "a result says why it ended");

    const double allowed = 1.001 * result.tolerance;
    const Certificate certificate = certify(scene, result.centred_nodes, &result.reactions, allowed);
    require(certificate.max_residual >= 0 && certificate.balance >= 0 && certificate.moment_balance >= 0 &&
                certificate.worst_tension >= 0,
            "the certificate is of numbers");
    require(!certificate.summary().empty(), "the certificate speaks");
    if (result.status == Status::converged)
        require(certificate.in_equilibrium, "the certificate agrees with 'converged':",
                certificate.summary() + " residual of the result: " + std::to_string(result.residual));
}

void check_same(const Result &one, const Result &other) {
    require(one.status == other.status && one.iterations == other.iterations, "slices end as one go does");
    require(one.nodes == other.nodes && one.member_forces == other.member_forces,
            "slices give the same bits");
}

void solve_from(Bytes &bytes) {
    const auto net = net_from(bytes);
    const auto effects = effects_from(bytes, *net);
    const auto scene = std::make_shared<const Scene>(net, supports_from(bytes, net->node_count()), effects,
                                                     rest_lengths_from(bytes, *net));
    const auto options = options_from(bytes, *net);
    const Result result = solve(scene, options);
    check_result(*scene, result);

    if (bytes.one_in(4)) {
        Solver sliced(scene, options);
        while (!sliced.advance(0))
            require(sliced.nodes().allFinite(), "nodes are finite on the way");
        check_same(sliced.result(), result);
    } else if (bytes.one_in(4)) {
        const auto changed = std::make_shared<const Scene>(net, supports_from(bytes, net->node_count()),
                                                           effects_from(bytes, *net));
        Solver solver(changed, options);
        for (int steps = bytes.between(0, 5); steps > 0; --steps)
            solver.advance(0);
        check_result(*changed, solver.result());
        solver.replace(scene);
        solver.advance();
        check_result(*scene, solver.result());
    }
}

} // namespace

} // namespace funicular::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    funicular::fuzz::Bytes bytes(data, size);
    try {
        funicular::fuzz::solve_from(bytes);
    } catch (const funicular::InvalidInput &error) {
        funicular::fuzz::require(error.what()[0] != '\0', "a refusal says what is wrong");
    }
    return 0;
}
