// SPDX-License-Identifier: MIT
#include "canvas/geometry/drag_text.h"

#include "document/text/text.h"
#include "widgets/numbers/number_text.h"

#include <cmath>
#include <numbers>

namespace view {

namespace {

using Mode = PolygonDrag::Mode;

double degrees(const ifs::Matrix<2>& rotation) {
    return std::atan2(rotation(1, 0), rotation(0, 0)) * 180 / std::numbers::pi;
}

QString factorText(const ifs::Matrix<2>& scaling) {
    const QString x = shortNumber(scaling(0, 0)), y = shortNumber(scaling(1, 1));
    return x == y ? x : QStringLiteral("%1 × %2").arg(x, y);
}

// Four digits, at any zoom.
QString lengthText(double length) {
    return QString::number(length, 'g', 4).replace(u'-', QChar(0x2212));
}

// Lengths of the edges that meet at the vertices that move, where these are one or two of a polygon.
QStringList edgeLengths(const PolygonDrag& drag, const std::vector<ifs::Vector<2>>& points) {
    const std::size_t count = points.size(), moving = drag.vertices.size();
    if (count < 3 || moving == 0 || moving > 2) return {};
    const auto edge = [&](std::size_t from) {
        return lengthText((points[(from + 1) % count] - points[from]).norm());
    };
    const auto first = std::size_t(drag.vertices.front());
    if (moving == 1) return {edge((first + count - 1) % count), edge(first)};
    const auto second = std::size_t(drag.vertices.back());
    return (first + 1) % count == second ? QStringList{edge(first)} : QStringList();
}

} // namespace

QString withValue(const QString& what, const PolygonDrag& drag, const DragResult& result) {
    switch (drag.mode) {
    case Mode::Rotate:
        return Text::tr("%1 by %2°").arg(what, shortNumber(degrees(result.change.linear)));
    case Mode::Scale:
        return Text::tr("%1 by %2").arg(what, factorText(result.change.linear));
    case Mode::Move:
        break;
    }
    const bool one = drag.vertices.size() == 1;
    const ifs::Vector<2> value =
        one ? result.points[std::size_t(drag.vertices.front())] : result.change.translation;
    return (one ? Text::tr("%1 to (%2, %3)") : Text::tr("%1 by (%2, %3)"))
        .arg(what, shortNumber(value.x()), shortNumber(value.y()));
}

QString readout(const PolygonDrag& drag, const DragResult& result) {
    if (drag.mode == Mode::Rotate)
        return Text::tr("%1°", "an angle")
            .arg(QString::number(degrees(result.change.linear), 'f', 1).replace(u'-', QChar(0x2212)));
    if (drag.mode == Mode::Scale) return Text::tr("× %1", "a factor").arg(factorText(result.change.linear));
    const ifs::Vector<2>& offset = result.change.translation;
    const QString way = Text::tr("Δ (%1, %2)  length %3")
                            .arg(lengthText(offset.x()), lengthText(offset.y()), lengthText(offset.norm()));
    const QStringList edges = edgeLengths(drag, result.points);
    if (edges.isEmpty()) return way;
    return way + u'\n' +
           (edges.size() == 1 ? Text::tr("edge %1").arg(edges.front())
                              : Text::tr("edges %1 and %2").arg(edges[0], edges[1]));
}

} // namespace view
