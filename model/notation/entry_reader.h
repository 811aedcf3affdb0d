// SPDX-License-Identifier: MIT
#pragma once

#include "notation/value/entry.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace notation {

struct File {
    std::vector<Entry> entries; // unreadable entries have no figure and a flaw
    std::optional<Flaw> flaw;   // set for a text without entries or with too many
};

// Reads a Fractint .ifs collection (docs/formats.md) as the window does: by the same scanner, rows and
// expressions. `bareName` is what the entry of a file of bare rows is called. Never fails.
File readFile(std::string_view text, std::string_view bareName = "unnamed");

constexpr std::size_t maxEntries = 200'000; // per file

} // namespace notation
