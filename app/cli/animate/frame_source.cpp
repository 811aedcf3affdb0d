// SPDX-License-Identifier: MIT
#include "animate/frame_source.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "render/render_plane.h"
#include "render/render_space.h"

namespace cli {

namespace {

bool showsNumbers(const io::SpaceExport& picture) {
    return picture.look == attractor::LookInSpace::Depth || picture.look == attractor::LookInSpace::Normals;
}

} // namespace

FrameSource::FrameSource(const document::Fractal& entry, const RenderArguments& options, const QString& name,
                         Output output)
    : m_options(options), m_entry(entry), m_name(name), m_output(output), m_frames(entry, options) {}

io::PlaneExport FrameSource::planeAt(const animation::Moment& moment) const {
    const Shown shown = m_frames.at(moment);
    if (!m_camera || shown.view) m_camera = cameraOf(shown, m_options, m_name);
    io::PlaneExport picture = planeExportOf(shown, *m_camera, m_options, 0);
    picture.fractal = m_entry;
    return picture;
}

io::SpaceExport FrameSource::spaceAt(const animation::Moment& moment) const {
    io::SpaceExport picture = spaceExportOf(m_frames.at(moment), m_options, m_name);
    if (frameOptions(m_options).shutter > 0 && showsNumbers(picture))
        throw UsageError{tr(
            "--shutter cannot be used here: depths and normals are data, which do not add up like light.")};
    if (m_output == Output::Video && picture.look == attractor::LookInSpace::Depth)
        throw UsageError{tr("--look depth cannot be used here: depths are 16-bit data, which a video cannot "
                            "store. Write the frames as NAME.####.png.")};
    picture.fractal = m_entry;
    return picture;
}

io::FrameOptions frameOptions(const RenderArguments& options) {
    return {options.shutter, options.exposure};
}

} // namespace cli
