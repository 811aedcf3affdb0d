// SPDX-License-Identifier: MIT
#include "io/fractint/metadata_comments.h"

#include "document/fractal/recurring_branches.h"
#include "document/text/text.h"
#include "ifs/system/links.h"
#include "io/palette/palette_stops.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <span>
#include <utility>

namespace io {

namespace {

constexpr const char* prefix = metadataPrefix;
constexpr qsizetype maxLine = maxMetadataLine;
constexpr const char* continued = " \\"; // end of a line that is continued by more coordinates
constexpr int maxVertices = 4096;        // limit against malicious files
constexpr std::size_t maxBranches = 1024;
constexpr std::size_t maxWord = 64;
constexpr std::size_t maxPieces = 100'000; // displayed pieces

QByteArray line(const char* key, const QByteArray& values) {
    return metadataLine(key, values);
}

// A point, on more than one line where its numbers are too long.
template <int Dim> QByteArrayList pointLines(const char* key, const ifs::Vector<Dim>& point) {
    QByteArrayList lines{line(key, {})};
    for (int i = 0; i < Dim; ++i) {
        const QByteArray text = formatNumber(point[i]);
        const qsizetype mark = i + 1 < Dim ? qsizetype(std::strlen(continued)) : 0;
        if (i > 0 && lines.back().size() + 1 + text.size() + mark > maxLine) {
            lines.back() += continued;
            lines << line(key, {});
        }
        lines.back() += (lines.back().endsWith(' ') ? "" : " ") + text;
    }
    return lines;
}

// Returns true for a map that makes the determinant rule serve for all; rows then hold probabilities.
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
        const QByteArray number = QByteArray::number(static_cast<qulonglong>(i) + 1);
        if (!map.enabled)
            lines << line("off", map.weight ? number + ' ' + formatNumber(*map.weight) : number);
        else if (!map.weight && !noWeights)
            lines << line("unweighted", number);
        else if (isRuled && map.weight && *map.weight > 0 && std::isfinite(*map.weight))
            lines << line("weight", number + ' ' + formatNumber(*map.weight));
        if (const auto* colour = appearance.mapColours.find(map.id))
            lines << line("map-colour", number + ' ' + colourText(*colour));
    }
    return lines;
}

// The word over as many lines as it needs, then the change in the order of a code row.
template <int Dim> QByteArrayList branchLines(const ifs::MovedBranch<Dim>& branch, bool recurs) {
    QByteArrayList lines{line("branch", recurs ? "0" : "")};
    for (const int symbol : branch.word) {
        const QByteArray number = QByteArray::number(symbol + 1);
        if (lines.back().size() + number.size() + 1 > maxLine) lines << line("branch", {});
        lines.back() += (lines.back().endsWith(' ') ? "" : " ") + number;
    }
    for (int i = 0; i < Dim; ++i)
        lines << pointLines<Dim>("by", branch.change.linear.row(i).transpose());
    return lines << pointLines<Dim>("by", branch.change.translation);
}

// Lines about the cage of the shape, and about its moved branches.
template <int Dim> QByteArrayList placementLines(const document::Shape<Dim>& shape) {
    QByteArrayList lines;
    if (shape.cage) {
        for (const auto& vertex : shape.cage->rest)
            lines << pointLines<Dim>("rest", vertex);
        for (const auto& vertex : shape.cage->current)
            lines << pointLines<Dim>("current", vertex);
        if (shape.cage->deformation == ifs::Deformation::AffineFit)
            lines << line("deformation", "affine-fit");
    }
    for (const auto& [branch, recurs] : document::storedBranches(shape))
        lines << branchLines(branch, recurs);
    return lines << symmetryComments(shape.system.symmetry) << animationComments(shape);
}

template <int Dim> ifs::Vector<Dim> vectorOf(const std::vector<double>& coordinates) {
    return Eigen::Map<const ifs::Vector<Dim>>(coordinates.data());
}

void append(std::vector<std::size_t>& lines, const std::vector<std::size_t>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

template <int Dim> void renumber(document::Shape<Dim>& shape, document::Fractal& fractal) {
    attractor::Appearance& appearance = fractal.appearance;
    attractor::MapColours colours;
    attractor::MapBlends blends;
    document::MapLabels labels;
    std::map<ifs::MapId, ifs::MapId> ids;
    std::uint32_t number = 0;
    std::size_t typedLines = maxTypedLines;
    for (auto& map : shape.system.maps) {
        const auto id = static_cast<ifs::MapId>(++number);
        if (const auto* colour = appearance.mapColours.find(map.id)) colours[id] = *colour;
        if (const auto* blend = appearance.mapBlends.find(map.id)) blends[id] = *blend;
        if (!fractal.mapLabels.isEmpty()) labels.set(id, storedLabel(fractal.mapLabels.of(map.id)));
        map.typed = storedTyped(map, typedLines);
        ids[map.id] = id;
        map.id = id;
    }
    ifs::renumberLinks(shape.system, ids);
    appearance.mapColours = std::move(colours);
    appearance.mapBlends = std::move(blends);
    fractal.mapLabels = std::move(labels);
    std::erase_if(shape.moved, [&](document::MovedBranch<Dim>& branch) {
        return !std::ranges::all_of(branch.word, [&](ifs::MapId& id) {
            const auto known = ids.find(id);
            if (known != ids.end()) id = known->second;
            return known != ids.end() || id == ifs::MapId::None;
        });
    });
    if (shape.animation) renumberAnimation(shape, ids);
}

} // namespace

QByteArrayList metadataComments(const document::Fractal& fractal) {
    const QByteArrayList appearance =
        appearanceComments(fractal.appearance) + byteLines(notation::spaceLines(fractal.inSpace));
    const auto linesOf = [&](const auto& shape) {
        return placementLines(shape) + appearance + mapLines(shape.system, fractal.appearance) +
               blendComments(fractal) + labelComments(fractal) + linkComments(shape.system) +
               typedComments(shape.system);
    };
    QByteArrayList lines = appearance;
    if (const auto* plane = document::plane(fractal))
        lines = linesOf(*plane);
    else if (const auto* space = document::space(fractal))
        lines = linesOf(*space);
    if (!lines.isEmpty()) lines.prepend(line("version", "1"));
    return lines;
}

document::Fractal asStored(document::Fractal fractal) {
    if (auto* plane = document::plane(fractal))
        renumber(*plane, fractal);
    else if (auto* space = document::space(fractal))
        renumber(*space, fractal);
    const attractor::Palette* builtIn = attractor::findPalette(fractal.appearance.palette.name);
    if (builtIn == nullptr || !(*builtIn == fractal.appearance.palette))
        fractal.appearance.palette.name = storableText("palette", fractal.appearance.palette.name);
    return fractal;
}

bool isOwnComment(QByteArrayView comment) {
    const QByteArrayView text = comment.trimmed();
    if (!text.startsWith(prefix)) return false;
    // Keeps lines of a fractal transformation and of saved views among the comments of the entry:
    // document/tops/kept_theft and document/saved_views.
    const QByteArrayView key = text.sliced(qsizetype(std::strlen(prefix))).trimmed();
    return !key.startsWith("partner") && !key.startsWith("view");
}

bool MetadataComments::read(QByteArrayView comment) {
    if (!isOwnComment(comment)) return false;
    ++m_ownComments;
    const QByteArray text =
        comment.trimmed().sliced(qsizetype(std::strlen(prefix))).toByteArray().simplified();
    QByteArrayList values = text.split(' ');
    const QByteArray key = values.takeFirst();
    return key == "version" || readSetting(key, values) || readMapSetting(key, values) ||
           m_colouring.read(key, values) || readBranch(key, values) ||
           m_links.read(key, values, m_ownComments - 1) || m_labels.read(key, values) ||
           m_blends.read(key, values) || m_typed.read(key, values) ||
           m_inSpace.read(key.toStdString(), plainWords(values)) ||
           m_symmetry.read(key, values, m_ownComments - 1) ||
           m_animations.read(key, values, m_ownComments - 1);
}

// Reads another point, or more coordinates of the last one.
bool MetadataComments::readPoint(const QByteArrayList& values, std::vector<Point>& points) const {
    const bool continues = !points.empty() && points.back().isOpen;
    Point point = continues ? points.back() : Point();
    point.isOpen = !values.isEmpty() && values.back() == QByteArray(continued).trimmed();
    for (const QByteArray& value : values.first(values.size() - (point.isOpen ? 1 : 0))) {
        const auto coordinate = metadataNumber(value);
        if (!coordinate) return false;
        point.coordinates.push_back(*coordinate);
    }
    const std::size_t count = point.coordinates.size();
    if (point.isOpen ? count < 1 || count > 2 : count < 2 || count > 3) return false;
    point.lines.push_back(m_ownComments - 1);
    if (continues)
        points.back() = std::move(point);
    else
        points.push_back(std::move(point));
    return true;
}

bool MetadataComments::readSetting(const QByteArray& key, const QByteArrayList& values) {
    if (key == "rest" || key == "current") {
        auto& vertices = key == "rest" ? m_rest : m_current;
        return vertices.size() < maxVertices && readPoint(values, vertices);
    }
    if (key == "deformation") {
        if (values.size() != 1 || (values[0] != "affine-fit" && values[0] != "bend")) return false;
        m_deformation = values[0] == "bend" ? ifs::Deformation::Bend : ifs::Deformation::AffineFit;
        m_deformationLines.push_back(m_ownComments - 1);
        return true;
    }
    return false;
}

bool MetadataComments::readMapSetting(const QByteArray& key, const QByteArrayList& values) {
    if (values.isEmpty() || values.size() > 2) return false;
    MapSetting setting;
    if (key == "unweighted" && values.size() == 1 && values[0] == "all") {
        m_unweighted.push_back(setting);
        return true;
    }
    setting.map = values[0].toInt();
    if (setting.map < 1) return false;
    if (key == "unweighted" && values.size() == 1) {
        m_unweighted.push_back(setting);
        return true;
    }
    if (key == "off") {
        setting.weight = values.size() == 2 ? metadataNumber(values[1]) : std::nullopt;
        if (values.size() == 2 && !setting.weight) return false;
        m_off.push_back(setting);
        return true;
    }
    if (key == "weight") {
        setting.weight = values.size() == 2 ? metadataNumber(values[1]) : std::nullopt;
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

bool MetadataComments::readBranch(const QByteArray& key, const QByteArrayList& values) {
    if (key == "branch") {
        if (m_branches.empty() || !m_branches.back().by.empty()) {
            if (m_branches.size() >= maxBranches) return false;
            m_branches.emplace_back();
        }
        std::vector<int> symbols;
        for (const QByteArray& value : values)
            symbols.push_back(value.toInt());
        std::vector<int>& word = m_branches.back().word;
        // Leading 0: a branch that changes inside itself.
        const auto first = symbols.begin() + (word.empty() && values.value(0) == "0" ? 1 : 0);
        if (first == symbols.end() || *std::min_element(first, symbols.end()) < 1 ||
            word.size() + symbols.size() > maxWord)
            return false;
        word.insert(word.end(), symbols.begin(), symbols.end());
        m_branches.back().lines.push_back(m_ownComments - 1);
        return true;
    }
    if (key != "by" || m_branches.empty()) return false;
    std::vector<Point>& by = m_branches.back().by;
    const bool isComplete = !by.empty() && !by.back().isOpen && by.size() > by.front().coordinates.size();
    return !isComplete && readPoint(values, by);
}

template <int Dim> void MetadataComments::applyCage(document::Shape<Dim>& shape, Outcome& outcome) const {
    ifs::ControlCage<Dim> cage{{}, {}, m_deformation};
    const std::size_t before = outcome.kept.size();
    const auto take = [&](const std::vector<Point>& points, std::vector<ifs::Vector<Dim>>& vertices) {
        for (const Point& point : points) {
            if (point.dimension() == Dim)
                vertices.push_back(vectorOf<Dim>(point.coordinates));
            else
                append(outcome.kept, point.lines);
        }
    };
    take(m_rest, cage.rest);
    take(m_current, cage.current);
    if (cage.rest.empty() && cage.current.empty()) {
        if (outcome.kept.size() > before) append(outcome.kept, m_deformationLines);
    } else if (ifs::isValid(cage)) {
        shape.cage = std::move(cage);
    } else {
        outcome.sentences << (Dim == 2
                                  ? Text::tr("The stored cage is not valid and is not applied: its lists of "
                                             "vertices do not match, or its rest polygon is flat, crosses "
                                             "itself or has more than 64 vertices.")
                                  : Text::tr("The stored cage is not valid and is not applied: its lists of "
                                             "vertices do not match, or its vertices at rest are in one "
                                             "plane or coincide."));
    }
}

template <int Dim> void MetadataComments::applyBranches(document::Shape<Dim>& shape, Outcome& outcome) const {
    const auto& maps = shape.system.maps;
    const auto isHere = [](const Point& point) { return point.dimension() == Dim; };
    std::size_t pieces = 0;
    for (const Branch& branch : m_branches) {
        if (!branch.by.empty() && std::ranges::none_of(branch.by, isHere)) {
            append(outcome.kept, branch.lines);
            for (const Point& point : branch.by)
                append(outcome.kept, point.lines);
            continue;
        }
        document::MovedBranch<Dim> moved;
        const bool recurs = !branch.word.empty() && branch.word.front() == 0;
        for (const int symbol : std::span(branch.word).subspan(recurs ? 1 : 0))
            if (std::size_t(symbol) <= maps.size()) moved.word.push_back(maps[std::size_t(symbol - 1)].id);
        const bool isAddress = !moved.word.empty();
        if (recurs) moved.word = document::recurringWord(std::move(moved.word));
        pieces += moved.word.size() * maps.size();
        const bool known = std::ranges::find(shape.moved, moved.word, &document::MovedBranch<Dim>::word) !=
                           shape.moved.end();
        if (branch.by.size() != Dim + 1 || !std::ranges::all_of(branch.by, isHere) || !isAddress ||
            moved.word.size() != branch.word.size() || known || pieces > maxPieces) {
            outcome.sentences << Text::tr(
                "The stored position of a branch is not valid and is not applied: its map is incomplete, its "
                "address names maps that do not exist or occurs twice, or there are too many.");
            continue;
        }
        for (int i = 0; i < Dim; ++i)
            moved.change.linear.row(i) = vectorOf<Dim>(branch.by[std::size_t(i)].coordinates).transpose();
        moved.change.translation = vectorOf<Dim>(branch.by[Dim].coordinates);
        shape.moved.push_back(std::move(moved));
    }
}

template <int Dim>
void MetadataComments::applyToMaps(ifs::IteratedFunctionSystem<Dim>& system,
                                   attractor::MapColours& mapColours, QStringList& sentences) const {
    auto& maps = system.maps;
    const auto mapAt = [&](int number) {
        return static_cast<std::size_t>(number) <= maps.size() ? &maps[static_cast<std::size_t>(number - 1)]
                                                               : nullptr;
    };
    for (const MapSetting& setting : m_unweighted) {
        if (setting.map == 0)
            for (auto& map : maps)
                map.weight.reset();
        else if (auto* map = mapAt(setting.map))
            map->weight.reset();
    }
    std::vector<MapSetting> colours = m_colours;
    std::ranges::stable_sort(colours, {}, &MapSetting::map); // order of the ids; the last one counts
    for (const MapSetting& setting : colours)
        if (const auto* map = mapAt(setting.map)) mapColours[map->id] = setting.colour;
    for (const MapSetting& setting : m_off) {
        auto* map = mapAt(setting.map);
        if (map == nullptr || (map->weight && *map->weight != 0)) {
            sentences << Text::tr("Map %1 was switched off here, but another program has given it a weight.")
                             .arg(setting.map);
            continue;
        }
        map->enabled = false;
        map->weight = setting.weight;
    }
    // Rows switched off by another program stay off. If no map lacks a weight, the rows hold the weights
    // themselves.
    if (std::ranges::none_of(maps, lacksWeight<Dim>)) return;
    for (const MapSetting& setting : m_weights)
        if (auto* map = mapAt(setting.map); map && map->enabled && map->weight.value_or(0) > 0)
            map->weight = setting.weight;
}

MetadataComments::Outcome MetadataComments::applyTo(document::Fractal& fractal) const {
    Outcome outcome;
    fractal.appearance = m_colouring.appearance();
    fractal.inSpace = m_inSpace.appearance();
    if (const auto palette = m_colouring.palette())
        fractal.appearance.palette = *palette;
    else if (m_colouring.namesPalette())
        outcome.sentences << Text::tr("The stored palette “%1” is unknown and is not applied.")
                                 .arg(QString::fromStdString(m_colouring.paletteName()));
    const auto apply = [&](auto& shape) {
        applyCage(shape, outcome);
        applyBranches(shape, outcome);
        if (!outcome.kept.empty())
            outcome.sentences << Text::tr("This entry is %1-dimensional, but its stored cage or moved "
                                          "branches are not: they are not applied, and their lines are "
                                          "kept.")
                                     .arg(document::dimension(fractal));
        applyToMaps(shape.system, fractal.appearance.mapColours, outcome.sentences);
        m_typed.applyTo(shape.system);
        m_labels.applyTo(fractal);
        m_blends.applyTo(fractal);
        if (const auto flaw = m_symmetry.applyTo(shape.system)) {
            outcome.sentences << *flaw;
            append(outcome.kept, m_symmetry.lines());
        }
        const LinkComments::Outcome links = m_links.applyTo(shape.system);
        if (!links.sentence.isEmpty()) outcome.sentences << links.sentence;
        if (links.kept) append(outcome.kept, m_links.lines());
        AnimationComments::Outcome animation = m_animations.applyTo(shape);
        outcome.sentences << animation.sentences;
        append(outcome.kept, animation.kept);
    };
    if (auto* plane = document::plane(fractal)) {
        apply(*plane);
    } else if (auto* space = document::space(fractal)) {
        apply(*space);
    } else {
        for (const auto* points : {&m_rest, &m_current})
            for (const Point& point : *points)
                append(outcome.kept, point.lines);
        append(outcome.kept, m_deformationLines);
        append(outcome.kept, m_symmetry.lines());
        append(outcome.kept, m_links.lines());
        append(outcome.kept, m_animations.lines());
        for (const Branch& branch : m_branches) {
            append(outcome.kept, branch.lines);
            for (const Point& point : branch.by)
                append(outcome.kept, point.lines);
        }
    }
    std::ranges::sort(outcome.kept);
    return outcome;
}

} // namespace io
