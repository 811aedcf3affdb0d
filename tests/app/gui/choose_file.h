// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QTimer>

namespace support {

// Chooses a file in the dialog that will ask for one, as long as the timer lives.
inline void chooseFile(QTimer& answering, const QString& path) {
    QObject::connect(&answering, &QTimer::timeout, &answering, [path] {
        QWidget* shown = QApplication::activeModalWidget();
        auto* files = qobject_cast<QFileDialog*>(shown);
        auto* complaint = qobject_cast<QMessageBox*>(shown); // of a folder that is not read yet
        if (complaint && qobject_cast<QFileDialog*>(complaint->parentWidget())) return complaint->reject();
        if (!files) return;
        // Once more until it has been taken.
        files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
        // Not at once: while the complaint that may follow is shown, this timer is to go on.
        QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
    });
    answering.start(50);
}

} // namespace support
