// SPDX-License-Identifier: MIT
#pragma once

#include "action_menu.h"
#include "open_file.h"

#include <functional>

// Opens and saves the file of a window, with the dialogs that this takes. Shares the translations of the main
// window.
class FileCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    FileCommands(const MenuContext& context, OpenFile* file);

    bool maybeSave();               // asks about unsaved changes; false: the user cancelled
    bool open(const QString& path); // reports what was read, or what failed
    // These ask about unsaved changes first.
    void startNew();
    void chooseAndOpen();
    void openRecent(const QString& path);

    bool save();
    bool saveAs();
    void revert();

    // A lesson goes with the file: how one is opened, whether what is written may be given up, and whether
    // one is played, which keeps the file from being saved meanwhile.
    struct Lessons {
        std::function<bool(const QString& path)> open;
        std::function<bool()> maybeSave;
        std::function<bool()> refusesSaving;
    };
    void setLessons(const Lessons& lessons) { m_lessons = lessons; }
    // The names of the snapshots that are lost with the file.
    void setSnapshots(const std::function<QStringList()>& unsaved) { m_snapshots = unsaved; }

private:
    enum class Answer { Save, SaveAs, Cancel };
    Answer askAboutDisk(OpenFile::OnDisk found);
    void reportOpened();
    void reportSaved();
    QString targetRemark() const;  // about the target of a collage, if there is one
    QString lostSnapshots() const; // a sentence; empty: none

    MenuContext m_context;
    OpenFile* m_file;
    Lessons m_lessons;
    bool m_hasRemarkedOnTarget = false; // since the window is open
    std::function<QStringList()> m_snapshots;
};
