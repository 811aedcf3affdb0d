// SPDX-License-Identifier: MIT
#include "io/picture/vector/svg_writer.h"

#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"
#include "ifs/copies/copy_merging.h"
#include "io/fractint/entry_writer.h"
#include "io/overlay/svg_overlay.h"
#include "io/picture/vector/svg_document.h"
#include "io/picture/vector/svg_shapes.h"
#include "io/text/number.h"

#include <QXmlStreamWriter>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr double goodEnough = 1;         // pixel
constexpr qsizetype maxPath = 9'900'000; // bytes: libxml2 refuses an attribute of ten million

const QString& svg = svgNamespace();

QString svgText(double number) {
    return QString::fromLatin1(formatNumber(number));
}

// SVG writes the matrix column by column.
QString svgText(const ifs::AffineMap<2>& map) {
    const auto& m = map.linear;
    return QStringLiteral("matrix(%1 %2 %3 %4 %5 %6)")
        .arg(svgText(m(0, 0)), svgText(m(1, 0)), svgText(m(0, 1)), svgText(m(1, 1)),
             svgText(map.translation.x()), svgText(map.translation.y()));
}

QString svgText(const attractor::Rgba& colour) {
    return QStringLiteral("#%1%2%3")
        .arg(colour.red, 2, 16, QLatin1Char('0'))
        .arg(colour.green, 2, 16, QLatin1Char('0'))
        .arg(colour.blue, 2, 16, QLatin1Char('0'));
}

template <typename Points> QString pointList(const Points& points) {
    QString list;
    for (const ifs::Vector<2>& p : points)
        list += (list.isEmpty() ? QString() : QStringLiteral(" ")) + svgText(p.x()) + QLatin1Char(',') +
                svgText(p.y());
    return list;
}

// Coordinates to a thousandth of a pixel.
QString pixels(const ifs::Vector<2>& point) {
    const auto rounded = [](double number) { return svgText(std::round(number * 1000) / 1000); };
    return rounded(point.x()) + QLatin1Char(' ') + rounded(point.y());
}

SvgPlan planOf(const document::Fractal& fractal, const ifs::CopyHierarchy& levels, const SvgFormat& format) {
    SvgPlan plan;
    plan.deepest = levels.deepest();
    plan.depth = svgDepth(levels, format);
    plan.references = std::max<std::uint64_t>(levels.references(plan.depth), 1);
    plan.errorInPixels = levels.error(plan.depth);
    plan.isCutShort = !format.depth && plan.errorInPixels > goodEnough && plan.depth < plan.deepest &&
                      levels.references(plan.depth + 1) > ifs::CopyHierarchy::comfortableReferences &&
                      levels.error(plan.depth + 1) < plan.errorInPixels;
    const ifs::ControlCage<2>* cage = document::cage2(fractal);
    plan.unbent = cage && ifs::bends(*cage);
    return plan;
}

class Writer {
public:
    Writer(const document::Fractal& fractal, const attractor::Camera& camera, const SvgFormat& format)
        : m_fractal(fractal), m_camera(camera), m_format(format), m_xml(&m_bytes) {}

    QByteArray structured(const ifs::CopyHierarchy& levels, int depth) {
        return picture([&] {
            const ifs::MergedCopies merged(levels, depth);
            writeDefinitions(levels, merged, depth);
            writeBackground();
            if (const auto shadow = shapeShadow(m_fractal, m_camera)) {
                startElement("g");
                attribute("id", QStringLiteral("shadow"));
                attribute("opacity", svgText(shadow->opacity));
                writeCopies(shadow->fractal, shadow->map * levels.display(), levels, merged);
                m_xml.writeEndElement();
            }
            startElement("g");
            attribute("id", QStringLiteral("attractor"));
            writeCopies(m_fractal, levels.display(), levels, merged);
            m_xml.writeEndElement();
        });
    }

    // Outlines for a cutter or plotter, without fills and background.
    QByteArray outline(const std::vector<Ring>& rings) {
        return picture([&] {
            QString path;
            for (const Ring& ring : rings) {
                QStringList corners;
                for (const auto& point : ring)
                    corners << pixels(point);
                path += QLatin1Char('M') + corners.join(QLatin1Char(' ')) + QLatin1Char('Z');
            }
            startPath(QStringLiteral("outline"), path, QStringLiteral("#000000"));
            attribute("stroke-linejoin", QStringLiteral("round"));
        });
    }

    QByteArray points() {
        return picture([&] {
            writeBackground();
            if (const auto shadow = shapeShadow(m_fractal, m_camera)) {
                startElement("g");
                attribute("id", QStringLiteral("shadow"));
                attribute("opacity", svgText(shadow->opacity));
                writePoints(shadow->fractal);
                m_xml.writeEndElement();
            }
            startElement("g");
            attribute("id", QStringLiteral("points"));
            writePoints(m_fractal);
            m_xml.writeEndElement();
        });
    }

private:
    void writePoints(const document::Fractal& fractal) {
        attribute("stroke-linecap", QStringLiteral("round")); // round ends: a line without length is a dot
        for (const ColouredPoints& group : shapePoints(fractal, m_camera, m_format.points, m_format.seed)) {
            QString path;
            for (const auto& point : group.points)
                path += QLatin1Char('M') + pixels(point) + QLatin1String("h0");
            startPath({}, path, svgText(group.colour));
        }
    }

    template <typename Content> QByteArray picture(const Content& content) {
        startSvg(
            m_xml,
            {{m_camera.width, m_camera.height}, m_format.dotsPerInch, m_fractal.name, writeEntry(m_fractal)});
        content();
        if (m_format.cage == CageVisibility::Shown) writeCage();
        if (m_format.overlay != PictureOverlay()) writeOverlay();
        m_xml.writeEndElement();
        m_xml.writeEndDocument();
        return m_bytes;
    }

    void startPath(const QString& id, const QString& path, const QString& colour) {
        m_xml.writeEmptyElement(svg, QStringLiteral("path"));
        if (!id.isEmpty()) attribute("id", id);
        attribute("d", path);
        attribute("fill", QStringLiteral("none"));
        attribute("stroke", colour);
        attribute("stroke-width", QStringLiteral("1"));
    }

    void attribute(const char* name, const QString& value) {
        m_xml.writeAttribute(QLatin1String(name), value);
    }
    void startElement(const char* name) { m_xml.writeStartElement(svg, QLatin1String(name)); }

    static QString levelId(int level) { return QStringLiteral("level-%1").arg(level); }
    // Permanent name of a projection in files.
    static QString projectionId(std::size_t i) { return QStringLiteral("projection-%1").arg(i + 1); }

    void writeDefinitions(const ifs::CopyHierarchy& levels, const ifs::MergedCopies& merged, int depth) {
        startElement("defs");
        for (const std::size_t i : merged.projections())
            writeProjection(i, *levels.projection(i));
        const ifs::Polygon outline = levels.outline(depth);
        for (const auto& [number, level] : merged.levels()) {
            if (number == 0) {
                m_xml.writeEmptyElement(svg, QStringLiteral("polygon"));
                attribute("id", levelId(0));
                attribute("points", pointList(outline));
            } else if (!level.pieces.empty()) {
                m_xml.writeEmptyElement(svg, QStringLiteral("path"));
                attribute("id", levelId(number));
                attribute("d", pathOf(levels, outline, level.pieces));
            } else {
                startElement("g");
                attribute("id", levelId(number));
                for (const ifs::Copy& copy : level.copies)
                    writeCopy(copy);
                m_xml.writeEndElement();
            }
        }
        m_xml.writeEndElement();
    }

    // Single path of all pieces, all counter-clockwise: overlaps are filled as well.
    static QString pathOf(const ifs::CopyHierarchy& levels, const ifs::Polygon& outline,
                          const std::vector<ifs::MergedCopies::Piece>& pieces) {
        std::vector<ifs::Polygon> polygons;
        for (const ifs::MergedCopies::Piece& piece : pieces) {
            const auto add = [&](ifs::Polygon polygon) {
                for (auto& corner : polygon)
                    corner = piece.map(corner);
                if (piece.map.linear.determinant() < 0) std::reverse(polygon.begin(), polygon.end());
                polygons.push_back(std::move(polygon));
            };
            if (!piece.projection)
                add(outline);
            else
                std::ranges::for_each(levels.projection(*piece.projection)->bars, add);
        }
        const int digits = digitsFor(polygons);
        QString path;
        for (const ifs::Polygon& polygon : polygons) {
            QStringList corners;
            for (const auto& corner : polygon)
                corners << shortNumber(corner.x(), digits) + u' ' + shortNumber(corner.y(), digits);
            path += QLatin1Char('M') + corners.join(QLatin1Char('L')) + QLatin1Char('z');
        }
        return path;
    }

    // Number of decimals that resolve a thousandth of the smallest polygon.
    static int digitsFor(const std::vector<ifs::Polygon>& polygons) {
        double smallest = 1;
        for (const ifs::Polygon& polygon : polygons) {
            double size = 0;
            for (const auto& corner : polygon)
                size = std::max(size, (corner - polygon.front()).cwiseAbs().maxCoeff());
            smallest = std::min(smallest, size);
        }
        constexpr double minSize = 1e-12;
        return int(std::ceil(3 - std::log10(std::max(smallest, minSize))));
    }

    static QString shortNumber(double value, int digits) {
        QString number = QString::number(value, 'f', digits);
        while (number.endsWith(u'0'))
            number.chop(1);
        if (number.endsWith(u'.')) number.chop(1);
        return number == u"-0" ? QStringLiteral("0") : number;
    }

    void writeProjection(std::size_t i, const ifs::CopyProjection& projection) {
        QString path;
        for (const auto& bar : projection.bars)
            path += QLatin1Char('M') + pointList(bar) + QLatin1Char('z');
        m_xml.writeEmptyElement(svg, QStringLiteral("path"));
        attribute("id", projectionId(i));
        attribute("d", path);
    }

    void writeCopy(const ifs::Copy& copy) {
        m_xml.writeEmptyElement(svg, QStringLiteral("use"));
        const QString of = copy.projection ? projectionId(*copy.projection) : levelId(copy.level);
        m_xml.writeAttribute(xlinkNamespace(), QStringLiteral("href"), QLatin1Char('#') + of);
        if (!(copy.map == ifs::AffineMap<2>{})) attribute("transform", svgText(copy.map));
    }

    void writeBackground() {
        const attractor::Rgba& colour = m_fractal.appearance.background;
        if (colour.alpha == 0) return;
        m_xml.writeEmptyElement(svg, QStringLiteral("rect"));
        attribute("width", QString::number(m_camera.width));
        attribute("height", QString::number(m_camera.height));
        attribute("fill", svgText(colour));
        if (colour.alpha != 255) attribute("fill-opacity", svgText(colour.alpha / 255.0));
    }

    // Writes into the open element, in the colours of the fractal.
    void writeCopies(const document::Fractal& fractal, const ifs::AffineMap<2>& display,
                     const ifs::CopyHierarchy& levels, const ifs::MergedCopies& merged) {
        attribute("transform", svgText(display));
        attribute("fill", svgText(shapeColour(fractal.appearance)));
        for (const ifs::Copy& copy : merged.picture()) {
            writeCopy(copy);
            if (const auto colour = shapeColour(fractal, levels, copy)) attribute("fill", svgText(*colour));
        }
    }

    void writeCage() {
        const ifs::ControlCage<2> cage = document::effectiveCage(m_fractal);
        startElement("g");
        attribute("id", QStringLiteral("control-triangle"));
        attribute("fill", QStringLiteral("none"));
        attribute("stroke", inkOn(groundOf(m_fractal, m_format)).name());
        attribute("stroke-width", QStringLiteral("1.5"));
        attribute("stroke-linejoin", QStringLiteral("round"));
        writePolygon("current", cage.current);
        writeSvgMarks(m_xml, cornerMarks(m_fractal, m_camera, groundOf(m_fractal, m_format)));
        m_xml.writeEndElement();
    }

    void writeOverlay() {
        startElement("g");
        attribute("id", QStringLiteral("overlay"));
        writeSvgMarks(m_xml, overlayMarks(m_fractal, m_camera, m_format.overlay));
        m_xml.writeEndElement();
    }

    void writePolygon(const char* id, std::vector<ifs::Vector<2>> vertices) {
        for (auto& vertex : vertices)
            vertex = toPixel(m_camera, vertex);
        m_xml.writeEmptyElement(svg, QStringLiteral("polygon"));
        attribute("id", QLatin1String(id));
        attribute("points", pointList(vertices));
    }

    const document::Fractal& m_fractal;
    const attractor::Camera& m_camera;
    const SvgFormat& m_format;
    QByteArray m_bytes;
    QXmlStreamWriter m_xml;
};

// The outline at the requested depth, else at the usual one or, where that is too much, at the deepest that
// programs read.
SvgPicture outlinePicture(const document::Fractal& fractal, const attractor::Camera& camera,
                          const ifs::CopyHierarchy& levels, SvgFormat format, const std::stop_token& stop) {
    const bool mayBeShallower = !format.depth;
    for (;;) {
        SvgPicture picture{{}, planOf(fractal, levels, format)};
        const int depth = picture.plan.depth;
        picture.bytes = Writer(fractal, camera, format).outline(leafUnion(levels, depth, stop));
        if (picture.bytes.size() <= maxPath || stop.stop_requested()) return picture;
        if (!mayBeShallower || depth == 0) {
            picture.bytes.clear();
            picture.plan.failure = Text::tr("The outline has more corners than other programs can read in "
                                            "one path. Choose a smaller depth.");
            return picture;
        }
        format.depth = depth - 1;
    }
}

} // namespace

int svgDepth(const ifs::CopyHierarchy& levels, const SvgFormat& format) {
    return format.depth ? std::clamp(*format.depth, 0, levels.deepest()) : levels.levelFor(goodEnough);
}

SvgPlan svgPlan(const document::Fractal& fractal, const attractor::Camera& camera, const SvgFormat& format) {
    const ShapeLevels levels = shapeLevels(fractal, camera);
    if (levels.levels) return planOf(fractal, *levels.levels, format);
    SvgPlan plan;
    plan.failure = levels.failure;
    return plan;
}

SvgPicture svgPicture(const document::Fractal& fractal, const attractor::Camera& camera,
                      const SvgFormat& format, const std::stop_token& stop) {
    const ShapeLevels levels = shapeLevels(fractal, camera);
    SvgPicture picture;
    if (levels.failure) {
        picture.plan.failure = levels.failure;
        return picture;
    }
    picture.plan = planOf(fractal, *levels.levels, format);
    const int depth = picture.plan.depth;
    Writer writer(fractal, camera, format);
    switch (format.style) {
    case ShapeStyle::Structured:
        picture.bytes = writer.structured(*levels.levels, depth);
        break;
    case ShapeStyle::Outline:
        return outlinePicture(fractal, camera, *levels.levels, format, stop);
    case ShapeStyle::Points:
        picture.bytes = writer.points();
        break;
    }
    return picture;
}

QByteArray structuredSvg(const document::Fractal& fractal, const attractor::Camera& camera) {
    const ShapeLevels levels = shapeLevels(fractal, camera);
    if (levels.failure) return {};
    return Writer(fractal, camera, {}).structured(*levels.levels, svgDepth(*levels.levels, {}));
}

} // namespace io
