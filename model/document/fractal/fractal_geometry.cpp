// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"

#include "attractor/cut/address_cut.h"
#include "attractor/request/shadow.h"
#include "ifs/extent/extent.h"
#include "ifs/links/linked_existence.h"
#include "notation/value/entry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace document {

namespace {

// Looser than rounding, so that a slowly contracting code does not keep the user waiting for digits nobody
// sees.
constexpr double relativeTolerance = 1e-10;

// The box of the words of a fine cut, in the smallest picture that holds the current vertices with room to
// spare.
std::optional<Box> boxOfBend(const Fractal& fractal, const ifs::Placement& placement,
                             const std::vector<ifs::Vector<2>>& vertices) {
    ifs::Vector<2> low = vertices[0];
    ifs::Vector<2> high = low;
    for (const ifs::Vector<2>& vertex : vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const attractor::PreparedSystem system = attractor::prepared(*system2(fractal), movedBranches(fractal));
    attractor::Camera camera;
    camera.width = camera.height = 1000;
    camera = attractor::fitted(camera, low, high, 0.3);
    attractor::CutSettings settings;
    settings.words = 4096;
    settings.maxLooks = 1U << 19; // limit, because a window waits for the box
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
    return system ? fractal.supports.support(*system) : nullptr;
}

std::optional<ifs::LinkedExtent> linkedExtent(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (!system || system->links.empty()) return std::nullopt;
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*system);
    return active.isLinked() ? ifs::LinkedExtent::of(active, ifs::classifyLinked<2>(active)) : std::nullopt;
}

ifs::Placement placement(const Fractal& fractal) {
    const ifs::ControlCage<2>* cage = cage2(fractal);
    if (!cage || !ifs::isValid(*cage)) return {};
    if (!ifs::bends(*cage)) return ifs::displayMap(*cage);
    const auto support = supportFunction(fractal);
    std::vector<ifs::AffineMap<2>> pieces;
    if (support && !plane(fractal)->moved.empty()) pieces = shownPieces(*plane(fractal));
    return {*cage, ifs::suitableCoordinates(cage->rest, support.get(), pieces)};
}

template <int Dim> std::vector<ifs::MovedBranch<Dim>> movedBranches(const Shape<Dim>& shape) {
    return notation::movedBranches(shape.system, shape.moved);
}
template std::vector<ifs::MovedBranch<2>> movedBranches(const Shape<2>&);
template std::vector<ifs::MovedBranch<3>> movedBranches(const Shape<3>&);

template <int Dim>
std::vector<ifs::MovedBranch<Dim>> shownBranches(const Shape<Dim>& shape,
                                                 const ifs::ActiveMaps<Dim>& active) {
    if (shape.moved.empty() || active.maps.empty()) return {};
    const auto moved = ifs::overMaps<Dim>(movedBranches(shape), active.index);
    return moved.empty() ? moved : ifs::pieces<Dim>(moved, active.maps.size());
}
template std::vector<ifs::MovedBranch<2>> shownBranches(const Shape<2>&, const ifs::ActiveMaps<2>&);
template std::vector<ifs::MovedBranch<3>> shownBranches(const Shape<3>&, const ifs::ActiveMaps<3>&);

template <int Dim> std::vector<ifs::AffineMap<Dim>> shownPieces(const Shape<Dim>& shape) {
    if (shape.moved.empty()) return std::vector<ifs::AffineMap<Dim>>(1);
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(shape.system);
    const auto branches = shownBranches(shape, active);
    if (branches.empty()) return std::vector<ifs::AffineMap<Dim>>(1);
    return ifs::pieceMaps<Dim>(branches, active.maps);
}
template std::vector<ifs::AffineMap<2>> shownPieces(const Shape<2>&);
template std::vector<ifs::AffineMap<3>> shownPieces(const Shape<3>&);

std::vector<ifs::MovedBranch<2>> movedBranches(const Fractal& fractal) {
    const Shape<2>* shape = plane(fractal);
    return shape ? movedBranches(*shape) : std::vector<ifs::MovedBranch<2>>{};
}

template <int Dim>
std::optional<Fractal> conjugated(const Fractal& fractal, const ifs::AffineMap<Dim>& transformation) {
    const auto* shape = std::get_if<Shape<Dim>>(&fractal.shape);
    auto moved = shape ? ifs::conjugate(transformation, shape->system) : std::nullopt;
    if (!moved) return std::nullopt;
    Fractal result = fractal;
    auto& after = std::get<Shape<Dim>>(result.shape);
    after.system = *std::move(moved);
    for (MovedBranch<Dim>& branch : after.moved)
        branch.change = ifs::conjugate(transformation, branch.change).value_or(branch.change);
    return result;
}
template std::optional<Fractal> conjugated(const Fractal&, const ifs::AffineMap<2>&);
template std::optional<Fractal> conjugated(const Fractal&, const ifs::AffineMap<3>&);

ifs::ControlCage<2> canonicalCage(const Fractal& fractal) {
    if (const auto support = supportFunction(fractal))
        return ifs::cageAtRest(
            ifs::minimalCanonicalSimplex(*support, relativeTolerance * support->radius()).vertices);
    if (const auto linked = linkedExtent(fractal))
        return ifs::cageAtRest(ifs::minimalCanonicalSimplex(*linked).vertices);
    return ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)});
}

ifs::ControlCage<2> effectiveCage(const Fractal& fractal) {
    const ifs::ControlCage<2>* stored = cage2(fractal);
    if (!stored) stored = fractal.lasting.plane();
    return stored ? *stored : canonicalCage(fractal);
}

template <int Dim> std::optional<ifs::IteratedFunctionSystem<Dim>> effectiveSystem(const Fractal& fractal) {
    const auto* shape = std::get_if<Shape<Dim>>(&fractal.shape);
    if (!shape) return std::nullopt;
    if (!shape->cage || shape->cage->rest == shape->cage->current) return shape->system;
    if (ifs::bends(*shape->cage)) return std::nullopt;
    return ifs::conjugate(ifs::displayMap(*shape->cage), shape->system);
}
template std::optional<System2> effectiveSystem<2>(const Fractal&);
template std::optional<System3> effectiveSystem<3>(const Fractal&);

template <int Dim> std::optional<ifs::SupportFunction<Dim>> displayedSupport(const Fractal& fractal) {
    const auto system = effectiveSystem<Dim>(fractal);
    return system ? ifs::SupportFunction<Dim>::of(ifs::activeMaps(*system).maps) : std::nullopt;
}
template std::optional<ifs::SupportFunction<2>> displayedSupport<2>(const Fractal&);
template std::optional<ifs::SupportFunction<3>> displayedSupport<3>(const Fractal&);

attractor::RenderRequest renderRequest(const Fractal& fractal, const attractor::Camera& camera) {
    attractor::RenderRequest request;
    if (const Shape<2>* shape = plane(fractal)) {
        request.system = shape->system;
        request.cage = shape->cage;
    }
    request.moved = movedBranches(fractal);
    request.appearance = fractal.appearance;
    request.shadow = shadowMap(fractal, camera.yAxis);
    request.camera = camera;
    return request;
}

namespace {

// The box of the picture moved by `map`.
std::optional<Box> boxOf(const Fractal& fractal, const ifs::AffineMap<2>& map) {
    const auto support = supportFunction(fractal);
    const auto linked = linkedExtent(fractal);
    if (!support && !linked) return std::nullopt;
    const auto height = [&](const ifs::Vector<2>& u) {
        if (linked) {
            const auto h = (*linked)(u, relativeTolerance * linked->radius() * u.norm());
            return h.value + h.error;
        }
        const auto h = (*support)(u, relativeTolerance * support->radius() * u.norm());
        return h.value + h.error;
    };
    const ifs::Placement placed = placement(fractal);
    if (placed.bend() != nullptr) {
        const ifs::ControlCage<2> cage = attractor::movedCage(*cage2(fractal), map);
        return boxOfBend(fractal, {cage, placed.bend()->coordinates()}, cage.current);
    }
    const std::vector<ifs::AffineMap<2>> pieces = shownPieces(*plane(fractal));
    // h_{M(A)}(u) = h_A(Mᵀu) + ⟨u, t⟩
    const auto extent = [&](const ifs::Vector<2>& u) {
        double farthest = -HUGE_VAL;
        for (const ifs::AffineMap<2>& piece : pieces) {
            const ifs::AffineMap<2> display = map * placed.affine() * piece;
            farthest =
                std::max(farthest, height(display.linear.transpose() * u) + u.dot(display.translation));
        }
        return farthest;
    };
    const Box box{{-extent({-1, 0}), -extent({0, -1})}, {extent({1, 0}), extent({0, 1})}};
    if (!box.min.allFinite() || !box.max.allFinite()) return std::nullopt;
    return box;
}

} // namespace

std::optional<Box> displayedBox(const Fractal& fractal) {
    return boxOf(fractal, {});
}

std::optional<ifs::AffineMap<2>> shadowMap(const Fractal& fractal, attractor::YAxis yAxis) {
    if (!(fractal.appearance.shadow > 0) || !plane(fractal)) return std::nullopt;
    const auto box = displayedBox(fractal);
    if (!box) return std::nullopt;
    const double ground = yAxis == attractor::YAxis::Up ? box->min.y() : box->max.y();
    return attractor::shadowMap(fractal.appearance, ground, yAxis);
}

std::optional<Box> boxWithShadow(const Fractal& fractal, attractor::YAxis yAxis) {
    std::optional<Box> box = displayedBox(fractal);
    const auto map = box ? shadowMap(fractal, yAxis) : std::nullopt;
    const auto fallen = map ? boxOf(fractal, *map) : std::nullopt;
    if (!fallen) return box;
    return Box{box->min.cwiseMin(fallen->min), box->max.cwiseMax(fallen->max)};
}

} // namespace document
