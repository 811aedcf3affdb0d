// SPDX-License-Identifier: MIT
#include "files/exports.h"

#include "dialogs/export/export_shell.h"
#include "document/text/text.h"
#include "messages/window_messages.h"
#include "session/session.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>

namespace exports {

QString folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/exports");
}

view::ExportQueue* queue() {
    auto* known = qApp->findChild<view::ExportQueue*>(QString(), Qt::FindDirectChildrenOnly);
    if (known) return known;
    auto* made = new view::ExportQueue(folder(), qApp);
    QObject::connect(qApp, &QCoreApplication::aboutToQuit, made, &view::ExportQueue::shutDown);
    return made;
}

void connectPanel(QDockWidget* panel, WindowMessages* messages) {
    panel->hide();
    QObject::connect(queue(), &view::ExportQueue::message, messages, &WindowMessages::say);
    QObject::connect(queue(), &view::ExportQueue::resumed, panel, [panel, messages] {
        const int count = queue()->unfinished();
        if (count == 0) return; // failed exports can wait until the panel is opened
        panel->show();
        panel->raise();
        messages->say(Text::tr("%n exports from the last session are in the queue.", nullptr, count));
    });
}

bool mayEnd(QWidget* window, SessionWindow::Leaving leaving) {
    for (auto* dialog : window->findChildren<view::ExportShell*>())
        if (!dialog->mayClose()) return false;
    const auto others = session::windows();
    const auto stays = [window](const SessionWindow* other) { return other != window && other->isVisible(); };
    const bool isLast = leaving == SessionWindow::Leaving::Program || std::ranges::none_of(others, stays);
    if (queue()->unfinished() == 0 || queue()->isPaused() || !isLast) return true;
    QMessageBox box(QMessageBox::Question, Text::tr("Exports are not finished"), {}, QMessageBox::Cancel,
                    window);
    box.setInformativeText(Text::tr(
        "Barycage closes when they are finished. Closed now, it continues with them at its next start.",
        nullptr, queue()->unfinished()));
    const QPushButton* close = box.addButton(Text::tr("&Close"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    const auto follow = [&box] {
        const int left = queue()->unfinished();
        box.setText(Text::tr("%n exports are still in the queue.", nullptr, left));
        if (left == 0) box.accept(); // no answer needed any more
    };
    QObject::connect(queue(), &view::ExportQueue::exportChanged, &box, follow);
    QObject::connect(queue(), &view::ExportQueue::listChanged, &box, follow);
    follow();
    box.exec();
    return queue()->unfinished() == 0 || box.clickedButton() == close;
}

} // namespace exports
