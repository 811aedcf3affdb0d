// SPDX-License-Identifier: MIT
#include "canvas/tools/branch_tool.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/maps/branch_handles.h"
#include "ifs/cage/map_handles.h"

#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace view {

using Kind = CanvasPart::Kind;

BranchTool::BranchTool(CanvasScene& scene) : MapsTool(scene), m_choice(scene.document()) {
    connect(&m_choice, &BranchChoice::changed, this, &BranchTool::showChoice);
    connect(&m_choice, &BranchChoice::announced, this, &BranchTool::say);
}

void BranchTool::start() {
    handles().setTarget(HandleTarget::Branch);
    showChoice();
}

void BranchTool::say() {
    if (handles().target() == HandleTarget::Branch && !isBusy()) emit message(m_choice.text());
}

void BranchTool::showChoice() {
    handles().setBranch(m_choice.branch());
    ask();
}

void BranchTool::ask() {
    if (handles().target() != HandleTarget::Branch || isBusy()) return;
    scene().notes().setPrompt(m_choice.prompt());
}

void BranchTool::stop() {
    MapsTool::stop();
    scene().notes().setPrompt({});
}

bool BranchTool::selectAt(const QPointF& position) {
    const attractor::Camera& camera = scene().camera();
    const ifs::Word address = handles().addressAt(worldAt(camera, position), 1 / camera.pixelsPerUnit);
    if (address.empty()) return false;
    selection().setFocused({});
    m_choice.choose(address);
    say();
    return true;
}

double BranchTool::shareToShow(const std::function<const document::Fractal&(double)>& after) {
    if (m_choice.edit() != document::BranchEdit::Inside || allowsNoAttractor())
        return MapsTool::shareToShow(after);
    const auto way = ifs::safeWay<2>(
        [&](double share) { return std::vector{document::recurringMap(after(share), handles().branch())}; });
    scene().notes().setPrompt(
        way.share < 1 ? tr("Stopped: beyond this, the branch would not become smaller inside itself.")
                      : QString());
    return way.share;
}

void BranchTool::press(const Pointer& pointer) {
    MapsTool::press(pointer);
    if (!isBusy() && !selectAt(pointer.position)) m_choice.choose({});
}

void BranchTool::clicked(const CanvasPart& part, const Pointer& pointer) {
    if (part.kind == Kind::Inside) selectAt(pointer.position);
}

// Unlike among maps, only a click or the keys of the depth change which branch is selected.
bool BranchTool::walk(int step) {
    return PolygonTool::walk(step); // NOLINT(bugprone-parent-virtual-call): MapsTool selects what it walks to
}

bool BranchTool::keyPress(const QKeyEvent& event) {
    if (m_choice.pressDepthKey(event.key())) return true;
    const bool isCornerFocused = selection().focused().kind != Kind::None;
    if (isBareKey(event, Qt::Key_Escape) && !isCornerFocused && !m_choice.address().empty()) {
        m_choice.choose({});
        return true;
    }
    return PolygonTool::keyPress(event); // NOLINT(bugprone-parent-virtual-call): MapsTool selects maps
}

MapsTool::HeldMaps BranchTool::hold(const CanvasPart&) {
    const QString obstacle = m_choice.before() ? QString() : m_choice.obstacle();
    if (!obstacle.isEmpty()) {
        emit message(obstacle);
        return {};
    }
    m_choice.beginDrag();
    auto branch =
        document::branchHandles(m_choice.before(), *handles().cage(), m_choice.branch(), m_choice.edit());
    if (!branch) return {};
    return {std::move(branch->handles), {branch->index}};
}

PolygonTool::Shown BranchTool::preview(const std::function<DragResult(double)>& resultAt) {
    Shown shown = MapsTool::preview(resultAt);
    m_choice.showDragged(shown.result.points != drag().points);
    return shown;
}

void BranchTool::abandoned() {
    m_choice.cancelDrag();
}

void BranchTool::ended() {
    MapsTool::ended();
    if (const QString said = m_choice.endDrag(); !said.isEmpty()) { // the table shows the new map
        selection().setMapIndices({0});
        emit message(said);
    }
    ask();
}

} // namespace view
