// SPDX-License-Identifier: MIT
#include "parser.h"

#include "usage_error.h"

#include <QByteArrayView>
#include <QCoreApplication>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace cli {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

QString shown(const std::string& word) {
    return QString::fromStdString(word);
}

QString listed(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names)
        list << shown(name);
    const QString last = list.takeLast();
    return list.isEmpty() ? last : tr("%1 or %2").arg(list.join(QStringLiteral(", ")), last);
}

// Insertions, deletions, replacements and exchanges of neighbours that make one word the other.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                steps[i][j] = i + j;
                continue;
            }
            const std::size_t replaced = steps[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            steps[i][j] = std::min({steps[i - 1][j] + 1, steps[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
        }
    return steps[a.size()][b.size()];
}

std::string withoutDashes(const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

std::vector<std::string> namesOf(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_lnames())
        names.push_back("--" + name);
    for (const std::string& name : option.get_snames())
        names.push_back("-" + name);
    return names;
}

std::vector<std::string> optionNames(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : namesOf(*option))
            names.push_back(name);
    return names;
}

std::vector<std::string> commandNames(CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({}))
        names.push_back(command->get_name());
    return names;
}

CLI::App* findCommand(CLI::App& program, const std::string& name) {
    const auto commands =
        program.get_subcommands([&](CLI::App* command) { return command->get_name() == name; });
    return commands.empty() ? nullptr : commands.front();
}

CLI::Option* findOption(CLI::App& command, const std::string& name) {
    const auto options = command.get_options([&](CLI::Option* option) {
        const auto names = namesOf(*option);
        return std::ranges::find(names, name) != names.end();
    });
    return options.empty() ? nullptr : options.front();
}

bool isFlag(const CLI::Option& option) {
    return option.get_items_expected_max() == 0;
}

bool isOptionWord(const std::string& word) {
    return word.size() > 1 && word[0] == '-' &&
           (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])));
}

// Bytes that are no text make sense only as the name of a file.
bool isFileName(const CLI::Option& option) {
    return option.get_positional() || option.check_lname("output") || option.check_lname("palette") ||
           option.check_lname("picture") || option.check_lname("from-file");
}

QString unknownOption(CLI::App& program, CLI::App* command, const std::string& name) {
    const QString unknown = tr("unknown option %1").arg(shown(name));
    std::vector<std::string> owners;
    for (CLI::App* other : program.get_subcommands({}))
        if (other != command && findOption(*other, name)) owners.push_back(other->get_name());
    if (command) {
        if (!owners.empty()) return tr("%1; it is an option of %2.").arg(unknown, listed(owners));
        const std::string meant = nearest(name, optionNames(*command));
        return meant.empty() ? unknown + u'.' : tr("%1; did you mean %2?").arg(unknown, shown(meant));
    }
    if (!owners.empty())
        return tr("%1 must follow its command, such as “%2 %1”.").arg(shown(name), shown(owners.front()));
    const std::string meant = nearest(name, optionNames(program));
    return meant.empty() ? unknown + u'.' : tr("%1; did you mean %2?").arg(unknown, shown(meant));
}

QString unknownCommand(CLI::App& program, const std::string& name) {
    const auto names = commandNames(program);
    const std::string meant = nearest(name, names);
    return meant.empty() ? tr("There is no command “%1”; the commands are %2.")
                               .arg(shown(name), listed(names).replace(tr(" or "), tr(" and ")))
                         : tr("There is no command “%1”; did you mean %2?").arg(shown(name), shown(meant));
}

// One command's words, from left to right.
class Reader {
public:
    Reader(CLI::App& program, CLI::App& command) : m_program(program), m_command(command) {}

    Question read(const std::vector<std::string>& words) {
        for (m_next = 0; m_next < words.size();) {
            const std::string& word = words[m_next++];
            if (m_optionsEnded || !isOptionWord(word))
                m_arguments.push_back(word);
            else if (word == "--")
                m_optionsEnded = true;
            else if (word[1] == '-')
                readLong(words, word);
            else
                readShort(words, word);
        }
        if (m_question != Question::None) return m_question;
        if (m_complaint) throw UsageError{*m_complaint};
        placeArguments();
        check();
        store();
        return Question::None;
    }

private:
    void complain(const QString& sentence) {
        if (!m_complaint) m_complaint = sentence;
    }

    void readLong(const std::vector<std::string>& words, const std::string& word) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        CLI::Option* option = findOption(m_command, name);
        if (!option) throw UsageError{unknownOption(m_program, &m_command, name)};
        if (isFlag(*option)) {
            if (equals != std::string::npos) complain(tr("%1 takes no value.").arg(shown(name)));
            return set(*option, name, "true");
        }
        if (equals != std::string::npos) return set(*option, name, word.substr(equals + 1));
        setNext(*option, name, words);
    }

    // Flags may share a dash, and a value may follow without a blank.
    void readShort(const std::vector<std::string>& words, const std::string& word) {
        for (std::size_t i = 1; i < word.size(); ++i) {
            const std::string name = std::string("-") + word[i];
            CLI::Option* option = findOption(m_command, name);
            if (!option) throw UsageError{unknownOption(m_program, &m_command, word)};
            if (isFlag(*option)) {
                set(*option, name, "true");
                continue;
            }
            return i + 1 < word.size() ? set(*option, name, word.substr(i + 1))
                                       : setNext(*option, name, words);
        }
    }

    void setNext(CLI::Option& option, const std::string& name, const std::vector<std::string>& words) {
        if (m_next < words.size()) return set(option, name, words[m_next++]);
        complain(tr("%1 needs a value: %1 %2.").arg(shown(name), shown(option.get_type_name())));
    }

    void set(CLI::Option& option, const std::string& name, const std::string& value) {
        if (option.check_lname("help")) {
            m_question = Question::Help;
            return;
        }
        if (value.empty() && !option.check_lname("title"))
            complain(tr("The value of %1 is empty.").arg(shown(name)));
        if (!isFlag(option) && !isFileName(option) && !QByteArrayView(value).isValidUtf8())
            complain(tr("The value of %1 is not valid UTF-8.").arg(shown(name)));
        if (option.count() > 0) {
            if (isFlag(option)) return;
            if (option.get_items_expected_max() == 1 &&
                option.get_multi_option_policy() != CLI::MultiOptionPolicy::TakeAll)
                return complain(tr("%1 can be given only once.").arg(shown(name)));
        }
        add(option, value);
    }

    // One value as it is: CLI11 would take [a,b] for two.
    static void add(CLI::Option& option, const std::string& value) {
        option.allow_extra_args(false);
        option.add_result(value);
    }

    // One argument for each place, and to the last as many as it takes.
    void placeArguments() {
        std::size_t at = 0;
        for (CLI::Option* option :
             m_command.get_options([](CLI::Option* candidate) { return candidate->get_positional(); })) {
            const auto minItems = std::size_t(option->get_items_expected_min());
            const auto maxItems = std::size_t(option->get_items_expected_max());
            const std::size_t left = m_arguments.size() - at;
            if (left < minItems && option->get_required() && !isAnswered())
                throw UsageError{tr("%1 is missing. Usage: barycage-cli %2")
                                     .arg(missing(*option, left), shown(m_command.get_footer()))};
            for (const std::size_t end = at + std::min(left, maxItems); at < end; ++at) {
                if (m_arguments[at].empty()) throw UsageError{tr("The name of a file is empty.")};
                add(*option, m_arguments[at]);
            }
        }
        if (at < m_arguments.size())
            throw UsageError{tr("“%1” is one argument too many. Usage: barycage-cli %2")
                                 .arg(shown(m_arguments[at]), shown(m_command.get_footer()))};
    }

    // The name of the first place that is empty: FILE or OUT of "FILE... OUT".
    static QString missing(const CLI::Option& option, std::size_t given) {
        const QStringList places = shown(option.get_type_name()).remove(QStringLiteral("...")).split(u' ');
        return places[std::min(qsizetype(given), places.size() - 1)];
    }

    // By an option that asks for a list instead of the command's work.
    bool isAnswered() const {
        return std::ranges::any_of(m_command.get_options({}), [](const CLI::Option* option) {
            return option->count() > 0 && option->get_lnames().size() == 1 &&
                   option->get_lnames().front().starts_with("list-");
        });
    }

    void check() const {
        for (const CLI::Option* option : m_command.get_options({})) {
            if (option->count() == 0) {
                if (option->get_required() && !option->get_positional() && !isAnswered())
                    throw UsageError{tr("%1 %2 is missing. Usage: barycage-cli %3")
                                         .arg(shown(namesOf(*option).back()), shown(option->get_type_name()),
                                              shown(m_command.get_footer()))};
                continue;
            }
            for (const CLI::Option* other : option->get_excludes())
                if (other->count() > 0)
                    throw UsageError{
                        tr("%1 and %2 cannot be used together.")
                            .arg(shown(namesOf(*option).front()), shown(namesOf(*other).front()))};
        }
    }

    void store() const {
        for (CLI::Option* option : m_command.get_options([](CLI::Option*) { return true; })) {
            if (option->count() == 0) continue;
            try {
                option->run_callback();
            } catch (const CLI::ParseError&) {
                throw UsageError{tr("%1 “%2” is not valid.")
                                     .arg(shown(option->get_name()), shown(option->results().front()))};
            }
        }
    }

    CLI::App& m_program;
    CLI::App& m_command;
    std::vector<std::string> m_arguments; // that belong to no option
    std::optional<QString> m_complaint;   // the first
    Question m_question = Question::None;
    std::size_t m_next = 0;
    bool m_optionsEnded = false;
};

CLI::App& commandNamed(CLI::App& program, const std::string& name) {
    if (CLI::App* command = findCommand(program, name)) return *command;
    throw UsageError{unknownCommand(program, name)};
}

} // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
    constexpr std::size_t minPrefix = 3;
    const std::string typed = withoutDashes(word);
    std::string best;
    std::size_t least = std::max<std::size_t>(2, typed.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::string name = withoutDashes(candidate);
        if (name.size() < 2) continue; // one letter is near everything
        const std::size_t shared = std::min(typed.size(), name.size());
        const bool isBeginning = shared >= minPrefix && typed.substr(0, shared) == name.substr(0, shared);
        std::size_t far = distance(typed, name);
        if (typed.size() <= 2 && far > 1) continue;
        if (isBeginning) far = std::min<std::size_t>(far, 1);
        if (far < least) {
            least = far;
            best = candidate;
        }
    }
    return best;
}

Call parse(CLI::App& program, const std::vector<std::string>& words) {
    if (words.empty()) throw UsageError{tr("Give a command: %1.").arg(listed(commandNames(program)))};
    const std::string& first = words.front();
    if (first == "help" || first == "--help" || first == "-h") {
        if (words.size() == 1) return {nullptr, Question::Help};
        return {&commandNamed(program, words[1]), Question::Help};
    }
    if (first == "--version" || first == "-V") return {nullptr, Question::Version};
    if (isOptionWord(first))
        throw UsageError{unknownOption(program, nullptr, first.substr(0, first.find('=')))};
    CLI::App& command = commandNamed(program, first);
    return {&command, Reader(program, command).read({words.begin() + 1, words.end()})};
}

} // namespace cli
