// SPDX-License-Identifier: MIT
#include "ifs/tiles/lattice.h"

#include <Eigen/LU>

#include <cmath>

namespace ifs {

Lattice::Lattice(double size) : m_tolerance(1e-9 * size) {}

bool Lattice::add(Vector<2> v) {
    constexpr int maxRounds = 200;
    for (int round = 0; round < maxRounds; ++round) {
        if (m_rank == 2) v -= m_basis * Vector<2>(m_basis.inverse() * v).array().round().matrix();
        if (v.cwiseAbs().maxCoeff() <= m_tolerance) return true;
        if (m_rank < 2 && (m_rank == 0 || !isAlong(v))) {
            m_basis.col(m_rank++) = v;
            return true;
        }
        v = m_rank == 1 ? reducedAlong(v) : exchanged(v);
        if (m_rank == 2 && std::abs(m_basis.determinant()) <= m_tolerance * m_tolerance) return false;
    }
    return false;
}

bool Lattice::isAlong(const Vector<2>& v) const {
    const Vector<2> b = m_basis.col(0);
    return std::abs(b.x() * v.y() - b.y() * v.x()) <= m_tolerance * b.norm();
}

// Euclid's algorithm on a line: the rest that remains.
Vector<2> Lattice::reducedAlong(const Vector<2>& v) {
    const Vector<2> b = m_basis.col(0);
    const Vector<2> rest = v - std::round(v.dot(b) / b.squaredNorm()) * b;
    if (rest.cwiseAbs().maxCoeff() > m_tolerance)
        m_basis.col(0) = rest;
    else
        return rest;
    return b;
}

// v has coordinates of at most 1/2, so that it spans a finer lattice with one of the basis; the other remains
// to be added.
Vector<2> Lattice::exchanged(const Vector<2>& v) {
    const Vector<2> coordinates = m_basis.inverse() * v;
    const int out = std::abs(coordinates.x()) > std::abs(coordinates.y()) ? 0 : 1;
    const Vector<2> rest = m_basis.col(out);
    m_basis.col(out) = v;
    return rest;
}

std::optional<Integers> integers(const Vector<2>& v) {
    constexpr double maxEntry = 1e6, off = 1e-6;
    const Vector<2> rounded = v.array().round().matrix();
    if (!(rounded.cwiseAbs().maxCoeff() <= maxEntry) || (v - rounded).cwiseAbs().maxCoeff() > off)
        return std::nullopt;
    return Integers{std::int64_t(rounded.x()), std::int64_t(rounded.y())};
}

} // namespace ifs
