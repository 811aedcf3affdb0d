// SPDX-License-Identifier: MIT
#include "attractor/tops/coupled_samples.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/samples/chaos_game.h"

#include <algorithm>
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
    double coordinate(std::uint64_t value) const { return double(value) / double(m_first) / double(m_maps); }

    std::uint64_t maps() const { return m_maps; }
    std::uint64_t values() const { return m_first * m_maps; } // number of values
    std::size_t length() const { return m_length; }

private:
    std::uint64_t m_maps;
    std::uint64_t m_first = 1; // place of the newest symbol
    std::uint64_t m_value = 0;
    std::size_t m_length = 1;
};

// The beginnings of values that come in increasing order. The values of a beginning are neighbours.
class Beginnings {
public:
    Beginnings(const CoupledSystem& system, const AddressRegister& addresses, double pieceSize,
               CoupledSamples& result)
        : m_system(system), m_addresses(addresses), m_pieceSize(pieceSize), m_result(result) {
        m_result.linear.push_back(ifs::Matrix<2>::Identity());
        m_open.push_back({0, addresses.values(), 0, 1 <= pieceSize});
    }

    // Shortest beginning whose piece is small, as a number in the tree.
    std::uint32_t of(std::uint64_t value) {
        while (m_open.size() > 1 && value - m_open.back().first >= m_open.back().values)
            m_open.pop_back();
        while (m_open.size() <= m_addresses.length() && !m_open.back().isSmall) {
            const Piece piece = m_open.back();
            const std::uint64_t values = piece.values / m_addresses.maps();
            const std::uint64_t symbol = (value - piece.first) / values;
            const ifs::Matrix<2> linear =
                m_result.linear[piece.word] * m_system.from[std::size_t(symbol)].linear;
            if (!(linear.squaredNorm() > 0)) break; // single point: uses the previous piece
            m_open.push_back({piece.first + symbol * values, values,
                              m_result.tree.longer(piece.word, std::size_t(symbol)),
                              ifs::spectralNorm<2>(linear) <= m_pieceSize});
            m_result.linear.push_back(linear);
        }
        return m_open.back().word;
    }

private:
    struct Piece {
        std::uint64_t first, values; // values that begin with the word
        std::uint32_t word;
        bool isSmall;
    };
    const CoupledSystem& m_system;
    const AddressRegister& m_addresses;
    double m_pieceSize;
    CoupledSamples& m_result;
    std::vector<Piece> m_open; // pieces of the previous value, largest first
};

struct Sample {
    std::uint64_t value;
    std::uint32_t index;
};

// Fills in the steps; by rank, the values.
std::vector<Sample> sorted(const CoupledSystem& system, std::uint64_t seed, AddressRegister& newest,
                           std::vector<CoupledSamples::Step>& orbit) {
    const AliasTable table(system.probabilities);
    std::uint64_t random = mixed(seed);
    std::vector<Sample> samples(orbit.size());
    for (std::size_t n = 0; n < orbit.size(); ++n) {
        orbit[n].symbol = table.draw(std::uint32_t(mixed(random++) >> 32));
        newest.push(orbit[n].symbol);
        samples[n] = {newest.value(), std::uint32_t(n)};
    }
    std::ranges::sort(samples, [](const Sample& a, const Sample& b) {
        return a.value != b.value ? a.value < b.value : a.index < b.index;
    });
    for (std::size_t rank = 0; rank < samples.size(); ++rank)
        orbit[samples[rank].index].rank = std::uint32_t(rank);
    return samples;
}

} // namespace

void CoupledSamples::moveTo(const CoupledSystem& system) {
    ifs::Vector<2> at = system.toTop;
    for (const Step& step : orbit) {
        at = system.to[step.symbol](at);
        images[step.rank].x = at.x();
        images[step.rank].y = at.y();
    }
    std::vector<double> stretches;
    for (const WordTree::Image& image : tree.images(system))
        stretches.push_back(stretchOf(image.areaRatio, image.to.linear, linear[stretches.size()]));
    for (std::size_t rank = 0; rank < size; ++rank)
        images[rank].stretch = stretches[beginnings[rank]];
}

CoupledSamples coupledSamples(const CoupledSystem& system, std::uint64_t seed, std::size_t size,
                              double pieceSize) {
    CoupledSamples result;
    result.size = size;
    result.orbit.resize(size);
    AddressRegister addresses(system.from.size());
    const auto samples = sorted(system, seed, addresses, result.orbit);
    Beginnings beginnings(system, addresses, pieceSize, result);
    for (const Sample& sample : samples) {
        result.images.push_back({0, 0, addresses.coordinate(sample.value), 0});
        result.beginnings.push_back(beginnings.of(sample.value));
    }
    const auto& h = system.around.heights;
    result.centre = {(h[0] - h[8]) / 2, (h[4] - h[12]) / 2};
    const double extent = std::max(h[0] + h[8], h[4] + h[12]) / 2;
    result.scale = extent > 0 ? extent : 1;
    result.x.resize((size + CoupledSamples::lanes - 1) / CoupledSamples::lanes * CoupledSamples::lanes);
    result.y.resize(result.x.size());
    ifs::Vector<2> at = system.fromTop;
    for (const CoupledSamples::Step& step : result.orbit) {
        at = system.from[step.symbol](at);
        const ifs::Vector<2> inBox = (at - result.centre) / result.scale;
        result.x[step.rank] = float(inBox.x());
        result.y[step.rank] = float(inBox.y());
    }
    for (std::size_t k = size; k < result.x.size(); ++k) {
        result.x[k] = result.x[size - 1];
        result.y[k] = result.y[size - 1];
    }
    result.moveTo(system);
    return result;
}

} // namespace attractor
