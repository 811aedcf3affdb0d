// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ifs {

using Integers = std::array<std::int64_t, 2>;

// The lattice that some vectors generate, if they do.
class Lattice {
public:
    explicit Lattice(double size); // `size` of the vectors

    bool isFull() const { return m_rank == 2; }
    const Matrix<2>& basis() const { return m_basis; }

    // Returns false when the vectors generate no lattice.
    bool add(Vector<2> v);

private:
    bool isAlong(const Vector<2>& v) const;
    Vector<2> reducedAlong(const Vector<2>& v);
    Vector<2> exchanged(const Vector<2>& v);

    Matrix<2> m_basis = Matrix<2>::Identity();
    int m_rank = 0;
    double m_tolerance;
};

// The integers that the coordinates are, nearly.
std::optional<Integers> integers(const Vector<2>& v);

} // namespace ifs
