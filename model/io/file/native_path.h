// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

// Names of files are bytes, and QString holds Unicode: a byte that is not UTF-8 becomes the lone surrogate
// U+DC80 … U+DCFF, as in Python (PEP 383), and the byte again when the file is opened. QFile cannot do this.
namespace io {

QString pathOf(const QByteArray& name);
QByteArray nativeName(const QString& path);
bool isUtf8Name(const QString& path); // false: only functions of this layer find the file

} // namespace io
