// SPDX-License-Identifier: MIT
#pragma once

#include <QMessageBox>

// Asks whether to save what would be lost: Save, which is the default, Discard or Cancel. `what` is a
// sentence, and `besides` are sentences about what saving does not keep; empty ones are left out.
QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what,
                                      const QStringList& besides = {});
// The same about what cannot be saved: whether to discard it. Cancel is the default.
bool askToDiscard(QWidget* parent, const QString& title, const QString& what, const QString& remark);
