// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

// Who the program is to the desktop and to the settings.
namespace resources {

QString applicationId();   // reverse DNS; also the base name of the desktop entry and of the application icon
QString applicationName(); // as users read it
QString version();         // "major.minor.patch"

} // namespace resources
