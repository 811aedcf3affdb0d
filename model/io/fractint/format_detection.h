// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArrayView>
#include <QString>

#include <optional>

namespace io {

// ".ifs" is also the suffix of formats that have nothing to do with Fractint's. What the bytes are instead,
// as a sentence for the user; nullopt when nothing speaks against a Fractint collection.
std::optional<QString> foreignFormatRemark(QByteArrayView bytes);

} // namespace io
