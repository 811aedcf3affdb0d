// SPDX-License-Identifier: MIT
#include "io/fractint/animation_comments.h"

#include "animation/motions/motion_fields.h"
#include "document/fractal/recurring_branches.h"
#include "document/text/text.h"
#include "io/fractint/appearance_comments.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

namespace io {

namespace {

using Stored = AnimationLines::Stored;
using animation::Animation, animation::CameraPose, animation::CagePose, animation::Keys, animation::Look,
    animation::MapIds, animation::MapPose;

template <int Dim> constexpr std::size_t rowLength = Dim*(Dim + 1);

// Writing: numbers in the order in which a code row has them.

template <int Dim> void append(QByteArrayList& numbers, const ifs::Vector<Dim>& vector) {
    for (int i = 0; i < Dim; ++i)
        numbers << formatNumber(vector[i]);
}

template <int Dim> void append(QByteArrayList& numbers, const ifs::AffineMap<Dim>& map) {
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            numbers << formatNumber(map.linear(i, j));
    append<Dim>(numbers, map.translation);
}

template <int Dim> QByteArrayList numbersOf(const MapPose<Dim>& pose) {
    QByteArrayList numbers;
    append<Dim>(numbers, pose.map);
    if (pose.weight) numbers << formatNumber(*pose.weight);
    return numbers;
}

template <int Dim> QByteArrayList numbersOf(const ifs::AffineMap<Dim>& map) {
    QByteArrayList numbers;
    append<Dim>(numbers, map);
    return numbers;
}

template <int Dim> QByteArrayList numbersOf(const CagePose<Dim>& vertices) {
    QByteArrayList numbers;
    for (const auto& vertex : vertices)
        append<Dim>(numbers, vertex);
    return numbers;
}

QByteArrayList numbersOf(const attractor::View& view) {
    QByteArrayList numbers;
    append<2>(numbers, view.centre);
    numbers << formatNumber(view.height) << (view.yAxis == attractor::YAxis::Up ? "1" : "-1");
    if (view.rotation != 0) numbers << formatNumber(attractor::degreesOf(view.rotation));
    return numbers;
}

QByteArrayList numbersOf(const attractor::OrbitCamera& camera) {
    QByteArrayList numbers;
    append<3>(numbers, camera.target);
    for (const double part : {camera.orientation.w(), camera.orientation.x(), camera.orientation.y(),
                              camera.orientation.z(), camera.height, camera.fieldOfView})
        numbers << formatNumber(part);
    const bool isPerspective = camera.projection == attractor::OrbitCamera::Projection::Perspective;
    return numbers << (isPerspective ? "1" : "0");
}

template <int Dim, class Value> QByteArrayList keyLines(const Keys<Value>& keys) {
    QByteArrayList lines;
    for (const auto& [frame, value, ease] : keys) {
        lines << metadataLine("key", QByteArray::number(frame) + ' ' + ifs::nameOf(ease.kind));
        if (ease.kind == animation::Ease::Kind::Cubic)
            lines << metadataLines("handles", {formatNumber(ease.x1), formatNumber(ease.y1),
                                               formatNumber(ease.x2), formatNumber(ease.y2)});
        if constexpr (std::is_same_v<Value, Look>)
            lines << lookComments(value);
        else if constexpr (std::is_same_v<Value, CagePose<Dim>>)
            lines << metadataLines("value", numbersOf<Dim>(value));
        else
            lines << metadataLines("value", numbersOf(value));
    }
    return lines;
}

template <int Dim>
QByteArrayList numbersOf(const std::vector<ifs::MapId>& ids, const document::Shape<Dim>& shape) {
    QByteArrayList numbers;
    const auto& maps = shape.system.maps;
    for (const ifs::MapId id : ids) {
        if (id == ifs::MapId::None) numbers << "0"; // mark before the address of a branch: document::recurs()
        const auto found = std::ranges::find(maps, id, &ifs::WeightedMap<Dim>::id);
        if (found != maps.end()) numbers << QByteArray::number(qlonglong(found - maps.begin()) + 1);
    }
    return numbers;
}

// The lines of a motion.
template <int Dim> struct MotionLines {
    const document::Shape<Dim>& shape;
    QByteArrayList lines{};

    void maps(const MapIds& ids) {
        if (!ids.empty()) lines << metadataLines("of", numbersOf(ids, shape));
    }
    void count(int number) { lines << metadataLine("count", QByteArray::number(number)); }
    void strength(double number) { lines << metadataLine("strength", formatNumber(number)); }
    void pivot(const ifs::Vector<Dim>& point) {
        QByteArrayList numbers;
        append<Dim>(numbers, point);
        lines << metadataLines("pivot", numbers);
    }
    void axis(const ifs::Vector<3>& direction, animation::OrbitPivot pivot = animation::OrbitPivot::Centre) {
        QByteArrayList numbers;
        append<3>(numbers, direction);
        if (Dim == 3 && pivot == animation::OrbitPivot::Centre) lines << metadataLines("axis", numbers);
    }
    void waves(const std::vector<animation::Wave>& waves) {
        for (const animation::Wave& wave : waves)
            lines << metadataLine("wave", QByteArray::number(wave.cycles))
                  << metadataLines("value", {formatNumber(wave.amplitude), formatNumber(wave.phase),
                                             formatNumber(wave.lag)});
    }
};

// Reading: what the lines mean in this dimension.
template <int Dim> class AnimationBuilder {
public:
    AnimationBuilder(const Stored& stored, const document::Shape<Dim>& shape)
        : m_stored(stored), m_shape(shape) {}

    // Returns nullopt if something does not fit.
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
            if (fits(std::size_t(number) <= m_shape.system.maps.size()))
                result.push_back(m_shape.system.maps[std::size_t(number - 1)].id);
        return result;
    }

    MapIds word(std::span<const int> numbers) {
        const bool recurs = !numbers.empty() && numbers.front() == 0;
        MapIds address = ids(numbers.subspan(recurs ? 1 : 0));
        fits(!address.empty());
        return recurs ? document::recurringWord(std::move(address)) : address;
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
        if (!fits(m_shape.cage && numbers.size() == m_shape.cage->rest.size() * Dim)) return pose;
        for (std::size_t at = 0; at < numbers.size(); at += Dim)
            pose.push_back(point(numbers.subspan(at, Dim)));
        return pose;
    }

    Look look(const Stored::Key& key) {
        Look look = animation::lookOf(key.look.appearance());
        const auto palette = key.look.palette();
        if (fits(palette && key.values.empty())) look.palette = *palette;
        if (key.inSpace && fits(Dim == 3)) look.inSpace = key.inSpace->appearance();
        return look;
    }

    CameraPose<Dim> camera(const Stored::Key& key) {
        const std::vector<double>& n = key.values;
        if constexpr (Dim == 2) {
            const bool isTurned = n.size() == 5; // false: no rotation
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

    // Stores fields in a motion; further fields are an error.
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
        // Default for files without an axis: orbits in space used to go around the target.
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
        auto motion = animation::motionNamed<Dim>({stored.kind.constData(), std::size_t(stored.kind.size())});
        if (!fits(motion.has_value())) return;
        MotionFields fields{*this, stored};
        animation::listFields(*motion, fields);
        fits(fields.isEmpty());
        m_animation.motions.push_back(*std::move(motion));
    }

    const Stored& m_stored;
    const document::Shape<Dim>& m_shape;
    Animation<Dim> m_animation;
    bool m_fits = true;
};

} // namespace

template <int Dim> QByteArrayList animationComments(const document::Shape<Dim>& shape) {
    if (!shape.animation) return {};
    const Animation<Dim>& animation = *shape.animation;
    QByteArrayList lines{metadataLine("animation", QByteArray::number(animation.length) + ' ' +
                                                       QByteArray::number(animation.rate.frames) + '/' +
                                                       QByteArray::number(animation.rate.seconds) + ' ' +
                                                       ifs::nameOf(animation.loop))};
    if (animation.reference) {
        QByteArrayList numbers;
        append<Dim>(numbers, *animation.reference);
        lines << metadataLines("reference", numbers);
    }
    if (!animation.cage.empty()) lines << metadataLine("track", "cage") << keyLines<Dim>(animation.cage);
    for (const auto& track : animation.maps)
        lines << metadataLine("track", "map " + numbersOf<Dim>({track.map}, shape).value(0))
              << keyLines<Dim>(track.keys);
    for (const auto& track : animation.branches)
        lines << metadataLine("track", "branch") << metadataLines("word", numbersOf(track.word, shape))
              << keyLines<Dim>(track.keys);
    if (!animation.look.empty()) lines << metadataLine("track", "look") << keyLines<Dim>(animation.look);
    if (!animation.camera.empty())
        lines << metadataLine("track", "camera") << keyLines<Dim>(animation.camera);
    for (const auto& motion : animation.motions) {
        MotionLines<Dim> fields{shape};
        animation::listFields(motion, fields);
        const std::string_view id = animation::idOf<Dim>(motion);
        lines << metadataLine("motion", QByteArray(id.data(), qsizetype(id.size()))) << fields.lines;
    }
    return lines;
}

template <int Dim>
void renumberAnimation(document::Shape<Dim>& shape, const std::map<ifs::MapId, ifs::MapId>& ids) {
    Animation<Dim>& animation = *shape.animation;
    const auto renumbered = [&](ifs::MapId& id) {
        const auto known = ids.find(id);
        if (known != ids.end()) id = known->second;
        return known != ids.end() || id == ifs::MapId::None;
    };
    std::erase_if(animation.maps, [&](auto& track) { return !renumbered(track.map); });
    std::erase_if(animation.branches,
                  [&](auto& track) { return !std::ranges::all_of(track.word, renumbered); });
    std::erase_if(animation.motions, [&](auto& motion) {
        struct : animation::SkippedFields {
            MapIds* found = nullptr;
            void maps(MapIds& ids) { found = &ids; }
        } moved;
        animation::listFields(motion, moved);
        if (moved.found == nullptr || moved.found->empty()) return false;
        std::erase_if(*moved.found, [&](ifs::MapId& id) { return !renumbered(id); });
        return moved.found->empty();
    });
    const std::size_t vertices = shape.cage ? shape.cage->rest.size() : 0;
    if (!animation.cage.empty() && animation.cage.front().value.size() != vertices) animation.cage.clear();
    for (auto& key : animation.look) {
        const attractor::Palette* builtIn = attractor::findPalette(key.value.palette.name);
        if (builtIn == nullptr || !(*builtIn == key.value.palette))
            key.value.palette.name = storableText("look palette", key.value.palette.name);
    }
}

bool AnimationComments::read(const QByteArray& key, const QByteArrayList& values, std::size_t line) {
    if (!AnimationLines::isKnown(key)) return false;
    if (AnimationLines::begins(key)) m_blocks.emplace_back();
    if (m_blocks.empty()) return false;
    m_blocks.back().lines.read(key, values);
    m_blocks.back().numbers.push_back(line);
    return true;
}

template <int Dim> AnimationComments::Outcome AnimationComments::applyTo(document::Shape<Dim>& shape) const {
    Outcome outcome;
    for (auto block = m_blocks.rbegin(); block != m_blocks.rend(); ++block) {
        std::optional<Animation<Dim>> animation;
        if (!shape.animation && !block->lines.mistake())
            animation = AnimationBuilder<Dim>(block->lines.stored(), shape).animation();
        if (animation) {
            shape.animation = std::move(animation);
            continue;
        }
        outcome.kept.insert(outcome.kept.end(), block->numbers.begin(), block->numbers.end());
        outcome.sentences << (block->lines.mistake()
                                  ? Text::tr("The stored animation is not applied, because “%1” is not "
                                             "understood; its lines are kept.")
                                        .arg(QString::fromUtf8(*block->lines.mistake()))
                              : shape.animation
                                  ? Text::tr("The entry has more than one stored animation: the last valid "
                                             "one is used, and the lines of the others are kept.")
                                  : Text::tr("The stored animation is not valid and is not applied: it "
                                             "moves maps or vertices that do not exist, a frame, number or "
                                             "curve is out of its range, or keys are not in order. Its "
                                             "lines are kept."));
    }
    return outcome;
}

std::vector<std::size_t> AnimationComments::lines() const {
    std::vector<std::size_t> all;
    for (const Block& block : m_blocks)
        all.insert(all.end(), block.numbers.begin(), block.numbers.end());
    return all;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template QByteArrayList animationComments<Dim>(const document::Shape<Dim>&);                             \
    template void renumberAnimation<Dim>(document::Shape<Dim>&, const std::map<ifs::MapId, ifs::MapId>&);    \
    template AnimationComments::Outcome AnimationComments::applyTo<Dim>(document::Shape<Dim>&) const;
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace io
