// SPDX-License-Identifier: MIT
#include "notation/moments/animation_lines.h"

#include "notation/text/number.h"
#include "notation/text/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <utility>

namespace notation {

namespace {

using animation::Ease, animation::Loop;

constexpr std::size_t maxAnimationNumbers = 4'000'000; // numbers of one animation
constexpr std::size_t maxParts = 100'000; // tracks, keys of a track, motions, maps of a motion, stops

std::optional<int> whole(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole ? std::optional(value) : std::nullopt;
}

// A word of a branch may begin with 0.
bool appendMaps(std::vector<int>& maps, std::span<const std::string> values, bool isWord = false) {
    for (const std::string& value : values) {
        const auto map = whole(value);
        const int least = isWord && maps.empty() ? 0 : 1;
        if (!map || *map < least || maps.size() >= maxParts) return false;
        maps.push_back(*map);
    }
    return !values.empty();
}

} // namespace

bool AnimationLines::isKnown(std::string_view key) {
    constexpr std::array keys{"animation", "reference", "track", "word",   "key",
                              "handles",   "value",     "look",  "motion", "of",
                              "count",     "strength",  "pivot", "axis",   "wave"};
    return std::ranges::any_of(keys, [&](const char* known) { return key == known; });
}

bool AnimationLines::begins(std::string_view key) {
    return key == "animation";
}

void AnimationLines::read(const std::string& key, const std::vector<std::string>& values) {
    if (!m_mistake && !understood(key, values)) m_mistake = key + ' ' + joined(values);
}

bool AnimationLines::understood(const std::string& key, const std::vector<std::string>& values) {
    m_numbers += values.size();
    if (values.empty() || m_numbers > maxAnimationNumbers) return false;
    if (key == "animation") return readHeader(values);
    if (key == "track") return readTrack(values);
    if (key == "value") return readValues(values);
    if (key == "word" || key == "key" || key == "handles") return readKey(key, values);
    if (key == "look") return readLook(values);
    if (key != "reference") return readMotion(key, values);
    for (const std::string& value : values) {
        const auto coordinate = parseNumber(value);
        if (!coordinate) return false;
        m_stored.reference.push_back(*coordinate);
    }
    return true;
}

// "48 24/1 cycle"
bool AnimationLines::readHeader(const std::vector<std::string>& values) {
    if (values.size() != 3) return false;
    const std::vector<std::string> rate = words(values[1], '/');
    const auto length = whole(values[0]);
    const auto frames = whole(rate.front()), seconds = whole(rate.back());
    const auto loop = ifs::named<Loop>(values[2]);
    if (!length || rate.size() != 2 || !frames || !seconds || !loop) return false;
    m_stored.length = *length;
    m_stored.rate = {*frames, *seconds};
    m_stored.loop = *loop;
    return true;
}

bool AnimationLines::readTrack(const std::vector<std::string>& values) {
    using Of = Stored::Track::Of;
    const auto of = ifs::named<Of>(values[0]);
    if (!of || m_stored.tracks.size() >= maxParts) return false;
    m_stored.tracks.push_back({*of, {}, {}});
    m_within = Within::Track;
    if (*of == Of::Map)
        return values.size() == 2 && appendMaps(m_stored.tracks.back().maps, std::span(values).subspan(1));
    return values.size() == 1;
}

AnimationLines::Stored::Key* AnimationLines::lastKey() {
    if (m_within != Within::Track || m_stored.tracks.back().keys.empty()) return nullptr;
    return &m_stored.tracks.back().keys.back();
}

bool AnimationLines::readKey(const std::string& key, const std::vector<std::string>& values) {
    if (m_within != Within::Track) return false;
    Stored::Track& track = m_stored.tracks.back();
    if (key == "word")
        return track.of == Stored::Track::Of::Branch && track.keys.empty() &&
               appendMaps(track.maps, values, true);
    if (key == "key") {
        const auto frame = whole(values[0]);
        const auto ease = values.size() == 2 ? ifs::named<Ease::Kind>(values[1]) : std::nullopt;
        if (!frame || !ease || track.keys.size() >= maxParts) return false;
        Stored::Key next;
        next.frame = *frame;
        next.ease.kind = *ease;
        track.keys.push_back(std::move(next));
        return true;
    }
    Stored::Key* last = lastKey();
    if (last == nullptr || last->ease.kind != Ease::Kind::Cubic) return false;
    for (const std::string& value : values) {
        const auto handle = parseNumber(value);
        if (!handle) return false;
        last->handles.push_back(*handle);
    }
    return last->handles.size() <= 4;
}

bool AnimationLines::readLook(const std::vector<std::string>& values) {
    Stored::Key* key = lastKey();
    if (key == nullptr || m_stored.tracks.back().of != Stored::Track::Of::Look) return false;
    const std::string& what = values[0];
    const std::vector<std::string> said(values.begin() + 1, values.end());
    const bool isOfEntry = what == "supersample" || what == "map-colour" || what == "map-blend";
    if (!isOfEntry && key->look.read(what, said)) return true;
    SpaceReader inSpace = key->inSpace.value_or(SpaceReader());
    const bool isOfSpace = inSpace.read(what, said);
    if (isOfSpace) key->inSpace = std::move(inSpace);
    return isOfSpace;
}

bool AnimationLines::readMotion(const std::string& key, const std::vector<std::string>& values) {
    if (key == "motion") {
        if (values.size() != 1 || m_stored.motions.size() >= maxParts) return false;
        m_stored.motions.emplace_back().kind = values[0];
        m_within = Within::Motion;
        return true;
    }
    if (m_within != Within::Motion) return false;
    Stored::Motion& motion = m_stored.motions.back();
    if (key == "of") return appendMaps(motion.maps, values);
    if (key == "pivot" || key == "axis") {
        for (const std::string& value : values) {
            const auto coordinate = parseNumber(value);
            if (!coordinate) return false;
            (key == "pivot" ? motion.pivot : motion.axis).push_back(*coordinate);
        }
        return true;
    }
    if (values.size() != 1) return false;
    if (key == "strength") {
        motion.strength = parseNumber(values[0]);
        return motion.strength.has_value();
    }
    const auto count = whole(values[0]);
    if (!count || motion.waves.size() >= maxParts) return false;
    if (key == "count")
        motion.count = count;
    else
        motion.waves.push_back({*count, {}});
    return true;
}

// Reads values of the key or wave that was begun last.
bool AnimationLines::readValues(const std::vector<std::string>& values) {
    std::vector<double>* numbers = nullptr;
    if (Stored::Key* key = lastKey())
        numbers = &key->values;
    else if (m_within == Within::Motion && !m_stored.motions.back().waves.empty())
        numbers = &m_stored.motions.back().waves.back().values;
    if (numbers == nullptr) return false;
    for (const std::string& value : values) {
        const auto parsed = parseNumber(value);
        if (!parsed) return false;
        numbers->push_back(*parsed);
    }
    return true;
}

} // namespace notation
