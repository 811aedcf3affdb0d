// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/geometry/snapping.h"
#include "canvas/scene/cylinder_choice.h"

#include <QFont>
#include <QRectF>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace view {

class AnalysisItem;
class BandItem;
class BorderArrowsItem;
class OverlayItem;
class ReadoutItem;
class RubberItem;
class SnapMark;
class TrailItem;

// Temporary marks over the picture, of tools, analyses and the chaos game. Points are in the plane.
class TransientMarks {
public:
    TransientMarks();
    ~TransientMarks();

    std::vector<OverlayItem*> itemsBelowHandles() const;
    std::vector<OverlayItem*> itemsAboveHandles() const;
    void setView(const attractor::Camera& camera);

    BorderArrowsItem& borderArrows() { return *m_borderArrows; } // arrows to corners outside the view
    void showSnap(const std::optional<Snapped>& snap);
    void showReadout(const QString& text, const QPointF& pointer); // pixels; empty: none
    const QString& readout() const;
    void setFont(const QFont& font);
    void showBand(const QRectF& band); // rectangle of a selection in pixels; empty: none
    void showRubber(const std::vector<ifs::Vector<2>>& clicked, const std::optional<ifs::Vector<2>>& pointer);
    // Outlines of an analysis; `outer` contain the cylinders among the shapes.
    void showOutlines(std::vector<document::OutlineShape> shapes, std::vector<document::OutlineShape> outer);
    bool chooseCylinderAt(const QPointF& position); // pixels; true if the choice changes
    std::vector<const document::OutlineShape*> cylinderWalk() const { return m_cylinders.walk(); }
    void showTrail(const std::vector<ifs::Vector<2>>& points); // points of a chaos game, newest last

private:
    attractor::Camera m_camera;
    std::optional<Snapped> m_snap;
    std::vector<ifs::Vector<2>> m_clicked;
    std::optional<ifs::Vector<2>> m_rubberEnd;
    std::vector<ifs::Vector<2>> m_trail;
    CylinderChoice m_cylinders;
    std::unique_ptr<AnalysisItem> m_analysisItem;
    std::unique_ptr<TrailItem> m_trailItem;
    std::unique_ptr<RubberItem> m_rubberItem;
    std::unique_ptr<SnapMark> m_snapMark;
    std::unique_ptr<BandItem> m_bandItem;
    std::unique_ptr<BorderArrowsItem> m_borderArrows;
    std::unique_ptr<ReadoutItem> m_readoutItem;
};

} // namespace view
