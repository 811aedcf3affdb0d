// SPDX-License-Identifier: MIT
#include "io/fractint/metadata_line.h"

#include "io/text/number.h"

#include <QString>

#include <algorithm>
#include <array>

namespace io {

namespace {

struct ColourByName {
    attractor::ColourBy colourBy;
    const char* name;
};
constexpr std::array colourByNames{
    ColourByName{attractor::ColourBy::Density, "density"}, ColourByName{attractor::ColourBy::Map, "map"},
    ColourByName{attractor::ColourBy::Address, "address"}, ColourByName{attractor::ColourBy::Plain, "plain"},
    ColourByName{attractor::ColourBy::Blend, "blend"}};

} // namespace

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

std::optional<double> metadataNumber(const QByteArray& value) {
    return parseNumber(QString::fromLatin1(value));
}

const char* nameOf(attractor::ColourBy colourBy) {
    return std::ranges::find(colourByNames, colourBy, &ColourByName::colourBy)->name;
}

std::optional<attractor::ColourBy> colourByNamed(const QByteArray& name) {
    const auto found =
        std::ranges::find_if(colourByNames, [&](const ColourByName& entry) { return name == entry.name; });
    return found == colourByNames.end() ? std::nullopt : std::optional(found->colourBy);
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
