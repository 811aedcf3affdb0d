// SPDX-License-Identifier: MIT
#include "messages/save_question.h"

#include <QCoreApplication>
#include <QPushButton>

#include <utility>

namespace {

QString sentence(const char* text) {
    return QCoreApplication::translate("MainWindow", text);
}

// Names buttons anew, since those of the toolkit have no letters to press.
void nameButtons(QMessageBox& box) {
    constexpr std::pair<QMessageBox::StandardButton, const char*> names[] = {
        {QMessageBox::Save, QT_TRANSLATE_NOOP("MainWindow", "&Save")},
        {QMessageBox::Discard, QT_TRANSLATE_NOOP("MainWindow", "&Discard")},
        {QMessageBox::Cancel, QT_TRANSLATE_NOOP("MainWindow", "&Cancel")}};
    for (const auto& [button, name] : names)
        if (QAbstractButton* found = box.button(button)) found->setText(sentence(name));
}

} // namespace

QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what,
                                      const QStringList& besides) {
    QMessageBox box(QMessageBox::Warning, title, what,
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    QStringList paragraphs{sentence(QT_TRANSLATE_NOOP("MainWindow", "Do you want to save them?"))};
    for (const QString& remark : besides)
        if (!remark.isEmpty()) paragraphs << remark;
    box.setInformativeText(paragraphs.join(QStringLiteral("\n\n")));
    nameButtons(box);
    box.setDefaultButton(QMessageBox::Save);
    return QMessageBox::StandardButton(box.exec());
}

bool askToDiscard(QWidget* parent, const QString& title, const QString& what, const QString& remark) {
    QMessageBox box(QMessageBox::Warning, title, what, QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(remark);
    nameButtons(box);
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Discard;
}
