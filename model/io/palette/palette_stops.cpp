// SPDX-License-Identifier: MIT
#include "io/palette/palette_stops.h"

#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <array>

namespace io {

namespace {

using attractor::linearLight;
using attractor::Palette;
using attractor::Rgba;

struct Band { // linear light of three levels: below, at, and above
    double low = 0;
    double middle = 0;
    double high = 0;
};

Band band(int level) {
    const auto light = [](int code) {
        return linearLight(static_cast<std::uint8_t>(std::clamp(code, 0, 255)));
    };
    return {light(level - 1), light(level), light(level + 1)};
}

using Bands = std::array<Band, 3>;

Bands bands(const Rgba& colour) {
    return {band(colour.red), band(colour.green), band(colour.blue)};
}

bool passes(const Bands& from, const Bands& to, double share, const Bands& through) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double light = from[c].middle + share * (to[c].middle - from[c].middle);
        if (light < through[c].low || light > through[c].high) return false;
    }
    return true;
}

} // namespace

QByteArray colourText(const Rgba& colour) {
    const std::array<char, 4> channels{static_cast<char>(colour.red), static_cast<char>(colour.green),
                                       static_cast<char>(colour.blue), static_cast<char>(colour.alpha)};
    return '#' + QByteArray(channels.data(), 4).toHex();
}

std::optional<Rgba> parseColour(const QByteArray& text) {
    if (text.size() != 9 || text.front() != '#') return std::nullopt;
    const QByteArray hex = text.sliced(1).toLower();
    const QByteArray channels = QByteArray::fromHex(hex);
    if (channels.toHex() != hex) return std::nullopt;
    const auto channel = [&](qsizetype i) { return static_cast<std::uint8_t>(channels[i]); };
    return Rgba{channel(0), channel(1), channel(2), channel(3)};
}

bool isGradient(const std::vector<Palette::Stop>& stops) {
    return stops.size() >= 2 && stops.front().position == 0 && stops.back().position == 1 &&
           std::is_sorted(stops.begin(), stops.end(),
                          [](const auto& a, const auto& b) { return a.position < b.position; });
}

std::vector<Palette::Stop> stopsThrough(std::span<const Rgba> colours) {
    if (colours.empty()) return {};
    if (colours.size() == 1) return {{0, colours[0]}, {1, colours[0]}};
    std::vector<Bands> all;
    for (const Rgba& colour : colours)
        all.push_back(bands(colour));
    const std::size_t last = colours.size() - 1;
    const auto reaches = [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from + 1; k < to; ++k)
            if (!passes(all[from], all[to], double(k - from) / double(to - from), all[k])) return false;
        return true;
    };
    std::vector<Palette::Stop> stops{{0, colours[0]}};
    for (std::size_t at = 0; at < last;) {
        std::size_t near = 1; // greatest known feasible distance
        while (at + near < last && reaches(at, std::min(last, at + 2 * near)))
            near = std::min(last - at, 2 * near);
        for (std::size_t step = near / 2; step > 0; step /= 2)
            if (at + near + step <= last && reaches(at, at + near + step)) near += step;
        at += near;
        stops.push_back({double(at) / double(last), colours[at]});
    }
    return stops;
}

} // namespace io
