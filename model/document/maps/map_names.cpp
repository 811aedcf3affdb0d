// SPDX-License-Identifier: MIT
#include "document/maps/map_names.h"

#include "document/text/reordered_text.h"

namespace document {

namespace {

bool isPart(const QString& text, qsizetype at) {
    const QChar c = text[at];
    if (c.isHighSurrogate()) return at + 1 < text.size() && text[at + 1].isLowSurrogate();
    if (c.isLowSurrogate()) return at > 0 && text[at - 1].isHighSurrogate();
    if (c == QChar::ByteOrderMark) return false; // removed by decoders
    return !turnsText(c) && c.category() != QChar::Other_Control && c.category() != QChar::Other_NotAssigned;
}

ifs::MapId idAt(const Fractal& fractal, std::size_t index) {
    if (const System2* system = system2(fractal))
        return index < system->maps.size() ? system->maps[index].id : ifs::MapId::None;
    const System3* solid = system3(fractal);
    return solid && index < solid->maps.size() ? solid->maps[index].id : ifs::MapId::None;
}

} // namespace

QString mapNameOf(const QString& text) {
    const QString line = text.simplified();
    QString name;
    for (qsizetype at = 0; at < line.size(); ++at)
        if (isPart(line, at)) name += line[at];
    name = name.simplified(); // blanks may have become adjacent
    if (name.size() > maxMapName) {
        name.truncate(maxMapName);
        if (name.back().isHighSurrogate()) name.chop(1);
        name = name.trimmed();
    }
    return name;
}

QString mapTitle(const Fractal& fractal, std::size_t index) {
    const QString number = QString::number(index + 1);
    const QString name = fractal.mapLabels.of(idAt(fractal, index)).name;
    return name.isEmpty() ? number : QStringLiteral("%1 (%2)").arg(number, name);
}

} // namespace document
