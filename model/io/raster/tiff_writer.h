// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/picture_writer.h"

#include <QIODevice>

#include <memory>

namespace io {

// TIFF of 8 or 16 bits per channel, compressed without loss (Deflate); BigTIFF from 3 GB of pixels on. The
// system is in ImageDescription.
class TiffWriter final : public PictureWriter {
public:
    // The device is open for writing, can seek, and outlives the writer.
    TiffWriter(QIODevice& device, const PictureFormat& format);
    ~TiffWriter() override;

    Failure writeRows(std::span<const std::uint32_t> pixels) override;
    Failure writeRows(std::span<const attractor::Rgba16> pixels) override;
    Failure finish() override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
