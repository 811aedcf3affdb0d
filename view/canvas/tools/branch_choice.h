// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/maps/map_handles.h"
#include "gestures/pointer.h"
#include "ifs/system/branch.h"

#include <QObject>

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

namespace view {

// The branch that a click has chosen, in the plane or in space: the address of a point to a depth; and what a
// drag of it changes. Another system has other branches; undo and redo lead back to that of the drag.
class BranchChoice : public QObject {
    Q_OBJECT

public:
    static constexpr int maxDepth = 12;

    explicit BranchChoice(document::Document& document);

    int depth() const { return m_depth; } // address length of the branch
    void setDepth(int depth);
    void turnDepth(int angle);                           // wheel angle in eighths of a degree
    bool pressDepthKey(int key);                         // Page Down and Page Up; false for other keys
    document::BranchEdit edit() const { return m_edit; } // kind of later drags
    void setEdit(document::BranchEdit edit);
    // The whole address of the point that was clicked, of which the branch is the beginning.
    const ifs::Word& address() const { return m_address; }
    ifs::Word branch() const; // indices in the system; empty: none
    void choose(const ifs::Word& address);
    // "Branch 3 2", for the status bar; empty without one.
    QString text() const;
    QString prompt() const; // effect of a click while nothing is chosen; else empty
    QString stepText(DragMode mode,
                     // Text for a drag of the branch or of one of its corners.
                     std::optional<std::size_t> corner) const;
    // Why it cannot be dragged, as a sentence: the map that would change, or be divided, is locked, or a map
    // that would be divided has keys. Empty: it can.
    QString obstacle() const;

    // Makes the branch follow the drag alone until it ends, whatever becomes of the document. A repeated call
    // returns to the branch of the first.
    void beginDrag();
    void showDragged(bool hasMoved); // called for each preview
    QString endDrag();               // message if the branch has become map 1; else empty
    void cancelDrag();
    // State before the drag; null: no drag.
    const std::shared_ptr<const document::Fractal>& before() const { return m_before; }

signals:
    void changed(); // sent for depth, address or edit
    // Sent after changed(), if the user should be told: for the depth, or changes by the document.
    void announced();

private:
    void follow(const document::Change& change);

    document::Document& m_document;
    int m_depth = 2;
    int m_turned = 0; // part of a notch, in eighths of a degree
    document::BranchEdit m_edit = document::BranchEdit::OwnMap;
    ifs::Word m_address;
    ifs::Word m_addressAtPress;
    std::shared_ptr<const document::Fractal> m_before;
    // Choices before and after the latest drags, for undo and redo.
    struct Chosen {
        std::weak_ptr<const document::Fractal> fractal;
        ifs::Word address;
    };
    std::deque<Chosen> m_chosen;
};

} // namespace view
