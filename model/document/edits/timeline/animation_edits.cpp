// SPDX-License-Identifier: MIT
#include "document/edits/timeline/animation_edits.h"

#include "animation/keys/key_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace document {

namespace {

template <class Entry, class Use> auto inItsDimension(Entry& entry, Use use) {
    if (auto* shape = plane(entry)) return use.template operator()<2>(*shape);
    if (auto* shape = space(entry)) return use.template operator()<3>(*shape);
    return decltype(use.template operator()<2>(*plane(entry)))();
}

template <class Tracks, class Name> auto* named(Tracks& tracks, const Name& name) {
    const auto found = std::ranges::find_if(tracks, [&](const auto& track) {
        if constexpr (requires { track.map; })
            return std::vector{track.map} == name;
        else
            return track.word == name;
    });
    return found == tracks.end() ? nullptr : &*found;
}

// Calls `use` with the keys of the track, which may be none.
template <int Dim, class Use>
void visitKeys(animation::Animation<Dim>& animation, const Track& track, Use use) {
    using Kind = Track::Kind;
    if (track.kind == Kind::Cage) return use(animation.cage);
    if (track.kind == Kind::Look) return use(animation.look);
    if (track.kind == Kind::Camera) return use(animation.camera);
    if (track.kind == Kind::Map) {
        auto* known = named(animation.maps, track.maps);
        if (!known) known = &animation.maps.emplace_back(animation::MapTrack<Dim>{track.maps.front(), {}});
        use(known->keys);
        std::erase_if(animation.maps, [](const auto& one) { return one.keys.empty(); });
    } else {
        auto* known = named(animation.branches, track.maps);
        if (!known) known = &animation.branches.emplace_back(animation::BranchTrack<Dim>{track.maps, {}});
        use(known->keys);
        std::erase_if(animation.branches, [](const auto& one) { return one.keys.empty(); });
    }
}

template <int Dim> animation::Animation<Dim>& animationOf(Shape<Dim>& shape) {
    if (!shape.animation) shape.animation.emplace();
    return *shape.animation;
}

// Calls `use` with the kind and a reference to each number that motionNumbers() lists.
template <class Motion, class Use> void visitNumbers(Motion& motion, Use use) {
    using Kind = MotionNumber::Kind;
    std::visit(
        [&](auto& which) {
            constexpr bool isSway = requires {
                which.waves;
            };
            if constexpr (requires { which.strength; })
                use(isSway ? Kind::Degrees : Kind::Share, which.strength);
            if constexpr (requires { which.turns; }) use(Kind::Turns, which.turns);
            // Positions on a palette may move either way.
            if constexpr (requires { which.cycles; })
                use(
                    requires { which.reference; } ? Kind::Cycles : Kind::Turns, which.cycles);
            if constexpr (isSway)
                for (auto& wave : which.waves)
                    use(Kind::Cycles, wave.cycles);
        },
        motion);
}

bool isAmong(std::span<const KeyAt> keys, const Track& track, int frame) {
    return std::ranges::find(keys, KeyAt{track, frame}) != keys.end();
}

std::vector<Track> tracksIn(std::span<const KeyAt> keys) {
    std::vector<Track> result;
    for (const KeyAt& key : keys)
        if (std::ranges::find(result, key.track) == result.end()) result.push_back(key.track);
    return result;
}

// Sorts the keys; the last one of several at one frame counts.
template <class Value> void putInOrder(animation::Keys<Value>& keys) {
    animation::Keys<Value> result;
    std::ranges::stable_sort(keys, {}, &animation::Key<Value>::frame);
    for (auto& key : keys) {
        if (!result.empty() && result.back().frame == key.frame) result.pop_back();
        result.push_back(std::move(key));
    }
    keys = std::move(result);
}

template <int Dim> std::vector<TrackKeys> tracksOfShape(const Shape<Dim>& shape) {
    std::vector<TrackKeys> result;
    const animation::Animation<Dim> still;
    const animation::Animation<Dim>& animation = shape.animation ? *shape.animation : still;
    const auto add = [&](Track track, const auto* keys) {
        TrackKeys& added = result.emplace_back(TrackKeys{std::move(track), {}});
        if (!keys) return;
        for (const auto& key : *keys)
            added.keys.push_back({key.frame, key.ease});
    };
    add({Track::Kind::Cage}, &animation.cage);
    std::unordered_map<ifs::MapId, const animation::MapTrack<Dim>*> moving;
    for (const auto& track : animation.maps)
        moving.emplace(track.map, &track);
    for (const auto& map : shape.system.maps) {
        const auto known = moving.find(map.id);
        add({Track::Kind::Map, {map.id}}, known == moving.end() ? nullptr : &known->second->keys);
    }
    std::vector<std::vector<ifs::MapId>> words;
    for (const auto& branch : shape.moved)
        words.push_back(branch.word);
    for (const auto& track : animation.branches)
        if (!named(shape.moved, track.word)) words.push_back(track.word);
    for (const auto& word : words) {
        const auto* known = named(animation.branches, word);
        add({Track::Kind::Branch, word}, known ? &known->keys : nullptr);
    }
    add({Track::Kind::Look}, &animation.look);
    add({Track::Kind::Camera}, &animation.camera);
    return result;
}

template <int Dim> bool areTracksAlike(const Shape<Dim>& a, const Shape<Dim>& b) {
    constexpr auto id = &ifs::WeightedMap<Dim>::id;
    constexpr auto word = &MovedBranch<Dim>::word;
    return a.cage.has_value() == b.cage.has_value() && a.animation == b.animation &&
           std::ranges::equal(a.system.maps, b.system.maps, {}, id, id) &&
           std::ranges::equal(a.moved, b.moved, {}, word, word);
}

// The shape that the keys alone show, without motions: the basis of a new key.
template <int Dim> Shape<Dim> keyedShape(Fractal entry, int frame) {
    if (auto& animation = std::get<Shape<Dim>>(entry.shape).animation) animation->motions.clear();
    return std::get<Shape<Dim>>(frameAt(entry, animation::moment(frame)).fractal.shape);
}

template <class Value> void addKey(animation::Keys<Value>& keys, int frame, const Value& value) {
    if (keys.empty())
        animation::setFirstKey(keys, frame, value);
    else
        animation::setKey(keys, frame, value);
}

// The value that each kind of track has.
template <int Dim> class NewKey {
public:
    NewKey(const Fractal& entry, const Track& track, int frame, const SeenCamera& camera)
        : m_entry(entry), m_track(track), m_frame(frame), m_camera(camera) {}

    void operator()(animation::Keys<animation::CagePose<Dim>>& keys) const {
        const auto cage = keyedShape<Dim>(m_entry, m_frame).cage;
        if (cage) addKey(keys, m_frame, cage->current);
    }
    void operator()(animation::Keys<animation::MapPose<Dim>>& keys) const {
        const auto shape = keyedShape<Dim>(m_entry, m_frame);
        for (const auto& map : shape.system.maps)
            if (map.id == m_track.maps.front())
                addKey(keys, m_frame, animation::MapPose<Dim>{map.map, map.weight});
    }
    void operator()(animation::Keys<ifs::AffineMap<Dim>>& keys) const {
        const auto shape = keyedShape<Dim>(m_entry, m_frame);
        if (const auto* branch = named(shape.moved, m_track.maps)) addKey(keys, m_frame, branch->change);
    }
    void operator()(animation::Keys<animation::Look>& keys) const {
        Fractal entry = m_entry;
        if (auto& animation = std::get<Shape<Dim>>(entry.shape).animation) animation->motions.clear();
        addKey(keys, m_frame, lookOf(frameAt(entry, animation::moment(m_frame)).fractal));
    }
    void operator()(animation::Keys<animation::CameraPose<Dim>>& keys) const {
        const auto* seen = m_camera ? std::get_if<animation::CameraPose<Dim>>(&*m_camera) : nullptr;
        if (!seen) return;
        animation::CameraPose<Dim> value = *seen;
        if constexpr (Dim == 3) { // motions follow the keys
            value = animation::orbitedBack(value, frameAt(m_entry, animation::moment(m_frame)).orbit);
            value.size = {};
        }
        addKey(keys, m_frame, value);
    }

private:
    const Fractal& m_entry;
    const Track& m_track;
    int m_frame;
    const SeenCamera& m_camera;
};

// The value that a track keeps when its last keys go.
template <int Dim> class KeepStill {
public:
    KeepStill(Fractal& entry, Shape<Dim>& shape, const Track& track)
        : m_entry(entry), m_shape(shape), m_track(track) {}

    void operator()(const animation::CagePose<Dim>& vertices) const {
        if (m_shape.cage && m_shape.cage->current.size() == vertices.size()) m_shape.cage->current = vertices;
    }
    void operator()(const animation::MapPose<Dim>& pose) const {
        for (auto& map : m_shape.system.maps)
            if (map.id == m_track.maps.front()) {
                map.map = pose.map;
                map.weight = pose.weight;
            }
    }
    void operator()(const ifs::AffineMap<Dim>& change) const {
        if (auto* branch = named(m_shape.moved, m_track.maps))
            branch->change = change;
        else
            m_shape.moved.push_back({m_track.maps, change});
    }
    void operator()(const animation::Look& look) const {
        m_entry.appearance = animation::withLook(m_entry.appearance, look);
        m_entry.inSpace = look.inSpace.value_or(m_entry.inSpace);
    }
    void operator()(const animation::CameraPose<Dim>&) const {}

private:
    Fractal& m_entry;
    Shape<Dim>& m_shape;
    const Track& m_track;
};

int lastFrameOf(const std::vector<TrackKeys>& tracks, std::span<const KeyAt> keys, KeyMove how) {
    int last = 0;
    for (const KeyAt& key : keys)
        last = std::max(last, key.frame);
    if (how != KeyMove::Ripple) return last;
    const std::vector<Track> moved = tracksIn(keys);
    for (const TrackKeys& one : tracks)
        if (!one.keys.empty() && std::ranges::find(moved, one.track) != moved.end())
            last = std::max(last, one.keys.back().frame);
    return last;
}

int firstFrameOf(std::span<const KeyAt> keys) {
    return std::ranges::min(keys, {}, &KeyAt::frame).frame;
}

} // namespace

std::vector<TrackKeys> tracksOf(const Fractal& entry) {
    return inItsDimension(entry, []<int Dim>(const Shape<Dim>& shape) { return tracksOfShape<Dim>(shape); });
}

bool areTracksAlike(const Fractal& a, const Fractal& b) {
    if (plane(a) && plane(b)) return areTracksAlike(*plane(a), *plane(b));
    if (space(a) && space(b)) return areTracksAlike(*space(a), *space(b));
    return a.shape.index() == b.shape.index();
}

Timing timingOf(const Fractal& entry) {
    const auto facts = animationFacts(entry);
    const animation::Animation<2> fresh;
    return facts ? Timing{facts->rate, facts->length, facts->loop}
                 : Timing{fresh.rate, fresh.length, fresh.loop};
}

Fractal withTiming(Fractal entry, const Timing& timing) {
    const auto set = [&]<int Dim>(Shape<Dim>& shape) {
        auto& animation = animationOf<Dim>(shape);
        animation.rate = timing.rate;
        animation.length = timing.length;
        animation.loop = timing.loop;
        for (const TrackKeys& one : tracksOfShape<Dim>(shape))
            visitKeys<Dim>(animation, one.track, [&](auto& keys) {
                std::erase_if(keys, [&](const auto& key) { return key.frame > timing.length; });
            });
    };
    inItsDimension(entry, set);
    return entry;
}

Fractal withKey(Fractal entry, const Track& track, int frame, const SeenCamera& camera) {
    if (track.kind == Track::Kind::Cage) {
        if (plane(entry) && !plane(entry)->cage) plane(entry)->cage = canonicalCage(entry);
        if (space(entry) && !space(entry)->cage) space(entry)->cage = spaceCage(entry);
    }
    const Fractal before = entry;
    inItsDimension(entry, [&]<int Dim>(Shape<Dim>& shape) {
        auto& animation = animationOf<Dim>(shape);
        const int at =
            int(animation::folded(animation::moment(frame), animation.loop, animation.length).numerator);
        visitKeys<Dim>(animation, track, NewKey<Dim>(before, track, at, camera));
    });
    return entry;
}

Fractal withoutKeys(Fractal entry, std::span<const KeyAt> keys) {
    inItsDimension(entry, [&]<int Dim>(Shape<Dim>& shape) {
        for (const Track& track : tracksIn(keys))
            visitKeys<Dim>(animationOf<Dim>(shape), track, [&](auto& present) {
                if (present.empty()) return;
                const auto first = present.front();
                std::erase_if(present, [&](const auto& key) { return isAmong(keys, track, key.frame); });
                if (present.empty()) KeepStill<Dim>(entry, shape, track)(first.value);
            });
    });
    return entry;
}

Fractal withEase(Fractal entry, std::span<const KeyAt> keys, const animation::Ease& ease) {
    inItsDimension(entry, [&]<int Dim>(Shape<Dim>& shape) {
        for (const Track& track : tracksIn(keys))
            visitKeys<Dim>(animationOf<Dim>(shape), track, [&](auto& present) {
                for (auto& key : present)
                    if (isAmong(keys, track, key.frame)) key.ease = ease;
            });
    });
    return entry;
}

int possibleMove(const Fractal& entry, std::span<const KeyAt> keys, int by, KeyMove how) {
    if (keys.empty()) return 0;
    const Timing timing = timingOf(entry);
    const int end = how == KeyMove::Ripple ? animation::maxLength : timing.length;
    return std::clamp(by, -firstFrameOf(keys), end - lastFrameOf(tracksOf(entry), keys, how));
}

Fractal withKeysMoved(Fractal entry, std::span<const KeyAt> keys, int by, KeyMove how) {
    by = possibleMove(entry, keys, by, how);
    if (by == 0) return entry;
    const int first = firstFrameOf(keys);
    const int last = lastFrameOf(tracksOf(entry), keys, how) + by;
    inItsDimension(entry, [&]<int Dim>(Shape<Dim>& shape) {
        auto& animation = animationOf<Dim>(shape);
        animation.length = std::max(animation.length, last);
        for (const Track& track : tracksIn(keys))
            visitKeys<Dim>(animation, track, [&](auto& present) {
                auto moved = present;
                std::erase_if(moved, [&](const auto& key) {
                    return how == KeyMove::Ripple ? key.frame < first : !isAmong(keys, track, key.frame);
                });
                if (how != KeyMove::Copy)
                    std::erase_if(present, [&](const auto& key) {
                        return std::ranges::find(moved, key.frame,
                                                 [](const auto& one) { return one.frame; }) != moved.end();
                    });
                for (auto& key : moved) {
                    key.frame += by;
                    present.push_back(std::move(key));
                }
                putInOrder(present);
            });
    });
    return entry;
}

std::vector<CopiedKey> copiedKeys(const Fractal& entry, std::span<const KeyAt> keys) {
    std::vector<CopiedKey> result;
    if (keys.empty()) return result;
    const int first = firstFrameOf(keys);
    Fractal copy = entry;
    inItsDimension(copy, [&]<int Dim>(Shape<Dim>& shape) {
        for (const Track& track : tracksIn(keys))
            visitKeys<Dim>(animationOf<Dim>(shape), track, [&](const auto& present) {
                for (auto key : present) {
                    if (!isAmong(keys, track, key.frame)) continue;
                    key.frame -= first;
                    result.push_back({{track, key.frame}, key});
                }
            });
    });
    return result;
}

Pasted withKeysPasted(Fractal entry, std::span<const CopiedKey> keys, int frame) {
    Pasted result{std::move(entry), {}};
    const std::vector<TrackKeys> tracks = tracksOf(result.fractal);
    inItsDimension(result.fractal, [&]<int Dim>(Shape<Dim>& shape) {
        auto& animation = animationOf<Dim>(shape);
        for (const CopiedKey& copied : keys) {
            const int at = frame + copied.at.frame;
            const bool isKnown =
                std::ranges::find(tracks, copied.at.track, &TrackKeys::track) != tracks.end();
            if (!isKnown || at > animation.length) continue;
            visitKeys<Dim>(animation, copied.at.track, [&]<class Value>(animation::Keys<Value>& present) {
                const auto* key = std::get_if<animation::Key<Value>>(&copied.key);
                if (!key) return;
                if constexpr (std::is_same_v<Value, animation::CagePose<Dim>>)
                    if (!shape.cage || shape.cage->rest.size() != key->value.size()) return;
                auto added = *key;
                added.frame = at;
                if constexpr (Dim == 2 && std::is_same_v<Value, animation::Look>) added.value.inSpace.reset();
                present.push_back(std::move(added));
                putInOrder(present);
                result.keys.push_back({copied.at.track, at});
            });
        }
    });
    return result;
}

Fractal withoutMotion(Fractal entry, std::size_t motion) {
    inItsDimension(entry, [&]<int Dim>(Shape<Dim>& shape) {
        auto& motions = animationOf<Dim>(shape).motions;
        if (motion < motions.size()) motions.erase(motions.begin() + std::ptrdiff_t(motion));
    });
    return entry;
}

std::vector<MotionNumber> motionNumbers(const Fractal& entry, std::size_t motion) {
    std::vector<MotionNumber> numbers;
    inItsDimension(entry, [&]<int Dim>(const Shape<Dim>& shape) {
        if (!shape.animation || motion >= shape.animation->motions.size()) return;
        visitNumbers(shape.animation->motions[motion], [&](MotionNumber::Kind kind, const auto& number) {
            numbers.push_back({kind, double(number)});
        });
    });
    return numbers;
}

Fractal withMotionNumbers(Fractal entry, std::size_t motion, std::span<const MotionNumber> numbers) {
    if (numbers.size() != motionNumbers(entry, motion).size()) return entry;
    inItsDimension(entry, [&]<int Dim>(Shape<Dim>& shape) {
        if (numbers.empty()) return;
        animation::Motion<Dim> changed = shape.animation->motions[motion];
        auto next = numbers.begin();
        visitNumbers(changed, [&]<class Number>(MotionNumber::Kind, Number& number) {
            constexpr double beyond = 2 * animation::maxCycles; // fits into an int, and is refused
            number = Number(std::clamp((next++)->value, -beyond, beyond));
        });
        if (animation::isValid<Dim>(changed)) shape.animation->motions[motion] = std::move(changed);
    });
    return entry;
}

} // namespace document
