// SPDX-License-Identifier: MIT
#include "cage_edits.h"

#include <QCoreApplication>

#include <algorithm>

namespace view {

namespace {

constexpr std::size_t triangle = 3;
constexpr double relativeTolerance = 1e-10; // finer than anybody sees, and never slow

QString sentence(const char* text) {
    return QCoreApplication::translate("CageEdits", text);
}

ifs::Orientation<2> orientationOf(SimplexChoice choice) {
    const bool left = choice == SimplexChoice::MinusPlus || choice == SimplexChoice::MinusMinus;
    const bool down = choice == SimplexChoice::PlusMinus || choice == SimplexChoice::MinusMinus;
    return {left ? -1 : 1, down ? -1 : 1};
}

// The maps that act on the displayed picture and take part in it.
std::vector<ifs::AffineMap<2>> displayedMaps(const document::Fractal& fractal) {
    const document::System2* code = document::system2(fractal);
    if (!code) return {};
    const auto system = isAtRest(fractal) ? std::optional(*code) : document::effectiveSystem(fractal);
    return system ? ifs::activeMaps(*system).maps : std::vector<ifs::AffineMap<2>>{};
}

} // namespace

bool isAtRest(const document::Fractal& fractal) {
    return !fractal.cage || fractal.cage->rest == fractal.cage->current;
}

QString bakeObstacle(const document::Fractal& fractal) {
    if (!document::system2(fractal))
        return sentence(QT_TRANSLATE_NOOP("CageEdits", "This entry has no maps of the plane."));
    if (isAtRest(fractal))
        return sentence(
            QT_TRANSLATE_NOOP("CageEdits", "The cage is at rest: the code is what is displayed."));
    if (fractal.cage->current.size() != triangle)
        return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                          "A cage of more than three vertices bends the picture, and no "
                                          "affine code has a bent picture."));
    if (!ifs::isInvertible(*fractal.cage))
        return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                          "The cage is flat: no code has this picture. Open the triangle "
                                          "first."));
    return {};
}

std::optional<document::Fractal> baked(const document::Fractal& fractal) {
    if (!bakeObstacle(fractal).isEmpty()) return std::nullopt;
    const auto result = ifs::bake(*document::system2(fractal), *fractal.cage);
    if (!result) return std::nullopt;
    document::Fractal after = fractal;
    after.system = result->system;
    after.cage = result->cage;
    return after;
}

document::Fractal withCageAtRest(document::Fractal fractal) {
    if (fractal.cage) fractal.cage->current = fractal.cage->rest;
    return fractal;
}

std::optional<ifs::CanonicalSimplex<2>> displayedSimplex(const document::Fractal& fractal,
                                                         SimplexChoice choice) {
    const auto support = ifs::SupportFunction<2>::of(displayedMaps(fractal));
    if (!support) return std::nullopt;
    const double tolerance = relativeTolerance * support->radius();
    return choice == SimplexChoice::Minimal
               ? ifs::minimalCanonicalSimplex(*support, tolerance)
               : ifs::canonicalSimplex<2>(*support, orientationOf(choice), tolerance);
}

std::optional<document::Fractal> withCageFitted(const document::Fractal& fractal, SimplexChoice choice) {
    const auto simplex = displayedSimplex(fractal, choice);
    if (!simplex) return std::nullopt;
    document::Fractal after = fractal;
    if (!isAtRest(fractal)) {
        after.cage = ifs::redefine(*fractal.cage, simplex->vertices);
        return after.cage ? std::optional(after) : std::nullopt;
    }
    if (choice == SimplexChoice::Minimal)
        after.cage.reset(); // it then follows the code
    else
        after.cage = ifs::cageAtRest<2>(simplex->vertices);
    return after;
}

QString fitObstacle(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    if (!system) return sentence(QT_TRANSLATE_NOOP("CageEdits", "This entry has no maps of the plane."));
    if (ifs::activeMaps(*system).maps.empty())
        return sentence(QT_TRANSLATE_NOOP("CageEdits", "No map takes part, so there is nothing to enclose."));
    if (!isAtRest(fractal) && fractal.cage->current.size() != triangle)
        return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                          "A bent picture cannot be held by a triangle. Reset the cage "
                                          "first."));
    if (!isAtRest(fractal) && !ifs::isInvertible(*fractal.cage))
        return sentence(
            QT_TRANSLATE_NOOP("CageEdits", "The cage is flat. Open the triangle, or reset it, first."));
    if (!ifs::SupportFunction<2>::of(displayedMaps(fractal)))
        return sentence(
            QT_TRANSLATE_NOOP("CageEdits", "This system has no attractor that could be enclosed."));
    return {};
}

QString orientationText(const ifs::Orientation<2>& orientation) {
    const auto sign = [](int s) { return s < 0 ? QStringLiteral("−") : QStringLiteral("+"); };
    return QStringLiteral("(%1, %2)").arg(sign(orientation[0]), sign(orientation[1]));
}

} // namespace view
