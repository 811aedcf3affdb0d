// SPDX-License-Identifier: MIT
#include "document/fractal.h"

#include "attractor/address_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <mutex>
#include <utility>

namespace document {

namespace {

// Looser than rounding, so that a slowly contracting code does not keep the user waiting for digits nobody
// sees.
constexpr double relativeTolerance = 1e-10;

// change∘w_word for every piece of what is shown, in coordinates of the code.
std::vector<ifs::AffineMap<2>> shownPieces(const Fractal& fractal) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*system2(fractal));
    const auto moved = ifs::overMaps<2>(movedBranches(fractal), active.index);
    return ifs::pieceMaps<2>(ifs::pieces<2>(moved, active.maps.size()), active.maps);
}

// Of the words of a fine cut, in the smallest picture that holds the current vertices with room to spare.
std::optional<Box> boxOfBend(const Fractal& fractal, const ifs::Placement& placement) {
    ifs::Vector<2> low = fractal.cage->current[0];
    ifs::Vector<2> high = low;
    for (const ifs::Vector<2>& vertex : fractal.cage->current) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const attractor::DrawableSystem system = attractor::drawable(*system2(fractal), movedBranches(fractal));
    attractor::Camera camera;
    camera.width = camera.height = 1000;
    camera = attractor::fitted(camera, low, high, 0.3);
    attractor::CutSettings settings;
    settings.words = 4096;
    settings.mostLooks = 1U << 19; // a window waits for the box
    const auto cut = attractor::addressCut(system, attractor::projection(camera, placement, 1), settings);
    if (cut.words.empty()) return std::nullopt;
    ifs::Vector<2> first = ifs::Vector<2>::Constant(camera.width);
    ifs::Vector<2> last = ifs::Vector<2>::Zero();
    for (const attractor::Word& word : cut.words) {
        const ifs::Vector<2> middle(word.x, word.y);
        const ifs::Vector<2> half(std::abs(word.xx) + std::abs(word.xy),
                                  std::abs(word.yx) + std::abs(word.yy));
        first = first.cwiseMin(middle - half);
        last = last.cwiseMax(middle + half);
    }
    const ifs::Vector<2> a = attractor::toWorld(camera, first);
    const ifs::Vector<2> b = attractor::toWorld(camera, last);
    return Box{a.cwiseMin(b), a.cwiseMax(b)};
}

} // namespace

std::shared_ptr<const ifs::SupportFunction<2>> supportFunction(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return nullptr;
    const auto computed = [&]() -> std::shared_ptr<const ifs::SupportFunction<2>> {
        auto support = ifs::SupportFunction<2>::of(ifs::activeMaps(*system).maps);
        return support ? std::make_shared<const ifs::SupportFunction<2>>(*std::move(support)) : nullptr;
    };
    constexpr std::size_t few = 256; // maps, for which comparing is hardly worth it
    if (system->maps.size() <= few) return computed();
    struct Known {
        System2 system;
        std::shared_ptr<const ifs::SupportFunction<2>> support;
    };
    static std::mutex mutex;
    static std::array<Known, 4> newest;
    const auto known = [&]() -> Known* {
        const auto found = std::ranges::find(newest, *system, &Known::system);
        return found == newest.end() ? nullptr : &*found;
    };
    {
        const std::lock_guard lock(mutex);
        if (const Known* found = known()) return found->support;
    }
    const auto support = computed();
    const std::lock_guard lock(mutex);
    if (!known()) {
        std::rotate(newest.begin(), std::prev(newest.end()), newest.end());
        newest.front() = {*system, support};
    }
    return support;
}

ifs::Placement placement(const Fractal& fractal) {
    if (!fractal.cage || !ifs::isValid(*fractal.cage)) return {};
    if (!ifs::bends(*fractal.cage)) return ifs::displayMap(*fractal.cage);
    const auto support = supportFunction(fractal);
    std::vector<ifs::AffineMap<2>> pieces;
    if (support && !fractal.moved.empty()) pieces = shownPieces(fractal);
    return {*fractal.cage, ifs::suitableCoordinates(fractal.cage->rest, support.get(), pieces)};
}

std::vector<ifs::MovedBranch<2>> movedBranches(const Fractal& fractal) {
    std::vector<ifs::MovedBranch<2>> result;
    const System2* system = system2(fractal);
    if (system == nullptr) return result;
    std::vector<std::pair<ifs::MapId, int>> places; // of the maps that are named
    for (const MovedBranch& branch : fractal.moved)
        for (const ifs::MapId id : branch.word)
            places.emplace_back(id, -1);
    std::ranges::sort(places);
    const auto placeOf = [&](ifs::MapId id) {
        const auto place = std::ranges::lower_bound(places, id, {}, &std::pair<ifs::MapId, int>::first);
        return place != places.end() && place->first == id ? &place->second : nullptr;
    };
    for (std::size_t place = 0; !places.empty() && place < system->maps.size(); ++place)
        if (int* known = placeOf(system->maps[place].id)) *known = int(place);
    for (const auto& [word, change] : fractal.moved) {
        ifs::MovedBranch<2> branch{{}, change};
        for (const ifs::MapId id : word)
            if (const int place = *placeOf(id); place >= 0) branch.word.push_back(place);
        if (branch.word.size() == word.size()) result.push_back(std::move(branch));
    }
    return result;
}

std::optional<Fractal> conjugated(const Fractal& fractal, const ifs::AffineMap<2>& transformation) {
    const System2* system = system2(fractal);
    auto moved = system ? ifs::conjugate(transformation, *system) : std::nullopt;
    if (!moved) return std::nullopt;
    Fractal result = fractal;
    result.system = *std::move(moved);
    for (MovedBranch& branch : result.moved)
        branch.change = ifs::conjugate(transformation, branch.change).value_or(branch.change);
    return result;
}

namespace {

// Numbers that rounding has left where there should be none would stand in the table, and in the file.
void dropRounding(System2& system) {
    constexpr double rounding = 1e-15;
    const auto clean = [](auto& numbers, double size) {
        numbers =
            numbers.unaryExpr([size](double x) { return std::abs(x) <= rounding * size ? 0 : x; }).eval();
    };
    double reach = 0;
    for (const auto& map : system.maps)
        reach = std::max(reach, map.map.translation.cwiseAbs().maxCoeff());
    for (auto& map : system.maps) {
        clean(map.map.linear, map.map.linear.cwiseAbs().maxCoeff());
        clean(map.map.translation, reach);
    }
}

} // namespace

std::optional<Fractal> withCageBaked(const Fractal& fractal) {
    if (system2(fractal) == nullptr || !fractal.cage) return std::nullopt;
    const auto baked = ifs::bake(*system2(fractal), *fractal.cage);
    auto result = baked ? conjugated(fractal, ifs::displayMap(*fractal.cage)) : std::nullopt;
    if (!result) return std::nullopt;
    System2 system = baked->system;
    dropRounding(system);
    result->system = std::move(system);
    result->cage = baked->cage;
    return result;
}

ifs::ControlCage<2> effectiveCage(const Fractal& fractal) {
    if (fractal.cage) return *fractal.cage;
    if (const auto support = supportFunction(fractal))
        return ifs::cageAtRest(
            ifs::minimalCanonicalSimplex(*support, relativeTolerance * support->radius()).vertices);
    return ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)});
}

std::optional<System2> effectiveSystem(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return std::nullopt;
    if (!fractal.cage || fractal.cage->rest == fractal.cage->current) return *system;
    if (ifs::bends(*fractal.cage)) return std::nullopt;
    return ifs::conjugate(ifs::displayMap(*fractal.cage), *system);
}

attractor::RenderRequest renderRequest(const Fractal& fractal, const attractor::Camera& camera) {
    attractor::RenderRequest request;
    if (const System2* system = system2(fractal)) request.system = *system;
    request.cage = fractal.cage;
    request.moved = movedBranches(fractal);
    request.appearance = fractal.appearance;
    request.camera = camera;
    return request;
}

std::optional<Box> displayedBox(const Fractal& fractal) {
    const auto support = supportFunction(fractal);
    if (!support) return std::nullopt;
    const ifs::Placement placed = placement(fractal);
    if (placed.bend() != nullptr) return boxOfBend(fractal, placed);
    const std::vector<ifs::AffineMap<2>> pieces =
        fractal.moved.empty() ? std::vector<ifs::AffineMap<2>>(1) : shownPieces(fractal);
    // h_{M(A)}(u) = h_A(Mᵀu) + ⟨u, t⟩
    const auto extent = [&](const ifs::Vector<2>& u) {
        double farthest = -HUGE_VAL;
        for (const ifs::AffineMap<2>& piece : pieces) {
            const ifs::AffineMap<2> display = placed.affine() * piece;
            const ifs::Vector<2> pulledBack = display.linear.transpose() * u;
            const auto h = (*support)(pulledBack, relativeTolerance * support->radius() * pulledBack.norm());
            farthest = std::max(farthest, h.value + h.error + u.dot(display.translation));
        }
        return farthest;
    };
    const Box box{{-extent({-1, 0}), -extent({0, -1})}, {extent({1, 0}), extent({0, 1})}};
    if (!box.min.allFinite() || !box.max.allFinite()) return std::nullopt;
    return box;
}

} // namespace document
