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
    const char* id; // unique and permanent: users' own shortcuts are stored under it
    QString text;
    QKeySequence shortcut;
    QString tip;                   // text of the status bar and the tool tip
    const char* setting = nullptr; // key under which a toggle is stored between runs; nullptr: not stored
    bool initially = false;        // state of a toggle that was never stored
    const char* icon = nullptr;    // name in the resources; nullptr: the icon named like `id`, if any
};

// Objects that the menus of a window act on.
struct MenuContext {
    QMainWindow* window;
    document::Document* document;
    view::CanvasView* canvas;
    WindowMessages* messages;
    Stage* stage; // canvas of the plane, or view of space
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
    void addShared(QAction* action); // for actions made elsewhere, with the id as their object name

    // The tool bar shows these actions side by side, apart from the next group, with short names.
    void addToolBarGroup(const QList<std::pair<QAction*, QString>>& actions);
    const QList<QList<QAction*>>& toolBarGroups() const { return m_toolBarGroups; }

protected:
    // Disables the action while `obstacle` has a sentence; its tips and its shortcut then show this sentence.
    void disableWhen(QAction* action, QString (*obstacle)(const document::Fractal&));
    const MenuContext& context() const { return m_context; }

private:
    QAction* create(const ActionSpec& spec);
    void explainShortcut(QAction* action); // also follows later changes of the shortcut, in What's This

    MenuContext m_context;
    QList<QList<QAction*>> m_toolBarGroups;
};
