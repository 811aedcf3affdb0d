// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/generalized_coordinates.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// A bend as small pieces of the plane see it. Third-order expansions over squares that are quartered where
// pieces ask for more, so that a piece costs a few multiplications. The same bits on every machine.
class BendTable {
public:
    // For pieces in the square centre ± halfSize; expansions are refined until they miss at most `tolerance`
    // in displayed coordinates, or are small beside the piece. The bend must outlive the table.
    BendTable(const ifs::PolygonDeformation& bend, const ifs::Vector<2>& centre, double halfSize,
              double tolerance);

    // The image of the parallelogram {x + a·spread₁ + b·spread₂ : |a|, |b| ≤ 1}:
    // value + linear·(a, b) + aa·a² + ab·ab + bb·b², but for `miss` at most; infinite where nothing is known.
    struct Piece {
        ifs::Vector<2> value;
        ifs::Matrix<2> linear;
        ifs::Vector<2> aa, ab, bb;
        ifs::Vector<2> miss;

        // a² runs from 0 to 1: with half of it in the value, a first-order map misses but the other half.
        ifs::Vector<2> middle() const { return value + 0.5 * (aa + bb); }
        ifs::Vector<2> curvature() const { return 0.5 * (aa.cwiseAbs() + bb.cwiseAbs()) + ab.cwiseAbs(); }
    };
    Piece piece(const ifs::Vector<2>& x, const ifs::Matrix<2>& spread);

private:
    struct Square {
        Square(const ifs::Vector<2>& c, double h) : centre(c), half(h) {}
        ifs::Vector<2> centre;
        double half;
        double error = -1; // of the expansion, in the square; infinite where there is none; −1: not measured
        double feature = 0;         // how far around it the bend is known to vary slowly
        std::uint32_t children = 0; // first of four; 0: not quartered
        ifs::PolygonDeformation::Expansion expansion;
    };
    void measure(Square& square) const;
    double featureSize(const ifs::Vector<2>& x) const;
    static double error(const Square& square, double distance, double radius);
    struct Found {
        std::size_t square = 0;
        double miss = 0;
    };
    Found find(const ifs::Vector<2>& x, double radius);

    const ifs::PolygonDeformation& m_bend;
    double m_tolerance;
    std::vector<double> m_cornerSize; // half of the shorter edge at each corner
    std::vector<Square> m_squares;
};

} // namespace attractor
