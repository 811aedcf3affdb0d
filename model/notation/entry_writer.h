// SPDX-License-Identifier: MIT
#pragma once

#include "notation/value/entry.h"

#include <string>

namespace notation {

// One entry in the strict form that every reader takes, as the window writes a new one; its lines end with
// "\n". An entry without a figure has no rows.
std::string written(const Entry& entry);

} // namespace notation
