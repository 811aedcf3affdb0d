// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/sample_set.h"
#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/address_strata.h"
#include "attractor/samples/prepared_system.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// Draws map i with probability p_i from one 32-bit number: its lowest bits choose a slot; the whole, read as
// a signed number, decides between the map of the slot's number and the slot's alias. A power of two of
// slots, at least 16.
class AliasTable {
public:
    explicit AliasTable(const std::vector<double>& probabilities);

    std::size_t size() const { return m_alias.size(); }
    std::uint32_t draw(std::uint32_t random) const {
        const std::size_t slot = random & (size() - 1);
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(random) < m_threshold[slot]
                                              ? static_cast<std::int32_t>(slot)
                                              : m_alias[slot]);
    }
    // Thresholds and aliases, an entry for each slot.
    const std::vector<std::int32_t>& thresholds() const { return m_threshold; }
    const std::vector<std::int32_t>& aliases() const { return m_alias; }

private:
    std::vector<std::int32_t> m_threshold;
    std::vector<std::int32_t> m_alias;
};

// The tables that draw the next map, one for each map; a single one if maps are not linked.
std::vector<AliasTable> nextMaps(const PreparedSystem& system);

// An orbit that is farther from the middle than this, in half boxes, has escaped.
inline constexpr float escapeRadius = 1e6F;

// Fills the ends of the arrays of a sample set, from which kernels read beyond its size.
void repeatBeginning(std::vector<float>& values);

// Draws samples of maps that are not linked: 64 orbits that have forgotten their start, with streams of their
// own for every (seed, pass). The same bits whatever the instruction set. An orbit that escapes begins anew
// in the middle of the box. Neighbours along an orbit are correlated; strata of the same system undo that.
void drawSamples(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass, SampleSet& samples,
                 const AddressStrata* strata = nullptr);

struct PointExtremes {
    float lowX = 0, highX = 0, lowY = 0, highY = 0;
};

// Fills both arrays, whose size is a multiple of 64, with points that are drawn in the same way, in box
// coordinates: as many as are wanted, without the strata and the copies that pictures need.
PointExtremes drawPoints(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass,
                         std::span<float> x, std::span<float> y);

// The seed paper's chaos game: one orbit from a fixed point of the first map (or the origin) of which the
// first `skipped` points are not plotted. An orbit that escapes begins anew. Of linked maps, the orbit begins
// in the middle of the box, and the first map is drawn as all are in the long run.
class Orbit {
public:
    static constexpr int skipped = 14;

    // With dropped = 0, next() begins with the points that are not plotted.
    Orbit(const PreparedSystem& system, std::uint64_t seed, int dropped = skipped,
          ColourCoordinates colours = {}); // empty: colours along the address

    struct Point {
        ifs::Vector<2> x;             // displayed position
        std::uint32_t lastMap = 0;    // index among the maps that take part
        double addressCoordinate = 0; // Σ σ_k N^−k, newest map first
        double colourCoordinate = 0;
    };
    Point next(); // next point to plot

private:
    void step();
    const ifs::AffineMap<2>& change() const; // change of the piece that contains the point

    const PreparedSystem* m_system; // must outlive the orbit
    ColourCoordinates m_colours;
    std::vector<AliasTable> m_next; // alias tables of nextMaps()
    std::vector<ifs::MovedBranch<2>> m_pieces;
    ifs::Word m_address; // address of the point, long enough to determine its piece
    Point m_point;       // current point
    double m_farAway = 0;
    std::uint64_t m_random = 0;
};

} // namespace attractor
