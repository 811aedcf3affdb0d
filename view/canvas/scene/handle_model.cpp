// SPDX-License-Identifier: MIT
#include "canvas/scene/handle_model.h"
#include "document/fractal/fractal_geometry.h"
#include "document/maps/branch_handles.h"
#include "io/file/background.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace view {

namespace {

constexpr std::chrono::milliseconds patience{12};

} // namespace

using Kind = CanvasPart::Kind;

HandleModel::HandleModel(const document::Document& document, const CanvasSelection& selection)
    : m_document(document), m_selection(selection) {
    connect(&selection, &CanvasSelection::mapsChanged, this, [this] {
        if (m_target == HandleTarget::Maps) m_pivot.reset();
    });
    connect(&m_finding, &QFutureWatcherBase::finished, this, [this] {
        const bool isFound = !m_addresses && m_finding.future().resultCount() > 0;
        if (isFound && knownAddresses()) emit addressesFound();
    });
}

void HandleModel::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & (Change::Current | Change::File)) {
        m_pivot.reset();
        m_branch.clear();
    }
    if (!(change.parts & (Change::System | Change::Cage | Change::Current | Change::File))) return;
    const document::Fractal& fractal = m_document.fractal();
    m_cage = document::system2(fractal) ? std::optional(document::effectiveCage(fractal)) : std::nullopt;
    m_maps.reset();
    m_isBranchMapKnown = false;
    m_addresses.reset();
    m_finding.setFuture({});
}

const document::MapHandles* HandleModel::maps() const {
    if (!m_maps && m_cage) m_maps.emplace(m_document.sharedFractal(), *m_cage);
    return m_maps ? &*m_maps : nullptr;
}

const document::MapHandles* HandleModel::branchMap() const {
    if (!m_isBranchMapKnown) {
        m_isBranchMapKnown = true;
        m_branchMap.reset();
        auto shown = m_cage ? document::branchHandles(m_document.sharedFractal(), *m_cage, m_branch,
                                                      document::BranchEdit::Display)
                            : std::nullopt;
        if (shown) m_branchMap.emplace(std::move(shown->handles));
    }
    return m_branchMap ? &*m_branchMap : nullptr;
}

void HandleModel::setTarget(HandleTarget target) {
    if (target == m_target) return;
    m_target = target;
    m_pivot.reset();
    emit targetChanged();
}

void HandleModel::setFaces(document::MapFaces faces) {
    if (faces == m_faces) return;
    m_faces = std::move(faces);
    emit changed();
}

attractor::Rgba HandleModel::colourOf(std::size_t map) const {
    if (map < m_faces.size()) return m_faces[map].colour;
    const document::Fractal& fractal = m_document.fractal();
    return attractor::mapColour(fractal.appearance, document::system2(fractal)->maps[map].id, map);
}

void HandleModel::setBranch(const ifs::Word& branch) {
    if (branch == m_branch) return;
    m_branch = branch;
    m_isBranchMapKnown = false;
    if (m_target == HandleTarget::Branch && m_selection.pressed().kind == Kind::None) m_pivot.reset();
    emit changed();
}

void HandleModel::findAddresses() const {
    const auto fractal = m_document.currentEntry().fractal;
    const document::System2* system = document::system2(*fractal);
    if (!system || system->maps.size() < manyMaps)
        m_addresses = std::make_shared<const document::Addresses>(*fractal);
    else if (!m_finding.future().isValid() || m_finding.isCanceled())
        m_finding.setFuture(
            io::inBackground<AddressesPointer>([fractal](QPromise<AddressesPointer>& promise) {
                promise.addResult(std::make_shared<const document::Addresses>(*fractal));
            }));
}

const document::Addresses* HandleModel::knownAddresses() const {
    if (!m_addresses) findAddresses();
    if (!m_addresses && io::finishesWithin(patience, m_finding.future()) &&
        m_finding.future().resultCount() > 0)
        m_addresses = m_finding.result();
    return m_addresses.get();
}

ifs::Word HandleModel::addressAt(const ifs::Vector<2>& point, double precision) const {
    return m_cage ? addresses().at(point, precision) : ifs::Word();
}

const document::Addresses& HandleModel::addresses() const {
    if (!knownAddresses()) m_addresses = m_finding.result(); // blocks until found
    return *m_addresses;
}

int HandleModel::childCount() const {
    if (!m_cage || m_target == HandleTarget::Cage) return 0;
    if (m_target == HandleTarget::Maps) return m_selection.mapCount();
    return branchMap() ? 1 : 0;
}

std::vector<ifs::Vector<2>> HandleModel::corners(int child) const {
    return m_target == HandleTarget::Branch ? branchMap()->corners(0) : maps()->corners(std::size_t(child));
}

std::vector<ifs::Vector<2>> HandleModel::heldPoints() const {
    if (!m_cage) return {};
    if (m_target == HandleTarget::Cage) return m_cage->current;
    if (m_target == HandleTarget::Branch) return branchMap() ? corners(0) : std::vector<ifs::Vector<2>>();
    std::vector<ifs::Vector<2>> points;
    for (const std::size_t index : m_selection.mapIndices())
        for (const ifs::Vector<2>& corner : maps()->corners(index))
            points.push_back(corner);
    return points;
}

bool HandleModel::isAnythingHeld() const {
    if (m_target == HandleTarget::Maps)
        return m_cage && !std::ranges::all_of(m_selection.maps(), [&](ifs::MapId map) {
                   return m_document.fractal().mapLabels.of(map).isLocked;
               });
    return m_target == HandleTarget::Cage || branchMap() != nullptr;
}

ifs::Vector<2> HandleModel::pivot() const {
    if (m_pivot) return *m_pivot;
    const std::vector<ifs::Vector<2>> points = heldPoints();
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const ifs::Vector<2>& point : points)
        sum += point;
    return points.empty() ? sum : ifs::Vector<2>(sum / double(points.size()));
}

void HandleModel::setPivot(const std::optional<ifs::Vector<2>>& pivot) {
    m_pivot = pivot;
    emit changed();
}

bool HandleModel::exists(const CanvasPart& part) const {
    if (part.kind == Kind::None) return true;
    const bool hasIndex = part.kind == Kind::Vertex || part.kind == Kind::Edge;
    return m_cage && part.map < childCount() && (!hasIndex || part.index < int(vertexCount()));
}

std::vector<CanvasPart> HandleModel::parts() const {
    std::vector<CanvasPart> parts;
    if (!m_cage) return parts;
    const int corners = int(vertexCount());
    for (int child = 0; child < childCount(); ++child) {
        parts.push_back({Kind::Inside, 0, child});
        for (int i = 0; i < corners; ++i)
            parts.push_back({Kind::Vertex, i, child});
    }
    for (int i = 0; m_target == HandleTarget::Cage && i < corners; ++i)
        parts.push_back({Kind::Vertex, i});
    if (m_target == HandleTarget::Cage) parts.push_back({Kind::Inside, 0});
    for (const Kind kind : {Kind::Pivot, Kind::Rotate, Kind::Scale})
        parts.push_back({kind, 0});
    return parts;
}

std::vector<ifs::Vector<2>> HandleModel::stillPoints(const CanvasPart& part,
                                                     const std::vector<int>& moving) const {
    std::vector<ifs::Vector<2>> still;
    if (!m_cage) return still;
    const auto add = [&](const std::vector<ifs::Vector<2>>& points, bool anyMoves) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!anyMoves || std::ranges::find(moving, int(i)) == moving.end()) still.push_back(points[i]);
    };
    if (m_target == HandleTarget::Cage) still = m_cage->rest;
    add(m_cage->current, m_target == HandleTarget::Cage);
    std::vector<bool> isHeld(std::size_t(childCount()), m_target == HandleTarget::Branch);
    if (m_target == HandleTarget::Maps)
        for (const std::size_t index : m_selection.mapIndices())
            isHeld[index] = true;
    for (int child = 0; child < childCount(); ++child) {
        const bool whole = part.kind != Kind::Vertex && !moving.empty() && isHeld[std::size_t(child)];
        if (!whole) add(corners(child), child == part.map);
    }
    return still;
}

} // namespace view
