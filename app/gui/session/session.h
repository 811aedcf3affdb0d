// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"

#include <QFuture>
#include <QList>
#include <QMainWindow>
#include <QStringList>
#include <QVariantMap>

#include <optional>

class OpenFile;
class Recovery;
struct ReadFile;

namespace document {
struct Abandoned;
}

// A window of the program, with a file of its own: what the others need to know of it.
class SessionWindow : public QMainWindow {
    Q_OBJECT

public:
    using QMainWindow::QMainWindow;
    virtual QString path() const = 0; // empty before the first save
    virtual OpenFile& file() = 0;
    // These take files that were read in the background, and report failures; false: the window is still
    // free.
    virtual bool openPath(const QString& path, const QFuture<ReadFile>& reading) = 0;
    virtual void openRecovered(const document::Abandoned& abandoned, const QFuture<ReadFile>& reading) = 0;
    virtual void adopt(const view::Preferences& preferences) = 0;
    virtual Recovery& recovery() = 0;
    // Asks the user, if something would be lost, and closes nothing. After true, close() does not ask again
    // until closingIsOff().
    enum class Leaving { Window, Program };
    virtual bool mayClose(Leaving leaving) = 0;
    virtual void closingIsOff() = 0; // called when another window stays open
    // The state that a restart brings back to this window, and its restoration.
    virtual QVariantMap restartPlace() const = 0;
    virtual void returnTo(const QVariantMap& place) = 0;
};

// The windows of this run, and the files that were open at its end.
namespace session {

QList<SessionWindow*> windows();
bool allAreClosed(); // also true if none was shown yet
// Brings another window than this one to the front if it has the file, whatever its path is called. That
// window says why. false: none has it.
bool showOther(const QString& path, const QWidget* window);
QStringList files(); // files of the last run, except those known to be gone

// Stores the files of the open windows for the next run. Call it while a window closes.
void remember();
// Closes all windows, or none: each of them may ask before. When all have closed, stores the files they had.
void quit();
// Closes like quit(); main() then starts the program again with the files to reopen.
void restart();
std::optional<QStringList> filesToReopen(); // nullopt: the user declined
// The places of the windows before the restart that this run is: once, later none.
QList<QVariantMap> takeRestartPlaces();

} // namespace session
