// SPDX-License-Identifier: MIT
#include "python/bindings.h"

#include "animation/morph.h"
#include "collage/suggestions.h"
#include "ifs/tops/fractal_transformation.h"
#include "notation/moments/entry_moment.h"
#include "python/arrays.h"
#include "python/interruptible.h"
#include "python/placing.h"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace python {

namespace {

namespace py = pybind11;

template <int Dim> notation::Entry conjugatedIn(notation::Entry entry, const Numbers& map) {
    auto& figure = std::get<notation::Figure<Dim>>(entry.figure);
    const ifs::AffineMap<Dim> transformation = mapFrom<Dim>(map);
    auto moved = ifs::conjugate(transformation, figure.system);
    if (!moved) throw std::invalid_argument("the transformation cannot be inverted, or hardly so");
    figure.system = *std::move(moved);
    for (auto& branch : figure.moved)
        branch.change = ifs::conjugate(transformation, branch.change).value_or(branch.change);
    return entry;
}

notation::Entry conjugated(const notation::Entry& entry, const Numbers& map) {
    return std::holds_alternative<notation::Figure<3>>(entry.figure) ? conjugatedIn<3>(entry, map)
                                                                     : conjugatedIn<2>(entry, map);
}

template <int Dim>
notation::Entry cagedIn(notation::Entry entry, const Numbers& rest, const Numbers& current, bool bend) {
    ifs::ControlCage<Dim> cage{pointsFrom<Dim>(rest, "rest"), pointsFrom<Dim>(current, "current"),
                               bend ? ifs::Deformation::Bend : ifs::Deformation::AffineFit};
    if (!ifs::isValid(cage))
        throw std::invalid_argument(
            "no cage: both lists need as many vertices, and those at rest must hold coordinates: no flat "
            "simplex and, in the plane, a simple polygon of at most 64 corners");
    std::get<notation::Figure<Dim>>(entry.figure).cage = std::move(cage);
    return entry;
}

notation::Entry caged(const notation::Entry& entry, const Numbers& rest, const Numbers& current, bool bend) {
    return std::holds_alternative<notation::Figure<3>>(entry.figure) ? cagedIn<3>(entry, rest, current, bend)
                                                                     : cagedIn<2>(entry, rest, current, bend);
}

template <int Dim>
notation::Entry withBranchIn(notation::Entry entry, const std::vector<int>& word, const Numbers& map) {
    auto& figure = std::get<notation::Figure<Dim>>(entry.figure);
    animation::BranchPose<Dim> moved{{}, mapFrom<Dim>(map)};
    for (const int symbol : word) {
        if (symbol < 1 || std::size_t(symbol) > figure.system.maps.size())
            throw std::invalid_argument("word: there is no map " + std::to_string(symbol));
        moved.word.push_back(figure.system.maps[std::size_t(symbol) - 1].id);
    }
    if (moved.word.empty() || moved.word.size() > 64)
        throw std::invalid_argument("word: from 1 to 64 numbers of maps");
    std::erase_if(figure.moved, [&](const auto& known) { return known.word == moved.word; });
    figure.moved.push_back(std::move(moved));
    return entry;
}

notation::Entry withBranch(const notation::Entry& entry, const std::vector<int>& word, const Numbers& map) {
    return std::holds_alternative<notation::Figure<3>>(entry.figure) ? withBranchIn<3>(entry, word, map)
                                                                     : withBranchIn<2>(entry, word, map);
}

template <int Dim>
ifs::IteratedFunctionSystem<Dim> morphedIn(const ifs::IteratedFunctionSystem<Dim>& from,
                                           const ifs::IteratedFunctionSystem<Dim>& to, double share) {
    constexpr int length = animation::maxLength;
    const ifs::ActiveMaps<Dim> first = ifs::activeMaps(from), second = ifs::activeMaps(to);
    requireDrawable(first);
    requireDrawable(second);
    if (first.isLinked() || second.isLinked()) throw std::invalid_argument("linked maps have no morph");
    const auto pairs = animation::correspondence<Dim>(first, second);
    if (!pairs)
        throw std::invalid_argument(
            "no morph: one of the invariant measures has no covariance, or there are more "
            "than " +
            std::to_string(animation::maxMorphMaps) + " maps");
    const animation::Morph<Dim> morph = animation::morph<Dim>(first, second, *pairs, length);
    const auto frame = std::int64_t(std::llround(share * length));
    return morph.animation.at(animation::moment(frame), animation::Pose<Dim>{morph.system}).system;
}

notation::Entry morphed(const notation::Entry& from, const notation::Entry& to, double share) {
    if (!(share >= 0 && share <= 1)) throw std::invalid_argument("share: from 0 to 1");
    notation::Entry result;
    result.name = from.name;
    result.appearance = from.appearance;
    result.appearance.mapColours = {};
    result.appearance.mapBlends = {};
    if (std::holds_alternative<notation::Figure<3>>(from.figure))
        result.figure =
            notation::Figure<3>{morphedIn<3>(figureIn<3>(from).system, figureIn<3>(to).system, share)};
    else
        result.figure =
            notation::Figure<2>{morphedIn<2>(figureIn<2>(from).system, figureIn<2>(to).system, share)};
    return result;
}

// Images of points of one attractor in the other; NaN for what lies on no attractor.
py::array tops(const notation::Entry& from, const notation::Entry& to, const Numbers& points) {
    const auto given = pointsFrom<2>(points, "points");
    std::vector<double> images(2 * given.size(), NAN);
    interruptibly([&](const std::stop_token& stop) {
        const auto target = ifs::activeMaps(figureIn<2>(to).system);
        requireDrawable(target);
        ifs::SupportFunction<2> attractor = supportOf(figureIn<2>(from).system);
        if (attractor.maps().size() != target.maps.size())
            throw std::invalid_argument("both entries need the same number of maps that take part");
        const ifs::FractalTransformation transformation(std::move(attractor), target.maps);
        for (std::size_t i = 0; i < given.size() && !stop.stop_requested(); ++i)
            if (const auto image = transformation.at(given[i]).image)
                std::copy_n(image->data(), 2, images.begin() + std::ptrdiff_t(2 * i));
    });
    return arrayOf(std::move(images), {py::ssize_t(given.size()), 2});
}

// Systems whose attractors look like the mask, best first: maps, weights.
py::list fit(const pybind11::array_t<std::uint8_t, pybind11::array::c_style>& mask,
             const std::array<int, 2>& maps, double seconds, std::size_t starts, std::uint64_t seed,
             int threads) {
    const auto [least, most] = maps;
    if (mask.ndim() != 2 || mask.size() == 0)
        throw std::invalid_argument("mask: the shape must be (rows, columns)");
    if (least < 1 || most < least || most > 32) throw std::invalid_argument("maps: from 1 to 32");
    collage::Mask shape = collage::emptyMask(int(mask.shape(1)), int(mask.shape(0)));
    std::copy_n(mask.data(), mask.size(), shape.cells.begin());
    if (collage::area(shape) == 0) throw std::invalid_argument("mask: nothing is in it");
    collage::SearchOptions options;
    options.minMaps = least;
    options.maxMaps = most;
    options.seed = seed;
    options.starts = starts;
    options.time = std::chrono::duration<double>(seconds);
    options.threads = threads;
    collage::Suggestions found;
    interruptibly(
        [&](const std::stop_token& stop) { found = collage::suggestions(shape, options, {}, stop); });
    py::list list;
    for (const collage::Suggestion& each : found.list)
        list.append(py::make_tuple(arrayOf(std::span<const ifs::AffineMap<2>>(each.maps)),
                                   Numbers(py::ssize_t(each.weights.size()), each.weights.data())));
    return list;
}

// (frames to draw, the last frame, frames, seconds, loop); None where nothing moves.
py::object animationFacts(const notation::Entry& entry) {
    const auto facts = notation::animationFacts(entry);
    if (!facts && notation::isAnimated(entry))
        throw std::invalid_argument("the animation of this entry is not understood, or does not fit its maps "
                                    "and its cage");
    if (!facts) return py::none();
    return py::make_tuple(animation::frameCount(facts->loop, facts->length),
                          animation::lastFrame(facts->loop, facts->length), facts->rate.frames,
                          facts->rate.seconds, ifs::nameOf(facts->loop));
}

notation::Entry at(const notation::Entry& entry, std::int64_t numerator, std::int64_t denominator) {
    return notation::atMoment(entry, animation::moment(numerator, denominator));
}

} // namespace

void bindChanges(py::module_& core) {
    core.def("conjugated", &conjugated);
    core.def("caged", &caged);
    core.def("with_branch", &withBranch);
    core.def("morphed", &morphed);
    core.def("animation_facts", &animationFacts);
    core.def("at", &at);
    core.def("tops", &tops);
    core.def("fit", &fit);
}

} // namespace python
