// SPDX-License-Identifier: MIT
#include "attractor/samples/prepared_space.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/samples/finite_maps.h"
#include "attractor/samples/prepared_system.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/support_function.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace attractor {

namespace {

using ifs::Vector;

struct Box {
    Vector<3> min = Vector<3>::Constant(HUGE_VAL);
    Vector<3> max = Vector<3>::Constant(-HUGE_VAL);
};

// The box of a short orbit with a guard against escape.
Box pilotBox(const PreparedSpace& system) {
    constexpr int points = 4000;
    constexpr int skipped = 100;
    std::vector<double> cumulative;
    std::partial_sum(system.probabilities.begin(), system.probabilities.end(),
                     std::back_inserter(cumulative));
    const Vector<3> start = ifs::fixedPoint(system.maps.front()).value_or(Vector<3>::Zero());
    double reach = 0;
    for (const ifs::AffineMap<3>& map : system.maps)
        reach = std::max(reach, (map(start) - start).cwiseAbs().maxCoeff());
    Box box;
    Vector<3> x = start;
    for (int n = 0; n < points; ++n) {
        const double u = static_cast<double>(mixed(static_cast<std::uint64_t>(n)) >> 11) * 0x1p-53;
        const auto i =
            std::ranges::upper_bound(cumulative.begin(), cumulative.end() - 1, u) - cumulative.begin();
        x = system.maps[static_cast<std::size_t>(i)](x);
        if (!((x - start).cwiseAbs().maxCoeff() <= 1e3 * reach)) x = start;
        if (n < skipped) continue;
        box.min = box.min.cwiseMin(x);
        box.max = box.max.cwiseMax(x);
    }
    return box;
}

void placeBox(PreparedSpace& system) {
    constexpr double fine = 1e-4; // relative tolerance
    Box box;
    double slack = 1e-5; // relative extent that flat sets get
    const auto support = system.note == RenderNote::None ? ifs::SupportFunction<3>::of(system.maps)
                                                         : std::optional<ifs::SupportFunction<3>>();
    if (support) {
        const ifs::BoundingBox<3> certified = ifs::boundingBox(*support, fine * support->radius());
        const Vector<3> error = Vector<3>::Constant(certified.error);
        box = {certified.min - error, certified.max + error};
        system.isCertified = box.min.allFinite() && box.max.allFinite();
    }
    if (!system.isCertified) {
        box = pilotBox(system);
        slack = 0.5;
    }
    system.centre = (box.min + box.max) / 2;
    system.halfExtent = (box.max - box.min) / 2;
    const double size = system.halfExtent.maxCoeff();
    const double distance = system.centre.cwiseAbs().maxCoeff();
    if (!system.centre.allFinite() || !std::isfinite(size)) {
        system.centre = Vector<3>::Zero();
        system.halfExtent = Vector<3>::Ones();
        return;
    }
    system.halfExtent += Vector<3>::Constant(slack * size + 1e-12 * distance + 1e-300);
    if (!(size > 0)) system.halfExtent = Vector<3>::Constant(1e-9 + 1e-12 * distance);
}

} // namespace

ifs::AffineMap<3> PreparedSpace::inBox(const ifs::AffineMap<3>& map) const {
    ifs::AffineMap<3> result;
    result.linear = halfExtent.cwiseInverse().asDiagonal() * map.linear * halfExtent.asDiagonal();
    result.translation = (map(centre) - centre).cwiseQuotient(halfExtent);
    return result;
}

ifs::AffineMap<3> PreparedSpace::fromBox() const {
    return {halfExtent.asDiagonal(), centre};
}

std::vector<PreparedSpace::Piece> PreparedSpace::pieces() const {
    std::vector<Piece> result;
    for (auto& [word, change] : ifs::pieces<3>(moved, maps.size())) {
        Piece piece{{}, {}, !(change == ifs::AffineMap<3>())};
        if (piece.isMoved) piece.map = inBox(change);
        for (const int letter : word)
            piece.map = piece.map * inBox(maps[static_cast<std::size_t>(letter)]);
        piece.word = std::move(word);
        result.push_back(std::move(piece));
    }
    return result;
}

PreparedSpace preparedSpace(const ifs::IteratedFunctionSystem<3>& system,
                            std::span<const ifs::MovedBranch<3>> moved) {
    PreparedSpace result{finiteMaps(system)};
    result.moved = ifs::overMaps<3>(moved, result.index);
    if (result.maps.empty()) {
        result.note = RenderNote::NoMaps;
        return result;
    }
    double meanLogarithm = 0;
    for (std::size_t i = 0; i < result.maps.size(); ++i)
        meanLogarithm +=
            result.probabilities[i] * naturalLogarithm(ifs::spectralNorm<3>(result.maps[i].linear));
    const ifs::Existence existence = ifs::classify<3>(result.maps, 2000);
    result.note = existenceNote(existence.verdict);
    result.contracts = result.note == RenderNote::None || meanLogarithm < 0;
    placeBox(result);
    return result;
}

BoxMaps::BoxMaps(const PreparedSpace& system) {
    constexpr std::size_t multiple = 16;
    const std::size_t padded = (system.maps.size() + multiple - 1) / multiple * multiple;
    for (auto& array : coefficients)
        array.assign(padded, 0);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const ifs::AffineMap<3> map = system.inBox(system.maps[i]);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                coefficients[static_cast<std::size_t>(3 * row + column)][i] =
                    static_cast<float>(map.linear(row, column));
            coefficients[static_cast<std::size_t>(9 + row)][i] = static_cast<float>(map.translation[row]);
        }
    }
}

} // namespace attractor
