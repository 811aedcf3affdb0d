// SPDX-License-Identifier: MIT
#include "io/own_comments.h"

#include "io/number.h"
#include "io/palette_stops.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace io {

namespace {

constexpr const char* prefix = "barycage:";
constexpr qsizetype longestLine = 69;
constexpr int maxVertices = 4096; // a hostile file must not make a cage of a million corners
constexpr int maxStops = 4096;
constexpr std::size_t maxBranches = 1024;
constexpr std::size_t maxWord = 64;
constexpr std::size_t maxPieces = 100'000; // of what is shown

struct ColourByName {
    attractor::ColourBy colourBy;
    const char* name;
};
constexpr std::array colourByNames{
    ColourByName{attractor::ColourBy::Density, "density"}, ColourByName{attractor::ColourBy::Map, "map"},
    ColourByName{attractor::ColourBy::Address, "address"}, ColourByName{attractor::ColourBy::Plain, "plain"}};

QByteArray line(const char* key, const QByteArray& values) {
    return QByteArray("; ") + prefix + ' ' + key + ' ' + values;
}

QByteArray point(const ifs::Vector<2>& p) {
    return formatNumber(p.x()) + ' ' + formatNumber(p.y());
}

std::optional<double> number(const QByteArray& text) {
    return parseNumber(QString::fromLatin1(text));
}

// With one such map the determinant rule serves for all, and the rows hold probabilities.
template <int Dim> bool lacksWeight(const ifs::WeightedMap<Dim>& map) {
    return map.enabled && !map.weight;
}

template <int Dim>
QByteArrayList mapLines(const ifs::IteratedFunctionSystem<Dim>& system,
                        const attractor::Appearance& appearance) {
    QByteArrayList lines;
    const bool noWeights = std::none_of(system.maps.begin(), system.maps.end(),
                                        [](const auto& map) { return map.weight.has_value(); });
    const bool isRuled = std::any_of(system.maps.begin(), system.maps.end(), lacksWeight<Dim>);
    if (noWeights && !system.maps.empty()) lines << line("unweighted", "all");
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const auto& map = system.maps[i];
        const QByteArray place = QByteArray::number(static_cast<qulonglong>(i) + 1);
        if (!map.enabled)
            lines << line("off", map.weight ? place + ' ' + formatNumber(*map.weight) : place);
        else if (!map.weight && !noWeights)
            lines << line("unweighted", place);
        else if (isRuled && map.weight && *map.weight > 0 && std::isfinite(*map.weight))
            lines << line("weight", place + ' ' + formatNumber(*map.weight));
        if (const auto* colour = appearance.mapColours.find(map.id))
            lines << line("map-colour", place + ' ' + colourText(*colour));
    }
    return lines;
}

// The word over as many lines as it needs, then the change in the order of a code row.
QByteArrayList branchLines(const ifs::MovedBranch<2>& branch) {
    QByteArrayList lines{line("branch", {})};
    for (const int place : branch.word) {
        const QByteArray number = QByteArray::number(place + 1);
        if (lines.back().size() + number.size() + 1 > longestLine) lines << line("branch", {});
        lines.back() += (lines.back().endsWith(' ') ? "" : " ") + number;
    }
    const ifs::Matrix<2>& linear = branch.change.linear;
    for (const ifs::Vector<2>& row :
         {ifs::Vector<2>(linear.row(0)), ifs::Vector<2>(linear.row(1)), branch.change.translation})
        lines << line("by", point(row));
    return lines;
}

QByteArrayList paletteLines(const attractor::Palette& palette) {
    QByteArrayList lines{line("palette", QByteArray::fromStdString(palette.name))};
    const attractor::Palette* builtIn = attractor::findPalette(palette.name);
    if (builtIn != nullptr && *builtIn == palette) return lines;
    for (const auto& stop : palette.stops)
        lines << line("stop", formatNumber(stop.position) + ' ' + colourText(stop.colour));
    return lines;
}

QByteArrayList appearanceLines(const attractor::Appearance& appearance) {
    const attractor::Appearance standard;
    QByteArrayList lines;
    if (appearance.colourBy != standard.colourBy)
        for (const auto& [colourBy, name] : colourByNames)
            if (colourBy == appearance.colourBy) lines << line("colour-by", name);
    if (!(appearance.palette == standard.palette)) lines << paletteLines(appearance.palette);
    if (!(appearance.plain == standard.plain)) lines << line("plain", colourText(appearance.plain));
    if (!(appearance.background == standard.background))
        lines << line("background", colourText(appearance.background));
    if (appearance.brightness != standard.brightness)
        lines << line("brightness", formatNumber(appearance.brightness));
    if (appearance.gamma != standard.gamma) lines << line("gamma", formatNumber(appearance.gamma));
    if (appearance.supersample != standard.supersample)
        lines << line("supersample", QByteArray::number(appearance.supersample));
    return lines;
}

// A text that is written after a key: one line, no blanks at its ends, short enough.
std::string storablePaletteName(const std::string& name) {
    QString text = QString::fromStdString(name);
    text.removeIf([](QChar c) { return !c.isPrint() && !c.isSurrogate() && !c.isSpace(); });
    text = text.simplified();
    const auto room = longestLine - line("palette", {}).size();
    while (text.toUtf8().size() > room)
        text.chop(1);
    return text.trimmed().toStdString();
}

template <int Dim>
void renumber(ifs::IteratedFunctionSystem<Dim>& system, attractor::MapColours& colours,
              std::vector<document::MovedBranch>& moved) {
    attractor::MapColours kept;
    std::map<ifs::MapId, ifs::MapId> ids;
    std::uint32_t number = 0;
    for (auto& map : system.maps) {
        const auto id = static_cast<ifs::MapId>(++number);
        if (const auto* colour = colours.find(map.id)) kept[id] = *colour;
        ids[map.id] = id;
        map.id = id;
    }
    colours = std::move(kept);
    std::erase_if(moved, [&](document::MovedBranch& branch) {
        return !std::ranges::all_of(branch.word, [&](ifs::MapId& id) {
            const auto known = ids.find(id);
            if (known != ids.end()) id = known->second;
            return known != ids.end();
        });
    });
}

} // namespace

QByteArrayList ownComments(const document::Fractal& fractal) {
    QByteArrayList lines;
    if (fractal.cage) {
        for (const auto& vertex : fractal.cage->rest)
            lines << line("rest", point(vertex));
        for (const auto& vertex : fractal.cage->current)
            lines << line("current", point(vertex));
        if (fractal.cage->deformation == ifs::Deformation::AffineFit)
            lines << line("deformation", "affine-fit");
    }
    for (const ifs::MovedBranch<2>& branch : document::movedBranches(fractal))
        lines << branchLines(branch);
    lines << appearanceLines(fractal.appearance);
    if (const auto* plane = std::get_if<document::System2>(&fractal.system))
        lines << mapLines(*plane, fractal.appearance);
    else if (const auto* space = std::get_if<document::System3>(&fractal.system))
        lines << mapLines(*space, fractal.appearance);
    if (!lines.isEmpty()) lines.prepend(line("version", "1"));
    return lines;
}

document::Fractal asStored(document::Fractal fractal) {
    if (auto* plane = std::get_if<document::System2>(&fractal.system))
        renumber(*plane, fractal.appearance.mapColours, fractal.moved);
    else if (auto* space = std::get_if<document::System3>(&fractal.system))
        renumber(*space, fractal.appearance.mapColours, fractal.moved);
    const attractor::Palette* builtIn = attractor::findPalette(fractal.appearance.palette.name);
    if (builtIn == nullptr || !(*builtIn == fractal.appearance.palette))
        fractal.appearance.palette.name = storablePaletteName(fractal.appearance.palette.name);
    return fractal;
}

bool isOwnComment(QByteArrayView comment) {
    return comment.trimmed().startsWith(prefix);
}

bool OwnComments::read(QByteArrayView comment) {
    if (!isOwnComment(comment)) return false;
    const QByteArray text =
        comment.trimmed().sliced(qsizetype(std::strlen(prefix))).toByteArray().simplified();
    QByteArrayList values = text.split(' ');
    const QByteArray key = values.takeFirst();
    return key == "version" || readSetting(key, values) || readMapSetting(key, values) ||
           readPalette(key, values) || readBranch(key, values);
}

bool OwnComments::readSetting(const QByteArray& key, const QByteArrayList& values) {
    if (key == "rest" || key == "current") {
        auto& vertices = key == "rest" ? m_cage.rest : m_cage.current;
        const auto x = values.size() == 2 ? number(values[0]) : std::nullopt;
        const auto y = values.size() == 2 ? number(values[1]) : std::nullopt;
        if (!x || !y || vertices.size() >= maxVertices) return false;
        vertices.emplace_back(*x, *y);
        return true;
    }
    if (values.size() != 1) return false;
    if (key == "deformation") {
        if (values[0] != "affine-fit" && values[0] != "bend") return false;
        m_cage.deformation = values[0] == "bend" ? ifs::Deformation::Bend : ifs::Deformation::AffineFit;
        return true;
    }
    if (key == "colour-by") {
        const auto found = std::find_if(colourByNames.begin(), colourByNames.end(),
                                        [&](const ColourByName& entry) { return values[0] == entry.name; });
        if (found == colourByNames.end()) return false;
        m_appearance.colourBy = found->colourBy;
        return true;
    }
    if (key == "plain" || key == "background") {
        const auto colour = parseColour(values[0]);
        if (colour) (key == "plain" ? m_appearance.plain : m_appearance.background) = *colour;
        return colour.has_value();
    }
    const auto value = number(values[0]);
    if (!value || !(*value > 0)) return false;
    if (key == "brightness")
        m_appearance.brightness = *value;
    else if (key == "gamma")
        m_appearance.gamma = *value;
    else if (key == "supersample" && *value <= 4 && *value == static_cast<int>(*value))
        m_appearance.supersample = static_cast<int>(*value);
    else
        return false;
    return true;
}

bool OwnComments::readMapSetting(const QByteArray& key, const QByteArrayList& values) {
    if (values.isEmpty() || values.size() > 2) return false;
    MapSetting setting;
    if (key == "unweighted" && values.size() == 1 && values[0] == "all") {
        m_unweighted.push_back(setting); // place 0: all of them
        return true;
    }
    setting.place = values[0].toInt();
    if (setting.place < 1) return false;
    if (key == "unweighted" && values.size() == 1) {
        m_unweighted.push_back(setting);
        return true;
    }
    if (key == "off") {
        setting.weight = values.size() == 2 ? number(values[1]) : std::nullopt;
        if (values.size() == 2 && !setting.weight) return false;
        m_off.push_back(setting);
        return true;
    }
    if (key == "weight") {
        setting.weight = values.size() == 2 ? number(values[1]) : std::nullopt;
        if (!(setting.weight.value_or(0) > 0)) return false;
        m_weights.push_back(setting);
        return true;
    }
    const auto colour = values.size() == 2 ? parseColour(values[1]) : std::nullopt;
    if (key != "map-colour" || !colour) return false;
    setting.colour = *colour;
    m_colours.push_back(setting);
    return true;
}

bool OwnComments::readPalette(const QByteArray& key, const QByteArrayList& values) {
    if (key == "palette") {
        m_paletteName = values.join(' ').toStdString();
        return true;
    }
    if (key != "stop" || values.size() != 2 || m_stops.size() >= maxStops) return false;
    const auto position = number(values[0]);
    const auto colour = parseColour(values[1]);
    if (!position || !colour || *position < 0 || *position > 1) return false;
    m_stops.push_back({*position, *colour});
    return true;
}

bool OwnComments::readBranch(const QByteArray& key, const QByteArrayList& values) {
    if (key == "branch") {
        if (m_branches.empty() || !m_branches.back().by.empty()) {
            if (m_branches.size() >= maxBranches) return false;
            m_branches.emplace_back();
        }
        std::vector<int> places;
        for (const QByteArray& value : values)
            places.push_back(value.toInt());
        std::vector<int>& word = m_branches.back().places;
        if (places.empty() || std::ranges::min(places) < 1 || word.size() + places.size() > maxWord)
            return false;
        word.insert(word.end(), places.begin(), places.end());
        return true;
    }
    if (key != "by" || values.size() != 2 || m_branches.empty() || m_branches.back().by.size() == 3)
        return false;
    const auto x = number(values[0]);
    const auto y = number(values[1]);
    if (x && y) m_branches.back().by.emplace_back(*x, *y);
    return x && y;
}

void OwnComments::applyBranches(document::Fractal& fractal, QStringList& sentences) const {
    const document::System2* system = document::system2(fractal);
    std::size_t pieces = 0;
    for (const Branch& branch : m_branches) {
        document::MovedBranch moved;
        for (const int place : branch.places)
            if (system && std::size_t(place) <= system->maps.size())
                moved.word.push_back(system->maps[std::size_t(place - 1)].id);
        if (system) pieces += moved.word.size() * system->maps.size();
        const bool known =
            std::ranges::find(fractal.moved, moved.word, &document::MovedBranch::word) != fractal.moved.end();
        if (branch.by.size() != 3 || branch.places.empty() || moved.word.size() != branch.places.size() ||
            known || pieces > maxPieces) {
            sentences << QCoreApplication::translate(
                "Text",
                "A stored place of a branch is not usable (its map is incomplete, or its address names maps "
                "that are not there, or occurs twice, or there are too many) and is not applied.");
            continue;
        }
        moved.change.linear << branch.by[0].transpose(), branch.by[1].transpose();
        moved.change.translation = branch.by[2];
        fractal.moved.push_back(std::move(moved));
    }
}

void OwnComments::applyCage(document::Fractal& fractal, QStringList& sentences) const {
    if (m_cage.rest.empty() && m_cage.current.empty()) return;
    if (ifs::isValid(m_cage))
        fractal.cage = m_cage;
    else
        sentences << QCoreApplication::translate(
            "Text",
            "The stored cage is not usable (its lists of vertices do not match, or its rest vertices lie on "
            "one line, cross each other or are more than 64) and is not applied.");
}

void OwnComments::applyPalette(document::Fractal& fractal, QStringList& sentences) const {
    if (!m_paletteName && m_stops.empty()) return;
    const std::string name = m_paletteName.value_or(std::string());
    const attractor::Palette* builtIn = attractor::findPalette(name);
    if (isGradient(m_stops))
        fractal.appearance.palette = {name, m_stops};
    else if (m_stops.empty() && builtIn != nullptr)
        fractal.appearance.palette = *builtIn;
    else
        sentences << QCoreApplication::translate("Text",
                                                 "The stored palette “%1” is unknown and is not applied.")
                         .arg(QString::fromStdString(name));
}

QStringList OwnComments::applyTo(document::Fractal& fractal) const {
    QStringList sentences;
    fractal.appearance = m_appearance;
    applyPalette(fractal, sentences);
    applyCage(fractal, sentences);
    applyBranches(fractal, sentences);
    const auto applyToMaps = [&](auto& maps) {
        const auto mapAt = [&](int place) {
            return static_cast<std::size_t>(place) <= maps.size() ? &maps[static_cast<std::size_t>(place - 1)]
                                                                  : nullptr;
        };
        for (const MapSetting& setting : m_unweighted) {
            if (setting.place == 0)
                for (auto& map : maps)
                    map.weight.reset();
            else if (auto* map = mapAt(setting.place))
                map->weight.reset();
        }
        std::vector<MapSetting> colours = m_colours;
        std::ranges::stable_sort(colours, {}, &MapSetting::place); // as their ids are; the last one counts
        for (const MapSetting& setting : colours)
            if (const auto* map = mapAt(setting.place))
                fractal.appearance.mapColours[map->id] = setting.colour;
        for (const MapSetting& setting : m_off) {
            auto* map = mapAt(setting.place);
            if (map == nullptr || (map->weight && *map->weight != 0)) {
                sentences << QCoreApplication::translate(
                                 "Text",
                                 "Map %1 was switched off here, but another program has given it a weight.")
                                 .arg(setting.place);
                continue;
            }
            map->enabled = false;
            map->weight = setting.weight;
        }
        // A row that another program has switched off stays off; without a map that lacks one, rows hold
        // the weights themselves.
        if (std::none_of(maps.begin(), maps.end(), [](const auto& map) { return lacksWeight(map); })) return;
        for (const MapSetting& setting : m_weights)
            if (auto* map = mapAt(setting.place); map && map->enabled && map->weight.value_or(0) > 0)
                map->weight = setting.weight;
    };
    if (auto* plane = std::get_if<document::System2>(&fractal.system))
        applyToMaps(plane->maps);
    else if (auto* space = std::get_if<document::System3>(&fractal.system))
        applyToMaps(space->maps);
    return sentences;
}

} // namespace io
