// SPDX-License-Identifier: MIT
#include "panels/cage/cage_fitter.h"

#include "document/document.h"

#include <utility>

namespace view {

CageFitter::CageFitter(document::Document* document) : m_document(document), m_fitting(document) {}

void CageFitter::fit(document::SimplexChoice choice) {
    auto fitted = withCageFitted(m_document->fractal(), choice);
    const QString obstacle = fitted ? QString() : fitObstacle(m_document->fractal());
    fitTo(std::move(fitted), obstacle);
}

void CageFitter::fit(document::PolygonChoice choice, int corners) {
    const QString obstacle = fitObstacle(m_document->fractal());
    auto fitted = obstacle.isEmpty() ? withCageAround(m_document->fractal(), choice, corners) : std::nullopt;
    fitTo(std::move(fitted), obstacle.isEmpty() ? tr("The picture is too thin for such a cage.") : obstacle);
}

void CageFitter::fitTetrahedron(const std::optional<ifs::Orientation<3>>& orientation) {
    fitInSpace([orientation](const document::Fractal& fractal) {
        return document::withTetrahedronFitted(fractal, orientation);
    });
}

void CageFitter::fitBox() {
    fitInSpace(&document::withBoxFitted);
}

void CageFitter::fitPolyhedron(document::SpacePolyhedron choice, int corners) {
    fitInSpace([choice, corners](const document::Fractal& fractal) {
        return document::withPolyhedronFitted(fractal, choice, corners);
    });
}

void CageFitter::fitInSpace(BackgroundEdit::Find find) {
    const QString obstacle = fitObstacle(m_document->fractal());
    if (!obstacle.isEmpty()) return fitTo(std::nullopt, obstacle);
    m_fitting.start(std::move(find), [this](std::optional<document::Fractal> fitted) {
        fitTo(std::move(fitted), tr("The picture is too thin for such a cage."));
    });
}

void CageFitter::fitTo(std::optional<document::Fractal> fitted, const QString& obstacle) {
    if (!fitted)
        emit message(obstacle);
    else if (isCageAlike(m_document->fractal(), *fitted))
        emit message(tr("The cage already has this shape."));
    else
        m_document->edit(tr("Fit the cage"), *std::move(fitted));
}

} // namespace view
