// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/settings.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>

#include <chrono>

namespace support {

// Settings and folders under the name of the test program, away from the user's. The settings are empty once
// what was still being stored has been, except that pictures at rest are refined to 20 million samples
// instead of 200: what refines them is taken from the test.
inline void useOwnSettings() {
    if (!view::finishStoring(std::chrono::minutes(1))) qFatal("settings are not stored");
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Barycage"));
    QSettings settings;
    settings.clear();
    settings.setValue(QStringLiteral("preferences/quality"), 20'000'000);
}

} // namespace support
