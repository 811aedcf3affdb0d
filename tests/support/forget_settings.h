// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/settings.h"

#include <QSettings>

namespace support {

// As at the first start; nothing that is still being stored comes after.
inline void forgetSettings() {
    view::finishStoring();
    QSettings().clear();
}

} // namespace support
