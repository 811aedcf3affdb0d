// SPDX-License-Identifier: MIT
#pragma once

#include "web/engine.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

// The calls by which an entry, as web pages hold it, is handed to an engine: what app/web/page/engine.js does
// in browsers.
namespace web {

using EnginePointer = std::unique_ptr<Engine, void (*)(Engine*)>;

// All numbers of an array of arrays; null is NaN.
inline void appendNumbers(const QJsonValue& value, std::vector<double>& numbers) {
    if (value.isArray())
        for (const QJsonValue part : value.toArray())
            appendNumbers(part, numbers);
    else
        numbers.push_back(value.toDouble(NAN));
}
inline std::vector<double> numbersOf(const QJsonValue& value) {
    std::vector<double> numbers;
    if (value.isArray()) appendNumbers(value, numbers);
    return numbers;
}

inline std::vector<double> appearanceOf(const QJsonObject& entry) {
    const QJsonObject given = entry[u"appearance"].toObject();
    std::vector<double> numbers{given[u"colourBy"].toDouble(0), given[u"brightness"].toDouble(20),
                                given[u"gamma"].toDouble(2.2),  given[u"contrast"].toDouble(1),
                                given[u"vibrancy"].toDouble(1), given[u"supersample"].toDouble(1)};
    const auto append = [&](const QJsonValue& colour, const std::array<double, 4>& usual) {
        const std::vector<double> own = numbersOf(colour);
        numbers.insert(numbers.end(), own.empty() ? usual.begin() : own.data(),
                       own.empty() ? usual.end() : own.data() + 4);
    };
    append(given[u"plain"], {235, 235, 235, 255});
    append(given[u"background"], {13, 16, 23, 255});
    return numbers;
}

// Returns the dimension.
inline int load(Engine* engine, const QJsonObject& entry) {
    const int dimension = entry[u"dimension"].toInt();
    std::vector<double> rows;
    for (const QJsonValue map : entry[u"maps"].toArray()) {
        std::vector<double> row = numbersOf(map);
        row.resize(std::size_t(dimension * (dimension + 1) + 1), NAN);
        rows.insert(rows.end(), row.begin(), row.end());
    }
    barycage_load(engine, dimension, rows.data(), int(entry[u"maps"].toArray().size()));
    if (const std::vector<double> links = numbersOf(entry[u"links"]); !links.empty())
        barycage_links(engine, links.data());
    if (const QJsonObject symmetry = entry[u"symmetry"].toObject(); !symmetry.isEmpty()) {
        std::vector<double> place = numbersOf(symmetry[u"centre"]);
        for (const double number : numbersOf(symmetry[u"frame"]))
            place.push_back(number);
        place.resize(std::size_t(dimension * (dimension + 2))); // the frame is read as a map
        barycage_symmetry(engine, symmetry[u"group"].toInt(), symmetry[u"order"].toInt(1),
                          symmetry[u"angle"].toDouble(), place.data());
    }
    for (const QJsonValue branch : entry[u"branches"].toArray()) {
        std::vector<int> word;
        for (const double symbol : numbersOf(branch[u"word"]))
            word.push_back(int(symbol));
        barycage_branch(engine, word.data(), int(word.size()), numbersOf(branch[u"change"]).data());
    }
    const std::vector<double> numbers = appearanceOf(entry);
    barycage_appearance(engine, numbers.data());
    std::vector<double> stops(5 * 64);
    const int count = barycage_palette_stops(0, stops.data());
    barycage_stops(engine, stops.data(), count);
    for (const QJsonValue colour : entry[u"appearance"][u"mapColours"].toArray())
        barycage_map_colour(engine, colour[0].toInt(), numbersOf(colour[1]).data());
    const QJsonObject solid = entry[u"solid"].toObject();
    std::vector<double> light = numbersOf(solid[u"light"]);
    if (light.empty()) light = {-40, 40};
    light.push_back(solid[u"fog"].toDouble());
    barycage_light(engine, solid[u"look"].toInt(), solid[u"colour"].toInt(), light.data());
    if (std::vector<double> clip = numbersOf(solid[u"clip"]); clip.size() == 5) {
        if (std::isnan(clip[3])) clip[3] = -INFINITY;
        if (std::isnan(clip[4])) clip[4] = INFINITY;
        barycage_clip(engine, clip.data());
    }
    barycage_settle(engine);
    return dimension;
}

inline QByteArray hashOf(Engine* engine) {
    const quint64 hash = quint64(barycage_hash(engine, 1)) << 32 | barycage_hash(engine, 0);
    return QByteArray::number(hash, 16).rightJustified(16, '0');
}

} // namespace web
