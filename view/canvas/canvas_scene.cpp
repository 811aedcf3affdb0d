// SPDX-License-Identifier: MIT
#include "canvas/canvas_scene.h"

#include "canvas/analysis_item.h"
#include "canvas/attractor_item.h"
#include "canvas/cage_item.h"
#include "canvas/canvas_geometry.h"
#include "canvas/canvas_marks.h"
#include "canvas/canvas_note.h"
#include "canvas/grid_item.h"
#include "canvas/map_frames_item.h"
#include "canvas/note_item.h"
#include "canvas/trail_item.h"

#include <QFont>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

// Of maps that are taken; more, and their moves, would take longer than an event of a drag may.
constexpr std::size_t mostFrames = 10'000;
constexpr std::size_t mostChosen = 1000; // selected ones, of more than that
constexpr std::size_t mostHints = 1000;  // at selected maps that are not taken: more would hide the picture

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

} // namespace

CanvasScene::CanvasScene(document::Document* document, QObject* parent)
    : QGraphicsScene(parent),
      m_document(document),
      m_attractor(std::make_unique<AttractorItem>()),
      m_grid(std::make_unique<GridItem>()),
      m_analysisItem(std::make_unique<AnalysisItem>()),
      m_cageItem(std::make_unique<CageItem>()),
      m_mapFrames(std::make_unique<MapFramesItem>()),
      m_gizmo(std::make_unique<GizmoItem>()),
      m_snapMark(std::make_unique<SnapMark>()),
      m_trailItem(std::make_unique<TrailItem>()),
      m_rubber(std::make_unique<RubberItem>()),
      m_band(std::make_unique<BandItem>()),
      m_noteItem(std::make_unique<NoteItem>(NoteItem::Place::Top)),
      m_promptItem(std::make_unique<NoteItem>(NoteItem::Place::Bottom)) {
    setItemIndexMethod(QGraphicsScene::NoIndex);
    addItem(m_attractor.get());
    double level = 1;
    for (OverlayItem* item : overlays()) {
        item->setZValue(level++);
        addItem(item);
    }
    raiseTaken();
    connect(document, &document::Document::changed, this, &CanvasScene::follow);
    follow({document::Change::Everything});
}

CanvasScene::~CanvasScene() = default;

std::vector<OverlayItem*> CanvasScene::overlays() const {
    return {m_grid.get(),      m_analysisItem.get(), m_trailItem.get(), m_cageItem.get(),
            m_mapFrames.get(), m_gizmo.get(),        m_rubber.get(),    m_snapMark.get(),
            m_band.get(),      m_noteItem.get(),     m_promptItem.get()};
}

void CanvasScene::setView(const attractor::Camera& camera, double devicePixelRatio) {
    m_camera = camera;
    const QRectF area(0, 0, camera.width, camera.height);
    setSceneRect(area);
    m_attractor->setView(camera, devicePixelRatio);
    m_grid->setView(camera);
    m_analysisItem->setView(camera);
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
        m_branch.clear();
        m_branchHandles.reset();
        setFocused({});
        setSelectedMaps({});
        setSelectedVertices({});
    }
    if (change.parts & (Change::System | Change::Appearance | Change::Current | Change::File)) {
        m_mapColours.clear();
        if (const document::System2* system = document::system2(fractal))
            for (std::size_t place = 0; place < system->maps.size(); ++place) {
                const auto colour = attractor::mapColour(fractal.appearance, system->maps[place].id, place);
                m_mapColours.emplace_back(colour.red, colour.green, colour.blue);
            }
    }
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) {
        const std::size_t vertices = m_cage ? m_cage->current.size() : 0;
        m_cage = document::system2(fractal) ? std::optional(document::effectiveCage(fractal)) : std::nullopt;
        m_handles = m_cage ? std::optional<document::MapHandles>(std::in_place,
                                                                 m_document->currentEntry().fractal, *m_cage)
                           : std::nullopt;
        setSelectedMaps(m_selectedMaps);                         // those that are left
        if (vertices != (m_cage ? m_cage->current.size() : 0)) { // others have the numbers now
            setSelectedVertices({});
            if (m_focused.map < 0) setFocused({});
        }
        takeBranch();
        m_addresses.reset();
        if (!exists(m_focused)) setFocused({});
        if (!exists(m_hovered)) setHovered({});
        place();
    }
    if (change.parts & (Change::System | Change::Cage | Change::Current | Change::File)) {
        m_noteStale = true;
        updateNote();
    }
    if (change.parts & (Change::Appearance | Change::Current | Change::File)) {
        restyle();
        placeMaps();
    }
}

QPolygonF CanvasScene::cagePolygon() const {
    QPolygonF polygon;
    if (m_cage)
        for (const ifs::Vector<2>& vertex : m_cage->current)
            polygon.append(pixelOf(m_camera, vertex));
    return polygon;
}

ifs::Vector<2> CanvasScene::pivot() const {
    const std::vector<ifs::Vector<2>> points = m_pivot ? std::vector<ifs::Vector<2>>() : takenPoints();
    if (points.empty()) return m_pivot.value_or(ifs::Vector<2>::Zero());
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const ifs::Vector<2>& point : points)
        sum += point;
    return sum / double(points.size());
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
    if (anythingTaken()) {
        consider(Kind::Pivot, 0, m_gizmoLayout.pivot);
        consider(Kind::Scale, 0, m_gizmoLayout.scale);
        consider(Kind::Rotate, 0, m_gizmoLayout.rotate);
    }
    if (m_taken != Taken::Cage) {
        // A corner comes before the pivot under it, as a vertex of the cage does.
        const CanvasPart part = framePartAt(m_mapFrames->frames(), position, handle, edge);
        return nearest.kind == Kind::None ||
                       (part.kind == Kind::Vertex && distance(positionOf(part)) <= least)
                   ? part
                   : nearest;
    }
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

bool CanvasScene::exists(const CanvasPart& part) const {
    if (part.kind == Kind::None) return true;
    const bool hasIndex = part.kind == Kind::Vertex || part.kind == Kind::Edge;
    return m_cage && part.map < childCount() && (!hasIndex || part.index < int(m_cage->current.size()));
}

QPointF CanvasScene::positionOf(const CanvasPart& part) const {
    if (part.map >= 0) {
        if (part.map >= childCount()) return {};
        const QPolygonF corners = inPixels(childCorners(part.map));
        if (part.kind == Kind::Vertex) return corners.value(part.index);
        QPointF sum;
        for (const QPointF& corner : corners)
            sum += corner;
        return sum / double(std::max<qsizetype>(1, corners.size()));
    }
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
    const int corners = int(m_cage->current.size());
    for (int child = 0; child < childCount(); ++child) {
        parts.push_back({Kind::Inside, 0, child});
        for (int i = 0; i < corners; ++i)
            parts.push_back({Kind::Vertex, i, child});
    }
    for (int i = 0; m_taken == Taken::Cage && i < corners; ++i)
        parts.push_back({Kind::Vertex, i});
    if (m_taken == Taken::Cage) parts.push_back({Kind::Inside, 0});
    for (const Kind kind : {Kind::Pivot, Kind::Rotate, Kind::Scale})
        parts.push_back({kind, 0});
    return parts;
}

QString CanvasScene::nameOf(const CanvasPart& part) const {
    if (part.map >= 0) {
        const QString name = m_taken == Taken::Branch
                                 ? tr("Branch %1").arg(document::addressText(m_branch, m_branch.size()))
                                 : tr("Map %1").arg(part.map + 1);
        return part.kind == Kind::Vertex ? tr("%1, corner %2").arg(name).arg(part.index + 1) : name;
    }
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
        if (part.map >= 0) return coordinates(m_camera, childCorners(part.map)[std::size_t(part.index)]);
        return m_cage ? coordinates(m_camera, m_cage->current[std::size_t(part.index)]) : QString();
    case Kind::Pivot:
        return coordinates(m_camera, pivot());
    case Kind::Edge:
        return tr("the arrow keys move both its ends");
    case Kind::Inside:
        return tr("the arrow keys move it");
    case Kind::Rotate:
        return tr("the arrow keys turn by one degree");
    case Kind::Scale:
        return tr("the arrow keys scale by one percent");
    case Kind::None:
        break;
    }
    return {};
}

QString CanvasScene::useOf(const CanvasPart& part) const {
    switch (part.kind) {
    case Kind::Pivot:
        return tr("Drag the pivot: turning and scaling are about it.");
    case Kind::Rotate:
        return tr("Drag to turn about the pivot; Shift: in steps of 15°.");
    case Kind::Scale:
        return tr("Drag to scale about the pivot; Shift: along x or y only.");
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
    if (m_taken == Taken::Maps && part.map >= 0 && !frameOf(part.map)) placeMaps();
    mark();
    emit focusChanged();
}

void CanvasScene::holdKnobAt(const std::optional<QPointF>& position) {
    m_heldKnob = position;
    place();
}

SnapTargets CanvasScene::snapTargets(const CanvasPart& part, const std::vector<int>& moving) const {
    SnapTargets targets{m_snapping, m_camera, {}};
    if (!m_cage) return targets;
    const auto addStill = [&](const std::vector<ifs::Vector<2>>& points, bool anyMoves) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!anyMoves || std::ranges::find(moving, int(i)) == moving.end())
                targets.vertices.push_back(points[i]);
    };
    if (m_taken == Taken::Cage) targets.vertices = m_cage->rest;
    addStill(m_cage->current, m_taken == Taken::Cage);
    std::vector<bool> isChosen(std::size_t(childCount()), m_taken == Taken::Branch);
    if (m_taken == Taken::Maps)
        for (const std::size_t place : selectedPlaces())
            isChosen[place] = true;
    for (int child = 0; child < childCount(); ++child) {
        const bool whole = part.kind != Kind::Vertex && !moving.empty() && isChosen[std::size_t(child)];
        if (!whole) addStill(childCorners(child), child == part.map);
    }
    return targets;
}

void CanvasScene::showSnap(const std::optional<Snapped>& snap) {
    m_snap = snap;
    m_snapMark->setSnap(snap, snap ? pixelOf(m_camera, snap->point) : QPointF());
}

void CanvasScene::showBand(const QRectF& band) {
    m_band->setBand(band);
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
    placeMaps();
    if (m_cage) {
        QPolygonF points;
        for (const ifs::Vector<2>& point : takenPoints())
            points.append(pixelOf(m_camera, point));
        m_gizmoLayout = gizmoLayout(points, pixelOf(m_camera, pivot()), sceneRect());
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

QPolygonF CanvasScene::inPixels(const std::vector<ifs::Vector<2>>& points) const {
    QPolygonF polygon;
    for (const ifs::Vector<2>& point : points)
        polygon.append(pixelOf(m_camera, point));
    return polygon;
}

QRectF CanvasScene::inPixels(const document::Box& box) const {
    return QRectF(pixelOf(m_camera, box.min), pixelOf(m_camera, box.max)).normalized();
}

// Of too many those near the view, and if these are too many every so many of them.
std::vector<std::size_t> CanvasScene::placesShown(const std::vector<bool>& isChosen) {
    std::vector<std::size_t> places(isChosen.size());
    std::iota(places.begin(), places.end(), std::size_t(0));
    m_thinned = false;
    if (places.size() <= mostFrames) return places;
    const bool withChosen = std::ranges::count(isChosen, true) <= std::ptrdiff_t(mostChosen);
    const auto mayGo = [&](std::size_t place) {
        return !(withChosen && isChosen[place]) && int(place) != m_focused.map;
    };
    const QSizeF margin = m_handles->bends() ? sceneRect().size() : QSizeF(1, 1);
    const QRectF near =
        sceneRect().adjusted(-margin.width(), -margin.height(), margin.width(), margin.height());
    const std::vector<document::Box> boxes = m_handles->boxes();
    std::erase_if(places, [&](std::size_t place) {
        const QRectF box = inPixels(boxes[place]).adjusted(-1, -1, 1, 1); // a flat one is empty
        return mayGo(place) && !near.intersects(box);
    });
    const std::size_t stride = (places.size() + mostFrames - 1) / mostFrames;
    m_thinned = stride > 1;
    if (m_thinned)
        std::erase_if(places, [&, k = std::size_t(0)](std::size_t place) mutable {
            return k++ % stride != 0 && mayGo(place);
        });
    return places;
}

void CanvasScene::placeMaps() {
    std::vector<MapFrame> frames;
    const auto add = [&](const document::MapHandles& handles, std::size_t place, int child,
                         const QColor& colour, bool selected) {
        frames.push_back({child,
                          m_taken == Taken::Cage ? QPolygonF() : inPixels(handles.corners(place)), // a hint
                          inPixels(handles.outline(place)), colour, selected, handles.maps()[place].enabled});
    };
    if (m_taken == Taken::Branch && m_branchHandles)
        add(*m_branchHandles, 0, 0, m_mapColours.at(std::size_t(m_branch.front())), true);
    std::vector<bool> isChosen(std::size_t(mapCount()), false);
    for (const std::size_t place : selectedPlaces())
        isChosen[place] = true;
    if (m_taken == Taken::Maps)
        for (const std::size_t place : placesShown(isChosen))
            add(*m_handles, place, int(place), m_mapColours.at(place), isChosen[place]);
    for (std::size_t place = 0; m_taken == Taken::Cage && place < isChosen.size(); ++place)
        if (isChosen[place] && frames.size() < mostHints)
            add(*m_handles, place, int(place), m_mapColours.at(place), true);
    m_mapFrames->setFrames(std::move(frames),
                           m_taken == Taken::Cage ? MapFramesItem::Mode::Hint : MapFramesItem::Mode::Held);
}

int CanvasScene::childCount() const {
    if (m_taken == Taken::Branch) return m_branchHandles ? 1 : 0;
    return m_taken == Taken::Maps ? mapCount() : 0;
}

std::vector<ifs::Vector<2>> CanvasScene::childCorners(int child) const {
    if (m_taken == Taken::Branch) return m_branchHandles->corners(0);
    return m_handles->corners(std::size_t(child));
}

void CanvasScene::takeBranch() {
    m_branchHandles.reset();
    if (m_taken != Taken::Branch || !m_cage) return;
    const auto shown = document::branchHandles(m_document->currentEntry().fractal, *m_cage, m_branch,
                                               document::BranchEdit::Display);
    if (shown) m_branchHandles = shown->handles;
}

void CanvasScene::setBranch(const ifs::Word& branch) {
    if (branch == m_branch) return;
    m_branch = branch;
    takeBranch();
    if (m_taken == Taken::Branch) {
        if (m_pressed.kind == Kind::None) m_pivot.reset();
        if (!exists(m_focused)) setFocused({});
    }
    place();
}

const document::Addresses& CanvasScene::addresses() {
    if (!m_addresses) m_addresses.emplace(m_document->fractal());
    return *m_addresses;
}

ifs::Word CanvasScene::addressAt(const QPointF& position) {
    if (!m_cage) return {};
    return addresses().at(worldAt(m_camera, position), 1 / m_camera.pixelsPerUnit);
}

std::vector<ifs::Vector<2>> CanvasScene::takenPoints() const {
    if (!m_cage) return {};
    if (m_taken == Taken::Cage) return m_cage->current;
    if (m_taken == Taken::Branch) return m_branchHandles ? childCorners(0) : std::vector<ifs::Vector<2>>();
    std::vector<ifs::Vector<2>> points;
    for (const std::size_t place : selectedPlaces())
        for (const ifs::Vector<2>& corner : m_handles->corners(place))
            points.push_back(corner);
    return points;
}

void CanvasScene::setTaken(Taken taken) {
    if (taken == m_taken) return;
    m_taken = taken;
    m_pivot.reset();
    m_hovered = {};
    setFocused({});
    setSelectedVertices({});
    m_cageItem->setQuiet(taken != Taken::Cage);
    raiseTaken();
    takeBranch();
    place();
}

// Handles that can be taken lie over outlines that only show something.
void CanvasScene::raiseTaken() {
    m_cageItem->setZValue(m_mapFrames->zValue() + (m_taken == Taken::Cage ? 0.5 : -0.5));
}

void CanvasScene::setSelectedMaps(const std::vector<ifs::MapId>& maps) {
    if (maps.empty() && m_selectedMaps.empty()) return;
    std::vector<ifs::MapId> selected = maps;
    std::ranges::sort(selected);
    std::vector<std::size_t> places;
    for (std::size_t place = 0; place < std::size_t(mapCount()); ++place)
        if (std::ranges::binary_search(selected, m_handles->maps()[place].id)) places.push_back(place);
    setSelectedPlaces(places);
}

void CanvasScene::setSelectedPlaces(const std::vector<std::size_t>& places) {
    std::vector<bool> isWanted(std::size_t(mapCount()), false);
    for (const std::size_t place : places)
        if (place < isWanted.size()) isWanted[place] = true;
    std::vector<ifs::MapId> selected;
    for (std::size_t place = 0; place < isWanted.size(); ++place)
        if (isWanted[place]) selected.push_back(m_handles->maps()[place].id);
    if (selected == m_selectedMaps) return;
    m_selectedMaps = std::move(selected);
    if (m_taken == Taken::Maps) m_pivot.reset();
    place();
    emit selectedMapsChanged();
}

std::vector<std::size_t> CanvasScene::selectedPlaces() const {
    std::vector<std::size_t> places;
    auto next = m_selectedMaps.begin(); // they are in the order of the places
    for (std::size_t place = 0; place < std::size_t(mapCount()) && next != m_selectedMaps.end(); ++place)
        if (m_handles->maps()[place].id == *next) {
            places.push_back(place);
            ++next;
        }
    return places;
}

bool CanvasScene::isSelected(int place) const {
    return place >= 0 && place < mapCount() &&
           std::ranges::find(m_selectedMaps, m_handles->maps()[std::size_t(place)].id) !=
               m_selectedMaps.end();
}

int CanvasScene::frameCount() const {
    return int(m_mapFrames->frames().size());
}

const MapFrame* CanvasScene::frameOf(int place) const {
    const std::vector<MapFrame>& frames = m_mapFrames->frames();
    const auto frame = std::ranges::lower_bound(frames, place, {}, &MapFrame::place);
    return frame != frames.end() && frame->place == place ? &*frame : nullptr;
}

std::vector<std::size_t> CanvasScene::placesWithin(const QRectF& band) const {
    std::vector<std::size_t> places;
    if (!m_handles) return places;
    std::vector<document::Box> boxes; // of those without frames
    if (frameCount() < mapCount()) boxes = m_handles->boxes();
    for (std::size_t place = 0; place < m_handles->count(); ++place) {
        const MapFrame* frame = frameOf(int(place));
        if (frame ? band.contains(frame->outline.boundingRect())
                  : band.contains(inPixels(boxes[place]).center()) &&
                        band.contains(inPixels(m_handles->outline(place)).boundingRect()))
            places.push_back(place);
    }
    return places;
}

void CanvasScene::setSelectedVertices(std::vector<std::size_t> vertices) {
    std::ranges::sort(vertices);
    m_selectedVertices = std::move(vertices);
    m_cageItem->setSelected(m_selectedVertices);
}

void CanvasScene::mark() {
    m_cageItem->setMarks(m_hovered, m_pressed, m_focused);
    m_mapFrames->setMarks(m_hovered, m_pressed, m_focused);
    m_gizmo->setMarks(m_hovered, m_pressed, m_focused);
}

void CanvasScene::showOutlines(std::vector<document::OutlineShape> shapes) {
    m_analysisItem->setShapes(std::move(shapes));
}

void CanvasScene::showTrail(const std::vector<ifs::Vector<2>>& points) {
    m_trail = points;
    place();
}

void CanvasScene::restyle() {
    const OverlayStyle style = overlayStyle(m_document->fractal().appearance.background, m_palette);
    m_attractor->setStyle(style);
    for (OverlayItem* item : overlays())
        item->setStyle(style);
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
    for (OverlayItem* item : overlays())
        item->setVisible(m_overlaysVisible);
    const bool cage = m_overlaysVisible && m_cageVisible && m_cage;
    m_cageItem->setVisible(cage);
    m_mapFrames->setVisible(cage);
    m_gizmo->setVisible(cage && anythingTaken());
}

} // namespace view
