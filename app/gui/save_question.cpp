// SPDX-License-Identifier: MIT
#include "save_question.h"

#include <QCoreApplication>

QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what,
                                      const QString& remark) {
    QMessageBox box(QMessageBox::Warning, title, what,
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    QString question = QCoreApplication::translate("MainWindow", "Do you want to save them?");
    if (!remark.isEmpty()) question += u' ' + remark;
    box.setInformativeText(question);
    box.setDefaultButton(QMessageBox::Save);
    return QMessageBox::StandardButton(box.exec());
}
