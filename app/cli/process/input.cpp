// SPDX-License-Identifier: MIT
#include "process/input.h"

#include "options/options.h"
#include "options/tr.h"
#include "process/files_read.h"
#include "process/messages.h"

#include "io/exchange/entry_link.h"
#include "io/file/native_path.h"
#include "io/file/save_file.h"

#include <QFile>

#include <algorithm>
#include <unistd.h>

namespace cli {

namespace {

io::Loaded readStandardInput() {
    QFile file;
    if (!file.open(STDIN_FILENO, QIODevice::ReadOnly))
        return {{}, tr("Standard input cannot be read: %1.").arg(file.errorString())};
    constexpr qint64 pieceSize = 1 << 16;
    constexpr qsizetype maxBytes = 256 * 1024 * 1024;
    io::Loaded loaded;
    for (QByteArray piece = file.read(pieceSize); !piece.isEmpty(); piece = file.read(pieceSize)) {
        loaded.bytes += piece;
        if (loaded.bytes.size() > maxBytes)
            return {{}, tr("Standard input is larger than 256 MB, which is the limit for a file.")};
    }
    if (file.error() != QFileDevice::NoError)
        return {{}, tr("Standard input cannot be read: %1.").arg(file.errorString())};
    return loaded;
}

const document::Entry* find(const Input& input, const QString& name) {
    const auto& entries = input.collection.file.entries;
    const auto first = [&](const auto& isMeant) {
        const auto found = std::find_if(entries.begin(), entries.end(), [&](const document::Entry& entry) {
            return isMeant(entry.fractal->name);
        });
        return found == entries.end() ? nullptr : &*found;
    };
    if (const auto* exact = first([&](const QString& other) { return other == name; })) return exact;
    if (const auto* shown = first([&](const QString& other) { return printableLine(other) == name; }))
        return shown;
    bool isNumber = false;
    const qsizetype number = name.startsWith(u'#') ? name.mid(1).toInt(&isNumber) : 0;
    if (isNumber && number >= 1 && number <= entries.size()) return &entries[number - 1];
    return first([&](const QString& other) { return other.compare(name, Qt::CaseInsensitive) == 0; });
}

void reportMissing(const Input& input, const QString& name) {
    if (!name.startsWith(u'#')) return reportError(input.name, tr("There is no entry “%1”.").arg(name));
    const qsizetype count = input.collection.file.entries.size();
    if (count == 1)
        return reportError(input.name, tr("There is no entry “%1”; the file has 1 entry.").arg(name));
    reportError(input.name,
                tr("There is no entry “%1”; the file has %2 entries.").arg(name, QString::number(count)));
}

// Turns a refusal by name into an entry that could not be read, as in a collection, with its reason as a
// problem of the entry.
void listRefused(document::FractalFile& file) {
    document::Problems ofTheFile;
    auto id = static_cast<std::uint32_t>(document::freshId(file));
    for (const document::Problem& problem : std::as_const(file.problems)) {
        if (problem.severity != document::Problem::Severity::Error || problem.entry.isEmpty()) {
            ofTheFile << problem;
            continue;
        }
        auto fractal = std::make_shared<document::Fractal>();
        fractal->name = problem.entry;
        document::Entry entry;
        entry.id = static_cast<document::EntryId>(id++);
        entry.fractal = std::move(fractal);
        entry.problems << problem;
        file.entries << entry;
    }
    file.problems = ofTheFile;
}

} // namespace

QString fileNameOf(const std::string& argument) {
    return io::pathOf(QByteArray::fromStdString(argument));
}

namespace {

// A link in place of a file, which would go before it.
bool isLink(const std::string& argument) {
    return io::looksLikeLink(argument) && !QFile::exists(fileNameOf(argument));
}

// The name in messages and output files: a link has no name, and may be long.
QString inputName(const std::string& argument) {
    return isLink(argument) ? QStringLiteral("link") : fileNameOf(argument);
}

} // namespace

io::Loaded loadBytes(const std::string& file) {
    if (isLink(file)) return {QByteArray::fromStdString(file), {}};
    noteRead(fileNameOf(file));
    return file == "-" ? readStandardInput() : io::loadSource(fileNameOf(file));
}

std::optional<Input> readInput(const std::string& file, const io::ReadOptions& options) {
    const QString name = inputName(file);
    const io::Loaded loaded = loadBytes(file);
    if (loaded.failure) {
        reportError(name, *loaded.failure);
        return std::nullopt;
    }
    Input input{name, loaded.bytes,
                io::readCollection(loaded.bytes, file == "-" ? QString() : name, options)};
    listRefused(input.collection.file);
    return input;
}

ExitStatus reportAll(const document::Problems& problems, const QString& fileName) {
    ExitStatus status = ExitStatus::Done;
    for (const document::Problem& problem : problems) {
        report(problem, fileName);
        if (problem.severity == document::Problem::Severity::Error) status = ExitStatus::InputProblems;
    }
    return status;
}

bool isLoaded(const document::Entry& entry) {
    return document::dimension(*entry.fractal) != 0;
}

Option& addEntriesOption(Command& command, std::vector<std::string>& entries, const char* standard) {
    return command.group("Files")
        .add("--entry", "NAME", &entries, "Only this entry: its name, #NUMBER, or all; may be repeated",
             standard)
        .completedBy(Completion::Kind::Entries);
}

namespace {

// Entries that are named, each once, in the order of the names.
struct Found {
    std::vector<const document::Entry*> entries;
    bool complete = true;
};

Found findAll(const Input& input, const std::vector<std::string>& names) {
    Found found;
    const auto add = [&](const document::Entry& entry) {
        if (std::ranges::find(found.entries, &entry) == found.entries.end()) found.entries.push_back(&entry);
    };
    for (const std::string& name : names) {
        if (const document::Entry* entry = find(input, QString::fromStdString(name))) {
            add(*entry);
        } else if (name == "all") {
            std::ranges::for_each(input.collection.file.entries, add);
        } else {
            reportMissing(input, QString::fromStdString(name));
            found.complete = false;
        }
    }
    return found;
}

// The first entry that can be drawn; for a file without one, the problems of all are reported.
ToDraw firstToDraw(const Input& input) {
    const auto& entries = input.collection.file.entries;
    const auto first = std::ranges::find_if(entries, isLoaded);
    ToDraw result{{}, reportAll(input.collection.file.problems, input.name)};
    for (auto entry = entries.begin(); entry != entries.end(); ++entry)
        if (entry == first || first == entries.end()) {
            result.status = std::max(result.status, reportAll(entry->problems, input.name));
            result.reported.push_back(&*entry);
        }
    if (first != entries.end())
        result.entries.push_back(&*first);
    else
        reportError(input.name, tr("The file contains no entry that can be drawn."));
    return result;
}

} // namespace

Selection select(const Input& input, const std::vector<std::string>& names) {
    Selection selection;
    selection.problems = input.collection.file.problems;
    if (names.empty()) selection.entries = input.collection.file.entries;
    const Found found = findAll(input, names);
    for (const document::Entry* entry : found.entries)
        selection.entries << *entry;
    selection.complete = found.complete;
    for (const auto& entry : std::as_const(selection.entries))
        selection.problems += entry.problems;
    return selection;
}

ToDraw entriesToDraw(const Input& input, const std::vector<std::string>& names, const ToDraw* before) {
    if (names.empty()) {
        ToDraw first = firstToDraw(input);
        if (first.entries.empty()) first.status = ExitStatus::InputProblems;
        return first;
    }
    const Found found = findAll(input, names);
    ToDraw result{{}, before ? before->status : reportAll(input.collection.file.problems, input.name)};
    if (before) result.reported = before->reported;
    if (!found.complete) result.status = ExitStatus::InputProblems;
    for (const document::Entry* entry : found.entries) {
        if (std::ranges::find(result.reported, entry) == result.reported.end()) {
            result.status = std::max(result.status, reportAll(entry->problems, input.name));
            result.reported.push_back(entry);
        }
        if (isLoaded(*entry))
            result.entries.push_back(entry);
        else
            result.status = ExitStatus::InputProblems;
    }
    return result;
}

} // namespace cli
