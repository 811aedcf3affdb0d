// SPDX-License-Identifier: MIT
#pragma once

#include "actions/action_menu.h"
#include "files/open_file.h"

#include <functional>
#include <optional>

namespace view {
class Snapshots;
}

bool isLesson(const QString& path);

// Opens and saves the file of a window, with the dialogs that this takes. Shares the translations of the main
// window.
class FileCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    FileCommands(const MenuContext& context, OpenFile* file);

    bool maybeSave(); // asks about unsaved changes; false if the user cancels
    // Commands that report what was read, or what failed:
    bool open(const QString& path);
    // Result of a reading that was started elsewhere.
    bool open(const QString& path, const FileReading& reading);
    // Commands that ask about unsaved changes first. A file that another window has is shown there.
    void startNew();
    void chooseAndOpen();
    void openRecent(const QString& path);

    bool save();
    bool saveAs();
    // saveAs() after the choice of a file, and without its lesson: what was said, or nullopt after a failure.
    std::optional<QString> saveTo(const QString& path);
    // Saves with the placements written into the code and all maps listed; the file of the window stays as it
    // is.
    void saveForOtherPrograms();
    void revert();

    // The lesson that goes with the file: how one is opened, whether unsaved writing may be given up, and
    // whether one is played, which keeps the file from being saved meanwhile, what becomes of it when the
    // file is saved (it says that with what has been said of the file), and whether it has unsaved steps.
    struct Lessons {
        std::function<bool(const QString& path)> open;
        std::function<bool()> maybeSave;
        std::function<bool()> refusesSaving;
        std::function<void(const QString& ofFile)> follow;
        std::function<bool()> isUnsaved;
    };
    void setLessons(const Lessons& lessons) { m_lessons = lessons; }
    bool hasUnsavedLesson() const { return m_lessons.isUnsaved && m_lessons.isUnsaved(); }
    void setSnapshots(const view::Snapshots* snapshots) { m_snapshots = snapshots; } // lost with the file

private:
    enum class Answer { Save, SaveAs, Cancel };
    Answer askAboutDisk(OpenFile::OnDisk found);
    void reportOpened();
    QString reportSaved(); // what it says
    void followFile(const QString& sentence);
    QString targetRemark() const;       // remark about the target of a collage, if there is one
    QString lostSnapshots() const;      // sentence about snapshots that would be lost; empty: none
    QString discardedSnapshots() const; // addition about snapshots, when changes are discarded

    MenuContext m_context;
    OpenFile* m_file;
    Lessons m_lessons;
    bool m_hasRemarkedOnTarget = false; // once per window
    bool m_hasRemarkedOnPlacement = false;
    const view::Snapshots* m_snapshots = nullptr;
};
