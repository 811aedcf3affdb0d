// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "ifs/names.h"
#include "notation/lines/look_lines.h"
#include "notation/lines/space_lines.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace notation {

// The lines of one animation, in whatever dimension: names, counts and numbers, not yet interpreted.
class AnimationLines {
public:
    struct Stored {
        struct Key {
            int frame = 0;
            animation::Ease ease;
            std::vector<double> handles;
            std::vector<double> values;
            LookReader look;
            std::optional<SpaceReader> inSpace; // of a look
        };
        struct Track {
            enum class Of { Cage, Map, Branch, Look, Camera };
            Of of = Of::Cage;
            std::vector<int> maps; // counted from 1: the map, or the address of the branch
            std::vector<Key> keys;
        };
        struct Wave {
            int cycles = 1;
            std::vector<double> values;
        };
        struct Motion {
            std::string kind;
            std::optional<int> count; // turns or cycles
            std::optional<double> strength;
            std::vector<int> maps; // counted from 1
            std::vector<double> pivot, axis;
            std::vector<Wave> waves;
        };
        animation::FrameRate rate;
        int length = 0;
        animation::Loop loop = animation::Loop::Off;
        std::vector<double> reference;
        std::vector<Track> tracks;
        std::vector<Motion> motions;
    };

    static bool isKnown(std::string_view key); // a line of an animation
    static bool begins(std::string_view key);  // its first one

    void read(const std::string& key, const std::vector<std::string>& values);

    const Stored& stored() const { return m_stored; }
    // The first line that was not understood; nullopt when every one was.
    const std::optional<std::string>& mistake() const { return m_mistake; }

private:
    bool understood(const std::string& key, const std::vector<std::string>& values);
    bool readHeader(const std::vector<std::string>& values);
    bool readTrack(const std::vector<std::string>& values);
    bool readKey(const std::string& key, const std::vector<std::string>& values);
    bool readLook(const std::vector<std::string>& values);
    bool readMotion(const std::string& key, const std::vector<std::string>& values);
    bool readValues(const std::vector<std::string>& values);
    Stored::Key* lastKey();

    Stored m_stored;
    enum class Within { Header, Track, Motion } m_within = Within::Header;
    std::size_t m_numbers = 0; // read so far
    std::optional<std::string> m_mistake;
};

} // namespace notation

template <>
inline constexpr auto ifs::names<notation::AnimationLines::Stored::Track::Of> =
    std::to_array<ifs::Named<notation::AnimationLines::Stored::Track::Of>>({
        {notation::AnimationLines::Stored::Track::Of::Cage, "cage"},
        {notation::AnimationLines::Stored::Track::Of::Map, "map"},
        {notation::AnimationLines::Stored::Track::Of::Branch, "branch"},
        {notation::AnimationLines::Stored::Track::Of::Look, "look"},
        {notation::AnimationLines::Stored::Track::Of::Camera, "camera"},
    });
