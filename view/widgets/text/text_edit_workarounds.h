// SPDX-License-Identifier: MIT
#pragma once

#include <QCursor>
#include <QGuiApplication>
#include <QMimeData>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QWidget>

#include <algorithm>

namespace view {

// A QTextEdit or QPlainTextEdit without three faults of Qt 6.4. While text is dragged, it scrolls and starts
// another drag. After a drag of text that ends outside, it keeps scrolling and starting new drags, because it
// has not seen the button released. And pasting from an empty clipboard crashes.
template <class TextEdit> class TextEditWithWorkarounds : public TextEdit {
public:
    using TextEdit::TextEdit;

protected:
    void mouseMoveEvent(QMouseEvent* event) override { // blocks until a drag that it starts has ended
        const QScopedValueRollback<bool> moving(m_isMoving, true);
        TextEdit::mouseMoveEvent(event);
    }
    void timerEvent(QTimerEvent* event) override {
        if (m_isMoving) return;
        const QScopedValueRollback<bool> moving(m_isMoving, true);
        if (QGuiApplication::mouseButtons() == Qt::NoButton) release();
        TextEdit::timerEvent(event);
    }
    void insertFromMimeData(const QMimeData* source) override {
        if (!source->formats().isEmpty()) TextEdit::insertFromMimeData(source);
    }

private:
    // Reports the release outside the visible text, where it follows no link and scrolls nowhere.
    void release() {
        const QWidget* seen = this->viewport();
        const QPoint beside(seen->width(), std::clamp(seen->mapFromGlobal(QCursor::pos()).y(), 0,
                                                      std::max(0, seen->height() - 1)));
        QMouseEvent event(QEvent::MouseButtonRelease, beside, seen->mapToGlobal(beside), Qt::LeftButton,
                          Qt::NoButton, Qt::NoModifier);
        this->mouseReleaseEvent(&event);
    }

    bool m_isMoving = false;
};

} // namespace view
