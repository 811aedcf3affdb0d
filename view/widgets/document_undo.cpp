// SPDX-License-Identifier: MIT
#include "widgets/document_undo.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace view {

namespace {

// Watches one field; belongs to it.
class UndoKeys : public QObject {
public:
    explicit UndoKeys(QAbstractSpinBox* field) : QObject(field), m_line(field->findChild<QLineEdit*>()) {
        field->installEventFilter(this);
        connect(m_line, &QLineEdit::textEdited, this, [this] { m_isTyped = true; });
        connect(field, &QAbstractSpinBox::editingFinished, this, [this] { m_isTyped = false; });
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride) return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool undo = key->matches(QKeySequence::Undo);
        if (!undo && !key->matches(QKeySequence::Redo)) return false;
        if (m_isTyped && (undo ? m_line->isUndoAvailable() : m_line->isRedoAvailable())) return false;
        event->ignore();
        return true;
    }

private:
    QLineEdit* m_line;
    bool m_isTyped = false;
};

} // namespace

void leaveUndoToDocument(QAbstractSpinBox* field) {
    new UndoKeys(field);
}

} // namespace view
