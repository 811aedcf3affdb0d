// SPDX-License-Identifier: MIT
#include "canvas/marks/address_walk.h"

#include "canvas/geometry/canvas_geometry.h"
#include "canvas/scene/canvas_scene.h"
#include "document/fractal/fractal_geometry.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace view {

namespace {

constexpr int piecesOfEdge = 12; // pieces of an edge if the cage bends
constexpr double minNamed = 26;  // pixels; words would hide smaller images
constexpr int letterSize = 12;
constexpr double maxCoordinate = 1e6; // pixels; QPainter overflows beyond, as in a deep zoom

QString subscript(int number) {
    static const QString digits = QStringLiteral("₀₁₂₃₄₅₆₇₈₉");
    QString text;
    for (const QChar digit : QString::number(number))
        text += digits[digit.digitValue()];
    return text;
}

QPolygonF nearView(QPolygonF polygon) {
    for (QPointF& point : polygon)
        point = {std::clamp(point.x(), -maxCoordinate, maxCoordinate),
                 std::clamp(point.y(), -maxCoordinate, maxCoordinate)};
    return polygon;
}

void paintWord(QPainter& painter, const OverlayStyle& style, const QPolygonF& image, const QString& word) {
    const QRectF box = image.boundingRect();
    QFont font = painter.font();
    font.setPixelSize(letterSize);
    font.setBold(true);
    painter.setFont(font);
    const QSizeF size = QFontMetricsF(font).size(Qt::TextSingleLine, word) + QSizeF(8, 2);
    // Outside the highest corner, which separates the words of nested images.
    const QPointF top = *std::ranges::min_element(image, {}, &QPointF::y);
    const QRectF room(
        QPointF(std::clamp(top.x() - size.width() / 2, box.left(), box.right()), top.y() - size.height() - 3),
        size);
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.noteBackground);
    painter.drawRoundedRect(room, 3, 3);
    painter.setPen(style.noteText);
    painter.drawText(room, Qt::AlignCenter, word);
}

} // namespace

std::vector<std::vector<ifs::Vector<2>>> addressWalk(const document::Fractal& fractal,
                                                     const ifs::Word& word) {
    const document::System2* system = document::system2(fractal);
    if (!system) return {};
    const std::vector<ifs::Vector<2>> cage = document::effectiveCage(fractal).rest;
    const ifs::Placement placement = document::placement(fractal);
    const int pieces = placement.bend() ? piecesOfEdge : 1;
    std::vector<std::vector<ifs::Vector<2>>> walk;
    ifs::AffineMap<2> map;
    for (const int symbol : word) {
        if (symbol < 0 || std::size_t(symbol) >= system->maps.size()) break;
        map = map * system->maps[std::size_t(symbol)].map;
        std::vector<ifs::Vector<2>> image;
        for (std::size_t j = 0; j < cage.size(); ++j) {
            const ifs::Vector<2> edge = cage[(j + 1) % cage.size()] - cage[j];
            for (int k = 0; k < pieces; ++k)
                image.push_back(placement(map(cage[j] + edge * (double(k) / pieces))));
        }
        walk.push_back(std::move(image));
    }
    return walk;
}

void AddressWalk::paintOver(QPainter& painter, const CanvasScene& canvas, const OverlayStyle& style) {
    const document::Fractal& fractal = canvas.document().fractal();
    const document::System2* system = document::system2(fractal);
    std::vector<ifs::Polygon> walk;
    ifs::Word word;
    if (canvas.handles().target() == HandleTarget::Branch) {
        word = canvas.handles().branch();
        walk = addressWalk(fractal, word);
    } else {
        for (const document::OutlineShape* cylinder : canvas.marks().cylinderWalk()) {
            walk.push_back(cylinder->points);
            word.push_back(cylinder->listed.back());
        }
    }
    std::vector<QPolygonF> images;
    for (std::size_t k = 0; k < walk.size(); ++k) {
        const auto index = std::size_t(word[k]);
        if (!system || index >= system->maps.size()) break; // maps removed since the analysis
        images.push_back(nearView(pixelsOf(canvas.camera(), walk[k])));
        const attractor::Rgba face = mapColour(fractal.appearance, system->maps[index].id, index);
        const QColor colour(face.red, face.green, face.blue);
        const bool isLast = k + 1 == walk.size();
        QPainterPath path;
        path.addPolygon(images.back());
        path.closeSubpath();
        if (isLast) {
            QColor fill = colour;
            fill.setAlphaF(0.28F);
            painter.fillPath(path, fill);
        }
        strokeWithHalo(painter, path, style, colour, isLast ? 2.5 : 1.5);
    }
    QString name;
    for (std::size_t k = 0; k < images.size(); ++k) {
        name += u'w' + subscript(word[k] + 1);
        const QRectF box = images[k].boundingRect();
        if (std::max(box.width(), box.height()) >= minNamed) paintWord(painter, style, images[k], name);
    }
}

} // namespace view
