// SPDX-License-Identifier: MIT
#include "dialogs/save_file_dialog.h"

#include <QFileDialog>
#include <QFileInfo>

namespace view {

QString chooseFileToSave(QWidget* parent, const QString& title, const QString& suggestion,
                         const QString& filter, const QString& suffix) {
    const QFileInfo suggested(suggestion);
    QFileDialog dialog(parent, title, suggested.path(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(suggested.fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace view
