// SPDX-License-Identifier: MIT
#include "document/text/stereo_modes.h"

#include <QtGlobal>

namespace document {

namespace {

constexpr StereoMode modes[]{
    {attractor::Stereo::None, QT_TRANSLATE_NOOP("Text", "One picture"), nullptr},
    {attractor::Stereo::SideBySide, QT_TRANSLATE_NOOP("Text", "Both eyes, side by side"),
     "stereo-side-by-side", QT_TRANSLATE_NOOP("Text", "Stereo, &Side by Side"),
     QT_TRANSLATE_NOOP("Text", "Show the views of both eyes side by side, the left eye on the left")},
    {attractor::Stereo::Anaglyph, QT_TRANSLATE_NOOP("Text", "Red and cyan glasses"), "stereo-red-cyan",
     QT_TRANSLATE_NOOP("Text", "Stereo, for Red and &Cyan Glasses"),
     QT_TRANSLATE_NOOP("Text", "Show the views of both eyes in one picture, in red and cyan")},
};

} // namespace

std::span<const StereoMode> stereoModes() {
    return modes;
}

} // namespace document
