// SPDX-License-Identifier: MIT
#include "attractor/colour/palette_edits.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/oklab.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace attractor {

std::size_t addStop(Palette& palette, double position) {
    const double clamped = std::clamp(position, 0.0, 1.0);
    const auto before =
        std::find_if(palette.stops.begin() + 1, palette.stops.end() - 1,
                     [clamped](const Palette::Stop& stop) { return stop.position > clamped; });
    const auto index = static_cast<std::size_t>(before - palette.stops.begin());
    palette.stops.insert(before, {clamped, colourAt(palette, clamped)});
    return index;
}

bool canMove(const Palette& palette, std::size_t stop) {
    return stop > 0 && stop + 1 < palette.stops.size();
}

void moveStop(Palette& palette, std::size_t stop, double position) {
    if (!canMove(palette, stop)) return;
    palette.stops[stop].position =
        std::clamp(position, palette.stops[stop - 1].position, palette.stops[stop + 1].position);
}

void removeStop(Palette& palette, std::size_t stop) {
    if (canMove(palette, stop))
        palette.stops.erase(palette.stops.begin() + static_cast<std::ptrdiff_t>(stop));
}

void reverse(Palette& palette) {
    std::reverse(palette.stops.begin(), palette.stops.end());
    for (Palette::Stop& stop : palette.stops)
        stop.position = 1 - stop.position;
}

void distribute(Palette& palette) {
    const double last = static_cast<double>(palette.stops.size()) - 1;
    for (std::size_t i = 0; i < palette.stops.size(); ++i)
        palette.stops[i].position = static_cast<double>(i) / last;
}

void turnHue(Palette& palette, double degrees) {
    if (std::remainder(degrees, 360.0) == 0) return;
    const double c = cosineOfDegrees(degrees);
    const double s = sineOfDegrees(degrees);
    for (Palette::Stop& stop : palette.stops) {
        const Oklab lab = oklab(linearColour(stop.colour));
        stop.colour = nearestShown({lab.lightness, c * lab.a - s * lab.b, s * lab.a + c * lab.b, lab.alpha});
    }
}

void shift(Palette& palette, double offset) {
    const double start = offset - std::floor(offset);
    if (!(start > 0) || palette.stops.size() < 2) return;
    std::vector<Palette::Stop> before;
    std::vector<Palette::Stop> after{{0, colourAt(palette, start)}};
    for (const Palette::Stop& stop : palette.stops) {
        if (stop.position > start)
            after.push_back({stop.position - start, stop.colour});
        else if (stop.position < start)
            before.push_back({stop.position + (1 - start), stop.colour});
    }
    // No repeated stop at the seam.
    if (after.back().colour == before.front().colour) before.erase(before.begin());
    after.insert(after.end(), before.begin(), before.end());
    after.push_back({1, after.front().colour});
    palette.stops = std::move(after);
}

} // namespace attractor
