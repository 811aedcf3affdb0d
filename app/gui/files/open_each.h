// SPDX-License-Identifier: MIT
#pragma once

#include "document/disk/journal.h"
#include "files/open_file.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QList>
#include <QPointer>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QProgressDialog;
class QWidget;
class SessionWindow;

// A file to be opened, with the unsaved work that belongs to it if there is some. The path is empty for work
// without a file.
struct WantedFile {
    QString path;
    std::optional<document::Abandoned> recovered;
};
QList<WantedFile> wanted(const QStringList& paths);

// Asks before more windows are opened than anybody can want by mistake; the paths that the user agrees to.
QStringList askWhichToOpen(const QStringList& paths, QWidget* parent);

// Opens files in windows of their own, the first in `first` when there is one. A file that cannot be opened
// leaves its window to the next; a file that is open already has one, which is shown. A few files are read at
// a time, beside the windows. They are opened in their order, but none waits for one that is not read within
// a moment: that one gets a window that says so, and can be cancelled there.
class OpenEach {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)

public:
    OpenEach(const QList<WantedFile>& files, SessionWindow* first,
             std::function<SessionWindow*()> createWindow);
    ~OpenEach();
    OpenEach(const OpenEach&) = delete;
    OpenEach& operator=(const OpenEach&) = delete;

    // Returns when all are opened or given up; events are handled meanwhile.
    void run();

private:
    struct Piece;
    QProgressDialog* showProgress(int count);
    void startSome();
    Piece* next(); // piece to open next; null while an earlier one is still being read
    void open(Piece& piece);
    SessionWindow* takeWindow();
    void showLate();
    void waitForMore();
    void giveUpTheRest();

    std::vector<std::unique_ptr<Piece>> m_left; // pieces in the order of opening
    QPointer<SessionWindow> m_unused;           // a window without a file
    std::function<SessionWindow*()> m_createWindow;
    bool m_hasShown = false;
    bool m_isCancelled = false;
    QEventLoop m_loop;
};
