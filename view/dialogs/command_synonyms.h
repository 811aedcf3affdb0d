// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <span>

namespace view {

// Other words for a command: those of other programs, of the result, and everyday ones.
struct CommandSynonyms {
    const char* context; // context and source text of the command, as in the translations
    const char* text;
    const char* words;
};
std::span<const CommandSynonyms> commandSynonyms();

// The words for a command with this name, without its menus, in the user's language and in English; empty
// where there are none.
QString synonymsOf(const QString& name);

// Those of them by which it comes first, even if others have them in their names.
QString firstSynonymsOf(const QString& name);

// A property of an action while the command palette triggers it: the words that were typed.
inline constexpr char searchedWords[] = "searchedWords";

} // namespace view
