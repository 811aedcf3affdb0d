// SPDX-License-Identifier: MIT
#include "widgets/document_undo.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace view {

namespace {

// Watches one field; belongs to it.
class UndoKeys : public QObject {
public:
    // `field` receives the keys; `line` has its text.
    UndoKeys(QWidget* field, QLineEdit* line) : QObject(field), m_line(line) {
        field->installEventFilter(this);
        connect(line, &QLineEdit::textEdited, this, [this] { m_isTyped = true; });
    }
    void endTyping() { m_isTyped = false; }

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
    auto* keys = new UndoKeys(field, field->findChild<QLineEdit*>());
    QObject::connect(field, &QAbstractSpinBox::editingFinished, keys, &UndoKeys::endTyping);
}

void leaveUndoToDocument(QComboBox* field) {
    QLineEdit* line = field->lineEdit();
    auto* keys = new UndoKeys(field, line); // passes keys on to the line
    line->installEventFilter(keys);
    QObject::connect(line, &QLineEdit::editingFinished, keys, &UndoKeys::endTyping);
}

} // namespace view
