// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace io {

// The user's sentence when something went wrong; nullopt on success.
using Failure = std::optional<QString>;

// Writes through a temporary file in the same folder, flushed to the disk and renamed: `path` holds the old
// bytes or the new ones, never a part. Permissions and a symbolic link at `path` are kept.
Failure saveFile(const QString& path, const QByteArray& bytes);

struct Loaded {
    QByteArray bytes;
    Failure failure;
};
Loaded loadFile(const QString& path); // refuses more than 256 MB, saying so

} // namespace io
