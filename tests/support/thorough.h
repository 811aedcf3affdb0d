// SPDX-License-Identifier: MIT
#pragma once

#include <QtGlobal>

namespace support {

/// Whether what takes long is tested, too: BARYCAGE_ALL in the environment, which `./dev test --all` sets.
/// Without, a test takes a fair sample of its cases.
inline bool isThorough() {
    return qEnvironmentVariableIsSet("BARYCAGE_ALL");
}

} // namespace support
