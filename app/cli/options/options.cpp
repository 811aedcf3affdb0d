// SPDX-License-Identifier: MIT
#include "options/options.h"

#include "options/tr.h"
#include "options/usage_error.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cli {

namespace {

std::vector<std::string> betweenCommas(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

// Puts values to the place of an option.
struct Storing {
    const std::string& option;
    const std::vector<std::string>& values;

    void operator()(std::monostate) const {}
    void operator()(bool* place) const { *place = true; }
    void operator()(std::string* place) const { *place = values.front(); }
    void operator()(std::optional<std::string>* place) const { *place = values.front(); }
    void operator()(std::vector<std::string>* place) const { *place = values; }
    void operator()(const ReadValue& read) const { read(option, values.front()); }
};

} // namespace

Option& Option::required() {
    isRequired = true;
    return *this;
}

Option& Option::minimum(std::size_t items) {
    minItems = items;
    return *this;
}

Option& Option::excludes(const std::string& name) {
    excluded.push_back(name);
    return *this;
}

Option& Option::fileName() {
    isFileName = true;
    return *this;
}

Option& Option::orEmpty() {
    mayBeEmpty = true;
    return *this;
}

Option& Option::question() {
    isQuestion = true;
    return *this;
}

Option& Option::moreOf(std::string sentences) {
    more = std::move(sentences);
    return *this;
}

Option& Option::is(unsigned kinds) {
    about |= kinds;
    return *this;
}

Option& Option::completedBy(Completion::Kind kind, std::vector<std::string> words) {
    completion = {kind, std::move(words)};
    return *this;
}

std::string Option::name() const {
    if (!longNames.empty()) return longNames.front();
    return shortNames.empty() ? valueName.substr(0, valueName.find('.')) : shortNames.front();
}

std::vector<std::string> Option::names() const {
    std::vector<std::string> names = shortNames;
    names.insert(names.end(), longNames.begin(), longNames.end());
    return names;
}

bool Option::isArgument() const {
    return longNames.empty() && shortNames.empty();
}

bool Option::isFlag() const {
    return asksForHelp() || std::holds_alternative<bool*>(place);
}

bool Option::asksForHelp() const {
    return std::holds_alternative<std::monostate>(place);
}

bool Option::takesMany() const {
    return std::holds_alternative<std::vector<std::string>*>(place);
}

bool Option::isNamed(const std::string& name) const {
    return std::ranges::find(longNames, name) != longNames.end() ||
           std::ranges::find(shortNames, name) != shortNames.end();
}

void Option::store(const std::vector<std::string>& values) const {
    std::visit(Storing{name(), values}, place);
}

OptionGroup::OptionGroup(Command& command, std::string name) : m_command(command), m_name(std::move(name)) {}

Option& OptionGroup::added(const std::string& names, Option option) const {
    for (const std::string& name : betweenCommas(names)) {
        if (m_command.find(name) || option.isNamed(name))
            throw std::logic_error(m_command.name + " has two options " + name);
        (name.starts_with("--") ? option.longNames : option.shortNames).push_back(name);
    }
    option.group = m_name;
    return m_command.options.emplace_back(std::move(option));
}

Option& OptionGroup::add(const std::string& names, const std::string& valueName, const Value& value,
                         const std::string& description, const std::string& standard) const {
    Option option;
    option.valueName = valueName;
    option.description = description;
    option.standard = standard;
    option.place = value.place;
    option.completion = value.completion;
    return added(names, std::move(option));
}

Option& OptionGroup::flag(const std::string& names, bool* place, const std::string& description) const {
    return add(names, {}, place, description);
}

Option& OptionGroup::argument(const std::string& valueName, const Place& place,
                              const std::string& description) const {
    return add({}, valueName, place, description).fileName();
}

Command::Command(std::string commandName, std::string commandDescription, std::string commandUsage)
    : name(std::move(commandName)),
      description(std::move(commandDescription)),
      usage(std::move(commandUsage)) {
    group(generalOptions).add("-h,--help", {}, Place(), "Print this help message and exit").is(Work);
}

OptionGroup Command::group(const std::string& groupName) {
    return {*this, groupName};
}

Option& Command::option(const std::string& optionName) {
    const auto found =
        std::ranges::find_if(options, [&](const Option& candidate) { return candidate.isNamed(optionName); });
    if (found == options.end()) throw std::logic_error(name + " has no option " + optionName);
    return *found;
}

const Option* Command::find(const std::string& optionName) const {
    const auto found =
        std::ranges::find_if(options, [&](const Option& candidate) { return candidate.isNamed(optionName); });
    return found == options.end() ? nullptr : &*found;
}

bool Given::has(const std::string& name) const {
    return std::ranges::any_of(m_options, [&](const Option* option) { return option->isNamed(name); });
}

void Given::refuse(unsigned about, const QString& reason) const {
    for (const Option* option : m_options)
        refuseIf((option->about & about) != 0, option->name().c_str(), reason);
}

void Given::refuse(const std::vector<std::string>& names, const QString& reason) const {
    for (const std::string& name : names)
        refuseIf(has(name), name.c_str(), reason);
}

void refuseIf(bool given, const char* option, const QString& reason) {
    if (given) throw UsageError{tr("%1 cannot be used here: %2").arg(QLatin1String(option), reason)};
}

Program::Program(std::string programDescription, std::vector<Command> programCommands)
    : description(std::move(programDescription)), commands(std::move(programCommands)) {
    for (const Command& command : commands) {
        if (find(command.name) != &command) throw std::logic_error("two commands " + command.name);
        for (const Option& option : command.options)
            for (const std::string& other : option.excluded)
                if (!command.find(other)) throw std::logic_error(command.name + " has no option " + other);
    }
}

const Command* Program::find(const std::string& commandName) const {
    const auto found = std::ranges::find(commands, commandName, &Command::name);
    return found == commands.end() ? nullptr : &*found;
}

} // namespace cli
