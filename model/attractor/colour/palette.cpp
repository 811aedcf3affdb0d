// SPDX-License-Identifier: MIT
#include "attractor/colour/palette.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace attractor {

namespace {

// The gradients. Every stop stands at its lightness in Oklab, so that equal steps of tone look equal; the hue
// turns as it brightens (as embers do) to keep neighbouring tones apart. The first nine are for dark grounds
// and end bright, the others for paper and end dark.
const std::vector<Palette>& gradients() {
    static const std::vector<Palette> palettes{
        {"Maple",
         {{0, {132, 37, 61}},
          {0.084, {156, 40, 61}},
          {0.17, {181, 44, 57}},
          {0.258, {205, 52, 49}},
          {0.356, {223, 76, 38}},
          {0.469, {240, 105, 17}},
          {0.627, {250, 152, 23}},
          {0.808, {251, 202, 111}},
          {1, {255, 246, 203}}}},
        {"Fern",
         {{0, {4, 88, 92}},
          {0.08, {7, 103, 98}},
          {0.156, {1, 118, 101}},
          {0.235, {6, 134, 100}},
          {0.359, {39, 158, 98}},
          {0.494, {85, 182, 91}},
          {0.642, {140, 205, 84}},
          {0.812, {202, 228, 100}},
          {1, {252, 252, 206}}}},
        {"Glacier",
         {{0, {65, 58, 160}},
          {0.078, {65, 75, 176}},
          {0.154, {64, 91, 192}},
          {0.232, {62, 108, 206}},
          {0.354, {55, 137, 219}},
          {0.486, {61, 167, 228}},
          {0.64, {98, 199, 233}},
          {0.823, {163, 231, 238}},
          {1, {236, 255, 253}}}},
        {"Orchid",
         {{0, {85, 52, 148}},
          {0.082, {109, 57, 163}},
          {0.157, {133, 60, 176}},
          {0.238, {160, 63, 186}},
          {0.337, {191, 75, 185}},
          {0.443, {223, 90, 179}},
          {0.578, {251, 122, 169}},
          {0.766, {255, 183, 179}},
          {1, {255, 246, 231}}}},
        {"Aurora",
         {{0, {80, 49, 161}},
          {0.085, {73, 73, 177}},
          {0.167, {62, 95, 189}},
          {0.273, {6, 126, 193}},
          {0.388, {5, 155, 177}},
          {0.532, {9, 187, 173}},
          {0.689, {57, 221, 154}},
          {0.842, {169, 239, 144}},
          {1, {242, 255, 167}}}},
        {"Dusk",
         {{0, {44, 72, 142}},
          {0.07, {75, 76, 156}},
          {0.137, {104, 78, 167}},
          {0.229, {145, 81, 168}},
          {0.34, {192, 86, 153}},
          {0.471, {228, 108, 128}},
          {0.618, {249, 145, 112}},
          {0.801, {255, 196, 141}},
          {1, {255, 245, 217}}}},
        {"Copper",
         {{0, {111, 71, 57}},
          {0.072, {127, 79, 59}},
          {0.145, {144, 87, 61}},
          {0.214, {160, 95, 61}},
          {0.339, {182, 114, 72}},
          {0.476, {206, 136, 86}},
          {0.631, {226, 165, 112}},
          {0.816, {242, 203, 157}},
          {1, {255, 240, 215}}}},
        {"Lagoon",
         {{0, {0, 83, 124}},
          {0.08, {1, 98, 134}},
          {0.164, {2, 114, 144}},
          {0.247, {3, 130, 154}},
          {0.378, {7, 156, 170}},
          {0.522, {28, 185, 185}},
          {0.669, {96, 211, 193}},
          {0.833, {168, 235, 206}},
          {1, {235, 255, 238}}}},
        {"Silver",
         {{0, {81, 86, 92}},
          {0.114, {98, 103, 109}},
          {0.232, {117, 121, 127}},
          {0.351, {135, 140, 146}},
          {0.468, {154, 159, 165}},
          {0.601, {177, 181, 186}},
          {0.735, {200, 204, 208}},
          {0.869, {224, 227, 230}},
          {1, {248, 250, 253}}}},
        {"Ink",
         {{-0, {138, 147, 159}},
          {0.123, {119, 129, 143}},
          {0.248, {100, 111, 128}},
          {0.369, {82, 94, 114}},
          {0.493, {65, 77, 99}},
          {0.619, {50, 60, 82}},
          {0.746, {35, 44, 65}},
          {0.872, {21, 29, 48}},
          {1, {9, 14, 33}}}},
        {"Herbarium",
         {{-0, {147, 178, 90}},
          {0.114, {125, 162, 80}},
          {0.229, {103, 146, 71}},
          {0.345, {81, 130, 62}},
          {0.456, {59, 115, 53}},
          {0.593, {41, 95, 45}},
          {0.727, {24, 76, 37}},
          {0.865, {9, 57, 28}},
          {1, {1, 39, 18}}}},
        {"Sanguine",
         {{-0, {224, 141, 93}},
          {0.104, {213, 122, 78}},
          {0.214, {200, 102, 65}},
          {0.317, {188, 83, 53}},
          {0.425, {174, 63, 44}},
          {0.569, {145, 49, 38}},
          {0.712, {117, 36, 31}},
          {0.857, {90, 23, 23}},
          {1, {64, 12, 15}}}},
        {"Cyanotype",
         {{-0, {103, 183, 214}},
          {0.12, {80, 163, 203}},
          {0.238, {59, 143, 193}},
          {0.36, {42, 122, 182}},
          {0.48, {30, 101, 170}},
          {0.611, {25, 80, 148}},
          {0.741, {20, 60, 126}},
          {0.869, {15, 41, 104}},
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

LinearColour linearColour(const Rgba& colour) {
    return {linearLight(colour.red), linearLight(colour.green), linearLight(colour.blue),
            colour.alpha / 255.0};
}

LinearColour linearColourAt(const Palette& palette, double position) {
    if (palette.stops.empty()) return {};
    const auto above = std::find_if(palette.stops.begin(), palette.stops.end(),
                                    [&](const Palette::Stop& stop) { return stop.position >= position; });
    if (above == palette.stops.begin() || !(position == position))
        return linearColour(palette.stops.front().colour);
    if (above == palette.stops.end()) return linearColour(palette.stops.back().colour);
    const Palette::Stop& below = *(above - 1);
    const LinearColour low = linearColour(below.colour);
    const LinearColour high = linearColour(above->colour);
    const double f = (position - below.position) / (above->position - below.position);
    const auto mix = [f](double a, double b) { return a + (b - a) * f; };
    return {mix(low.red, high.red), mix(low.green, high.green), mix(low.blue, high.blue),
            mix(low.alpha, high.alpha)};
}

Rgba colourAt(const Palette& palette, double position) {
    if (palette.stops.empty()) return {};
    const LinearColour colour = linearColourAt(palette, position);
    return {encoded(colour.red), encoded(colour.green), encoded(colour.blue),
            static_cast<std::uint8_t>(std::lround(255 * colour.alpha))};
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
