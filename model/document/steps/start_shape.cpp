// SPDX-License-Identifier: MIT
#include "document/steps/start_shape.h"

#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"

#include <QFont>
#include <QPainterPath>

#include <algorithm>
#include <functional>
#include <utility>

namespace document {

namespace {

constexpr int letterSize = 400;          // pixels, for which curves become lines of a few pixels
constexpr std::size_t maxCorners = 1500; // total limit, because every step draws them many times

template <class Change> StartShape changed(StartShape shape, Change change) {
    for (auto& contour : shape.contours)
        for (ifs::Vector<2>& corner : contour)
            corner = change(corner);
    return shape;
}

StartShape normalised(StartShape shape) {
    ifs::Vector<2> low = shape.contours.front().front();
    ifs::Vector<2> high = low;
    for (const auto& contour : shape.contours)
        for (const ifs::Vector<2>& corner : contour) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    const ifs::Vector<2> middle = (low + high) / 2;
    const double side = (high - low).maxCoeff();
    return changed(std::move(shape), [&](const ifs::Vector<2>& corner) -> ifs::Vector<2> {
        return (corner - middle) / (side > 0 ? side : 1);
    });
}

} // namespace

StartShape squareShape() {
    return {{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}};
}

std::optional<StartShape> letterShape(const QString& letters) {
    QFont font;
    font.setStyleHint(QFont::SansSerif);
    font.setBold(true);
    font.setPixelSize(letterSize);
    QPainterPath path;
    path.addText(0, 0, font, letters.trimmed());
    StartShape shape;
    // Simplified, because letters may overlap.
    for (const QPolygonF& polygon : path.simplified().toSubpathPolygons()) {
        std::vector<ifs::Vector<2>> contour;
        for (const QPointF& point : polygon)
            contour.emplace_back(point.x(), -point.y());
        // More than 3, since the last point repeats the first.
        if (contour.size() > 3) shape.contours.push_back(std::move(contour));
    }
    if (shape.contours.empty()) return std::nullopt;
    return normalised(std::move(shape));
}

StartShape pictureShape(const TracedPicture& picture) {
    StartShape shape;
    std::size_t corners = 0;
    std::vector<std::vector<ifs::Vector<2>>> outlines = picture.outlines;
    // Largest outlines first, specks last.
    std::ranges::stable_sort(outlines, std::ranges::greater(), &std::vector<ifs::Vector<2>>::size);
    for (auto& outline : outlines) {
        corners += outline.size();
        if (corners > maxCorners && !shape.contours.empty()) break;
        shape.contours.push_back(std::move(outline));
    }
    return normalised(std::move(shape));
}

StartShape overAttractor(const StartShape& shape, const Fractal& fractal) {
    const attractor::PreparedSystem system = attractor::prepared(*system2(fractal), movedBranches(fractal));
    const double side = 2 * system.halfExtent.maxCoeff();
    return changed(
        shape, [&](const ifs::Vector<2>& corner) -> ifs::Vector<2> { return system.centre + side * corner; });
}

} // namespace document
