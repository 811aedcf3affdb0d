// SPDX-License-Identifier: MIT
#include "io/fractint/label_comments.h"

#include "document/maps/map_names.h"
#include "io/text/metadata_line.h"

#include <QString>

#include <algorithm>
#include <cctype>
#include <utility>

namespace io {

namespace {

constexpr const char* nameKey = "map-name";
constexpr const char* lockKey = "locked";
constexpr qsizetype maxWritten = 4096; // bytes of a name, each of which may take three
constexpr qsizetype escaped = 3;       // bytes

QByteArray escapeOf(const QByteArray& bytes) {
    QByteArray text;
    for (const char byte : bytes)
        text += '%' + QByteArray::number(uint(static_cast<unsigned char>(byte)), 16).rightJustified(2, '0');
    return text;
}

// Returns false for letters that must be escaped in a comment: ends of lines and entries, and invisible ones.
bool isPlain(const QString& letter) {
    const QChar c = letter.front();
    return letter != u"%" && letter != u"{" && letter != u"}" && (c.isPrint() || c.isSurrogate());
}

// The letters of a name as they are written, none of which can be divided.
QByteArrayList lettersOf(const QString& name) {
    QByteArrayList letters;
    for (qsizetype at = 0; at < name.size();) {
        const qsizetype size = name[at].isHighSurrogate() ? 2 : 1;
        const QString letter = name.mid(at, size);
        letters << (isPlain(letter) ? letter.toUtf8() : escapeOf(letter.toUtf8()));
        at += size;
    }
    return letters;
}

// Blanks at the ends of lines would be lost, and so would all but one of several.
QByteArrayList linesOf(int map, const QString& name) {
    const QByteArray number = QByteArray::number(map);
    const qsizetype room = maxMetadataLine - metadataLine(nameKey, number + ' ').size();
    QByteArrayList texts{QByteArray()};
    const auto closeText = [&texts] {
        if (texts.back().endsWith(' ')) texts.back().replace(texts.back().size() - 1, 1, "%20");
    };
    for (const QByteArray& letter : lettersOf(name)) {
        if (texts.back().size() + letter.size() + escaped - 1 > room) {
            closeText();
            texts << QByteArray();
        }
        const bool isLost = letter == " " && (texts.back().isEmpty() || texts.back().endsWith(' '));
        texts.back() += isLost ? QByteArray("%20") : letter;
    }
    closeText();
    QByteArrayList lines;
    for (const QByteArray& text : std::as_const(texts))
        lines << metadataLine(nameKey, number + ' ' + text);
    return lines;
}

QString nameIn(const QByteArray& written) {
    QByteArray bytes;
    for (qsizetype at = 0; at < written.size(); ++at) {
        bool isByte = false;
        const QByteArray digits = written[at] == '%' ? written.mid(at + 1, 2) : QByteArray();
        const bool areDigits = digits.size() == 2 &&
                               std::ranges::all_of(digits, [](unsigned char c) { return std::isxdigit(c); });
        const int byte = areDigits ? digits.toInt(&isByte, 16) : 0;
        if (isByte) at += 2;
        bytes += isByte ? char(byte) : written[at];
    }
    return document::mapNameOf(QString::fromUtf8(bytes));
}

template <class System> QByteArrayList linesOf(const System& system, const document::MapLabels& labels) {
    QByteArrayList lines, locked;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const document::MapLabel label = storedLabel(labels.of(system.maps[i].id));
        if (!label.name.isEmpty()) lines << linesOf(int(i) + 1, label.name);
        if (label.isLocked) locked << QByteArray::number(qulonglong(i) + 1);
    }
    if (!locked.isEmpty()) lines << metadataLines(lockKey, locked);
    return lines;
}

template <class System>
void give(const System& system, const std::map<int, QByteArray>& names, std::vector<int> locked,
          document::MapLabels& labels) {
    std::ranges::sort(locked);
    const auto count = int(system.maps.size());
    auto name = names.begin();
    auto lock = locked.begin();
    while (name != names.end() || lock != locked.end()) {
        const int map = name == names.end()    ? *lock
                        : lock == locked.end() ? name->first
                                               : std::min(name->first, *lock);
        if (map > count) return;
        document::MapLabel label;
        if (name != names.end() && name->first == map) label.name = nameIn((name++)->second);
        for (; lock != locked.end() && *lock == map; ++lock)
            label.isLocked = true;
        labels.set(system.maps[std::size_t(map) - 1].id, std::move(label));
    }
}

} // namespace

QByteArrayList labelComments(const document::Fractal& fractal) {
    if (fractal.mapLabels.isEmpty()) return {};
    if (const auto* system = document::system2(fractal)) return linesOf(*system, fractal.mapLabels);
    const auto* solid = document::system3(fractal);
    return solid ? linesOf(*solid, fractal.mapLabels) : QByteArrayList();
}

document::MapLabel storedLabel(document::MapLabel label) {
    label.name = document::mapNameOf(label.name);
    return label;
}

bool LabelComments::read(const QByteArray& key, const QByteArrayList& values) {
    if (key == nameKey && values.size() >= 2) {
        const int map = values[0].toInt();
        if (map < 1) return false;
        QByteArray& name = m_names[map];
        const QByteArray text = values.sliced(1).join(' ');
        if (name.size() + text.size() > maxWritten) return false;
        name += text;
        return true;
    }
    if (key != lockKey || values.isEmpty()) return false;
    std::vector<int> locked;
    for (const QByteArray& value : values)
        locked.push_back(value.toInt());
    if (std::ranges::min(locked) < 1) return false;
    m_locked.insert(m_locked.end(), locked.begin(), locked.end());
    return true;
}

void LabelComments::applyTo(document::Fractal& fractal) const {
    if (const auto* system = document::system2(fractal))
        give(*system, m_names, m_locked, fractal.mapLabels);
    else if (const auto* solid = document::system3(fractal))
        give(*solid, m_names, m_locked, fractal.mapLabels);
}

} // namespace io
