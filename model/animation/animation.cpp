// SPDX-License-Identifier: MIT
#include "animation/animation.h"

#include "animation/paths/contraction.h"
#include "animation/paths/smooth_keys.h"
#include "animation/paths/smooth_paths.h"
#include "attractor/request/appearance_fields.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace animation {

namespace {

template <int Dim> const MapTrack<Dim>* trackOf(const Animation<Dim>& animation, ifs::MapId map) {
    const auto found = std::ranges::find(animation.maps, map, &MapTrack<Dim>::map);
    return found == animation.maps.end() ? nullptr : &*found;
}

template <int Dim> ifs::Vector<Dim> referenceOf(const Animation<Dim>& animation, const Pose<Dim>& still) {
    if (animation.reference) return *animation.reference;
    ifs::Vector<Dim> sum = ifs::Vector<Dim>::Zero();
    if (still.cage && !still.cage->rest.empty()) {
        for (const auto& vertex : still.cage->rest)
            sum += vertex;
        return sum / double(still.cage->rest.size());
    }
    int count = 0;
    for (const auto& map : still.system.maps)
        if (const auto fixed = ifs::fixedPoint<Dim>(map.map)) {
            sum += *fixed;
            ++count;
        }
    return count > 0 ? ifs::Vector<Dim>(sum / count) : sum;
}

// The centre of a branch: the image of the reference under the maps of its address in the still system.
template <int Dim>
ifs::Vector<Dim> centreOf(const std::vector<ifs::MapId>& word, const ifs::IteratedFunctionSystem<Dim>& system,
                          ifs::Vector<Dim> reference) {
    for (auto id = word.rbegin(); id != word.rend(); ++id) {
        const auto map = std::ranges::find(system.maps, *id, &ifs::WeightedMap<Dim>::id);
        if (map != system.maps.end()) reference = map->map(reference);
    }
    return reference;
}

// The evaluation of an animation at one moment.
template <int Dim> class Evaluation {
public:
    Evaluation(const Animation<Dim>& animation, const Moment& moment, Pose<Dim> still)
        : m_animation(animation),
          m_clock{folded(moment, animation.loop, animation.length), animation.loop, animation.length},
          m_pose(std::move(still)),
          m_reference(referenceOf(animation, m_pose)) {}

    Pose<Dim> pose() && {
        moveBranches(); // relative to the code at rest
        moveMaps();
        moveCage();
        if (!m_animation.look.empty()) moveLook();
        if (!m_animation.camera.empty()) m_pose.camera = along(wayAt(m_animation.camera, m_clock));
        for (const Motion<Dim>& motion : m_animation.motions)
            apply(motion);
        return std::move(m_pose);
    }

private:
    void moveMaps() {
        if (m_animation.maps.empty()) return;
        const CommonNorm<Dim> norm = commonNorm(m_animation, m_pose.system).value_or(CommonNorm<Dim>());
        for (const MapTrack<Dim>& track : m_animation.maps) {
            const auto map = std::ranges::find(m_pose.system.maps, track.map, &ifs::WeightedMap<Dim>::id);
            if (map == m_pose.system.maps.end() || track.keys.empty()) continue;
            const MapPose<Dim> pose = along<Dim>(wayAt(track.keys, m_clock), m_reference, norm);
            map->map = pose.map;
            map->weight = pose.weight;
        }
    }

    void moveBranches() {
        for (const BranchTrack<Dim>& track : m_animation.branches) {
            if (track.keys.empty()) continue;
            const auto change =
                along<Dim>(wayAt(track.keys, m_clock), centreOf<Dim>(track.word, m_pose.system, m_reference));
            const auto known = std::ranges::find(m_pose.moved, track.word, &BranchPose<Dim>::word);
            if (known != m_pose.moved.end())
                known->change = change;
            else
                m_pose.moved.push_back({track.word, change});
        }
    }

    void moveCage() {
        if (m_animation.cage.empty() || !m_pose.cage) return;
        const auto way = wayAt(m_animation.cage, m_clock);
        const std::size_t vertices = m_pose.cage->rest.size();
        if (way.from.size() == vertices && way.to.size() == vertices)
            m_pose.cage->current = along<Dim>(way, *m_pose.cage);
    }

    void moveLook() {
        Look look;
        if (Dim == 3 && !std::ranges::all_of(m_animation.look, saysHowInSpace)) {
            Keys<Look> keys = m_animation.look;
            for (Key<Look>& key : keys)
                if (!saysHowInSpace(key)) key.value.inSpace = m_pose.inSpace;
            look = along(wayAt(keys, m_clock));
        } else {
            look = along(wayAt(m_animation.look, m_clock));
        }
        m_pose.appearance = withLook(std::move(m_pose.appearance), look);
        if (look.inSpace) m_pose.inSpace = *look.inSpace;
    }

    static bool saysHowInSpace(const Key<Look>& key) { return key.value.inSpace.has_value(); }

    void apply(const Motion<Dim>& motion) {
        animation::moveMaps<Dim>(motion, m_clock.moment, m_clock.length, m_pose.system);
        const double angle = orbitAngle<Dim>(motion, m_clock.moment, m_clock.length);
        if (const auto* orbit = std::get_if<Orbit<Dim>>(&motion)) {
            if constexpr (Dim == 2) {
                if (angle != 0 && m_pose.cage) turnCage(*m_pose.cage, orbit->centre, angle);
            } else {
                const bool isAboutCentre = orbit->pivot == OrbitPivot::Centre;
                m_pose.orbit.push_back(
                    {angle, orbit->axis, isAboutCentre ? std::optional(orbit->centre) : std::nullopt});
            }
        }
        if (const auto* cycle = std::get_if<PaletteCycle>(&motion))
            m_pose.appearance.palette =
                cycled(m_pose.appearance.palette, phase(m_clock.moment, m_clock.length, cycle->cycles));
    }

    const Animation<Dim>& m_animation;
    Clock m_clock;
    Pose<Dim> m_pose;
    ifs::Vector<Dim> m_reference;
};

bool isPositive(double number) {
    return number > 0 && std::isfinite(number);
}

bool isValid(const attractor::View& view) {
    return view.centre.allFinite() && isPositive(view.height) && std::isfinite(view.rotation);
}
bool isValid(const attractor::OrbitCamera& camera) {
    return camera.target.allFinite() && isPositive(camera.height) && camera.fieldOfView > 0 &&
           camera.fieldOfView < 180 && std::abs(camera.orientation.norm() - 1) <= 1e-9;
}
bool isValid(const attractor::SpaceAppearance& look) {
    return std::isfinite(look.lightAzimuth) && std::isfinite(look.lightElevation) && look.fog >= 0 &&
           look.fog <= attractor::SpaceAppearance::maxFog && (!look.clip || isUsable(*look.clip));
}
bool isValid(const Look& look) {
    const auto& stops = look.palette.stops;
    const auto isInRange = [&](const auto& number) { return number.accepts(look.*number.member); };
    return std::ranges::all_of(attractor::appearanceNumbers, isInRange) &&
           (!look.inSpace || isValid(*look.inSpace)) && stops.size() >= 2 && stops.front().position == 0 &&
           stops.back().position == 1 &&
           std::ranges::is_sorted(stops, {}, &attractor::Palette::Stop::position);
}
template <int Dim> bool isValid(const ifs::AffineMap<Dim>& map) {
    return ifs::isFinite<Dim>(map);
}
template <int Dim> bool isValid(const MapPose<Dim>& pose) {
    return ifs::isFinite<Dim>(pose.map) && (!pose.weight || std::isfinite(*pose.weight));
}
template <int Dim> bool isValid(const CagePose<Dim>& vertices) {
    return std::ranges::all_of(vertices, [](const auto& vertex) { return vertex.allFinite(); });
}

template <int Dim, class Value> bool areValid(const Keys<Value>& keys, int length) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const bool isInOrder = i == 0 ? keys[i].frame >= 0 : keys[i].frame > keys[i - 1].frame;
        if (!isInOrder || keys[i].frame > length || !isValid(keys[i].ease)) return false;
        if constexpr (std::is_same_v<Value, CagePose<Dim>>) {
            if (!isValid<Dim>(keys[i].value) || keys[i].value.size() != keys[0].value.size()) return false;
        } else {
            if (!isValid(keys[i].value)) return false;
            if constexpr (Dim == 2 && std::is_same_v<Value, Look>)
                if (keys[i].value.inSpace) return false;
        }
    }
    return true;
}

} // namespace

template <int Dim> Animation<Dim>::Animation() = default;
template <int Dim> Animation<Dim>::Animation(const Animation& other) = default;
template <int Dim> Animation<Dim>::Animation(Animation&& other) noexcept = default;
template <int Dim> Animation<Dim>& Animation<Dim>::operator=(const Animation& other) = default;
template <int Dim> Animation<Dim>& Animation<Dim>::operator=(Animation&& other) noexcept = default;
template <int Dim> Animation<Dim>::~Animation() = default;

template <int Dim> Pose<Dim> Animation<Dim>::at(const Moment& moment, Pose<Dim> still) const {
    return Evaluation<Dim>(*this, moment, std::move(still)).pose();
}

template <int Dim> int trackCount(const Animation<Dim>& animation) {
    const auto one = [](const auto& keys) { return keys.empty() ? 0 : 1; };
    return one(animation.cage) + one(animation.look) + one(animation.camera) + int(animation.maps.size()) +
           int(animation.branches.size());
}

template <int Dim> bool isValid(const Animation<Dim>& animation) {
    const int length = animation.length;
    if (length < 1 || length > maxLength || animation.rate.frames < 1 || animation.rate.seconds < 1)
        return false;
    if (animation.reference && !animation.reference->allFinite()) return false;
    std::set<std::vector<ifs::MapId>> known;
    for (const auto& track : animation.maps)
        if (track.keys.empty() || !known.insert({track.map}).second || !areValid<Dim>(track.keys, length))
            return false;
    known.clear();
    for (const auto& track : animation.branches)
        if (track.keys.empty() || track.word.empty() || !known.insert(track.word).second ||
            !areValid<Dim>(track.keys, length))
            return false;
    return areValid<Dim>(animation.cage, length) && areValid<Dim>(animation.look, length) &&
           areValid<Dim>(animation.camera, length) &&
           std::ranges::all_of(animation.motions,
                               [](const Motion<Dim>& motion) { return animation::isValid<Dim>(motion); });
}

template <int Dim>
std::optional<CommonNorm<Dim>> commonNorm(const Animation<Dim>& animation,
                                          const ifs::IteratedFunctionSystem<Dim>& still) {
    // Most common case: all maps contract at all keys. Maps are read in place, because there may be thousands
    // of keys.
    const std::vector<double> probabilities = ifs::probabilities(still);
    const auto allOf = [&](auto&& holds) {
        for (std::size_t i = 0; i < still.maps.size(); ++i)
            if (const auto* track = trackOf(animation, still.maps[i].id)) {
                for (const auto& key : track->keys)
                    if (!holds(key.value.map)) return false;
            } else if (probabilities[i] > 0 && !holds(still.maps[i].map)) {
                return false;
            }
        return true;
    };
    if (allOf(contracts<Dim>)) return CommonNorm<Dim>{};
    // Cache of the last norm, which takes long to find: the next moment of an animation often has the same
    // one.
    struct Found {
        std::vector<ifs::AffineMap<Dim>> maps;
        std::optional<CommonNorm<Dim>> norm;
    };
    thread_local Found last;
    std::size_t same = 0;
    const bool isKnown = allOf(
        [&](const ifs::AffineMap<Dim>& map) { return same < last.maps.size() && last.maps[same++] == map; });
    if (isKnown && same == last.maps.size()) return last.norm;
    last.maps.clear();
    allOf([&](const ifs::AffineMap<Dim>& map) {
        last.maps.push_back(map);
        return true;
    });
    last.norm = commonNorm<Dim>(last.maps);
    return last.norm;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template struct Animation<Dim>;                                                                          \
    template int trackCount<Dim>(const Animation<Dim>&);                                                     \
    template bool isValid<Dim>(const Animation<Dim>&);                                                       \
    template std::optional<CommonNorm<Dim>> commonNorm<Dim>(const Animation<Dim>&,                           \
                                                            const ifs::IteratedFunctionSystem<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace animation
