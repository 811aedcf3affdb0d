// SPDX-License-Identifier: MIT
#include "canvas/tools/branch_tool.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/addresses.h"
#include "document/edits/map_locks.h"
#include "ifs/cage/map_handles.h"

#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace view {

using Kind = CanvasPart::Kind;
using Mode = PolygonDrag::Mode;

namespace {

constexpr std::size_t maxSelected = 200; // a hundred drags

// The sentence of the map that would change, or be divided, if it is locked.
QString lockObstacle(const document::Fractal& fractal, const ifs::Word& branch, document::BranchEdit edit) {
    using document::BranchEdit;
    if (branch.empty() || edit == BranchEdit::Display || edit == BranchEdit::Inside) return {};
    const bool isFirst = edit == document::BranchEdit::OwnMap;
    return document::lockObstacle(fractal,
                                  std::vector{std::size_t(isFirst ? branch.front() : branch.back())});
}

} // namespace

BranchTool::BranchTool(CanvasScene& scene) : MapsTool(scene) {
    connect(&scene.document(), &document::Document::changed, this, &BranchTool::follow);
}

void BranchTool::start() {
    handles().setTarget(HandleTarget::Branch);
    select(m_address);
}

// Another system has other branches; undo and redo lead back to that of the drag.
void BranchTool::follow(const document::Change& change) {
    using document::Change;
    if (!(change.parts & (Change::System | Change::Current | Change::File)) || isBusy()) return;
    const bool isAnother = change.parts & (Change::Current | Change::File);
    if (change.parts & Change::Time && !isAnother) return; // the same maps, elsewhere
    const auto now = scene().document().sharedFractal();
    const auto known = std::ranges::find_if(
        m_selected, [&](const Selected& selected) { return selected.fractal.lock() == now; });
    if (known == m_selected.end() && m_address.empty()) return;
    select(known == m_selected.end() ? ifs::Word() : known->address);
    say();
}

void BranchTool::say() {
    if (handles().target() != HandleTarget::Branch) return;
    emit message(m_address.empty()
                     ? QString()
                     : tr("Branch %1").arg(document::addressText(handles().branch(), maxDepth)));
}

void BranchTool::select(const ifs::Word& address) {
    m_address = address;
    const auto length = std::min<std::size_t>(std::size_t(m_depth), address.size());
    handles().setBranch({address.begin(), address.begin() + std::ptrdiff_t(length)});
    ask();
    emit changed();
}

void BranchTool::ask() {
    if (handles().target() != HandleTarget::Branch || isBusy()) return;
    scene().notes().setPrompt(m_address.empty() ? tr("Click a point of the attractor to select its branch.")
                                                : QString());
}

void BranchTool::stop() {
    MapsTool::stop();
    scene().notes().setPrompt({});
}

void BranchTool::setDepth(int depth) {
    depth = std::clamp(depth, 1, maxDepth);
    if (depth == m_depth) return;
    m_depth = depth;
    if (isBusy()) return;
    select(m_address);
    say();
}

void BranchTool::selectAt(const QPointF& position) {
    const attractor::Camera& camera = scene().camera();
    const ifs::Word address = handles().addressAt(worldAt(camera, position), 1 / camera.pixelsPerUnit);
    if (address.empty()) return;
    selection().setFocused({});
    select(address);
    say();
}

double BranchTool::shareToShow(const std::function<const document::Fractal&(double)>& after) {
    if (m_edit != document::BranchEdit::Inside || allowsNoAttractor()) return MapsTool::shareToShow(after);
    const auto way = ifs::safeWay<2>(
        [&](double share) { return std::vector{document::recurringMap(after(share), handles().branch())}; });
    scene().notes().setPrompt(
        way.share < 1 ? tr("Stopped: beyond this, the branch would not become smaller inside itself.")
                      : QString());
    return way.share;
}

void BranchTool::press(const Pointer& pointer) {
    MapsTool::press(pointer);
    if (!isBusy()) selectAt(pointer.position);
}

void BranchTool::clicked(const CanvasPart& part, const Pointer& pointer) {
    if (part.kind == Kind::Inside) selectAt(pointer.position);
}

// One branch is selected, and only a click or the keys of its depth change which: not as among the maps.
void BranchTool::walk(int step) {
    PolygonTool::walk(step); // NOLINT(bugprone-parent-virtual-call): MapsTool selects what it walks to
}

bool BranchTool::keyPress(const QKeyEvent& event) {
    if (event.key() == Qt::Key_PageDown || event.key() == Qt::Key_PageUp) {
        setDepth(m_depth + (event.key() == Qt::Key_PageDown ? 1 : -1));
        return true;
    }
    return PolygonTool::keyPress(event); // NOLINT(bugprone-parent-virtual-call): MapsTool selects maps
}

MapsTool::HeldMaps BranchTool::hold(const CanvasPart&) {
    const QString locked =
        m_before ? QString() : lockObstacle(scene().document().fractal(), handles().branch(), m_edit);
    if (!locked.isEmpty()) {
        emit message(locked);
        return {};
    }
    if (m_before) {
        select(m_addressAtPress); // begun anew
    } else {
        m_before = scene().document().sharedFractal();
        m_addressAtPress = m_address;
    }
    auto branch = document::branchHandles(m_before, *handles().cage(), handles().branch(), m_edit);
    if (!branch) return {};
    return {std::move(branch->handles), {branch->index}};
}

QString BranchTool::stepText(Mode mode, std::optional<std::size_t> corner) const {
    const QString name = document::addressText(handles().branch(), maxDepth);
    if (corner) return tr("Move corner %1 of branch %2").arg(*corner + 1).arg(name);
    if (mode == Mode::Move) return tr("Move branch %1").arg(name);
    return (mode == Mode::Rotate ? tr("Rotate branch %1") : tr("Scale branch %1")).arg(name);
}

// Once it is a map of its own the branch is the first one.
PolygonTool::Shown BranchTool::preview(const std::function<DragResult(double)>& resultAt) {
    Shown shown = MapsTool::preview(resultAt);
    const bool converted = m_edit == document::BranchEdit::OwnMap &&
                           std::min<std::size_t>(m_addressAtPress.size(), std::size_t(m_depth)) > 1 &&
                           shown.result.points != drag().points;
    select(converted ? ifs::Word{0} : m_addressAtPress);
    return shown;
}

void BranchTool::ended() {
    MapsTool::ended();
    const bool isUndone = m_before && scene().document().fractal() == *m_before;
    if (isUndone) select(m_addressAtPress);
    if (m_before && !isUndone && m_address != m_addressAtPress) { // the table shows the map that it is now
        selection().setMapIndices({0});
        emit message(tr("This branch is now map 1. You can change it further in the table."));
    }
    if (m_before && !isUndone) {
        m_selected.push_front({scene().document().sharedFractal(), m_address});
        m_selected.push_front({m_before, m_addressAtPress});
        if (m_selected.size() > maxSelected) m_selected.resize(maxSelected);
    }
    m_before.reset();
    ask();
}

} // namespace view
