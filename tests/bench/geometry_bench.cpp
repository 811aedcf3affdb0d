// SPDX-License-Identifier: MIT
#include "bench/geometry_bench.h"

#include "golden/collection.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/extent.h"

#include <ctime>

namespace geometry {

namespace {

std::vector<std::vector<ifs::AffineMap<2>>> systems() {
    std::vector<std::vector<ifs::AffineMap<2>>> result;
    for (const auto& theme : golden::collection())
        for (const auto& entry : theme.file.entries)
            if (const auto* system = document::system2(*entry.fractal))
                result.push_back(ifs::activeMaps(*system).maps);
    return result;
}

bool hullIsTight(const std::vector<ifs::AffineMap<2>>& maps) {
    const auto support = ifs::SupportFunction<2>::of(maps);
    if (!support) return false;
    const auto box = ifs::boundingBox(*support);
    const double wanted = 1e-6 * (box.max - box.min).norm();
    return ifs::convexHull(*support, wanted).error <= wanted;
}

bool simplexIsTight(const std::vector<ifs::AffineMap<2>>& maps) {
    const auto support = ifs::SupportFunction<2>::of(maps);
    if (!support) return false;
    const auto simplex = ifs::minimalCanonicalSimplex(*support);
    return simplex.error <= 1e-11 * simplex.leg;
}

// Of this thread alone, whatever else the machine does.
double milliseconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

template <class Function> Distribution measure(const std::string& name, Function isTight, int repetitions) {
    Distribution result{.name = name};
    for (const auto& maps : systems()) {
        double shortest = HUGE_VAL;
        bool tight = false;
        for (int n = 0; n < repetitions; ++n) {
            const double begin = milliseconds();
            tight = isTight(maps);
            shortest = std::min(shortest, milliseconds() - begin);
        }
        result.milliseconds.push_back(shortest);
        result.missed += tight ? 0 : 1;
    }
    std::ranges::sort(result.milliseconds);
    return result;
}

} // namespace

std::vector<Distribution> measureCollection(int repetitions) {
    return {measure("hull", hullIsTight, repetitions), measure("simplex", simplexIsTight, repetitions)};
}

} // namespace geometry
