// SPDX-License-Identifier: MIT
#include "document/fractal/fractal.h"

#include <cmath>
#include <utility>

namespace document {

namespace {

template <class Value> bool areSame(const Value* a, const Value* b) {
    return a && b ? *a == *b : a == b;
}

} // namespace

template <int Dim>
Shape<Dim>::Shape(ifs::IteratedFunctionSystem<Dim> code, std::optional<ifs::ControlCage<Dim>> held)
    : system(std::move(code)), cage(std::move(held)) {}
template <int Dim> Shape<Dim>::Shape(const Shape& other) = default;
template <int Dim> Shape<Dim>::Shape(Shape&& other) noexcept = default;
template <int Dim> Shape<Dim>& Shape<Dim>::operator=(const Shape& other) = default;
template <int Dim> Shape<Dim>& Shape<Dim>::operator=(Shape&& other) noexcept = default;
template <int Dim> Shape<Dim>::~Shape() = default;

template struct Shape<2>;
template struct Shape<3>;

Fractal::Fractal() = default;
Fractal::Fractal(const Fractal& other) = default;
Fractal::Fractal(Fractal&& other) noexcept = default;
Fractal& Fractal::operator=(const Fractal& other) = default;
Fractal& Fractal::operator=(Fractal&& other) noexcept = default;
Fractal::~Fractal() = default;

int dimension(const Fractal& fractal) {
    if (plane(fractal)) return 2;
    return space(fractal) ? 3 : 0;
}

bool isSameSystem(const Fractal& a, const Fractal& b) {
    return areSame(system2(a), system2(b)) && areSame(system3(a), system3(b));
}

Fractal sierpinskiTriangle() {
    const double height = std::sqrt(3.0) / 4;
    System2 system;
    for (const ifs::Vector<2>& corner :
         {ifs::Vector<2>(0, 0), ifs::Vector<2>(0.5, 0), ifs::Vector<2>(0.25, height)})
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, corner.x(), corner.y()), 1.0 / 3);
    Fractal fractal;
    fractal.name = QStringLiteral("sierpinski");
    fractal.shape = Shape<2>{std::move(system)};
    return fractal;
}

} // namespace document
