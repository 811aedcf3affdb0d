// SPDX-License-Identifier: MIT
#pragma once

#include "space/space_navigation.h"

#include <QKeyEvent>

namespace view {

bool isOnKeypad(const QKeyEvent& event);

// The keypad's views, as in modelling programs; with Ctrl from the opposite side. False when the key is none
// of theirs.
bool lookBy(SpaceNavigation& navigation, const QKeyEvent& event);

} // namespace view
