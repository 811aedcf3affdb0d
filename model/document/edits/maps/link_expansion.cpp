// SPDX-License-Identifier: MIT
#include "document/edits/maps/link_expansion.h"

#include "document/edits/maps/map_locks.h"
#include "document/text/text.h"
#include "ifs/links/plain_words.h"
#include "ifs/system/links.h"

#include <algorithm>
#include <utility>

namespace document {

namespace {

constexpr std::size_t maxWords = 4096;

std::optional<ifs::PlainWords> wordsOf(const System2& system) {
    return ifs::plainWords(ifs::activeMaps(system), maxWords);
}

bool isEachOneMap(const ifs::PlainWords& plain) {
    return std::ranges::all_of(plain.words, [](const auto& word) { return word.size() == 1; });
}

// The maps as they are, with the weights that they have come to.
void unlinkMaps(System2& system, const ifs::ActiveMaps<2>& active, const ifs::PlainWords& plain) {
    const std::vector<ifs::LinkState> states = ifs::linkStates(system);
    for (std::size_t i = 0; i < states.size(); ++i)
        if (states[i] != ifs::LinkState::TakesPart) system.maps[i].enabled = false;
    for (std::size_t k = 0; k < plain.words.size(); ++k)
        system.maps[active.index[plain.words[k].front()]].weight = plain.weights[k];
    system.links.clear();
}

void listWords(Fractal& fractal, const ifs::ActiveMaps<2>& active, const ifs::PlainWords& plain) {
    System2& system = plane(fractal)->system;
    attractor::Appearance& appearance = fractal.appearance;
    const bool isByMap = appearance.colourBy == attractor::ColourBy::Map;
    const bool hasBlends = appearance.colourBy == attractor::ColourBy::Blend || !appearance.mapBlends.empty();
    const auto blendOf = [&](std::size_t map) {
        const std::size_t index = active.index[map];
        return attractor::mapBlend(appearance, system.maps[index].id, index, system.maps.size());
    };
    System2 listed;
    attractor::MapColours colours;
    attractor::MapBlends blends;
    MapLabels labels;
    for (std::size_t k = 0; k < plain.words.size(); ++k) {
        ifs::AffineMap<2> map = active.maps[plain.words[k].front()];
        attractor::MapBlend blend = blendOf(plain.words[k].front());
        for (std::size_t m = 1; m < plain.words[k].size(); ++m) {
            map = map * active.maps[plain.words[k][m]];
            blend = attractor::composed(blend, blendOf(plain.words[k][m]));
        }
        const ifs::MapId made = ifs::append(listed, map, plain.weights[k]);
        const std::size_t outermost = active.index[plain.words[k].front()];
        const ifs::MapId id = system.maps[outermost].id;
        if (isByMap || appearance.mapColours.find(id) != nullptr)
            colours[made] = attractor::mapColour(appearance, id, outermost);
        if (hasBlends) blends[made] = blend;
        copyLabel(fractal.mapLabels, id, labels, made, CopyLock::Keep);
    }
    fractal.mapLabels = std::move(labels);
    appearance.mapColours = std::move(colours);
    appearance.mapBlends = std::move(blends);
    system = std::move(listed);
}

} // namespace

bool isLinked(const Fractal& fractal) {
    const System2* system = system2(fractal);
    return system != nullptr && !system->links.empty();
}

QString linkExpansionObstacle(const Fractal& fractal) {
    if (!isLinked(fractal)) return {};
    const Shape<2>& shape = *plane(fractal);
    if (ifs::countActive(shape.system) == 0)
        return Text::tr("With the links of “%1” every sequence of maps ends, so plain maps would have "
                        "nothing to draw.")
            .arg(fractal.name);
    const auto plain = wordsOf(shape.system);
    if (!plain && ifs::hasPlainWords(ifs::activeMaps(shape.system)))
        return Text::tr(
                   "Plain maps of “%1” would be more than %2 words of its maps, which is the limit. Keep "
                   "the links in an .ifs or .flame file, or remove them.")
            .arg(fractal.name, QString::number(maxWords));
    if (!plain)
        return Text::tr(
                   "The links of “%1” cannot be written as plain maps: a sequence of maps can go on for ever "
                   "without reaching one that may follow every map. Keep the links in an .ifs or .flame "
                   "file, or remove them.")
            .arg(fractal.name);
    if (isEachOneMap(*plain)) return {};
    const bool moves =
        shape.animation && !(shape.animation->maps.empty() && shape.animation->motions.empty());
    if (moves || !shape.moved.empty())
        return Text::tr(
                   "Plain maps of “%1” would be words of its maps, which cannot take part in its animation "
                   "or in its moved branches. Remove these first.")
            .arg(fractal.name);
    return {};
}

Fractal withLinksExpanded(Fractal fractal) {
    if (!isLinked(fractal)) return fractal;
    System2& system = plane(fractal)->system;
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    const auto plain = ifs::plainWords(active, maxWords);
    if (!plain) return fractal;
    if (isEachOneMap(*plain))
        unlinkMaps(system, active, *plain);
    else
        listWords(fractal, active, *plain);
    return fractal;
}

bool linkExpansionKeepsDensity(const Fractal& fractal) {
    if (!isLinked(fractal)) return true;
    const auto plain = wordsOf(plane(fractal)->system);
    return plain && plain->keepsMeasure;
}

} // namespace document
