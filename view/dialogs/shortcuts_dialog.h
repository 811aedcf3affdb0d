// SPDX-License-Identifier: MIT
#pragma once

#include "dialogs/command_palette.h"

#include <QDialog>

namespace view {

// Every shortcut of the window and every gesture of the canvas, in one list to read or search.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ShortcutsDialog(const QList<NamedAction>& actions, QWidget* parent = nullptr);
};

} // namespace view
