// SPDX-License-Identifier: MIT
#pragma once

#include "io/text/literal_lists.h"

namespace io {

// The lists and keys of YAML whose levels are given by indentation, as those of brackets: "- " begins an
// item, "key:" names what follows. What stands in brackets or behind a key is read as literalsIn() does.
// Without such a line there is none.
Literals yamlLiterals(const QString& text);

} // namespace io
