// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QStandardPaths>

namespace support {

// Settings and folders under the name of the test program, away from the user's; the settings empty.
inline void useOwnSettings() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Barycage"));
    QSettings().clear();
}

} // namespace support
