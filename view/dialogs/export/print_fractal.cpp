// SPDX-License-Identifier: MIT
#include "dialogs/export/print_fractal.h"

#include "canvas/geometry/canvas_geometry.h"
#include "dialogs/export/print_preview.h"
#include "dialogs/export/printed_parts.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"
#include "document/text/user_comments.h"
#include "io/export_job.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace view {

namespace {

constexpr double maxShare = 0.62; // share of the page for the picture
constexpr int linesOnPage = 60;
constexpr double wholeWidth = 8; // columns of a table as wide as the page
constexpr int longSide = 2400;   // pixels of the longer side

// The withoutMargins() of a view that is turned: there the box around the box counts.
attractor::Camera withoutTurnedMargins(const document::Box& box, attractor::Camera camera) {
    constexpr double margin = 0.01;   // share of the canvas
    constexpr double narrowest = 0.1; // share of the canvas
    const QRectF room(0, 0, camera.width, camera.height);
    const QRectF shown = pixelsOf(camera, box.min, box.max)
                             .adjusted(-margin * camera.width, -margin * camera.height, margin * camera.width,
                                       margin * camera.height);
    const QRectF kept = shown.intersected(room);
    if (kept.isEmpty()) return camera; // nothing in view
    camera.centre = worldAt(camera, kept.center());
    camera.width = std::max(1, int(std::lround(std::max(kept.width(), narrowest * room.width()))));
    camera.height = std::max(1, int(std::lround(std::max(kept.height(), narrowest * room.height()))));
    return camera;
}

// The view of the canvas without its empty sides, which are the cage's.
attractor::Camera withoutMargins(const document::Fractal& fractal, attractor::Camera camera) {
    const auto box = document::boxWithShadow(fractal, camera.yAxis);
    if (!box || camera.width < 1 || camera.height < 1) return camera;
    if (camera.rotation != 0) return withoutTurnedMargins(*box, camera);
    const ifs::Vector<2> half = ifs::Vector<2>(camera.width, camera.height) / (2 * camera.pixelsPerUnit);
    constexpr double margin = 0.02;
    constexpr double narrowest = 0.1; // share of the canvas, because a line has no width
    ifs::Vector<2> low = (camera.centre - half).cwiseMax(box->min - margin * half);
    ifs::Vector<2> high = (camera.centre + half).cwiseMin(box->max + margin * half);
    if (!((high - low).minCoeff() > 0)) return camera; // nothing in view
    const ifs::Vector<2> size = (high - low).cwiseMax(2 * narrowest * half);
    camera.centre = (low + high) / 2;
    camera.width = std::max(1, int(std::lround(size.x() * camera.pixelsPerUnit)));
    camera.height = std::max(1, int(std::lround(size.y() * camera.pixelsPerUnit)));
    return camera;
}

io::PlaneExport pictureFor(const document::Fractal& fractal, attractor::Camera camera) {
    const double factor = double(longSide) / std::max({1, camera.width, camera.height});
    camera.width = std::max(1, int(camera.width * factor));
    camera.height = std::max(1, int(camera.height * factor));
    camera.pixelsPerUnit *= factor;
    const document::Fractal printed = onPaper(fractal);
    io::PlaneExport picture{printed, document::renderRequest(printed, camera), {}};
    picture.request.threads = io::threadsOfThisMachine();
    picture.request.samples = 50ull * std::uint64_t(camera.width) * std::uint64_t(camera.height);
    return picture;
}

// Tables of the displayed system or, if no maps have that picture, of the picture at rest.
std::pair<std::vector<PrintedTable>, bool> tablesOf(const document::Fractal& fractal) {
    if (const auto* system = document::system2(fractal)) {
        const auto displayed = document::effectiveSystem(fractal);
        return {{coefficientTable<2>(displayed ? *displayed : *system)}, !displayed};
    }
    const auto* system = document::system3(fractal);
    if (!system) return {};
    const auto displayed = document::effectiveSystem<3>(fractal);
    std::vector<PrintedTable> tables{coefficientTable<3>(displayed ? *displayed : *system)};
    if (const auto cage = document::spaceCage(fractal)) tables.push_back(cornerTable(*cage));
    return {tables, !displayed};
}

// Paints tables one below the other, from `top` on.
void paintTables(QPainter& painter, const QRectF& page, double top, const std::vector<PrintedTable>& tables,
                 const std::function<void()>& newPage) {
    const double line = page.height() / linesOnPage;
    std::size_t lines = 0; // remaining lines, with an empty one behind each table
    for (const PrintedTable& table : tables)
        lines += table.rows.size() + 2;
    QRectF room(QPointF(page.left(), top), page.bottomRight());
    for (const PrintedTable& table : tables) {
        const auto own = double(table.rows.size() + 1);
        const bool isFirst = &table == &tables.front();
        if (!isFirst && room.height() < own * line && page.height() > 0) {
            newPage();
            room = page;
        }
        // Reserves a share of a large page for the following lines.
        const double share = room.height() * own / double(lines - 1);
        QRectF place = share < own * line ? room : QRectF(room.topLeft(), QSizeF(room.width(), share));
        // Limits the width, because wide columns of few numbers are hard to read across.
        const double width = std::min(1.0, double(table.names.size()) / wholeWidth) * page.width();
        place.setWidth(width);
        Printed printed = paintTable(painter, place, line, table, 0);
        std::size_t done = printed.rows;
        while (done < table.rows.size() && page.height() > 0) { // ends even for paper without height
            newPage();
            room = page;
            printed =
                paintTable(painter, QRectF(page.topLeft(), QSizeF(width, page.height())), line, table, done);
            done += printed.rows;
        }
        room.setTop(std::min(printed.bottom + line, page.bottom()));
        lines -= table.rows.size() + 2;
    }
}

void showPreview(const document::Fractal& fractal, const QImage& picture, QWidget* parent,
                 const PrintSaid& said) {
    const auto paint = [fractal, picture](QPainter& painter, const QRectF& page,
                                          const std::function<void()>& newPage) {
        paintPages(painter, page, fractal, picture, newPage);
    };
    showPrintPreview({Text::tr("Print “%1”").arg(fractal.name), fractal.name, paint}, parent, said);
}

} // namespace

void paintPages(QPainter& painter, const QRectF& page, const document::Fractal& fractal,
                const QImage& picture, const std::function<void()>& newPage) {
    const double line = page.height() / 30;
    painter.setPen(Qt::black);
    painter.setFont(printedFont(painter, 0.7 * line, true));
    painter.drawText(QRectF(page.topLeft(), QSizeF(page.width(), line)), Qt::AlignLeft | Qt::AlignVCenter,
                     fractal.name);
    double top = page.top() + 1.2 * line;
    painter.setFont(printedFont(painter, 0.4 * line, false));
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
    const auto [tables, areAtRest] = tablesOf(fractal);
    if (tables.empty()) return;
    double under = frame.bottom() + 0.7 * line;
    if (areAtRest) {
        painter.drawText(
            QRectF(page.left(), under, page.width(), 0.6 * line), Qt::AlignCenter,
            Text::tr("The cage bends or flattens the picture. The numbers describe the picture at rest."));
        under += line;
    }
    paintTables(painter, page, under, tables, newPage);
}

void printFractal(document::Document* document, const attractor::Camera& camera, QWidget* parent,
                  const PrintSaid& said) {
    // The document may change while the picture is drawn.
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    const document::Fractal fractal = document->fractal();
    const QImage picture = drawnForPaper(pictureFor(fractal, withoutMargins(fractal, camera)), parent);
    if (!picture.isNull()) showPreview(fractal, picture, parent, said);
}

void printFractal(document::Document* document, const attractor::OrbitCamera& camera, QWidget* parent,
                  const PrintSaid& said) {
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    const document::Fractal fractal = document->fractal();
    const QImage picture = drawnForPaper(spacePicture(fractal, camera, longSide), parent);
    if (picture.isNull()) return;
    const attractor::Rgba ground = document::backgroundInSpace(onPaper(fractal));
    const QRgb colour = qRgba(ground.red, ground.green, ground.blue, ground.alpha);
    showPreview(fractal, withoutEmptySides(picture, qPremultiply(colour)), parent, said);
}

} // namespace view
