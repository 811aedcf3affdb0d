// SPDX-License-Identifier: MIT
#include "python/placing.h"

#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_system.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"

#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace python {

namespace {

// As loose as in the window: digits that nobody sees may take long.
constexpr double viewTolerance = 1e-10;

// The number of a map in its list, from 1.
template <int Dim> std::string wordText(const ifs::ActiveMaps<Dim>& active, const std::vector<int>& word) {
    std::string text;
    for (const int symbol : word) {
        if (!text.empty()) text += ' ';
        const auto at = std::size_t(symbol);
        const std::size_t copies = active.index.empty() ? 1 : active.maps.size() / active.index.size();
        text += std::to_string(at / copies < active.index.size() ? active.index[at / copies] + 1 : at + 1);
    }
    return text;
}

template <int Dim> ifs::Existence existenceOf(const ifs::ActiveMaps<Dim>& active) {
    if (active.isLinked()) return ifs::classifyLinked<Dim>(active);
    return ifs::classify<Dim>(active.maps);
}

} // namespace

template <int Dim> const notation::Figure<Dim>& figureIn(const notation::Entry& entry) {
    if (const auto* figure = std::get_if<notation::Figure<Dim>>(&entry.figure)) return *figure;
    throw std::invalid_argument(
        Dim == 2 ? "this needs an entry in the plane, and “" + entry.name + "” is one in space"
                 : "this needs an entry in space, and “" + entry.name + "” is one in the plane");
}
template const notation::Figure<2>& figureIn(const notation::Entry&);
template const notation::Figure<3>& figureIn(const notation::Entry&);

template <int Dim> void requireDrawable(const ifs::ActiveMaps<Dim>& active) {
    const ifs::Existence existence = existenceOf(active);
    if (existence.verdict == ifs::Verdict::Empty)
        throw std::invalid_argument("the system has no attractor: no map takes part");
    if (existence.verdict == ifs::Verdict::None)
        throw std::invalid_argument(
            "the system has no attractor: the maps applied in the order " +
            wordText(active, existence.witness) +
            " (outermost first) do not contract, as their spectral radius is at least 1");
}
template void requireDrawable(const ifs::ActiveMaps<2>&);
template void requireDrawable(const ifs::ActiveMaps<3>&);

template <int Dim> ifs::SupportFunction<Dim> supportOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    if (active.isLinked())
        throw std::invalid_argument(
            "the maps of this system are linked, which this function does not know of");
    if (auto support = ifs::SupportFunction<Dim>::of(active.maps)) return *std::move(support);
    requireDrawable(active);
    throw std::invalid_argument(
        "it is not known whether the system has an attractor, or it contracts too slowly "
        "to be measured");
}
template ifs::SupportFunction<2> supportOf(const ifs::IteratedFunctionSystem<2>&);
template ifs::SupportFunction<3> supportOf(const ifs::IteratedFunctionSystem<3>&);

ifs::BoundingBox<2> boxOfAttractor(const ifs::IteratedFunctionSystem<2>& system) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    if (!active.isLinked()) return ifs::boundingBox(supportOf(system));
    if (const auto linked = ifs::LinkedExtent::of(active, ifs::classifyLinked<2>(active)))
        return ifs::boundingBox(*linked);
    requireDrawable(active);
    throw std::invalid_argument(
        "it is not known whether the system has an attractor, or it contracts too slowly "
        "to be measured");
}

ifs::BoundingBox<3> boxOfAttractor(const ifs::IteratedFunctionSystem<3>& system) {
    return ifs::boundingBox(supportOf(system));
}

ifs::Placement placementOf(const notation::Figure<2>& figure) {
    if (!figure.cage || !ifs::isValid(*figure.cage)) return {};
    if (!ifs::bends(*figure.cage)) return ifs::displayMap(*figure.cage);
    const auto support = ifs::SupportFunction<2>::of(ifs::activeMaps(figure.system).maps);
    return {*figure.cage, ifs::suitableCoordinates(figure.cage->rest, support ? &*support : nullptr)};
}

attractor::RenderRequest requestOf(const notation::Entry& entry, int width, int height) {
    const notation::Figure<2>& figure = figureIn<2>(entry);
    attractor::RenderRequest request;
    request.system = figure.system;
    request.cage = figure.cage;
    request.moved = notation::movedBranches(figure.system, figure.moved);
    request.appearance = entry.appearance;
    // No shadow: its ground is the lowest line of the picture, which is known only with a window.
    request.appearance.shadow = 0;
    request.camera.width = width;
    request.camera.height = height;
    return request;
}

attractor::Camera cameraAround(const notation::Entry& entry, attractor::Camera camera) {
    const notation::Figure<2>& figure = figureIn<2>(entry);
    const ifs::Placement placement = placementOf(figure);
    const ifs::ActiveMaps<2> active = ifs::activeMaps(figure.system);
    if (placement.bend() == nullptr && !active.isLinked()) {
        const ifs::SupportFunction<2> support = supportOf(figure.system);
        std::vector<ifs::AffineMap<2>> images(1);
        const auto moved =
            ifs::overMaps<2>(notation::movedBranches(figure.system, figure.moved), active.index);
        if (!moved.empty())
            images = ifs::pieceMaps<2>(ifs::pieces<2>(moved, active.maps.size()), active.maps);
        for (ifs::AffineMap<2>& image : images)
            image = placement.affine() * image;
        const auto box = ifs::boundingBoxOfImages<2>(images, support, viewTolerance * support.radius());
        const ifs::Vector<2> error = ifs::Vector<2>::Constant(box.error);
        return attractor::fitted(camera, box.min - error, box.max + error);
    }
    const ifs::BoundingBox<2> plain = boxOfAttractor(figure.system);
    if (placement.bend() == nullptr && figure.moved.empty() && placement.affine() == ifs::AffineMap<2>{})
        return attractor::fitted(camera, plain.min, plain.max);
    constexpr int looks = 100'000;
    const attractor::PreparedSystem system =
        attractor::prepared(figure.system, notation::movedBranches(figure.system, figure.moved));
    attractor::Orbit orbit(system, 1);
    ifs::Vector<2> low = placement(orbit.next().x), high = low;
    for (int i = 1; i < looks; ++i) {
        const ifs::Vector<2> x = placement(orbit.next().x);
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return attractor::fitted(camera, low, high);
}

} // namespace python
