// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/pixel_version.h"
#include "document/fractal/fractal.h"

#include <QByteArray>

#include <cstdint>
#include <optional>

namespace io {

// Text of everything that the bytes of a frame depend on, in lines "name value" in a fixed order; an option
// that is not given is absent. It begins with the version of the pixels and ends with the entry.
class FrameRequestText {
public:
    explicit FrameRequestText(int pixels = attractor::pixelVersion);
    void add(const char* name, const QByteArray& value);
    void addCount(const char* name, std::uint64_t value);

    // SHA-256, in hexadecimal digits.
    QByteArray hash(const document::Fractal& entry) const;

    // Must be called first. nullopt, for the text shared by all frames of an animation, adds nothing.
    void addFrame(std::optional<int> frame);

private:
    QByteArray m_text;
};

// Hashes of two such texts: of the frame, and of the part shared by all frames of its animation.
struct FrameHashes {
    QByteArray frame;
    QByteArray animation;
};

} // namespace io
