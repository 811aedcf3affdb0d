// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

// Puts what was typed to the options that the commands declare.
namespace cli {

enum class Question { None, Help, Version };

struct Call {
    CLI::App* command = nullptr; // none: the question is about the program
    Question question = Question::None;
};

// CLI11 stores the values; what the words mean is decided here, so that a complaint names them as typed. An
// unknown option is named before anything else is complained about. Throws UsageError.
Call parse(CLI::App& program, const std::vector<std::string>& words);

// Of the candidates the one that was probably meant: one that begins like the word, or else differs from it
// in few letters. Empty when there is none.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

} // namespace cli
