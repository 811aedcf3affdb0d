// SPDX-License-Identifier: MIT
#include "io/text/encoding.h"

#include <QStringConverter>
#include <QStringDecoder>

#include <algorithm>

namespace io {

namespace {

// Text in Latin letters has its zeros all at even places, or all at odd ones.
std::optional<QStringConverter::Encoding> byZeros(const QByteArray& bytes) {
    constexpr qsizetype sample = 512;
    constexpr qsizetype shortest = 8;
    const QByteArrayView head = QByteArrayView(bytes).first(std::min(bytes.size(), sample));
    if (head.size() < shortest || bytes.size() % 2 != 0) return std::nullopt;
    qsizetype zeros[2] = {0, 0};
    for (qsizetype i = 0; i < head.size(); ++i)
        if (head[i] == '\0') ++zeros[i % 2];
    const qsizetype most = head.size() / 2;
    if (zeros[0] == 0 && zeros[1] * 10 >= most * 9) return QStringConverter::Utf16LE;
    if (zeros[1] == 0 && zeros[0] * 10 >= most * 9) return QStringConverter::Utf16BE;
    return std::nullopt;
}

} // namespace

std::optional<QByteArray> fromUtf16(const QByteArray& bytes) {
    auto encoding = QStringConverter::encodingForData(bytes);
    if (!encoding || *encoding == QStringConverter::Utf8) encoding = byZeros(bytes);
    if (!encoding) return std::nullopt;
    QStringDecoder decoder(*encoding);
    QString text = decoder(bytes);
    if (decoder.hasError()) return std::nullopt;
    if (text.startsWith(QChar(0xfeff))) text.remove(0, 1);
    return text.toUtf8();
}

} // namespace io
