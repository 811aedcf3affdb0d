// SPDX-License-Identifier: MIT
#include "dialogs/transform_edits.h"

#include "ifs/decomposition.h"
#include "ifs/moments.h"

#include <QtMath>

namespace view {

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

document::Fractal placed(document::Fractal fractal, const ifs::AffineMap<2>& transformation) {
    auto cage = document::effectiveCage(fractal);
    for (auto& vertex : cage.current)
        vertex = transformation(vertex);
    fractal.cage = std::move(cage);
    return fractal;
}

std::optional<document::Fractal> rewritten(document::Fractal fractal,
                                           const ifs::AffineMap<2>& transformation) {
    auto result = document::conjugated(fractal, transformation);
    if (result && result->cage) {
        for (auto* vertices : {&result->cage->rest, &result->cage->current}) {
            for (auto& vertex : *vertices)
                vertex = transformation(vertex);
        }
    }
    return result;
}

std::optional<ifs::Vector<2>> middleOfBox(const document::Fractal& fractal) {
    const auto box = document::displayedBox(fractal);
    return box ? std::optional<ifs::Vector<2>>((box->min + box->max) / 2) : std::nullopt;
}

std::optional<ifs::Vector<2>> displayedMean(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    if (!system) return std::nullopt;
    const auto moments = ifs::moments(ifs::activeMaps(*system));
    if (!moments) return std::nullopt;
    const bool atRest = !fractal.cage || fractal.cage->rest == fractal.cage->current;
    if (!atRest && ifs::bends(*fractal.cage))
        return std::nullopt; // a bent picture's mean is no image of the code's
    return atRest ? moments->mean : ifs::displayMap(*fractal.cage)(moments->mean);
}

} // namespace view
