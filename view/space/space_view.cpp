// SPDX-License-Identifier: MIT
#include "space/space_view.h"

#include "canvas/geometry/canvas_note.h"
#include "canvas/items/note_item.h"
#include "document/space_geometry.h"

#include <QContextMenuEvent>
#include <QGraphicsScene>
#include <QMenu>
#include <QWindow>

namespace view {

namespace {

// Of the box around what is displayed, where it is cut.
std::vector<ifs::Vector<3>> cornersOfCut(const document::Fractal& fractal) {
    if (!document::space(fractal) || !fractal.inSpace.clip) return {};
    std::array<document::Extent, 3> sides;
    for (int axis = 0; axis < 3; ++axis)
        sides[std::size_t(axis)] = document::extentAlong(fractal, ifs::Vector<3>::Unit(axis));
    std::vector<ifs::Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1) != 0 ? sides[0].high : sides[0].low,
                             (k & 2) != 0 ? sides[1].high : sides[1].low,
                             (k & 4) != 0 ? sides[2].high : sides[2].low);
    return corners;
}

} // namespace

SpaceView::SpaceView(document::Document* document, SolidBridge* bridge, QWidget* parent)
    : QGraphicsView(parent),
      m_document(document),
      m_bridge(bridge),
      m_solid(new SolidItem),
      m_outlines(new SpaceOutlinesItem),
      m_cageItem(new SpaceCageItem),
      m_slice(new SliceItem),
      m_ball(new AxisBall),
      m_note(new NoteItem(NoteItem::Edge::Top)),
      m_navigation(document, bridge, viewport()),
      m_input(document, m_navigation, *m_cageItem, *m_slice, *m_ball),
      m_cage(document::spaceCage(document->fractal())),
      m_around(cornersOfCut(document->fractal())) {
    setScene(new QGraphicsScene(this)); // owns the items
    for (OverlayItem* item :
         std::initializer_list<OverlayItem*>{m_solid, m_outlines, m_cageItem, m_slice, m_ball, m_note})
        scene()->addItem(item);
    setUpWidget();
    connect(document, &document::Document::changed, this, &SpaceView::followDocument);
    connect(bridge, &SolidBridge::frameChanged, this, [this] {
        m_solid->setFrame(m_bridge->frame());
        if (m_bridge->isCurrent()) layOut(); // which handles are hidden is known now
        const auto frame = m_bridge->frame();
        m_note->setText(frame ? noteInSpace(frame->note) : QString());
    });
    connect(&m_navigation, &SpaceNavigation::changed, this, &SpaceView::layOut);
    connect(&m_input, &SpaceInput::changed, this, &SpaceView::refreshMarks);
    connect(&m_input, &SpaceInput::pointerMoved, this, &SpaceView::pointerMoved);
    connect(&m_input, &SpaceInput::pointerLeft, this, &SpaceView::pointerLeft);
    connect(&m_input, &SpaceInput::menuRequested, this, &SpaceView::showMenu);
    applyStyle();
}

SpaceView::~SpaceView() {
    m_input.cancelGesture();
}

void SpaceView::setUpWidget() {
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
    viewport()->setMouseTracking(true);
    viewport()->setCursor(Qt::CrossCursor);
    setAccessibleName(tr("Canvas in space"));
    setWhatsThis(
        tr("The solid and its tetrahedron. Drag a corner: X, Y or Z keeps it on an axis, with Shift in "
           "a plane, and the wheel pushes it away. Drag anywhere else to turn the view; the wheel zooms "
           "at the pointer, the middle button pans. Double-click the solid to turn about that point."));
    describeFocus();
}

void SpaceView::describeFocus() {
    const auto vertex = m_input.focusedVertex();
    if (!vertex || *vertex >= m_cageItem->vertices().size()) {
        setAccessibleDescription(tr(
            "The attractor and its control tetrahedron. Tab moves from corner to corner, the arrow keys move "
            "the corner in focus or turn the view, F6 leaves the canvas."));
        return;
    }
    const ifs::Vector<3>& at = m_cageItem->vertices()[*vertex];
    setAccessibleDescription(tr("Vertex %1 at %2, %3, %4")
                                 .arg(*vertex + 1)
                                 .arg(at.x(), 0, 'g', 6)
                                 .arg(at.y(), 0, 'g', 6)
                                 .arg(at.z(), 0, 'g', 6));
}

void SpaceView::followDocument(const document::Change& change) {
    using document::Change;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (!isAnother && !(change.parts & (Change::System | Change::Cage | Change::Appearance))) return;
    m_cage = document::spaceCage(m_document->fractal());
    if (!change.live) m_around = cornersOfCut(m_document->fractal());
    if (isAnother) m_input.forgetFocus();
    if (isAnother || change.parts & Change::Appearance) applyStyle();
    if (isAnother && m_cage && m_wasShown) m_navigation.fit();
    layOut();
}

void SpaceView::setOverlaysVisible(bool visible) {
    m_overlays = visible;
    m_input.setEnabled(visible);
    layOut();
}

void SpaceView::showOutlines(std::vector<document::SpaceOutline> shapes) {
    m_outlines->setShapes(std::move(shapes));
}

QString SpaceView::note() const {
    return m_note->text();
}

void SpaceView::layOut() {
    const attractor::OrbitCamera& camera = m_navigation.camera();
    const double ratio = m_navigation.pixelRatio();
    const QSizeF size(camera.size.width, camera.size.height);
    m_solid->setView(size, ratio);
    m_note->setView({QPointF(), size});
    const bool isShown = m_cage && m_overlays;
    m_outlines->setVisible(isShown);
    m_cageItem->setVisible(isShown);
    m_slice->setVisible(isShown);
    m_ball->setVisible(isShown);
    if (!isShown) return;
    m_ball->layOut(camera);
    m_outlines->layOut(camera);
    layOutSlice();
    const auto frame = m_bridge->isCurrent() ? m_bridge->frame() : nullptr;
    const double touching = 3 / pixelsPerUnit(camera); // a vertex on the surface is not behind it
    m_cageItem->layOut(camera, m_cage->current, [&](const attractor::ScreenPoint& seen) {
        return frame && depthAt(*frame, seen.pixel * ratio) < seen.depth - touching;
    });
    refreshMarks();
}

void SpaceView::layOutSlice() {
    const auto& clip = m_document->fractal().inSpace.clip;
    const bool isCut = clip && !m_around.empty();
    m_slice->layOut(m_navigation.camera(), isCut ? std::optional(slicePlane(*clip, m_around)) : std::nullopt);
}

void SpaceView::applyStyle() {
    const OverlayStyle style = overlayStyle(document::backgroundInSpace(m_document->fractal()), palette());
    for (OverlayItem* item :
         std::initializer_list<OverlayItem*>{m_solid, m_outlines, m_cageItem, m_slice, m_ball, m_note})
        item->setStyle(style);
    m_note->setFont(font());
}

void SpaceView::refreshMarks() {
    m_input.showMarks(hasFocus());
    viewport()->setCursor(m_input.cursor());
    describeFocus();
}

void SpaceView::showMenu(const QPoint& global) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Fit"), &m_navigation, &SpaceNavigation::fit);
    QAction* perspective = menu->addAction(tr("&Perspective"));
    perspective->setCheckable(true);
    perspective->setChecked(m_navigation.isPerspective());
    connect(perspective, &QAction::toggled, &m_navigation, &SpaceNavigation::setPerspective);
    menu->addSeparator();
    const std::pair<QString, AxisBall::End> views[] = {
        {tr("Look from the F&ront"), {2, true}},
        {tr("Look from the &Right"), {0, true}},
        {tr("Look from &Above"), {1, true}},
    };
    for (const auto& [text, end] : views)
        menu->addAction(text, this, [this, end = end] { m_navigation.lookFrom(AxisBall::towards(end)); });
    menu->popup(global);
}

bool SpaceView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && m_input.needsKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    return QGraphicsView::event(event);
}

bool SpaceView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) m_input.leave();
    return QGraphicsView::viewportEvent(event);
}

void SpaceView::resizeEvent(QResizeEvent*) {
    scene()->setSceneRect(viewport()->rect());
    m_navigation.adoptViewport();
}

void SpaceView::showEvent(QShowEvent* event) {
    QGraphicsView::showEvent(event);
    if (QWindow* handle = window()->windowHandle())
        connect(handle, &QWindow::screenChanged, &m_navigation, &SpaceNavigation::adoptViewport,
                Qt::UniqueConnection);
    m_navigation.adoptViewport();
    if (!m_wasShown) m_navigation.fit();
    m_wasShown = true;
}

void SpaceView::changeEvent(QEvent* event) {
    QGraphicsView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) applyStyle();
}

void SpaceView::wheelEvent(QWheelEvent* event) {
    m_input.wheel(*event);
    event->accept();
}

void SpaceView::mousePressEvent(QMouseEvent* event) {
    m_input.press(*event);
}

void SpaceView::mouseMoveEvent(QMouseEvent* event) {
    m_input.move(*event);
}

void SpaceView::mouseReleaseEvent(QMouseEvent* event) {
    m_input.release(*event);
}

void SpaceView::mouseDoubleClickEvent(QMouseEvent* event) {
    m_input.handleDoubleClick(*event);
}

void SpaceView::contextMenuEvent(QContextMenuEvent* event) {
    // Of the mouse, a click of the right button that does not turn the view.
    if (event->reason() != QContextMenuEvent::Mouse) showMenu(mapToGlobal(rect().center()));
    event->accept();
}

void SpaceView::keyPressEvent(QKeyEvent* event) {
    if (!m_input.keyPress(*event)) event->ignore();
}

void SpaceView::keyReleaseEvent(QKeyEvent* event) {
    m_input.keyRelease(*event);
}

void SpaceView::focusInEvent(QFocusEvent* event) {
    QGraphicsView::focusInEvent(event);
    refreshMarks();
}

void SpaceView::focusOutEvent(QFocusEvent* event) {
    QGraphicsView::focusOutEvent(event);
    refreshMarks();
}

bool SpaceView::focusNextPrevChild(bool next) {
    return m_input.focusVertex(next) || QGraphicsView::focusNextPrevChild(next);
}

} // namespace view
