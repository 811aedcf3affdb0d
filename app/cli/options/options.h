// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

class QString;

// The tables of the command line: what each command takes, what the help says of it, and where the values go.
// What was typed is held by the parser until all of it makes sense; the tables do not change.
namespace cli {

// Reads a value and stores it. Throws UsageError with a sentence that names the option.
using ReadValue = std::function<void(const std::string& option, const std::string& text)>;

// Destination of the values of an option. Nothing: it asks for the help. A bool: it is a flag and takes no
// value. A list: the option may be repeated, and an argument takes all words that are left. A function: it is
// called for each value.
using Place = std::variant<std::monostate, bool*, std::string*, std::optional<std::string>*,
                           std::vector<std::string>*, ReadValue>;

// Completion of the value of an option in a shell.
struct Completion {
    enum class Kind { Nothing, Words, Entries, Palettes, Files };
    Kind kind = Kind::Nothing;
    std::vector<std::string> words; // words, or suffixes of files without a dot; none: all files
};

// The place of a value, and what completes it.
struct Value {
    Value(Place where) : place(std::move(where)) {}
    template <class T> Value(T* where) : place(where) {}

    Place place;
    Completion completion;
};

// A value that `read` makes from the name of the option and the typed text.
template <class T, class Read> Value parsed(T* place, Read read) {
    return Place(ReadValue(
        [place, read](const std::string& option, const std::string& text) { *place = read(option, text); }));
}

// Aspects of a picture that an option refers to: combinations that make no sense are refused by these.
enum About : unsigned {
    Tone = 1,      // the tone curve of a density
    Samples = 2,   // number of samples
    Colours = 4,   // palette, and the quantity it shows
    Cells = 8,     // supersampling
    Rows = 16,     // rows of pixels in a file
    Light = 32,    // light on a solid
    InPlane = 64,  // options for entries in the plane only
    InSpace = 128, // options for entries in space only
    Picture = 256, // settings shared by all parts of a picture
    Work = 512,    // settings that never change a pixel, such as threads and names of files
};

// Or an argument, which has no name and is known by its place.
struct Option {
    std::vector<std::string> longNames, shortNames; // including their dashes
    std::string valueName;                          // placeholder of the value in the help and in messages
    std::string description;
    std::string standard; // default value as the help shows it; may be empty
    std::string more;     // further sentences for the manual page
    std::string group;    // heading in the help
    Place place;
    Completion completion;
    unsigned about = 0;                // bits of About
    std::size_t minItems = 1;          // least number of values of an argument
    std::vector<std::string> excluded; // names of options that cannot be used together with this one
    bool isRequired = false;
    bool isFileName = false; // bytes need not be UTF-8
    bool mayBeEmpty = false;
    bool isQuestion = false; // answered instead of the command's work, so that no argument is required

    Option& required();
    Option& minimum(std::size_t items);
    Option& excludes(const std::string& name);
    Option& fileName();
    Option& orEmpty();
    Option& question();
    Option& moreOf(std::string sentences);
    Option& is(unsigned about);
    Option& completedBy(Completion::Kind kind, std::vector<std::string> words = {});

    // The name in messages: the first long name, or for an argument its value name.
    std::string name() const;
    std::vector<std::string> names() const; // including dashes, short names first
    bool isArgument() const;
    bool isFlag() const; // true if the option takes no value
    bool asksForHelp() const;
    bool takesMany() const;
    bool isNamed(const std::string& name) const; // true for any of its names, with dashes

    // Stores at least one value, as typed; of a flag any.
    void store(const std::vector<std::string>& values) const;
};

struct Command;

// Adds options under one heading of the help.
class OptionGroup {
public:
    OptionGroup(Command& command, std::string name);

    // Names between commas, such as "-j,--threads". The reference holds as long as the command is not moved.
    Option& add(const std::string& names, const std::string& valueName, const Value& value,
                const std::string& description, const std::string& standard = {}) const;
    Option& flag(const std::string& names, bool* place, const std::string& description) const;
    Option& argument(const std::string& valueName, const Place& place, const std::string& description) const;

private:
    Option& added(const std::string& names, Option option) const;

    Command& m_command;
    std::string m_name;
};

constexpr auto generalOptions = "Options"; // heading of the options that every command has; last in the help

// Throws UsageError: "--x cannot be used here: reason".
void refuseIf(bool given, const char* option, const QString& reason);

// The options of a command that were typed, in the order of its table.
class Given {
public:
    void add(const Option& option) { m_options.push_back(&option); }
    bool has(const std::string& name) const;

    // Throws UsageError when one of them says something of this kind, or has one of the names.
    void refuse(unsigned about, const QString& reason) const;
    void refuse(const std::vector<std::string>& names, const QString& reason) const;

private:
    std::vector<const Option*> m_options;
};

struct Command {
    // The usage names the command. It has --help from the beginning.
    Command(std::string name, std::string description, std::string usage);

    OptionGroup group(const std::string& name);
    Option& option(const std::string& name); // throws std::logic_error if there is none
    const Option* find(const std::string& name) const;

    std::string name, description, usage;
    std::string more; // further sentences for the manual page
    std::deque<Option> options;
    Given* given = nullptr;          // record of the options that were typed; may be null
    std::function<ExitStatus()> run; // called after all values are stored
};

struct Program {
    // std::logic_error where two commands have one name, or an option excludes one that is not there.
    Program(std::string description, std::vector<Command> commands);

    const Command* find(const std::string& name) const;

    std::string description;
    std::vector<Command> commands;
};

} // namespace cli
