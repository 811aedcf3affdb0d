// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "notation/moments/animation_lines.h"

#include <QByteArrayList>
#include <QStringList>

#include <map>
#include <vector>

namespace io {

// The lines of a shape's animation, each under 70 bytes; none when nothing moves. docs/formats.md,
// "Barycage's comment lines".
template <int Dim> QByteArrayList animationComments(const document::Shape<Dim>& shape);

// Reduces an animation to what survives being written and read when maps get these ids: motions of maps that
// are gone are dropped, as are positions of a cage that is gone.
template <int Dim>
void renumberAnimation(document::Shape<Dim>& shape, const std::map<ifs::MapId, ifs::MapId>& ids);

// Collects the lines of the animations of one entry, then gives the last valid one to its shape.
class AnimationComments {
public:
    // Returns true if the line belongs to an animation that has begun, or begins one. Errors in it come out
    // in applyTo(), for then none of its lines counts. `line` names it in the outcome.
    bool read(const QByteArray& key, const QByteArrayList& values, std::size_t line);

    struct Outcome {
        QStringList sentences;
        std::vector<std::size_t> kept; // lines of animations that are not applied
    };
    // Needs the system and the cage in place.
    template <int Dim> Outcome applyTo(document::Shape<Dim>& shape) const;

    std::vector<std::size_t> lines() const; // lines of all animations

private:
    struct Block {
        notation::AnimationLines lines;
        std::vector<std::size_t> numbers;
    };
    std::vector<Block> m_blocks;
};

} // namespace io
