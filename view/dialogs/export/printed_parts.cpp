// SPDX-License-Identifier: MIT
#include "dialogs/export/printed_parts.h"

#include "document/text/text.h"
#include "io/exports/export_recipe.h"
#include "widgets/background/wait_for.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr std::size_t maxMaps = 1000; // limit on paper

QImage drawn(QFuture<QImage> drawing, QWidget* parent) {
    if (!waitFor(QFuture<void>(drawing), Text::tr("Drawing the picture…"), parent)) return {};
    return drawing.takeResult();
}

double lightness(const attractor::Rgba& colour) {
    return (0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue) / 255;
}

} // namespace

QStringList coefficientNames(int dimension) {
    QStringList names{QString()};
    for (const QChar letter : dimension == 2 ? QStringLiteral("abcdef") : QStringLiteral("abcdefghijkl"))
        names << letter;
    return names << QStringLiteral("p");
}

template <int Dim> PrintedTable coefficientTable(const ifs::IteratedFunctionSystem<Dim>& system) {
    constexpr int digits = Dim == 2 ? 8 : 6; // fewer in space, where there are twice as many columns
    PrintedTable table{coefficientNames(Dim), {}};
    const auto number = [](double value) { return QString::number(value == 0 ? 0.0 : value, 'g', digits); };
    const auto probabilities = ifs::probabilities(system);
    for (std::size_t i = 0; i < std::min(system.maps.size(), maxMaps); ++i) {
        const auto& map = system.maps[i].map;
        QStringList row{QString::number(i + 1)};
        for (int k = 0; k < Dim * Dim; ++k)
            row << number(map.linear(k / Dim, k % Dim));
        for (const double shift : map.translation)
            row << number(shift);
        table.rows.push_back(row << QString::number(probabilities[i], 'g', 4));
    }
    if (system.maps.size() > maxMaps)
        table.rows.push_back(
            {QStringLiteral("…"), Text::tr("%n more maps", nullptr, int(system.maps.size() - maxMaps))});
    return table;
}
template PrintedTable coefficientTable(const document::System2& system);
template PrintedTable coefficientTable(const document::System3& system);

PrintedTable cornerTable(const ifs::ControlCage<3>& cage) {
    PrintedTable table{{Text::tr("Cage"), QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")}, {}};
    for (std::size_t k = 0; k < cage.current.size(); ++k) {
        QStringList row{QString::number(k + 1)};
        for (const double value : cage.current[k])
            row << QString::number(value == 0 ? 0.0 : value, 'g', 8);
        table.rows.push_back(row);
    }
    return table;
}

QFont printedFont(const QPainter& painter, double pixels, bool bold) {
    QFont font = painter.font();
    font.setPixelSize(std::max(1, int(pixels)));
    font.setBold(bold);
    return font;
}

Printed paintTable(QPainter& painter, const QRectF& room, double minHeight, const PrintedTable& table,
                   std::size_t first) {
    std::span<const QStringList> rows = std::span(table.rows).subspan(first);
    rows = rows.first(std::min(rows.size(), std::size_t(std::max(0.0, room.height() / minHeight - 1))));
    const double rowHeight = std::min(room.height() / double(rows.size() + 1), room.width() / 32);
    constexpr double narrow = 0.4; // column of row numbers
    const double columnWidth = room.width() / (double(table.names.size()) - 1 + narrow);
    double pixels = 0.7 * rowHeight;
    painter.setFont(printedFont(painter, pixels, false));
    double widest = 0;
    for (const QStringList& row : rows)
        for (const QString& text : row)
            widest = std::max(widest, QFontMetricsF(painter.font()).horizontalAdvance(text));
    pixels *= std::min(1.0, 0.92 * columnWidth / std::max(widest, 1.0));
    for (std::size_t i = 0; i <= rows.size(); ++i) {
        const QStringList& row = i == 0 ? table.names : rows[i - 1];
        for (qsizetype j = 0; j < row.size(); ++j) {
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
    return {rows.size(), room.top() + rowHeight * double(rows.size() + 1)};
}

document::Fractal onPaper(document::Fractal fractal) {
    attractor::Appearance& look = fractal.appearance;
    if (look.background.alpha == 255 && lightness(look.background) > 0.5) return fractal;
    look.background = {255, 255, 255, 255};
    // True for solids, whose ink depends on the light and needs their colour.
    const bool isSolid = document::space(fractal) && !attractor::showsCloud(fractal.inSpace.look);
    if (!isSolid && lightness(look.plain) > 0.5) look.plain = {20, 20, 20, 255};
    const auto& stops = look.palette.stops;
    const attractor::Palette* ink = attractor::findPalette("Ink");
    if (ink && !isSolid && !stops.empty() && lightness(stops.back().colour) > lightness(stops.front().colour))
        look.palette = *ink;
    return fractal;
}

QImage drawnForPaper(const io::PlaneExport& picture, QWidget* parent) {
    return drawn(io::drawBeside(picture), parent);
}

QImage drawnForPaper(const io::SpaceExport& picture, QWidget* parent) {
    return drawn(io::drawBeside(picture), parent);
}

attractor::OrbitCamera standardView() {
    constexpr double azimuth = 30, elevation = 20;
    attractor::OrbitCamera camera;
    camera.orientation = attractor::orbit(azimuth, elevation);
    return camera;
}

io::SpaceExport spacePicture(const document::Fractal& fractal, attractor::OrbitCamera camera, int longSide) {
    io::SpaceRecipe recipe;
    camera.size.width = std::max(1, camera.size.width);
    camera.size.height = std::max(1, camera.size.height);
    recipe.camera = camera;
    const double factor = double(longSide) / std::max(camera.size.width, camera.size.height);
    recipe.size = {std::max(1, int(camera.size.width * factor)),
                   std::max(1, int(camera.size.height * factor))};
    return io::exportOf(recipe, onPaper(fractal));
}

QImage withoutEmptySides(const QImage& picture, QRgb ground) {
    const QImage pixels = picture.convertToFormat(QImage::Format_ARGB32_Premultiplied);
    QRect shown;
    for (int y = 0; y < pixels.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(pixels.constScanLine(y));
        const auto isDrawn = [ground](QRgb pixel) { return pixel != ground; };
        const auto* end = row + pixels.width();
        const auto* first = std::find_if(row, end, isDrawn);
        if (first == end) continue;
        const auto* last = end - 1;
        while (!isDrawn(*last))
            --last;
        shown |= QRect(QPoint(int(first - row), y), QPoint(int(last - row), y));
    }
    if (shown.isEmpty()) return picture;
    const int margin = std::max(pixels.width(), pixels.height()) / 100;
    const QSize least = pixels.size() / 10;
    const QSize size = (shown.size() + QSize(2 * margin, 2 * margin)).expandedTo(least);
    QRect kept(QPoint(0, 0), size);
    kept.moveCenter(shown.center());
    return picture.copy(kept & pixels.rect());
}

} // namespace view
