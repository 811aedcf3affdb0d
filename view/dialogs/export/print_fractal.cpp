// SPDX-License-Identifier: MIT
#include "dialogs/export/print_fractal.h"

#include "document/fractal_geometry.h"
#include "document/user_comments.h"
#include "io/export_job.h"
#include "widgets/tooltip_text.h"
#include "widgets/wait_for.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrinter>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>

namespace view {

namespace {

constexpr int columns = 8;
constexpr double maxShare = 0.62; // of the page for the picture
constexpr int linesOnPage = 60;
constexpr std::size_t maxMaps = 1000; // nobody reads more on paper

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

using Row = std::array<QString, columns>;

std::vector<Row> coefficientRows(const document::System2& system) {
    std::vector<Row> rows;
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

QFont sized(const QPainter& painter, double pixels, bool bold) {
    QFont font = painter.font();
    font.setPixelSize(std::max(1, int(pixels)));
    font.setBold(bold);
    return font;
}

// As many rows as are legible in the room, under their names; returns how many.
std::size_t paintTable(QPainter& painter, const QRectF& room, double minHeight, std::span<const Row> rows) {
    const Row names{QString(),           QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"),
                    QStringLiteral("d"), QStringLiteral("e"), QStringLiteral("f"), QStringLiteral("p")};
    rows = rows.first(std::min(rows.size(), std::size_t(std::max(0.0, room.height() / minHeight - 1))));
    const double rowHeight = std::min(room.height() / double(rows.size() + 1), room.width() / 32);
    constexpr double narrow = 0.4; // the numbers of the maps
    const double columnWidth = room.width() / (columns - 1 + narrow);
    double pixels = 0.7 * rowHeight;
    painter.setFont(sized(painter, pixels, false));
    double widest = 0;
    for (const Row& row : rows)
        for (const QString& text : row)
            widest = std::max(widest, QFontMetricsF(painter.font()).horizontalAdvance(text));
    pixels *= std::min(1.0, 0.92 * columnWidth / std::max(widest, 1.0));
    for (std::size_t i = 0; i <= rows.size(); ++i) {
        const Row& row = i == 0 ? names : rows[i - 1];
        for (std::size_t j = 0; j < columns; ++j) {
            const double left = j == 0 ? 0 : columnWidth * (double(j) - 1 + narrow);
            painter.setFont(sized(painter, pixels, i == 0 || j == 0));
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

double lightness(const attractor::Rgba& colour) {
    return (0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue) / 255;
}

// The look on paper: a dark screen would drown the page in ink, and what glows on it would be pale on white.
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

// What the canvas shows without its empty sides, which are the cage's.
attractor::Camera withoutMargins(const document::Fractal& fractal, attractor::Camera camera) {
    const auto box = document::displayedBox(fractal);
    if (!box || camera.width < 1 || camera.height < 1) return camera;
    const ifs::Vector<2> half = ifs::Vector<2>(camera.width, camera.height) / (2 * camera.pixelsPerUnit);
    constexpr double margin = 0.02;
    constexpr double narrowest = 0.1; // of the canvas: a line has no width
    ifs::Vector<2> low = (camera.centre - half).cwiseMax(box->min - margin * half);
    ifs::Vector<2> high = (camera.centre + half).cwiseMin(box->max + margin * half);
    if (!((high - low).minCoeff() > 0)) return camera; // nothing is in view
    const ifs::Vector<2> size = (high - low).cwiseMax(2 * narrowest * half);
    camera.centre = (low + high) / 2;
    camera.width = std::max(1, int(std::lround(size.x() * camera.pixelsPerUnit)));
    camera.height = std::max(1, int(std::lround(size.y() * camera.pixelsPerUnit)));
    return camera;
}

io::PngExport pictureFor(const document::Fractal& fractal, attractor::Camera camera) {
    constexpr int longSide = 2400;
    const double factor = double(longSide) / std::max({1, camera.width, camera.height});
    camera.width = std::max(1, int(camera.width * factor));
    camera.height = std::max(1, int(camera.height * factor));
    camera.pixelsPerUnit *= factor;
    const document::Fractal printed = onPaper(fractal);
    io::PngExport picture{printed, document::renderRequest(printed, camera), {}};
    picture.request.threads = io::threadsOfThisMachine();
    picture.request.samples = 50ull * std::uint64_t(camera.width) * std::uint64_t(camera.height);
    return picture;
}

// Null when the user has changed their mind, or closed the window.
QImage drawn(const io::PngExport& picture, QWidget* parent) {
    QFuture<QImage> drawing = io::drawBeside(picture);
    if (!waitFor(QFuture<void>(drawing), Text::tr("Drawing the picture…"), parent)) return {};
    return drawing.takeResult();
}

} // namespace

void paintPages(QPainter& painter, const QRectF& page, const document::Fractal& fractal,
                const QImage& picture, const std::function<void()>& newPage) {
    const double line = page.height() / 30;
    painter.setPen(Qt::black);
    painter.setFont(sized(painter, 0.7 * line, true));
    painter.drawText(QRectF(page.topLeft(), QSizeF(page.width(), line)), Qt::AlignLeft | Qt::AlignVCenter,
                     fractal.name);
    double top = page.top() + 1.2 * line;
    painter.setFont(sized(painter, 0.4 * line, false));
    constexpr qsizetype maxComments = 3;
    const QStringList comments = document::userComments(fractal.comments);
    for (const QString& comment : comments.mid(0, maxComments)) {
        const QRectF room(page.left(), top, page.width(), 0.6 * line);
        painter.drawText(
            room, Qt::AlignLeft | Qt::AlignVCenter,
            QFontMetricsF(painter.font()).elidedText(comment.trimmed(), Qt::ElideRight, room.width()));
        top = room.bottom();
    }
    if (!comments.isEmpty()) top += 0.3 * line;
    QSizeF size = picture.size();
    size.scale(page.width(), maxShare * page.height(), Qt::KeepAspectRatio);
    const QRectF frame(QPointF(page.left() + (page.width() - size.width()) / 2, top), size);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(frame, picture);
    if (const auto* system = document::system2(fractal)) {
        const auto displayed = document::effectiveSystem(fractal);
        const std::vector<Row> rows = coefficientRows(displayed ? *displayed : *system);
        double under = frame.bottom() + 0.7 * line;
        if (!displayed) {
            painter.drawText(
                QRectF(page.left(), under, page.width(), 0.6 * line), Qt::AlignCenter,
                Text::tr(
                    "The cage bends or flattens the picture. The numbers describe the picture at rest."));
            under += line;
        }
        QRectF room(QPointF(page.left(), under), page.bottomRight());
        std::size_t done = 0;
        const auto paintMore = [&] {
            done += paintTable(painter, room, page.height() / linesOnPage, std::span(rows).subspan(done));
        };
        paintMore();
        while (done < rows.size() && page.height() > 0) { // paper without height would never end
            newPage();
            room = page;
            paintMore();
        }
    }
}

void printFractal(document::Document* document, const attractor::Camera& camera, QWidget* parent) {
    // The document may change while the picture is drawn.
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    const document::Fractal fractal = document->fractal();
    const QImage picture = drawn(pictureFor(fractal, withoutMargins(fractal, camera)), parent);
    if (picture.isNull()) return;
    const auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(fractal.name);
    auto* preview = new QPrintPreviewDialog(printer.get(), parent);
    preview->setAttribute(Qt::WA_DeleteOnClose);
    preview->setWindowTitle(Text::tr("Print “%1”").arg(titleText(fractal.name)));
    QObject::connect(preview, &QPrintPreviewDialog::paintRequested, preview,
                     [fractal, picture, printer](QPrinter* device) {
                         QPainter painter(device);
                         const QSizeF size = device->pageRect(QPrinter::DevicePixel).size();
                         paintPages(painter, QRectF(QPointF(0, 0), size), fractal, picture,
                                    [device] { device->newPage(); });
                     });
    preview->open();
}

} // namespace view
