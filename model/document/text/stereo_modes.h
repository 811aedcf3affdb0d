// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/stereo.h"

#include <span>

// Stereo as menus and lists of the window offer it. Texts are translated by Text::tr().
namespace document {

struct StereoMode {
    attractor::Stereo value;
    const char* title;          // title in a list
    const char* command;        // id of the command that switches it on or off; null: none
    const char* item = nullptr; // text of the command in the menu
    const char* tip = nullptr;  // tip of the command
};

std::span<const StereoMode> stereoModes(); // in the order of menus and lists

} // namespace document
