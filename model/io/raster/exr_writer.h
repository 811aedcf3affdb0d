// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/library_device.h"
#include "io/raster/picture_writer.h"

#include <memory>

namespace io {

// OpenEXR: linear light of the Rec. 709 primaries, colours multiplied by alpha as the format asks for, in
// floating point of 16 or 32 bits, compressed without loss (ZIP). Takes rows of 16 bits per channel. The
// system is in an attribute of its own.
class ExrWriter final : public PictureWriter {
public:
    // The device is open for writing, can seek, and outlives the writer; `file` is ExrHalf or ExrFloat.
    ExrWriter(QIODevice& device, PictureFile file, const PictureFormat& format);
    ~ExrWriter() override;

    Failure writeRows(std::span<const std::uint32_t> pixels) override; // must not be called
    Failure writeRows(std::span<const attractor::Rgba16> pixels) override;
    Failure finish() override;

private:
    struct State;
    void fail();

    LibraryDevice m_device;
    std::unique_ptr<State> m_state;
    Failure m_failure;
};

} // namespace io
