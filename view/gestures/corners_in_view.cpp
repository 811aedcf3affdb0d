// SPDX-License-Identifier: MIT
#include "gestures/corners_in_view.h"

#include <QUndoStack>

#include <utility>

namespace view {

void CornersInView::follow(const document::Change& change, QObject* context) {
    using document::Change;
    if (!(change.parts & (Change::Cage | Change::System)) || change.parts & Change::Time) return;
    const bool wasDragged = std::exchange(m_isDragged, change.live && m_view.isHeld());
    if (change.live && !m_isDragged) return; // typed in a field: what counts is the number that stays
    const bool isCommand = !wasDragged && !change.live && !(change.parts & (Change::Current | Change::File));
    const bool leave = std::exchange(m_wereInView, m_view.showsAll()) && !m_wereInView;
    if (!isCommand || !m_view.isShown() || !leave) return;
    // Undo and redo restore their own views; queued, because the history will then know which one.
    const QUndoStack& history = *m_document->undoStack();
    const int index = history.index();
    QMetaObject::invokeMethod(
        context,
        [this, index, redone = history.command(index)] {
            const QUndoStack& now = *m_document->undoStack();
            const bool isNew = now.index() > index && now.command(now.index() - 1) != redone;
            if (isNew && !m_view.showsAll()) m_view.fit();
        },
        Qt::QueuedConnection);
}

} // namespace view
