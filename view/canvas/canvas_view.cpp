// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"

#include "attractor/render/renderer.h"
#include "bridges/render_bridge.h"
#include "canvas/canvas_accessible.h"
#include "canvas/canvas_menu.h"
#include "canvas/items/attractor_item.h"
#include "canvas/items/border_arrows_item.h"
#include "canvas/scene/handle_text.h"
#include "desktop/shortcuts.h"
#include "document/analysis/analysis.h"
#include "document/edits/cage/cage_actions.h"
#include "document/fractal/fractal_geometry.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace view {

namespace {

constexpr int maxHold = 33; // milliseconds
// Milliseconds; delays the search for an address, which competes with the picture.
constexpr int untilReport = 50;

} // namespace

CanvasView::CanvasView(document::Document* document, RenderBridge* bridge, QWidget* parent)
    : Viewport(parent),
      m_document(document),
      m_bridge(bridge),
      m_scene(new CanvasScene(document, this)),
      m_options(*m_scene),
      m_navigation(*m_scene, *bridge, *viewport()),
      m_tools(*m_scene, m_options),
      m_input(*m_scene, m_tools, m_navigation, m_options),
      m_corners(document, {[this] { return areCornersInView(); }, [this] { return wasShown(); },
                           [this] { return hasFocus() || m_input.isHolding(); }, [this] { fit(); }}) {
    setUpWidget();
    connectParts();
    adoptDesktop();
    m_scene->setFrame(bridge->frame());
}

CanvasView::~CanvasView() {
    m_tools.stop(); // releases held parts while there is still a scene
}

void CanvasView::setUpWidget() {
    installCanvasAccessibility();
    showScene(m_scene);
    // The picture covers the whole viewport.
    viewport()->setAutoFillBackground(false);
    viewport()->setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Canvas"));
    this->setWhatsThis(
        tr("The picture and its cage. Drag a corner, an edge or the inside of the cage; hold Ctrl to rotate, "
           "Alt to scale, Shift to keep directions. The wheel zooms at the pointer, the middle button pans. "
           "Tab moves from handle to handle, the arrow keys move the handle, F6 leaves the canvas."));
    setAccessibleDescription(tr("The attractor and its control cage. Tab moves from handle to handle, the "
                                "arrow keys move the handle in focus, F6 leaves the canvas."));
    m_hold.setSingleShot(true);
    m_hold.setInterval(maxHold);
}

void CanvasView::connectParts() {
    connect(m_document, &document::Document::changed, this, &CanvasView::followDocument);
    auto* report = new QTimer(this);
    report->setSingleShot(true);
    connect(report, &QTimer::timeout, this, [this] {
        if (viewport()->underMouse()) m_input.reportPointer();
    });
    connect(m_document, &document::Document::changed, this, [this, report](const document::Change& change) {
        // Updates the readout of the point under the pointer.
        if (!change.live && viewport()->underMouse()) report->start(untilReport);
    });
    connect(m_bridge, &RenderBridge::frameChanged, this, [this] {
        m_scene->setFrame(m_bridge->frame());
        paintAgain();
    });
    connect(&m_hold, &QTimer::timeout, this, &CanvasView::paintAgain);
    const CanvasSelection& selection = m_scene->selection();
    connect(&selection, &CanvasSelection::mapsChanged, this, &CanvasView::selectedMapsChanged);
    connect(&selection, &CanvasSelection::focusChanged, this, [this] {
        describeFocus();
        announceFocus(*this);
    });
    connect(&selection, &CanvasSelection::focusMoved, this, [this] {
        describeFocus();
        announceMotion(*this);
    });
    connect(&m_options, &CanvasOptions::overlaysVisibleChanged, this, [this](bool visible) {
        cancelGesture();
        refreshCursor();
        emit message(visible ? QString()
                             : tr("Only the picture is shown. Press %1 to see the cage again.")
                                   .arg(toPress(QStringLiteral("hide"), Qt::Key_H)));
    });
    connect(&m_tools, &Toolbox::message, this, &CanvasView::message);
    connect(&m_tools, &Toolbox::cursorChanged, this, &CanvasView::refreshCursor);
    connect(&m_tools, &Toolbox::toolChanged, this, &CanvasView::toolChanged);
    connect(&m_tools, &Toolbox::used, this, &CanvasView::dismissHint);
    connect(&m_tools, &Toolbox::definingRefused, this, &CanvasView::offerReset);
    connect(this, &CanvasView::message, this, [this] { m_said.clear(); });
    connect(&m_navigation, &CanvasNavigation::zoomed, this, &CanvasView::dismissHint);
    connect(&m_navigation, &CanvasNavigation::cameraChanged, this, [this] { m_corners.look(); });
    connect(&m_navigation, &CanvasNavigation::cameraChanged, &m_input, &CanvasInput::reportAgain,
            Qt::QueuedConnection); // queued behind all other reactions
    connect(&m_scene->handles(), &HandleModel::addressesFound, &m_input, &CanvasInput::reportAgain);
    connect(&m_input, &CanvasInput::changed, this, &CanvasView::refreshCursor);
    connect(&m_input, &CanvasInput::pointerMoved, this, &CanvasView::pointerMoved);
}

void CanvasView::offerReset() {
    auto* question = new QMessageBox(
        QMessageBox::Question, tr("Define triangle"),
        tr("The cage is flat, so new vertices cannot be related to the picture."), QMessageBox::Cancel, this);
    question->setInformativeText(tr("Reset the cage first?"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* reset = question->addButton(tr("Reset the Cage"), QMessageBox::AcceptRole);
    connect(reset, &QPushButton::clicked, this, [this] {
        resetCage(*m_document);
        setTool(Tool::DefineTriangle);
    });
    question->open();
}

void CanvasView::showOutlines(std::vector<document::OutlineShape> shapes,
                              std::vector<document::OutlineShape> outer) {
    m_scene->marks().showOutlines(std::move(shapes), std::move(outer));
}

void CanvasView::showTrail(const std::vector<ifs::Vector<2>>& points) {
    m_scene->marks().showTrail(points);
}

void CanvasView::setHint(const QString& hint) {
    m_scene->notes().setHint(hint);
}

void CanvasView::setCovered(const QRect& area) {
    m_scene->notes().setCovered(area);
}

void CanvasView::dismissHint() {
    if (hint().isEmpty()) return;
    setHint({});
    emit hintDismissed();
}

QImage CanvasView::picture() const {
    const std::shared_ptr<const attractor::Frame> frame = m_bridge->frame();
    return frame ? imageOf(*frame).copy() : QImage();
}

void CanvasView::followDocument(const document::Change& change) {
    using document::Change;
    if (change.live || change.parts & Change::Time) holdPainting();
    if (!change.live && !m_said.isEmpty()) describeFocus();
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (isAnother && tool() == Tool::DefineTriangle) setTool(Tool::Cage);
    if (change.parts & Change::File && wasShown() && m_navigation.rotation() != 0)
        m_navigation.resetRotation(); // left over from the previous file
    if (isAnother && wasShown()) fit();
    if (const auto& view = m_document->view();
        view && wasShown() && (isAnother || change.parts & Change::Time))
        m_navigation.moveTo(attractor::cameraOf(*view, {viewport()->width(), viewport()->height()}));
    m_corners.follow(change, this);
}

bool CanvasView::areCornersInView() const {
    return borderArrows(m_scene->cagePolygon(), m_scene->sceneRect()).empty();
}

// Cage and picture move together: in a gesture or at another moment nothing is painted until the picture has
// come, unless that takes longer than the eye accepts. It also leaves the processor to those who draw it.
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

void CanvasView::adoptDesktop() {
    m_scene->setDesktop(palette(), font());
}

void CanvasView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    if (m_input.isHolding()) return;
    if (tool() == Tool::DefineTriangle) {
        cancelGesture();
        return;
    }
    if (event->reason() == QContextMenuEvent::Keyboard) {
        const CanvasPart part = m_scene->selection().focused();
        const QPointF position = part.kind == CanvasPart::Kind::None ? QPointF(viewport()->rect().center())
                                                                     : m_scene->positionOf(part);
        showMenu(part, viewport()->mapToGlobal(position.toPoint()));
        return;
    }
    const QPointF position = viewport()->mapFromGlobal(event->globalPos());
    showMenu(m_scene->partAt(position, Reach::Mouse), event->globalPos());
}

void CanvasView::showMenu(const CanvasPart& part, const QPoint& global) {
    const auto copyPicture = [this] {
        if (const QImage image = picture(); !image.isNull()) QGuiApplication::clipboard()->setImage(image);
    };
    popUpCanvasMenu({*this, *m_scene, m_tools, m_navigation, m_options, copyPicture}, part, global);
}

bool CanvasView::focusNextPrevChild(bool next) {
    PolygonTool* tool = m_tools.polygonTool();
    const bool canWalk = tool && m_scene->handles().cage() && m_scene->overlaysVisible();
    return (canWalk && tool->walk(next ? 1 : -1)) || Viewport::focusNextPrevChild(next);
}

void CanvasView::describeFocus() {
    // The readout of the pointer shows the position during a drag.
    const CanvasPart part = m_scene->selection().focused();
    const bool isShown = part.kind != CanvasPart::Kind::None && !m_input.isHolding();
    const QString said = isShown ? tr("%1: %2").arg(nameOf(m_scene->handles(), part),
                                                    valueOf(m_scene->handles(), m_scene->camera(), part))
                                 : QString();
    if (said == m_said) return;
    emit message(said);
    m_said = said;
}

} // namespace view
