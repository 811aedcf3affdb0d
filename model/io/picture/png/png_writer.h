// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/picture_writer.h"

#include <QIODevice>

#include <memory>

namespace io {

// Writes an sRGB picture; only the rows at hand need memory.
class PngWriter final : public PictureWriter {
public:
    // The device is open for writing and outlives the writer.
    PngWriter(QIODevice& device, const PictureFormat& format);
    ~PngWriter() override;

    Failure writeRows(std::span<const std::uint32_t> pixels) override;
    Failure writeRows(std::span<const attractor::Rgba16> pixels) override;
    // Writes rows of a picture of Pixels::Grey with 16 bits.
    Failure writeRows(std::span<const std::uint16_t> values);
    Failure finish() override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
