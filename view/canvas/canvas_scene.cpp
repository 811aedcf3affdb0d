// SPDX-License-Identifier: MIT
#include "canvas/canvas_scene.h"

#include "canvas/attractor_item.h"
#include "canvas/cage_item.h"
#include "canvas/canvas_geometry.h"
#include "canvas/canvas_marks.h"
#include "canvas/canvas_note.h"
#include "canvas/grid_item.h"
#include "canvas/note_item.h"
#include "canvas/trail_item.h"

#include <QFont>
#include <QLineF>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

struct Radii {
    double handle;
    double edge;
};

Radii radii(Reach reach) {
    return reach == Reach::Touch ? Radii{20, 14} : Radii{11, 6};
}

QString coordinates(const attractor::Camera& camera, const ifs::Vector<2>& point) {
    // As many digits as a pixel is worth.
    const int digits = std::clamp(int(std::ceil(std::log10(camera.pixelsPerUnit))) + 1, 0, 15);
    return QStringLiteral("x %1, y %2").arg(point.x(), 0, 'f', digits).arg(point.y(), 0, 'f', digits);
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double squared = QPointF::dotProduct(along, along);
    const double t = squared > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / squared, 0.0, 1.0) : 0;
    return QLineF(p, a + t * along).length();
}

} // namespace

CanvasScene::CanvasScene(document::Document* document, QObject* parent)
    : QGraphicsScene(parent),
      m_document(document),
      m_attractor(std::make_unique<AttractorItem>()),
      m_grid(std::make_unique<GridItem>()),
      m_cageItem(std::make_unique<CageItem>()),
      m_gizmo(std::make_unique<GizmoItem>()),
      m_snapMark(std::make_unique<SnapMark>()),
      m_trailItem(std::make_unique<TrailItem>()),
      m_rubber(std::make_unique<RubberItem>()),
      m_noteItem(std::make_unique<NoteItem>(NoteItem::Place::Top)),
      m_promptItem(std::make_unique<NoteItem>(NoteItem::Place::Bottom)) {
    setItemIndexMethod(QGraphicsScene::NoIndex);
    addItem(m_attractor.get());
    double level = 1;
    for (QGraphicsItem* item : overlays()) {
        item->setZValue(level++);
        addItem(item);
    }
    connect(document, &document::Document::changed, this, &CanvasScene::follow);
    follow({document::Change::Everything});
}

CanvasScene::~CanvasScene() = default;

std::vector<QGraphicsItem*> CanvasScene::overlays() const {
    return {m_grid.get(),   m_trailItem.get(), m_gizmo.get(),    m_cageItem.get(),
            m_rubber.get(), m_snapMark.get(),  m_noteItem.get(), m_promptItem.get()};
}

void CanvasScene::setView(const attractor::Camera& camera, double devicePixelRatio) {
    m_camera = camera;
    const QRectF area(0, 0, camera.width, camera.height);
    setSceneRect(area);
    m_attractor->setView(camera, devicePixelRatio);
    m_grid->setView(camera);
    m_gizmo->setView(area);
    m_noteItem->setView(area);
    m_promptItem->setView(area);
    place();
}

void CanvasScene::setFrame(std::shared_ptr<const attractor::Frame> frame) {
    m_frame = frame;
    m_attractor->setFrame(std::move(frame));
    updateNote();
}

void CanvasScene::setDesktop(const QPalette& palette, const QFont& font) {
    m_palette = palette;
    m_noteItem->setFont(font);
    m_promptItem->setFont(font);
    setFont(font);
    restyle();
}

void CanvasScene::follow(const document::Change& change) {
    using document::Change;
    const document::Fractal& fractal = m_document->fractal();
    if (change.parts & (Change::Current | Change::File)) {
        m_pivot.reset();
        setFocused({});
    }
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) {
        m_cage = document::system2(fractal) ? std::optional(document::effectiveCage(fractal)) : std::nullopt;
        place();
    }
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) {
        m_noteStale = true;
        updateNote();
    }
    if (change.parts & (Change::Appearance | Change::Current | Change::File)) restyle();
}

QPolygonF CanvasScene::cagePolygon() const {
    QPolygonF polygon;
    if (m_cage)
        for (const ifs::Vector<2>& vertex : m_cage->current)
            polygon.append(pixelOf(m_camera, vertex));
    return polygon;
}

ifs::Vector<2> CanvasScene::pivot() const {
    if (m_pivot || !m_cage || m_cage->current.empty()) return m_pivot.value_or(ifs::Vector<2>::Zero());
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const ifs::Vector<2>& vertex : m_cage->current)
        sum += vertex;
    return sum / double(m_cage->current.size());
}

void CanvasScene::setPivot(const std::optional<ifs::Vector<2>>& pivot) {
    m_pivot = pivot;
    place();
}

CanvasPart CanvasScene::partAt(const QPointF& position, Reach reach) const {
    if (!m_cage || !m_overlaysVisible || !m_cageVisible) return {};
    const auto [handle, edge] = radii(reach);
    const QPolygonF polygon = cagePolygon();
    const auto distance = [&](const QPointF& p) { return QLineF(p, position).length(); };
    CanvasPart nearest;
    double least = handle;
    const auto consider = [&, handle = handle](Kind kind, int index, const QPointF& p) {
        if (distance(p) <= least && distance(p) <= handle) {
            least = distance(p);
            nearest = {kind, index};
        }
    };
    consider(Kind::Pivot, 0, m_gizmoLayout.pivot);
    consider(Kind::Scale, 0, m_gizmoLayout.scale);
    consider(Kind::Rotate, 0, m_gizmoLayout.rotate);
    for (int i = 0; i < polygon.size(); ++i)
        consider(Kind::Vertex, i, polygon[i]);
    if (nearest.kind != Kind::None) return nearest;
    least = edge;
    for (int i = 0; i < polygon.size(); ++i) {
        const double d = distanceToSegment(position, polygon[i], polygon[(i + 1) % polygon.size()]);
        if (d < least) {
            least = d;
            nearest = {Kind::Edge, i};
        }
    }
    if (nearest.kind == Kind::None && polygon.containsPoint(position, Qt::OddEvenFill))
        return {Kind::Inside, 0};
    return nearest;
}

QPointF CanvasScene::positionOf(const CanvasPart& part) const {
    const QPolygonF polygon = cagePolygon();
    switch (part.kind) {
    case Kind::Vertex:
        return polygon.value(part.index);
    case Kind::Edge:
        return polygon.isEmpty() ? QPointF()
                                 : (polygon[part.index] + polygon[(part.index + 1) % polygon.size()]) / 2;
    case Kind::Rotate:
        return m_gizmoLayout.rotate;
    case Kind::Scale:
        return m_gizmoLayout.scale;
    case Kind::Inside:
    case Kind::Pivot:
    case Kind::None:
        break;
    }
    return m_gizmoLayout.pivot;
}

std::vector<CanvasPart> CanvasScene::handles() const {
    std::vector<CanvasPart> parts;
    if (!m_cage) return parts;
    for (std::size_t i = 0; i < m_cage->current.size(); ++i)
        parts.push_back({Kind::Vertex, int(i)});
    for (const Kind kind : {Kind::Inside, Kind::Pivot, Kind::Rotate, Kind::Scale})
        parts.push_back({kind, 0});
    return parts;
}

QString CanvasScene::nameOf(const CanvasPart& part) const {
    switch (part.kind) {
    case Kind::None:
        break;
    case Kind::Vertex:
        return tr("Vertex %1").arg(part.index + 1);
    case Kind::Edge:
        return tr("Edge from vertex %1").arg(part.index + 1);
    case Kind::Inside:
        return tr("The whole cage");
    case Kind::Pivot:
        return tr("Pivot");
    case Kind::Rotate:
        return tr("Rotate handle");
    case Kind::Scale:
        return tr("Scale handle");
    }
    return {};
}

QString CanvasScene::placeOf(const CanvasPart& part) const {
    switch (part.kind) {
    case Kind::Vertex:
        return m_cage ? coordinates(m_camera, m_cage->current[std::size_t(part.index)]) : QString();
    case Kind::Pivot:
        return coordinates(m_camera, pivot());
    case Kind::Edge:
        return tr("the arrow keys move both its ends");
    case Kind::Inside:
        return tr("the arrow keys move it");
    case Kind::Rotate:
        return tr("the arrow keys turn the cage by one degree");
    case Kind::Scale:
        return tr("the arrow keys scale the cage by one percent");
    case Kind::None:
        break;
    }
    return {};
}

QString CanvasScene::useOf(const CanvasPart& part) const {
    switch (part.kind) {
    case Kind::Pivot:
        return tr("Drag the pivot: the cage turns and scales about it.");
    case Kind::Rotate:
        return tr("Drag to turn the cage about the pivot; Shift: in steps of 15°.");
    case Kind::Scale:
        return tr("Drag to scale the cage about the pivot; Shift: along x or y only.");
    case Kind::None:
    case Kind::Vertex:
    case Kind::Edge:
    case Kind::Inside:
        break;
    }
    return {};
}

void CanvasScene::setHovered(CanvasPart part) {
    if (m_hovered == part) return;
    m_hovered = part;
    mark();
}

void CanvasScene::setPressed(CanvasPart part) {
    m_pressed = part;
    mark();
}

void CanvasScene::setFocused(CanvasPart part) {
    m_focused = part;
    mark();
    emit focusChanged();
}

void CanvasScene::holdKnobAt(const std::optional<QPointF>& position) {
    m_heldKnob = position;
    place();
}

SnapTargets CanvasScene::snapTargets(const std::vector<int>& moving) const {
    SnapTargets targets{m_snapping, m_camera, {}};
    if (!m_cage) return targets;
    targets.vertices = m_cage->rest;
    for (std::size_t i = 0; i < m_cage->current.size(); ++i)
        if (std::ranges::find(moving, int(i)) == moving.end()) targets.vertices.push_back(m_cage->current[i]);
    return targets;
}

void CanvasScene::showSnap(const std::optional<Snapped>& snap) {
    m_snap = snap;
    m_snapMark->setSnap(snap, snap ? pixelOf(m_camera, snap->point) : QPointF());
}

void CanvasScene::showRubber(const std::vector<ifs::Vector<2>>& clicked,
                             const std::optional<ifs::Vector<2>>& pointer) {
    m_clicked = clicked;
    m_rubberEnd = pointer;
    place();
}

void CanvasScene::place() {
    const QPolygonF polygon = cagePolygon();
    m_cageItem->setPolygon(polygon);
    if (m_cage) {
        m_gizmoLayout = gizmoLayout(polygon, pixelOf(m_camera, pivot()), sceneRect());
        if (m_heldKnob && m_pressed.kind == Kind::Rotate) m_gizmoLayout.rotate = *m_heldKnob;
        if (m_heldKnob && m_pressed.kind == Kind::Scale) m_gizmoLayout.scale = *m_heldKnob;
        m_gizmo->setLayout(m_gizmoLayout);
    }
    QPolygonF clicked;
    for (const ifs::Vector<2>& point : m_clicked)
        clicked.append(pixelOf(m_camera, point));
    m_rubber->setPoints(clicked, m_rubberEnd ? std::optional(pixelOf(m_camera, *m_rubberEnd)) : std::nullopt);
    QPolygonF trail;
    for (const ifs::Vector<2>& point : m_trail)
        trail.append(pixelOf(m_camera, point));
    m_trailItem->setPoints(trail);
    m_snapMark->setSnap(m_snap, m_snap ? pixelOf(m_camera, m_snap->point) : QPointF());
    mark();
    updateVisibility();
}

void CanvasScene::mark() {
    m_cageItem->setMarks(m_hovered, m_pressed, m_focused);
    m_gizmo->setMarks(m_hovered, m_pressed, m_focused);
}

void CanvasScene::showTrail(const std::vector<ifs::Vector<2>>& points) {
    m_trail = points;
    place();
}

void CanvasScene::restyle() {
    const OverlayStyle style = overlayStyle(m_document->fractal().appearance.background, m_palette);
    m_attractor->setStyle(style);
    m_grid->setStyle(style);
    m_cageItem->setStyle(style);
    m_gizmo->setStyle(style);
    m_snapMark->setStyle(style);
    m_rubber->setStyle(style);
    m_trailItem->setStyle(style);
    m_noteItem->setStyle(style);
    m_promptItem->setStyle(style);
}

QString CanvasScene::note() const {
    return m_noteItem->text();
}

void CanvasScene::updateNote() {
    const attractor::RenderNote note = m_frame ? m_frame->note : attractor::RenderNote::None;
    if (note == m_noted && !m_noteStale) return;
    m_noted = note;
    m_noteStale = false;
    m_noteItem->setText(noteOn(m_document->fractal(), note));
}

void CanvasScene::setPrompt(const QString& prompt) {
    m_prompt = prompt;
    m_promptItem->setText(m_prompt.isEmpty() ? m_hint : m_prompt);
}

void CanvasScene::setHint(const QString& hint) {
    m_hint = hint;
    setPrompt(m_prompt);
}

void CanvasScene::setGridVisible(bool visible) {
    m_grid->setGridVisible(visible);
}

void CanvasScene::setAxesVisible(bool visible) {
    m_grid->setAxesVisible(visible);
}

bool CanvasScene::isGridVisible() const {
    return m_grid->isGridVisible();
}

bool CanvasScene::areAxesVisible() const {
    return m_grid->areAxesVisible();
}

void CanvasScene::setOverlaysVisible(bool visible) {
    m_overlaysVisible = visible;
    updateVisibility();
}

void CanvasScene::setCageVisible(bool visible) {
    m_cageVisible = visible;
    updateVisibility();
}

void CanvasScene::updateVisibility() {
    for (QGraphicsItem* item : overlays())
        item->setVisible(m_overlaysVisible);
    const bool cage = m_overlaysVisible && m_cageVisible && m_cage;
    m_cageItem->setVisible(cage);
    m_gizmo->setVisible(cage);
}

} // namespace view
