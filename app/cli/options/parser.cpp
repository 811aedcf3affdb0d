// SPDX-License-Identifier: MIT
#include "options/parser.h"

#include "options/tr.h"
#include "options/usage_error.h"

#include <QByteArrayView>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

namespace cli {

namespace {

QString shown(const std::string& word) {
    return QString::fromStdString(word);
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

std::vector<std::string> optionNames(const Command& command) {
    std::vector<std::string> names;
    for (const Option& option : command.options)
        for (const std::string& name : option.names())
            names.push_back(name);
    return names;
}

std::vector<std::string> commandNames(const Program& program) {
    std::vector<std::string> names;
    for (const Command& command : program.commands)
        names.push_back(command.name);
    return names;
}

bool isOptionWord(const std::string& word) {
    return word.size() > 1 && word[0] == '-' &&
           (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])));
}

QString unknownOption(const Program& program, const Command* command, const std::string& name) {
    const QString unknown = tr("unknown option %1").arg(shown(name));
    std::vector<std::string> owners;
    for (const Command& other : program.commands)
        if (&other != command && other.find(name)) owners.push_back(other.name);
    if (command) {
        if (!owners.empty()) return tr("%1; it is an option of %2.").arg(unknown, listed(owners, tr("or")));
        const std::string meant = nearest(name, optionNames(*command));
        return meant.empty() ? unknown + u'.' : tr("%1; did you mean %2?").arg(unknown, shown(meant));
    }
    if (!owners.empty())
        return tr("%1 must follow its command, such as “%2 %1”.").arg(shown(name), shown(owners.front()));
    const std::string meant = nearest(name, {"--help", "--version"});
    return meant.empty() ? unknown + u'.' : tr("%1; did you mean %2?").arg(unknown, shown(meant));
}

QString unknownCommand(const Program& program, const std::string& name) {
    const auto names = commandNames(program);
    const std::string meant = nearest(name, names);
    return meant.empty() ? tr("There is no command “%1”; the commands are %2.")
                               .arg(shown(name), listed(names, tr("and")))
                         : tr("There is no command “%1”; did you mean %2?").arg(shown(name), shown(meant));
}

// Reads the words of one command, from left to right.
class Reader {
public:
    Reader(const Program& program, const Command& command) : m_program(program), m_command(command) {}

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
        const Option* option = m_command.find(name);
        if (!option) throw UsageError{unknownOption(m_program, &m_command, name)};
        if (option->isFlag()) {
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
            const Option* option = m_command.find(name);
            if (!option) throw UsageError{unknownOption(m_program, &m_command, word)};
            if (option->isFlag()) {
                set(*option, name, "true");
                continue;
            }
            return i + 1 < word.size() ? set(*option, name, word.substr(i + 1))
                                       : setNext(*option, name, words);
        }
    }

    void setNext(const Option& option, const std::string& name, const std::vector<std::string>& words) {
        if (m_next < words.size()) return set(option, name, words[m_next++]);
        complain(tr("%1 needs a value: %1 %2.").arg(shown(name), shown(option.valueName)));
    }

    void set(const Option& option, const std::string& name, const std::string& value) {
        if (option.asksForHelp()) {
            m_question = Question::Help;
            return;
        }
        if (value.empty() && !option.mayBeEmpty) complain(tr("The value of %1 is empty.").arg(shown(name)));
        if (!option.isFlag() && !option.isFileName && !QByteArrayView(value).isValidUtf8())
            complain(tr("The value of %1 is not valid UTF-8.").arg(shown(name)));
        std::vector<std::string>& values = m_values[&option];
        if (!values.empty() && !option.takesMany()) {
            if (!option.isFlag()) complain(tr("%1 can be given only once.").arg(shown(name)));
            return;
        }
        values.push_back(value);
    }

    // Gives one argument to each place, and to the last as many as it takes.
    void placeArguments() {
        std::size_t at = 0;
        for (const Option& option : m_command.options) {
            if (!option.isArgument()) continue;
            const std::size_t left = m_arguments.size() - at;
            if (left < option.minItems && option.isRequired && !isAnswered())
                throw UsageError{tr("%1 is missing. Usage: barycage-cli %2")
                                     .arg(missing(option, left), shown(m_command.usage))};
            const std::size_t taken = option.takesMany() ? left : std::min<std::size_t>(left, 1);
            for (const std::size_t end = at + taken; at < end; ++at) {
                if (m_arguments[at].empty()) throw UsageError{tr("The name of a file is empty.")};
                m_values[&option].push_back(m_arguments[at]);
            }
        }
        if (at < m_arguments.size())
            throw UsageError{tr("“%1” is one argument too many. Usage: barycage-cli %2")
                                 .arg(shown(m_arguments[at]), shown(m_command.usage))};
    }

    // The name of the first place that is empty: FILE or OUT of "FILE... OUT".
    static QString missing(const Option& option, std::size_t given) {
        const QStringList places = shown(option.valueName).remove(QStringLiteral("...")).split(u' ');
        return places[std::min(qsizetype(given), places.size() - 1)];
    }

    bool isGiven(const Option& option) const { return m_values.contains(&option); }

    bool isAnswered() const {
        return std::ranges::any_of(
            m_command.options, [this](const Option& option) { return option.isQuestion && isGiven(option); });
    }

    void check() const {
        for (const Option& option : m_command.options) {
            if (!isGiven(option)) {
                if (option.isRequired && !option.isArgument() && !isAnswered())
                    throw UsageError{tr("%1 %2 is missing. Usage: barycage-cli %3")
                                         .arg(shown(option.names().front()), shown(option.valueName),
                                              shown(m_command.usage))};
                continue;
            }
            for (const std::string& name : option.excluded) {
                const Option* other = m_command.find(name);
                if (other != nullptr && isGiven(*other))
                    throw UsageError{tr("%1 and %2 cannot be used together.")
                                         .arg(shown(option.name()), shown(other->name()))};
            }
        }
    }

    void store() const {
        for (const Option& option : m_command.options) {
            if (!isGiven(option)) continue;
            option.store(m_values.at(&option));
            if (m_command.given != nullptr) m_command.given->add(option);
        }
    }

    const Program& m_program;
    const Command& m_command;
    std::map<const Option*, std::vector<std::string>> m_values; // words given for each option or argument
    std::vector<std::string> m_arguments;                       // words that belong to no option
    std::optional<QString> m_complaint;                         // first complaint
    Question m_question = Question::None;
    std::size_t m_next = 0;
    bool m_optionsEnded = false;
};

const Command& commandNamed(const Program& program, const std::string& name) {
    if (const Command* command = program.find(name)) return *command;
    throw UsageError{unknownCommand(program, name)};
}

} // namespace

QString listed(QStringList words, const QString& last) {
    const QString end = words.takeLast();
    return words.isEmpty() ? end : words.join(QStringLiteral(", ")) + u' ' + last + u' ' + end;
}

QString listed(const std::vector<std::string>& words, const QString& last) {
    QStringList list;
    for (const std::string& word : words)
        list << shown(word);
    return listed(std::move(list), last);
}

std::string nearest(const std::string& word, const std::vector<std::string>& candidates) {
    constexpr std::size_t minPrefix = 3;
    const std::string typed = withoutDashes(word);
    std::string best;
    std::size_t least = std::max<std::size_t>(2, typed.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::string name = withoutDashes(candidate);
        if (name.size() < 2) continue; // a single letter resembles too many names
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

Call parse(const Program& program, const std::vector<std::string>& words) {
    if (words.empty())
        throw UsageError{tr("Give a command: %1.").arg(listed(commandNames(program), tr("or")))};
    const std::string& first = words.front();
    if (first == "help" || first == "--help" || first == "-h") {
        if (words.size() == 1) return {nullptr, Question::Help};
        return {&commandNamed(program, words[1]), Question::Help};
    }
    if (first == "--version" || first == "-V") return {nullptr, Question::Version};
    if (isOptionWord(first))
        throw UsageError{unknownOption(program, nullptr, first.substr(0, first.find('=')))};
    const Command& command = commandNamed(program, first);
    return {&command, Reader(program, command).read({words.begin() + 1, words.end()})};
}

} // namespace cli
