// SPDX-License-Identifier: MIT
#include "document/fractal.h"

#include "ifs/support_function.h"

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

} // namespace

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
    if (fractal.cage->rest.size() != 3) return std::nullopt;
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
    ifs::AffineMap<2> display;
    if (fractal.cage && fractal.cage->rest != fractal.cage->current) {
        if (fractal.cage->rest.size() != 3) return std::nullopt;
        display = ifs::displayMap(*fractal.cage);
    }
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
