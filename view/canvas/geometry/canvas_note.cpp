// SPDX-License-Identifier: MIT
#include "canvas/geometry/canvas_note.h"

#include "desktop/shortcuts.h"
#include "document/document.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/links/linked_existence.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"

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
    QString stretch; // largest singular value
    QString radius;  // spectral radius
};

template <int Dim>
Witness described(std::span<const ifs::AffineMap<Dim>> maps, const std::vector<std::size_t>& index,
                  const std::vector<int>& word) {
    const ifs::AffineMap<Dim> map = ifs::composed<Dim>(maps, word);
    QStringList address;
    for (const int letter : word)
        address << QString::number(index[std::size_t(letter)] + 1);
    return {address.join(QLatin1Char(' ')), number(ifs::spectralNorm<Dim>(map.linear)),
            number(ifs::spectralRadius<Dim>(map.linear))};
}

QString noAttractor(const ifs::ActiveMaps<2>& active, const std::vector<int>& witness) {
    const auto [word, stretch, radius] = described<2>(active.maps, active.index, witness);
    if (witness.size() == 1)
        return Notes::tr(
                   "No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). "
                   "Make it smaller, or switch it off.")
            .arg(word, stretch, radius);
    return Notes::tr("No attractor: the maps %1, applied one after the other, do not contract (largest "
                     "singular value %2, spectral radius %3). Make one of them smaller, or switch it off.")
        .arg(word, stretch, radius);
}

// The proved verdict on the maps, if there is one: it is known at once, while the last picture may be of
// other maps.
template <int Dim>
attractor::RenderNote provedNote(const ifs::IteratedFunctionSystem<Dim>& system,
                                 attractor::RenderNote drawn) {
    using enum attractor::RenderNote;
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    const bool isDoubtful = drawn == NoAttractor || drawn == Undecided;
    const auto contracts = [](const auto& map) { return ifs::spectralNorm<Dim>(map.linear) < 1; };
    if (!isDoubtful && std::ranges::all_of(active.maps, contracts)) return drawn;
    switch (ifs::classifyLinked<Dim>(active).verdict) {
    case ifs::Verdict::None:
        return NoAttractor;
    case ifs::Verdict::Hyperbolic:
    case ifs::Verdict::EventuallyContractive:
        return isDoubtful ? None : drawn;
    case ifs::Verdict::Undecided:
    case ifs::Verdict::Empty:
        break;
    }
    return drawn;
}

// The renderer only says that the picture is not to be trusted; the reason is looked for here.
QString doubtful(const document::System2& system) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    const ifs::Existence existence = ifs::classifyLinked<2>(active);
    if (existence.verdict == ifs::Verdict::None && !existence.witness.empty())
        return noAttractor(active, existence.witness);
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        const double stretch = ifs::spectralNorm(active.maps[i].linear);
        if (stretch >= 1)
            return Notes::tr("It is undecided whether this system has an attractor: map %1 stretches by up "
                             "to %2. Points that escape are left out.")
                .arg(active.index[i] + 1)
                .arg(number(stretch));
    }
    return Notes::tr(
        "It is undecided whether this system has an attractor. Points that escape are left out.");
}

bool isOnePoint(const document::System2& system) {
    return ifs::countActive(system) == 1;
}

QString onePoint(const document::Fractal& fractal) {
    const auto displayed = document::effectiveSystem(fractal);
    const auto point = displayed ? ifs::fixedPoint(ifs::activeMaps(*displayed).maps.front()) : std::nullopt;
    if (!point) return Notes::tr("With a single map, only its fixed point is left.");
    return Notes::tr("With a single map, only its fixed point (%1, %2) is left.")
        .arg(number(point->x()), number(point->y()));
}

} // namespace

template <int Dim>
QString stopNote(const ifs::IteratedFunctionSystem<Dim>& system, const ifs::SafeWay<Dim>& way) {
    const std::vector<std::size_t> index = ifs::activeMaps(system).index;
    if (way.verdict.verdict == ifs::Verdict::None) {
        const auto [word, stretch, radius] = described<Dim>(way.past, index, way.verdict.witness);
        const QString sentence =
            way.verdict.witness.size() == 1
                ? Notes::tr("Stopped: beyond this, map %1 would not contract (largest singular value %2, "
                            "spectral radius %3), and there would be no attractor.")
                : Notes::tr(
                      "Stopped: beyond this, the maps %1, applied one after the other, would not contract "
                      "(largest singular value %2, spectral radius %3), and there would be no attractor.");
        return sentence.arg(word, stretch, radius);
    }
    const auto largest = std::ranges::max_element(
        way.past, {}, [](const ifs::AffineMap<Dim>& map) { return ifs::spectralNorm<Dim>(map.linear); });
    return Notes::tr("Stopped: beyond this, an attractor is not guaranteed (map %1 has the largest singular "
                     "value, %2).")
        .arg(index[std::size_t(largest - way.past.begin())] + 1)
        .arg(number(ifs::spectralNorm<Dim>(largest->linear)));
}
template QString stopNote(const document::System2&, const ifs::SafeWay<2>&);
template QString stopNote(const document::System3&, const ifs::SafeWay<3>&);

QString noteOn(const document::Fractal& fractal, attractor::RenderNote note) {
    const document::System2* system = document::system2(fractal);
    if (!system)
        return document::dimension(fractal) == 3
                   ? QString() // already visible in the view of space
                   : Notes::tr("This entry could not be read. Its text is kept unchanged in the file.");
    switch (provedNote(*system, note)) {
    case attractor::RenderNote::None:
        return isOnePoint(*system) ? onePoint(fractal) : cageWarning(fractal);
    case attractor::RenderNote::NoMaps:
        if (ifs::countActive(*system) == 0 &&
            std::ranges::any_of(system->maps, [](const auto& map) { return map.enabled; }))
            return Notes::tr("No map that is switched on has a positive weight, so there is nothing to draw. "
                             "Give one of them a weight.");
        return Notes::tr("No map is active, so there is nothing to draw. Add a map or switch one on.");
    case attractor::RenderNote::NoAttractor:
    case attractor::RenderNote::Undecided:
        return doubtful(*system);
    case attractor::RenderNote::TooDeep:
    case attractor::RenderNote::TooFar: // solids only
        return Notes::tr(
            "This is the limit of numerical precision: zoom out a little for an accurate picture.");
    case attractor::RenderNote::FewerIterations:
        return Notes::tr("Drawn with fewer iterations than requested: more would exceed the memory limit.");
    case attractor::RenderNote::Degenerate:
        return Notes::tr(
            "The cage is flat, and so is the picture. Drag a corner to open it: nothing is lost.");
    }
    return {};
}

QString nothingHere() {
    return Notes::tr("Nothing here. Press %1 to see the whole picture.")
        .arg(toPress(QStringLiteral("fit"), Qt::Key_F));
}

QString modeNote(document::CageMode mode) {
    return mode == document::CageMode::Rewrite ? Notes::tr("Moving the cage rewrites the code") : QString();
}

QString noteInSpace(const document::Fractal& fractal, attractor::RenderNote note, bool isCoarse) {
    const document::System3* system = document::system3(fractal);
    if (!system) return {};
    switch (provedNote(*system, note)) {
    case attractor::RenderNote::None:
    case attractor::RenderNote::FewerIterations:
        return isCoarse ? Notes::tr("So many pieces overlap that parts of this solid may be missing. "
                                    "The look Cloud shows all of it.")
                        : QString();
    case attractor::RenderNote::NoMaps:
        return Notes::tr("No map is active, so there is nothing to draw. Add a map or switch one on.");
    case attractor::RenderNote::NoAttractor:
        return Notes::tr("This system has no attractor, so the picture may be incomplete or empty.");
    case attractor::RenderNote::Undecided:
        return Notes::tr("Whether this system has an attractor is undecided.");
    case attractor::RenderNote::TooDeep:
        return Notes::tr(
            "This is the limit of numerical precision: zoom out a little for an accurate picture.");
    case attractor::RenderNote::TooFar:
        return Notes::tr("What lies far behind this small view may be drawn in the wrong order. Zoom out a "
                         "little for an accurate picture.");
    case attractor::RenderNote::Degenerate:
        return Notes::tr(
            "The cage is flat, and so is the picture. Drag a corner to open it: nothing is lost.");
    }
    return {};
}

} // namespace view
