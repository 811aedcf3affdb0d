// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

namespace io {

// The name beside a file under which its previous version is kept: maple.ifs~.
QString previousVersionOf(const QString& path);

enum class Keeping {
    Nothing, // no file yet
    Kept,
    Foreign, // other file of that name, which stays
    Refused  // error of the file system
};
struct KeptVersion {
    Keeping outcome = Keeping::Nothing;
    QByteArray digest; // SHA-256 of the kept version, by which the next call recognises its own file
};

// Keeps the file as it is now, with its permissions. A file that has the name already is replaced only if it
// has the digest `own`, that of one which an earlier call kept. One that holds the same is left as it is.
KeptVersion keepPreviousVersion(const QString& path, const QByteArray& own);

} // namespace io
