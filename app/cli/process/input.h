// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include "io/collection_reader.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct Command;
struct Option;

struct Input {
    QString name; // argument as typed, "-" for standard input, "link" for a link
    QByteArray bytes;
    io::Collection collection;
};

QString fileNameOf(const std::string& argument); // accepts bytes that are not UTF-8

io::Loaded loadBytes(const std::string& file); // contents of a file, of standard input for "-", or of a link

// Reads FILE, or what a link holds that no file is called; nullopt when it cannot be read, which has then
// been reported.
std::optional<Input> readInput(const std::string& file, const io::ReadOptions& options = {});

// --entry, as often as one likes.
Option& addEntriesOption(Command& command, std::vector<std::string>& entries, const char* standard = "all");

// The entries named, each once; all when no name is given. A name means the first entry that has exactly this
// name, else the first that is shown so (printableLine), else for #N the Nth entry of the file, else the
// first that has it but for case; "all" means all where no entry is called so. One that is not there is
// reported and makes `complete` false.
struct Selection {
    QList<document::Entry> entries;
    document::Problems problems; // problems of the file and of these entries
    bool complete = true;
};
Selection select(const Input& input, const std::vector<std::string>& names);

// Says the problems; InputProblems when one of them is an error.
ExitStatus reportAll(const document::Problems& problems, const QString& fileName);

// The entries to draw: those named, else the first that could be read. What cannot be
// drawn has been reported, as the problems of the entries and of the file have, unless `before`, an earlier
// answer for the same input, reported them.
struct ToDraw {
    std::vector<const document::Entry*> entries;
    ExitStatus status;                                 // InputProblems after an error
    std::vector<const document::Entry*> reported = {}; // entries with problems that have been printed
};
ToDraw entriesToDraw(const Input& input, const std::vector<std::string>& names,
                     const ToDraw* before = nullptr);

bool isLoaded(const document::Entry& entry);

} // namespace cli
