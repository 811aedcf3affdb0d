// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QIODevice>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace io {

struct PngFormat {
    enum class Pixels { Opaque, Transparent, Grey }; // Grey: one channel, of numbers rather than light
    enum class Depth { Bits8, Bits16 };              // a channel

    int width = 0;
    int height = 0;
    Pixels pixels = Pixels::Opaque; // Opaque drops the alpha channel
    Depth depth = Depth::Bits8;
    std::optional<double> dotsPerInch;
    QByteArray systemText; // UTF-8, embedded for readPngSystem(); empty: nothing
    // Further texts, Latin-1: keyword (1 to 79 characters) and value.
    std::vector<std::pair<QByteArray, QByteArray>> texts{};
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
    // Into a picture of Pixels::Grey with 16 bits.
    Failure writeRows(std::span<const std::uint16_t> values);
    Failure finish(); // after the last row

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
