// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class FileCommands;
class OpenFile;
namespace view {
class ExportShell;
}

// The entry for other programs and people: as files, and through the clipboard.
class ExportMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    ExportMenu(const MenuContext& context, FileCommands* commands, const OpenFile* file);

    QAction* picture() const { return m_picture; }

private:
    void showWithQueue(view::ExportShell* dialog);
    void offerAnimation(view::ExportShell* dialog);
    void exportPicture();
    void exportAnimation();
    void exportData();
    void copyLink();
    void copyAsPython();
    void copyPicture();

    FileCommands* m_commands;
    const OpenFile* m_file;
    QAction* m_picture = nullptr;
};
