// SPDX-License-Identifier: MIT
#include "io/palette/palette_hex.h"

#include <QRegularExpression>
#include <QString>

namespace io {

namespace {

using attractor::Rgba;

constexpr std::size_t maxHexColours = 4096;

// "fc0" stands for "ffcc00"; opacities are ignored. They are in front in 0xAARRGGBB, and behind in #RRGGBBAA.
Rgba colourOf(QString digits, bool isOpacityFirst) {
    if (isOpacityFirst && digits.size() == 8) digits = digits.sliced(2);
    if (digits.size() < 6) {
        QString doubled;
        for (const QChar digit : digits.left(3))
            doubled += QString(2, digit);
        digits = doubled;
    }
    const uint value = digits.left(6).toUInt(nullptr, 16);
    return {std::uint8_t(value >> 16), std::uint8_t(value >> 8 & 0xff), std::uint8_t(value & 0xff), 255};
}

std::vector<Rgba> all(const QString& text, const QRegularExpression& pattern) {
    std::vector<Rgba> colours;
    for (auto found = pattern.globalMatch(text); found.hasNext() && colours.size() < maxHexColours;) {
        const auto match = found.next();
        const bool isPrefixed = match.capturedView().startsWith(u"0x", Qt::CaseInsensitive);
        colours.push_back(colourOf(match.captured(1), isPrefixed));
    }
    return colours;
}

} // namespace

std::vector<Rgba> hexColours(const QByteArray& bytes) {
    static const QRegularExpression marked(
        QStringLiteral("(?:#|\\b0[xX])([0-9a-fA-F]{8}|[0-9a-fA-F]{6}|[0-9a-fA-F]{3,4})(?![0-9A-Za-z])"));
    static const QRegularExpression bare(QStringLiteral("\\b([0-9a-fA-F]{6})\\b"));
    static const QRegularExpression remark(QStringLiteral("^\\s*(?:;|//|#(?![0-9a-fA-F]{3})).*$"),
                                           QRegularExpression::MultilineOption);
    static const QRegularExpression separators(QStringLiteral("[\\s,;|/\"'\\[\\](){}-]+"));
    static const QRegularExpression address(
        QStringLiteral("^\\s*(?:https?://)?[\\w.-]+\\.[a-z]{2,6}/(?:[\\w.-]*/)*?(?=[0-9a-f]{6}(?:-|\\b))"));
    QString text = QString::fromUtf8(bytes);
    // Excludes gradients of Ultra Fractal, which have words and braces around whole numbers.
    if (!text.contains(QStringLiteral("gradient:")))
        if (auto colours = all(text, marked); colours.size() >= 2) return colours;
    text.remove(remark).remove(address);
    auto colours = all(text, bare);
    if (colours.size() < 2) return {};
    QString rest = text;
    rest.remove(bare).remove(separators);
    return rest.isEmpty() ? colours : std::vector<Rgba>();
}

} // namespace io
