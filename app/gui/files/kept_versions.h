// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/previous_version.h"
#include "widgets/background/save_beside.h"

#include <QByteArray>
#include <QSet>
#include <QString>

class QWidget;

// The previous versions of the files that a window saves: each is kept once in a sitting, unless the
// preference is off. Which of them are ours outlives the program.
class KeptVersions {
public:
    // Data for io::keepPreviousVersion() about a file; usable in any thread.
    struct Wish {
        bool isWanted = false;
        QByteArray own;

        io::KeptVersion fulfilled(const QString& path) const;
    };
    Wish wishFor(const QString& path) const;
    // Takes note after an attempt to save.
    void note(const QString& path, const io::KeptVersion& kept, bool isSaved);
    void clear() { m_seen.clear(); }

private:
    QSet<QString> m_seen; // paths whose previous version has been kept, or did not exist
};

// A remark for the user on the previous version; empty when there is nothing to say. `name` is the file's.
QString remarkOn(io::Keeping outcome, const QString& name);

// view::saveBeside(), which keeps the previous version. `versions` is not used when the window is gone.
struct KeepingSave {
    view::Saving saving;
    io::Keeping outcome = io::Keeping::Nothing;
};
KeepingSave saveKeeping(const QString& path, const QByteArray& bytes, QWidget* window,
                        KeptVersions& versions);
