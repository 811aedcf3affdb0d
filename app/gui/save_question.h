// SPDX-License-Identifier: MIT
#pragma once

#include <QMessageBox>

// Asks whether to save what would be lost: Save, which is the default, Discard or Cancel. `what` is a
// sentence, `remark` one about what saving does not keep.
QMessageBox::StandardButton askToSave(QWidget* parent, const QString& title, const QString& what,
                                      const QString& remark = {});
