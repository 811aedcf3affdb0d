// SPDX-License-Identifier: MIT
#include "help.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace cli {

namespace {

constexpr std::size_t lineLength = 80;
constexpr std::size_t column = 26; // where descriptions begin
constexpr char unbroken = '\x1f';  // a blank at which no line ends

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

std::string nameOf(const CLI::Option& option) {
    if (option.get_positional()) return option.get_type_name();
    std::string names;
    for (const std::string& name : option.get_snames())
        names += "-" + name + ", ";
    for (const std::string& name : option.get_lnames())
        names += "--" + name + ", ";
    names.resize(names.size() - 2);
    return option.get_items_expected_max() == 0 ? names : names + ' ' + option.get_type_name();
}

std::string descriptionOf(const CLI::Option& option) {
    std::string standard = option.get_default_str();
    if (standard.empty()) return option.get_description();
    standard = "[default: " + standard + "]";
    if (standard.size() <= lineLength - column) std::ranges::replace(standard, ' ', unbroken);
    return option.get_description() + ' ' + standard;
}

std::string programHelp(const CLI::App& program) {
    std::string text =
        program.get_description() + "\n\nUsage: barycage-cli COMMAND FILE... [OPTION]...\n\nCommands:\n";
    for (const CLI::App* command : program.get_subcommands({}))
        addRow(text, command->get_name(), command->get_description());
    addRow(text, "help COMMAND", "Show the options of a command, as COMMAND --help does");
    text += "\nOptions:\n";
    addRow(text, "-h, --help", "Show this help");
    addRow(text, "-V, --version", "Show the version");
    return text + "\nThe manual page, man barycage-cli, has the details and examples.\n";
}

} // namespace

std::string helpText(const CLI::App& program, const CLI::App* command) {
    if (!command) return programHelp(program);
    std::string text = command->get_description() + "\n\nUsage: barycage-cli " + command->get_footer() + "\n";
    std::vector<std::string> groups;
    for (const CLI::Option* option : command->get_options())
        if (std::ranges::find(groups, option->get_group()) == groups.end())
            groups.push_back(option->get_group());
    const auto isGeneral = [](const std::string& group) { return group == "Options"; };
    std::stable_partition(groups.begin(), groups.end(),
                          [&](const std::string& group) { return !isGeneral(group); });
    for (const std::string& group : groups) {
        text += '\n' + group + ":\n";
        for (const CLI::Option* option : command->get_options())
            if (option->get_group() == group) addRow(text, nameOf(*option), descriptionOf(*option));
    }
    return text;
}

} // namespace cli
