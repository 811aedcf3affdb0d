// SPDX-License-Identifier: MIT
#include "document/moments/motion_paths.h"

#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <set>

namespace document {

namespace {

constexpr int maxPoints = 240;
constexpr std::size_t maxMaps = 16;

ifs::Vector<2> middleOf(const ifs::ControlCage<2>& cage) {
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const auto& vertex : cage.rest)
        sum += vertex;
    return sum / double(cage.rest.size());
}

// Adds a point; returns true if there is a key at this frame.
template <class Keys> bool add(MotionPath& path, const ifs::Vector<2>& point, const Keys& keys, int frame) {
    path.points.push_back(point);
    if (std::ranges::none_of(keys, [frame](const auto& key) { return key.frame == frame; })) return false;
    path.keys.push_back(point);
    path.frames.push_back(frame);
    return true;
}

std::vector<ifs::Vector<2>> outlineOf(const ifs::AffineMap<2>& map, const Fractal& shown,
                                      const ifs::Placement& place) {
    std::vector<ifs::Vector<2>> outline;
    for (const ifs::Vector<2>& vertex : cage2(shown)->rest)
        outline.push_back(place(map(vertex)));
    return outline;
}

std::set<int> framesOf(const animation::Animation<2>& animation) {
    std::set<int> frames;
    const int step = (animation.length + maxPoints - 1) / maxPoints;
    for (int frame = 0; frame <= animation.length; frame += step)
        frames.insert(frame);
    for (const auto& key : animation.cage)
        frames.insert(key.frame);
    for (const auto& track : animation.maps)
        for (const auto& key : track.keys)
            frames.insert(key.frame);
    return frames;
}

} // namespace

MotionPaths motionPaths(const Fractal& entry) {
    const Shape<2>* shape = plane(entry);
    if (!shape || !shape->animation) return {};
    const animation::Animation<2>& animation = *shape->animation;
    const std::size_t maps = std::min(animation.maps.size(), maxMaps);
    if (animation.cage.empty() && maps == 0) return {};

    Fractal held = entry; // copy, so that a canonical cage is computed once
    if (!shape->cage) plane(held)->cage = canonicalCage(entry);
    const ifs::Vector<2> middle = middleOf(*plane(held)->cage);
    MotionPaths paths;
    paths.vertices.resize(animation.cage.empty() ? 0 : plane(held)->cage->current.size());
    paths.maps.resize(maps);
    for (const int frame : framesOf(animation)) {
        const Fractal shown = frameAt(held, animation::moment(frame)).fractal;
        for (std::size_t i = 0; i < paths.vertices.size(); ++i) {
            paths.vertices[i].index = i;
            add(paths.vertices[i], cage2(shown)->current[i], animation.cage, frame);
        }
        const ifs::Placement place = placement(shown);
        for (std::size_t i = 0; i < maps; ++i)
            for (std::size_t index = 0; index < system2(shown)->maps.size(); ++index) {
                const auto& map = system2(shown)->maps[index];
                if (map.id != animation.maps[i].map) continue;
                paths.maps[i].index = index;
                if (add(paths.maps[i], place(map.map(middle)), animation.maps[i].keys, frame))
                    paths.maps[i].outlines.push_back(outlineOf(map.map, shown, place));
            }
    }
    return paths;
}

} // namespace document
