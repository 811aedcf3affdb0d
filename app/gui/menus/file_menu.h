// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"

class FileCommands;
class OpenFile;

class FileMenu : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    FileMenu(const MenuContext& context, FileCommands* commands, const OpenFile* file,
             const std::function<void()>& openWindow);

private:
    void addOpening(const std::function<void()>& openWindow);
    void addSaving();
    void fillRecent();
    void printPicture();

    FileCommands* m_commands;
    const OpenFile* m_file;
    QMenu* m_recent = nullptr;
    QAction* m_open = nullptr;
    QAction* m_save = nullptr;
};
