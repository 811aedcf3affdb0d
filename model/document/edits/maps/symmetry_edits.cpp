// SPDX-License-Identifier: MIT
#include "document/edits/maps/symmetry_edits.h"

#include "document/edits/maps/map_locks.h"
#include "document/text/text.h"

#include <utility>

namespace document {

namespace {

template <class Visit> auto ofSystem(const Fractal& fractal, Visit visit) {
    if (const auto* shape = plane(fractal)) return visit(*shape);
    if (const auto* shape = space(fractal)) return visit(*shape);
    return visit(Shape<2>{});
}

template <int Dim> Fractal withSymmetryIn(Fractal fractal, const ifs::Symmetry<Dim>& symmetry) {
    if (auto* shape = std::get_if<Shape<Dim>>(&fractal.shape)) shape->system.symmetry = symmetry;
    return fractal;
}

template <int Dim> void expand(Shape<Dim>& shape, attractor::Appearance& appearance, MapLabels& mapLabels) {
    const std::size_t copies = ifs::copiesOfEachMap(shape.system);
    ifs::IteratedFunctionSystem<Dim> listed = ifs::expanded(shape.system);
    const bool isByMap = appearance.colourBy == attractor::ColourBy::Map;
    const bool isByBlend = appearance.colourBy == attractor::ColourBy::Blend;
    attractor::MapColours colours;
    attractor::MapBlends blends;
    MapLabels labels;
    const std::size_t count = shape.system.maps.size();
    for (std::size_t i = 0; copies > 1 && i < listed.maps.size(); ++i) {
        const std::size_t of = i / copies;
        const ifs::MapId id = shape.system.maps[of].id;
        if (isByMap || appearance.mapColours.find(id) != nullptr)
            colours[listed.maps[i].id] = attractor::mapColour(appearance, id, of);
        if (isByBlend || appearance.mapBlends.find(id) != nullptr)
            blends[listed.maps[i].id] = attractor::mapBlend(appearance, id, of, count);
        copyLabel(mapLabels, id, labels, listed.maps[i].id, CopyLock::Keep);
    }
    if (copies > 1) {
        appearance.mapColours = std::move(colours);
        appearance.mapBlends = std::move(blends);
        mapLabels = std::move(labels);
    }
    shape.system = std::move(listed);
}

} // namespace

std::size_t symmetryOrder(const Fractal& fractal) {
    return ofSystem(fractal, [](const auto& shape) {
        return ifs::groupOrder(shape.system.symmetry.group, shape.system.symmetry.order);
    });
}

bool isSymmetric(const Fractal& fractal) {
    return symmetryOrder(fractal) > 1;
}

QString symmetryObstacle(const Fractal& fractal, std::size_t groupOrder) {
    const std::size_t maps = ofSystem(fractal, [](const auto& shape) { return shape.system.maps.size(); });
    const bool isLinked = ofSystem(fractal, [](const auto& shape) { return !shape.system.links.empty(); });
    const std::size_t most = isLinked ? ifs::maxSymmetricLinkedMaps : ifs::maxSymmetricMaps;
    if (groupOrder <= 1 || maps <= most / groupOrder) return {};
    return Text::
        tr("“%1” has %2 maps; with a symmetry of %3 elements they would be more than %4, which is the limit.")
            .arg(fractal.name, QString::number(maps), QString::number(groupOrder), QString::number(most));
}

Fractal withSymmetry(Fractal fractal, const ifs::Symmetry<2>& symmetry) {
    return withSymmetryIn(std::move(fractal), symmetry);
}
Fractal withSymmetry(Fractal fractal, const ifs::Symmetry<3>& symmetry) {
    return withSymmetryIn(std::move(fractal), symmetry);
}

QString expandObstacle(const Fractal& fractal) {
    if (!isSymmetric(fractal)) return {};
    const bool moves = ofSystem(fractal, [](const auto& shape) {
        return shape.animation && !(shape.animation->maps.empty() && shape.animation->motions.empty());
    });
    if (!moves) return {};
    return Text::
        tr("The maps of “%1” move in its animation, and the copies that its symmetry makes would not move "
           "with them. Remove the motions and the keys of the maps first.")
            .arg(fractal.name);
}

Fractal expanded(Fractal fractal) {
    if (auto* shape = plane(fractal))
        expand(*shape, fractal.appearance, fractal.mapLabels);
    else if (auto* solid = space(fractal))
        expand(*solid, fractal.appearance, fractal.mapLabels);
    return fractal;
}

} // namespace document
