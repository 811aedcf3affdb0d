// SPDX-License-Identifier: MIT
#include "io/fractint/blend_comments.h"

#include "document/fractal/fractal_geometry.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"

#include <QString>

#include <cstddef>

namespace io {

namespace {

constexpr const char* blendKey = "map-blend";

// Two lines where the numbers are too long for one, as in the links of maps.
QByteArrayList linesOf(std::size_t map, const attractor::MapBlend& blend) {
    const QByteArray number = QByteArray::number(qulonglong(map) + 1) + ' ';
    const QByteArray coordinate = formatNumber(blend.coordinate), speed = formatNumber(blend.speed);
    const QByteArray line = metadataLine(blendKey, number + coordinate + ' ' + speed);
    if (line.size() <= maxMetadataLine) return {line};
    return {metadataLine(blendKey, number + coordinate), metadataLine(blendKey, number + speed)};
}

template <class Visit> void visitMaps(const document::Fractal& fractal, const Visit& visit) {
    if (const auto* system = document::system2(fractal))
        visit(system->maps);
    else if (const auto* solid = document::system3(fractal))
        visit(solid->maps);
}

} // namespace

QByteArrayList blendComments(const document::Fractal& fractal) {
    QByteArrayList lines;
    const attractor::MapBlends& blends = fractal.appearance.mapBlends;
    if (blends.empty()) return lines;
    visitMaps(fractal, [&](const auto& maps) {
        for (std::size_t i = 0; i < maps.size(); ++i)
            if (const auto* blend = blends.find(maps[i].id)) lines << linesOf(i, *blend);
    });
    return lines;
}

bool BlendComments::read(const QByteArray& key, const QByteArrayList& values) {
    if (key != blendKey || values.size() < 2 || values.size() > 3) return false;
    const int map = values[0].toInt();
    if (map < 1) return false;
    std::vector<double> numbers;
    for (const QByteArray& value : values.sliced(1)) {
        const auto number = parseNumber(QString::fromLatin1(value));
        if (!number || !(*number >= 0 && *number <= 1)) return false;
        numbers.push_back(*number);
    }
    const auto known = m_blends.find(map);
    if (known != m_blends.end() && known->second.size() + numbers.size() > 2) return false;
    std::vector<double>& blend = m_blends[map];
    blend.insert(blend.end(), numbers.begin(), numbers.end());
    return true;
}

void BlendComments::applyTo(document::Fractal& fractal) const {
    attractor::MapBlends& blends = fractal.appearance.mapBlends;
    visitMaps(fractal, [&](const auto& maps) {
        for (const auto& [map, numbers] : m_blends) {
            if (std::size_t(map) > maps.size()) break;
            attractor::MapBlend& blend = blends[maps[std::size_t(map) - 1].id];
            blend.coordinate = numbers.front();
            if (numbers.size() > 1) blend.speed = numbers.back();
        }
    });
}

} // namespace io
