// SPDX-License-Identifier: MIT
#include "session/stored_layout.h"

#include <QByteArray>
#include <QDataStream>
#include <QIODevice>
#include <QMainWindow>
#include <QToolBar>

namespace {

// The name as it is in a stored state.
QByteArray streamed(const QString& name) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << name;
    return bytes;
}

} // namespace

bool restoreStoredLayout(QMainWindow* window, const QByteArray& state) {
    const QString now = QStringLiteral("construction"), before = QStringLiteral("arising");
    auto* bar = window->findChild<QToolBar*>(now);
    if (bar && state.contains(streamed(before))) bar->setObjectName(before);
    const bool isRestored = window->restoreState(state);
    if (bar) bar->setObjectName(now);
    return isRestored;
}
