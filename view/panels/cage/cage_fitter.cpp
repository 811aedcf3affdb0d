// SPDX-License-Identifier: MIT
#include "panels/cage/cage_fitter.h"

#include "document/document.h"
#include "io/file/background.h"

#include <chrono>
#include <utility>

namespace view {

namespace {

constexpr std::chrono::milliseconds fitPatience{50}; // for a cage in space

} // namespace

CageFitter::CageFitter(document::Document* document) : m_document(document) {
    connect(&m_fitting, &QFutureWatcherBase::finished, this, &CageFitter::takeFitted);
}

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

// Of very many maps in the background: it is done when it is found, unless something else has been done
// since.
void CageFitter::fitInSpace(const Fitting& fitting) {
    const QString obstacle = fitObstacle(m_document->fractal());
    if (!obstacle.isEmpty()) return fitTo(std::nullopt, obstacle);
    m_isFitting = true;
    m_fitting.setFuture(
        io::inBackground<Fitted>([fitting, fractal = m_document->sharedFractal()](QPromise<Fitted>& promise) {
            promise.addResult(Fitted{fractal, fitting(*fractal)});
        }));
    if (io::finishesWithin(fitPatience, m_fitting.future())) takeFitted();
}

void CageFitter::takeFitted() {
    if (!std::exchange(m_isFitting, false) || m_fitting.future().resultCount() == 0) return;
    const Fitted fitted = m_fitting.result();
    if (fitted.from == m_document->sharedFractal())
        fitTo(fitted.to, tr("The picture is too thin for such a cage."));
}

void CageFitter::fitTo(std::optional<document::Fractal> fitted, const QString& obstacle) {
    if (!fitted)
        emit message(obstacle);
    else if (isCageAlike(m_document->fractal(), *fitted))
        emit message(tr("The cage is already there."));
    else
        m_document->edit(tr("Fit the cage"), *std::move(fitted));
}

} // namespace view
