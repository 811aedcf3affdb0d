// SPDX-License-Identifier: MIT
#pragma once

#include <QMessageBox>

// Asks whether to save what would be lost: Save, which is the default, Discard or Cancel. `what` is a
// sentence, and so is `besides`, of what cannot be saved.
QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what,
                                      const QString& besides = {});
