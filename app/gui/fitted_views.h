// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "space/space_navigation.h"

#include <variant>
#include <vector>

namespace view {
class CanvasNavigation;
}

// A view that is fitted may move with an edit, such as the choice of a symmetry, or be fitted again after it:
// undo takes it back to where it was before the edit, and redo does it again. One that the user has moved
// stays.
class FittedViews : public QObject {
public:
    FittedViews(document::Document* document, view::CanvasNavigation& plane, view::SpaceNavigation& space,
                QObject* parent);

private:
    struct Fitted {
        document::EntryId entry;
        std::variant<attractor::Camera, attractor::OrbitCamera> camera;
    };
    // A place in the history, and what was seen when it was left.
    struct Place {
        const QUndoCommand* step = nullptr; // that leads there
        std::optional<Fitted> view;         // nullopt: it was not fitted
    };

    void follow(int index);
    std::optional<Fitted> now() const;
    void restore(const Fitted& before);

    document::Document* m_document;
    view::CanvasNavigation& m_plane;
    view::SpaceNavigation& m_space;
    std::vector<Place> m_places{1};
    int m_index = 0;
};
