// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <optional>

// The output of a command that writes several files: in its last part, the name of the file, %e is the name
// of the entry, %n its number, %f the name of its file without folder and suffix, %i the number of
// iterations, and
// %% a per cent sign. In the names of folders, % is a letter.
namespace cli {

struct OutputName {
    QString entry;
    int number = 1;  // position of the entry in its file
    int numbers = 1; // largest such number in the file; sets the digits of %n
    QString file;
    std::optional<int> iterations;
    int maxIterations = 0;
};

bool hasPlaceholders(const QString& pattern); // true for %e, %n or %f, which give each entry its own file
bool hasIterations(const QString& pattern);   // true for %i

// Names of entries and files as document::fileNamePart() has them.
QString outputFor(const QString& pattern, const OutputName& name);

} // namespace cli
