// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_actions.h"
#include "document/fractal/fractal_geometry.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/edits/timeline/keyed_maps.h"
#include "document/fractal/fractal.h"
#include "document/fractal/space_geometry.h"
#include "ifs/cage/control_cage.h"

#include <QCoreApplication>

namespace document {

namespace {

struct Actions {
    Q_DECLARE_TR_FUNCTIONS(document::CageActions)
};

using Failure = std::optional<QString>;

QString notPlanar() {
    return Actions::tr("This entry is not a system in the plane, so it has no control cage.");
}

QString tooFlat() {
    return Actions::tr(
        "The cage is too flat to be inverted. Open it by dragging a corner, or reset it, and try again.");
}

QString onOneLine() {
    return Actions::tr(
        "The three points are on one line, so they define no coordinates. Click a third point off the line.");
}

QString inOnePlane() {
    return Actions::tr(
        "The four points are in one plane, so they define no coordinates. Click the fourth point "
        "off the plane.");
}

} // namespace

bool isPlacementInvertible(const Fractal& fractal) {
    const ifs::ControlCage<2>* cage = cage2(fractal);
    return !cage || ifs::isInvertible(*cage);
}

Failure fitMinimalCanonicalSimplex(Document& document) {
    const Fractal& fractal = document.fractal();
    if (const QString obstacle = fitObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    auto fitted = withCageFitted(fractal, SimplexChoice::Minimal);
    if (!fitted) return tooFlat();
    if (isCageAlike(fractal, *fitted))
        return Actions::tr("The cage is already the minimal canonical simplex.");
    document.edit(Actions::tr("Fit the minimal canonical simplex"), *std::move(fitted));
    return std::nullopt;
}

Failure resetCage(Document& document) {
    const Fractal& fractal = document.fractal();
    if (const QString obstacle = resetObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    document.edit(Actions::tr("Reset the cage"), withCageAtRest(fractal));
    return std::nullopt;
}

Failure resetVertex(Document& document, int index) {
    const Fractal& fractal = document.fractal();
    if (!system2(fractal)) return notPlanar();
    const ifs::ControlCage<2> cage = effectiveCage(fractal);
    return moveVertex(document, index, cage.rest.at(std::size_t(index)));
}

QString bakeObstacle(const Document& document) {
    const QString obstacle = bakeObstacle(document.fractal());
    return obstacle.isEmpty() ? rewriteObstacle(document.entryFractal()) : obstacle;
}

QString moveCageObstacle(const Document& document) {
    return document.cageMode() == CageMode::Rewrite ? rewriteObstacle(document.entryFractal()) : QString();
}

Failure bakeCage(Document& document) {
    if (const QString obstacle = bakeObstacle(document); !obstacle.isEmpty()) return obstacle;
    auto after = baked(document.fractal());
    if (!after) return tooFlat();
    document.edit(Actions::tr("Bake the placement into the code"), *std::move(after));
    return std::nullopt;
}

Failure defineTriangle(Document& document, const ifs::Simplex<2>& vertices) {
    Fractal fractal = document.fractal();
    if (!system2(fractal)) return notPlanar();
    if (!ifs::isAffineBasis<2>(vertices)) return onOneLine();
    auto& cage = plane(fractal)->cage;
    if (cage && ifs::bends(*cage)) return fitObstacle(fractal);
    cage = ifs::redefine<2>(effectiveCage(fractal), vertices);
    if (!cage) return tooFlat();
    document.edit(Actions::tr("Define the control triangle"), std::move(fractal));
    return std::nullopt;
}

Failure defineTetrahedron(Document& document, const ifs::Simplex<3>& vertices) {
    const Fractal& fractal = document.fractal();
    if (const QString obstacle = spaceObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    const auto& cage = space(fractal)->cage;
    if (cage && ifs::bends(*cage)) return fitObstacle(fractal);
    if (!ifs::isAffineBasis<3>(vertices)) return inOnePlane();
    auto defined = withCageThrough(fractal, {vertices.begin(), vertices.end()});
    if (!defined) return tooFlat();
    document.edit(Actions::tr("Define the control tetrahedron"), *std::move(defined));
    return std::nullopt;
}

Failure moveVertex(Document& document, int index, const ifs::Vector<2>& position) {
    Fractal fractal = document.fractal();
    if (!system2(fractal)) return notPlanar();
    ifs::ControlCage<2> cage = effectiveCage(fractal);
    if (cage.current.at(std::size_t(index)) == position)
        return Actions::tr("Vertex %1 is already there.").arg(index + 1);
    if (const QString obstacle = moveCageObstacle(document); !obstacle.isEmpty()) return obstacle;
    cage.current[std::size_t(index)] = position;
    document.edit(
        Actions::tr("Move vertex %1 to (%2, %3)").arg(index + 1).arg(position.x()).arg(position.y()),
        withCageMoved(std::move(fractal), std::move(cage), document.cageMode()));
    return std::nullopt;
}

Failure insertVertex(Document& document, int edge, double share) {
    Fractal fractal = document.fractal();
    if (!system2(fractal)) return notPlanar();
    const ifs::ControlCage<2> cage = effectiveCage(fractal);
    if (cage.rest.size() >= ifs::maxCorners)
        return Actions::tr("A cage can have at most %1 vertices.").arg(ifs::maxCorners);
    auto after = ifs::withVertexInserted(cage, std::size_t(edge), share);
    if (!after) return Actions::tr("There is no room for a vertex here.");
    plane(fractal)->cage = std::move(after);
    document.edit(Actions::tr("Insert a vertex"), std::move(fractal));
    return std::nullopt;
}

Failure removeVertices(Document& document, const std::vector<std::size_t>& vertices) {
    Fractal fractal = document.fractal();
    if (!system2(fractal)) return notPlanar();
    const ifs::ControlCage<2> cage = effectiveCage(fractal);
    const bool one = vertices.size() == 1;
    if (cage.rest.size() < 3 + vertices.size()) return Actions::tr("A cage needs at least three vertices.");
    std::optional after(cage);
    for (std::size_t k = vertices.size(); k-- > 0 && after;)
        after = ifs::withVertexRemoved(*after, vertices[k]);
    if (!after)
        return one ? Actions::tr("Without this vertex the cage at rest would cross itself or be flat.")
                   : Actions::tr("Without these vertices the cage at rest would cross itself or be flat.");
    plane(fractal)->cage = std::move(after);
    document.edit(one ? Actions::tr("Delete vertex %1").arg(vertices.front() + 1)
                      : Actions::tr("Delete %1 vertices").arg(vertices.size()),
                  std::move(fractal));
    return std::nullopt;
}

Failure makeCageRegular(Document& document) {
    const Fractal& fractal = document.fractal();
    if (!system2(fractal)) return notPlanar();
    if (const QString obstacle = moveCageObstacle(document); !obstacle.isEmpty()) return obstacle;
    ifs::ControlCage<2> cage = effectiveCage(fractal);
    const auto regular = ifs::regularPolygonNear(cage.current);
    if (!regular) return tooFlat();
    cage.current = *regular;
    Fractal after = withCageMoved(fractal, std::move(cage), document.cageMode());
    if (isCageAlike(fractal, after)) return Actions::tr("The cage is already regular.");
    document.edit(Actions::tr("Make the cage regular"), std::move(after));
    return std::nullopt;
}

Failure unbakeCage(Document& document) {
    const Fractal& fractal = document.fractal();
    if (const QString obstacle = unbakeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (const QString obstacle = rewriteObstacle(document.entryFractal()); !obstacle.isEmpty())
        return obstacle;
    auto after = unbaked(fractal);
    if (!after) return tooFlat();
    document.edit(Actions::tr("Unbake: extract the placement from the code"), *std::move(after));
    return std::nullopt;
}

} // namespace document
