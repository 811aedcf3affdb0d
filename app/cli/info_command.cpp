// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/messages.h"
#include "process/progress_bar.h"
#include "render/shown_frame.h"

#include "io/file/standard_output.h"
#include "io/report/info_json.h"
#include "io/report/info_text.h"

#include <QHash>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>

namespace cli {

namespace {

struct InfoArguments {
    std::string file;
    std::vector<std::string> entries;
    bool json = false;
    bool names = false;
    bool list = false;
    bool noDimension = false;
    std::optional<double> hullTolerance;
    std::optional<animation::Moment> frame;
    std::optional<double> budget = 1; // seconds; none: no limit
    Verbosity verbosity;
};

// Names of entries, each once, as --entry takes it.
QByteArray namesOf(const QList<document::Entry>& entries) {
    QStringList lines;
    for (const document::Entry& entry : entries)
        if (!entry.fractal->name.isEmpty()) lines << printableLine(entry.fractal->name) + u'\n';
    lines.removeDuplicates();
    return lines.join(QString()).toUtf8();
}

// Entries with their numbers in the file, counted from 1.
QByteArray listOf(const Input& input, const io::InfoSubject& subject, bool asJson) {
    const auto& all = input.collection.file.entries;
    QHash<document::EntryId, qsizetype> places;
    for (qsizetype i = 0; i < all.size(); ++i)
        places.insert(all[i].id, i + 1);
    QList<qsizetype> numbers;
    for (const document::Entry& entry : subject.entries)
        numbers << places.value(entry.id);
    return asJson ? io::listJson(subject, numbers)
                  : printable(io::listText(subject.entries, numbers)).toUtf8();
}

// A bar that appears when the answer takes longer than a second.
class LateBar {
public:
    explicit LateBar(ProgressMode mode)
        : m_mode(mode), m_watch([this](const std::stop_token& stop) { watch(stop); }) {}

    void show(double fraction) { m_fraction = fraction; }

private:
    void watch(const std::stop_token& stop) {
        constexpr std::chrono::milliseconds patience{1000}, tick{100};
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any waiting;
        const auto passes = [&](std::chrono::milliseconds time) {
            waiting.wait_for(lock, stop, time, [] { return false; });
            return !stop.stop_requested();
        };
        if (!passes(patience)) return;
        ProgressBar bar(m_mode);
        do
            bar.show(m_fraction);
        while (passes(tick));
    }

    ProgressMode m_mode;
    std::atomic<double> m_fraction = 0;
    std::jthread m_watch;
};

// A file with many systems, each of which takes long, ends as well.
void limit(io::InfoSubject& subject, std::chrono::duration<double> perFact) {
    constexpr int perEntry = 3, perCall = 30; // multiples of the budget of one fact
    subject.limits.perFact = perFact;
    subject.limits.together = perEntry * perFact;
    subject.end = ifs::ProcessorClock::now() + perCall * perFact;
}

QByteArray factsOf(const InfoArguments& arguments, io::InfoSubject subject, ProgressMode mode) {
    document::Problems remarks;
    subject.hullTolerance = arguments.hullTolerance;
    if (arguments.frame) subject.moment = *arguments.frame;
    subject.limits.withAffinityDimension = !arguments.noDimension;
    if (arguments.budget) limit(subject, std::chrono::duration<double>(*arguments.budget));
    subject.remark = [&](const document::Problem& problem) { remarks << problem; };
    QByteArray answer;
    {
        LateBar bar(mode);
        const auto all = double(subject.entries.size());
        subject.begun = [&](qsizetype entry) { bar.show(double(entry) / all); };
        answer = arguments.json ? io::infoJson(subject) : printable(io::infoText(subject)).toUtf8();
    }
    reportAll(remarks, subject.fileName);
    return answer;
}

// Entries whose animations end before the frame are named and left out.
void dropEntriesEndedBefore(const animation::Moment& moment, Selection& selection, const QString& fileName) {
    selection.entries.removeIf([&](const document::Entry& entry) {
        if (isLoaded(entry) && !document::animationFacts(*entry.fractal))
            reportWarning(fileName, tr("“%1” has no animation: its properties are the "
                                       "same in every frame.")
                                        .arg(printableLine(entry.fractal->name)));
        const QString obstacle = frameObstacle(*entry.fractal, moment);
        if (!obstacle.isEmpty()) reportError(fileName, obstacle);
        selection.complete &= obstacle.isEmpty();
        return !obstacle.isEmpty();
    });
}

std::optional<double> budgetArgument(const std::string& option, const std::string& text) {
    if (text == "none") return std::nullopt;
    constexpr double maxSeconds = 1e6;
    const double seconds = positiveArgument(option, text);
    if (seconds > maxSeconds) throw UsageError{tr("--budget must be none, or at most 1000000 seconds.")};
    return seconds;
}

ExitStatus info(const InfoArguments& arguments) {
    const ProgressMode mode = applied(arguments.verbosity);
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    Selection selection = select(*input, arguments.entries);
    if (arguments.frame) dropEntriesEndedBefore(*arguments.frame, selection, input->name);
    const ExitStatus problems = reportAll(selection.problems, input->name);
    const io::InfoSubject subject{
        input->name, input->collection.format, selection.entries, selection.problems, {}};
    const QByteArray answer = arguments.names  ? namesOf(selection.entries)
                              : arguments.list ? listOf(*input, subject, arguments.json)
                                               : factsOf(arguments, subject, mode);
    if (!print(answer)) {
        reportError(input->name, io::cannotPrint(errno));
        return ExitStatus::CannotReadOrWrite;
    }
    return selection.complete && !selection.entries.isEmpty() ? problems : ExitStatus::InputProblems;
}

} // namespace

Command infoCommand() {
    auto arguments = std::make_shared<InfoArguments>();
    Command command("info", "Show what a file contains and the properties of its systems",
                    "info FILE [OPTION]...");
    command.group("Files")
        .argument("FILE", &arguments->file,
                  "Collection, or picture with an embedded system; - for standard input")
        .required();
    addEntriesOption(command, arguments->entries);
    const OptionGroup output = command.group("Output");
    output.flag("--json", &arguments->json, "Print one JSON object at full precision")
        .moreOf("Its schema is info.schema.json in the documentation.")
        .excludes("--names");
    output.flag("--names", &arguments->names, "Print only the names, one per line")
        .moreOf("Control characters in them are replaced; each name can be used as printed.")
        .excludes("--list");
    output.flag("--list", &arguments->list, "Print only the number, dimension, maps and name of each entry")
        .moreOf("With --json, the same as an object.");
    const OptionGroup properties = command.group("Properties");
    properties.add("--frame", "F", parsed(&arguments->frame, momentArgument),
                   "The moment of an animation in frames, counted from 0, such as 12, 12.5 or 25/2",
                   "the entry at rest");
    properties
        .add("--hull-tolerance", "LENGTH", parsed(&arguments->hullTolerance, positiveArgument),
             "Tolerance of the convex hull, in the system's units", "1e-6 of the diagonal")
        .moreOf("A warning is printed where it is not reached.");
    properties
        .add("--budget", "SECONDS", parsed(&arguments->budget, budgetArgument),
             "Processor time for each property that can take long, with three times as much for an entry and "
             "30 times for all, or none for no limit",
             "1")
        .moreOf("A property that would take longer is reported as not computed within the budget; in "
                "JSON it is null, and listed as out_of_time.")
        .completedBy(Completion::Kind::Words, {"1", "10", "none"});
    properties.flag("--no-dimension", &arguments->noDimension, "Leave out the affinity dimension")
        .moreOf("It takes longest.");
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return info(*arguments); };
    return command;
}

} // namespace cli
