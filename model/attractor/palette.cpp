// SPDX-License-Identifier: MIT
#include "attractor/palette.h"

#include "attractor/arithmetic.h"
#include "attractor/linear_light.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace attractor {

namespace {

// Stops at equal steps of lightness in Oklab, so that equal steps of tone look equal; the hue turns as it
// brightens (as embers do) to keep neighbouring tones apart. The first nine are for dark grounds and end
// bright, the others for paper and end dark.
const std::vector<Palette>& gradients() {
    static const std::vector<Palette> palettes{
        {"Maple",
         {{0, {132, 37, 61}},
          {0.125, {156, 40, 61}},
          {0.25, {181, 44, 57}},
          {0.375, {205, 52, 49}},
          {0.5, {223, 76, 38}},
          {0.625, {240, 105, 17}},
          {0.75, {250, 152, 23}},
          {0.875, {251, 202, 111}},
          {1, {255, 246, 203}}}},
        {"Fern",
         {{0, {4, 88, 92}},
          {0.125, {7, 103, 98}},
          {0.25, {1, 118, 101}},
          {0.375, {6, 134, 100}},
          {0.5, {39, 158, 98}},
          {0.625, {85, 182, 91}},
          {0.75, {140, 205, 84}},
          {0.875, {202, 228, 100}},
          {1, {252, 252, 206}}}},
        {"Glacier",
         {{0, {65, 58, 160}},
          {0.125, {65, 75, 176}},
          {0.25, {64, 91, 192}},
          {0.375, {62, 108, 206}},
          {0.5, {55, 137, 219}},
          {0.625, {61, 167, 228}},
          {0.75, {98, 199, 233}},
          {0.875, {163, 231, 238}},
          {1, {236, 255, 253}}}},
        {"Orchid",
         {{0, {85, 52, 148}},
          {0.125, {109, 57, 163}},
          {0.25, {133, 60, 176}},
          {0.375, {160, 63, 186}},
          {0.5, {191, 75, 185}},
          {0.625, {223, 90, 179}},
          {0.75, {251, 122, 169}},
          {0.875, {255, 183, 179}},
          {1, {255, 246, 231}}}},
        {"Aurora",
         {{0, {80, 49, 161}},
          {0.125, {73, 73, 177}},
          {0.25, {62, 95, 189}},
          {0.375, {6, 126, 193}},
          {0.5, {5, 155, 177}},
          {0.625, {9, 187, 173}},
          {0.75, {57, 221, 154}},
          {0.875, {169, 239, 144}},
          {1, {242, 255, 167}}}},
        {"Dusk",
         {{0, {44, 72, 142}},
          {0.125, {75, 76, 156}},
          {0.25, {104, 78, 167}},
          {0.375, {145, 81, 168}},
          {0.5, {192, 86, 153}},
          {0.625, {228, 108, 128}},
          {0.75, {249, 145, 112}},
          {0.875, {255, 196, 141}},
          {1, {255, 245, 217}}}},
        {"Copper",
         {{0, {111, 71, 57}},
          {0.125, {127, 79, 59}},
          {0.25, {144, 87, 61}},
          {0.375, {160, 95, 61}},
          {0.5, {182, 114, 72}},
          {0.625, {206, 136, 86}},
          {0.75, {226, 165, 112}},
          {0.875, {242, 203, 157}},
          {1, {255, 240, 215}}}},
        {"Lagoon",
         {{0, {0, 83, 124}},
          {0.125, {1, 98, 134}},
          {0.25, {2, 114, 144}},
          {0.375, {3, 130, 154}},
          {0.5, {7, 156, 170}},
          {0.625, {28, 185, 185}},
          {0.75, {96, 211, 193}},
          {0.875, {168, 235, 206}},
          {1, {235, 255, 238}}}},
        {"Silver",
         {{0, {81, 86, 92}},
          {0.125, {98, 103, 109}},
          {0.25, {117, 121, 127}},
          {0.375, {135, 140, 146}},
          {0.5, {154, 159, 165}},
          {0.625, {177, 181, 186}},
          {0.75, {200, 204, 208}},
          {0.875, {224, 227, 230}},
          {1, {248, 250, 253}}}},
        {"Ink",
         {{0, {138, 147, 159}},
          {0.125, {119, 129, 143}},
          {0.25, {100, 111, 128}},
          {0.375, {82, 94, 114}},
          {0.5, {65, 77, 99}},
          {0.625, {50, 60, 82}},
          {0.75, {35, 44, 65}},
          {0.875, {21, 29, 48}},
          {1, {9, 14, 33}}}},
        {"Herbarium",
         {{0, {147, 178, 90}},
          {0.125, {125, 162, 80}},
          {0.25, {103, 146, 71}},
          {0.375, {81, 130, 62}},
          {0.5, {59, 115, 53}},
          {0.625, {41, 95, 45}},
          {0.75, {24, 76, 37}},
          {0.875, {9, 57, 28}},
          {1, {1, 39, 18}}}},
        {"Sanguine",
         {{0, {224, 141, 93}},
          {0.125, {213, 122, 78}},
          {0.25, {200, 102, 65}},
          {0.375, {188, 83, 53}},
          {0.5, {174, 63, 44}},
          {0.625, {145, 49, 38}},
          {0.75, {117, 36, 31}},
          {0.875, {90, 23, 23}},
          {1, {64, 12, 15}}}},
        {"Cyanotype",
         {{0, {103, 183, 214}},
          {0.125, {80, 163, 203}},
          {0.25, {59, 143, 193}},
          {0.375, {42, 122, 182}},
          {0.5, {30, 101, 170}},
          {0.625, {25, 80, 148}},
          {0.75, {20, 60, 126}},
          {0.875, {15, 41, 104}},
          {1, {10, 22, 82}}}},
    };
    return palettes;
}

// Neighbours differ in lightness as well as in hue, so that they stay apart with any kind of colour vision.
constexpr std::array<Rgba, 12> categorical{
    {Rgba{245, 174, 57, 255}, Rgba{55, 170, 227, 255}, Rgba{247, 95, 76, 255}, Rgba{89, 211, 140, 255},
     Rgba{212, 118, 205, 255}, Rgba{224, 214, 83, 255}, Rgba{115, 130, 230, 255}, Rgba{71, 199, 199, 255},
     Rgba{240, 121, 152, 255}, Rgba{113, 162, 85, 255}, Rgba{229, 178, 138, 255}, Rgba{174, 150, 218, 255}}};

bool sameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

} // namespace

Rgba colourAt(const Palette& palette, double position) {
    if (palette.stops.empty()) return {};
    const auto above = std::find_if(palette.stops.begin(), palette.stops.end(),
                                    [&](const Palette::Stop& stop) { return stop.position >= position; });
    if (above == palette.stops.begin() || !(position == position)) return palette.stops.front().colour;
    if (above == palette.stops.end()) return palette.stops.back().colour;
    const Palette::Stop& low = *(above - 1);
    const Palette::Stop& high = *above;
    const double f = (position - low.position) / (high.position - low.position);
    const auto mix = [f](std::uint8_t a, std::uint8_t b) {
        return encoded(linearLight(a) + (linearLight(b) - linearLight(a)) * f);
    };
    return {mix(low.colour.red, high.colour.red), mix(low.colour.green, high.colour.green),
            mix(low.colour.blue, high.colour.blue),
            static_cast<std::uint8_t>(
                std::lround(low.colour.alpha + (high.colour.alpha - low.colour.alpha) * f))};
}

std::span<const Palette> builtInPalettes() {
    return gradients();
}

const Palette* findPalette(std::string_view name) {
    const auto& palettes = gradients();
    const auto found = std::find_if(palettes.begin(), palettes.end(), [&](const Palette& palette) {
        return std::equal(palette.name.begin(), palette.name.end(), name.begin(), name.end(), sameLetter);
    });
    return found == palettes.end() ? nullptr : &*found;
}

Rgba categoricalColour(std::size_t index) {
    return categorical[index % categorical.size()];
}

} // namespace attractor
