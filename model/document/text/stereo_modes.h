// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/stereo.h"

#include <span>

// Stereo as menus and lists of the window offer it. Texts are translated by Text::tr().
namespace document {

struct StereoMode {
    attractor::Stereo value;
    const char* title;          // in a list
    const char* command;        // id of its command, which switches it on or off; null: it has none
    const char* item = nullptr; // of the command in the menu
    const char* tip = nullptr;  // of the command
};

std::span<const StereoMode> stereoModes(); // in the order of menus and lists

} // namespace document
