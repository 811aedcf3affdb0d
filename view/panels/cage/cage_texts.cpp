// SPDX-License-Identifier: MIT
#include "panels/cage/cage_texts.h"

#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "ifs/system/barycentric.h"
#include "io/report/figure_error.h"
#include "widgets/numbers/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace view {

namespace {

constexpr std::size_t triangleSize = 3;
constexpr double roundingShare = 4 * std::numeric_limits<double>::epsilon();
constexpr double spaceTolerance = 1e-9; // relative to the simplex in space; finer than its digits

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(view::CagePanel)
};

} // namespace

QString cageStatus(const document::Fractal& fractal, const ifs::ControlCage<2>& cage) {
    const std::size_t count = cage.current.size();
    if (isAtRest(fractal))
        return count == triangleSize
                   ? Texts::tr("At rest: the picture shows the code.")
                   : Texts::tr("%1 vertices, at rest: the picture shows the code.").arg(count);
    if (ifs::bends(cage)) {
        const bool smooth =
            document::placement(fractal).bend()->coordinates() == ifs::Coordinates::Wachspress;
        return smooth ? Texts::tr("%1 vertices: bent by Wachspress coordinates; cannot be baked.").arg(count)
                      : Texts::tr("%1 vertices: bent by mean value coordinates; cannot be baked.").arg(count);
    }
    if (!ifs::isInvertible(cage))
        return Texts::tr("Flat: the picture is squeezed onto a line. Open the cage to get it back.");
    const double factor = ifs::determinant<2>(ifs::displayMap(cage).linear);
    return factor < 0
               ? Texts::tr(
                     "Placed and mirrored: areas change by the factor %1, and the orientation is reversed.")
                     .arg(shortNumber(-factor))
               : Texts::tr("Placed: areas change by the factor %1.").arg(shortNumber(factor));
}

QString cageStatus(const document::Fractal& fractal, const ifs::ControlCage<3>& cage) {
    if (isAtRest(fractal))
        return cage.rest.size() == 4
                   ? Texts::tr("At rest: the picture shows the code.")
                   : Texts::tr("%1 vertices, at rest: the picture shows the code.").arg(cage.rest.size());
    if (ifs::bends(cage))
        return Texts::tr("%1 vertices: bent by mean value coordinates, cannot be baked.")
            .arg(cage.rest.size());
    if (!ifs::isInvertible(cage))
        return Texts::tr("Flat: the solid is squeezed onto a plane or a line. Open the cage to get it back.");
    const double factor = ifs::determinant<3>(ifs::displayMap(cage).linear);
    return factor < 0
               ? Texts::tr(
                     "Placed and mirrored: volumes change by the factor %1, and the orientation is reversed.")
                     .arg(shortNumber(-factor))
               : Texts::tr("Placed: volumes change by the factor %1.").arg(shortNumber(factor));
}

template <int Dim> double roundingIn(const ifs::ControlCage<Dim>& cage) {
    double size = 0;
    for (const auto* vertices : {&cage.current, &cage.rest})
        for (const auto& vertex : *vertices)
            size = std::max(size, vertex.norm());
    return roundingShare * size;
}

template double roundingIn(const ifs::ControlCage<2>&);
template double roundingIn(const ifs::ControlCage<3>&);

template <int Dim> QString barycentricText(const ifs::ControlCage<Dim>& cage, const ifs::Vector<Dim>& point) {
    if (cage.current.empty()) return {};
    if (cage.current.size() != Dim + 1)
        return Dim == 2 ? Texts::tr("Available for triangles only.")
                        : Texts::tr("Available for tetrahedra only.");
    ifs::Simplex<Dim> simplex;
    std::copy(cage.current.begin(), cage.current.end(), simplex.begin());
    if (!ifs::isAffineBasis<Dim>(simplex))
        return Dim == 2 ? Texts::tr("The triangle is flat: it defines no coordinates.")
                        : Texts::tr("The tetrahedron is flat: it defines no coordinates.");
    // Clears weights that are 0 up to rounding, for points on a face.
    ifs::Matrix<Dim> edges;
    double size = point.norm();
    for (int k = 0; k < Dim; ++k) {
        edges.col(k) = simplex[std::size_t(k) + 1] - simplex[0];
        size = std::max({size, simplex[0].norm(), simplex[std::size_t(k) + 1].norm()});
    }
    const double rounding = roundingShare * size * ifs::Matrix<Dim>(edges.inverse()).norm();
    QStringList weights;
    for (const double weight : ifs::barycentric<Dim>(simplex, point))
        weights << shortNumber(io::withoutNoise(weight, rounding));
    return u'(' + weights.join(QStringLiteral(", ")) + u')';
}

template QString barycentricText(const ifs::ControlCage<2>&, const ifs::Vector<2>&);
template QString barycentricText(const ifs::ControlCage<3>&, const ifs::Vector<3>&);

QString enclosingSimplexText(const document::Fractal& fractal) {
    if (const auto cage = document::spaceCage(fractal)) {
        if (ifs::bends(*cage)) return fitObstacle(fractal);
        const auto support = document::spaceSupport(fractal);
        if (!support) return Texts::tr("This system has no attractor that can be enclosed.");
        const ifs::AffineMap<3> display = ifs::displayMap(*cage);
        const double size = support->radius() * ifs::spectralNorm<3>(display.linear);
        const auto simplex = ifs::minimalCanonicalSimplexOfImage(display, *support, spaceTolerance * size);
        const ifs::Vector<3> corner = io::withoutNoise(simplex.vertices[0], simplex.error);
        return Texts::tr("%1, leg %2, corner (%3, %4, %5)")
            .arg(document::orientationText(simplex.orientation), shortNumber(simplex.leg),
                 shortNumber(corner.x()), shortNumber(corner.y()), shortNumber(corner.z()));
    }
    const auto simplex = displayedSimplex(fractal, document::SimplexChoice::Minimal);
    if (!simplex) return fitObstacle(fractal);
    const ifs::Vector<2> corner = io::withoutNoise(simplex->vertices[0], simplex->error);
    return Texts::tr("%1, leg %2, corner (%3, %4)")
        .arg(document::orientationText(simplex->orientation), shortNumber(simplex->leg),
             shortNumber(corner.x()), shortNumber(corner.y()));
}

template <int Dim>
QString stepText(const QString& pattern, std::size_t vertex, const ifs::Vector<Dim>& position) {
    QString text = pattern.arg(vertex + 1);
    for (const double x : io::withoutNoise(position, roundingShare * position.norm()))
        text = text.arg(shortNumber(x));
    return text;
}

template QString stepText(const QString&, std::size_t, const ifs::Vector<2>&);
template QString stepText(const QString&, std::size_t, const ifs::Vector<3>&);

} // namespace view
