// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "attractor/request/appearance.h"
#include "attractor/request/space_appearance.h"
#include "document/fractal/lasting_cage.h"
#include "document/fractal/map_labels.h"
#include "document/fractal/support_cache.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/iterated_function_system.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <variant>
#include <vector>

namespace document {

using System2 = ifs::IteratedFunctionSystem<2>;
using System3 = ifs::IteratedFunctionSystem<3>;

// A branch, by the ids of the maps of its address, that is shown elsewhere: ifs::MovedBranch.
template <int Dim> using MovedBranch = animation::BranchPose<Dim>;

// The code of an entry, the cage that holds it, and the branches that are shown elsewhere.
template <int Dim> struct Shape {
    // Defined in one source, because many files copy shapes.
    Shape(ifs::IteratedFunctionSystem<Dim> code = {}, std::optional<ifs::ControlCage<Dim>> held = {});
    Shape(const Shape& other);
    Shape(Shape&& other) noexcept;
    Shape& operator=(const Shape& other);
    Shape& operator=(Shape&& other) noexcept;
    ~Shape();

    ifs::IteratedFunctionSystem<Dim> system;
    // nullopt: in the plane, the minimal canonical simplex of the code, at rest
    std::optional<ifs::ControlCage<Dim>> cage{};
    std::vector<MovedBranch<Dim>> moved{};                // words are unique
    std::optional<animation::Animation<Dim>> animation{}; // must satisfy animation::isValid()

    friend bool operator==(const Shape&, const Shape&) = default;
};

// An entry of a file, as a plain value.
struct Fractal {
    // Defined in one source, because many files copy fractals.
    Fractal();
    Fractal(const Fractal& other);
    Fractal(Fractal&& other) noexcept;
    Fractal& operator=(const Fractal& other);
    Fractal& operator=(Fractal&& other) noexcept;
    ~Fractal();

    QString name;
    QString headerComment; // text after the opening brace, without the semicolon
    QStringList comments;  // comment lines of the entry in their order, without the semicolon
    // monostate: the entry could not be read; its bytes are kept in its source.
    std::variant<std::monostate, Shape<2>, Shape<3>> shape;
    attractor::Appearance appearance;
    attractor::SpaceAppearance inSpace{}; // entries in space only; the fog is in range, the clip usable
    MapLabels mapLabels{};
    SupportCache supports{}; // cached results of functions of the fractal; ignored by ==
    LastingCage lasting{};   // set by Document at a moment or in a gesture; ignored by ==

    friend bool operator==(const Fractal&, const Fractal&) = default;
};

int dimension(const Fractal& fractal); // 2 or 3; 0 for an unreadable entry

// The shape of the entry; nullptr if it has the other dimension or could not be read.
inline const Shape<2>* plane(const Fractal& fractal) {
    return std::get_if<Shape<2>>(&fractal.shape);
}
inline Shape<2>* plane(Fractal& fractal) {
    return std::get_if<Shape<2>>(&fractal.shape);
}
inline const Shape<3>* space(const Fractal& fractal) {
    return std::get_if<Shape<3>>(&fractal.shape);
}
inline Shape<3>* space(Fractal& fractal) {
    return std::get_if<Shape<3>>(&fractal.shape);
}

// The system alone; nullptr as above.
inline const System2* system2(const Fractal& fractal) {
    const Shape<2>* shape = plane(fractal);
    return shape ? &shape->system : nullptr;
}
inline System2* system2(Fractal& fractal) {
    Shape<2>* shape = plane(fractal);
    return shape ? &shape->system : nullptr;
}
inline const System3* system3(const Fractal& fractal) {
    const Shape<3>* shape = space(fractal);
    return shape ? &shape->system : nullptr;
}
inline System3* system3(Fractal& fractal) {
    Shape<3>* shape = space(fractal);
    return shape ? &shape->system : nullptr;
}
// The stored cage of an entry in the plane; nullptr without one, and as above.
inline const ifs::ControlCage<2>* cage2(const Fractal& fractal) {
    const Shape<2>* shape = plane(fractal);
    return shape && shape->cage ? &*shape->cage : nullptr;
}

// Returns true if the codes are the same, whatever cage holds them.
bool isSameSystem(const Fractal& a, const Fractal& b);

Fractal sierpinskiTriangle(); // fractal of File → New

} // namespace document
