// SPDX-License-Identifier: MIT
#include "document/edits/transform_edits.h"
#include "document/fractal_geometry.h"

#include "ifs/dimension/moments.h"
#include "ifs/links/linked_measure.h"
#include "ifs/system/decomposition.h"

#include <QtMath>

namespace document {

namespace {

ifs::Matrix<2> mirror(double axisDegrees) {
    return ifs::linearPart({2 * qDegreesToRadians(axisDegrees), 1, -1, 0});
}

// Quarter turns without the rounding of π.
ifs::Matrix<2> exactWhereItCanBe(ifs::Matrix<2> matrix) {
    return matrix.unaryExpr([](double x) { return qAbs(x) < 1e-16 ? 0.0 : x; });
}

} // namespace

ifs::AffineMap<2> affineMap(const Transformation& t) {
    ifs::Matrix<2> linear = ifs::linearPart({qDegreesToRadians(t.rotation), t.scaleX, t.scaleY, t.shear});
    if (t.reflect) linear = linear * mirror(t.axis);
    linear = exactWhereItCanBe(linear);
    const ifs::AffineMap<2> toOrigin{ifs::Matrix<2>::Identity(), -t.about};
    return ifs::AffineMap<2>{linear, t.about + t.translation} * toOrigin;
}

Fractal placed(Fractal fractal, const ifs::AffineMap<2>& transformation) {
    Shape<2>* shape = plane(fractal);
    if (!shape) return fractal;
    shape->cage = effectiveCage(fractal);
    for (auto& vertex : shape->cage->current)
        vertex = transformation(vertex);
    return fractal;
}

std::optional<Fractal> rewritten(Fractal fractal, const ifs::AffineMap<2>& transformation) {
    auto result = conjugated(fractal, transformation);
    if (!result) return std::nullopt;
    if (auto& cage = plane(*result)->cage) {
        for (auto* vertices : {&cage->rest, &cage->current}) {
            for (auto& vertex : *vertices)
                vertex = transformation(vertex);
        }
    }
    return result;
}

std::optional<ifs::Vector<2>> middleOfBox(const Fractal& fractal) {
    const auto box = displayedBox(fractal);
    return box ? std::optional<ifs::Vector<2>>((box->min + box->max) / 2) : std::nullopt;
}

std::optional<ifs::Vector<2>> displayedMean(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (!system) return std::nullopt;
    const ifs::ActiveMaps<2> active = ifs::activeMaps(*system);
    const auto moments = !active.isLinked()      ? ifs::moments(active)
                         : linkedExtent(fractal) ? ifs::linkedMoments(active)
                                                 : std::nullopt;
    if (!moments) return std::nullopt;
    const ifs::ControlCage<2>* cage = cage2(fractal);
    const bool atRest = !cage || cage->rest == cage->current;
    if (!atRest && ifs::bends(*cage)) return std::nullopt; // a bent picture's mean is no image of the code's
    return atRest ? moments->mean : ifs::displayMap(*cage)(moments->mean);
}

} // namespace document
