// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/command_palette.h"

#include <QDialog>

namespace view {

// The shortcuts of the window and the gestures of the canvas, in one list to read or search.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ShortcutsDialog(const QList<NamedAction>& actions, QWidget* parent = nullptr);
};

} // namespace view
