// SPDX-License-Identifier: MIT
#include "options/describe.h"

#include "options/tr.h"
#include "options/usage_error.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>
#include <vector>

namespace cli {

namespace {

using Kind = Completion::Kind;

constexpr auto palettes = "command barycage-cli render --list-palettes </dev/null 2>/dev/null";

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : between) + word;
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::string escaped(const std::string& text, const std::string& special) {
    std::string result;
    for (const char letter : text)
        result += special.find(letter) == std::string::npos ? std::string{letter} : std::string{'\\', letter};
    return result;
}

// The description up to its explanation, short enough to stand beside a name in a list.
std::string summary(const std::string& description) {
    std::size_t end = description.size();
    for (const char* explains : {": ", "; ", ", such as"})
        end = std::min(end, description.find(explains));
    return description.substr(0, end);
}

// --- bash

// The completion of a value, and the options that take such a value.
struct BashCase {
    std::string answer;
    std::vector<std::string> patterns;
};

std::string bashAnswer(const Completion& completion) {
    switch (completion.kind) {
    case Kind::Nothing:
        return "kind=nothing";
    case Kind::Words:
        return "kind=words choices=(" + joined(completion.words, " ") + ')';
    case Kind::Entries:
        return "kind=entries";
    case Kind::Palettes:
        return "kind=palettes";
    case Kind::Files:
        break;
    }
    return "kind=files";
}

std::vector<BashCase> bashCases(const Program& program) {
    std::vector<BashCase> cases;
    for (const Command& command : program.commands)
        for (const Option& option : command.options) {
            if (option.isArgument() || option.isFlag()) continue;
            const std::string answer = bashAnswer(option.completion);
            auto found = std::ranges::find(cases, answer, &BashCase::answer);
            if (found == cases.end()) found = cases.insert(cases.end(), {answer, {}});
            for (const std::string& name : option.names())
                found->patterns.push_back('\'' + command.name + ' ' + name + '\'');
        }
    return cases;
}

std::string bashTables(const Program& program) {
    std::string text = "_barycage_cli_commands=(";
    for (const Command& command : program.commands)
        text += command.name + ' ';
    text.back() = ')';
    text += "\n\n# Sets `options`: those of the command $1.\n_barycage_cli_options_of() {\n  case $1 in\n";
    for (const Command& command : program.commands) {
        text += "    " + command.name + ")\n      options=(";
        for (const Option& option : command.options)
            for (const std::string& name : option.longNames)
                text += name + ' ';
        text.back() = ')';
        text += "\n      ;;\n";
    }
    text += "    *) options=() ;;\n  esac\n}\n\n"
            "# Sets `kind` of what completes the value of $2, an option of the command $1, and `choices` of "
            "words. Fails where\n# there is no value.\n_barycage_cli_value_of() {\n  choices=()\n  case \"$1 "
            "$2\" in\n";
    for (const BashCase& each : bashCases(program))
        text += "    " + joined(each.patterns, " | \\\n      ") + ") " + each.answer + " ;;\n";
    return text + "    *) return 1 ;;\n  esac\n}\n";
}

// --- zsh

std::string zshAction(const Completion& completion) {
    switch (completion.kind) {
    case Kind::Nothing:
        return {};
    case Kind::Words:
        return ":(" + joined(completion.words, " ") + ')';
    case Kind::Entries:
        return ":_barycage_cli_names";
    case Kind::Palettes:
        return ":_barycage_cli_palettes";
    case Kind::Files:
        break;
    }
    return completion.words.empty() ? ":_files" : ":_files -g \"*.(" + joined(completion.words, "|") + ")\"";
}

// The other names of the option, and the options that cannot be used with it.
std::vector<std::string> zshExcluded(const Command& command, const Option& option) {
    std::vector<std::string> excluded;
    if (!option.takesMany() && option.names().size() > 1) excluded = option.names();
    excluded.insert(excluded.end(), option.excluded.begin(), option.excluded.end());
    for (const Option& other : command.options)
        if (std::ranges::any_of(other.excluded,
                                [&](const std::string& name) { return option.isNamed(name); }))
            excluded.push_back(other.name());
    return excluded;
}

std::string zshWord(const std::string& text) {
    return '\'' + replaced(text, "'", "'\\''") + '\'';
}

std::string zshOption(const Command& command, const Option& option, const std::string& name) {
    const std::vector<std::string> excluded = zshExcluded(command, option);
    std::string text = excluded.empty() ? "" : '(' + joined(excluded, " ") + ')';
    if (option.takesMany()) text += '*';
    text += name + '[' + escaped(summary(option.description), "[]:\\") + ']';
    if (!option.isFlag()) text += ':' + escaped(option.valueName, ":\\[]") + zshAction(option.completion);
    return zshWord(text);
}

std::string zshTables(const Program& program) {
    std::string text = "local -a subcommands\nsubcommands=(\n";
    for (const Command& command : program.commands)
        text += "  " + zshWord(command.name + '[' + escaped(command.description, "[]:\\") + ']') + '\n';
    text += "  'help[Show the options of a command]'\n)\n\n_barycage_cli_arguments() {\n  case $1 in\n";
    for (const Command& command : program.commands) {
        text += "    " + command.name + ")\n      _arguments";
        for (const Option& option : command.options)
            for (const std::string& name : option.names())
                text += " \\\n        " + zshOption(command, option, name);
        for (const Option& option : command.options)
            if (option.isArgument()) {
                Completion files = option.completion;
                if (files.kind == Kind::Nothing) files.kind = Kind::Files;
                text += " \\\n        " + zshWord((option.takesMany() ? "*:" : "1:") +
                                                  escaped(option.name(), ":\\[]") + zshAction(files));
            }
        text += "\n      ;;\n";
    }
    return text + "  esac\n}\n";
}

// --- fish

std::string fishWord(const std::string& text) {
    return '"' + escaped(text, "\\\"$") + '"';
}

std::string fishValue(const Option& option) {
    switch (option.completion.kind) {
    case Kind::Nothing:
        return option.isFlag() ? "" : " -x";
    case Kind::Words:
        return " -x -a " + fishWord(joined(option.completion.words, " "));
    case Kind::Entries:
        return " -x -a \"(__barycage_cli_names)\"";
    case Kind::Palettes:
        return std::string(" -r -a \"(") + palettes + ")\"";
    case Kind::Files:
        break;
    }
    return option.isFileName && option.isNamed("--output") ? " -r -a -" : " -r";
}

std::string fishTables(const Program& program) {
    std::vector<std::string> commands, flags;
    for (const Command& command : program.commands) {
        commands.push_back(command.name);
        for (const Option& option : command.options)
            if (!option.isArgument() && option.isFlag())
                for (const std::string& name : option.names())
                    if (std::ranges::find(flags, name) == flags.end()) flags.push_back(name);
    }
    std::string text = "set -g __barycage_cli_commands " + joined(commands, " ") +
                       "\n# The options that take no value.\nset -g __barycage_cli_flags " +
                       joined(flags, " ") + '\n';
    const std::string first = "complete -c barycage-cli -n \"not __fish_seen_subcommand_from "
                              "$__barycage_cli_commands\"";
    for (const Command& command : program.commands)
        text += first + " -f -a " + command.name + " -d " + fishWord(command.description) + '\n';
    text += first + " -f -a help -d \"Show the options of a command\"\n" + first +
            " -l help -d \"Show this help\"\n" + first + " -l version -d \"Show the version\"\n";
    for (const Command& command : program.commands)
        for (const Option& option : command.options) {
            if (option.isArgument()) continue;
            text += "complete -c barycage-cli -n \"__fish_seen_subcommand_from " + command.name + '"';
            for (const std::string& name : option.names())
                text += (name.starts_with("--") ? " -l " : " -s ") + name.substr(name.find_first_not_of('-'));
            text += fishValue(option) + " -d " + fishWord(summary(option.description)) + '\n';
        }
    return text;
}

// --- the manual page

// Text for troff, with names of options in bold.
std::string manualText(const std::string& text) {
    std::string result = escaped(text, "\\");
    result = replaced(result, "-", "\\-");
    for (const auto& [sign, request] :
         {std::pair{"√", "\\(sr"}, {"·", "\\(pc"}, {"…", "..."}, {"\"", "\\(dq"}})
        result = replaced(result, sign, request);
    for (std::size_t at = 0; (at = result.find("\\-\\-", at)) != std::string::npos;) {
        std::size_t end = at;
        while (end < result.size() && (std::isalpha(static_cast<unsigned char>(result[end])) ||
                                       result[end] == '\\' || result[end] == '-'))
            ++end;
        const std::string name = "\\fB" + result.substr(at, end - at) + "\\fP";
        result.replace(at, end - at, name);
        at += name.size();
    }
    return result;
}

std::string sentence(const std::string& text) {
    return text.ends_with('.') || text.ends_with("…") ? text : text + '.';
}

// Lines of the manual, each a sentence or more.
std::string manualLines(const std::vector<std::string>& texts) {
    constexpr std::size_t length = 118;
    std::string lines;
    for (const std::string& text : texts) {
        std::string line;
        std::istringstream words(manualText(text));
        for (std::string word; words >> word;) {
            if (!line.empty() && line.size() + 1 + word.size() > length) {
                lines += line + '\n';
                line.clear();
            }
            const bool isRequest = line.empty() && (word.front() == '.' || word.front() == '\'');
            line += (line.empty() ? (isRequest ? "\\&" : "") : " ") + word;
        }
        if (!line.empty()) lines += line + '\n';
    }
    return lines;
}

std::string manualEntry(const Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names())
        names.push_back("\\fB" + replaced(name, "-", "\\-") + "\\fP");
    std::string text = ".TP\n" + joined(names, ", ");
    if (!option.isFlag()) text += " \\fI" + manualText(option.valueName) + "\\fP";
    const std::string standard = option.standard.empty() ? "" : sentence("By default " + option.standard);
    return text + '\n' + manualLines({sentence(option.description), standard, option.more});
}

std::string manualSections(const Program& program) {
    std::string text;
    for (const Command& command : program.commands) {
        text += ".SS " + command.name + '\n' + manualLines({sentence(command.description), command.more});
        for (const Option& option : command.options)
            if (!option.isArgument() && !option.asksForHelp()) text += manualEntry(option);
    }
    return text;
}

// Names of the options on which the pixels of a frame depend.
std::string frameOptionNames(const Program& program) {
    std::string names;
    if (const Command* command = program.find("animate"))
        for (const Option& option : command->options)
            if (!option.isArgument() && (option.about & Work) == 0) names += option.name() + '\n';
    return names;
}

} // namespace

std::string describe(const Program& program, const std::string& reader) {
    if (reader == "bash") return bashTables(program);
    if (reader == "zsh") return zshTables(program);
    if (reader == "fish") return fishTables(program);
    if (reader == "manual") return manualSections(program);
    if (reader == "frames") return frameOptionNames(program);
    throw UsageError{tr("--describe bash, zsh, fish, manual, frames or schema.")};
}

} // namespace cli
