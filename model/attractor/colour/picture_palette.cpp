// SPDX-License-Identifier: MIT
#include "attractor/colour/picture_palette.h"

#include "attractor/colour/oklab.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace attractor {

namespace {

constexpr int bits = 5;      // bits of each channel by which similar pixels are counted together
constexpr int maxSteps = 30; // iterations of Lloyd's algorithm

// Similar pixels: their mean colour and place, and their number.
struct Sample {
    Oklab colour{0, 0, 0, 1};
    double place = 0; // 0 … 1 along the line
    double weight = 0;
};

double distance(const Oklab& a, const Oklab& b) { // squared
    const double l = a.lightness - b.lightness, x = a.a - b.a, y = a.b - b.b;
    return l * l + x * x + y * y;
}

Sample mean(std::span<const Sample> samples) {
    Sample sum;
    for (const Sample& sample : samples) {
        sum.colour.lightness += sample.weight * sample.colour.lightness;
        sum.colour.a += sample.weight * sample.colour.a;
        sum.colour.b += sample.weight * sample.colour.b;
        sum.place += sample.weight * sample.place;
        sum.weight += sample.weight;
    }
    if (!(sum.weight > 0)) return sum;
    return {{sum.colour.lightness / sum.weight, sum.colour.a / sum.weight, sum.colour.b / sum.weight, 1},
            sum.place / sum.weight,
            sum.weight};
}

std::vector<Sample> samplesOf(std::span<const Rgba> pixels) {
    const double last = std::max<double>(1, double(pixels.size()) - 1);
    std::map<std::uint32_t, Sample> sums;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const Rgba& pixel = pixels[k];
        if (pixel.alpha == 0) continue;
        const auto code = [](std::uint8_t channel) { return std::uint32_t(channel >> (8 - bits)); };
        const std::uint32_t key = code(pixel.red) << 2 * bits | code(pixel.green) << bits | code(pixel.blue);
        const double weight = pixel.alpha / 255.0;
        const Oklab colour = oklab(linearColour({pixel.red, pixel.green, pixel.blue, 255}));
        Sample& sum = sums[key];
        sum.colour.lightness += weight * colour.lightness;
        sum.colour.a += weight * colour.a;
        sum.colour.b += weight * colour.b;
        sum.place += weight * double(k) / last;
        sum.weight += weight;
    }
    std::vector<Sample> samples;
    for (const auto& [key, sum] : sums)
        samples.push_back(
            {{sum.colour.lightness / sum.weight, sum.colour.a / sum.weight, sum.colour.b / sum.weight, 1},
             sum.place / sum.weight,
             sum.weight});
    return samples;
}

std::size_t nearest(const std::vector<Sample>& centres, const Oklab& colour) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < centres.size(); ++k)
        if (distance(centres[k].colour, colour) < distance(centres[best].colour, colour)) best = k;
    return best;
}

// The commonest colour, then always the one that is worst represented, by its number.
std::vector<Sample> firstCentres(const std::vector<Sample>& samples, std::size_t count) {
    std::vector<Sample> centres{*std::ranges::max_element(samples, {}, &Sample::weight)};
    std::vector<double> off(samples.size(), std::numeric_limits<double>::infinity());
    while (centres.size() < count) {
        std::size_t worst = 0;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            off[k] = std::min(off[k], distance(samples[k].colour, centres.back().colour));
            if (samples[k].weight * off[k] > samples[worst].weight * off[worst]) worst = k;
        }
        if (!(off[worst] > 0)) break;
        centres.push_back(samples[worst]);
    }
    return centres;
}

std::vector<Sample> means(const std::vector<Sample>& samples, std::size_t count) {
    if (samples.empty()) return {};
    std::vector<Sample> centres = firstCentres(samples, std::clamp<std::size_t>(count, 2, maxPictureColours));
    std::vector<std::size_t> of(samples.size(), centres.size());
    for (int step = 0; step < maxSteps; ++step) {
        bool isSettled = true;
        std::vector<std::vector<Sample>> groups(centres.size());
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const std::size_t group = nearest(centres, samples[k].colour);
            isSettled = isSettled && group == of[k];
            of[k] = group;
            groups[group].push_back(samples[k]);
        }
        if (isSettled) break;
        for (std::size_t k = 0; k < centres.size(); ++k)
            if (!groups[k].empty()) centres[k] = mean(groups[k]);
    }
    return centres;
}

// The palette of these colours, with stops at 0 and 1 at least.
Palette paletteOf(const std::vector<Sample>& centres, std::span<const double> places) {
    Palette palette;
    for (std::size_t k = 0; k < centres.size(); ++k)
        palette.stops.push_back({places[k], colourOf(centres[k].colour)});
    if (palette.stops.empty()) palette.stops = {{0, {0, 0, 0, 255}}, {1, {255, 255, 255, 255}}};
    if (palette.stops.size() == 1) palette.stops.push_back(palette.stops.front());
    palette.stops.front().position = 0;
    palette.stops.back().position = 1;
    return palette;
}

} // namespace

Palette paletteOfPicture(std::span<const Rgba> pixels, std::size_t colours) {
    std::vector<Sample> centres = means(samplesOf(pixels), colours);
    std::ranges::stable_sort(centres, {}, [](const Sample& centre) { return centre.colour.lightness; });
    std::vector<double> places;
    for (std::size_t k = 0; k < centres.size(); ++k)
        places.push_back(double(k) / std::max<double>(1, double(centres.size()) - 1));
    return paletteOf(centres, places);
}

Palette paletteAlongLine(std::span<const Rgba> pixels, std::size_t colours) {
    std::vector<Sample> centres = means(samplesOf(pixels), colours);
    std::ranges::stable_sort(centres, {}, &Sample::place);
    std::vector<double> places;
    for (const Sample& centre : centres)
        places.push_back(centre.place);
    return paletteOf(centres, places);
}

} // namespace attractor
