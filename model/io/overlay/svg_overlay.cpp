// SPDX-License-Identifier: MIT
#include "io/overlay/svg_overlay.h"

#include <QStringList>
#include <QXmlStreamWriter>

#include <cmath>

namespace io {

namespace {

constexpr double baseline = 0.36; // letter sizes below the middle of a digit

QString text(double number) { // rounded to thousandths of a pixel
    return QString::number(std::round(number * 1000) / 1000, 'g', 12);
}

QString joined(const QPolygonF& polygon) {
    QStringList corners;
    for (const QPointF& corner : polygon)
        corners << text(corner.x()) + u',' + text(corner.y());
    return corners.join(u' ');
}

class Element {
public:
    Element(QXmlStreamWriter& xml, const char* name, const QString& content = {}) : m_xml(xml) {
        const QString svg = QStringLiteral("http://www.w3.org/2000/svg");
        m_isEmpty = content.isEmpty();
        m_content = content;
        if (m_isEmpty)
            m_xml.writeEmptyElement(svg, QLatin1String(name));
        else
            m_xml.writeStartElement(svg, QLatin1String(name));
    }
    ~Element() {
        if (m_isEmpty) return;
        m_xml.writeCharacters(m_content);
        m_xml.writeEndElement();
    }
    Element(const Element&) = delete;
    Element& operator=(const Element&) = delete;

    void set(const char* name, const QString& value) { m_xml.writeAttribute(QLatin1String(name), value); }

private:
    QXmlStreamWriter& m_xml;
    QString m_content;
    bool m_isEmpty = true;
};

void setColours(Element& element, const OverlayMark& mark) {
    element.set("fill", mark.fill.isValid() ? mark.fill.name() : QStringLiteral("none"));
    if (mark.fill.isValid() && mark.fill.alpha() < 255) element.set("fill-opacity", text(mark.fill.alphaF()));
    if (!mark.stroke.isValid()) return;
    element.set("stroke", mark.stroke.name());
    element.set("stroke-width", text(mark.width));
    element.set("stroke-linejoin", QStringLiteral("round"));
    if (mark.dashes.isEmpty()) return;
    element.set("stroke-linecap",
                mark.cap == Qt::RoundCap ? QStringLiteral("round") : QStringLiteral("square"));
    QStringList dashes;
    for (const qreal dash : mark.dashes)
        dashes << text(dash * mark.width);
    element.set("stroke-dasharray", dashes.join(u' '));
}

} // namespace

void writeSvgMarks(QXmlStreamWriter& xml, const OverlayMarks& marks) {
    for (const OverlayMark& mark : marks) {
        if (!mark.polygon.isEmpty()) {
            Element polygon(xml, "polygon");
            polygon.set("points", joined(mark.polygon));
            setColours(polygon, mark);
        } else if (mark.radius > 0) {
            Element circle(xml, "circle");
            circle.set("cx", text(mark.centre.x()));
            circle.set("cy", text(mark.centre.y()));
            circle.set("r", text(mark.radius));
            setColours(circle, mark);
        } else if (!mark.word.isEmpty()) {
            Element word(xml, "text", mark.word);
            word.set("x", text(mark.centre.x()));
            word.set("y", text(mark.centre.y() + baseline * mark.letterSize));
            word.set("font-family", QStringLiteral("sans-serif"));
            word.set("font-weight", QStringLiteral("bold"));
            word.set("font-size", text(mark.letterSize));
            word.set("text-anchor", QStringLiteral("middle"));
            setColours(word, mark);
        }
    }
}

} // namespace io
