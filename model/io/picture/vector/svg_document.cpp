// SPDX-License-Identifier: MIT
#include "io/picture/vector/svg_document.h"

#include "io/picture/vector/svg_system.h"

#include <QXmlStreamWriter>

#include <cmath>

namespace io {

namespace {

// XML 1.0 knows no control characters but tab and line end.
QString withoutControls(const QString& text) {
    QString result;
    for (const QChar c : text)
        if (c.unicode() >= 0x20 ? c.unicode() < 0xfffe : c == u'\t' || c == u'\n') result += c;
    return result;
}

QString length(int pixels, double dotsPerInch) {
    if (dotsPerInch == pixelsOfSvg) return QString::number(pixels);
    // Exact size in tenths of a millimetre for paper sizes, since whole pixels only approximate them.
    const double perMillimetre = dotsPerInch / 25.4;
    const double tenths = std::round(10 * pixels / perMillimetre) / 10;
    const double length = std::lround(tenths * perMillimetre) == pixels ? tenths : pixels / perMillimetre;
    return QString::number(length, 'g', 7) + QStringLiteral("mm");
}

} // namespace

const QString& svgNamespace() {
    static const QString name = QStringLiteral("http://www.w3.org/2000/svg");
    return name;
}

const QString& xlinkNamespace() {
    static const QString name = QStringLiteral("http://www.w3.org/1999/xlink");
    return name;
}

void startSvg(QXmlStreamWriter& xml, const SvgHeading& heading) {
    const auto& [width, height] = heading.pixels;
    const QString& svg = svgNamespace();
    xml.setAutoFormatting(true);
    xml.setAutoFormattingIndent(1);
    xml.writeStartDocument();
    xml.writeDefaultNamespace(svg);
    xml.writeNamespace(xlinkNamespace(), QStringLiteral("xlink"));
    xml.writeStartElement(svg, QStringLiteral("svg"));
    xml.writeAttribute(QStringLiteral("version"), QStringLiteral("1.1"));
    xml.writeAttribute(QStringLiteral("width"), length(width, heading.dotsPerInch));
    xml.writeAttribute(QStringLiteral("height"), length(height, heading.dotsPerInch));
    xml.writeAttribute(QStringLiteral("viewBox"), QStringLiteral("0 0 %1 %2").arg(width).arg(height));
    xml.writeTextElement(svg, QStringLiteral("title"), withoutControls(heading.title));
    xml.writeStartElement(svg, QStringLiteral("metadata"));
    xml.writeNamespace(svgSystemNamespace(), QStringLiteral("barycage"));
    xml.writeStartElement(svgSystemNamespace(), QStringLiteral("system"));
    xml.writeCDATA(withoutControls(QString::fromUtf8(heading.systemText)));
    xml.writeEndElement();
    xml.writeEndElement();
}

} // namespace io
