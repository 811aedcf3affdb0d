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
// stays; one that keys of the camera have moved goes back once undo has taken these away.
class FittedViews : public QObject {
public:
    FittedViews(document::Document* document, view::CanvasNavigation& plane, view::SpaceNavigation& space,
                QObject* parent);

private:
    struct Seen {
        document::EntryId entry;
        std::variant<attractor::Camera, attractor::OrbitCamera> camera;
        bool isFitted = false;
    };
    // A place in the history, and the view when it was left.
    struct Place {
        const QUndoCommand* step = nullptr; // step that leads to this place
        std::optional<Seen> view;
    };

    void follow(int index);
    Seen now() const;
    bool movesPicture(); // the step that was just done or undone: what changes colours alone does not
    void restore(const Seen& before);
    void restoreUnkeyed(const Seen& before);

    document::Document* m_document;
    view::CanvasNavigation& m_plane;
    view::SpaceNavigation& m_space;
    std::vector<Place> m_places{1};
    int m_index = 0;
    bool m_isKeyed = false;            // the view in the plane
    document::Change::Parts m_changed; // since the history was followed last
    bool m_hasShadow = false;
};
