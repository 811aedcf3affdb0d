// SPDX-License-Identifier: MIT
#include "space/space_view.h"

#include "animation/paths/camera_path.h"
#include "canvas/geometry/canvas_note.h"
#include "canvas/items/note_item.h"
#include "document/fractal/space_geometry.h"
#include "io/report/figure_error.h"
#include "space/space_symmetry.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QGraphicsScene>
#include <QMenu>

#include <algorithm>
#include <utility>

namespace view {

namespace {

// Returns true if the view is empty. A solid is recognised after a few pixels.
bool showsNothing(const attractor::SolidFrame& frame) {
    return std::ranges::all_of(frame.raster.keys,
                               [](std::uint32_t key) { return key == attractor::emptyKey; });
}

// Corners of the box around the displayed picture, where it is cut.
std::vector<ifs::Vector<3>> cornersOfCut(const document::Fractal& fractal) {
    if (!document::space(fractal) || !fractal.inSpace.clip || !document::isSpaceExtentKnown(fractal))
        return {};
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
    : Viewport(parent),
      m_document(document),
      m_bridge(bridge),
      m_solid(new SolidItem),
      m_outlines(new SpaceOutlinesItem),
      m_cageItem(new SpaceCageItem),
      m_mapOutlines(new SpaceOutlinesItem),
      m_mapItem(new SpaceCageItem),
      m_definitionLines(new SpaceOutlinesItem),
      m_slice(new SliceItem),
      m_symmetry(new SymmetryItem),
      m_ball(new AxisBall),
      m_arrows(new BorderArrowsItem),
      m_note(new NoteItem(NoteItem::Edge::Top)),
      m_title(new NoteItem(NoteItem::Edge::Bottom)),
      m_navigation(document, bridge, viewport()),
      m_maps(document, *m_mapOutlines, *m_mapItem),
      m_branch(document, *m_mapOutlines, *m_mapItem),
      m_definition(*m_definitionLines),
      m_input(document, m_navigation,
              {*m_cageItem, m_maps, m_branch, *m_mapItem, m_definition, *m_slice, *m_symmetry, *m_ball,
               *m_arrows}),
      m_corners(document, {[this] { return areCornersInView(); }, [this] { return wasShown(); },
                           [this] {
                               return m_input.isHolding() ||
                                      qobject_cast<SpaceView*>(QApplication::focusWidget()) != nullptr;
                           },
                           [this] { m_navigation.fit(); }}),
      m_around(cornersOfCut(document->fractal())),
      m_orbit(document->orbit()) {
    showScene(new QGraphicsScene(this)); // owner of the items
    setCage(document::knownSpaceCage(document->fractal()));
    m_isExtentKnown = document::isSpaceExtentKnown(document->fractal());
    for (OverlayItem* item : std::initializer_list<OverlayItem*>{
             m_solid, m_ball, m_outlines, m_cageItem, m_mapOutlines, m_mapItem, m_definitionLines, m_slice,
             m_symmetry, m_arrows, m_note, m_title})
        scene()->addItem(item);
    setUpWidget();
    connect(document, &document::Document::changed, this, &SpaceView::followDocument);
    connect(document, &document::Document::cageModeChanged, this, &SpaceView::showNote);
    connect(bridge, &SolidBridge::frameChanged, this, [this] {
        m_solid->setFrame(m_bridge->frame());
        if (m_bridge->isCurrent()) {
            layOut(); // updates hidden handles
            m_input.reportAgain();
        }
        showNote();
    });
    connect(&m_navigation, &SpaceNavigation::changed, this, [this] {
        layOut();
        m_corners.look();
    });
    connect(&m_navigation, &SpaceNavigation::changed, &m_input, &SpaceInput::reportAgain,
            Qt::QueuedConnection);
    followInput();
    m_cageItem->setFacesHeld(true);
    setTarget(Target::Cage);
    adoptDesktop();
}

void SpaceView::followInput() {
    connect(&m_input, &SpaceInput::changed, this, &SpaceView::refreshMarks);
    connect(&m_input, &SpaceInput::mapSelected, this, [this] {
        layOut();
        if (const auto map = heldMap()) emit mapHeld(*map);
    });
    connect(&m_input, &SpaceInput::stopped, this, [this](const QString& why) {
        m_stop = why;
        showNote();
    });
    connect(&m_input, &SpaceInput::defined, this, &SpaceView::defined);
    connect(&m_input, &SpaceInput::prompted, this, &SpaceView::showNote);
    connect(&m_input, &SpaceInput::pointerMoved, this, &SpaceView::pointerMoved);
    connect(&m_input, &SpaceInput::menuRequested, this,
            [this](const QPointF& position) { showMenu(viewport()->mapToGlobal(position.toPoint())); });
}

void SpaceView::setCage(const std::optional<ifs::ControlCage<3>>& cage) {
    if (!cage || !m_cage || cage->rest != m_cage->rest)
        m_faces = SpaceCageItem::facesOf(cage ? cage->rest : std::vector<ifs::Vector<3>>());
    m_cage = cage;
}

void SpaceView::showNote() {
    // True in views whose message the main view shows.
    const bool isSpokenFor = isFixed() && !m_definition.hasBegun();
    const auto frame = m_bridge->frame();
    const auto note = [&] {
        if (isFixed()) return QString();
        const document::Fractal& fractal = m_document->fractal();
        const QString found =
            noteInSpace(fractal, frame ? frame->note : attractor::RenderNote::None, frame && frame->isCoarse);
        const bool isCut = fractal.inSpace.clip.has_value(); // a cut, which no change of the view undoes
        return found.isEmpty() && !isCut && frame && showsNothing(*frame) ? nothingHere() : found;
    };
    const bool defines = m_definition.isActive();
    const bool isSilent = isSpokenFor || !areOverlaysShown(); // true if a click would have no effect
    QString said = !defines ? m_stop : isSilent ? QString() : m_definition.prompt();
    if (said.isEmpty()) said = note();
    if (said.isEmpty() && !defines && !isSpokenFor) said = m_branch.prompt();
    if (said.isEmpty() && !isFixed()) said = modeNote(m_document->cageMode()); // least urgent
    m_note->setText(said);
}

void SpaceView::setTarget(Target target) {
    // Before the release of held parts, so that it does not count as cancelled by the user.
    m_definition.setActive(false);
    m_input.forgetFocus();
    m_maps.setActive(target == Target::Maps);
    m_branch.setActive(target == Target::Branch);
    m_definition.setActive(target == Target::Definition);
    showNote();
    m_cageItem->setHandlesVisible(target == Target::Cage);
    layOut();
}

void SpaceView::setBranchChoice(BranchChoice* choice) {
    if (BranchChoice* before = m_branch.choice()) before->disconnect(this);
    m_branch.setChoice(choice);
    if (!choice) return;
    connect(choice, &BranchChoice::changed, this, [this] {
        if (!m_branch.isActive() || !document::space(m_document->fractal())) return;
        showNote();
        layOut();
    });
}

void SpaceView::holdMap(std::optional<std::size_t> index, std::vector<ifs::MapId> among) {
    if (!m_maps.select(index, std::move(among))) return;
    layOut();
    emit mapsSelected();
}

void SpaceView::fixDirection(const attractor::Direction& direction, const QString& title) {
    m_title->setText(title);
    setAccessibleName(tr("Canvas in space: %1").arg(title));
    m_navigation.fixDirection(direction);
    showNote();
    layOut();
}

SpaceView::~SpaceView() {
    m_input.cancelDrag(); // before the view is emptied
}

void SpaceView::setUpWidget() {
    setAccessibleName(tr("Canvas in space"));
    setWhatsThis(
        tr("The solid and its tetrahedron. Drag a corner: X, Y or Z keeps it on an axis, with Shift in "
           "a plane, and the wheel pushes it away. Drag anywhere else to turn the view; the wheel zooms "
           "at the pointer, the middle button pans. Double-click the solid to turn about that point."));
    describeFocus();
}

// Setting it is announced, also where it does not change.
void SpaceView::describeFocus() {
    const QString text = focusText();
    if (text != accessibleDescription()) setAccessibleDescription(text);
}

QString SpaceView::focusText() const {
    if (const auto end = m_ball->focused()) return ballText(*end);
    const auto vertex = m_input.focusedVertex();
    const auto& vertices = (holdsMap() ? m_mapItem : m_cageItem)->vertices();
    if (!vertex || *vertex >= vertices.size())
        return tr("The attractor and its control tetrahedron. Tab moves from corner to corner and to the "
                  "ball of axes, the arrow keys move the corner in focus or turn the view, F6 leaves the "
                  "canvas.");
    double size = 0;
    for (const ifs::Vector<3>& corner : vertices)
        size = std::max(size, corner.norm());
    const ifs::Vector<3> at = io::withoutNoise(vertices[*vertex], 1e-15 * size);
    const auto map = m_maps.selected();
    const QString corner = map                   ? tr("Map %5, corner %1 at %2, %3, %4")
                           : m_branch.isActive() ? tr("Corner %1 of the branch at %2, %3, %4")
                                                 : tr("Vertex %1 at %2, %3, %4");
    const QString middle =
        map ? tr("Map %4, its middle at %1, %2, %3") : tr("The middle of the branch at %1, %2, %3");
    QString text = holdsMap() && *vertex == SpaceMaps::middle ? middle : corner.arg(*vertex + 1);
    text = text.arg(at.x(), 0, 'g', 6).arg(at.y(), 0, 'g', 6).arg(at.z(), 0, 'g', 6);
    return map ? text.arg(*map + 1) : text;
}

QString SpaceView::ballText(const AxisBall::End& end) const {
    const QString chosen =
        end.isPositive ? tr("Ball of axes, positive end of %1.") : tr("Ball of axes, negative end of %1.");
    const QString next = AxisBall::looksFrom(m_navigation.camera(), end)
                             ? tr("The view looks from there; Enter looks from behind.")
                             : tr("Enter looks from there, the arrow keys choose another end.");
    return chosen.arg(QChar(u'X' + end.axis)) + u' ' + next;
}

void SpaceView::followDocument(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File | Change::System | Change::Cage | Change::Appearance))
        followFractal(change);
    if (change.parts & (Change::Current | Change::File | Change::System)) showNote();
    followCamera(change);
    m_corners.follow(change, this);
}

void SpaceView::followFractal(const document::Change& change) {
    using document::Change;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    const auto cage = document::knownSpaceCage(m_document->fractal());
    const bool isKnown = document::isSpaceExtentKnown(m_document->fractal());
    const bool isFound = !std::exchange(m_isExtentKnown, isKnown) && isKnown; // found in the background
    if (cage || isAnother || !document::space(m_document->fractal())) setCage(cage);
    if (!change.live) m_around = cornersOfCut(m_document->fractal());
    if (isAnother) m_input.forgetFocus();
    if (isAnother || change.parts & Change::Appearance) adoptDesktop();
    if (isAnother && wasShown()) m_navigation.fit();
    if (isFound && m_navigation.isFitted()) m_navigation.fit();
    layOut();
}

// Keys say where to look, whatever the user has done since; an orbit without keys goes on from there, also
// while its axis or pivot is being chosen.
void SpaceView::followCamera(const document::Change& change) {
    using document::Change;
    const auto before = std::exchange(m_orbit, m_document->orbit());
    const bool isAnother = change.parts & (Change::Current | Change::File);
    const bool isLater = !isAnother && change.parts & Change::Time;
    if (m_document->camera()) {
        if (isAnother || isLater) lookAsKeyed(change.live);
    } else if (!isAnother && m_orbit != before && !isFixed() && document::space(m_document->fractal())) {
        const attractor::OrbitCamera still = animation::orbitedBack(m_navigation.camera(), before);
        m_navigation.moveTo(animation::orbited(still, m_orbit), change.live);
    }
}

void SpaceView::lookAsKeyed(bool isMoving) {
    const auto& camera = m_document->camera();
    if (!camera || isFixed()) return;
    m_navigation.followKeys(animation::orbited(*camera, m_document->orbit()), isMoving);
}

bool SpaceView::areCornersInView() const {
    return !m_cage || isFixed() ||
           borderArrows(m_cageItem->handles(), {QPointF(), QSizeF(viewport()->size())}).empty();
}

void SpaceView::setOverlaysVisible(bool visible) {
    m_overlays = visible;
    m_input.setEnabled(areOverlaysShown());
    layOut();
}

void SpaceView::setStereo(attractor::Stereo stereo) {
    m_navigation.setStereo(stereo);
    m_input.setEnabled(areOverlaysShown());
    // Cancels a definition, whose corners could not be clicked.
    if (!areOverlaysShown()) m_input.cancelGesture();
    layOut();
}

bool SpaceView::areOverlaysShown() const {
    return m_overlays && picturesAcross(m_navigation.stereo()) == 1;
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
    const QSizeF size = viewport()->size();
    m_solid->setView(size, ratio);
    m_note->setView({QPointF(), size});
    m_title->setView({QPointF(), size});
    const bool isShown = m_cage && areOverlaysShown();
    m_outlines->setVisible(isShown);
    m_definitionLines->setVisible(isShown);
    m_definitionLines->layOut(camera);
    m_cageItem->setVisible(isShown);
    m_slice->setVisible(isShown);
    m_symmetry->setVisible(isShown);
    m_ball->layOut(camera);
    m_ball->setVisible(isShown && !isFixed());
    m_note->avoid({}, m_ball->isVisible() ? m_ball->boundingRect() : QRectF());
    m_arrows->setVisible(isShown && !holdsMap() && !m_definition.isActive());
    m_mapOutlines->setVisible(isShown && holdsMap());
    m_mapItem->setVisible(isShown && holdsMap());
    if (!isShown) return refreshMarks(); // hidden parts have no focus
    m_outlines->layOut(camera);
    layOutSlice();
    m_symmetry->setMarks(symmetryLayout(m_document->fractal(), camera));
    const auto frame = m_bridge->isCurrent() ? m_bridge->frame() : nullptr;
    const double touching = 3 / pixelsPerUnit(camera); // tolerance for vertices on the surface
    const auto isHidden = [&](const attractor::ScreenPoint& seen) {
        return frame && depthAt(*frame, seen.pixel * ratio) < seen.depth - touching;
    };
    m_cageItem->layOut(camera, m_cage->current, m_faces, isHidden);
    m_arrows->setView({QPointF(), size});
    m_arrows->setArrows(borderArrows(m_cageItem->handles(), {QPointF(), size}));
    m_maps.layOut(camera, m_cage, isHidden);
    m_branch.layOut(camera, m_cage, isHidden);
    refreshMarks();
}

void SpaceView::layOutSlice() {
    const auto& clip = m_document->fractal().inSpace.clip;
    const bool isCut = clip && !m_around.empty();
    m_slice->layOut(m_navigation.camera(), isCut ? std::optional(slicePlane(*clip, m_around)) : std::nullopt);
}

void SpaceView::adoptDesktop() {
    const OverlayStyle style = overlayStyle(document::backgroundInSpace(m_document->fractal()), palette());
    for (OverlayItem* item : std::initializer_list<OverlayItem*>{
             m_solid, m_ball, m_outlines, m_cageItem, m_mapOutlines, m_mapItem, m_definitionLines, m_slice,
             m_symmetry, m_arrows, m_note, m_title})
        item->setStyle(style);
    m_note->setFont(font());
    m_title->setFont(font());
}

void SpaceView::refreshMarks() {
    m_input.showMarks(hasFocus());
    refreshCursor();
    describeFocus();
}

void SpaceView::showMenu(const QPoint& global) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Fit"), &m_navigation, &SpaceNavigation::fit);
    if (isFixed()) return menu->popup(global);
    QAction* perspective = menu->addAction(tr("&Perspective"));
    perspective->setCheckable(true);
    perspective->setChecked(m_navigation.isPerspective());
    connect(perspective, &QAction::toggled, &m_navigation, &SpaceNavigation::setPerspective);
    menu->addSeparator();
    const std::pair<QString, attractor::Direction> views[] = {
        {tr("Look from the F&ront"), directions::front},
        {tr("Look from the &Right"), directions::right},
        {tr("Look from &Above"), directions::top},
    };
    for (const auto& [text, from] : views)
        menu->addAction(text, this, [this, from = from] { m_navigation.lookFrom(from); });
    menu->popup(global);
}

void SpaceView::begin() {
    m_navigation.fit();
    lookAsKeyed(false);
}

void SpaceView::contextMenuEvent(QContextMenuEvent* event) {
    // Opens the menu for keys only; the mouse opens it by a click of the right button that does not turn the
    // view.
    if (event->reason() != QContextMenuEvent::Mouse) showMenu(mapToGlobal(rect().center()));
    event->accept();
}

bool SpaceView::focusNextPrevChild(bool next) {
    return m_input.moveFocus(next) || Viewport::focusNextPrevChild(next);
}

} // namespace view
