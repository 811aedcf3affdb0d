// SPDX-License-Identifier: MIT
#include "save_question.h"

#include <QCoreApplication>
#include <QPushButton>

QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what,
                                      const QStringList& besides) {
    const auto sentence = [](const char* text) { return QCoreApplication::translate("MainWindow", text); };
    QMessageBox box(QMessageBox::Warning, title, what,
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    QStringList paragraphs{sentence(QT_TRANSLATE_NOOP("MainWindow", "Do you want to save them?"))};
    for (const QString& remark : besides)
        if (!remark.isEmpty()) paragraphs << remark;
    box.setInformativeText(paragraphs.join(QStringLiteral("\n\n")));
    // Those of the toolkit have no letters to press.
    box.button(QMessageBox::Save)->setText(sentence(QT_TRANSLATE_NOOP("MainWindow", "&Save")));
    box.button(QMessageBox::Discard)->setText(sentence(QT_TRANSLATE_NOOP("MainWindow", "&Discard")));
    box.button(QMessageBox::Cancel)->setText(sentence(QT_TRANSLATE_NOOP("MainWindow", "&Cancel")));
    box.setDefaultButton(QMessageBox::Save);
    return QMessageBox::StandardButton(box.exec());
}
