// SPDX-License-Identifier: MIT
#include "io/file/native_path.h"

#include <QByteArrayView>

namespace io {

namespace {

constexpr char16_t base = 0xdc00;

bool isByte(const QString& path, qsizetype i) {
    const char16_t c = path[i].unicode();
    return c >= base + 0x80 && c <= base + 0xff && (i == 0 || !path[i - 1].isHighSurrogate());
}

// The bytes of the character that begins there, 0 when none does.
qsizetype characterLength(QByteArrayView text) {
    for (qsizetype length = 1; length <= 4 && length <= text.size(); ++length)
        if (text.first(length).isValidUtf8()) return length;
    return 0;
}

} // namespace

QString pathOf(const QByteArray& name) {
    QString path;
    for (qsizetype i = 0; i < name.size();) {
        const qsizetype length = characterLength(QByteArrayView(name).sliced(i));
        if (length == 0)
            path += QChar(char16_t(base + static_cast<unsigned char>(name[i++])));
        else
            path += QString::fromUtf8(name.constData() + i, length), i += length;
    }
    return path;
}

QByteArray nativeName(const QString& path) {
    QByteArray name;
    qsizetype done = 0;
    for (qsizetype i = 0; i < path.size(); ++i) {
        if (!isByte(path, i)) continue;
        name += QStringView(path).sliced(done, i - done).toUtf8();
        name += char(path[i].unicode() - base);
        done = i + 1;
    }
    return name + QStringView(path).sliced(done).toUtf8();
}

bool isUtf8Name(const QString& path) {
    for (qsizetype i = 0; i < path.size(); ++i)
        if (isByte(path, i)) return false;
    return true;
}

} // namespace io
