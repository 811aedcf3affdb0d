// SPDX-License-Identifier: MIT
#include "canvas/scene/handle_text.h"

#include "canvas/geometry/coordinate_text.h"
#include "document/text/text.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

using Kind = CanvasPart::Kind;

QString coordinates(const attractor::Camera& camera, const ifs::Vector<2>& point) {
    return QStringLiteral("x %1, y %2")
        .arg(CoordinateText(camera, 0).text(point.x()), CoordinateText(camera, 1).text(point.y()));
}

} // namespace

QString mapName(const HandleModel& handles, std::size_t map) {
    const document::MapFaces& faces = handles.faces();
    const std::size_t number = map < faces.size() ? faces[map].number : map + 1;
    return number > 0 ? Text::tr("Map %1").arg(number) : Text::tr("Map that takes no part");
}

QString nameOf(const HandleModel& handles, const CanvasPart& part) {
    if (part.map >= 0) {
        const QString name =
            handles.target() == HandleTarget::Branch
                ? Text::tr("Branch %1").arg(document::addressText(handles.branch(), handles.branch().size()))
                : mapName(handles, std::size_t(part.map));
        return part.kind == Kind::Vertex
                   ? Text::tr("%1, corner %2").arg(name, QString::number(part.index + 1))
                   : name;
    }
    switch (part.kind) {
    case Kind::None:
        break;
    case Kind::Vertex:
        return Text::tr("Vertex %1").arg(part.index + 1);
    case Kind::Edge:
        return Text::tr("Edge from vertex %1").arg(part.index + 1);
    case Kind::Inside:
        return Text::tr("The whole cage");
    case Kind::Pivot:
        return Text::tr("Pivot");
    case Kind::Rotate:
        return Text::tr("Round handle");
    case Kind::Scale:
        return Text::tr("Square handle");
    }
    return {};
}

QString valueOf(const HandleModel& handles, const attractor::Camera& camera, const CanvasPart& part) {
    switch (part.kind) {
    case Kind::Vertex:
        if (part.map >= 0) return coordinates(camera, handles.corners(part.map)[std::size_t(part.index)]);
        return handles.cage() ? coordinates(camera, handles.cage()->current[std::size_t(part.index)])
                              : QString();
    case Kind::Pivot:
        return coordinates(camera, handles.pivot());
    case Kind::Edge:
        return Text::tr("the arrow keys move both its ends");
    case Kind::Inside:
        return Text::tr("the arrow keys move it");
    case Kind::Rotate:
        return Text::tr("the arrow keys turn by one degree");
    case Kind::Scale:
        return Text::tr("the arrow keys scale by one percent");
    case Kind::None:
        break;
    }
    return {};
}

QString useOf(const CanvasPart& part) {
    switch (part.kind) {
    case Kind::Pivot:
        return Text::tr("Drag to move the pivot, the centre of rotation and scaling.");
    case Kind::Rotate:
        return Text::tr("Drag to rotate about the pivot; hold Shift for steps of 15°.");
    case Kind::Scale:
        return Text::tr("Drag to scale about the pivot; hold Shift for x or y only.");
    case Kind::None:
    case Kind::Vertex:
    case Kind::Edge:
    case Kind::Inside:
        break;
    }
    return {};
}

} // namespace view
