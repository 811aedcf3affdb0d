// SPDX-License-Identifier: MIT
#include "space/space_branch.h"

#include "document/branches/addresses.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/branch_handles.h"

#include <utility>
#include <vector>

namespace view {

using document::SpaceMapHandles;

void SpaceBranch::setActive(bool active) {
    m_isActive = active;
    if (!active) m_held.setFill({});
}

void SpaceBranch::layOut(const attractor::OrbitCamera& camera, const std::optional<ifs::ControlCage<3>>& cage,
                         const SpaceCageItem::Hidden& isHidden) {
    if (!isActive()) return;
    const document::Fractal& fractal = m_document->fractal();
    const ifs::Word branch = m_choice->branch();
    const auto handles =
        cage ? std::optional(SpaceMapHandles(m_document->sharedFractal(), *cage)) : std::nullopt;
    std::vector<document::SpaceOutline> walk;
    std::vector<ifs::Vector<3>> held;
    for (std::size_t length = 1; handles && length <= branch.size(); ++length) {
        const auto corners = handles->corners({branch.begin(), branch.begin() + std::ptrdiff_t(length)});
        if (!corners) break;
        const auto last = std::size_t(branch[length - 1]);
        const attractor::Rgba face =
            attractor::mapColour(fractal.appearance, document::system3(fractal)->maps[last].id, last);
        walk.push_back(tetrahedron(*corners, face));
        if (length < branch.size()) continue;
        held = handlesOf(*corners);
        constexpr int translucent = 71;
        m_held.setFill(QColor(face.red, face.green, face.blue, translucent));
    }
    m_walk.setShapes(std::move(walk));
    m_walk.layOut(camera);
    m_held.layOut(camera, held, facesOfTetrahedron(), isHidden);
}

QString SpaceBranch::chooseAt(const ifs::Vector<3>& displayed, double precision) {
    const ifs::Word address = document::addressInSpace(m_document->fractal(), displayed, precision);
    if (address.empty()) return tr("No branch can be selected here: the address of this point is not known.");
    m_choice->choose(address);
    return m_choice->text();
}

std::optional<SpaceMapDrag> SpaceBranch::drag(QString& obstacle) {
    const ifs::Word branch = m_choice->branch();
    const auto cage = document::knownSpaceCage(m_document->fractal());
    if (branch.empty() || !cage) return std::nullopt;
    obstacle = m_choice->obstacle();
    if (!obstacle.isEmpty()) return std::nullopt;
    const document::BranchEdit edit = m_choice->edit();
    auto held = document::branchHandles(m_document->sharedFractal(), *cage, branch, edit);
    auto drag = held ? SpaceMapDrag::of(std::move(held->handles), {held->index},
                                        edit == document::BranchEdit::Inside ? branch : ifs::Word())
                     : std::nullopt;
    if (drag)
        m_choice->beginDrag();
    else
        obstacle = tr("A branch cannot be dragged while it or the cage is flat.");
    return drag;
}

bool SpaceBranch::keyPress(const QKeyEvent& event) {
    if (isActive() && event.key() == Qt::Key_Escape && !m_choice->address().empty()) {
        m_choice->choose({});
        return true;
    }
    return isActive() && m_choice->pressDepthKey(event.key());
}

} // namespace view
