// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"
#include "io/table/table_reader.h"

namespace io {

// The rows as a system, numbered from 1.
ifs::IteratedFunctionSystem<2> systemOf(const Table& table);
ifs::IteratedFunctionSystem<3> spaceSystemOf(const Table& table);

} // namespace io
