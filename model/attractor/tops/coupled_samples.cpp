// SPDX-License-Identifier: MIT
#include "attractor/tops/coupled_samples.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/samples/chaos_game.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace attractor {

namespace {

// The newest symbols of an orbit as a number in base N, the newest first, which is the order of the
// addresses.
class AddressRegister {
public:
    explicit AddressRegister(std::size_t maps) : m_maps(std::uint64_t(maps)) {
        if (m_maps < 2) return;
        while (m_first <= std::numeric_limits<std::uint64_t>::max() / 2 / m_maps / m_maps) {
            m_first *= m_maps;
            ++m_length;
        }
    }

    void push(std::uint32_t symbol) { m_value = symbol * m_first + m_value / m_maps; }
    std::uint64_t value() const { return m_value; }
    double coordinate() const { return double(m_value) / double(m_first) / double(m_maps); }
    // Those of a value, the newest first.
    void read(std::uint64_t value, std::vector<std::uint32_t>& symbols) const {
        symbols.clear();
        std::uint64_t place = m_first;
        for (int k = 0; k < m_length; ++k, place /= m_maps)
            symbols.push_back(std::uint32_t(value / place % m_maps));
    }

private:
    std::uint64_t m_maps;
    std::uint64_t m_first = 1; // the place of the newest symbol
    std::uint64_t m_value = 0;
    int m_length = 1;
};

struct Sample {
    std::uint64_t code;
    ifs::Vector<2> from, to;
    double address;
    double stretch;
};

// By how much T magnifies areas near samples, in the order of their addresses: what their beginnings have in
// common is worked out once.
class Stretches {
public:
    Stretches(const CoupledSystem& system, double pieceSize) : m_system(system), m_pieceSize(pieceSize) {
        m_pieces.push_back({.isSmall = 1 <= pieceSize});
    }

    double at(const std::vector<std::uint32_t>& symbols) {
        const auto limit = std::min(m_symbols.size(), symbols.size());
        const auto first = symbols.begin();
        const auto common = std::mismatch(first, first + std::ptrdiff_t(limit), m_symbols.begin()).first;
        m_pieces.resize(std::min(m_pieces.size(), std::size_t(common - first) + 1));
        m_symbols = symbols;
        while (m_pieces.size() <= symbols.size() && !m_pieces.back().isSmall) {
            const Piece& piece = m_pieces.back();
            const std::uint32_t symbol = symbols[m_pieces.size() - 1];
            const ifs::Matrix<2> longer = piece.from * m_system.from[symbol].linear;
            if (!(longer.squaredNorm() > 0)) break; // a point: what is known of the piece before must do
            m_pieces.push_back({longer, piece.to * m_system.to[symbol].linear,
                                piece.ratio * m_system.areaRatios[symbol],
                                ifs::spectralNorm<2>(longer) <= m_pieceSize});
        }
        const Piece& found = m_pieces.back();
        return stretchOf(found.ratio, found.to, found.from);
    }

private:
    struct Piece {
        ifs::Matrix<2> from = ifs::Matrix<2>::Identity(), to = from;
        double ratio = 1;
        bool isSmall = false;
    };
    const CoupledSystem& m_system;
    double m_pieceSize;
    std::vector<std::uint32_t> m_symbols; // of the sample before
    std::vector<Piece> m_pieces;          // of its beginnings, the whole first
};

std::vector<Sample> orbit(const CoupledSystem& system, std::uint64_t seed, std::size_t size,
                          double pieceSize) {
    const AliasTable table(system.probabilities);
    AddressRegister newest(system.from.size());
    std::uint64_t random = mixed(seed);
    Sample sample{0, system.fromTop, system.toTop, 0, 1};
    std::vector<Sample> samples;
    for (std::size_t n = 0; n < size; ++n) {
        const std::uint32_t i = table.draw(std::uint32_t(mixed(random++) >> 32));
        sample.from = system.from[i](sample.from);
        sample.to = system.to[i](sample.to);
        newest.push(i);
        sample.code = newest.value();
        sample.address = newest.coordinate();
        samples.push_back(sample);
    }
    std::ranges::stable_sort(samples, {}, &Sample::code);
    Stretches stretches(system, pieceSize);
    std::vector<std::uint32_t> symbols;
    for (Sample& each : samples) {
        newest.read(each.code, symbols);
        each.stretch = stretches.at(symbols);
    }
    return samples;
}

} // namespace

CoupledSamples coupledSamples(const CoupledSystem& system, std::uint64_t seed, std::size_t size,
                              double pieceSize) {
    const auto samples = orbit(system, seed, size, pieceSize);
    const auto& h = system.around.heights;
    CoupledSamples result;
    result.size = samples.size();
    result.centre = {(h[0] - h[8]) / 2, (h[4] - h[12]) / 2};
    const double extent = std::max(h[0] + h[8], h[4] + h[12]) / 2;
    result.scale = extent > 0 ? extent : 1;
    for (const Sample& sample : samples) {
        const ifs::Vector<2> inBox = (sample.from - result.centre) / result.scale;
        result.x.push_back(float(inBox.x()));
        result.y.push_back(float(inBox.y()));
        result.images.push_back({sample.to.x(), sample.to.y(), sample.address, sample.stretch});
    }
    for (; result.x.size() % CoupledSamples::lanes != 0 && !samples.empty();) {
        result.x.push_back(result.x.back());
        result.y.push_back(result.y.back());
    }
    return result;
}

} // namespace attractor
