// SPDX-License-Identifier: MIT
#include "python/bindings.h"

#include "ifs/system/links.h"
#include "notation/entry_reader.h"
#include "notation/entry_writer.h"
#include "notation/text/symmetry_name.h"
#include "python/arrays.h"

#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>

namespace python {

namespace {

namespace py = pybind11;

struct TextFlaw {
    int line;
    int column;
    std::string sentence;
};

// The entries of a text; where one cannot be read, its flaw stands in its place.
py::list parsed(const std::string& text, const std::string& bareName) {
    notation::File file;
    {
        const py::gil_scoped_release release;
        file = notation::readFile(text, bareName);
    }
    py::list list;
    if (file.flaw) list.append(TextFlaw{file.flaw->line, file.flaw->column, file.flaw->sentence});
    for (notation::Entry& each : file.entries) {
        if (each.flaw)
            list.append(
                py::make_tuple(each.name, TextFlaw{each.flaw->line, each.flaw->column, each.flaw->sentence}));
        else
            list.append(std::move(each));
    }
    return list;
}

template <int Dim>
notation::Entry made(const Numbers& maps, const std::optional<Numbers>& weights, const std::string& name,
                     const std::string& symmetry, const std::optional<Numbers>& links) {
    notation::Entry result;
    result.name = name;
    notation::Figure<Dim>& figure = result.figure.emplace<notation::Figure<Dim>>();
    const auto given = mapsFrom<Dim>(maps);
    if (weights && (weights->ndim() != 1 || std::size_t(weights->size()) != given.size()))
        throw std::invalid_argument("weights: one number for each map");
    for (std::size_t k = 0; k < given.size(); ++k) {
        const double weight = weights ? weights->data()[k] : NAN;
        ifs::append(figure.system, given[k], std::isfinite(weight) ? std::optional(weight) : std::nullopt);
    }
    const auto named = notation::symmetryNamed(symmetry);
    const auto group = named ? notation::symmetryIn<Dim>(*named) : std::nullopt;
    if (!group) throw std::invalid_argument("symmetry: “" + symmetry + "” is none in this dimension");
    figure.system.symmetry = *group;
    if (links) {
        const auto n = py::ssize_t(given.size());
        if (Dim != 2 || links->ndim() != 2 || links->shape(0) != n || links->shape(1) != n)
            throw std::invalid_argument("links: the shape must be (maps, maps), of an entry in the plane");
        ifs::setLinks(figure.system, std::span(links->data(), std::size_t(links->size())));
    }
    return result;
}

notation::Entry madeOf(const Numbers& maps, const std::optional<Numbers>& weights, const std::string& name,
                       const std::string& symmetry, const std::optional<Numbers>& links) {
    if (maps.ndim() == 3 && maps.shape(1) == 3) return made<3>(maps, weights, name, symmetry, links);
    return made<2>(maps, weights, name, symmetry, links);
}

// Work on the figure, whose dimension the compiler knows.
template <class Work> py::object withFigure(const notation::Entry& entry, const Work& work) {
    if (const auto* plane = std::get_if<notation::Figure<2>>(&entry.figure)) return work(*plane);
    return work(std::get<notation::Figure<3>>(entry.figure));
}

py::object mapsOf(const notation::Entry& entry) {
    return withFigure(entry, [](const auto& figure) -> py::object {
        const auto maps = ifs::mapsOf(figure.system);
        return arrayOf(std::span(maps));
    });
}

py::object weightsOf(const notation::Entry& entry) {
    return withFigure(entry, [](const auto& figure) -> py::object {
        std::vector<double> weights;
        for (const auto& map : figure.system.maps)
            weights.push_back(!map.enabled ? 0 : map.weight.value_or(NAN));
        const auto count = py::ssize_t(weights.size());
        return arrayOf(std::move(weights), {count});
    });
}

py::object probabilitiesOf(const notation::Entry& entry) {
    return withFigure(entry, [](const auto& figure) -> py::object {
        std::vector<double> probabilities = ifs::probabilities(figure.system);
        const auto count = py::ssize_t(probabilities.size());
        return arrayOf(std::move(probabilities), {count});
    });
}

py::object cageOf(const notation::Entry& entry) {
    return withFigure(entry, [](const auto& figure) -> py::object {
        if (!figure.cage) return py::none();
        return py::make_tuple(arrayOf(std::span(figure.cage->rest)),
                              arrayOf(std::span(figure.cage->current)));
    });
}

py::object linksOf(const notation::Entry& entry) {
    return withFigure(entry, [](const auto& figure) -> py::object {
        if (figure.system.links.empty()) return py::none();
        const auto n = py::ssize_t(figure.system.maps.size());
        return arrayOf(ifs::linkMatrix(figure.system), {n, n});
    });
}

py::object symmetryOf(const notation::Entry& entry) {
    return withFigure(entry, [](const auto& figure) -> py::object {
        const auto& symmetry = figure.system.symmetry;
        return py::str(notation::symmetryName(symmetry.group, symmetry.order));
    });
}

} // namespace

void bindEntries(py::module_& core) {
    py::class_<TextFlaw>(core, "Flaw")
        .def_readonly("line", &TextFlaw::line)
        .def_readonly("column", &TextFlaw::column)
        .def_readonly("sentence", &TextFlaw::sentence);
    py::class_<notation::Entry>(core, "Entry")
        .def(py::init(&madeOf))
        .def_readonly("name", &notation::Entry::name)
        .def_readonly("comments", &notation::Entry::comments)
        .def_property_readonly("dimension", [](const notation::Entry& e) { return e.figure.index() + 1; })
        .def_property_readonly("maps", &mapsOf)
        .def_property_readonly("weights", &weightsOf)
        .def_property_readonly("probabilities", &probabilitiesOf)
        .def_property_readonly("cage", &cageOf)
        .def_property_readonly("links", &linksOf)
        .def_property_readonly("symmetry", &symmetryOf)
        .def("text", &notation::written)
        .def("__eq__", [](const notation::Entry& a, const notation::Entry& b) { return a == b; });
    core.def("parse", &parsed);
}

} // namespace python
