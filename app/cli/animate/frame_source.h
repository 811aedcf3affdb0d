// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"
#include "render/shown_frame.h"

#include "io/animation/frame_drawing.h"

#include <QString>

#include <optional>

namespace cli {

// The frames of an entry as options ask for them. What makes no sense throws UsageError.
class FrameSource : public io::FrameSource {
public:
    enum class Output { Pictures, Video };
    // `name` stands for the pictures in messages.
    FrameSource(const document::Fractal& entry, const RenderArguments& options, const QString& name,
                Output output);

    const document::Fractal& entry() const override { return m_entry; }
    io::PlaneExport planeAt(const animation::Moment& moment) const override;
    io::SpaceExport spaceAt(const animation::Moment& moment) const override;

private:
    const RenderArguments& m_options;
    const document::Fractal& m_entry;
    QString m_name;
    Output m_output;
    Frames m_frames;
    mutable std::optional<attractor::Camera> m_camera; // shared by all frames; empty until it is known
};

io::FrameOptions frameOptions(const RenderArguments& options); // --shutter and --exposure

} // namespace cli
