// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"
#include "io/text/symmetry_text.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

// The options of `convert` that give entries a symmetry, and that list the maps one stands for.
namespace cli {

struct SymmetryArguments {
    std::optional<std::string> symmetry;
    bool expand = false;
};

void addSymmetryOptions(CLI::App& command, SymmetryArguments& arguments);

struct SymmetryChange {
    std::optional<io::NamedSymmetry> symmetry;
    bool expand = false;

    bool isWanted() const { return symmetry || expand; }
};
SymmetryChange symmetryChange(const SymmetryArguments& arguments); // throws UsageError

// The entry with the symmetry, and then as plain maps; or why it cannot have it.
std::optional<QString> changeSymmetry(document::Entry& entry, const SymmetryChange& change);
std::optional<QString> expandSymmetry(document::Entry& entry, const SymmetryChange& change);

} // namespace cli
