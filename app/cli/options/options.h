// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// The tables of the command line: what each command takes, what the help says of it, and where the values go.
// What was typed is held by the parser until all of it makes sense; the tables do not change.
namespace cli {

// Where the values of an option go. To nothing: it asks for the help. A bool: it is a flag and takes no
// value. A list: the option may be repeated, and an argument takes all words that are left.
using Place =
    std::variant<std::monostate, bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*>;

// Or an argument, which has no name and is known by its place.
struct Option {
    std::vector<std::string> longNames, shortNames; // with their dashes
    std::string valueName;                          // stands for the value in the help and in messages
    std::string description;
    std::string standard; // that is taken where the option is not given, as the help has it; may be empty
    std::string group;    // heading in the help
    Place place;
    std::size_t minItems = 1;          // of an argument
    std::vector<std::string> excluded; // names of options that cannot be used together with this one
    bool isRequired = false;
    bool isFileName = false; // whose bytes need not be UTF-8
    bool mayBeEmpty = false;
    bool isQuestion = false; // answered instead of the command's work, for which nothing is then required

    Option& required();
    Option& minimum(std::size_t items);
    Option& excludes(const std::string& name);
    Option& fileName();
    Option& orEmpty();
    Option& question();

    bool isArgument() const;
    bool isFlag() const; // takes no value
    bool asksForHelp() const;
    bool takesMany() const;
    bool isNamed(const std::string& name) const; // with its dashes

    // At least one value, as typed; of a flag any.
    void store(const std::vector<std::string>& values) const;
};

struct Command;

// Adds options under one heading of the help.
class OptionGroup {
public:
    OptionGroup(Command& command, std::string name);

    // Names between commas, such as "-j,--threads". The reference holds as long as the command is not moved.
    Option& add(const std::string& names, const std::string& valueName, const Place& place,
                const std::string& description, const std::string& standard = {}) const;
    Option& flag(const std::string& names, bool* place, const std::string& description) const;
    Option& argument(const std::string& valueName, const Place& place, const std::string& description) const;

private:
    Option& added(const std::string& names, Option option) const;

    Command& m_command;
    std::string m_name;
};

constexpr auto generalOptions = "Options"; // the heading of what every command has; the last in the help

struct Command {
    // The usage names the command. It has --help from the beginning.
    Command(std::string name, std::string description, std::string usage);

    OptionGroup group(const std::string& name);
    Option& option(const std::string& name); // std::logic_error where there is none
    const Option* find(const std::string& name) const;

    std::string name, description, usage;
    std::deque<Option> options;
    std::function<ExitStatus()> run; // once the places are filled in
};

struct Program {
    // std::logic_error where two commands have one name, or an option excludes one that is not there.
    Program(std::string description, std::vector<Command> commands);

    const Command* find(const std::string& name) const;

    std::string description;
    std::vector<Command> commands;
};

} // namespace cli
