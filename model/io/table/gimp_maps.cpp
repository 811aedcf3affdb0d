// SPDX-License-Identifier: MIT
#include "io/table/gimp_maps.h"

#include "io/text/number.h"

#include <QHash>
#include <QRegularExpression>

#include <cmath>
#include <optional>
#include <utility>

namespace io {

namespace {

// M = rotation · scale · distortion about the centre, then to (x, y); all in widths of the picture.
std::optional<WrittenMap> mapOf(const QHash<QString, double>& element, double centreX, double centreY) {
    for (const char* key : {"x", "y", "theta", "scale", "asym", "shear"})
        if (!element.contains(QLatin1String(key))) return std::nullopt;
    const auto of = [&](const char* key) { return element.value(QLatin1String(key)); };
    if (of("asym") == 0) return std::nullopt;
    const double across = of("flip") != 0 ? -of("scale") : of("scale");
    const double c = std::cos(of("theta"));
    const double s = std::sin(of("theta"));
    const double along = of("scale") / of("asym");
    const double a = c * across * of("asym");
    const double b = c * across * of("shear") + s * along;
    const double d = -s * across * of("asym");
    const double e = -s * across * of("shear") + c * along;
    const double x = of("x") - a * centreX - b * centreY;
    const double y = of("y") - d * centreX - e * centreY;
    WrittenMap map{{a, -b, -d, e, x, -y}, {}, 0};
    if (element.contains(QStringLiteral("prob"))) map.weight = of("prob");
    return map;
}

} // namespace

WrittenMaps gimpMaps(const QString& text) {
    static const QRegularExpression token(
        QStringLiteral(R"(([a-z_]+)\s+(?:(-?\s?[0-9.][^\s{}]*)|(\{[^{}a-z]*\})|(\{)|([^\s{}]+)))"));
    if (!text.contains(QStringLiteral("center_x")) || !text.contains(QStringLiteral("element"))) return {};
    QHash<QString, double> general;
    std::vector<QHash<QString, double>> elements;
    std::vector<int> lines;
    bool isInside = false;
    std::optional<UnreadMap> unread;
    qsizetype before = 0;
    int line = 1;
    for (auto found = token.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        line += int(QStringView(text).sliced(before, match.capturedStart() - before).count(u'\n'));
        before = match.capturedStart();
        if (match.capturedView(1) == u"element" && match.hasCaptured(4)) {
            elements.emplace_back();
            lines.push_back(line);
            isInside = true;
        } else if (match.hasCaptured(2)) {
            const auto value = parseNumber(match.captured(2).remove(u' '));
            if (value)
                (isInside ? elements.back() : general).insert(match.captured(1), *value);
            else if (!unread)
                unread = {int(elements.size()), line, match.captured()};
        } else if (match.hasCaptured(5) && isInside && !unread) {
            unread = {int(elements.size()), line, match.captured()};
        }
    }
    if (unread && elements.empty()) return {};
    if (unread) return {{}, unread};
    std::vector<WrittenMap> maps;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        auto map = mapOf(elements[i], general.value(QStringLiteral("center_x")),
                         general.value(QStringLiteral("center_y")));
        if (!map) return {{}, UnreadMap{int(i) + 1, lines[i], QStringLiteral("element")}};
        map->line = lines[i];
        maps.push_back(*std::move(map));
    }
    return {std::move(maps)};
}

} // namespace io
