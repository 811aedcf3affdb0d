// SPDX-License-Identifier: MIT
#include "notation/moments/entry_moment.h"

#include "ifs/extent/extent.h"
#include "ifs/links/linked_existence.h"
#include "ifs/links/linked_extent.h"
#include "notation/lines/space_lines.h"
#include "notation/moments/animation_builder.h"
#include "notation/moments/animation_lines.h"
#include "notation/text/words.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace notation {

namespace {

// The animations of an entry, in their order.
class StoredAnimations {
public:
    // Returns true if the line is one of an animation.
    bool read(const std::string& comment) {
        auto [key, values] = ownWords(comment);
        if (!AnimationLines::isKnown(key)) return false;
        if (AnimationLines::begins(key)) m_blocks.emplace_back();
        if (m_blocks.empty()) return false;
        m_blocks.back().read(key, values);
        return true;
    }

    const std::vector<AnimationLines>& blocks() const { return m_blocks; }

private:
    std::vector<AnimationLines> m_blocks;
};

StoredAnimations storedIn(const Entry& entry) {
    StoredAnimations stored;
    for (const std::string& line : entry.otherLines)
        stored.read(line);
    return stored;
}

// The appearance in space, which takes its lines from those that the entry keeps.
attractor::SpaceAppearance takenFrom(std::vector<std::string>& lines) {
    SpaceReader reader;
    std::erase_if(lines, [&](const std::string& line) {
        auto [key, values] = ownWords(line);
        return reader.read(key, values);
    });
    return reader.appearance();
}

// document::canonicalCage(), to the last bit.
ifs::ControlCage<2> canonicalCageOf(const ifs::IteratedFunctionSystem<2>& system) {
    constexpr double tolerance = 1e-10; // as a share
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    if (!active.isLinked()) {
        if (const auto support = ifs::SupportFunction<2>::of(active.maps))
            return ifs::cageAtRest(
                ifs::minimalCanonicalSimplex(*support, tolerance * support->radius()).vertices);
    } else if (const auto linked = ifs::LinkedExtent::of(active, ifs::classifyLinked<2>(active))) {
        return ifs::cageAtRest(ifs::minimalCanonicalSimplex(*linked).vertices);
    }
    return ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)});
}

// A turn of the whole plane turns the cage, which an entry without one has all the same.
template <int Dim> bool turnsPlane(const animation::Animation<Dim>& animation) {
    return Dim == 2 && std::ranges::any_of(animation.motions, [](const animation::Motion<Dim>& motion) {
               return std::holds_alternative<animation::Orbit<Dim>>(motion);
           });
}

template <int Dim>
Entry movedTo(Entry entry, const animation::Animation<Dim>& animation, const animation::Moment& moment) {
    StoredAnimations taken;
    std::erase_if(entry.otherLines, [&](const std::string& line) { return taken.read(line); });
    auto& figure = std::get<Figure<Dim>>(entry.figure);
    if constexpr (Dim == 2)
        if (!figure.cage && turnsPlane(animation)) figure.cage = canonicalCageOf(figure.system);
    const attractor::SpaceAppearance inSpace =
        Dim == 3 ? takenFrom(entry.otherLines) : attractor::SpaceAppearance();
    animation::Pose<Dim> pose = animation.at(moment, {std::move(figure.system),
                                                      std::move(figure.cage),
                                                      std::move(figure.moved),
                                                      std::move(entry.appearance),
                                                      {},
                                                      {},
                                                      inSpace});
    figure.system = std::move(pose.system);
    figure.cage = std::move(pose.cage);
    figure.moved = std::move(pose.moved);
    entry.appearance = std::move(pose.appearance);
    if (Dim == 3)
        for (const std::string& line : spaceLines(pose.inSpace))
            entry.otherLines.push_back(line.substr(2)); // without the semicolon
    return entry;
}

} // namespace

bool isAnimated(const Entry& entry) {
    return !storedIn(entry).blocks().empty();
}

template <int Dim> std::optional<animation::Animation<Dim>> animationOf(const Entry& entry) {
    const auto* figure = std::get_if<Figure<Dim>>(&entry.figure);
    if (figure == nullptr) return std::nullopt;
    const StoredAnimations stored = storedIn(entry);
    const std::vector<AnimationLines>& blocks = stored.blocks();
    for (auto lines = blocks.rbegin(); lines != blocks.rend(); ++lines) // the last one that is understood
        if (!lines->mistake())
            if (auto animation = animationOf<Dim>(lines->stored(), figure->system, figure->cage))
                return animation;
    return std::nullopt;
}
template std::optional<animation::Animation<2>> animationOf<2>(const Entry&);
template std::optional<animation::Animation<3>> animationOf<3>(const Entry&);

std::optional<AnimationFacts> animationFacts(const Entry& entry) {
    if (const auto plane = animationOf<2>(entry))
        return AnimationFacts{plane->rate, plane->length, plane->loop};
    if (const auto space = animationOf<3>(entry))
        return AnimationFacts{space->rate, space->length, space->loop};
    return std::nullopt;
}

Entry atMoment(Entry entry, const animation::Moment& moment) {
    if (const auto plane = animationOf<2>(entry)) return movedTo<2>(std::move(entry), *plane, moment);
    if (const auto space = animationOf<3>(entry)) return movedTo<3>(std::move(entry), *space, moment);
    return entry;
}

} // namespace notation
