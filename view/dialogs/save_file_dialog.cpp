// SPDX-License-Identifier: MIT
#include "dialogs/save_file_dialog.h"

#include "settings.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace view {

namespace {

QString documents() {
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

} // namespace

QString chooseFileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                         const QString& filter, const QString& suffix) {
    const QString lastFolder = QStringLiteral("dialogs/folder");
    const QFileInfo suggested(QDir(stored(lastFolder, documents()).toString()), suggestion);
    QFileDialog dialog(parent, title, suggested.path(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(suggested.fileName());
    if (dialog.exec() != QDialog::Accepted) return {};
    QString chosen = dialog.selectedFiles().value(0);
    store(lastFolder, QFileInfo(chosen).absolutePath());
    return chosen;
}

} // namespace view
