// SPDX-License-Identifier: MIT
#pragma once

#include "exit_status.h"

#include "io/collection_reader.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace cli {

struct Input {
    QString name; // as given, "-" for standard input
    QByteArray bytes;
    io::Collection collection;
};

// Reads FILE; nullopt when it cannot be read, which has then been reported.
std::optional<Input> readInput(const std::string& file, const io::ReadOptions& options = {});

// The entries named, compared without case, the first of each name, each once; all when no name is given. A
// name that is not there is reported and makes `complete` false.
struct Selection {
    QList<document::Entry> entries;
    document::Problems problems; // of the file and of these entries
    bool complete = true;
};
Selection select(const Input& input, const std::vector<std::string>& names);

// Says the problems; InputProblems when one of them is an error.
ExitStatus reportAll(const document::Problems& problems, const QString& fileName);

// The entry to draw: the one named, else the first that could be read and lies in the plane. nullptr when
// there is none, which has then been reported, as its problems and those of the file are.
struct ToDraw {
    const document::Entry* entry;
    ExitStatus status; // InputProblems after an error
};
ToDraw entryToDraw(const Input& input, const std::string& name);

bool isLoaded(const document::Entry& entry);

} // namespace cli
