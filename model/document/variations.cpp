// SPDX-License-Identifier: MIT
#include "document/variations.h"

#include "document/fractal_geometry.h"

#include "attractor/render/renderer.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/polygon.h"
#include "ifs/system/links.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace document {

namespace {

constexpr int trials = 60;
constexpr double minShare = 0.12;  // of the view that is filled
constexpr double minAspect = 0.25; // of its box
constexpr double maxNorm = 0.95;

// The standard's distributions differ between libraries; this one does not.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : m_engine(seed) {}

    double between(double low, double high) {
        return low + (high - low) * double(m_engine() >> 11) * 0x1p-53;
    }
    // The sum of four is near enough to the normal distribution; deviation 1.
    double normal() {
        constexpr double deviation = 0.57735026918962576; // of a number between −1 and 1
        double sum = 0;
        for (int i = 0; i < 4; ++i)
            sum += between(-1, 1);
        return sum / (2 * deviation);
    }
    std::size_t below(std::size_t count) {
        return std::min(count - 1, std::size_t(between(0, double(count))));
    }

private:
    std::mt19937_64 m_engine;
};

ifs::Matrix<2> rotation(double angle) {
    ifs::Matrix<2> matrix;
    matrix << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return matrix;
}

// Turned, stretched unequally and turned back somewhat: any linear map is of this form.
ifs::Matrix<2> linearMap(double first, double second, double inner, double outer) {
    return rotation(outer) * ifs::Vector<2>(first, second).asDiagonal() * rotation(inner);
}

ifs::AffineMap<2> randomMap(Chance& chance) {
    const double large = chance.between(0.35, 0.8);
    const double small = large * chance.between(0.3, 1) * (chance.between(0, 1) < 0.2 ? -1 : 1);
    const double inner = chance.between(-0.6, 0.6);
    const double outer = chance.between(0, 1) < 0.4 ? -inner + chance.between(-0.5, 0.5)
                                                    : chance.between(-1, 1) * std::numbers::pi;
    ifs::AffineMap<2> map;
    map.linear = linearMap(large, small, inner, outer);
    map.translation = {chance.between(-1, 1), chance.between(-1, 1)};
    return map;
}

bool isGood(const Fractal& fractal) {
    const auto active = ifs::activeMaps(*system2(fractal));
    const ifs::Existence existence = ifs::classify<2>(active.maps);
    const bool exists = existence.verdict == ifs::Verdict::Hyperbolic ||
                        existence.verdict == ifs::Verdict::EventuallyContractive;
    return exists && shareOfView(fractal) >= minShare;
}

void weighByDeterminant(System2& system) {
    const auto maps = ifs::mapsOf(system);
    const std::vector<double> weights = ifs::determinantWeights<2>(maps, 0.02);
    for (std::size_t i = 0; i < maps.size(); ++i)
        system.maps[i].weight = weights[i];
}

// The size of the system: how far its fixed points lie apart, so that moves are in proportion.
double extentOf(const System2& system) {
    ifs::Polygon ends;
    for (const auto& map : system.maps)
        ends.push_back(map.map.translation);
    double extent = 0;
    if (ends.size() > 16) ends = ifs::convexHull(std::move(ends), 0); // the farthest are corners of it
    for (const ifs::Vector<2>& a : ends)
        for (const ifs::Vector<2>& b : ends)
            extent = std::max(extent, (a - b).norm());
    return extent > 0 ? extent : 1;
}

System2 varied(System2 system, double strength, Chance& chance) {
    const double extent = extentOf(system);
    for (auto& weighted : system.maps) {
        ifs::AffineMap<2>& map = weighted.map;
        const double angle = 0.9 * strength * chance.normal();
        const double along = std::exp(0.35 * strength * chance.normal());
        const double across = std::exp(0.35 * strength * chance.normal());
        map.linear = rotation(angle) * linearMap(along, across, 0, 0) * map.linear;
        map.linear(0, 1) += 0.15 * strength * chance.normal();
        const double norm = ifs::spectralNorm<2>(map.linear);
        if (norm > maxNorm) map.linear *= maxNorm / norm;
        map.translation += 0.25 * strength * extent * ifs::Vector<2>(chance.normal(), chance.normal());
    }
    if (chance.between(0, 1) < 0.35 * strength && system.maps.size() > 2)
        system.maps.erase(system.maps.begin() + std::ptrdiff_t(chance.below(system.maps.size())));
    ifs::dropStaleLinks(system);
    if (chance.between(0, 1) < 0.35 * strength && system.maps.size() < 12) {
        ifs::AffineMap<2> map = randomMap(chance);
        map.translation *= extent;
        ifs::append(system, map);
    }
    weighByDeterminant(system);
    return system;
}

} // namespace

double shareOfView(const Fractal& fractal) {
    constexpr int side = 32;
    const auto box = displayedBox(fractal);
    if (!box) return 0;
    const ifs::Vector<2> size = box->max - box->min;
    if (!(size.minCoeff() > minAspect * size.maxCoeff())) return 0;
    attractor::Camera camera;
    camera.width = camera.height = side;
    attractor::RenderRequest request =
        renderRequest(fractal, attractor::fitted(camera, box->min, box->max, 0));
    request.samples = std::uint64_t{20} * side * side;
    request.appearance = {};
    request.appearance.colourBy = attractor::ColourBy::Plain;
    request.appearance.background = {0, 0, 0, 0};
    const attractor::Frame frame = attractor::render(request);
    const auto drawn = std::count_if(frame.pixels.begin(), frame.pixels.end(),
                                     [](std::uint32_t pixel) { return (pixel >> 24) >= 32; });
    return double(drawn) / (side * side);
}

Fractal randomFractal(std::uint64_t seed) {
    Chance chance(seed);
    Fractal fractal = sierpinskiTriangle();
    fractal.comments.clear();
    fractal.headerComment.clear();
    fractal.name = QStringLiteral("random%1").arg(seed % 1'000'000);
    for (int trial = 0; trial < trials; ++trial) {
        System2 system;
        const std::size_t count = 2 + chance.below(4);
        for (std::size_t i = 0; i < count; ++i)
            ifs::append(system, randomMap(chance));
        weighByDeterminant(system);
        fractal.shape = Shape<2>{std::move(system)};
        if (isGood(fractal)) return fractal;
    }
    fractal.shape = sierpinskiTriangle().shape; // no seed is known to come here
    return fractal;
}

Fractal variation(const Fractal& fractal, double strength, std::uint64_t seed) {
    Chance chance(seed);
    Fractal result = fractal;
    const ifs::ControlCage<2>* cage = cage2(fractal);
    if (cage && cage->rest == cage->current) plane(result)->cage.reset(); // fits the new one
    double now = std::clamp(strength, 0.0, 1.0);
    for (int trial = 0; trial < trials; ++trial) {
        *system2(result) = varied(*system2(fractal), now, chance);
        if (isGood(result)) return result;
        now *= 0.95; // what is nearer is likelier to be like it
    }
    return fractal;
}

} // namespace document
