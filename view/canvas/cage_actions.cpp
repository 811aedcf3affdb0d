// SPDX-License-Identifier: MIT
#include "canvas/cage_actions.h"

#include "cage_edits.h"
#include "document/fractal.h"
#include "ifs/control_cage.h"

#include <QCoreApplication>

namespace view {

namespace {

struct Actions {
    Q_DECLARE_TR_FUNCTIONS(view::CageActions)
};

using Failure = std::optional<QString>;

QString notPlanar() {
    return Actions::tr("This entry is not a system of the plane, so it has no control cage.");
}

QString tooFlat() {
    return Actions::tr(
        "The cage is too flat to be undone. Open it by dragging a vertex, or reset it, and try again.");
}

QString onOneLine() {
    return Actions::tr(
        "The three points lie on one line and hold no coordinates. Put the third one beside the line.");
}

} // namespace

bool isPlacementInvertible(const document::Fractal& fractal) {
    return !fractal.cage || ifs::isInvertible(*fractal.cage);
}

Failure fitMinimalCanonicalSimplex(document::Document& document) {
    const document::Fractal& fractal = document.fractal();
    if (const QString obstacle = fitObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    auto fitted = withCageFitted(fractal, SimplexChoice::Minimal);
    if (!fitted) return tooFlat();
    if (isCageAlike(fractal, *fitted))
        return Actions::tr("The cage is the minimal canonical simplex already.");
    document.edit(Actions::tr("Fit the minimal canonical simplex"), *std::move(fitted));
    return std::nullopt;
}

Failure resetCage(document::Document& document) {
    const document::Fractal& fractal = document.fractal();
    if (const QString obstacle = resetObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    document.edit(Actions::tr("Reset the cage"), withCageAtRest(fractal));
    return std::nullopt;
}

Failure resetVertex(document::Document& document, int index) {
    const document::Fractal& fractal = document.fractal();
    if (!document::system2(fractal)) return notPlanar();
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    return moveVertex(document, index, cage.rest.at(std::size_t(index)));
}

Failure bakeCage(document::Document& document) {
    const document::Fractal& fractal = document.fractal();
    if (const QString obstacle = bakeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    auto after = baked(fractal);
    if (!after) return tooFlat();
    document.edit(Actions::tr("Bake the placement into the code"), *std::move(after));
    return std::nullopt;
}

Failure defineTriangle(document::Document& document, const ifs::Simplex<2>& vertices) {
    document::Fractal fractal = document.fractal();
    if (!document::system2(fractal)) return notPlanar();
    if (!ifs::isAffineBasis<2>(vertices)) return onOneLine();
    if (fractal.cage && ifs::bends(*fractal.cage)) return fitObstacle(fractal);
    fractal.cage = ifs::redefine<2>(document::effectiveCage(fractal), vertices);
    if (!fractal.cage) return tooFlat();
    document.edit(Actions::tr("Define the control triangle"), std::move(fractal));
    return std::nullopt;
}

Failure moveVertex(document::Document& document, int index, const ifs::Vector<2>& position) {
    document::Fractal fractal = document.fractal();
    if (!document::system2(fractal)) return notPlanar();
    ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    if (cage.current.at(std::size_t(index)) == position)
        return Actions::tr("Vertex %1 is there already.").arg(index + 1);
    cage.current[std::size_t(index)] = position;
    document.edit(Actions::tr("Move vertex %1").arg(index + 1),
                  withCageMoved(std::move(fractal), std::move(cage), document.cageMode()));
    return std::nullopt;
}

Failure insertVertex(document::Document& document, int edge, double share) {
    document::Fractal fractal = document.fractal();
    if (!document::system2(fractal)) return notPlanar();
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    if (cage.rest.size() >= ifs::mostCorners)
        return Actions::tr("A cage has at most %1 vertices.").arg(ifs::mostCorners);
    fractal.cage = ifs::withVertexInserted(cage, std::size_t(edge), share);
    if (!fractal.cage) return Actions::tr("There is no room for a vertex here.");
    document.edit(Actions::tr("Insert a vertex"), std::move(fractal));
    return std::nullopt;
}

Failure removeVertices(document::Document& document, const std::vector<std::size_t>& vertices) {
    document::Fractal fractal = document.fractal();
    if (!document::system2(fractal)) return notPlanar();
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    const bool one = vertices.size() == 1;
    if (cage.rest.size() < 3 + vertices.size()) return Actions::tr("A cage has at least three vertices.");
    fractal.cage = cage;
    for (std::size_t k = vertices.size(); k-- > 0 && fractal.cage;)
        fractal.cage = ifs::withVertexRemoved(*fractal.cage, vertices[k]);
    if (!fractal.cage)
        return one ? Actions::tr("Without this vertex the cage at rest would cross itself or be flat.")
                   : Actions::tr("Without these vertices the cage at rest would cross itself or be flat.");
    document.edit(one ? Actions::tr("Delete vertex %1").arg(vertices.front() + 1)
                      : Actions::tr("Delete %1 vertices").arg(vertices.size()),
                  std::move(fractal));
    return std::nullopt;
}

Failure makeCageRegular(document::Document& document) {
    const document::Fractal& fractal = document.fractal();
    if (!document::system2(fractal)) return notPlanar();
    ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    const auto regular = ifs::regularPolygonNear(cage.current);
    if (!regular) return tooFlat();
    cage.current = *regular;
    document::Fractal after = withCageMoved(fractal, std::move(cage), document.cageMode());
    if (isCageAlike(fractal, after)) return Actions::tr("The cage is regular already.");
    document.edit(Actions::tr("Make the cage regular"), std::move(after));
    return std::nullopt;
}

Failure unbakeCage(document::Document& document) {
    const document::Fractal& fractal = document.fractal();
    if (const QString obstacle = unbakeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    auto after = unbaked(fractal);
    if (!after) return tooFlat();
    document.edit(Actions::tr("Unbake: take the placement out of the code"), *std::move(after));
    return std::nullopt;
}

} // namespace view
