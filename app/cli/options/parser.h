// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.h"

#include <QStringList>

#include <string>
#include <vector>

// Parses the command line by the options that the commands declare.
namespace cli {

enum class Question { None, Help, Version };

struct Call {
    const Command* command = nullptr; // null if the question is about the whole program
    Question question = Question::None;
};

// Fills the places of the command in, once all words make sense; a complaint names them as typed. An unknown
// option is named before anything else is complained about. Throws UsageError.
Call parse(const Program& program, const std::vector<std::string>& words);

// "a, b or c".
QString listed(QStringList words, const QString& last);
QString listed(const std::vector<std::string>& words, const QString& last);

// The candidate that was probably meant: one that begins like the word, or else differs from it in few
// letters. Empty when there is none.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

} // namespace cli
