// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QVariant>

#include <span>

namespace view {

// Returns true if unrequested motion is replaced by a still picture: as the user prefers, else as the desktop
// says, else as the style does, which has no animations of its own then.
bool reducesMotion();

// The settings of desktops that say it.
struct MotionSetting {
    const char* group;
    const char* key;
    bool isReducedBy; // value as true or false
};
std::span<const MotionSetting> motionSettings();

// The desktop's value of one of its settings; of any other setting, nothing happens.
void takeDesktopSetting(const QString& group, const QString& key, const QVariant& value);

} // namespace view
