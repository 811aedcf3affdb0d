// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_scene.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/geometry/canvas_note.h"
#include "canvas/items/attractor_item.h"
#include "canvas/items/border_arrows_item.h"
#include "canvas/items/cage_item.h"
#include "canvas/items/motion_path_item.h"
#include "canvas/items/shadow_item.h"
#include "canvas/items/symmetry_item.h"
#include "canvas/scene/frame_layout.h"
#include "canvas/scene/shadow_layout.h"
#include "canvas/scene/symmetry_layout.h"
#include "document/fractal/fractal_geometry.h"

#include <QFont>
#include <QLineF>

#include <algorithm>
#include <utility>

namespace view {

using Kind = CanvasPart::Kind;

namespace {

constexpr std::size_t maxAvoided = 300; // handles that sentences avoid
constexpr std::size_t maxCorners = 60;  // corners of maps that are not selected, in addition
constexpr double keyReach = 7;          // pixels from the middle of a diamond

// Returns true if every pixel is one of the background. A picture with content is recognised after a few
// pixels. The first points of a chaos game say nothing about the view.
bool showsNothing(const attractor::Frame& frame, const attractor::Rgba& background) {
    constexpr std::uint64_t enough = 100'000; // samples
    const bool isTelling = frame.measure < 1 || frame.samples >= enough;
    const auto opaque =
        std::uint32_t(0xff000000U | background.red << 16U | background.green << 8U | background.blue);
    const std::uint32_t empty = background.alpha < 255 ? 0 : opaque;
    return isTelling && frame.passes > 0 && !frame.pixels.empty() &&
           std::ranges::all_of(frame.pixels, [empty](std::uint32_t pixel) { return pixel == empty; });
}

} // namespace

CanvasScene::CanvasScene(document::Document* document, QObject* parent)
    : QGraphicsScene(parent),
      m_document(document),
      m_selection(*document),
      m_handles(*document, m_selection),
      m_attractor(std::make_unique<AttractorItem>()),
      m_grid(std::make_unique<GridItem>()),
      m_pathItem(std::make_unique<MotionPathItem>()),
      m_symmetryItem(std::make_unique<SymmetryItem>()),
      m_shadowItem(std::make_unique<ShadowItem>()),
      m_cageItem(std::make_unique<CageItem>()),
      m_mapFrames(std::make_unique<MapFramesItem>()),
      m_gizmo(std::make_unique<GizmoItem>()) {
    setItemIndexMethod(QGraphicsScene::NoIndex);
    addItem(m_attractor.get());
    m_attractor->setGrid(m_grid.get());
    double level = 1;
    for (OverlayItem* item : overlays()) {
        item->setZValue(level++);
        addItem(item);
    }
    raiseHeld();
    connect(&m_selection, &CanvasSelection::mapsChanged, this, &CanvasScene::requestLayout);
    connect(&m_selection, &CanvasSelection::pointedChanged, this, &CanvasScene::requestLayout);
    connect(&m_selection, &CanvasSelection::verticesChanged, this,
            [this] { m_cageItem->setSelected(m_selection.vertices()); });
    connect(&m_selection, &CanvasSelection::marksChanged, this, &CanvasScene::mark);
    connect(&m_handles, &HandleModel::targetChanged, this, &CanvasScene::changeTarget);
    connect(&m_handles, &HandleModel::changed, this, [this] {
        dropWhatIsGone();
        requestLayout();
    });
    connect(document, &document::Document::changed, this, &CanvasScene::follow);
    connect(document, &document::Document::cageModeChanged, this,
            [this](document::CageMode mode) { m_notes.setMode(modeNote(mode)); });
    m_notes.setMode(modeNote(document->cageMode()));
    follow({document::Change::Everything});
}

CanvasScene::~CanvasScene() = default;

CanvasScene::Batch::~Batch() {
    if (--m_scene.m_batches == 0 && m_scene.m_isLayoutStale) m_scene.layoutItems();
}

std::vector<OverlayItem*> CanvasScene::overlays() {
    std::vector<OverlayItem*> items{m_grid.get()};
    const auto add = [&](const std::vector<OverlayItem*>& more) {
        items.insert(items.end(), more.begin(), more.end());
    };
    add(m_marks.itemsBelowHandles());
    add({m_pathItem.get(), m_cageItem.get(), m_mapFrames.get(), m_gizmo.get(), m_symmetryItem.get(),
         m_shadowItem.get()});
    add(m_marks.itemsAboveHandles());
    add(m_notes.items());
    return items;
}

void CanvasScene::setView(const attractor::Camera& camera, double devicePixelRatio) {
    m_camera = camera;
    const QRectF area(0, 0, camera.width, camera.height);
    setSceneRect(area);
    m_attractor->setView(camera, devicePixelRatio);
    m_grid->setView(camera);
    m_gizmo->setView(area);
    m_marks.setView(camera);
    m_notes.setView(area);
    requestLayout();
}

void CanvasScene::setFrame(std::shared_ptr<const attractor::Frame> frame) {
    m_frame = frame;
    m_attractor->setFrame(std::move(frame));
    updateNote();
}

void CanvasScene::setDesktop(const QPalette& palette, const QFont& font) {
    m_palette = palette;
    m_notes.setFont(font);
    m_marks.setFont(font);
    setFont(font);
    restyle();
}

void CanvasScene::follow(const document::Change& change) {
    using document::Change;
    const Batch batch(*this);
    const std::size_t vertices = m_handles.vertexCount();
    m_handles.follow(change);
    if (change.parts & (Change::Current | Change::File)) m_selection.clear();
    const bool isMoved = !change.live && change.parts & (Change::Animation | Change::System | Change::Cage) &&
                         !(change.parts & Change::Time);
    if (isMoved || change.parts & (Change::Current | Change::File)) {
        m_paths = document::motionPaths(m_document->entryFractal());
        requestLayout();
    }
    const bool hasPaths = !m_paths.vertices.empty() || !m_paths.maps.empty();
    if (hasPaths && change.parts & Change::Time) requestLayout(); // other neighbouring keys
    if (change.parts & Change::Name) requestLayout();             // locks may have changed with the names
    if (change.parts & (Change::Appearance | Change::Time)) layoutKnobs(); // a shadow may have appeared
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) {
        requestLayout();
        m_selection.setMaps(m_selection.maps());   // selected maps that still exist
        if (vertices != m_handles.vertexCount()) { // vertices have been renumbered
            m_selection.setVertices({});
            if (m_selection.focused().map < 0) m_selection.setFocused({});
        }
        dropWhatIsGone();
        m_notes.forget();
        updateNote();
    }
    if (change.parts & (Change::Appearance | Change::Current | Change::File)) {
        restyle();
        if (!m_isLayoutStale) layoutFrames();
    }
}

void CanvasScene::changeTarget() {
    const Batch batch(*this);
    m_selection.setHovered({});
    m_selection.setFocused({});
    m_selection.setVertices({});
    m_cageItem->setQuiet(m_handles.target() != HandleTarget::Cage);
    raiseHeld();
    requestLayout();
}

void CanvasScene::dropWhatIsGone() {
    if (!m_handles.exists(m_selection.focused())) m_selection.setFocused({});
    if (!m_handles.exists(m_selection.hovered())) m_selection.setHovered({});
}

// Handles that can be held lie over outlines that only show something.
void CanvasScene::raiseHeld() {
    m_cageItem->setZValue(m_mapFrames->zValue() + (m_handles.target() == HandleTarget::Cage ? 0.5 : -0.5));
}

QPolygonF CanvasScene::cagePolygon() const {
    return m_handles.cage() ? pixelsOf(m_camera, m_handles.cage()->current) : QPolygonF();
}

CanvasPart CanvasScene::partAt(const QPointF& position, Reach reach) const {
    return m_overlaysVisible && m_cageVisible ? hitTester().partAt(position, reach) : CanvasPart();
}

void CanvasScene::holdKnobAt(const std::optional<QPointF>& position) {
    if (position == m_heldKnob) return;
    m_heldKnob = position;
    requestLayout();
}

SnapTargets CanvasScene::snapTargets(const CanvasPart& part, const std::vector<int>& moving) const {
    return {m_snapping, m_camera, m_handles.stillPoints(part, moving)};
}

void CanvasScene::requestLayout() {
    if (m_batches > 0)
        m_isLayoutStale = true;
    else
        layoutItems();
}

void CanvasScene::layoutItems() {
    m_isLayoutStale = false;
    m_cageItem->setPolygon(cagePolygon());
    // Corners of several maps have the numbers of those of the cage.
    std::vector<BorderArrow> arrows = borderArrows(pixelsOf(m_camera, m_handles.heldPoints()), sceneRect());
    const int vertices = std::max(int(m_handles.vertexCount()), 1);
    for (BorderArrow& arrow : arrows)
        arrow.vertex %= vertices;
    m_marks.borderArrows().setArrows(std::move(arrows));
    layoutFrames();
    layoutPaths();
    layoutKnobs();
    if (m_handles.cage()) {
        m_gizmoLayout = gizmoLayout(pixelsOf(m_camera, m_handles.heldPoints()),
                                    pixelOf(m_camera, m_handles.pivot()), sceneRect());
        const Kind pressed = m_selection.pressed().kind;
        if (m_heldKnob && pressed == Kind::Rotate) m_gizmoLayout.rotate = *m_heldKnob;
        if (m_heldKnob && pressed == Kind::Scale) m_gizmoLayout.scale = *m_heldKnob;
        m_gizmo->setLayout(m_gizmoLayout);
    }
    mark();
    updateVisibility();
}

void CanvasScene::layoutKnobs() {
    m_symmetryItem->setMarks(symmetryLayout(m_document->fractal(), m_camera));
    m_shadowItem->setMarks(shadowLayout(m_document->fractal(), m_camera));
}

// Positions of the handles that can be taken now.
std::vector<QPointF> CanvasScene::handlePositions() const {
    std::vector<QPointF> positions;
    if (!m_handles.cage()) return positions;
    if (m_handles.target() == HandleTarget::Cage) {
        const QPolygonF polygon = cagePolygon();
        positions.assign(polygon.begin(), polygon.end());
    }
    for (const MapFrame& frame : frames())
        if (frame.selected && !frame.isLocked && positions.size() < maxAvoided)
            positions.insert(positions.end(), frame.corners.begin(), frame.corners.end());
    if (m_handles.isAnythingHeld())
        for (const QPointF& knob : {m_gizmoLayout.pivot, m_gizmoLayout.rotate, m_gizmoLayout.scale})
            positions.push_back(knob);
    for (const auto& knob : {m_symmetryItem->knob(), m_shadowItem->knob()})
        if (knob) positions.push_back(*knob);
    std::vector<QPointF> others;
    for (const MapFrame& frame : frames())
        if (!frame.selected && !frame.isLocked && others.size() <= maxCorners)
            others.insert(others.end(), frame.corners.begin(), frame.corners.end());
    if (others.size() <= maxCorners) positions.insert(positions.end(), others.begin(), others.end());
    return positions;
}

// Shows the paths of the current target: the cage, or the maps.
void CanvasScene::layoutPaths() {
    std::vector<MotionPathItem::Way> ways;
    for (const document::MotionPath& path : paths())
        ways.push_back({pixelsOf(m_camera, path.points), pixelsOf(m_camera, path.keys)});
    m_pathItem->setWays(std::move(ways), ghosts());
}

const std::vector<document::MotionPath>& CanvasScene::paths() const {
    static const std::vector<document::MotionPath> none;
    if (m_handles.target() == HandleTarget::Branch) return none;
    return m_handles.target() == HandleTarget::Cage ? m_paths.vertices : m_paths.maps;
}

// The cage, or each map, at the key before the moment and at the one after it.
std::vector<QPolygonF> CanvasScene::ghosts() const {
    std::vector<QPolygonF> result;
    const bool isCage = m_handles.target() == HandleTarget::Cage;
    const auto add = [&](const document::MotionPath& path, std::size_t key) {
        std::vector<ifs::Vector<2>> outline;
        if (isCage)
            for (const document::MotionPath& vertex : paths())
                outline.push_back(vertex.keys[key]);
        result.push_back(pixelsOf(m_camera, isCage ? outline : path.outlines[key]));
    };
    const animation::Moment& now = m_document->moment();
    for (const document::MotionPath& path : paths()) {
        const auto next = std::ranges::find_if(
            path.frames, [&](int frame) { return frame * now.denominator > now.numerator; });
        const auto isNow = [&](int frame) { return frame * now.denominator == now.numerator; };
        auto before = std::size_t(next - path.frames.begin());
        if (before > 0 && isNow(path.frames[before - 1])) --before;
        if (before > 0) add(path, before - 1);
        if (next != path.frames.end()) add(path, std::size_t(next - path.frames.begin()));
        if (isCage) break; // all vertices have the same keys
    }
    return result;
}

std::optional<CanvasScene::KeyOnPath> CanvasScene::keyAt(const QPointF& position, Reach reach) const {
    const Kind kind = partAt(position, reach).kind;
    const bool isFree = kind == Kind::None || kind == Kind::Inside || kind == Kind::Edge;
    if (!m_overlaysVisible || !m_handles.cage() || !isFree) return std::nullopt;
    const bool isCage = m_handles.target() == HandleTarget::Cage;
    for (const document::MotionPath& path : paths()) {
        const QPolygonF keys = pixelsOf(m_camera, path.keys);
        for (qsizetype i = 0; i < keys.size(); ++i)
            if (QLineF(keys[i], position).length() <= keyReach)
                return KeyOnPath{path.frames[std::size_t(i)],
                                 isCage ? CanvasPart{Kind::Vertex, int(path.index), -1}
                                        : CanvasPart{Kind::Inside, 0, int(path.index)}};
    }
    return std::nullopt;
}

void CanvasScene::layoutFrames() {
    FrameLayout layout = frameLayout(m_handles, m_selection, m_document->fractal(), m_camera);
    m_isThinnedOut = layout.isThinnedOut;
    m_mapFrames->setFrames(std::move(layout.frames), m_handles.target() == HandleTarget::Cage
                                                         ? MapFramesItem::Mode::Hint
                                                         : MapFramesItem::Mode::Held);
}

void CanvasScene::mark() {
    const CanvasPart focused = m_selection.focused();
    const bool lacksFrame =
        m_handles.target() == HandleTarget::Maps && focused.map >= 0 && !frameOf(frames(), focused.map);
    if (lacksFrame && !m_isLayoutStale) layoutFrames();
    m_cageItem->setMarks(m_selection.hovered(), m_selection.pressed(), focused);
    m_mapFrames->setMarks(m_selection.hovered(), m_selection.pressed(), focused);
    m_gizmo->setMarks(m_selection.hovered(), m_selection.pressed(), focused);
}

void CanvasScene::restyle() {
    const OverlayStyle style = overlayStyle(m_document->fractal().appearance.background, m_palette);
    m_attractor->setStyle(style);
    for (OverlayItem* item : overlays())
        item->setStyle(style);
}

void CanvasScene::updateNote() {
    const document::Fractal& fractal = m_document->fractal();
    if (m_frame)
        m_notes.describe(fractal, m_frame->note, showsNothing(*m_frame, fractal.appearance.background));
    else
        m_notes.describe(fractal, attractor::RenderNote::None);
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
    for (OverlayItem* item : overlays())
        item->setVisible(m_overlaysVisible);
    const bool cage = m_overlaysVisible && m_cageVisible && m_handles.cage();
    m_cageItem->setVisible(cage);
    m_marks.borderArrows().setVisible(cage);
    m_mapFrames->setVisible(cage);
    m_pathItem->setVisible(cage);
    m_symmetryItem->setVisible(cage);
    m_shadowItem->setVisible(cage);
    m_gizmo->setVisible(cage && m_handles.isAnythingHeld());
    m_notes.avoid(handlePositions());
}

} // namespace view
