// SPDX-License-Identifier: MIT
#include "io/svg_writer.h"

#include "io/fractint_writer.h"
#include "io/number.h"
#include "io/svg_levels.h"
#include "io/svg_system.h"

#include <QCoreApplication>
#include <QXmlStreamWriter>

#include <set>

namespace io {

namespace {

constexpr double goodEnough = 1; // pixel
const QString svg = QStringLiteral("http://www.w3.org/2000/svg");
const QString xlink = QStringLiteral("http://www.w3.org/1999/xlink");

QString tr(const char* text) {
    return QCoreApplication::translate("SvgWriter", text);
}

QString text(double number) {
    return QString::fromLatin1(formatNumber(number));
}

// SVG writes the matrix column by column.
QString text(const ifs::AffineMap<2>& map) {
    const auto& m = map.linear;
    return QStringLiteral("matrix(%1 %2 %3 %4 %5 %6)")
        .arg(text(m(0, 0)), text(m(1, 0)), text(m(0, 1)), text(m(1, 1)), text(map.translation.x()),
             text(map.translation.y()));
}

QString text(const attractor::Rgba& colour) {
    return QStringLiteral("#%1%2%3")
        .arg(colour.red, 2, 16, QLatin1Char('0'))
        .arg(colour.green, 2, 16, QLatin1Char('0'))
        .arg(colour.blue, 2, 16, QLatin1Char('0'));
}

template <typename Points> QString pointList(const Points& points) {
    QString list;
    for (const ifs::Vector<2>& p : points)
        list +=
            (list.isEmpty() ? QString() : QStringLiteral(" ")) + text(p.x()) + QLatin1Char(',') + text(p.y());
    return list;
}

// XML 1.0 knows no control characters but tab and line end.
QString withoutControls(const QString& text) {
    QString result;
    for (const QChar c : text)
        if (c.unicode() >= 0x20 ? c.unicode() < 0xfffe : c == u'\t' || c == u'\n') result += c;
    return result;
}

struct Levels {
    std::optional<SvgLevels> levels;
    Failure failure;
};

Levels levelsOf(const document::Fractal& fractal, const attractor::Camera& camera) {
    const document::System2* system = document::system2(fractal);
    if (!system) return {{}, tr("Only plane systems can be written as a scalable picture.")};
    ifs::AffineMap<2> display = worldToPixel(camera);
    if (fractal.cage) display = display * ifs::displayMap(*fractal.cage);
    auto levels = SvgLevels::of(*system, display);
    if (!levels)
        return {
            {},
            tr("The system has no attractor of which an outline could be certified, so there is nothing to "
               "make copies of.")};
    return {std::move(levels), {}};
}

SvgPlan planOf(const document::Fractal& fractal, const SvgLevels& levels, const SvgFormat& format) {
    SvgPlan plan;
    plan.deepest = levels.deepest();
    plan.depth = format.depth ? std::clamp(*format.depth, 0, plan.deepest) : levels.levelFor(goodEnough);
    plan.references = std::max<std::uint64_t>(levels.references(plan.depth), 1);
    plan.errorInPixels = levels.error(plan.depth);
    plan.unbent = fractal.cage && ifs::bends(*fractal.cage);
    return plan;
}

class Writer {
public:
    Writer(const document::Fractal& fractal, const attractor::Camera& camera, const SvgLevels& levels,
           int depth)
        : m_fractal(fractal), m_camera(camera), m_levels(levels), m_depth(depth), m_xml(&m_bytes) {}

    QByteArray write(CageVisibility cage) {
        m_xml.setAutoFormatting(true);
        m_xml.setAutoFormattingIndent(1);
        m_xml.writeStartDocument();
        startRoot();
        writeMetadata();
        writeDefinitions();
        writeBackground();
        writeAttractor();
        if (cage == CageVisibility::Shown) writeCage();
        m_xml.writeEndElement();
        m_xml.writeEndDocument();
        return m_bytes;
    }

private:
    void attribute(const char* name, const QString& value) {
        m_xml.writeAttribute(QLatin1String(name), value);
    }
    void startElement(const char* name) { m_xml.writeStartElement(svg, QLatin1String(name)); }

    void startRoot() {
        m_xml.writeDefaultNamespace(svg);
        m_xml.writeNamespace(xlink, QStringLiteral("xlink"));
        startElement("svg");
        const QString width = QString::number(m_camera.width);
        const QString height = QString::number(m_camera.height);
        attribute("version", QStringLiteral("1.1"));
        attribute("width", width);
        attribute("height", height);
        attribute("viewBox", QStringLiteral("0 0 %1 %2").arg(width, height));
        m_xml.writeTextElement(svg, QStringLiteral("title"), withoutControls(m_fractal.name));
    }

    void writeMetadata() {
        startElement("metadata");
        m_xml.writeNamespace(svgSystemNamespace(), QStringLiteral("barycage"));
        m_xml.writeStartElement(svgSystemNamespace(), QStringLiteral("system"));
        m_xml.writeCDATA(withoutControls(QString::fromUtf8(writeEntry(m_fractal))));
        m_xml.writeEndElement();
        m_xml.writeEndElement();
    }

    static QString levelId(int level) { return QStringLiteral("level-%1").arg(level); }

    // The levels that the deepest one needs.
    std::set<int> usedLevels() const {
        std::set<int> used{m_depth};
        for (auto level = used.rbegin(); level != used.rend() && *level > 0; ++level)
            for (std::size_t i = 0; i < m_levels.maps().size(); ++i)
                used.insert(m_levels.below(*level, i));
        return used;
    }

    void writeDefinitions() {
        startElement("defs");
        for (const int level : usedLevels()) {
            if (level == 0)
                writeOutline();
            else if (level < m_depth)
                writeLevel(level);
        }
        m_xml.writeEndElement();
    }

    void writeOutline() {
        m_xml.writeEmptyElement(svg, QStringLiteral("polygon"));
        attribute("id", levelId(0));
        attribute("points", pointList(m_levels.outline(m_depth)));
    }

    void writeLevel(int level) {
        startElement("g");
        attribute("id", levelId(level));
        for (std::size_t i = 0; i < m_levels.maps().size(); ++i)
            writeCopy(level, i, {});
        m_xml.writeEndElement();
    }

    void writeCopy(int level, std::size_t i, const QString& colour) {
        m_xml.writeEmptyElement(svg, QStringLiteral("use"));
        m_xml.writeAttribute(xlink, QStringLiteral("href"),
                             QLatin1Char('#') + levelId(m_levels.below(level, i)));
        attribute("transform", text(m_levels.maps()[i]));
        if (!colour.isEmpty()) attribute("fill", colour);
    }

    void writeBackground() {
        const attractor::Rgba& colour = m_fractal.appearance.background;
        if (colour.alpha == 0) return;
        m_xml.writeEmptyElement(svg, QStringLiteral("rect"));
        attribute("width", QString::number(m_camera.width));
        attribute("height", QString::number(m_camera.height));
        attribute("fill", text(colour));
        if (colour.alpha != 255) attribute("fill-opacity", text(colour.alpha / 255.0));
    }

    // One colour for what has shades in the picture made of points: the bright part of the palette.
    attractor::Rgba colourOfAll() const {
        const attractor::Appearance& appearance = m_fractal.appearance;
        return appearance.colourBy == attractor::ColourBy::Plain
                   ? appearance.plain
                   : attractor::colourAt(appearance.palette, 0.75);
    }

    // Empty where the maps of the top level share the colour of all.
    QString colourOfMap(std::size_t i) const {
        const attractor::Appearance& appearance = m_fractal.appearance;
        const document::System2& system = *document::system2(m_fractal);
        const std::size_t place = m_levels.index()[i];
        if (appearance.colourBy == attractor::ColourBy::Map)
            return text(attractor::mapColour(appearance, system.maps[place].id, place));
        if (appearance.colourBy == attractor::ColourBy::Address)
            return text(
                attractor::colourAt(appearance.palette, (double(i) + 0.5) / double(m_levels.maps().size())));
        return {};
    }

    void writeAttractor() {
        startElement("g");
        attribute("id", QStringLiteral("attractor"));
        attribute("transform", text(m_levels.display()));
        attribute("fill", text(colourOfAll()));
        if (m_depth == 0) {
            m_xml.writeEmptyElement(svg, QStringLiteral("use"));
            m_xml.writeAttribute(xlink, QStringLiteral("href"), QLatin1Char('#') + levelId(0));
        }
        for (std::size_t i = 0; m_depth > 0 && i < m_levels.maps().size(); ++i)
            writeCopy(m_depth, i, colourOfMap(i));
        m_xml.writeEndElement();
    }

    void writeCage() {
        const ifs::ControlCage<2> cage = document::effectiveCage(m_fractal);
        startElement("g");
        attribute("id", QStringLiteral("control-triangle"));
        attribute("fill", QStringLiteral("none"));
        attribute("stroke", cageColour().name());
        attribute("stroke-width", QStringLiteral("1.5"));
        attribute("stroke-linejoin", QStringLiteral("round"));
        if (cage.rest != cage.current) writePolygon("rest", cage.rest, QStringLiteral("4 4"));
        writePolygon("current", cage.current, {});
        m_xml.writeEndElement();
    }

    void writePolygon(const char* id, std::vector<ifs::Vector<2>> vertices, const QString& dashes) {
        for (auto& vertex : vertices)
            vertex = toPixel(m_camera, vertex);
        m_xml.writeEmptyElement(svg, QStringLiteral("polygon"));
        attribute("id", QLatin1String(id));
        attribute("points", pointList(vertices));
        if (!dashes.isEmpty()) attribute("stroke-dasharray", dashes);
    }

    const document::Fractal& m_fractal;
    const attractor::Camera& m_camera;
    const SvgLevels& m_levels;
    int m_depth;
    QByteArray m_bytes;
    QXmlStreamWriter m_xml;
};

} // namespace

SvgPlan svgPlan(const document::Fractal& fractal, const attractor::Camera& camera, const SvgFormat& format) {
    const Levels levels = levelsOf(fractal, camera);
    if (levels.failure) {
        SvgPlan plan;
        plan.failure = levels.failure;
        return plan;
    }
    return planOf(fractal, *levels.levels, format);
}

SvgPicture svgPicture(const document::Fractal& fractal, const attractor::Camera& camera,
                      const SvgFormat& format) {
    const Levels levels = levelsOf(fractal, camera);
    SvgPicture picture;
    if (levels.failure) {
        picture.plan.failure = levels.failure;
        return picture;
    }
    picture.plan = planOf(fractal, *levels.levels, format);
    picture.bytes = Writer(fractal, camera, *levels.levels, picture.plan.depth).write(format.cage);
    return picture;
}

} // namespace io
