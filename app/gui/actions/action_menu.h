// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_view.h"
#include "document/document.h"
#include "messages/window_messages.h"

#include <QCoreApplication>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>

#include <functional>

class Panels;
class Stage;

// Texts of an action, and the keys that trigger it.
struct ActionSpec {
    const char* id; // unique and never changed: the users' own shortcuts are stored under it
    QString text;
    QKeySequence shortcut;
    QString tip;                   // for the status bar and the tool tip
    const char* setting = nullptr; // where a toggle is stored between runs; nullptr: nowhere
    bool initially = false;        // the state of a toggle that was never stored
    const char* icon = nullptr;    // its name in the resources; nullptr: that of the id, if there is one
};

// Objects that the menus of a window act on.
struct MenuContext {
    QMainWindow* window;
    document::Document* document;
    view::CanvasView* canvas;
    WindowMessages* messages;
    Stage* stage; // shows the canvas, or the window into space
    const Panels* panels;
};

// A menu that builds its actions from specs. They belong to the window, too, so that their shortcuts work
// while the menu bar is hidden. The menus of the main window share its translations.
class ActionMenu : public QMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    ActionMenu(const MenuContext& context, const QString& title);

    // The action's object name is the id.
    QAction* add(const ActionSpec& spec, const std::function<void()>& operation);
    // Calls `set` when the user switches it and, if the toggle has a setting, at once with the stored state.
    QAction* addToggle(const ActionSpec& spec, const std::function<void(bool)>& set);
    void addShared(QAction* action); // made elsewhere, with the id as its object name

    // The tool bar shows these actions side by side, apart from the next group, with short names.
    void addToolBarGroup(const QList<std::pair<QAction*, QString>>& actions);
    const QList<QList<QAction*>>& toolBarGroups() const { return m_toolBarGroups; }

protected:
    // Disables the action while `obstacle` has a sentence; its tips and its shortcut then show this sentence.
    void disableWhen(QAction* action, QString (*obstacle)(const document::Fractal&));
    const MenuContext& context() const { return m_context; }

private:
    QAction* create(const ActionSpec& spec);
    void explainShortcut(QAction* action); // in What's This, also when the user changes it

    MenuContext m_context;
    QList<QList<QAction*>> m_toolBarGroups;
};
