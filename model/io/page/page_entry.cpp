// SPDX-License-Identifier: MIT
#include "io/page/page_entry.h"

#include "attractor/request/appearance_fields.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "ifs/system/links.h"
#include "io/fractint/entry_writer.h"

#include <cmath>
#include <span>
#include <vector>

namespace io {

namespace {

using Layout = JsonWriter::Layout;
using attractor::Rgba;

void writeArray(JsonWriter& json, std::span<const double> numbers) {
    json.beginArray(Layout::Inline);
    for (const double number : numbers)
        json.value(number);
    json.endArray();
}

void writeColour(JsonWriter& json, const Rgba& colour) {
    writeArray(json, std::vector<double>{double(colour.red), double(colour.green), double(colour.blue),
                                         double(colour.alpha)});
}

// The linear part by rows, then the translation.
template <int Dim> std::vector<double> numbersOf(const ifs::AffineMap<Dim>& map) {
    std::vector<double> numbers;
    for (int row = 0; row < Dim; ++row)
        for (int column = 0; column < Dim; ++column)
            numbers.push_back(map.linear(row, column));
    for (int row = 0; row < Dim; ++row)
        numbers.push_back(map.translation[row]);
    return numbers;
}

template <int Dim> void writeMaps(JsonWriter& json, const ifs::IteratedFunctionSystem<Dim>& system) {
    json.key("maps");
    json.beginArray(Layout::Inline);
    for (const auto& map : system.maps) {
        json.beginArray(Layout::Inline);
        for (const double number : numbersOf<Dim>(map.map))
            json.value(number);
        json.value(map.enabled ? map.weight : std::optional<double>(0));
        json.endArray();
    }
    json.endArray();
    if (system.links.empty()) return;
    const std::vector<double> links = ifs::linkMatrix(system);
    json.key("links");
    json.beginArray(Layout::Inline);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        writeArray(json, std::span(links).subspan(i * system.maps.size(), system.maps.size()));
    json.endArray();
}

template <int Dim> void writeSymmetry(JsonWriter& json, const ifs::Symmetry<Dim>& symmetry) {
    if (symmetry.group == ifs::SymmetryGroup::None) return;
    json.key("symmetry");
    json.beginObject(Layout::Inline);
    json.member("group", int(symmetry.group));
    json.member("order", symmetry.order);
    json.member("angle", symmetry.angle);
    std::vector<double> frame = numbersOf<Dim>({symmetry.frame, symmetry.centre});
    const std::size_t matrix = std::size_t(Dim) * Dim;
    json.key("centre");
    writeArray(json, std::span(frame).subspan(matrix));
    json.key("frame");
    writeArray(json, std::span(frame).first(matrix));
    json.endObject();
}

template <int Dim> void writePoints(JsonWriter& json, const std::vector<ifs::Vector<Dim>>& points) {
    json.beginArray(Layout::Inline);
    for (const auto& point : points)
        writeArray(json, std::span(point.data(), Dim));
    json.endArray();
}

template <int Dim> void writeShape(JsonWriter& json, const document::Shape<Dim>& shape) {
    json.member("dimension", Dim);
    writeMaps(json, shape.system);
    writeSymmetry(json, shape.system.symmetry);
    if (!shape.moved.empty()) {
        json.key("branches");
        json.beginArray(Layout::Inline);
        for (const ifs::MovedBranch<Dim>& branch : document::movedBranches(shape)) {
            json.beginObject(Layout::Inline);
            json.key("word");
            writeArray(json, std::vector<double>(branch.word.begin(), branch.word.end()));
            json.key("change");
            writeArray(json, numbersOf<Dim>(branch.change));
            json.endObject();
        }
        json.endArray();
    }
    if (!shape.cage || !ifs::isValid(*shape.cage)) return;
    json.key("cage");
    json.beginObject(Layout::Inline);
    json.key("rest");
    writePoints<Dim>(json, shape.cage->rest);
    json.key("current");
    writePoints<Dim>(json, shape.cage->current);
    json.member("bends", shape.cage->deformation == ifs::Deformation::Bend);
    json.endObject();
}

template <int Dim>
void writeMapValues(JsonWriter& json, const attractor::Appearance& appearance,
                    const ifs::IteratedFunctionSystem<Dim>& system) {
    json.key("mapColours");
    json.beginArray(Layout::Inline);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        if (const Rgba* colour = appearance.mapColours.find(system.maps[i].id)) {
            json.beginArray(Layout::Inline);
            json.value(int(i));
            writeColour(json, *colour);
            json.endArray();
        }
    json.endArray();
    json.key("mapBlends");
    json.beginArray(Layout::Inline);
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        if (const attractor::MapBlend* blend = appearance.mapBlends.find(system.maps[i].id))
            writeArray(json, std::vector<double>{double(i), blend->coordinate, blend->speed});
    json.endArray();
}

void writeAppearance(JsonWriter& json, const document::Fractal& fractal) {
    const attractor::Appearance& appearance = fractal.appearance;
    json.key("appearance");
    json.beginObject();
    json.member("colourBy", int(appearance.colourBy));
    for (const auto& number : attractor::appearanceNumbers) // pages draw no shadow
        if (number.part == attractor::AppearanceNumber::Part::Tone)
            json.member(number.key, appearance.*number.member);
    json.member("supersample", appearance.supersample);
    for (const auto& [key, colour] : attractor::appearanceColours) {
        json.key(key);
        writeColour(json, appearance.*colour);
    }
    json.key("stops");
    json.beginArray(Layout::Inline);
    for (const auto& stop : appearance.palette.stops)
        writeArray(json,
                   std::vector<double>{stop.position, double(stop.colour.red), double(stop.colour.green),
                                       double(stop.colour.blue), double(stop.colour.alpha)});
    json.endArray();
    if (const auto* system = document::system2(fractal))
        writeMapValues<2>(json, appearance, *system);
    else if (const auto* solid = document::system3(fractal))
        writeMapValues<3>(json, appearance, *solid);
    json.endObject();
}

void writeSolid(JsonWriter& json, const document::Fractal& fractal) {
    const attractor::SpaceAppearance& inSpace = fractal.inSpace;
    json.key("solid");
    json.beginObject();
    json.member("look", int(inSpace.look));
    json.member("colour", int(document::solidColour(fractal)));
    json.key("light");
    writeArray(json, std::vector<double>{inSpace.lightAzimuth, inSpace.lightElevation});
    json.member("fog", inSpace.fog);
    if (inSpace.clip) {
        json.key("clip");
        // Infinite numbers are null; the page knows their sign.
        const ifs::Vector<3>& normal = inSpace.clip->normal;
        writeArray(json, std::vector<double>{normal.x(), normal.y(), normal.z(), inSpace.clip->lowest,
                                             inSpace.clip->highest});
    }
    json.endObject();
    attractor::OrbitCamera camera;
    camera.orientation = attractor::orbit(pageAzimuth, pageElevation);
    camera.size = {1000, 1000};
    camera = document::fittedTo(fractal, camera, pageMargin);
    json.key("view");
    writeArray(json, std::vector<double>{camera.target.x(), camera.target.y(), camera.target.z(), pageAzimuth,
                                         pageElevation, camera.height, 0});
}

// The lines of the collection, without those that the page writes itself.
void writeText(JsonWriter& json, const document::Fractal& fractal) {
    QByteArrayList lines = writeEntry(fractal).split('\n');
    json.key("text");
    json.beginObject();
    json.member("begin", QString::fromUtf8(lines.takeFirst()));
    QByteArrayList comments, rows;
    for (const QByteArray& line : lines) {
        const QByteArray text = line.trimmed();
        if (text.isEmpty() || text == "}") continue;
        if (text.startsWith("; barycage: rest ") || text.startsWith("; barycage: current ")) continue;
        (text.startsWith(';') ? comments : rows) << text;
    }
    for (const auto& [key, list] : {std::pair("lines", comments), std::pair("rows", rows)}) {
        json.key(key);
        json.beginArray();
        for (const QByteArray& text : list)
            json.value(QString::fromUtf8(text));
        json.endArray();
    }
    json.endObject();
}

} // namespace

void writePageEntry(JsonWriter& json, const document::Fractal& fractal) {
    json.beginObject();
    json.member("name", fractal.name);
    if (const auto* shape = document::plane(fractal)) writeShape<2>(json, *shape);
    if (const auto* shape = document::space(fractal)) writeShape<3>(json, *shape);
    if (const auto box = document::displayedBox(fractal)) {
        json.key("box");
        writeArray(json, std::vector<double>{box->min.x(), box->min.y(), box->max.x(), box->max.y()});
    }
    writeAppearance(json, fractal);
    if (document::space(fractal)) writeSolid(json, fractal);
    writeText(json, fractal);
    json.endObject();
}

} // namespace io
