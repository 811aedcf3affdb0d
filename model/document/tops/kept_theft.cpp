// SPDX-License-Identifier: MIT
#include "document/tops/kept_theft.h"

#include <QUrl>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace document {

namespace {

const QString prefix = QStringLiteral("barycage: partner");
constexpr qsizetype maxValue = 36; // characters of a path on one line, which then stays below 70
constexpr std::size_t maxOrder = 4096;
constexpr qsizetype maxPath = 8192;
constexpr qsizetype maxDataLine = 44; // characters, four of which hold three bytes
const QByteArray::Base64Options dataLetters = QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals;

bool isOurs(const QString& comment) {
    return comment.startsWith(prefix);
}

void readOrder(const QString& value, std::vector<std::size_t>& order) {
    for (const QString& number : value.split(u' ', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int map = number.toInt(&isNumber);
        if (!isNumber || map < 1 || order.size() >= maxOrder) return;
        order.push_back(std::size_t(map - 1));
    }
}

std::optional<attractor::View> viewOf(const QString& value) {
    const QStringList texts = value.split(u' ', Qt::SkipEmptyParts);
    std::array<double, 3> numbers{};
    if (texts.size() != 3) return std::nullopt;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        bool isNumber = false;
        numbers[k] = texts[qsizetype(k)].toDouble(&isNumber);
        if (!isNumber || !(std::abs(numbers[k]) < 1e38)) return std::nullopt;
    }
    if (!(numbers[2] > 0)) return std::nullopt;
    return attractor::View{{numbers[0], numbers[1]}, numbers[2]};
}

// Values that are spread over several lines.
struct Encoded {
    QByteArray path, data;
};

void readLine(const QString& key, const QString& value, KeptTheft& theft, Encoded& encoded) {
    if (key.isEmpty()) theft.partner = value;
    if (key == QLatin1String("-order")) readOrder(value, theft.order);
    if (key == QLatin1String("-picture") && encoded.path.size() < maxPath) encoded.path += value.toLatin1();
    if (key == QLatin1String("-data") && encoded.data.size() < 2 * maxEmbeddedPicture)
        encoded.data += value.toLatin1();
    if (key == QLatin1String("-view")) theft.view = viewOf(value);
    if (key == QLatin1String("-mode"))
        theft.mode = ifs::named<TheftMode>(value.toStdString()).value_or(theft.mode);
    if (key == QLatin1String("-pattern"))
        theft.pattern = ifs::named<attractor::Pattern>(value.toStdString()).value_or(theft.pattern);
}

QString line(const char* key, const QString& value) {
    return prefix + QLatin1String(key) + u' ' + value;
}

QStringList linesOf(const KeptTheft& theft) {
    QStringList lines{line("", theft.partner), line("-mode", QLatin1String(ifs::nameOf(theft.mode)))};
    QStringList numbers;
    for (std::size_t k = 0; k < theft.order.size(); ++k) {
        numbers << QString::number(theft.order[k] + 1);
        if (numbers.size() == 8 || k + 1 == theft.order.size())
            lines << line("-order", std::exchange(numbers, {}).join(u' '));
    }
    lines << line("-pattern", QLatin1String(ifs::nameOf(theft.pattern)));
    const QByteArray path = QUrl::toPercentEncoding(theft.picture, "/");
    for (qsizetype at = 0; at < path.size(); at += maxValue)
        lines << line("-picture", QString::fromLatin1(path.mid(at, maxValue)));
    const QByteArray data = theft.embedded.toBase64(dataLetters);
    for (qsizetype at = 0; at < data.size(); at += maxDataLine)
        lines << line("-data", QString::fromLatin1(data.mid(at, maxDataLine)));
    if (theft.view)
        lines << line("-view", QStringLiteral("%1 %2 %3")
                                   .arg(theft.view->centre.x(), 0, 'g', 12)
                                   .arg(theft.view->centre.y(), 0, 'g', 12)
                                   .arg(theft.view->height, 0, 'g', 12));
    return lines;
}

} // namespace

std::optional<KeptTheft> keptTheft(const Fractal& fractal) {
    KeptTheft theft;
    Encoded encoded;
    for (const QString& comment : fractal.comments) {
        if (!isOurs(comment)) continue;
        const QString rest = comment.mid(prefix.size());
        const qsizetype blank = rest.indexOf(u' ');
        if (blank >= 0) readLine(rest.left(blank), rest.mid(blank + 1).trimmed(), theft, encoded);
    }
    theft.picture = QUrl::fromPercentEncoding(encoded.path);
    theft.embedded = QByteArray::fromBase64(encoded.data, dataLetters);
    return theft.partner.isEmpty() ? std::nullopt : std::optional(theft);
}

Fractal withTheft(Fractal fractal, const std::optional<KeptTheft>& theft) {
    const bool isKept = theft && !theft->partner.isEmpty();
    if (isKept ? keptTheft(fractal) == theft : std::ranges::none_of(fractal.comments, isOurs)) return fractal;
    fractal.comments.removeIf(isOurs);
    if (isKept) fractal.comments << linesOf(*theft);
    return fractal;
}

} // namespace document
