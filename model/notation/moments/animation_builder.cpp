// SPDX-License-Identifier: MIT
#include "notation/moments/animation_builder.h"

#include "animation/motions/motion_fields.h"

#include <cstddef>
#include <span>
#include <utility>

namespace notation {

namespace {

using Stored = AnimationLines::Stored;
using animation::Animation, animation::CameraPose, animation::CagePose, animation::Keys, animation::Look,
    animation::MapIds, animation::MapPose;

template <int Dim> constexpr std::size_t rowLength = Dim*(Dim + 1);

template <int Dim> class AnimationBuilder {
public:
    AnimationBuilder(const Stored& stored, const ifs::IteratedFunctionSystem<Dim>& system,
                     const std::optional<ifs::ControlCage<Dim>>& cage)
        : m_stored(stored), m_system(system), m_cage(cage) {}

    // nullopt when something does not fit.
    std::optional<Animation<Dim>> animation() && {
        m_animation.rate = m_stored.rate;
        m_animation.length = m_stored.length;
        m_animation.loop = m_stored.loop;
        if (!m_stored.reference.empty()) m_animation.reference = point(m_stored.reference);
        for (const Stored::Track& track : m_stored.tracks)
            add(track);
        for (const Stored::Motion& motion : m_stored.motions)
            add(motion);
        m_fits = m_fits && animation::isValid(m_animation);
        return m_fits ? std::optional(std::move(m_animation)) : std::nullopt;
    }

private:
    using Track = Stored::Track;

    bool fits(bool condition) {
        m_fits = m_fits && condition;
        return condition;
    }

    ifs::Vector<Dim> point(std::span<const double> numbers) {
        if (!fits(numbers.size() == Dim)) return ifs::Vector<Dim>::Zero();
        return Eigen::Map<const ifs::Vector<Dim>>(numbers.data());
    }

    ifs::Vector<3> axis(const std::vector<double>& numbers) {
        if (!fits(Dim == 3 ? numbers.size() == 3 : numbers.empty()) || Dim == 2)
            return ifs::Vector<3>::UnitZ();
        return Eigen::Map<const ifs::Vector<3>>(numbers.data());
    }

    ifs::AffineMap<Dim> map(std::span<const double> numbers) {
        ifs::AffineMap<Dim> result;
        if (!fits(numbers.size() == rowLength<Dim>)) return result;
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j)
                result.linear(i, j) = numbers[std::size_t(i * Dim + j)];
        result.translation = point(numbers.subspan(std::size_t(Dim) * Dim));
        return result;
    }

    MapIds ids(std::span<const int> numbers) {
        MapIds result;
        for (const int number : numbers)
            if (fits(std::size_t(number) <= m_system.maps.size()))
                result.push_back(m_system.maps[std::size_t(number - 1)].id);
        return result;
    }

    MapIds word(std::span<const int> numbers) {
        const bool recurs = !numbers.empty() && numbers.front() == 0;
        MapIds address = ids(numbers.subspan(recurs ? 1 : 0));
        fits(!address.empty());
        if (recurs) address.insert(address.begin(), ifs::MapId::None);
        return address;
    }

    MapPose<Dim> mapPose(const Stored::Key& key) {
        const std::span<const double> numbers = key.values;
        MapPose<Dim> pose;
        if (numbers.size() == rowLength<Dim> + 1) pose.weight = numbers.back();
        pose.map = map(numbers.first(numbers.size() - (pose.weight ? 1 : 0)));
        return pose;
    }

    CagePose<Dim> cagePose(const Stored::Key& key) {
        CagePose<Dim> pose;
        const std::span<const double> numbers = key.values;
        if (!fits(m_cage && numbers.size() == m_cage->rest.size() * Dim)) return pose;
        for (std::size_t at = 0; at < numbers.size(); at += Dim)
            pose.push_back(point(numbers.subspan(at, Dim)));
        return pose;
    }

    Look look(const Stored::Key& key) {
        Look look = animation::lookOf(key.look.appearance(0));
        const auto palette = key.look.palette();
        if (fits(palette && key.values.empty())) look.palette = *palette;
        if (key.inSpace && fits(Dim == 3)) look.inSpace = key.inSpace->appearance();
        return look;
    }

    CameraPose<Dim> camera(const Stored::Key& key) {
        const std::vector<double>& n = key.values;
        if constexpr (Dim == 2) {
            const bool isTurned = n.size() == 5; // else there is no rotation
            if (!fits((n.size() == 4 || isTurned) && (n[3] == 1 || n[3] == -1))) return {};
            return {{n[0], n[1]},
                    n[2],
                    n[3] == 1 ? attractor::YAxis::Up : attractor::YAxis::Down,
                    isTurned ? attractor::rotationOf(n[4]) : 0};
        } else {
            attractor::OrbitCamera camera;
            if (!fits(n.size() == 10 && (n[9] == 0 || n[9] == 1))) return camera;
            camera.target = {n[0], n[1], n[2]};
            camera.orientation = attractor::Orientation(n[3], n[4], n[5], n[6]);
            camera.height = n[7];
            camera.fieldOfView = n[8];
            if (n[9] == 1) camera.projection = attractor::OrbitCamera::Projection::Perspective;
            return camera;
        }
    }

    template <class Value>
    Keys<Value> keys(const Track& track, Value (AnimationBuilder::*value)(const Stored::Key&)) {
        Keys<Value> result;
        for (const Stored::Key& key : track.keys) {
            animation::Ease ease = key.ease;
            if (ease.kind == animation::Ease::Kind::Cubic && fits(key.handles.size() == 4)) {
                ease.x1 = key.handles[0];
                ease.y1 = key.handles[1];
                ease.x2 = key.handles[2];
                ease.y2 = key.handles[3];
            }
            result.push_back({key.frame, (this->*value)(key), ease});
        }
        fits(!result.empty());
        return result;
    }

    ifs::AffineMap<Dim> change(const Stored::Key& key) { return map(key.values); }

    void add(const Track& track) {
        switch (track.of) {
        case Track::Of::Cage:
            fits(m_animation.cage.empty());
            m_animation.cage = keys(track, &AnimationBuilder::cagePose);
            break;
        case Track::Of::Map:
            if (const MapIds map = ids(track.maps); fits(map.size() == 1))
                m_animation.maps.push_back({map.front(), keys(track, &AnimationBuilder::mapPose)});
            break;
        case Track::Of::Branch:
            m_animation.branches.push_back({word(track.maps), keys(track, &AnimationBuilder::change)});
            break;
        case Track::Of::Look:
            fits(m_animation.look.empty());
            m_animation.look = keys(track, &AnimationBuilder::look);
            break;
        case Track::Of::Camera:
            fits(m_animation.camera.empty());
            m_animation.camera = keys(track, &AnimationBuilder::camera);
            break;
        }
    }

    // Takes stored fields into a motion; no other field may be stored.
    struct MotionFields {
        AnimationBuilder& builder;
        Stored::Motion left;

        void maps(MapIds& ids) { ids = builder.ids(std::exchange(left.maps, {})); }
        void count(int& number) {
            number = left.count.value_or(0);
            builder.fits(std::exchange(left.count, {}).has_value());
        }
        void strength(double& number) {
            number = left.strength.value_or(0);
            builder.fits(std::exchange(left.strength, {}).has_value());
        }
        void pivot(ifs::Vector<Dim>& point) { point = builder.point(std::exchange(left.pivot, {})); }
        void axis(ifs::Vector<3>& direction) { direction = builder.axis(left.axis); }
        // An orbit in space without an axis goes about the target, as all of them did before axes were
        // stored.
        void axis(ifs::Vector<3>& direction, animation::OrbitPivot& pivot) {
            if (Dim == 3 && left.axis.empty())
                pivot = animation::OrbitPivot::Target;
            else if (Dim == 3)
                axis(direction);
        }
        void waves(std::vector<animation::Wave>& waves) {
            for (const Stored::Wave& wave : std::exchange(left.waves, {}))
                if (builder.fits(wave.values.size() == 3))
                    waves.push_back({wave.values[0], wave.cycles, wave.values[1], wave.values[2]});
        }
        bool isEmpty() const {
            return left.maps.empty() && !left.count && !left.strength && left.pivot.empty() &&
                   left.waves.empty();
        }
    };

    void add(const Stored::Motion& stored) {
        auto motion = animation::motionNamed<Dim>(stored.kind);
        if (!fits(motion.has_value())) return;
        MotionFields fields{*this, stored};
        animation::listFields(*motion, fields);
        fits(fields.isEmpty());
        m_animation.motions.push_back(*std::move(motion));
    }

    const Stored& m_stored;
    const ifs::IteratedFunctionSystem<Dim>& m_system;
    const std::optional<ifs::ControlCage<Dim>>& m_cage;
    Animation<Dim> m_animation;
    bool m_fits = true;
};

} // namespace

template <int Dim>
std::optional<Animation<Dim>> animationOf(const AnimationLines::Stored& stored,
                                          const ifs::IteratedFunctionSystem<Dim>& system,
                                          const std::optional<ifs::ControlCage<Dim>>& cage) {
    return AnimationBuilder<Dim>(stored, system, cage).animation();
}
template std::optional<Animation<2>> animationOf(const AnimationLines::Stored&,
                                                 const ifs::IteratedFunctionSystem<2>&,
                                                 const std::optional<ifs::ControlCage<2>>&);
template std::optional<Animation<3>> animationOf(const AnimationLines::Stored&,
                                                 const ifs::IteratedFunctionSystem<3>&,
                                                 const std::optional<ifs::ControlCage<3>>&);

} // namespace notation
