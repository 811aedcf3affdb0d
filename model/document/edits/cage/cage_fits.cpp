// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_fits.h"

#include "ifs/cage/hull_cage.h"
#include "ifs/cage/space_hull_cage.h"
#include "ifs/extent/extent.h"

#include <QtGlobal>

namespace document {

namespace {

using Points2 = std::vector<ifs::Vector<2>>;
using Points3 = std::vector<ifs::Vector<3>>;
using Support2 = ifs::SupportFunction<2>;
using Support3 = ifs::SupportFunction<3>;

Points2 boxAround(const Support2& support) {
    const auto box = ifs::boundingBox(support);
    const ifs::Vector<2> low = box.min.array() - box.error, high = box.max.array() + box.error;
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

constexpr int polygons[]{3, 4, 5, 6, 8, 12, 16, 24};
constexpr int polyhedra[]{10, 12, 16, 20, 24};

constexpr CageFit<2> planeFits[]{
    {PolygonChoice::Box,
     "box",
     QT_TRANSLATE_NOOP("Text", "Bounding Box"),
     {4, 4, 4},
     [](const Support2& support, double, int) { return boxAround(support); }},
    {PolygonChoice::Rectangle,
     "rectangle",
     QT_TRANSLATE_NOOP("Text", "Smallest Rectangle"),
     {4, 4, 4},
     [](const Support2& support, double, int) {
         return Points2(ifs::smallestRectangleAround(ifs::enlargedHull(support)));
     }},
    {PolygonChoice::Hull,
     "hull",
     QT_TRANSLATE_NOOP("Text", "Convex Hull, Simplified to"),
     {8, 3, 64, polygons},
     [](const Support2& support, double, int corners) {
         return Points2(ifs::simplifiedHull(ifs::enlargedHull(support), corners));
     }},
    {PolygonChoice::Regular,
     "",
     QT_TRANSLATE_NOOP("Text", "Regular Polygon with"),
     {8, 3, 64, polygons},
     [](const Support2& support, double, int corners) {
         return Points2(ifs::regularPolygonAround(ifs::enlargedHull(support), corners));
     }},
};

constexpr CageFit<3> spaceFits[]{
    {SpacePolyhedron::Box,
     "box",
     QT_TRANSLATE_NOOP("Text", "Bounding Box, Eight Corners"),
     {8, 8, 8},
     [](const Support3& support, double tolerance, int) {
         return Points3(ifs::boxCage(support, tolerance));
     }},
    {SpacePolyhedron::Octahedron,
     "octahedron",
     QT_TRANSLATE_NOOP("Text", "Octahedron"),
     {6, 6, 6},
     [](const Support3& support, double tolerance, int) {
         return Points3(ifs::octahedronCage(support, tolerance));
     }},
    {SpacePolyhedron::Hull,
     "hull",
     QT_TRANSLATE_NOOP("Text", "Convex Hull, Simplified to"),
     {16, 8, 24, polyhedra},
     [](const Support3& support, double tolerance, int corners) {
         return Points3(ifs::hullCage(support, corners, tolerance));
     }},
};

} // namespace

template <> std::span<const CageFit<2>> cageFits<2>() {
    return planeFits;
}

template <> std::span<const CageFit<3>> cageFits<3>() {
    return spaceFits;
}

} // namespace document
