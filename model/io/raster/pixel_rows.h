// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"

#include <QRgb>

#include <cstdint>

namespace io {

// Converts a row of 0xAARRGGBB, premultiplied, to bytes red, green, blue and, if asked for, alpha, not
// premultiplied.
inline void putBytes(const std::uint32_t* pixels, int width, bool withAlpha, std::uint8_t* to) {
    for (int x = 0; x < width; ++x) {
        const QRgb colour = qUnpremultiply(pixels[x]);
        *to++ = std::uint8_t(qRed(colour));
        *to++ = std::uint8_t(qGreen(colour));
        *to++ = std::uint8_t(qBlue(colour));
        if (withAlpha) *to++ = std::uint8_t(qAlpha(colour));
    }
}

// The same with 16 bits, in the order of bytes of this machine.
inline void putWords(const attractor::Rgba16* pixels, int width, bool withAlpha, std::uint16_t* to) {
    for (int x = 0; x < width; ++x) {
        *to++ = pixels[x].red;
        *to++ = pixels[x].green;
        *to++ = pixels[x].blue;
        if (withAlpha) *to++ = pixels[x].alpha;
    }
}

} // namespace io
