// SPDX-License-Identifier: MIT
#pragma once

#include <QCursor>
#include <QGuiApplication>
#include <QMimeData>
#include <QMouseEvent>
#include <QWidget>

#include <algorithm>

namespace view {

// A QTextEdit or QPlainTextEdit without two faults of Qt 6.4. When text is dragged and the drag ends outside,
// it goes on to scroll as if the button were held, and begins one drag after the other: nobody told it of the
// release. And to paste an empty clipboard is the end of the program.
template <class TextEdit> class MendedText : public TextEdit {
public:
    using TextEdit::TextEdit;

protected:
    void timerEvent(QTimerEvent* event) override {
        if (QGuiApplication::mouseButtons() == Qt::NoButton) release();
        TextEdit::timerEvent(event);
    }
    void insertFromMimeData(const QMimeData* source) override {
        if (!source->formats().isEmpty()) TextEdit::insertFromMimeData(source);
    }

private:
    // Beside what is seen of the text: no link is followed and nothing scrolled to.
    void release() {
        const QWidget* seen = this->viewport();
        const QPoint beside(seen->width(), std::clamp(seen->mapFromGlobal(QCursor::pos()).y(), 0,
                                                      std::max(0, seen->height() - 1)));
        QMouseEvent event(QEvent::MouseButtonRelease, beside, seen->mapToGlobal(beside), Qt::LeftButton,
                          Qt::NoButton, Qt::NoModifier);
        this->mouseReleaseEvent(&event);
    }
};

} // namespace view
