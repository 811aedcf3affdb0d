// SPDX-License-Identifier: MIT
#include "document/moments/frame_edit.h"

#include "animation/keys/key_edits.h"
#include "animation/motions/moved_back.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace document {

namespace {

// The maps of a system, found by their identities.
template <int Dim> class MapIndex {
public:
    explicit MapIndex(const ifs::IteratedFunctionSystem<Dim>& system) {
        m_maps.reserve(system.maps.size());
        for (const ifs::WeightedMap<Dim>& map : system.maps)
            m_maps.push_back(&map);
        if (!std::ranges::is_sorted(m_maps, {}, id)) std::ranges::sort(m_maps, {}, id); // rarely unsorted
    }

    const ifs::WeightedMap<Dim>* find(ifs::MapId wanted) const {
        const auto found = std::ranges::lower_bound(m_maps, wanted, {}, id);
        return found == m_maps.end() || id(*found) != wanted ? nullptr : *found;
    }

private:
    static ifs::MapId id(const ifs::WeightedMap<Dim>* map) { return map->id; }

    std::vector<const ifs::WeightedMap<Dim>*> m_maps;
};

template <class Tracks, class Name, class Member>
auto* trackOf(Tracks& tracks, const Name& name, Member member) {
    const auto found = std::ranges::find(tracks, name, member);
    return found == tracks.end() ? nullptr : &*found;
}

animation::MapIds* mapsOf(auto& motion) {
    if constexpr (requires { motion.maps; })
        return &motion.maps;
    else
        return nullptr;
}

// An edit, applied part by part.
template <int Dim> class Edit {
public:
    Edit(const Fractal& entry, const animation::Moment& moment, const Fractal& before, const Fractal& after)
        : m_entry{entry},
          m_shape(std::get<Shape<Dim>>(m_entry.fractal.shape)),
          m_animation(*m_shape.animation),
          m_moment(animation::folded(moment, m_animation.loop, m_animation.length)),
          m_before(before),
          m_after(after),
          m_keyed(keyedFrame(entry, moment)) {
        m_entry.frame = int(m_moment.numerator / m_moment.denominator);
    }

    FrameEdit result() && {
        const Shape<Dim>& before = std::get<Shape<Dim>>(m_before.shape);
        const Shape<Dim>& after = std::get<Shape<Dim>>(m_after.shape);
        m_entry.fractal.name = m_after.name;
        m_entry.fractal.headerComment = m_after.headerComment;
        m_entry.fractal.comments = m_after.comments;
        m_entry.fractal.mapLabels = m_after.mapLabels;
        if (!(after.system == before.system)) {
            forgetMaps(after.system);
            putMaps(before.system, after.system);
        }
        if (after.cage != before.cage) putCage(after.cage);
        if (after.moved != before.moved) putBranches(before.moved, after.moved);
        if (!(m_after.appearance == m_before.appearance && m_after.inSpace == m_before.inSpace))
            putAppearance();
        return std::move(m_entry);
    }

private:
    // Frame from the keys alone.
    static Fractal keyedFrame(Fractal entry, const animation::Moment& moment) {
        std::get<Shape<Dim>>(entry.shape).animation->motions.clear();
        return frameAt(entry, moment).fractal;
    }

    template <class Value> void write(animation::Keys<Value>& keys, Value value) {
        animation::setKey(keys, m_entry.frame, std::move(value));
        m_entry.isKeyed = true;
    }

    void forgetMaps(const ifs::IteratedFunctionSystem<Dim>& after) {
        const MapIndex<Dim> left(after);
        const auto isGone = [&](ifs::MapId id) { return id != ifs::MapId::None && !left.find(id); };
        std::erase_if(m_animation.maps, [&](const auto& track) { return isGone(track.map); });
        std::erase_if(m_animation.branches,
                      [&](const auto& track) { return std::ranges::any_of(track.word, isGone); });
        std::erase_if(m_animation.motions, [&](animation::Motion<Dim>& motion) {
            animation::MapIds* maps = std::visit([](auto& which) { return mapsOf(which); }, motion);
            if (!maps || maps->empty()) return false;
            std::erase_if(*maps, isGone);
            return maps->empty(); // an empty list would mean all maps
        });
    }

    void putMaps(const ifs::IteratedFunctionSystem<Dim>& before,
                 const ifs::IteratedFunctionSystem<Dim>& after) {
        const auto back = animation::movedBack<Dim>(m_animation.motions, m_moment, m_animation.length, after);
        const MapIndex<Dim> shown(before), stored(m_shape.system);
        const MapIndex<Dim> keyed(std::get<Shape<Dim>>(m_keyed.shape).system);
        std::unordered_map<ifs::MapId, animation::MapTrack<Dim>*> tracks;
        for (animation::MapTrack<Dim>& track : m_animation.maps)
            tracks.emplace(track.map, &track);
        ifs::IteratedFunctionSystem<Dim> result = after;
        for (std::size_t i = 0; i < after.maps.size(); ++i) {
            ifs::WeightedMap<Dim>& map = result.maps[i];
            const auto* old = shown.find(map.id);
            const auto* kept = stored.find(map.id);
            const auto* unmoved = keyed.find(map.id);
            const bool isMapSame = old && unmoved && old->map == map.map;
            const bool isSame = isMapSame && old->weight == map.weight;
            map.map = isMapSame ? unmoved->map : back.maps[i].map;
            const auto track = tracks.find(map.id);
            const bool isTracked = track != tracks.end();
            if (isTracked && !isSame)
                write(track->second->keys, animation::MapPose<Dim>{map.map, map.weight});
            if (kept && (isTracked || isSame)) {
                map.map = kept->map;
                map.weight = kept->weight;
            }
        }
        m_shape.system = std::move(result);
    }

    void putCage(std::optional<ifs::ControlCage<Dim>> cage) {
        if constexpr (Dim == 2)
            if (cage) animation::turnBack(m_animation.motions, m_moment, m_animation.length, *cage);
        auto& keys = m_animation.cage;
        if (cage && !keys.empty() && keys.front().value.size() == cage->current.size()) {
            write(keys, cage->current);
            if (m_shape.cage && m_shape.cage->current.size() == cage->current.size())
                cage->current = m_shape.cage->current;
        } else {
            keys.clear();
        }
        m_shape.cage = std::move(cage);
    }

    void putBranches(const std::vector<MovedBranch<Dim>>& before,
                     const std::vector<MovedBranch<Dim>>& after) {
        for (const MovedBranch<Dim>& old : before)
            if (!trackOf(after, old.word, &MovedBranch<Dim>::word)) {
                std::erase_if(m_shape.moved, [&](const auto& branch) { return branch.word == old.word; });
                std::erase_if(m_animation.branches,
                              [&](const auto& track) { return track.word == old.word; });
            }
        for (const MovedBranch<Dim>& branch : after) {
            const auto* old = trackOf(before, branch.word, &MovedBranch<Dim>::word);
            if (old && *old == branch) continue;
            if (auto* track = trackOf(m_animation.branches, branch.word, &animation::BranchTrack<Dim>::word))
                write(track->keys, branch.change);
            else if (auto* kept = trackOf(m_shape.moved, branch.word, &MovedBranch<Dim>::word))
                *kept = branch;
            else
                m_shape.moved.push_back(branch);
        }
    }

    void putAppearance() {
        const animation::Look before = lookOf(m_before);
        animation::Look after = lookOf(m_after);
        animation::Look still = lookOf(m_entry.fractal);
        if (!(after == before)) {
            if (after.palette == before.palette) after.palette = m_keyed.appearance.palette;
            if (m_animation.look.empty())
                still = after;
            else
                write(m_animation.look, std::move(after));
        }
        m_entry.fractal.appearance = m_after.appearance;
        m_entry.fractal = withLook(std::move(m_entry.fractal), still);
    }

    FrameEdit m_entry;
    Shape<Dim>& m_shape; // shape of the entry, as are the members below
    animation::Animation<Dim>& m_animation;
    animation::Moment m_moment; // folded
    const Fractal& m_before;
    const Fractal& m_after;
    Fractal m_keyed;
};

template <int Dim> bool isAnimated(const Shape<Dim>* shape) {
    return shape && shape->animation;
}

} // namespace

FrameEdit withFrameEdited(const Fractal& entry, const animation::Moment& moment, const Fractal& before,
                          Fractal after) {
    if (isAnimated(plane(entry)) && plane(after)) return Edit<2>(entry, moment, before, after).result();
    if (isAnimated(space(entry)) && space(after)) return Edit<3>(entry, moment, before, after).result();
    return {std::move(after)};
}

} // namespace document
