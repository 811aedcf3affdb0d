// SPDX-License-Identifier: MIT
#include "io/overlay/pdf_overlay.h"

#include <QByteArrayList>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr double pdfBaseline = 0.36;   // letter sizes below the middle of a digit
constexpr double digitWidth = 0.556;   // letter sizes; digits of Helvetica-Bold, available in every viewer
constexpr double circleArm = 0.552285; // 4 (√2 − 1) / 3, for curves that are quarters of a circle

QByteArray text(double number) { // rounded to thousandths of a pixel; PDF has no exponents
    return QByteArray::number(std::round(number * 1000) / 1000, 'f', 3);
}

QByteArray text(double x, double y) {
    return text(x) + ' ' + text(y);
}

QByteArray text(const QColor& colour) {
    return text(colour.redF()) + ' ' + text(colour.greenF()) + ' ' + text(colour.blueF());
}

QByteArray path(const QPolygonF& polygon) {
    QByteArray path;
    for (const QPointF& corner : polygon)
        path += text(corner.x(), corner.y()) + (path.isEmpty() ? " m\n" : " l\n");
    return path + "h\n";
}

// Four quarters.
QByteArray path(const QPointF& centre, double radius) {
    const auto at = [&](double x, double y) {
        return text(centre.x() + radius * x, centre.y() + radius * y) + ' ';
    };
    const double k = circleArm;
    return at(1, 0) + "m\n" + at(1, k) + at(k, 1) + at(0, 1) + "c\n" + at(-k, 1) + at(-1, k) + at(-1, 0) +
           "c\n" + at(-1, -k) + at(-k, -1) + at(0, -1) + "c\n" + at(k, -1) + at(1, -k) + at(1, 0) + "c\nh\n";
}

// Name of the graphics state of an opacity: each has its own.
QByteArray stateName(const QColor& fill) {
    return "/A" + QByteArray::number(fill.alpha());
}

QByteArray painted(const OverlayMark& mark, const QByteArray& path) {
    QByteArray content = "q\n";
    if (mark.fill.isValid()) {
        content += text(mark.fill) + " rg\n";
        if (mark.fill.alpha() < 255) content += stateName(mark.fill) + " gs\n";
    }
    if (mark.stroke.isValid()) {
        content += text(mark.stroke) + " RG " + text(mark.width) + " w 1 j " +
                   (mark.cap == Qt::RoundCap ? "1" : "2") + " J\n";
        QByteArrayList dashes;
        for (const qreal dash : mark.dashes)
            dashes << text(dash * mark.width);
        if (!dashes.isEmpty()) content += '[' + dashes.join(' ') + "] 0 d\n";
    }
    const char* paint = mark.fill.isValid() ? (mark.stroke.isValid() ? "B" : "f") : "S";
    return content + path + paint + "\nQ\n";
}

// A word of digits, upright although y is down.
QByteArray word(const OverlayMark& mark) {
    const double width = digitWidth * mark.letterSize * double(mark.word.size());
    const double x = mark.centre.x() - width / 2;
    const double y = mark.centre.y() + pdfBaseline * mark.letterSize;
    return "BT " + text(mark.fill) + " rg /Digits " + text(mark.letterSize) + " Tf 1 0 0 -1 " + text(x, y) +
           " Tm (" + mark.word.toLatin1() + ") Tj ET\n";
}

} // namespace

QByteArray pdfMarks(const OverlayMarks& marks) {
    QByteArray content;
    for (const OverlayMark& mark : marks) {
        if (!mark.polygon.isEmpty())
            content += painted(mark, path(mark.polygon));
        else if (mark.radius > 0)
            content += painted(mark, path(mark.centre, mark.radius));
        else if (!mark.word.isEmpty())
            content += word(mark);
    }
    return content;
}

QByteArray pdfMarkResources(const OverlayMarks& marks) {
    QByteArrayList states;
    for (const OverlayMark& mark : marks)
        if (mark.fill.isValid() && mark.fill.alpha() < 255) {
            const QByteArray state = stateName(mark.fill) + "<</ca " + text(mark.fill.alphaF()) + ">>";
            if (!states.contains(state)) states << state;
        }
    QByteArray resources;
    if (!states.isEmpty()) resources += "/ExtGState<<" + states.join() + ">>";
    const auto hasWord = [](const OverlayMark& mark) { return !mark.word.isEmpty(); };
    if (std::ranges::any_of(marks, hasWord))
        resources += "/Font<</Digits<</Type/Font/Subtype/Type1/BaseFont/Helvetica-Bold>>>>";
    return resources;
}

} // namespace io
