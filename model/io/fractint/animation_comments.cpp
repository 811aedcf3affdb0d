// SPDX-License-Identifier: MIT
#include "io/fractint/animation_comments.h"

#include "animation/motions/motion_fields.h"
#include "document/text/text.h"
#include "io/fractint/appearance_comments.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"
#include "notation/moments/animation_builder.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace io {

namespace {

using animation::Animation, animation::CagePose, animation::Keys, animation::Look, animation::MapIds,
    animation::MapPose;

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
    const std::string_view known(key.constData(), std::size_t(key.size()));
    if (!notation::AnimationLines::isKnown(known)) return false;
    if (notation::AnimationLines::begins(known)) m_blocks.emplace_back();
    if (m_blocks.empty()) return false;
    m_blocks.back().lines.read(key.toStdString(), plainWords(values));
    m_blocks.back().numbers.push_back(line);
    return true;
}

template <int Dim> AnimationComments::Outcome AnimationComments::applyTo(document::Shape<Dim>& shape) const {
    Outcome outcome;
    for (auto block = m_blocks.rbegin(); block != m_blocks.rend(); ++block) {
        std::optional<Animation<Dim>> animation;
        if (!shape.animation && !block->lines.mistake())
            animation = notation::animationOf<Dim>(block->lines.stored(), shape.system, shape.cage);
        if (animation) {
            shape.animation = std::move(animation);
            continue;
        }
        outcome.kept.insert(outcome.kept.end(), block->numbers.begin(), block->numbers.end());
        outcome.sentences << (block->lines.mistake()
                                  ? Text::tr("The stored animation is not applied, because “%1” is not "
                                             "understood; its lines are kept.")
                                        .arg(QString::fromStdString(*block->lines.mistake()))
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
