// SPDX-License-Identifier: MIT
#include "canvas/canvas_note.h"

#include "cage_edits.h"
#include "ifs/attractor_existence.h"
#include "ifs/branch.h"
#include "ifs/iterated_function_system.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <span>

namespace view {

namespace {

struct Notes {
    Q_DECLARE_TR_FUNCTIONS(view::Canvas)
};

QString number(double value) {
    return QString::number(value, 'g', 4);
}

// The witness of a verdict, in the numbers that the user counts by.
struct Witness {
    QString word;
    QString stretch; // its largest singular value
    QString radius;  // its spectral radius
};

Witness described(std::span<const ifs::AffineMap<2>> maps, const std::vector<std::size_t>& index,
                  const std::vector<int>& word) {
    const ifs::AffineMap<2> map = ifs::composed<2>(maps, word);
    QStringList address;
    for (const int letter : word)
        address << QString::number(index[std::size_t(letter)] + 1);
    return {address.join(QLatin1Char(' ')), number(ifs::spectralNorm(map.linear)),
            number(ifs::spectralRadius(map.linear))};
}

QString noAttractor(const ifs::ActiveMaps<2>& active, const std::vector<int>& witness) {
    const auto [word, stretch, radius] = described(active.maps, active.index, witness);
    if (witness.size() == 1)
        return Notes::tr(
                   "No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). "
                   "Make it smaller, or switch it off.")
            .arg(word, stretch, radius);
    return Notes::tr(
               "No attractor: the maps %1, one after the other, do not contract (largest singular value %2, "
               "spectral radius %3). Make one of them smaller, or switch it off.")
        .arg(word, stretch, radius);
}

// The renderer only says that the picture is not to be trusted; the reason is looked for here.
QString doubtful(const document::System2& system) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    const ifs::Existence existence = ifs::classify<2>(active.maps);
    if (existence.verdict == ifs::Verdict::None && !existence.witness.empty())
        return noAttractor(active, existence.witness);
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        const double stretch = ifs::spectralNorm(active.maps[i].linear);
        if (stretch >= 1)
            return Notes::tr(
                       "It is not settled whether this system has an attractor: map %1 stretches by %2. "
                       "Points that run away are left out.")
                .arg(active.index[i] + 1)
                .arg(number(stretch));
    }
    return Notes::tr(
        "It is not settled whether this system has an attractor. Points that run away are left out.");
}

bool isOnePoint(const document::System2& system) {
    return ifs::countActive(system) == 1;
}

QString onePoint(const document::Fractal& fractal) {
    const auto displayed = document::effectiveSystem(fractal);
    const auto point = displayed ? ifs::fixedPoint(ifs::activeMaps(*displayed).maps.front()) : std::nullopt;
    if (!point) return Notes::tr("One map alone: nothing is left but its fixed point.");
    return Notes::tr("One map alone: nothing is left but its fixed point (%1, %2).")
        .arg(number(point->x()), number(point->y()));
}

} // namespace

QString stopNote(const document::System2& system, const ifs::SafeWay& way) {
    const std::vector<std::size_t> index = ifs::activeMaps(system).index;
    if (way.verdict.verdict == ifs::Verdict::None) {
        const auto [word, stretch, radius] = described(way.past, index, way.verdict.witness);
        const QString sentence =
            way.verdict.witness.size() == 1
                ? Notes::tr("Stopped: any farther, map %1 would not contract (largest singular value %2, "
                            "spectral radius %3), and there would be no attractor.")
                : Notes::tr("Stopped: any farther, the maps %1, one after the other, would not contract "
                            "(largest singular value %2, spectral radius %3), and there would be no "
                            "attractor.");
        return sentence.arg(word, stretch, radius);
    }
    const auto largest = std::ranges::max_element(
        way.past, {}, [](const ifs::AffineMap<2>& map) { return ifs::spectralNorm(map.linear); });
    return Notes::tr(
               "Stopped: any farther, it is not settled whether there would be an attractor (map %1 has "
               "the largest singular value, %2).")
        .arg(index[std::size_t(largest - way.past.begin())] + 1)
        .arg(number(ifs::spectralNorm(largest->linear)));
}

QString noteOn(const document::Fractal& fractal, attractor::RenderNote note) {
    const document::System2* system = document::system2(fractal);
    if (!system)
        return document::dimension(fractal) == 3
                   ? Notes::tr("This entry is a system in space: not yet shown. It is kept as it is.")
                   : Notes::tr("This entry could not be read. Its text is kept as it is in the file.");
    switch (note) {
    case attractor::RenderNote::None:
        return isOnePoint(*system) ? onePoint(fractal) : cageWarning(fractal);
    case attractor::RenderNote::NoMaps:
        if (ifs::countActive(*system) == 0 &&
            std::ranges::any_of(system->maps, [](const auto& map) { return map.enabled; }))
            return Notes::tr(
                "No map that is on has a weight above 0, so there is nothing to draw. Give one a "
                "weight.");
        return Notes::tr("No map takes part, so there is nothing to draw. Add a map or switch one on.");
    case attractor::RenderNote::NoAttractor:
    case attractor::RenderNote::Undecided:
        return doubtful(*system);
    case attractor::RenderNote::TooDeep:
        return Notes::tr("This is as deep as the arithmetic reaches: zoom out a little for a true picture.");
    case attractor::RenderNote::FewerIterations:
        return Notes::tr(
            "Drawn with fewer iterations than asked for: more would need more memory than allowed.");
    case attractor::RenderNote::Degenerate:
        return Notes::tr(
            "The cage is flat, and so is the picture. Drag a vertex to open it: nothing is lost.");
    }
    return {};
}

} // namespace view
