// SPDX-License-Identifier: MIT
#include "io/picture/vector/shape_preview.h"

#include "io/picture/vector/svg_shapes.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace io {

namespace {

constexpr std::uint64_t maxCopies = 50'000;
constexpr std::uint64_t maxDots = 200'000;

QColor colourOf(const attractor::Rgba& colour) {
    return {colour.red, colour.green, colour.blue, colour.alpha};
}

QPolygonF polygon(const Ring& ring, const ifs::AffineMap<2>& map) {
    QPolygonF corners;
    for (const auto& point : ring) {
        const ifs::Vector<2> at = map(point);
        corners << QPointF(at.x(), at.y());
    }
    return corners;
}

// A depth that is drawn without a long wait.
int previewDepth(const ifs::CopyHierarchy& levels, const SvgFormat& format) {
    int depth = std::min(svgDepth(levels, format), levels.deepest());
    while (depth > 0 && levels.references(depth) > maxCopies)
        --depth;
    return depth;
}

class Preview {
public:
    Preview(const document::Fractal& fractal, const attractor::Camera& camera, const std::stop_token& stop)
        : m_fractal(fractal),
          m_camera(camera),
          m_stop(stop),
          m_image(camera.width, camera.height, QImage::Format_ARGB32_Premultiplied) {
        m_image.fill(Qt::transparent);
    }

    QImage draw(const ifs::CopyHierarchy& levels, const SvgFormat& format) {
        QPainter painter(&m_image);
        painter.setRenderHint(QPainter::Antialiasing);
        if (format.style != ShapeStyle::Outline)
            painter.fillRect(m_image.rect(), colourOf(m_fractal.appearance.background));
        if (format.style == ShapeStyle::Outline) {
            painter.setPen(Qt::black);
            for (const Ring& ring : leafUnion(levels, previewDepth(levels, format), m_stop))
                painter.drawPolygon(polygon(ring, {}));
        } else {
            if (const auto shadow = shapeShadow(m_fractal, m_camera))
                drawShadow(painter, *shadow, levels, format);
            drawShapes(painter, m_fractal, levels.display(), levels, format);
        }
        painter.end();
        if (format.cage == CageVisibility::Shown)
            paintCage(m_image, m_fractal, m_camera, groundOf(m_fractal, format));
        return m_image;
    }

private:
    void drawShadow(QPainter& painter, const ShapeShadow& shadow, const ifs::CopyHierarchy& levels,
                    const SvgFormat& format) {
        QImage layer(m_image.size(), m_image.format());
        layer.fill(Qt::transparent);
        QPainter onLayer(&layer);
        onLayer.setRenderHint(QPainter::Antialiasing);
        drawShapes(onLayer, shadow.fractal, shadow.map * levels.display(), levels, format);
        onLayer.end();
        painter.setOpacity(shadow.opacity);
        painter.drawImage(0, 0, layer);
        painter.setOpacity(1);
    }

    void drawShapes(QPainter& painter, const document::Fractal& fractal, const ifs::AffineMap<2>& display,
                    const ifs::CopyHierarchy& levels, const SvgFormat& format) {
        if (format.style == ShapeStyle::Structured) {
            drawCopies(painter, fractal, display, levels, previewDepth(levels, format));
            return;
        }
        for (const auto& [colour, points] :
             shapePoints(fractal, m_camera, std::min(format.points, maxDots), format.seed)) {
            painter.setPen(QPen(colourOf(colour), 1, Qt::SolidLine, Qt::RoundCap));
            for (const auto& point : points)
                painter.drawPoint(QPointF(point.x(), point.y()));
        }
    }

    void drawCopies(QPainter& painter, const document::Fractal& fractal, const ifs::AffineMap<2>& display,
                    const ifs::CopyHierarchy& levels, int depth) {
        m_outline = levels.outline(depth);
        m_copies.clear();
        for (int level = 0; level <= depth; ++level)
            m_copies.push_back(level == 0 ? std::vector<ifs::Copy>() : levels.copies(level, depth));
        const attractor::Rgba all = shapeColour(fractal.appearance);
        painter.setPen(Qt::NoPen);
        for (const ifs::Copy& copy : levels.picture(depth)) {
            painter.setBrush(colourOf(shapeColour(fractal, levels, copy).value_or(all)));
            drawCopy(painter, levels, copy, display * copy.map);
        }
    }

    // Draws a copy; `map` takes its original to pixels.
    void drawCopy(QPainter& painter, const ifs::CopyHierarchy& levels, const ifs::Copy& copy,
                  const ifs::AffineMap<2>& map) {
        if (m_stop.stop_requested()) return;
        if (copy.projection) {
            for (const Ring& bar : levels.projection(*copy.projection)->bars)
                painter.drawPolygon(polygon(bar, map));
        } else if (copy.level == 0) {
            painter.drawPolygon(polygon(m_outline, map));
        } else {
            for (const ifs::Copy& inner : m_copies.at(std::size_t(copy.level)))
                drawCopy(painter, levels, inner, map * inner.map);
        }
    }

    const document::Fractal& m_fractal;
    const attractor::Camera& m_camera;
    const std::stop_token& m_stop;
    QImage m_image;
    Ring m_outline;                               // level 0
    std::vector<std::vector<ifs::Copy>> m_copies; // copies by level
};

} // namespace

std::optional<QImage> shapePreview(const document::Fractal& fractal, const attractor::Camera& camera,
                                   const SvgFormat& format, const std::stop_token& stop) {
    const ShapeLevels levels = shapeLevels(fractal, camera);
    if (!levels.levels) return std::nullopt;
    const QImage image = Preview(fractal, camera, stop).draw(*levels.levels, format);
    return stop.stop_requested() || image.isNull() ? std::nullopt : std::optional(image);
}

} // namespace io
