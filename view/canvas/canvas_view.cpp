// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"

#include "canvas/attractor_item.h"
#include "canvas/branch_tool.h"
#include "canvas/cage_actions.h"
#include "canvas/cage_tool.h"
#include "canvas/canvas_accessible.h"
#include "canvas/canvas_geometry.h"
#include "canvas/canvas_menu.h"
#include "canvas/canvas_scene.h"
#include "canvas/define_tool.h"
#include "canvas/maps_tool.h"
#include "document/analysis.h"
#include "document/fractal.h"
#include "io/number.h"
#include "render_bridge.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QPushButton>
#include <QTouchEvent>
#include <QWheelEvent>
#include <QWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double unitPixels = 100; // of one unit of the plane at 100 %
constexpr double keyZoom = 1.25;
constexpr double keyPan = 40; // pixels
constexpr double fitMargin = 0.09;
constexpr int longestHold = 33; // milliseconds
constexpr int notch = 120;      // of a wheel, in eighths of a degree

double wheelFactor(const QWheelEvent& event) {
    // A touchpad reports pixels, a wheel eighths of a degree: one notch is 120 of them, fine wheels send
    // parts of it.
    if (!event.pixelDelta().isNull()) return std::exp2(event.pixelDelta().y() / 240.0);
    // With Alt held some platforms turn the wheel sideways.
    const int angle = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    return std::exp2(angle / 480.0);
}

Qt::KeyboardModifier modifierOf(int key) {
    switch (key) {
    case Qt::Key_Shift:
        return Qt::ShiftModifier;
    case Qt::Key_Control:
        return Qt::ControlModifier;
    case Qt::Key_Alt:
        return Qt::AltModifier;
    default:
        return Qt::NoModifier;
    }
}

QPointF arrow(int key) {
    switch (key) {
    case Qt::Key_Left:
        return {1, 0};
    case Qt::Key_Right:
        return {-1, 0};
    case Qt::Key_Up:
        return {0, 1};
    case Qt::Key_Down:
        return {0, -1};
    default:
        return {};
    }
}

} // namespace

CanvasView::CanvasView(document::Document* document, RenderBridge* bridge, QWidget* parent)
    : QGraphicsView(parent),
      m_document(document),
      m_bridge(bridge),
      m_scene(new CanvasScene(document, this)),
      m_cageTool(new CageTool(m_scene)),
      m_mapsTool(new MapsTool(m_scene)),
      m_branchTool(new BranchTool(m_scene)),
      m_defineTool(new DefineTool(m_scene)) {
    installCanvasAccessibility();
    setScene(m_scene);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTransformationAnchor(QGraphicsView::NoAnchor);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setAcceptDrops(false); // a file dropped here is the window's business
    viewport()->setAcceptDrops(false);
    // The picture covers it all, so nothing is to be filled first.
    viewport()->setAutoFillBackground(false);
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    viewport()->setMouseTracking(true);
    viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
    viewport()->setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Canvas"));
    this->setWhatsThis(
        tr("The picture and its cage. Drag a corner, an edge or the inside of the cage; Ctrl turns, Alt "
           "scales, Shift keeps directions. The wheel zooms at the pointer, the middle button moves the "
           "plane. Tab goes from handle to handle, arrow keys move them, F6 leaves."));
    setAccessibleDescription(
        tr("The attractor and its control cage. Tab goes from handle to handle, the arrow keys "
           "move the one in focus, F6 leaves the canvas."));
    m_scene->setDesktop(palette(), font());

    connect(document, &document::Document::changed, this, &CanvasView::followDocument);
    connect(bridge, &RenderBridge::frameChanged, this, [this] {
        m_scene->setFrame(m_bridge->frame());
        paintAgain();
    });
    m_hold.setSingleShot(true);
    m_hold.setInterval(longestHold);
    connect(&m_hold, &QTimer::timeout, this, &CanvasView::paintAgain);
    connect(m_scene, &CanvasScene::focusChanged, this, [this] {
        describeFocus();
        announceFocus(*this);
    });
    connect(m_scene, &CanvasScene::focusMoved, this, [this] {
        describeFocus();
        announceMotion(*this);
    });
    connect(m_branchTool, &BranchTool::changed, this, &CanvasView::branchChanged);
    connect(m_scene, &CanvasScene::selectedMapsChanged, this, &CanvasView::selectedMapsChanged);
    for (CanvasTool* tool :
         {static_cast<CanvasTool*>(m_cageTool), static_cast<CanvasTool*>(m_mapsTool),
          static_cast<CanvasTool*>(m_branchTool), static_cast<CanvasTool*>(m_defineTool)}) {
        connect(tool, &CanvasTool::message, this, &CanvasView::message);
        connect(tool, &CanvasTool::cursorChanged, this, &CanvasView::refreshCursor);
        connect(tool, &CanvasTool::finished, this, &CanvasView::finishTool);
    }
    for (PolygonTool* tool : {static_cast<PolygonTool*>(m_cageTool), static_cast<PolygonTool*>(m_mapsTool),
                              static_cast<PolygonTool*>(m_branchTool)})
        connect(tool, &PolygonTool::grasped, this, &CanvasView::dismissHint);
    m_scene->setFrame(bridge->frame());
}

CanvasView::~CanvasView() {
    if (m_document) active().stop(); // what is held is let go while there is a scene
}

CanvasTool& CanvasView::active() const {
    if (PolygonTool* tool = taking()) return *tool;
    return *m_defineTool;
}

PolygonTool* CanvasView::taking() const {
    if (m_tool == Tool::Maps) return m_mapsTool;
    if (m_tool == Tool::Branch) return m_branchTool;
    return m_tool == Tool::Cage ? m_cageTool : nullptr;
}

const std::vector<ifs::MapId>& CanvasView::selectedMaps() const {
    return m_scene->selectedMaps();
}

void CanvasView::selectMaps(const std::vector<ifs::MapId>& maps) {
    m_scene->setSelectedMaps(maps);
}

double CanvasView::shareToShow(const std::function<document::Fractal(double)>& after) {
    return m_mapsTool->shareToShow(after);
}

void CanvasView::dismissStop() {
    m_scene->setPrompt({});
}

void CanvasView::setAllowsNoAttractor(bool allows) {
    m_mapsTool->setAllowsNoAttractor(allows);
    m_branchTool->setAllowsNoAttractor(allows);
}

const ifs::Word& CanvasView::branchAddress() const {
    return m_branchTool->address();
}

int CanvasView::branchDepth() const {
    return m_branchTool->depth();
}

void CanvasView::setBranchDepth(int depth) {
    m_branchTool->setDepth(depth);
}

void CanvasView::setBranchEdit(document::BranchEdit edit) {
    m_branchTool->setEdit(edit);
}

void CanvasView::setTool(Tool tool) {
    if (tool == m_tool) return;
    if (tool != Tool::Cage && !document::system2(m_document->fractal())) {
        emit message(m_scene->note());
        emit toolChanged(m_tool); // a button that was pressed goes back
        return;
    }
    if (tool == Tool::DefineTriangle && offerReset()) {
        emit toolChanged(m_tool);
        return;
    }
    if (tool != Tool::Cage) setOverlaysVisible(true);
    dismissHint();
    active().stop();
    m_tool = tool;
    active().start();
    refreshCursor();
    emit toolChanged(tool);
}

void CanvasView::finishTool() {
    setTool(Tool::Cage);
}

bool CanvasView::offerReset() {
    if (isPlacementInvertible(m_document->fractal())) return false;
    auto* question = new QMessageBox(
        QMessageBox::Question, tr("Define triangle"),
        tr("The cage is flat, so new vertices cannot be related to the picture."), QMessageBox::Cancel, this);
    question->setInformativeText(tr("Put the cage back to rest first?"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* reset = question->addButton(tr("Reset the Cage"), QMessageBox::AcceptRole);
    connect(reset, &QPushButton::clicked, this, [this] {
        resetCage(*m_document);
        setTool(Tool::DefineTriangle);
    });
    question->open();
    return true;
}

bool CanvasView::cancelGesture() {
    if (m_holding == Holding::Plane) {
        setCamera(m_pan.before());
        m_pan.release();
        m_holding = Holding::Nothing;
        refreshCursor();
        return true;
    }
    if (!active().isBusy() && taking()) return false;
    return active().cancel();
}

const attractor::Camera& CanvasView::camera() const {
    return m_scene->camera();
}

void CanvasView::setCamera(attractor::Camera camera) {
    const double ratio = viewport()->devicePixelRatioF();
    camera = withinDepth(camera);
    m_scene->setView(camera, ratio);
    if (camera.width > 0 && camera.height > 0) m_bridge->setCamera(deviceCamera(camera, ratio));
    emit viewChanged();
}

void CanvasView::adoptViewport() {
    attractor::Camera camera = m_scene->camera();
    camera.width = viewport()->width();
    camera.height = viewport()->height();
    setCamera(camera);
    if (m_fitted) fit();
}

void CanvasView::fit() {
    std::optional<document::Box> box = document::displayedBox(m_document->fractal());
    if (m_scene->cage())
        for (const ifs::Vector<2>& vertex : m_scene->cage()->current) {
            if (!box) box = document::Box{vertex, vertex};
            box->min = box->min.cwiseMin(vertex);
            box->max = box->max.cwiseMax(vertex);
        }
    if (!box) box = document::Box{ifs::Vector<2>(-1, -1), ifs::Vector<2>(1, 1)};
    setCamera(attractor::fitted(m_scene->camera(), box->min, box->max, fitMargin));
    m_fitted = true;
}

void CanvasView::zoomAt(const QPointF& position, double factor) {
    m_fitted = false;
    setCamera(attractor::zoomedAt(m_scene->camera(), toVector(position), factor));
    report(position);
}

void CanvasView::zoomBy(double factor) {
    zoomAt(QPointF(viewport()->width() / 2.0, viewport()->height() / 2.0), factor);
}

void CanvasView::resetZoom() {
    m_fitted = false;
    attractor::Camera camera = m_scene->camera();
    camera.pixelsPerUnit = unitPixels;
    setCamera(camera);
}

void CanvasView::pan(const QPointF& pixels) {
    m_fitted = false;
    setCamera(attractor::panned(m_scene->camera(), toVector(pixels)));
}

void CanvasView::setYAxis(attractor::YAxis yAxis) {
    if (yAxis == this->yAxis()) return;
    attractor::Camera camera = m_scene->camera();
    camera.yAxis = yAxis;
    setCamera(camera);
    emit yAxisChanged(yAxis);
}

void CanvasView::setGridVisible(bool visible) {
    if (visible == isGridVisible()) return;
    m_scene->setGridVisible(visible);
    emit gridVisibleChanged(visible);
}

void CanvasView::setAxesVisible(bool visible) {
    if (visible == areAxesVisible()) return;
    m_scene->setAxesVisible(visible);
    emit axesVisibleChanged(visible);
}

void CanvasView::setOverlaysVisible(bool visible) {
    if (visible == overlaysVisible()) return;
    cancelGesture();
    m_scene->setOverlaysVisible(visible);
    refreshCursor();
    emit message(visible ? QString() : tr("Only the picture is shown. Press H to see the cage again."));
    emit overlaysVisibleChanged(visible);
}

bool CanvasView::isGridVisible() const {
    return m_scene->isGridVisible();
}

bool CanvasView::areAxesVisible() const {
    return m_scene->areAxesVisible();
}

bool CanvasView::overlaysVisible() const {
    return m_scene->overlaysVisible();
}

void CanvasView::setSnapping(Snapping snapping) {
    if (snapping == m_scene->snapping()) return;
    m_scene->setSnapping(snapping);
    emit snappingChanged(snapping);
}

Snapping CanvasView::snapping() const {
    return m_scene->snapping();
}

void CanvasView::showOutlines(std::vector<document::OutlineShape> shapes) {
    m_scene->showOutlines(std::move(shapes));
}

void CanvasView::showTrail(const std::vector<ifs::Vector<2>>& points) {
    m_scene->showTrail(points);
}

void CanvasView::setHint(const QString& hint) {
    m_hint = hint;
    m_scene->setHint(hint);
}

void CanvasView::dismissHint() {
    if (m_hint.isEmpty()) return;
    setHint({});
    emit hintDismissed();
}

QString CanvasView::note() const {
    return m_scene->note();
}

QImage CanvasView::picture() const {
    const std::shared_ptr<const attractor::Frame> frame = m_bridge->frame();
    return frame ? imageOf(*frame).copy() : QImage();
}

void CanvasView::copyPicture() const {
    if (const QImage image = picture(); !image.isNull()) QGuiApplication::clipboard()->setImage(image);
}

void CanvasView::followDocument(const document::Change& change) {
    using document::Change;
    if (change.live)
        holdPainting();
    else if (viewport()->underMouse()) // what is said of the place of the pointer has changed with the cage
        QMetaObject::invokeMethod(
            this, [this] { report(m_pointer.position); }, Qt::QueuedConnection);
    if (!(change.parts & (Change::Current | Change::File))) return;
    if (m_tool == Tool::DefineTriangle) finishTool();
    if (m_placed) fit();
}

// Cage and picture move together: during a gesture nothing is painted until the picture has come, unless that
// takes longer than the eye accepts. It also leaves the processor to those who draw it.
void CanvasView::holdPainting() {
    if (m_bridge->isCurrent() || m_hold.isActive()) return;
    setViewportUpdateMode(QGraphicsView::NoViewportUpdate);
    m_hold.start();
}

void CanvasView::paintAgain() {
    m_hold.stop();
    if (viewportUpdateMode() == QGraphicsView::FullViewportUpdate) return;
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    viewport()->update();
}

bool CanvasView::event(QEvent* event) {
    // Keys that mean something here must not be taken by shortcuts of the window: the arrows and Backspace.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        if (!arrow(key.key()).isNull() || key.key() == Qt::Key_Space ||
            (key.key() == Qt::Key_Backspace && m_tool == Tool::DefineTriangle)) {
            event->accept();
            return true;
        }
    }
    return QGraphicsView::event(event);
}

bool CanvasView::viewportEvent(QEvent* event) {
    switch (event->type()) {
    case QEvent::Leave:
        active().leave();
        emit pointerLeft();
        break;
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        return touch(static_cast<QTouchEvent&>(*event)) || QGraphicsView::viewportEvent(event);
    case QEvent::NativeGesture: {
        const auto& gesture = static_cast<QNativeGestureEvent&>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture)
            zoomAt(gesture.position(), std::max(0.1, 1 + gesture.value()));
        else if (gesture.gestureType() == Qt::SmartZoomNativeGesture)
            fit();
        else
            break;
        return true;
    }
    default:
        break;
    }
    return QGraphicsView::viewportEvent(event);
}

// One finger does what the left button does, two hold the plane. A touchpad is left to the mouse it moves.
bool CanvasView::touch(const QTouchEvent& event) {
    if (event.pointingDevice()->type() != QInputDevice::DeviceType::TouchScreen) return false;
    const QList<QEventPoint>& points = event.points();
    m_pointer = {points.front().position(), event.modifiers(), Reach::Touch};
    if (points.size() >= 2 && !m_pinch.isActive()) {
        if (taking()) active().cancel();
        m_pinch.press(camera(), points[0].position(), points[1].position());
        return true;
    }
    switch (event.type()) {
    case QEvent::TouchBegin:
        m_holding = Holding::Tool;
        active().press(m_pointer);
        break;
    case QEvent::TouchUpdate:
        if (!m_pinch.isActive()) {
            active().move(m_pointer);
            report(m_pointer.position);
        } else if (points.size() >= 2) {
            m_fitted = false;
            setCamera(m_pinch.cameraAt(points[0].position(), points[1].position()));
        }
        break;
    case QEvent::TouchCancel:
        if (taking()) active().cancel();
        [[fallthrough]];
    default:
        m_pinch.release();
        m_holding = Holding::Nothing;
        active().release(m_pointer);
        active().leave();
        break;
    }
    return true;
}

void CanvasView::resizeEvent(QResizeEvent*) {
    adoptViewport();
}

void CanvasView::showEvent(QShowEvent* event) {
    QGraphicsView::showEvent(event);
    if (QWindow* handle = window()->windowHandle())
        connect(handle, &QWindow::screenChanged, this, &CanvasView::adoptViewport, Qt::UniqueConnection);
    adoptViewport();
    if (!std::exchange(m_placed, true)) fit();
}

void CanvasView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_scene->setDesktop(palette(), font());
    QGraphicsView::changeEvent(event);
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    if (m_tool == Tool::Branch && event->modifiers().testFlag(Qt::ShiftModifier)) {
        m_wheelTurned += event->angleDelta().y() + event->angleDelta().x();
        setBranchDepth(branchDepth() + m_wheelTurned / notch);
        m_wheelTurned %= notch;
        event->accept();
        return;
    }
    zoomAt(event->position(), wheelFactor(*event));
    event->accept();
}

void CanvasView::report(const QPointF& position) {
    PointerPosition pointer{worldAt(camera(), position), std::nullopt};
    if (const auto& cage = m_scene->cage(); cage && cage->current.size() == 3) {
        const ifs::Simplex<2> triangle{cage->current[0], cage->current[1], cage->current[2]};
        if (ifs::isAffineBasis<2>(triangle))
            pointer.barycentric = ifs::barycentric<2>(triangle, pointer.world);
    }
    if (m_holding == Holding::Nothing) findAddress(pointer);
    emit pointerMoved(pointer);
}

void CanvasView::findAddress(PointerPosition& pointer) {
    pointer.address = m_scene->addressAt(pixelOf(camera(), pointer.world));
    pointer.fixedLength = std::min(std::size_t(branchDepth()), pointer.address.size());
    const auto end = pointer.address.begin() + std::ptrdiff_t(pointer.fixedLength);
    pointer.fixedPoint = m_scene->addresses().fixedPoint({pointer.address.begin(), end});
}

void CanvasView::refreshCursor() {
    if (m_holding == Holding::Plane)
        viewport()->setCursor(Qt::ClosedHandCursor);
    else if (m_spaceHeld && m_holding == Holding::Nothing)
        viewport()->setCursor(Qt::OpenHandCursor);
    else
        viewport()->setCursor(active().cursor(m_pointer));
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    m_pointer = {event->position(), event->modifiers(), Reach::Mouse};
    if (m_holding != Holding::Nothing) return;
    const bool left = event->button() == Qt::LeftButton;
    if (event->button() == Qt::MiddleButton || (left && m_spaceHeld)) {
        m_pan.press(camera(), event->position());
        m_holding = Holding::Plane;
    } else if (left) {
        m_holding = Holding::Tool;
        active().press(m_pointer);
    }
    refreshCursor();
}

void CanvasView::mouseDoubleClickEvent(QMouseEvent* event) {
    const CanvasPart part = m_scene->partAt(event->position(), Reach::Mouse);
    if (event->button() == Qt::LeftButton && !m_spaceHeld && m_tool == Tool::Cage &&
        part.kind == CanvasPart::Kind::Edge)
        insertVertexAt(part.index, event->position());
    mousePressEvent(event);
}

void CanvasView::insertVertexAt(int edge, const QPointF& position) {
    m_cageTool->insertVertexAt(edge, position);
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = {event->position(), event->modifiers(), Reach::Mouse};
    if (m_holding == Holding::Plane) {
        m_fitted = false;
        setCamera(m_pan.cameraAt(event->position()));
    } else {
        active().move(m_pointer);
    }
    report(event->position());
    refreshCursor();
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    m_pointer = {event->position(), event->modifiers(), Reach::Mouse};
    const bool left = event->button() == Qt::LeftButton;
    if (m_holding == Holding::Plane && (left || event->button() == Qt::MiddleButton)) {
        m_pan.release();
        m_holding = Holding::Nothing;
    } else if (m_holding == Holding::Tool && left) {
        m_holding = Holding::Nothing;
        active().release(m_pointer);
    }
    refreshCursor();
}

void CanvasView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    if (m_holding != Holding::Nothing) return;
    if (m_tool == Tool::DefineTriangle) {
        active().cancel();
        return;
    }
    if (event->reason() == QContextMenuEvent::Keyboard) {
        const CanvasPart part = m_scene->focused();
        const QPointF position = part.kind == CanvasPart::Kind::None ? QPointF(viewport()->rect().center())
                                                                     : m_scene->positionOf(part);
        popUpCanvasMenu({*this, *m_document, *m_scene}, part, viewport()->mapToGlobal(position.toPoint()));
        return;
    }
    const QPointF position = viewport()->mapFromGlobal(event->globalPos());
    popUpCanvasMenu({*this, *m_document, *m_scene}, m_scene->partAt(position, Reach::Mouse),
                    event->globalPos());
}

void CanvasView::updateModifiers(Qt::KeyboardModifiers modifiers) {
    m_pointer.modifiers = modifiers;
    if (m_holding == Holding::Tool) active().move(m_pointer);
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    if (const Qt::KeyboardModifier modifier = modifierOf(event->key()); modifier != Qt::NoModifier) {
        updateModifiers(event->modifiers() | modifier);
        return;
    }
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_spaceHeld = true;
        refreshCursor();
        return;
    }
    if (active().keyPress(*event) || canvasKey(*event)) {
        event->accept();
        return;
    }
    event->ignore();
}

// Whether the key means something to the canvas whatever the tool.
bool CanvasView::canvasKey(const QKeyEvent& event) {
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (const QPointF way = arrow(event.key()); !way.isNull()) {
        pan(way * (event.modifiers().testFlag(Qt::ShiftModifier) ? 5 * keyPan : keyPan));
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        if (cancelGesture()) return true;
        const bool focused = m_scene->focused().kind != CanvasPart::Kind::None;
        m_scene->setFocused({});
        return focused;
    }
    if (!plain) return false;
    switch (event.key()) {
    case Qt::Key_Space:
        return true;
    case Qt::Key_F:
        fit();
        return true;
    case Qt::Key_1:
        resetZoom();
        return true;
    case Qt::Key_H:
        setOverlaysVisible(!overlaysVisible());
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(keyZoom);
        return true;
    case Qt::Key_Minus:
        zoomBy(1 / keyZoom);
        return true;
    case Qt::Key_F6:
        return QGraphicsView::focusNextPrevChild(!event.modifiers().testFlag(Qt::ShiftModifier));
    default:
        return false;
    }
}

void CanvasView::focusOn(const CanvasPart& part) {
    setFocus(Qt::TabFocusReason);
    m_scene->setFocused(part);
}

void CanvasView::keyReleaseEvent(QKeyEvent* event) {
    if (const Qt::KeyboardModifier modifier = modifierOf(event->key()); modifier != Qt::NoModifier)
        updateModifiers(event->modifiers() & ~Qt::KeyboardModifiers(modifier));
    else if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        m_spaceHeld = false;
    else if (!active().keyRelease(*event))
        event->ignore();
    refreshCursor();
}

void CanvasView::focusOutEvent(QFocusEvent* event) {
    m_spaceHeld = false;
    refreshCursor();
    QGraphicsView::focusOutEvent(event);
}

bool CanvasView::focusNextPrevChild(bool next) {
    if (!taking() || !m_scene->cage() || !overlaysVisible()) return QGraphicsView::focusNextPrevChild(next);
    taking()->walk(next ? 1 : -1);
    return true;
}

void CanvasView::describeFocus() {
    // While a part is dragged the read-out of the pointer says where it is.
    const CanvasPart part = m_scene->focused();
    if (part.kind != CanvasPart::Kind::None && m_holding == Holding::Nothing)
        emit message(tr("%1: %2").arg(m_scene->nameOf(part), m_scene->placeOf(part)));
}

} // namespace view
