// SPDX-License-Identifier: MIT
#include "panels/timeline/space_tap.h"

#include <QAbstractScrollArea>
#include <QKeyEvent>

#include <utility>

namespace view {

SpaceTap::SpaceTap(QAbstractScrollArea* canvas) : QObject(canvas) {
    canvas->installEventFilter(this);
    canvas->viewport()->installEventFilter(this);
}

bool SpaceTap::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease: {
        const auto& key = static_cast<QKeyEvent&>(*event);
        if (key.isAutoRepeat()) break;
        const bool isSpace = key.key() == Qt::Key_Space && key.modifiers() == Qt::NoModifier;
        const bool wasDown = std::exchange(m_isDown, isSpace && event->type() == QEvent::KeyPress);
        if (wasDown && isSpace && event->type() == QEvent::KeyRelease)
            // Queued until after the release.
            QMetaObject::invokeMethod(this, &SpaceTap::tapped, Qt::QueuedConnection);
        break;
    }
    case QEvent::MouseButtonPress:
    case QEvent::FocusOut:
        m_isDown = false;
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace view
