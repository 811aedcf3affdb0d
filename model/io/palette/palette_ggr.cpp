// SPDX-License-Identifier: MIT
#include "io/palette/palette_ggr.h"

#include "document/text/text.h"
#include "io/palette/palette_stops.h"
#include "io/text/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace io {

namespace {

using attractor::Rgba;
using document::Problem;

constexpr qsizetype maxSegments = 4096;
constexpr int colours = 1024; // samples of a gradient

using Colour = std::array<double, 3>; // sRGB, 0 … 1

enum class Blend { Linear, Curved, Sine, SphereIncreasing, SphereDecreasing, Step };
enum class Way { Rgb, HueUp, HueDown };
enum class End { Own, Foreground, ClearForeground, Background, ClearBackground };

struct Segment {
    double left = 0;
    double middle = 0;
    double right = 0;
    Colour from{};
    Colour to{};
    Blend blend = Blend::Linear;
    Way way = Way::Rgb;
};

// A whole number of a row, which must name one of the values.
template <class Value> std::optional<Value> choice(const QByteArray& word, Value last) {
    bool good = false;
    const int value = word.toInt(&good);
    if (!good || value < 0 || value > static_cast<int>(last)) return std::nullopt;
    return static_cast<Value>(value);
}

Colour endColour(const Colour& own, End end) {
    switch (end) {
    case End::Own:
        return own;
    case End::Foreground:
    case End::ClearForeground:
        return {0, 0, 0};
    case End::Background:
    case End::ClearBackground:
        return {1, 1, 1};
    }
    return own;
}

// left middle right, twice r g b a, how it blends, by which way; newer files add what either end stands for.
std::optional<Segment> segmentOf(const QByteArray& line) {
    const QByteArrayList words = line.simplified().split(' ');
    if (words.size() < 13) return std::nullopt;
    std::array<double, 11> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto number = parseNumber(QString::fromLatin1(words[qsizetype(i)]));
        if (!number || !(*number >= -1e-6 && *number <= 1 + 1e-6)) return std::nullopt;
        numbers[i] = std::clamp(*number, 0.0, 1.0);
    }
    const auto blend = choice(words[11], Blend::Step);
    const auto way = choice(words[12], Way::HueDown);
    const auto from = choice(words.value(13, "0"), End::ClearBackground);
    const auto to = choice(words.value(14, "0"), End::ClearBackground);
    if (!blend || !way || !from || !to) return std::nullopt;
    const auto& n = numbers;
    if (!(n[0] <= n[1] && n[1] <= n[2])) return std::nullopt;
    return Segment{
        n[0],   n[1], n[2], endColour({n[3], n[4], n[5]}, *from), endColour({n[7], n[8], n[9]}, *to),
        *blend, *way};
}

// Share of the way from the first colour to the second.
double share(const Segment& segment, double position) {
    const double length = segment.right - segment.left;
    if (!(length > 0)) return 0.5;
    const double middle = (segment.middle - segment.left) / length;
    const double at = std::clamp((position - segment.left) / length, 0.0, 1.0);
    constexpr double tiny = 1e-10;
    double linear = 0.5;
    if (at <= middle)
        linear = middle < tiny ? 0 : 0.5 * at / middle;
    else
        linear = 1 - middle < tiny ? 1 : 0.5 + 0.5 * (at - middle) / (1 - middle);
    switch (segment.blend) {
    case Blend::Linear:
        return linear;
    case Blend::Curved:
        return middle < tiny ? 1 : std::pow(at, std::log(0.5) / std::log(middle));
    case Blend::Sine:
        return 0.5 - 0.5 * std::cos(std::numbers::pi * linear);
    case Blend::SphereIncreasing:
        return std::sqrt(1 - (linear - 1) * (linear - 1));
    case Blend::SphereDecreasing:
        return 1 - std::sqrt(1 - linear * linear);
    case Blend::Step:
        return at >= middle ? 1 : 0;
    }
    return linear;
}

// Hue (0 … 1), saturation and value.
std::array<double, 3> hsv(const Colour& c) {
    const double high = std::max({c[0], c[1], c[2]});
    const double range = high - std::min({c[0], c[1], c[2]});
    if (!(range > 0)) return {0, 0, high};
    double hue = (c[0] - c[1]) / range + 4;
    if (high == c[0])
        hue = (c[1] - c[2]) / range;
    else if (high == c[1])
        hue = (c[2] - c[0]) / range + 2;
    hue /= 6;
    return {hue - std::floor(hue), range / high, high};
}

Colour ofHsv(double hue, double saturation, double value) {
    const auto channel = [&](double shift) {
        const double place = std::fmod(shift + 6 * (hue - std::floor(hue)), 6.0);
        return value - value * saturation * std::clamp(std::min(place, 4 - place), 0.0, 1.0);
    };
    return {channel(5), channel(3), channel(1)};
}

Colour colourAt(const Segment& segment, double position) {
    const double f = share(segment, position);
    const auto mix = [f](double a, double b) { return a + (b - a) * f; };
    const Colour& a = segment.from;
    const Colour& b = segment.to;
    if (segment.way == Way::Rgb) return {mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])};
    const auto from = hsv(a);
    auto to = hsv(b);
    if (segment.way == Way::HueUp && to[0] < from[0]) to[0] += 1;
    if (segment.way == Way::HueDown && to[0] > from[0]) to[0] -= 1;
    return ofHsv(mix(from[0], to[0]), mix(from[1], to[1]), mix(from[2], to[2]));
}

Rgba rounded(const Colour& c) {
    const auto level = [](double x) { return std::uint8_t(std::clamp(x, 0.0, 1.0) * 255 + 0.5); };
    return {level(c[0]), level(c[1]), level(c[2]), 255};
}

// Colours at evenly spaced positions, both ends included.
std::vector<Rgba> sampled(const std::vector<Segment>& segments) {
    std::vector<Rgba> result;
    std::size_t k = 0;
    for (int i = 0; i < colours; ++i) {
        const double position = double(i) / (colours - 1);
        while (k + 1 < segments.size() && segments[k].right < position)
            ++k;
        result.push_back(rounded(colourAt(segments[k], position)));
    }
    return result;
}

void reportIn(PaletteFile& file, Problem::Severity severity, int line, const QString& message) {
    file.problems << Problem{severity, {}, line, line > 0 ? 1 : 0, message};
}

} // namespace

void readGimpGradient(const QByteArrayList& lines, QString name, PaletteFile& file) {
    qsizetype at = 1;
    if (lines.value(at).trimmed().toLower().startsWith("name:")) {
        const QString own = QString::fromUtf8(lines[at].trimmed().sliced(5).left(200)).simplified();
        if (!own.isEmpty()) name = own;
        ++at;
    }
    bool good = false;
    const int count = lines.value(at).trimmed().toInt(&good);
    if (!good || count < 1 || count > maxSegments)
        return reportIn(
            file, Problem::Severity::Error, int(at) + 1,
            Text::tr("A GIMP gradient states its number of segments here, from 1 to %1.").arg(maxSegments));
    std::vector<Segment> segments;
    for (int i = 0; i < count; ++i) {
        const auto segment = segmentOf(lines.value(++at));
        const double end = segments.empty() ? 0 : segments.back().right;
        if (!segment || std::abs(segment->left - end) > 1e-3)
            return reportIn(
                file, Problem::Severity::Error, int(at) + 1,
                Text::tr("This is not a segment of a GIMP gradient that continues the one before."));
        segments.push_back(*segment);
    }
    file.palettes.push_back({name.toStdString(), stopsThrough(sampled(segments))});
}

} // namespace io
