// SPDX-License-Identifier: MIT
#pragma once

#include <QCursor>
#include <QGuiApplication>
#include <QMouseEvent>

namespace view {

// A QTextEdit or QPlainTextEdit whose text may be dragged. When a drag ends outside, Qt (6.4) goes on to
// scroll as if the button were held, and begins one drag after the other: nobody told it of the release.
template <class TextEdit> class HeldText : public TextEdit {
public:
    using TextEdit::TextEdit;

protected:
    void timerEvent(QTimerEvent* event) override {
        if (QGuiApplication::mouseButtons() == Qt::NoButton) release();
        TextEdit::timerEvent(event);
    }

private:
    void release() {
        const QPoint place = this->viewport()->mapFromGlobal(QCursor::pos());
        QMouseEvent event(QEvent::MouseButtonRelease, place, QCursor::pos(), Qt::LeftButton, Qt::NoButton,
                          Qt::NoModifier);
        this->mouseReleaseEvent(&event);
    }
};

} // namespace view
