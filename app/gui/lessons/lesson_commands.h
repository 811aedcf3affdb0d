// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "io/lesson/lesson_reader.h"
#include "lessons/lesson_player.h"
#include "panels/lesson/lesson_notebook.h"

#include <QHash>

class FileCommands;
class OpenFile;
class Panels;
class QDockWidget;
namespace view {
class LessonPanel;
}

// The lesson of a window: written in its panel, kept beside the file of its fractals, and played. Its menu
// goes into the View menu.
class LessonCommands : public ActionMenu {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    LessonCommands(const MenuContext& context, const LessonParts& parts, QAction* presentation);

    void setFiles(FileCommands* commands, OpenFile* file); // files that the lessons follow from now on
    view::LessonPanel* panel() const { return m_panel; }
    void setPanels(const Panels& panels); // panels that lessons show, including their own

    bool open(const QString& path); // opens the lesson and its file; reports failures
    bool maybeSave();               // ends the lesson and asks about unsaved steps; false if the user cancels
    // Lesson of a window that has ended; ignores an empty one.
    void recover(const QByteArray& lesson, const QString& path);
    // Shows it in the user's language if there is such a text, from the step with this index.
    void showBuiltIn(const QString& name, int step = 0);
    // The lesson that is open and the step that is played, for a restart; empty without one.
    QVariantMap restartPlace() const;
    bool returnTo(const QVariantMap& place); // false if there was no lesson

    // The lessons that come with the program, as actions; `window` makes the window for one of them.
    void addBuiltIn(QMenu* menu, const std::function<LessonCommands*()>& window);

    view::LessonNotebook& notebook() { return *m_notebook; }
    LessonPlayer& player() { return *m_player; }

private:
    void createActions();
    void connectPanel();
    struct LessonPlace {
        QString lesson;       // path; empty for a lesson of the program
        QString fractals;     // path of the file of fractals
        bool isOther = false; // true if the user chose another file than the lesson names
    };
    bool adopt(const LessonPlace& place, const QString& name, io::LessonFile read);
    bool openWith(const QString& fractals, const QString& path, io::LessonFile lesson);
    void askForForeign(const QString& path, io::LessonFile lesson);
    void offerToFind(const QString& path, io::LessonFile lesson);
    void showPanel();
    bool save();
    bool saveAs();
    bool isReadyToSave() const;
    bool saveWithFractals(const QString& lesson);
    bool saveTo(const QString& path, const QString& before = {}); // says what has been said `before` again
    void follow(const QString& ofFile);                           // when the fractals have been saved
    void showFirstEntry();
    void addStep();
    void play();
    void print();
    void fileChanged();
    void followNames(const document::Change& change);
    QHash<QString, document::EntryId> namedEntries() const;
    bool isUnused() const;

    LessonParts m_parts;
    view::LessonNotebook* m_notebook;
    view::LessonPanel* m_panel;
    LessonPlayer* m_player;
    QDockWidget* m_dock = nullptr;
    FileCommands* m_commands = nullptr;
    OpenFile* m_file = nullptr;
    QHash<QString, document::EntryId> m_named; // namedEntries() before the next change
    QString m_builtIn;                         // name of the open lesson of the program; empty otherwise
    QString m_filePath;                        // path of the lesson's file of fractals
    bool m_isGivenUp = false;                  // true if the user discards the unsaved steps
    bool m_isOpening = false;
};
