// SPDX-License-Identifier: MIT
#include "dialogs/export/printed_parts.h"

#include "io/export_job.h"
#include "widgets/wait_for.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr int columns = printedColumns;
constexpr std::size_t maxMaps = 1000; // nobody reads more on paper

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

double lightness(const attractor::Rgba& colour) {
    return (0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue) / 255;
}

} // namespace

std::vector<PrintedRow> coefficientRows(const document::System2& system) {
    std::vector<PrintedRow> rows;
    const auto number = [](double value) { return QString::number(value == 0 ? 0.0 : value, 'g', 8); };
    const auto probabilities = ifs::probabilities(system);
    for (std::size_t i = 0; i < std::min(system.maps.size(), maxMaps); ++i) {
        const auto& map = system.maps[i].map;
        rows.push_back({QString::number(i + 1), number(map.linear(0, 0)), number(map.linear(0, 1)),
                        number(map.linear(1, 0)), number(map.linear(1, 1)), number(map.translation.x()),
                        number(map.translation.y()), QString::number(probabilities[i], 'g', 4)});
    }
    if (system.maps.size() > maxMaps)
        rows.push_back(
            {QStringLiteral("…"), Text::tr("%n more maps", nullptr, int(system.maps.size() - maxMaps))});
    return rows;
}

QFont printedFont(const QPainter& painter, double pixels, bool bold) {
    QFont font = painter.font();
    font.setPixelSize(std::max(1, int(pixels)));
    font.setBold(bold);
    return font;
}

std::size_t paintCoefficients(QPainter& painter, const QRectF& room, double minHeight,
                              std::span<const PrintedRow> rows) {
    const PrintedRow names{QString(),           QStringLiteral("a"), QStringLiteral("b"),
                           QStringLiteral("c"), QStringLiteral("d"), QStringLiteral("e"),
                           QStringLiteral("f"), QStringLiteral("p")};
    rows = rows.first(std::min(rows.size(), std::size_t(std::max(0.0, room.height() / minHeight - 1))));
    const double rowHeight = std::min(room.height() / double(rows.size() + 1), room.width() / 32);
    constexpr double narrow = 0.4; // the numbers of the maps
    const double columnWidth = room.width() / (columns - 1 + narrow);
    double pixels = 0.7 * rowHeight;
    painter.setFont(printedFont(painter, pixels, false));
    double widest = 0;
    for (const PrintedRow& row : rows)
        for (const QString& text : row)
            widest = std::max(widest, QFontMetricsF(painter.font()).horizontalAdvance(text));
    pixels *= std::min(1.0, 0.92 * columnWidth / std::max(widest, 1.0));
    for (std::size_t i = 0; i <= rows.size(); ++i) {
        const PrintedRow& row = i == 0 ? names : rows[i - 1];
        for (std::size_t j = 0; j < columns; ++j) {
            const double left = j == 0 ? 0 : columnWidth * (double(j) - 1 + narrow);
            painter.setFont(printedFont(painter, pixels, i == 0 || j == 0));
            painter.drawText(QRectF(room.left() + left, room.top() + rowHeight * double(i),
                                    0.96 * columnWidth * (j == 0 ? narrow : 1), rowHeight),
                             Qt::AlignRight | Qt::AlignVCenter, row[j]);
        }
    }
    painter.setPen(QPen(Qt::black, room.width() / 1500));
    painter.drawLine(QPointF(room.left(), room.top() + rowHeight),
                     QPointF(room.right(), room.top() + rowHeight));
    return rows.size();
}

document::Fractal onPaper(document::Fractal fractal) {
    attractor::Appearance& look = fractal.appearance;
    if (look.background.alpha == 255 && lightness(look.background) > 0.5) return fractal;
    look.background = {255, 255, 255, 255};
    if (lightness(look.plain) > 0.5) look.plain = {20, 20, 20, 255};
    const auto& stops = look.palette.stops;
    const attractor::Palette* ink = attractor::findPalette("Ink");
    if (ink && !stops.empty() && lightness(stops.back().colour) > lightness(stops.front().colour))
        look.palette = *ink;
    return fractal;
}

QImage drawnForPaper(const io::PngExport& picture, QWidget* parent) {
    QFuture<QImage> drawing = io::drawBeside(picture);
    if (!waitFor(QFuture<void>(drawing), Text::tr("Drawing the picture…"), parent)) return {};
    return drawing.takeResult();
}

} // namespace view
