// SPDX-License-Identifier: MIT
#include "web/tops_hash.h"

#include "attractor/request/camera.h"
#include "attractor/tops/exact_tops.h"
#include "attractor/tops/key_tops.h"
#include "ifs/system/iterated_function_system.h"
#include "ifs/tops/families.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

namespace web {

namespace {

std::uint64_t hashOf(std::span<const attractor::TopPoint> points) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const attractor::TopPoint& point : points) {
        const std::array<double, 3> numbers{point.x, point.y, point.address};
        if (point.isEmpty()) continue;
        for (const double number : numbers)
            for (int shift = 0; shift < 64; shift += 8)
                hash = (hash ^ ((std::bit_cast<std::uint64_t>(number) >> shift) & 255)) * 1099511628211ULL;
    }
    return hash;
}

std::string line(int width, int height, const char* how, std::uint64_t hash) {
    std::array<char, 100> text{};
    std::snprintf(text.data(), text.size(), "tops %dx%d %s hash %016llx\n", width, height, how,
                  static_cast<unsigned long long>(hash));
    return text.data();
}

} // namespace

std::string topsHashes() {
    const std::vector<ifs::AffineMap<2>> from = ifs::triangleFamily({.5, .5, .5});
    const std::vector<ifs::AffineMap<2>> to = ifs::triangleFamily({.4, .55, .6});
    const attractor::CoupledSystem system(*ifs::SupportFunction<2>::of(from),
                                          *ifs::SupportFunction<2>::of(to), ifs::determinantWeights<2>(from));
    std::string text;
    for (const auto& [width, height] : {std::pair(400, 300), std::pair(123, 77)}) {
        attractor::Camera camera;
        camera.width = width;
        camera.height = height;
        camera = attractor::fitted(camera, {0, 0}, {1, 1});
        std::vector<attractor::TopPoint> points(std::size_t(width) * std::size_t(height));
        attractor::KeyTops(system, camera, 1'000'000, 1, {}).draw(0, points, {});
        text += line(width, height, "1000000 points", hashOf(points));
        attractor::ExactTops(system, camera).draw(0, points, {});
        text += line(width, height, "exact", hashOf(points));
    }
    return text;
}

} // namespace web
