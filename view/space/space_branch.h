// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/tools/branch_choice.h"
#include "space/space_maps.h"
#include "space/spatial_drag.h"

#include <QKeyEvent>
#include <QPointer>

#include <optional>

namespace view {

// The branch of the current entry in space that is chosen: the images of the tetrahedron under w₁, w₁w₂ and
// so on, one inside the other. The last one is filled and held, like a map.
class SpaceBranch {
    Q_DECLARE_TR_FUNCTIONS(SpaceBranch)

public:
    SpaceBranch(const document::Document* document, SpaceOutlinesItem& walk, SpaceCageItem& held)
        : m_document(document), m_walk(walk), m_held(held) {}

    // Without a choice, no branch can be chosen.
    void setChoice(BranchChoice* choice) { m_choice = choice; }
    BranchChoice* choice() const { return m_choice; }

    bool isActive() const { return m_isActive && m_choice; }
    void setActive(bool active);
    QString prompt() const { return isActive() ? m_choice->prompt() : QString(); }

    // Lays out while it is active; call it after the maps, which use the same items.
    void layOut(const attractor::OrbitCamera& camera, const std::optional<ifs::ControlCage<3>>& cage,
                const SpaceCageItem::Hidden& isHidden);

    // Chooses the branch of a point of the attractor, known to within `precision`. What is to be said of it.
    QString chooseAt(const ifs::Vector<3>& displayed, double precision);
    // A drag of the branch, which has begun then; nullopt where there can be none, and why.
    std::optional<SpaceMapDrag> drag(QString& obstacle);
    QString stepText(DragMode mode, std::optional<std::size_t> corner) const {
        return m_choice->stepText(mode, corner);
    }

    // Page Down and Page Up change its depth, Esc lets it go; false: no key of ours.
    bool keyPress(const QKeyEvent& event);

private:
    const document::Document* m_document;
    SpaceOutlinesItem& m_walk;
    SpaceCageItem& m_held;
    QPointer<BranchChoice> m_choice;
    bool m_isActive = false;
};

} // namespace view
