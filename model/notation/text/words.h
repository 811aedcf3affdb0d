// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The form of the lines "; barycage: key values". docs/formats.md, "Barycage's comment lines".
namespace notation {

inline constexpr std::string_view linePrefix = "barycage:";
inline constexpr std::size_t maxOwnLine = 69; // bytes

// Without white space at its ends, and with one blank for each other stretch of it.
std::string simplified(std::string_view text);

// What single blanks, or other characters, separate; one empty word of an empty text.
std::vector<std::string> words(std::string_view text, char separator = ' ');
std::string joined(const std::vector<std::string>& words, std::size_t first = 0);

// 0 where it is no whole number.
int wholeNumber(std::string_view text);

std::string ownLine(std::string_view key, std::string_view values);
// The values on as many lines with this key as they need; at least one.
std::vector<std::string> ownLines(std::string_view key, const std::vector<std::string>& values);

// Whether a comment (what follows the semicolon) is one of Barycage's that the entry itself consists of.
// Lines of a fractal transformation and of saved views are not.
bool isOwnComment(std::string_view comment);

// Key and values of such a comment.
std::pair<std::string, std::vector<std::string>> ownWords(std::string_view comment);

void append(std::vector<std::string>& lines, std::vector<std::string> more);

} // namespace notation
