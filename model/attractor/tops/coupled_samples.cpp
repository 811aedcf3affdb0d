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
    double coordinate() const { return double(m_value) / double(m_first) / double(m_maps); }
    std::vector<std::uint32_t> symbols() const {
        std::vector<std::uint32_t> result;
        std::uint64_t place = m_first;
        for (int k = 0; k < m_length; ++k, place /= m_maps)
            result.push_back(std::uint32_t(m_value / place % m_maps));
        return result;
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

double sampleStretch(const CoupledSystem& system, const std::vector<std::uint32_t>& symbols,
                     double pieceSize) {
    ifs::Matrix<2> from = ifs::Matrix<2>::Identity(), to = from;
    double ratio = 1;
    for (const std::uint32_t symbol : symbols) {
        if (ifs::spectralNorm<2>(from) <= pieceSize) break;
        const ifs::Matrix<2> longer = from * system.from[symbol].linear;
        if (!(longer.squaredNorm() > 0)) break; // a point: what is known of the piece before must do
        from = longer;
        to = to * system.to[symbol].linear;
        ratio *= system.areaRatios[symbol];
    }
    return stretchOf(ratio, to, from);
}

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
        sample.stretch = sampleStretch(system, newest.symbols(), pieceSize);
        samples.push_back(sample);
    }
    std::ranges::stable_sort(samples, {}, &Sample::code);
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
