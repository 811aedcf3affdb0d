// SPDX-License-Identifier: MIT
#include "io/exchange/flame_times.h"

#include "animation/animation.h"
#include "document/text/text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace io {

namespace {

// The frame of every entry, from 0 on; empty where they are not all there, apart from one another and within
// an animation's length.
std::vector<int> framesOf(const std::vector<std::optional<double>>& times) {
    const auto isThere = [](const auto& time) { return time.has_value(); };
    if (times.size() < 2 || !std::ranges::all_of(times, isThere)) return {};
    const double first = **std::ranges::min_element(times);
    std::vector<int> frames;
    for (const auto& time : times) {
        const double frame = std::round(*time - first);
        if (!(frame <= animation::maxLength)) return {};
        frames.push_back(int(frame));
    }
    std::vector<int> sorted = frames;
    std::ranges::sort(sorted);
    return std::ranges::adjacent_find(sorted) == sorted.end() ? frames : std::vector<int>();
}

const document::System2* plainSystem(const document::Entry& entry) {
    const document::System2* system = document::system2(*entry.fractal);
    return system && system->links.empty() && system->symmetry == ifs::Symmetry<2>() ? system : nullptr;
}

} // namespace

void joinByTime(document::FractalFile& file, const std::vector<std::optional<double>>& times) {
    const std::vector<int> frames = framesOf(times);
    if (frames.empty() || frames.size() != std::size_t(file.entries.size())) return;
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return frames[i]; });
    const document::Entry& firstEntry = file.entries[qsizetype(order.front())];
    const document::System2* first = plainSystem(firstEntry);
    if (!first) return;
    animation::Animation<2> moving;
    moving.length = frames[order.back()];
    for (const auto& map : first->maps)
        moving.maps.push_back({map.id, {}});
    document::Problems problems;
    for (const std::size_t i : order) {
        const document::Entry& entry = file.entries[qsizetype(i)];
        const document::System2* system = plainSystem(entry);
        if (!system || system->maps.size() != first->maps.size()) return;
        for (std::size_t map = 0; map < system->maps.size(); ++map)
            moving.maps[map].keys.push_back(
                {frames[i], {system->maps[map].map, system->maps[map].weight}, {}});
        problems += entry.problems;
    }
    if (!animation::isValid(moving)) return;
    document::Fractal fractal = *firstEntry.fractal;
    document::plane(fractal)->animation = std::move(moving);
    document::Entry joined = firstEntry;
    for (document::Problem& problem : problems)
        problem.entry = fractal.name;
    joined.problems = std::move(problems);
    joined.problems << document::Problem{
        document::Problem::Severity::Warning, fractal.name, 0, 0,
        Text::tr("%1 flames with different times are the keys of this animation, a frame "
                 "for each unit of time. Its colours are those of the first one.")
            .arg(frames.size())};
    joined.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
    file.entries = {joined};
}

} // namespace io
