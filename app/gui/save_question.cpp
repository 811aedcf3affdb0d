// SPDX-License-Identifier: MIT
#include "save_question.h"

#include <QCoreApplication>

QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what) {
    QMessageBox box(QMessageBox::Warning, title, what,
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(QCoreApplication::translate("MainWindow", "Do you want to save them?"));
    box.setDefaultButton(QMessageBox::Save);
    return QMessageBox::StandardButton(box.exec());
}
