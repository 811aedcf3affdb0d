// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

namespace io {

// The name beside a file under which its previous version is kept: maple.ifs~.
QString previousVersionOf(const QString& path);

enum class Keeping {
    Nothing, // there is no file yet
    Kept,
    Foreign, // another file has the name, and stays
    Refused  // by the file system
};
struct KeptVersion {
    Keeping outcome = Keeping::Nothing;
    QByteArray digest; // SHA-256 of what was kept, by which the next call knows its own file
};

// Keeps the file as it is now, with its permissions. A file that has the name already is replaced only if it
// has the digest `own`, that of one which an earlier call kept. One that holds the same is left as it is.
KeptVersion keepPreviousVersion(const QString& path, const QByteArray& own);

} // namespace io
