// SPDX-License-Identifier: MIT
#include "bench/time_bench.h"

#include "animation/animation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace timing {

namespace {

constexpr int tracks = 64;
constexpr int keys = 100;
constexpr int moments = 200; // between keys, from the beginning to the end

struct Moving {
    animation::Pose<2> still;
    animation::Animation<2> animation;
};

// `shear` 0: every map contracts as it is. Above: only in coordinates that belong to all keys together.
Moving moving(double shear, animation::Ease ease) {
    Moving result;
    result.animation.length = 10 * (keys - 1);
    for (int i = 0; i < tracks; ++i) {
        const auto pose = [&](int k) {
            const double angle = 0.3 * std::sin(i + 0.7 * k), size = 0.3 + 0.1 * std::cos(2.0 * i + k);
            const double c = size * std::cos(angle), s = size * std::sin(angle);
            // M A M⁻¹ with M = (1 shear; 0 1)
            return animation::MapPose<2>{ifs::affineMap(c + shear * s, -s * (1 + shear * shear), s,
                                                        c - shear * s, std::cos(i), std::sin(i)),
                                         1.0};
        };
        const ifs::MapId id = ifs::append(result.still.system, pose(0).map, 1);
        animation::MapTrack<2> track{id, {}};
        for (int k = 0; k < keys; ++k)
            track.keys.push_back({10 * k, pose(k), ease});
        result.animation.maps.push_back(std::move(track));
    }
    return result;
}

double microseconds(const Moving& moving, int repetitions) {
    using Clock = std::chrono::steady_clock;
    double shortest = std::numeric_limits<double>::infinity(), sum = 0;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        const auto begin = Clock::now();
        for (int i = 0; i < moments; ++i) {
            const auto moment = animation::moment(std::int64_t(moving.animation.length) * i + 1, moments);
            sum += moving.animation.at(moment, moving.still).system.maps.back().map.linear(0, 0);
        }
        const std::chrono::duration<double, std::micro> taken = Clock::now() - begin;
        shortest = std::min(shortest, taken.count() / moments);
    }
    return std::isfinite(sum) ? shortest : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::vector<Row> measure(int repetitions) {
    const animation::Ease slow{animation::Ease::Kind::Both}, smooth{animation::Ease::Kind::Smooth};
    return {{"time.at_us", microseconds(moving(0, slow), repetitions), "<= 200"},
            {"time.at_us.common_norm", microseconds(moving(6, slow), repetitions), "<= 200"},
            {"time.at_us.smooth", microseconds(moving(6, smooth), repetitions), "<= 200"}};
}

} // namespace timing
