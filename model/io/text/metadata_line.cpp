// SPDX-License-Identifier: MIT
#include "io/text/metadata_line.h"

#include "io/text/number.h"

#include <QString>

#include <cstddef>

namespace io {

QByteArray metadataLine(const char* key, const QByteArray& values) {
    return QByteArray("; ") + metadataPrefix + ' ' + key + ' ' + values;
}

QByteArrayList metadataLines(const char* key, const QByteArrayList& values) {
    QByteArrayList lines{metadataLine(key, {})};
    for (const QByteArray& value : values) {
        if (!lines.back().endsWith(' ')) {
            if (lines.back().size() + 1 + value.size() > maxMetadataLine)
                lines << metadataLine(key, {});
            else
                lines.back() += ' ';
        }
        lines.back() += value;
    }
    return lines;
}

std::vector<std::string> plainWords(const QByteArrayList& values) {
    std::vector<std::string> words;
    words.reserve(std::size_t(values.size()));
    for (const QByteArray& value : values)
        words.push_back(value.toStdString());
    return words;
}

QByteArrayList byteLines(const std::vector<std::string>& lines) {
    QByteArrayList list;
    for (const std::string& line : lines)
        list << QByteArray::fromStdString(line);
    return list;
}

std::optional<double> metadataNumber(const QByteArray& value) {
    return parseNumber(QString::fromLatin1(value));
}

std::string storableText(const char* key, const std::string& text) {
    QString line = QString::fromStdString(text);
    line.removeIf([](QChar c) { return !c.isPrint() && !c.isSurrogate() && !c.isSpace(); });
    line = line.simplified();
    const auto room = maxMetadataLine - metadataLine(key, {}).size();
    while (line.toUtf8().size() > room)
        line.chop(1);
    return line.trimmed().toStdString();
}

} // namespace io
