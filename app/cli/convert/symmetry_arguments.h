// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "io/text/symmetry_text.h"

#include <optional>
#include <string>

// The options of `convert` that give entries a symmetry, and that list the maps one and linked maps stand
// for.
namespace cli {

struct Command;

struct SymmetryArguments {
    std::optional<io::NamedSymmetry> symmetry;
    bool expand = false;

    bool isWanted() const { return symmetry || expand; }
};

void addSymmetryOptions(Command& command, SymmetryArguments& arguments);

// The entry with the symmetry; or why it cannot have it.
std::optional<QString> changeSymmetry(document::Entry& entry, const SymmetryArguments& change);

struct Expansion {
    std::optional<QString> obstacle; // reason why the entry cannot be written
    std::optional<QString> warning;
};
// The entry as plain maps, without a symmetry and without links.
Expansion expanded(document::Entry& entry, const SymmetryArguments& change);

} // namespace cli
