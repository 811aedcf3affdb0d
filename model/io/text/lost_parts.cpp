// SPDX-License-Identifier: MIT
#include "io/text/lost_parts.h"

#include "attractor/request/appearance_fields.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/edits/maps/symmetry_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/saved_views.h"
#include "document/text/text.h"
#include "document/tops/kept_theft.h"

#include <QStringList>

#include <algorithm>

namespace io {

namespace {

struct Held {
    bool cage = false;
    bool moved = false;
    bool linked = false;
    bool named = false; // true if any map has a name
};

// Returns true if links make a difference: between the maps that take part, or by excluding some.
template <int Dim> bool linksMatter(const ifs::IteratedFunctionSystem<Dim>& system) {
    if (system.links.empty()) return false;
    auto unlinked = system;
    unlinked.links.clear();
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    return active.isLinked() || active.maps.size() != ifs::countActive(unlinked);
}

Held heldBy(const document::Fractal& fractal) {
    const auto of = [&labels = fractal.mapLabels](const auto& shape) {
        const bool isNamed =
            !labels.isEmpty() && std::ranges::any_of(shape.system.maps, [&](const auto& map) {
                return !labels.of(map.id).name.isEmpty();
            });
        return Held{shape.cage.has_value(), !shape.moved.empty(), linksMatter(shape.system), isNamed};
    };
    if (const auto* plane = document::plane(fractal)) return of(*plane);
    if (const auto* space = document::space(fractal)) return of(*space);
    return {};
}

} // namespace

namespace {

std::optional<QString> lostParts(const KeptParts& kept, const document::Fractal& fractal) {
    const attractor::Appearance usual = document::Fractal{}.appearance;
    attractor::Appearance rest = fractal.appearance;
    const Held held = heldBy(fractal);
    QStringList lost;
    if (held.cage) lost << Text::tr("its cage");
    if (held.moved) lost << Text::tr("its moved branches");
    const bool losesLinks = held.linked && !kept.links;
    if (document::keptTheft(fractal) && !kept.transformation) lost << Text::tr("its fractal transformation");
    if (document::animationFacts(fractal)) lost << Text::tr("its animation");
    if (!document::savedViews(fractal).empty()) lost << Text::tr("its saved views");
    if (losesLinks) lost << Text::tr("the links of its maps");
    if (held.named && !kept.mapNames) lost << Text::tr("the names of its maps");
    if (!document::lockedMaps(fractal).empty()) lost << Text::tr("the locks of its maps");
    if (!kept.palette && !(rest.palette == usual.palette)) lost << Text::tr("its palette");
    if (!kept.background && !(rest.background == usual.background)) lost << Text::tr("its background");
    rest.palette = usual.palette;
    rest.background = usual.background;
    if (kept.colourBy) rest.colourBy = usual.colourBy;
    if (kept.mapColours) rest.mapColours = usual.mapColours;
    if (kept.mapBlends) rest.mapBlends = usual.mapBlends;
    if (kept.tones) {
        rest.contrast = usual.contrast;
        rest.vibrancy = usual.vibrancy;
    }
    if (rest.shadow > 0) lost << Text::tr("its shadow");
    for (const auto& number : attractor::appearanceNumbers)
        if (number.part == attractor::AppearanceNumber::Part::Shadow)
            rest.*number.member = usual.*number.member;
    if (!(rest == usual)) lost << Text::tr("its other colour settings");
    if (lost.isEmpty()) return std::nullopt;
    const QString last = lost.takeLast();
    const QString all =
        lost.isEmpty() ? last : Text::tr("%1 and %2").arg(lost.join(QStringLiteral(", ")), last);
    const bool isDifferent = held.moved || losesLinks || !document::isAtRest(fractal);
    return isDifferent ? Text::tr("“%1” is written without %2: other programs will draw a different picture.")
                             .arg(fractal.name, all)
                       : Text::tr("“%1” is written without %2.").arg(fractal.name, all);
}

std::optional<QString> lostSymmetry(const KeptParts& kept, const document::Fractal& fractal) {
    if (kept.symmetry || !document::isSymmetric(fractal)) return std::nullopt;
    return Text::tr("The symmetry of “%1” is written as the maps that it stands for.").arg(fractal.name);
}

} // namespace

std::optional<QString> lossBeside(const KeptParts& kept, const document::Fractal& fractal) {
    const auto parts = lostParts(kept, fractal), symmetry = lostSymmetry(kept, fractal);
    if (parts && symmetry) return *parts + u' ' + *symmetry;
    return parts ? parts : symmetry;
}

} // namespace io
