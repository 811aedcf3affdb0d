// SPDX-License-Identifier: MIT
#include "canvas/scene/transient_marks.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/items/analysis_item.h"
#include "canvas/items/border_arrows_item.h"
#include "canvas/items/canvas_marks.h"
#include "canvas/items/readout_item.h"
#include "canvas/items/trail_item.h"

#include <utility>

namespace view {

TransientMarks::TransientMarks()
    : m_analysisItem(std::make_unique<AnalysisItem>()),
      m_trailItem(std::make_unique<TrailItem>()),
      m_rubberItem(std::make_unique<RubberItem>()),
      m_snapMark(std::make_unique<SnapMark>()),
      m_bandItem(std::make_unique<BandItem>()),
      m_borderArrows(std::make_unique<BorderArrowsItem>()),
      m_readoutItem(std::make_unique<ReadoutItem>()) {}

TransientMarks::~TransientMarks() = default;

std::vector<OverlayItem*> TransientMarks::itemsBelowHandles() const {
    return {m_analysisItem.get(), m_trailItem.get()};
}

std::vector<OverlayItem*> TransientMarks::itemsAboveHandles() const {
    return {m_borderArrows.get(), m_rubberItem.get(), m_snapMark.get(), m_bandItem.get(),
            m_readoutItem.get()};
}

void TransientMarks::setView(const attractor::Camera& camera) {
    m_camera = camera;
    m_analysisItem->setView(camera);
    m_snapMark->setRotation(-attractor::degreesOf(camera.rotation)); // parallel to the grid
    const QRectF area(0, 0, camera.width, camera.height);
    m_readoutItem->setView(area);
    m_borderArrows->setView(area);
    showSnap(m_snap);
    showRubber(m_clicked, m_rubberEnd);
    showTrail(m_trail);
}

void TransientMarks::showSnap(const std::optional<Snapped>& snap) {
    m_snap = snap;
    m_snapMark->setSnap(snap, snap ? pixelOf(m_camera, snap->point) : QPointF());
}

void TransientMarks::showReadout(const QString& text, const QPointF& pointer) {
    m_readoutItem->setText(text, pointer);
}

const QString& TransientMarks::readout() const {
    return m_readoutItem->text();
}

void TransientMarks::setFont(const QFont& font) {
    m_readoutItem->setFont(font);
}

void TransientMarks::showBand(const QRectF& band) {
    m_bandItem->setBand(band);
}

void TransientMarks::showRubber(const std::vector<ifs::Vector<2>>& clicked,
                                const std::optional<ifs::Vector<2>>& pointer) {
    m_clicked = clicked;
    m_rubberEnd = pointer;
    m_rubberItem->setPoints(pixelsOf(m_camera, clicked),
                            pointer ? std::optional(pixelOf(m_camera, *pointer)) : std::nullopt);
}

void TransientMarks::showOutlines(std::vector<document::OutlineShape> shapes,
                                  std::vector<document::OutlineShape> outer) {
    m_cylinders.setShapes(shapes, std::move(outer));
    m_analysisItem->setShapes(std::move(shapes));
}

bool TransientMarks::chooseCylinderAt(const QPointF& position) {
    const bool isAnother = m_cylinders.chooseAt(m_camera, position);
    if (isAnother) m_analysisItem->update();
    return isAnother;
}

void TransientMarks::showTrail(const std::vector<ifs::Vector<2>>& points) {
    m_trail = points;
    m_trailItem->setPoints(pixelsOf(m_camera, points));
}

} // namespace view
