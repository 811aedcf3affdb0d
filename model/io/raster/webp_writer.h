// SPDX-License-Identifier: MIT
#pragma once

#include "io/raster/library_device.h"
#include "io/raster/picture_writer.h"

namespace io {

// WebP of 8 bits per channel, without loss unless the format names a quality; at most 16,383 pixels along a
// side. The whole picture is in memory until finish(). The system is in an XMP packet, in an element `system`
// of xmpSystemNamespace().
class WebPWriter final : public PictureWriter {
public:
    // The device is open for writing and outlives the writer.
    WebPWriter(QIODevice& device, PictureFormat format);

    Failure writeRows(std::span<const std::uint32_t> pixels) override;
    Failure writeRows(std::span<const attractor::Rgba16> pixels) override; // must not be called
    Failure finish() override;

private:
    void fail(const QString& reason);

    LibraryDevice m_device;
    PictureFormat m_format;
    std::vector<std::uint8_t> m_bytes; // bytes of the rows so far
    Failure m_failure;
};

// The XMP packet that holds the system.
QByteArray xmpPacket(const QByteArray& system);

} // namespace io
