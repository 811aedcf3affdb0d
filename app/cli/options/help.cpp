// SPDX-License-Identifier: MIT
#include "options/help.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace cli {

namespace {

constexpr std::size_t lineLength = 80;
constexpr std::size_t column = 26; // first column of the descriptions
constexpr char unbroken = '\x1f';  // blank at which no line is broken

// The name, and behind it the description in lines of its own column.
void addRow(std::string& text, const std::string& name, const std::string& description) {
    std::string line = "  " + name;
    if (line.size() + 2 > column) {
        text += line + '\n';
        line.clear();
    }
    line.resize(column, ' ');
    std::istringstream words(description);
    for (std::string word; words >> word;) {
        std::ranges::replace(word, unbroken, ' ');
        const bool isFirst = line.find_first_not_of(' ') == std::string::npos || line.back() == ' ';
        if (!isFirst && line.size() + 1 + word.size() > lineLength) {
            text += line + '\n';
            line.assign(column, ' ');
            line += word;
        } else {
            line += (isFirst ? "" : " ") + word;
        }
    }
    text += line + '\n';
}

std::string nameOf(const Option& option) {
    if (option.isArgument()) return option.valueName;
    std::string names;
    for (const std::string& name : option.names())
        names += (names.empty() ? "" : ", ") + name;
    return option.isFlag() ? names : names + ' ' + option.valueName;
}

std::string descriptionOf(const Option& option) {
    if (option.standard.empty()) return option.description;
    std::string standard = "[default: " + option.standard + "]";
    if (standard.size() <= lineLength - column) std::ranges::replace(standard, ' ', unbroken);
    return option.description + ' ' + standard;
}

std::string programHelp(const Program& program) {
    std::string text =
        program.description + "\n\nUsage: barycage-cli COMMAND FILE... [OPTION]...\n\nCommands:\n";
    for (const Command& command : program.commands)
        addRow(text, command.name, command.description);
    addRow(text, "help COMMAND", "Show the options of a command, as COMMAND --help does");
    text += "\nOptions:\n";
    addRow(text, "-h, --help", "Show this help");
    addRow(text, "-V, --version", "Show the version");
    return text + "\nThe manual page, man barycage-cli, has the details and examples.\n";
}

} // namespace

std::string helpText(const Program& program, const Command* command) {
    if (!command) return programHelp(program);
    std::string text = command->description + "\n\nUsage: barycage-cli " + command->usage + "\n";
    std::vector<std::string> groups;
    for (const Option& option : command->options)
        if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
    std::stable_partition(groups.begin(), groups.end(),
                          [](const std::string& group) { return group != generalOptions; });
    for (const std::string& group : groups) {
        text += '\n' + group + ":\n";
        for (const Option& option : command->options)
            if (option.group == group) addRow(text, nameOf(option), descriptionOf(option));
    }
    return text;
}

} // namespace cli
