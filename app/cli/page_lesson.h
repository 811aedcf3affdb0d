// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"
#include "process/input.h"

#include "io/page/page_export.h"

#include <string>

namespace cli {

// Gives the page the steps of a lesson and the entries of the collection that they show. What a page cannot
// show is reported; without a step afterwards, nothing could be read.
ExitStatus addLesson(io::PageExport& page, const std::string& file, const Input& collection);

} // namespace cli
