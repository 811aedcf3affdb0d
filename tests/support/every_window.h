// SPDX-License-Identifier: MIT
#pragma once

#include "main_window.h"

#include <QList>
#include <QPointer>
#include <QWidget>

namespace support {

// A window with the maple, or with the file at `path`, and every dialog that its menus open (except system
// dialogs: files, the printer). For tests that check all of them.
class EveryWindow {
public:
    explicit EveryWindow(const QString& path = {});
    ~EveryWindow();

    MainWindow& main() const { return *m_main; }
    const QList<QPointer<QWidget>>& dialogs() const { return m_dialogs; }
    QList<QWidget*> all() const; // the main window first

    // What a user can use in it: buttons, fields, lists and whatever takes the focus, without the inner parts
    // of Qt's own widgets.
    static QList<QWidget*> controls(const QWidget* window);
    static QString describe(const QWidget* widget); // for messages: where it is

private:
    MainWindow* m_main;
    QList<QPointer<QWidget>> m_dialogs;
};

} // namespace support
