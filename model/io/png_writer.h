// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tone_map16.h"
#include "io/save_file.h"

#include <QByteArray>
#include <QIODevice>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace io {

struct PngFormat {
    enum class Pixels { Opaque, Transparent };
    enum class Depth { Bits8, Bits16 }; // a channel

    int width = 0;
    int height = 0;
    Pixels pixels = Pixels::Opaque; // Opaque drops the alpha channel
    Depth depth = Depth::Bits8;
    std::optional<double> dotsPerInch;
    QByteArray systemText; // UTF-8, embedded for readPngSystem(); empty: nothing
};

// Writes an sRGB picture row by row, so that only the rows at hand need memory. Any failure is
// remembered and makes the calls that follow return it at once.
class PngWriter {
public:
    // The device is open for writing and outlives the writer.
    PngWriter(QIODevice& device, const PngFormat& format);
    ~PngWriter();

    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    // Whole rows from the top on, 0xAARRGGBB premultiplied, into a picture of 8 bits a channel …
    Failure writeRows(std::span<const std::uint32_t> pixels);
    // … or of 16.
    Failure writeRows(std::span<const attractor::Rgba16> pixels);
    Failure finish(); // after the last row

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
