// SPDX-License-Identifier: MIT
#pragma once

#include "document/disk/journal.h"
#include "document/document.h"
#include "files/kept_versions.h"
#include "files/open_claim.h"
#include "io/collection_reader.h"
#include "io/file/previous_version.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QFuture>
#include <QObject>
#include <QPointer>
#include <QString>

#include <optional>

class QProgressDialog;
class QWidget;

// A file as it was read beside the windows.
struct ReadFile {
    io::Loaded loaded;
    io::Collection collection; // valid if there is no failure
    QByteArray digest;
    QString table; // name of the table whose order of columns is assumed
};
using FileReading = QFuture<ReadFile>;
FileReading startReading(const QString& path);

// The file of a window's document.
class OpenFile : public QObject {
    Q_OBJECT

public:
    OpenFile(document::Document* document, QWidget* window);
    ~OpenFile() override;

    QString path() const { return m_path; } // empty before the first save
    QString name() const;                   // file name for titles, or "Untitled"

    void startNew(); // file with a Sierpiński triangle and no path
    void startFrom(document::FractalFile file, document::EntryId current); // file without a path
    // Pictures that carry their system open as a file without path. The document is as before when this
    // fails.
    io::Failure open(const QString& path);
    io::Failure open(const QString& path, FileReading reading);
    // Says under a dialog over the window that the file is being read, without waiting for it: open() or
    // recover() follows once the reading is finished or cancelled.
    void await(const QString& path, const QFuture<void>& reading);
    void giveUpAwaiting();
    // A large file is read or written beside the window, and events are handled meanwhile.
    bool isBusy() const { return m_isBusy; }
    bool isReading() const { return m_isReading; }
    // Stops reading because the window closes: nobody waits for the result any more, and nothing is reported.
    // stopped() follows when nobody uses the window any more.
    void stopReading();
    bool isStopped() const { return m_isStopped; }
    // Takes over unsaved work as one undoable step over the file as it is on disk, so that nothing is written
    // before it is saved. A file that cannot be read now, as on a drive that is not there, is reported; the
    // path stays. nullopt when the user does not wait for it.
    std::optional<io::Failure> recover(const document::Snapshot& snapshot);
    std::optional<io::Failure> recover(const document::Snapshot& snapshot, const FileReading& onDisk);
    io::Failure save(); // writes to path()
    io::Failure saveAs(const QString& path);
    io::Failure revert();

    QByteArray digest() const { return m_digest; } // digest of the bytes last read or written here
    // State of the file at path(): `Changed` when it holds other bytes or cannot be read, `Gone` when there
    // is none any more and the user has not been told so. nullopt when the user does not wait for it.
    enum class OnDisk { Same, Changed, Gone };
    std::optional<OnDisk> onDisk();
    // Hard links of the file that was there before the last save, which go on leading to the old contents.
    int otherNames() const { return m_otherNames; }
    // The fate of the version before the last save. The first save of a file in this window keeps it, unless
    // the user does not want that.
    io::Keeping previousVersion() const { return m_previous; }
    KeptVersions& versions() { return m_versions; } // kept versions of all files that the window saves

signals:
    void pathChanged();
    void stopped();
    void isOpenElsewhere(); // true if another window of this account, which may also save, has the file open
    // A table was opened whose text does not say what its columns are.
    void orderAssumed(const QString& text);
    void flamesOpened();

private:
    bool hasRead(const QFuture<void>& reading, const QString& label);
    void endAwaiting();
    io::Failure write(const QString& path);
    void remember(const QString& path, const QByteArray& digest);

    document::Document* m_document;
    QWidget* m_window;
    bool m_isBusy = false;
    bool m_isReading = false;
    bool m_isStopped = false;
    bool m_isAwaiting = false;
    QFuture<void> m_reading;
    QPointer<QProgressDialog> m_progress; // shown during a slow read
    QString m_path;
    QByteArray m_digest;
    bool m_isMissing = false; // true if the file was missing when it was read, and the user knows
    void claim();

    int m_otherNames = 0;
    io::Keeping m_previous = io::Keeping::Nothing;
    KeptVersions m_versions;
    QString m_claimed; // path that the claim is for
    ClaimLock m_claim;
};
