// SPDX-License-Identifier: MIT
#include "bench/plain_rivals.h"

#include <array>
#include <cmath>
#include <random>

namespace rivals {

using attractor::Camera;
using attractor::PreparedSystem;

Points storedPoints(const PreparedSystem& system, std::size_t count) {
    std::vector<double> xy(2 * count);
    scalarOrbit(system, xy);
    return {{xy.begin(), xy.end()}};
}

void scalarOrbit(const PreparedSystem& system, std::span<double> xy) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    struct Map {
        double a, b, c, d, e, f, below;
    };
    std::vector<Map> maps;
    double sum = 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const auto& m = system.maps[i];
        sum += system.probabilities[i];
        maps.push_back({m.linear(0, 0), m.linear(0, 1), m.linear(1, 0), m.linear(1, 1), m.translation.x(),
                        m.translation.y(), sum});
    }
    double x = system.centre.x();
    double y = system.centre.y();
    for (std::size_t n = 0; n < xy.size(); n += 2) {
        const double u = uniform(random);
        std::size_t i = 0;
        while (i + 1 < maps.size() && u >= maps[i].below)
            ++i;
        const Map& m = maps[i];
        const double nextX = m.a * x + m.b * y + m.e;
        y = m.c * x + m.d * y + m.f;
        x = nextX;
        xy[n] = x;
        xy[n + 1] = y;
    }
}

void redrawStored(const Points& points, const Camera& camera, std::vector<std::uint32_t>& counts) {
    const ifs::AffineMap<2> m = attractor::worldToPixel(camera);
    const auto a = static_cast<float>(m.linear(0, 0));
    const auto b = static_cast<float>(m.linear(0, 1));
    const auto c = static_cast<float>(m.linear(1, 0));
    const auto d = static_cast<float>(m.linear(1, 1));
    const auto e = static_cast<float>(m.translation.x());
    const auto f = static_cast<float>(m.translation.y());
    for (std::size_t n = 0; n < points.xy.size(); n += 2) {
        const int column = static_cast<int>(std::floor(a * points.xy[n] + b * points.xy[n + 1] + e));
        const int row = static_cast<int>(std::floor(c * points.xy[n] + d * points.xy[n + 1] + f));
        if (column >= 0 && column < camera.width && row >= 0 && row < camera.height)
            ++counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) +
                     static_cast<std::size_t>(column)];
    }
}

void chaosIntoGrid(const PreparedSystem& system, const Camera& camera, std::size_t points,
                   std::vector<std::uint32_t>& counts) {
    constexpr std::size_t entries = 16384;
    std::vector<std::uint16_t> table;
    double sum = 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        sum += system.probabilities[i];
        const auto end = std::min(entries, static_cast<std::size_t>(sum * entries + 0.5));
        table.resize(std::max(table.size(), end), static_cast<std::uint16_t>(i));
    }
    table.resize(entries, table.empty() ? std::uint16_t{0} : table.back());
    const ifs::AffineMap<2> toCells = attractor::worldToPixel(camera);
    struct Map {
        float a, b, c, d, e, f;
    };
    std::vector<Map> maps;
    for (const auto& w : system.maps) {
        const auto m = *ifs::conjugate(toCells, w);
        maps.push_back({static_cast<float>(m.linear(0, 0)), static_cast<float>(m.linear(0, 1)),
                        static_cast<float>(m.linear(1, 0)), static_cast<float>(m.linear(1, 1)),
                        static_cast<float>(m.translation.x()), static_cast<float>(m.translation.y())});
    }
    const ifs::Vector<2> start = toCells(system.centre);
    std::array<float, 4> x{};
    std::array<float, 4> y{};
    x.fill(static_cast<float>(start.x()));
    y.fill(static_cast<float>(start.y()));
    const auto width = static_cast<float>(camera.width);
    const auto height = static_cast<float>(camera.height);
    std::uint64_t random = 88172645463325252U;
    for (std::size_t n = 0; n < points; n += 4) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        for (std::size_t k = 0; k < 4; ++k) {
            const Map& m = maps[table[(random >> (14 * k)) & (entries - 1)]];
            const float nextX = m.a * x[k] + m.b * y[k] + m.e;
            y[k] = m.c * x[k] + m.d * y[k] + m.f;
            x[k] = nextX;
            if (x[k] >= 0 && x[k] < width && y[k] >= 0 && y[k] < height)
                ++counts[static_cast<std::size_t>(y[k]) * static_cast<std::size_t>(camera.width) +
                         static_cast<std::size_t>(x[k])];
        }
    }
}

} // namespace rivals
