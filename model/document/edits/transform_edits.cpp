// SPDX-License-Identifier: MIT
#include "document/edits/transform_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"

#include "ifs/dimension/moments.h"
#include "ifs/links/linked_measure.h"
#include "ifs/system/decomposition.h"

#include <QtMath>

#include <utility>

namespace document {

namespace {

ifs::Matrix<2> mirror(double axisDegrees) {
    return ifs::linearPart({2 * qDegreesToRadians(axisDegrees), 1, -1, 0});
}

// Quarter turns without the rounding of π.
template <int Dim> ifs::Matrix<Dim> exactWhereItCanBe(const ifs::Matrix<Dim>& matrix) {
    return matrix.unaryExpr([](double x) { return qAbs(x) < 1e-16 ? 0.0 : x; });
}

template <int Dim> const Shape<Dim>* shapeOf(const Fractal& fractal) {
    return std::get_if<Shape<Dim>>(&fractal.shape);
}

template <int Dim> std::optional<ifs::ControlCage<Dim>> cageInForce(const Fractal& fractal) {
    if constexpr (Dim == 2)
        return effectiveCage(fractal);
    else
        return spaceCage(fractal);
}

template <int Dim>
ifs::AffineMap<Dim> about(const ifs::Vector<Dim>& point, const ifs::Matrix<Dim>& linear,
                          const ifs::Vector<Dim>& translation) {
    const ifs::AffineMap<Dim> toOrigin{ifs::Matrix<Dim>::Identity(), -point};
    return ifs::AffineMap<Dim>{linear, point + translation} * toOrigin;
}

} // namespace

ifs::AffineMap<2> affineMap(const Transformation& t) {
    ifs::Matrix<2> linear = ifs::linearPart({qDegreesToRadians(t.rotation), t.scaleX, t.scaleY, t.shear});
    if (t.reflect) linear = linear * mirror(t.axis);
    return about<2>(t.about, exactWhereItCanBe<2>(linear), t.translation);
}

ifs::AffineMap<3> affineMap(const SpaceTransformation& t) {
    const ifs::Matrix<3> rotation = ifs::rotationAbout({t.axis, qDegreesToRadians(t.rotation)});
    return about<3>(t.about, exactWhereItCanBe<3>(rotation) * t.scale.asDiagonal(), t.translation);
}

template <int Dim> Fractal placed(Fractal fractal, const ifs::AffineMap<Dim>& transformation) {
    auto cage = shapeOf<Dim>(fractal) ? cageInForce<Dim>(fractal) : std::nullopt;
    if (!cage) return fractal;
    for (auto& vertex : cage->current)
        vertex = transformation(vertex);
    std::get<Shape<Dim>>(fractal.shape).cage = std::move(cage);
    return fractal;
}
template Fractal placed(Fractal, const ifs::AffineMap<2>&);
template Fractal placed(Fractal, const ifs::AffineMap<3>&);

template <int Dim>
std::optional<Fractal> rewritten(const Fractal& fractal, const ifs::AffineMap<Dim>& transformation) {
    const Shape<Dim>* before = shapeOf<Dim>(fractal);
    if (!before) return std::nullopt;
    if constexpr (Dim == 3) {
        const ifs::MapKind kind = ifs::kind<3>(transformation.linear);
        const bool isSimilarity =
            kind == ifs::MapKind::Similarity || kind == ifs::MapKind::ReflectedSimilarity;
        if (before->cage && ifs::bends(*before->cage) && !isSimilarity) return std::nullopt;
    }
    auto result = conjugated<Dim>(fractal, transformation);
    if (!result) return std::nullopt;
    if (auto& cage = std::get<Shape<Dim>>(result->shape).cage) {
        for (auto* vertices : {&cage->rest, &cage->current}) {
            for (auto& vertex : *vertices)
                vertex = transformation(vertex);
        }
    }
    return result;
}
template std::optional<Fractal> rewritten(const Fractal&, const ifs::AffineMap<2>&);
template std::optional<Fractal> rewritten(const Fractal&, const ifs::AffineMap<3>&);

template <int Dim> std::optional<ifs::Vector<Dim>> middleOfBox(const Fractal& fractal) {
    if constexpr (Dim == 2) {
        const auto box = displayedBox(fractal);
        return box ? std::optional<ifs::Vector<2>>((box->min + box->max) / 2) : std::nullopt;
    } else {
        if (!spaceSupport(fractal)) return std::nullopt;
        ifs::Vector<3> middle;
        for (int axis = 0; axis < 3; ++axis) {
            const Extent extent = extentAlong(fractal, ifs::Vector<3>::Unit(axis));
            middle[axis] = (extent.low + extent.high) / 2;
        }
        return middle;
    }
}
template std::optional<ifs::Vector<2>> middleOfBox(const Fractal&);
template std::optional<ifs::Vector<3>> middleOfBox(const Fractal&);

template <int Dim> std::optional<ifs::Vector<Dim>> displayedMean(const Fractal& fractal) {
    const Shape<Dim>* shape = shapeOf<Dim>(fractal);
    if (!shape) return std::nullopt;
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(shape->system);
    std::optional<ifs::Moments<Dim>> moments;
    if (!active.isLinked()) moments = ifs::moments(active);
    if constexpr (Dim == 2)
        if (active.isLinked() && linkedExtent(fractal)) moments = ifs::linkedMoments(active);
    if (!moments) return std::nullopt;
    const auto& cage = shape->cage;
    const bool atRest = !cage || cage->rest == cage->current;
    // The mean of a bent picture is no image of the code's mean.
    if (!atRest && ifs::bends(*cage)) return std::nullopt;
    return atRest ? moments->mean : ifs::displayMap(*cage)(moments->mean);
}
template std::optional<ifs::Vector<2>> displayedMean(const Fractal&);
template std::optional<ifs::Vector<3>> displayedMean(const Fractal&);

} // namespace document
