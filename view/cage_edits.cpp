// SPDX-License-Identifier: MIT
#include "cage_edits.h"

#include "ifs/hull_cage.h"

#include <QCoreApplication>

#include <algorithm>

namespace view {

namespace {

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

// The same picture held by other vertices.
std::optional<document::Fractal> withCageThrough(const document::Fractal& fractal,
                                                 const std::vector<ifs::Vector<2>>& vertices) {
    document::Fractal after = fractal;
    after.cage = ifs::redefine<2>(document::effectiveCage(fractal), vertices);
    return after.cage ? std::optional(after) : std::nullopt;
}

} // namespace

bool isCageAlike(const document::Fractal& a, const document::Fractal& b) {
    if (!a.cage || !b.cage) return !a.cage && !b.cage;
    if (a.cage->deformation != b.cage->deformation || a.cage->rest.size() != b.cage->rest.size())
        return false;
    const auto near = [](const std::vector<ifs::Vector<2>>& p, const std::vector<ifs::Vector<2>>& q) {
        double size = 0;
        for (const ifs::Vector<2>& vertex : p)
            size = std::max(size, (vertex - p.front()).norm());
        return std::equal(p.begin(), p.end(), q.begin(), [size](const auto& v, const auto& w) {
            return (v - w).norm() <= 10 * relativeTolerance * size;
        });
    };
    return near(a.cage->rest, b.cage->rest) && near(a.cage->current, b.cage->current);
}

bool isAtRest(const document::Fractal& fractal) {
    return !fractal.cage || fractal.cage->rest == fractal.cage->current;
}

QString planeObstacle(const document::Fractal& fractal) {
    if (document::system2(fractal)) return {};
    return sentence(QT_TRANSLATE_NOOP("CageEdits", "This entry has no maps of the plane."));
}

QString bakeObstacle(const document::Fractal& fractal) {
    if (const QString obstacle = planeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (isAtRest(fractal))
        return sentence(
            QT_TRANSLATE_NOOP("CageEdits", "The cage is at rest: the code is what is displayed."));
    if (ifs::bends(*fractal.cage))
        return sentence(QT_TRANSLATE_NOOP(
            "CageEdits", "The cage bends the picture, and no affine code has a bent picture. "
                         "Choose “Affine fit” to bake what comes nearest to it."));
    if (!ifs::isInvertible(*fractal.cage))
        return sentence(QT_TRANSLATE_NOOP(
            "CageEdits", "The cage is flat: no code has this picture. Open the cage first."));
    return {};
}

std::optional<document::Fractal> baked(const document::Fractal& fractal) {
    return bakeObstacle(fractal).isEmpty() ? document::withCageBaked(fractal) : std::nullopt;
}

QString resetObstacle(const document::Fractal& fractal) {
    if (const QString obstacle = planeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (isAtRest(fractal)) return sentence(QT_TRANSLATE_NOOP("CageEdits", "The cage is at rest."));
    return {};
}

document::Fractal withCageAtRest(document::Fractal fractal) {
    if (fractal.cage) fractal.cage->current = fractal.cage->rest;
    return fractal;
}

document::Fractal withCageMoved(document::Fractal fractal, ifs::ControlCage<2> cage,
                                document::CageMode mode) {
    fractal.cage = std::move(cage);
    if (mode == document::CageMode::Rewrite)
        if (auto rewritten = baked(fractal)) return *std::move(rewritten);
    return fractal;
}

QString modeText(const document::Fractal& fractal, document::CageMode mode) {
    const bool bendable =
        fractal.cage && fractal.cage->rest.size() > 3 && fractal.cage->deformation == ifs::Deformation::Bend;
    if (mode == document::CageMode::Place)
        return sentence(QT_TRANSLATE_NOOP(
            "CageEdits", "Moving the cage moves the picture. The code stays as it is until you bake."));
    if (bendable)
        return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                          "Moving the whole cage rewrites the code. Moving single vertices "
                                          "bends the picture, which no code can follow, and leaves it."));
    return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                      "Moving the cage rewrites every coefficient of the code, and the cage "
                                      "rests where it is."));
}

QString unbakeObstacle(const document::Fractal& fractal) {
    if (const QString obstacle = planeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (!isAtRest(fractal))
        return sentence(QT_TRANSLATE_NOOP("CageEdits", "The cage already places the code."));
    if (fractal.cage && fractal.cage->rest.size() != 3)
        return sentence(QT_TRANSLATE_NOOP("CageEdits", "Only a triangle can be taken out of the code."));
    return {};
}

std::optional<document::Fractal> unbaked(const document::Fractal& fractal) {
    if (!unbakeObstacle(fractal).isEmpty()) return std::nullopt;
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    const std::vector<ifs::Vector<2>> unit{{0, 0}, {1, 0}, {0, 1}};
    document::Fractal after = fractal;
    after.cage = {cage.rest, unit};
    auto result = document::withCageBaked(after);
    if (result) result->cage = {unit, cage.current};
    return result;
}

QString cageWarning(const document::Fractal& fractal) {
    if (!fractal.cage || !ifs::bends(*fractal.cage)) return {};
    // Either kind of coordinates tells, and this one needs no certified hull.
    const auto kind = ifs::isStrictlyConvex(fractal.cage->rest) ? ifs::Coordinates::Wachspress
                                                                : ifs::Coordinates::MeanValue;
    switch (ifs::flawOf(*fractal.cage, {*fractal.cage, kind})) {
    case ifs::CageFlaw::None:
        return {};
    case ifs::CageFlaw::Concave:
        return sentence(
            QT_TRANSLATE_NOOP("CageEdits", "The cage has a notch: the picture may fold over itself there."));
    case ifs::CageFlaw::Folded:
        return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                          "The cage is folded: parts of the picture lie over one another. "
                                          "Move the vertices apart to unfold it."));
    }
    return {};
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

std::optional<document::Fractal> withCageAround(const document::Fractal& fractal, PolygonChoice choice,
                                                int corners) {
    const auto support = ifs::SupportFunction<2>::of(displayedMaps(fractal));
    if (!support) return std::nullopt;
    if (choice == PolygonChoice::Box) {
        const auto box = ifs::boundingBox(*support, relativeTolerance * support->radius());
        const ifs::Vector<2> low = box.min - ifs::Vector<2>::Constant(box.error);
        const ifs::Vector<2> high = box.max + ifs::Vector<2>::Constant(box.error);
        return withCageThrough(fractal, {low, {high.x(), low.y()}, high, {low.x(), high.y()}});
    }
    const auto around = ifs::enlargedHull(*support);
    return withCageThrough(fractal, choice == PolygonChoice::Hull
                                        ? ifs::simplifiedHull(around, corners)
                                        : ifs::regularPolygonAround(around, corners));
}

QString fitObstacle(const document::Fractal& fractal) {
    if (const QString obstacle = planeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (ifs::activeMaps(*document::system2(fractal)).maps.empty())
        return sentence(QT_TRANSLATE_NOOP("CageEdits", "No map takes part, so there is nothing to enclose."));
    if (fractal.cage && ifs::bends(*fractal.cage))
        return sentence(QT_TRANSLATE_NOOP("CageEdits",
                                          "A bent picture cannot be held by another cage. Reset the cage, or "
                                          "choose “Affine fit”, first."));
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
