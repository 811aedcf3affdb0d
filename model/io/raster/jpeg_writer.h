// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/picture_writer.h"

#include <QIODevice>

#include <memory>

namespace io {

// JPEG of 8 bits per channel, with colours at full resolution: opaque, at most 65,500 pixels along a side.
// The system is in comments of at most 64 KB each, one after the other.
class JpegWriter final : public PictureWriter {
public:
    // The device is open for writing and outlives the writer.
    JpegWriter(QIODevice& device, const PictureFormat& format);
    ~JpegWriter() override;

    Failure writeRows(std::span<const std::uint32_t> pixels) override;
    Failure writeRows(std::span<const attractor::Rgba16> pixels) override; // must not be called
    Failure finish() override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace io
