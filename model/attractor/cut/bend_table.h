// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/generalized_coordinates.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace attractor {

// A bend as small pieces of the plane see it. Third-order expansions over squares that are quartered where
// pieces ask for more, so that a piece costs a few multiplications. What depends on the corners at rest alone
// is kept from one bend to the next, and never changes a bit; the same bits on every machine.
class BendTable {
public:
    static constexpr double farthest = 0x1p16;

    // Switches to the pieces of this bend, which must outlive them, in the square centre ± halfSize.
    // Expansions are refined until they miss at most `tolerance` in displayed coordinates, or are small
    // beside the piece. `samePieces` says that most pieces are those of the bend before, and keeps what was
    // measured in them.
    void follow(const ifs::PolygonDeformation& bend, const ifs::Vector<2>& centre, double halfSize,
                double tolerance, bool samePieces = false);

    // The image of the parallelogram {x + a·spread₁ + b·spread₂ : |a|, |b| ≤ 1}:
    // value + linear·(a, b) + aa·a² + ab·ab + bb·b², but for `miss` at most; infinite where nothing is known.
    // Not a number beyond `farthest` cages from the cage, where coordinates have lost their digits.
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
        std::uint32_t children = 0; // index of the first of four children; 0: none
        std::uint32_t bend = 0;     // number of the last bend for which this was measured
        double error = 0;           // error of the expansion in the square; infinite without an expansion
        double feature = -1;        // radius in which coordinates vary slowly; −1: unknown
        ifs::PolygonDeformation::Expansion expansion;
        std::vector<ifs::Jet> coordinates;         // jets at the centre; empty without derivatives
        std::vector<std::array<double, 8>> misses; // errors of the expansions around the square
    };
    void restart(const ifs::PolygonDeformation& bend, const ifs::Vector<2>& centre, double half);
    void expand(Square& square);
    void measure(Square& square);
    double featureSize(const ifs::Vector<2>& x) const;
    struct Parallelogram {
        ifs::Vector<2> x;
        ifs::Matrix<2> spread;
        friend bool operator==(const Parallelogram&, const Parallelogram&) = default;
    };
    struct Hash {
        std::size_t operator()(const Parallelogram& piece) const;
    };
    std::span<const double> cornerCoordinates(const ifs::Vector<2>& x, const ifs::Matrix<2>& spread);
    void forgetPieces();
    double missOf(const Square& square, const ifs::Vector<2>& x, const ifs::Matrix<2>& spread);
    static double error(const Square& square, double distance, double radius);
    struct Found {
        std::size_t square = 0;
        double miss = 0;
    };
    Found find(const ifs::Vector<2>& x, double radius);

    const ifs::PolygonDeformation* m_bend = nullptr;
    std::uint32_t m_number = 0; // number of the bend
    double m_tolerance = 0;
    double m_farthest = 0; // greatest distance from the middle of the first square
    ifs::Coordinates m_kind = ifs::Coordinates::MeanValue;
    std::vector<ifs::Vector<2>> m_rest;
    std::vector<double> m_cornerSize; // half of the shorter edge at each corner
    std::vector<Square> m_squares;
    std::size_t m_expanded = 0; // number of expanded squares
    // Indices at which the coordinates of each piece begin.
    std::unordered_map<Parallelogram, std::size_t, Hash> m_pieces;
    std::vector<double> m_cornerCoordinates;
    bool m_keepsPieces = false;
};

} // namespace attractor
