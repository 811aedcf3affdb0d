// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "ifs/names.h"
#include "io/fractint/appearance_comments.h"
#include "io/fractint/space_comments.h"

#include <QByteArray>
#include <QByteArrayList>

#include <array>
#include <optional>
#include <vector>

namespace io {

// The lines of one animation, in whatever dimension: names, counts and numbers, not yet interpreted.
class AnimationLines {
public:
    struct Stored {
        struct Key {
            int frame = 0;
            animation::Ease ease;
            std::vector<double> handles;
            std::vector<double> values;
            AppearanceComments look;
            std::optional<SpaceComments> inSpace; // appearance keys only
        };
        struct Track {
            enum class Of { Cage, Map, Branch, Look, Camera };
            Of of = Of::Cage;
            std::vector<int> maps; // 1-based: the map, or the address of the branch
            std::vector<Key> keys;
        };
        struct Wave {
            int cycles = 1;
            std::vector<double> values;
        };
        struct Motion {
            QByteArray kind;
            std::optional<int> count; // turns or cycles
            std::optional<double> strength;
            std::vector<int> maps; // 1-based
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

    static bool isKnown(const QByteArray& key); // true for keys of an animation's lines
    static bool begins(const QByteArray& key);  // true for the key of its first line

    void read(const QByteArray& key, const QByteArrayList& values);

    const Stored& stored() const { return m_stored; }
    // The first line that was not understood; nullopt when every one was.
    const std::optional<QByteArray>& mistake() const { return m_mistake; }

private:
    bool understood(const QByteArray& key, const QByteArrayList& values);
    bool readHeader(const QByteArrayList& values);
    bool readTrack(const QByteArrayList& values);
    bool readKey(const QByteArray& key, const QByteArrayList& values);
    bool readLook(const QByteArrayList& values);
    bool readMotion(const QByteArray& key, const QByteArrayList& values);
    bool readValues(const QByteArrayList& values);
    Stored::Key* lastKey();

    Stored m_stored;
    enum class Within { Header, Track, Motion } m_within = Within::Header;
    std::size_t m_numbers = 0; // number read so far
    std::optional<QByteArray> m_mistake;
};

// Names of the tracks in the lines.

} // namespace io

template <>
inline constexpr auto ifs::names<io::AnimationLines::Stored::Track::Of> =
    std::to_array<ifs::Named<io::AnimationLines::Stored::Track::Of>>({
        {io::AnimationLines::Stored::Track::Of::Cage, "cage"},
        {io::AnimationLines::Stored::Track::Of::Map, "map"},
        {io::AnimationLines::Stored::Track::Of::Branch, "branch"},
        {io::AnimationLines::Stored::Track::Of::Look, "look"},
        {io::AnimationLines::Stored::Track::Of::Camera, "camera"},
    });
