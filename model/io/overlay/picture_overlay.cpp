// SPDX-License-Identifier: MIT
#include "io/overlay/picture_overlay.h"

#include "document/maps/map_handles.h"
#include "ifs/extent/convex_hull.h"

#include <QPainter>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace io {

namespace {

QColor colourOf(const attractor::Rgba& colour) {
    return {colour.red, colour.green, colour.blue};
}

QPointF middleOf(const QPolygonF& polygon) {
    QPointF sum;
    for (const QPointF& point : polygon)
        sum += point;
    return sum / double(std::max<qsizetype>(1, polygon.size()));
}

// Shapes in the order in which they lie on each other.
class Shapes {
public:
    Shapes(const document::Fractal& fractal, const attractor::Camera& camera, const PictureOverlay& overlay,
           const document::MapFaces& faces)
        : m_camera(camera), m_width(std::max(1.5, std::min(camera.width, camera.height) / 500.0)) {
        m_ink = inkOn(fractal.appearance.background);
        m_halo = haloOn(fractal.appearance.background);
        if (overlay.maps || overlay.fixedPoints || overlay.numbers) findMaps(fractal, faces);
        if (overlay.maps) std::ranges::for_each(m_maps, [this](const Map& map) { addMap(map); });
        if (overlay.hull) addHull(fractal);
        if (overlay.cage) {
            OverlayMarks cage = cageMarks(fractal, camera, overlay.isCageInked ? m_ink : cageColour());
            if (!overlay.showsRest) cage.erase(cage.begin(), cage.end() - 1);
            std::ranges::move(cage, std::back_inserter(m_marks));
        }
        for (const Map& map : m_maps)
            if (overlay.fixedPoints && map.hasFixedPoint) addFixedPoint(map);
        for (const Map& map : m_maps)
            if (overlay.numbers && map.number > 0) addNumber(map);
    }

    OverlayMarks taken() { return std::move(m_marks); }

private:
    struct Map {
        std::size_t number = 0; // 1-based; 0: none
        QPolygonF image;        // image of the cage
        QColor colour;
        bool takesPart = true;
        bool hasFixedPoint = false;
        QPointF fixedPoint;
    };
    void findMaps(const document::Fractal& fractal, const document::MapFaces& faces);
    void addMap(const Map& map);
    void addHull(const document::Fractal& fractal);
    void addFixedPoint(const Map& map);
    void addNumber(const Map& map);
    void addPolygon(const QPolygonF& polygon, const QColor& stroke, double width);
    void addDisc(const QPointF& centre, double radius, const QColor& fill, const QColor& stroke,
                 double width);
    QPointF onScreen(const ifs::Vector<2>& displayed) const;

    attractor::Camera m_camera;
    std::vector<Map> m_maps;
    QColor m_ink, m_halo; // colours for the background
    double m_width = 1;   // pixels; width of a line
    OverlayMarks m_marks;
};

QPointF Shapes::onScreen(const ifs::Vector<2>& displayed) const {
    const ifs::Vector<2> pixel = toPixel(m_camera, displayed);
    return {pixel.x(), pixel.y()};
}

void Shapes::findMaps(const document::Fractal& fractal, const document::MapFaces& faces) {
    const document::MapHandles handles(std::make_shared<document::Fractal>(fractal),
                                       document::effectiveCage(fractal));
    const ifs::Placement placement = document::placement(fractal);
    const auto& maps = handles.maps();
    const std::vector<double> probabilities = ifs::probabilities(*document::system2(fractal));
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const document::MapFace face =
            i < faces.size() ? faces[i]
                             : document::MapFace{mapColour(fractal.appearance, maps[i].id, i), i + 1};
        Map map{face.number, {}, colourOf(face.colour), probabilities[i] > 0, false, {}};
        for (const ifs::Vector<2>& corner : handles.outline(i))
            map.image << onScreen(corner);
        if (const auto point = ifs::fixedPoint(maps[i].map)) {
            map.hasFixedPoint = true;
            map.fixedPoint = onScreen(placement(*point));
        }
        m_maps.push_back(std::move(map));
    }
}

void Shapes::addPolygon(const QPolygonF& polygon, const QColor& stroke, double width) {
    OverlayMark mark;
    mark.polygon = polygon;
    mark.stroke = stroke;
    mark.width = width;
    m_marks.push_back(std::move(mark));
}

void Shapes::addDisc(const QPointF& centre, double radius, const QColor& fill, const QColor& stroke,
                     double width) {
    OverlayMark mark;
    mark.centre = centre;
    mark.radius = radius;
    mark.fill = fill;
    mark.stroke = stroke;
    mark.width = width;
    m_marks.push_back(std::move(mark));
}

// Within a tenth of a pixel, and bent with the cage.
void Shapes::addHull(const document::Fractal& fractal) {
    constexpr int parts = 16; // parts of a bent edge
    const auto support = document::supportFunction(fractal);
    if (!support) return;
    const ifs::Placement placement = document::placement(fractal);
    const double size = std::max(1e-300, ifs::spectralNorm(placement.affine().linear));
    const auto hull = ifs::convexHull(*support, 0.1 / (size * m_camera.pixelsPerUnit));
    const int steps = placement.bend() ? parts : 1;
    QPolygonF polygon;
    for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
        const ifs::Vector<2>& from = hull.vertices[i];
        const ifs::Vector<2> edge = hull.vertices[(i + 1) % hull.vertices.size()] - from;
        for (int k = 0; k < steps; ++k)
            polygon << onScreen(placement(from + edge * (double(k) / steps)));
    }
    addPolygon(polygon, m_halo, 2 * m_width);
    addPolygon(polygon, m_ink, m_width);
}

void Shapes::addMap(const Map& map) {
    QColor tint = map.colour;
    tint.setAlphaF(0.08F);
    addPolygon(map.image, m_halo, 2 * m_width);
    m_marks.back().fill = tint;
    addPolygon(map.image, map.colour, m_width);
    if (!map.takesPart) m_marks.back().dashes = {4, 3};
}

void Shapes::addFixedPoint(const Map& map) {
    const double radius = 3 * m_width;
    addDisc(map.fixedPoint, radius, map.colour, m_halo, m_width);
    addDisc(map.fixedPoint, radius + m_width / 2, {}, m_ink, m_width / 2);
}

void Shapes::addNumber(const Map& map) {
    const double radius = 7.5 * m_width;
    const QPointF middle = middleOf(map.image);
    addDisc(middle, radius, map.colour, m_halo, m_width);
    OverlayMark digits;
    digits.centre = middle;
    digits.word = QString::number(map.number);
    digits.letterSize = radius * (digits.word.size() < 3 ? 1.1 : 0.8);
    digits.fill = qGray(map.colour.rgb()) > 130 ? QColor(14, 18, 26) : QColor(250, 252, 255);
    m_marks.push_back(std::move(digits));
}

} // namespace

OverlayMarks overlayMarks(const document::Fractal& fractal, const attractor::Camera& camera,
                          const PictureOverlay& overlay, const document::MapFaces& faces) {
    return Shapes(fractal, camera, overlay, faces).taken();
}

std::vector<ifs::Vector<2>> overlayPoints(const document::Fractal& fractal, const PictureOverlay& overlay) {
    if (!overlay.cage && !overlay.maps) return {};
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    std::vector<ifs::Vector<2>> points = cage.current;
    const auto add = [&points](const std::vector<ifs::Vector<2>>& more) {
        points.insert(points.end(), more.begin(), more.end());
    };
    if (overlay.cage && overlay.showsRest) add(cage.rest);
    const document::MapHandles maps(std::make_shared<document::Fractal>(fractal), cage);
    for (std::size_t i = 0; overlay.maps && i < maps.count(); ++i)
        add(maps.outline(i));
    return points;
}

QImage imageOver(std::span<std::uint32_t> pixels, int width) {
    return {reinterpret_cast<uchar*>(pixels.data()), width, int(pixels.size() / std::size_t(width)),
            qsizetype(width) * 4, QImage::Format_ARGB32_Premultiplied};
}

QImage imageOver(std::span<attractor::Rgba16> pixels, int width) {
    return {reinterpret_cast<uchar*>(pixels.data()), width, int(pixels.size() / std::size_t(width)),
            qsizetype(width) * 8, QImage::Format_RGBA64};
}

void paintOverlay(QImage& rows, const OverlayMarks& marks, int firstRow) {
    QPainter painter(&rows);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.translate(0, -firstRow);
    paint(painter, marks);
}

} // namespace io
