// SPDX-License-Identifier: MIT
#include "document/fractal.h"

#include "attractor/address_cut.h"
#include "ifs/support_function.h"

#include <cmath>

namespace document {

namespace {

// Looser than rounding, so that a slowly contracting code does not keep the user waiting for digits nobody
// sees.
constexpr double relativeTolerance = 1e-10;

std::optional<ifs::SupportFunction<2>> supportFunction(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return std::nullopt;
    return ifs::SupportFunction<2>::of(ifs::activeMaps(*system).maps);
}

// Of the words of a fine cut, in the smallest picture that holds the current vertices with room to spare.
std::optional<Box> boxOfBend(const Fractal& fractal, const ifs::Placement& placement) {
    ifs::Vector<2> low = fractal.cage->current[0];
    ifs::Vector<2> high = low;
    for (const ifs::Vector<2>& vertex : fractal.cage->current) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const attractor::DrawableSystem system = attractor::drawable(*system2(fractal));
    attractor::Camera camera;
    camera.width = camera.height = 1000;
    camera = attractor::fitted(camera, low, high, 0.3);
    attractor::CutSettings settings;
    settings.words = 4096;
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

ifs::Placement placement(const Fractal& fractal) {
    if (!fractal.cage || !ifs::isValid(*fractal.cage)) return {};
    if (!ifs::bends(*fractal.cage)) return ifs::displayMap(*fractal.cage);
    const auto support = supportFunction(fractal);
    return {*fractal.cage, ifs::suitableCoordinates(fractal.cage->rest, support ? &*support : nullptr)};
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
    request.appearance = fractal.appearance;
    request.camera = camera;
    return request;
}

std::optional<Box> displayedBox(const Fractal& fractal) {
    const auto support = supportFunction(fractal);
    if (!support) return std::nullopt;
    const ifs::Placement placed = placement(fractal);
    if (placed.bend() != nullptr) return boxOfBend(fractal, placed);
    const ifs::AffineMap<2>& display = placed.affine();
    // h_{M(A)}(u) = h_A(Mᵀu) + ⟨u, t⟩
    const auto extent = [&](const ifs::Vector<2>& u) {
        const ifs::Vector<2> pulledBack = display.linear.transpose() * u;
        const auto h = (*support)(pulledBack, relativeTolerance * support->radius() * pulledBack.norm());
        return h.value + h.error + u.dot(display.translation);
    };
    const Box box{{-extent({-1, 0}), -extent({0, -1})}, {extent({1, 0}), extent({0, 1})}};
    if (!box.min.allFinite() || !box.max.allFinite()) return std::nullopt;
    return box;
}

} // namespace document
