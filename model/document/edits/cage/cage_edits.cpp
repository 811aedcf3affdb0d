// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"

#include "document/edits/cage/rounding.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"

#include "document/text/text.h"

#include <algorithm>

namespace document {

namespace {

constexpr double relativeTolerance = 1e-10; // imperceptible, and fast to reach

ifs::Orientation<2> orientationOf(SimplexChoice choice) {
    const bool left = choice == SimplexChoice::MinusPlus || choice == SimplexChoice::MinusMinus;
    const bool down = choice == SimplexChoice::PlusMinus || choice == SimplexChoice::MinusMinus;
    return {left ? -1 : 1, down ? -1 : 1};
}

// The same picture held by other vertices.
std::optional<Fractal> withPolygonThrough(const Fractal& fractal,
                                          const std::vector<ifs::Vector<2>>& vertices) {
    Fractal after = fractal;
    auto& cage = plane(after)->cage = ifs::redefine<2>(effectiveCage(fractal), vertices);
    return cage ? std::optional(after) : std::nullopt;
}

// The code takes up its cage (ifs::bake); nullopt where that cannot be.
template <int Dim> std::optional<Fractal> withCageBaked(const Fractal& fractal) {
    const auto* shape = std::get_if<Shape<Dim>>(&fractal.shape);
    if (!shape || !shape->cage) return std::nullopt;
    auto baked = ifs::bake(shape->system, *shape->cage);
    auto result = baked ? conjugated(fractal, ifs::displayMap(*shape->cage)) : std::nullopt;
    if (!result) return std::nullopt;
    dropRounding(baked->system);
    auto& after = std::get<Shape<Dim>>(result->shape);
    after.system = std::move(baked->system);
    after.cage = std::move(baked->cage);
    return result;
}

// The code that is shown where `cage` is, for the corners 0, e₁, …
template <int Dim>
std::optional<Fractal> withCageUnbaked(const Fractal& fractal, const ifs::ControlCage<Dim>& cage) {
    std::vector<ifs::Vector<Dim>> unit{ifs::Vector<Dim>::Zero()};
    for (int axis = 0; axis < Dim; ++axis)
        unit.push_back(ifs::Vector<Dim>::Unit(axis));
    Fractal after = fractal;
    std::get<Shape<Dim>>(after.shape).cage = ifs::ControlCage<Dim>{cage.rest, unit};
    auto result = withCageBaked<Dim>(after);
    if (result) std::get<Shape<Dim>>(result->shape).cage = ifs::ControlCage<Dim>{unit, cage.current};
    return result;
}

template <int Dim> bool areAlike(const ifs::ControlCage<Dim>* p, const ifs::ControlCage<Dim>* q) {
    if (!p || !q) return !p && !q;
    if (p->deformation != q->deformation || p->rest.size() != q->rest.size()) return false;
    const auto near = [](const std::vector<ifs::Vector<Dim>>& these,
                         const std::vector<ifs::Vector<Dim>>& those) {
        double size = 0;
        for (const ifs::Vector<Dim>& vertex : these)
            size = std::max(size, (vertex - these.front()).norm());
        return std::equal(these.begin(), these.end(), those.begin(), [size](const auto& v, const auto& w) {
            return (v - w).norm() <= 10 * relativeTolerance * size;
        });
    };
    return near(p->rest, q->rest) && near(p->current, q->current);
}

const ifs::ControlCage<3>* cage3(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    return shape && shape->cage ? &*shape->cage : nullptr;
}

// Asks about the stored cage; false without one.
template <class Ask> bool storedCage(const Fractal& fractal, Ask ask) {
    if (const auto* cage = cage3(fractal)) return ask(*cage);
    const auto* cage = cage2(fractal);
    return cage && ask(*cage);
}

} // namespace

bool isCageAlike(const Fractal& a, const Fractal& b) {
    return areAlike(cage2(a), cage2(b)) && areAlike(cage3(a), cage3(b));
}

bool isAtRest(const Fractal& fractal) {
    return !storedCage(fractal, [](const auto& cage) { return cage.rest != cage.current; });
}

QString planeObstacle(const Fractal& fractal) {
    if (system2(fractal)) return {};
    return Text::tr("This entry is not a system in the plane.");
}

QString cageObstacle(const Fractal& fractal) {
    return dimension(fractal) == 0 ? planeObstacle(fractal) : QString();
}

QString bakeObstacle(const Fractal& fractal) {
    if (const QString obstacle = cageObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (isAtRest(fractal)) return Text::tr("The cage is at rest: the picture shows the code.");
    if (storedCage(fractal, [](const auto& cage) { return ifs::bends(cage); }))
        return Text::tr("The cage bends the picture, and no affine code produces a bent picture. Choose "
                        "“Affine fit” to bake the closest affine placement.");
    if (!storedCage(fractal, [](const auto& cage) { return ifs::isInvertible(cage); }))
        return Text::tr(
            "The cage is flat, so its placement cannot be baked into the code. Open the cage first.");
    return {};
}

std::optional<Fractal> baked(const Fractal& fractal) {
    if (!bakeObstacle(fractal).isEmpty()) return std::nullopt;
    return space(fractal) ? withCageBaked<3>(fractal) : withCageBaked<2>(fractal);
}

QString resetObstacle(const Fractal& fractal) {
    if (dimension(fractal) == 0) return planeObstacle(fractal);
    if (isAtRest(fractal)) return Text::tr("The cage is at rest.");
    return {};
}

Fractal withCageAtRest(Fractal fractal) {
    if (Shape<2>* shape = plane(fractal); shape && shape->cage) shape->cage->current = shape->cage->rest;
    if (Shape<3>* shape = space(fractal); shape && shape->cage) shape->cage->current = shape->cage->rest;
    return fractal;
}

template <int Dim> Fractal withCageMoved(Fractal fractal, ifs::ControlCage<Dim> cage, CageMode mode) {
    if (auto* shape = std::get_if<Shape<Dim>>(&fractal.shape)) shape->cage = std::move(cage);
    if (mode == CageMode::Rewrite)
        if (auto rewritten = baked(fractal)) return *std::move(rewritten);
    return fractal;
}
template Fractal withCageMoved(Fractal, ifs::ControlCage<2>, CageMode);
template Fractal withCageMoved(Fractal, ifs::ControlCage<3>, CageMode);

QString modeText(const Fractal& fractal, CageMode mode) {
    const ifs::ControlCage<2>* cage = cage2(fractal);
    const bool bendable = cage && cage->rest.size() > 3 && cage->deformation == ifs::Deformation::Bend;
    if (mode == CageMode::Place)
        return Text::tr("Moving the cage moves the picture. Bake to change the code.");
    if (bendable)
        return Text::tr("Moving the whole cage rewrites the code. Moving single vertices bends the picture, "
                        "which no code can reproduce, so the code does not change.");
    return Text::tr("Moving the cage rewrites all coefficients of the code; "
                    "the cage is then at rest in its new position.");
}

QString unbakeObstacle(const Fractal& fractal) {
    if (const QString obstacle = cageObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (const Shape<3>* shape = space(fractal); shape && shape->system.maps.empty())
        return Text::tr("No map is active, so there is nothing to enclose.");
    if (!isAtRest(fractal)) return Text::tr("The cage is not at rest: it already holds a placement.");
    const std::size_t corners = dimension(fractal) + 1U;
    if (storedCage(fractal, [=](const auto& cage) { return cage.rest.size() != corners; }))
        return space(fractal) ? Text::tr("Only a cage with four vertices can be unbaked.")
                              : Text::tr("Only a cage with three vertices can be unbaked.");
    return {};
}

std::optional<Fractal> unbaked(const Fractal& fractal) {
    if (!unbakeObstacle(fractal).isEmpty()) return std::nullopt;
    return space(fractal) ? withCageUnbaked(fractal, *spaceCage(fractal))
                          : withCageUnbaked(fractal, effectiveCage(fractal));
}

QString cageWarning(const Fractal& fractal) {
    const ifs::ControlCage<2>* cage = cage2(fractal);
    if (!cage || !ifs::bends(*cage)) return {};
    // Either kind of coordinates suffices, and this one needs no certified hull.
    const auto kind =
        ifs::isStrictlyConvex(cage->rest) ? ifs::Coordinates::Wachspress : ifs::Coordinates::MeanValue;
    switch (ifs::flawOf(*cage, {*cage, kind})) {
    case ifs::CageFlaw::None:
        return {};
    case ifs::CageFlaw::Concave:
        return Text::tr("The cage is not convex: the picture may fold over itself at the notch.");
    case ifs::CageFlaw::Folded:
        return Text::tr(
            "The cage is folded: parts of the picture overlap. Move the vertices apart to unfold it.");
    }
    return {};
}

std::optional<ifs::CanonicalSimplex<2>> displayedSimplex(const Fractal& fractal, SimplexChoice choice) {
    const auto support = displayedSupport<2>(fractal);
    if (!support) return std::nullopt;
    const double tolerance = relativeTolerance * support->radius();
    return choice == SimplexChoice::Minimal
               ? ifs::minimalCanonicalSimplex(*support, tolerance)
               : ifs::canonicalSimplex<2>(*support, orientationOf(choice), tolerance);
}

std::optional<Fractal> withCageFitted(const Fractal& fractal, SimplexChoice choice) {
    if (space(fractal) && choice == SimplexChoice::Minimal) return withTetrahedronFitted(fractal);
    const auto simplex = displayedSimplex(fractal, choice);
    if (!simplex) return std::nullopt;
    Fractal after = fractal;
    auto& cage = plane(after)->cage;
    if (!isAtRest(fractal)) {
        cage = ifs::redefine(*cage2(fractal), simplex->vertices);
        return cage ? std::optional(after) : std::nullopt;
    }
    if (choice == SimplexChoice::Minimal)
        cage.reset(); // the cage follows the code from now on
    else
        cage = ifs::cageAtRest<2>(simplex->vertices);
    return after;
}

std::optional<std::vector<ifs::Vector<2>>> verticesAround(const Fractal& fractal, PolygonChoice choice,
                                                          int corners) {
    const auto support = displayedSupport<2>(fractal);
    if (!support) return std::nullopt;
    const auto fit = std::ranges::find(cageFits<2>(), choice, &CageFit<2>::choice);
    return fit->around(*support, 0, corners);
}

std::optional<Fractal> withCageAround(const Fractal& fractal, PolygonChoice choice, int corners) {
    const auto vertices = verticesAround(fractal, choice, corners);
    return vertices ? withPolygonThrough(fractal, *vertices) : std::nullopt;
}

QString fitObstacle(const Fractal& fractal) {
    if (space(fractal)) return spaceFitObstacle(fractal);
    if (const QString obstacle = planeObstacle(fractal); !obstacle.isEmpty()) return obstacle;
    if (ifs::activeMaps(*system2(fractal)).maps.empty())
        return Text::tr("No map is active, so there is nothing to enclose.");
    if (ifs::activeMaps(*system2(fractal)).isLinked())
        return Text::tr("The maps are linked; a cage cannot be fitted to linked maps.");
    const ifs::ControlCage<2>* cage = cage2(fractal);
    if (cage && ifs::bends(*cage))
        return Text::tr(
            "A bent picture cannot be given another cage. First reset the cage or choose “Affine fit”.");
    if (!isAtRest(fractal) && !ifs::isInvertible(*cage))
        return Text::tr("The cage is flat. First open or reset the triangle.");
    if (!displayedSupport<2>(fractal)) return Text::tr("This system has no attractor that can be enclosed.");
    return {};
}

QString orientationText(std::span<const int> orientation) {
    QStringList signs;
    for (const int sign : orientation)
        signs << (sign < 0 ? QStringLiteral("−") : QStringLiteral("+"));
    return u'(' + signs.join(QStringLiteral(", ")) + u')';
}

} // namespace document
