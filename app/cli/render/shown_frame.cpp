// SPDX-License-Identifier: MIT
#include "render/shown_frame.h"

#include "options/tr.h"
#include "options/usage_error.h"

namespace cli {

QString frameObstacle(const document::Fractal& entry, const animation::Moment& moment) {
    const auto facts = document::animationFacts(entry);
    if (!facts) return {};
    const int last = animation::lastFrame(facts->loop, facts->length);
    if (!animation::isAfter(moment, last)) return {};
    return tr("“%1” has the frames 0 to %2; --frame is after the last one.")
        .arg(entry.name, QString::number(last));
}

Frames::Frames(const document::Fractal& entry, const RenderArguments& arguments)
    : m_arguments(arguments), m_entry(entry) {
    if (document::plane(entry)) applyAppearance(m_entry.appearance, arguments);
    if (arguments.overlay.cage) m_lasting = document::lastingCage(entry);
    if (!document::animationFacts(entry) || arguments.view || io::hasCameraKeys(entry)) return;
    if (document::plane(entry))
        m_common.box =
            io::boxOfFrames(m_entry, arguments.yDown ? attractor::YAxis::Down : attractor::YAxis::Up);
    else
        m_common.support = io::supportOfFrames(entry);
}

Shown Frames::at(const animation::Moment& moment) const {
    if (const QString obstacle = frameObstacle(m_entry, moment); !obstacle.isEmpty())
        throw UsageError{obstacle};
    const document::AnimatedFrame frame = document::frameAt(m_entry, moment);
    Shown shown = m_common;
    shown.entry = m_entry;
    shown.fractal = frame.fractal;
    shown.fractal.lasting = m_lasting;
    shown.view = frame.view;
    shown.camera = frame.camera;
    shown.orbit = frame.orbit;
    // Options override keys.
    if (document::plane(m_entry)) applyAppearance(shown.fractal.appearance, m_arguments);
    return shown;
}

Shown shownBy(const document::Fractal& entry, const RenderArguments& arguments) {
    if (arguments.frame) return Frames(entry, arguments).at(*arguments.frame);
    Shown shown{entry, entry};
    if (document::plane(entry)) applyAppearance(shown.fractal.appearance, arguments);
    return shown;
}

} // namespace cli
