// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"

#include "canvas/attractor_item.h"
#include "canvas/branch_tool.h"
#include "canvas/cage_actions.h"
#include "canvas/cage_tool.h"
#include "canvas/canvas_accessible.h"
#include "canvas/canvas_geometry.h"
#include "canvas/canvas_scene.h"
#include "canvas/define_tool.h"
#include "canvas/maps_tool.h"
#include "document/analysis.h"
#include "document/fractal.h"
#include "render_bridge.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace view {

namespace {

constexpr double unitPixels = 100; // of one unit of the plane at 100 %
constexpr double fitMargin = 0.09;
constexpr int longestHold = 33; // milliseconds

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

} // namespace view
