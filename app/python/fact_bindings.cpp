// SPDX-License-Identifier: MIT
#include "python/bindings.h"

#include "ifs/dimension/dimension.h"
#include "ifs/dimension/moments.h"
#include "ifs/extent/address_search.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/convex_hull_3d.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"
#include "python/arrays.h"
#include "python/interruptible.h"
#include "python/placing.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace python {

namespace {

namespace py = pybind11;

template <class Work> py::object inItsDimension(const notation::Entry& entry, const Work& work) {
    if (const auto* plane = std::get_if<notation::Figure<2>>(&entry.figure)) return work(plane->system);
    return work(figureIn<3>(entry).system);
}

// Indices into the maps, from 1, as people count them.
template <int Dim>
std::vector<int> counted(const ifs::IteratedFunctionSystem<Dim>& system, const std::vector<int>& word) {
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    const std::size_t copies = ifs::copiesOfEachMap(system);
    std::vector<int> result;
    for (const int symbol : word)
        result.push_back(int(active.index[std::size_t(symbol) / copies]) + 1);
    return result;
}

py::object box(const notation::Entry& entry) {
    return inItsDimension(entry, [](const auto& system) -> py::object {
        std::optional<std::decay_t<decltype(boxOfAttractor(system))>> box;
        interruptibly([&](const std::stop_token&) { box = boxOfAttractor(system); });
        return py::make_tuple(arrayOf(box->min), arrayOf(box->max), box->error);
    });
}

std::optional<ifs::ConvexHull> hullOf(const ifs::IteratedFunctionSystem<2>& system, double tolerance,
                                      const std::stop_token& stop) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    if (!active.isLinked()) return ifs::convexHull(supportOf(system), tolerance, stop);
    const auto linked = ifs::LinkedExtent::of(active, ifs::classifyLinked<2>(active));
    if (linked) return ifs::convexHull(*linked, tolerance, stop);
    requireDrawable(active);
    throw std::invalid_argument("it is not known whether the system has an attractor");
}

py::object hull(const notation::Entry& entry, double tolerance) {
    if (!(tolerance > 0)) throw std::invalid_argument("tolerance: must be above 0");
    if (const auto* plane = std::get_if<notation::Figure<2>>(&entry.figure)) {
        std::optional<ifs::ConvexHull> found;
        interruptibly([&](const std::stop_token& stop) { found = hullOf(plane->system, tolerance, stop); });
        return py::make_tuple(arrayOf(std::span<const ifs::Vector<2>>(found->vertices)), py::none(),
                              found->area, ifs::areaError(*found), found->error);
    }
    std::optional<ifs::ConvexHull3> found;
    const auto& system = figureIn<3>(entry).system;
    interruptibly(
        [&](const std::stop_token& stop) { found = ifs::convexHull(supportOf(system), tolerance, stop); });
    std::vector<int> facets;
    for (const std::array<int, 3>& facet : found->facets)
        facets.insert(facets.end(), facet.begin(), facet.end());
    const auto count = py::ssize_t(found->facets.size());
    return py::make_tuple(arrayOf(std::span<const ifs::Vector<3>>(found->vertices)),
                          arrayOf(std::move(facets), {count, 3}), found->volume, ifs::volumeError(*found),
                          found->error);
}

// Value, error and kind; none where nothing is known.
template <int Dim> py::object dimensionOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    std::optional<double> value;
    double error = 0;
    const char* kind = "similarity";
    interruptibly([&](const std::stop_token& stop) {
        const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
        if (active.isLinked())
            throw std::invalid_argument(
                "the maps of this system are linked, which this function does not know of");
        requireDrawable(active);
        value = ifs::similarityDimension<Dim>(active.maps);
        if (value) {
            error = ifs::similarityDimensionError<Dim>(active.maps, *value);
        } else if constexpr (Dim == 2) {
            kind = "affinity";
            value = ifs::affinityDimension(active.maps, stop);
            error = ifs::affinityDimensionError;
        }
    });
    if (!value) return py::none();
    const ifs::CappedDimension shown = ifs::capped(*value, error, Dim);
    return py::make_tuple(shown.value, shown.error, kind);
}

py::object dimension(const notation::Entry& entry) {
    return inItsDimension(entry, [](const auto& system) { return dimensionOf(system); });
}

py::object classify(const notation::Entry& entry) {
    return inItsDimension(entry, [](const auto& system) -> py::object {
        ifs::Existence existence;
        interruptibly([&](const std::stop_token&) {
            const auto active = ifs::activeMaps(system);
            existence =
                active.isLinked() ? ifs::classifyLinked(active) : ifs::classify(std::span(active.maps));
        });
        constexpr std::array names{"hyperbolic", "eventually contractive", "none", "undecided", "empty"};
        return py::make_tuple(names[std::size_t(existence.verdict)], existence.contractivity,
                              existence.wordLength, counted(system, existence.witness));
    });
}

py::object moments(const notation::Entry& entry) {
    return inItsDimension(entry, [](const auto& system) -> py::object {
        const auto active = ifs::activeMaps(system);
        const auto found = ifs::moments(active);
        if (!found) {
            requireDrawable(active);
            throw std::invalid_argument("the invariant measure has no covariance, or none is proved");
        }
        return py::make_tuple(arrayOf(found->mean), matrixArray(found->covariance),
                              matrixArray(found->longRunCovariance), found->meanError,
                              found->covarianceError);
    });
}

template <int Dim>
py::object supportOfEntry(const ifs::IteratedFunctionSystem<Dim>& system, const Numbers& direction,
                          double tolerance) {
    const ifs::Vector<Dim> u = vectorFrom<Dim>(direction, "direction");
    std::optional<ifs::SupportValue<Dim>> found;
    interruptibly([&](const std::stop_token&) { found = supportOf(system)(u, tolerance); });
    return py::make_tuple(found->value, found->error, arrayOf(found->point), counted(system, found->address));
}

py::object support(const notation::Entry& entry, const Numbers& direction, double tolerance) {
    return inItsDimension(entry,
                          [&](const auto& system) { return supportOfEntry(system, direction, tolerance); });
}

template <int Dim>
py::object addressIn(const ifs::IteratedFunctionSystem<Dim>& system, const Numbers& point, double reach,
                     double width) {
    const ifs::AddressQueryIn<Dim> query{vectorFrom<Dim>(point, "point")};
    std::optional<ifs::AddressMatch> found;
    interruptibly([&](const std::stop_token&) {
        const ifs::SupportFunction<Dim> attractor = supportOf(system);
        const double size = 2 * attractor.radius();
        found = ifs::addressNear<Dim>(attractor, std::span(&query, 1), reach * size, width * size);
    });
    if (!found) return py::none();
    return py::make_tuple(counted(system, found->address), found->distance);
}

py::object address(const notation::Entry& entry, const Numbers& point, double reach, double width) {
    return inItsDimension(entry, [&](const auto& system) { return addressIn(system, point, reach, width); });
}

} // namespace

void bindFacts(py::module_& core) {
    core.def("box", &box);
    core.def("hull", &hull);
    core.def("dimension", &dimension);
    core.def("classify", &classify);
    core.def("moments", &moments);
    core.def("support", &support);
    core.def("address", &address);
}

} // namespace python
