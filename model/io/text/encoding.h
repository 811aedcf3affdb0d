// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

#include <optional>

namespace io {

// A text in UTF-16 or UTF-32, told by its first bytes or by the zeros in every other one, in UTF-8; nullopt
// for any other bytes.
std::optional<QByteArray> fromUtf16(const QByteArray& bytes);

} // namespace io
