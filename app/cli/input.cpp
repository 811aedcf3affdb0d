// SPDX-License-Identifier: MIT
#include "input.h"

#include "messages.h"

#include "io/save_file.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>

namespace cli {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

io::Loaded readStandardInput() {
    QFile file;
    if (!file.open(stdin, QIODevice::ReadOnly))
        return {{}, tr("Standard input cannot be read: %1.").arg(file.errorString())};
    constexpr qint64 pieceSize = 1 << 16;
    constexpr qsizetype mostBytes = 256 * 1024 * 1024;
    io::Loaded loaded;
    for (QByteArray piece = file.read(pieceSize); !piece.isEmpty(); piece = file.read(pieceSize)) {
        loaded.bytes += piece;
        if (loaded.bytes.size() > mostBytes)
            return {{}, tr("More than 256 MB came in, which is the limit for a file.")};
    }
    if (file.error() != QFileDevice::NoError)
        return {{}, tr("Standard input cannot be read: %1.").arg(file.errorString())};
    return loaded;
}

const document::Entry* find(const Input& input, const QString& name) {
    const auto& entries = input.collection.file.entries;
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const document::Entry& entry) {
        return entry.fractal->name.compare(name, Qt::CaseInsensitive) == 0;
    });
    return found == entries.end() ? nullptr : &*found;
}

bool isDrawable(const document::Entry& entry) {
    return document::system2(*entry.fractal) != nullptr;
}

void reportMissing(const Input& input, const QString& name) {
    reportError(input.name, tr("There is no entry “%1”.").arg(name));
}

// What its reader refused by name is an entry that could not be read, as in a collection, and its reason a
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

std::optional<Input> readInput(const std::string& file, const io::ReadOptions& options) {
    const QString name = QString::fromStdString(file);
    const io::Loaded loaded = file == "-" ? readStandardInput() : io::loadFile(name);
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

Selection select(const Input& input, const std::vector<std::string>& names) {
    Selection selection;
    selection.problems = input.collection.file.problems;
    if (names.empty()) selection.entries = input.collection.file.entries;
    for (const std::string& name : names) {
        if (const document::Entry* entry = find(input, QString::fromStdString(name))) {
            const auto isSame = [entry](const document::Entry& chosen) { return chosen.id == entry->id; };
            if (std::none_of(selection.entries.begin(), selection.entries.end(), isSame))
                selection.entries << *entry;
            continue;
        }
        reportMissing(input, QString::fromStdString(name));
        selection.complete = false;
    }
    for (const auto& entry : std::as_const(selection.entries))
        selection.problems += entry.problems;
    return selection;
}

ToDraw entryToDraw(const Input& input, const std::string& name) {
    const document::Entry* entry = nullptr;
    const auto& entries = input.collection.file.entries;
    if (!name.empty()) {
        entry = find(input, QString::fromStdString(name));
        if (!entry) reportMissing(input, QString::fromStdString(name));
    } else if (const auto first = std::find_if(entries.begin(), entries.end(), isDrawable);
               first != entries.end()) {
        entry = &*first;
    }
    ExitStatus status = reportAll(input.collection.file.problems, input.name);
    for (const auto& other : entries)
        if (&other == entry || (!entry && name.empty()))
            status = std::max(status, reportAll(other.problems, input.name));
    if (entry && isDrawable(*entry)) return {entry, status};
    if (!entry && name.empty())
        reportError(input.name, tr("The file holds no entry that can be drawn."));
    else if (entry && isLoaded(*entry))
        reportError(
            input.name,
            tr("“%1” lies in space, and this version draws in the plane only.").arg(entry->fractal->name));
    return {nullptr, ExitStatus::InputProblems};
}

} // namespace cli
