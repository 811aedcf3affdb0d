// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

// The files that this call reads, whatever for. What a command writes holds less than they do, so that it
// replaces none of them. Whoever reads a file that the user named says so here, and whoever writes one asks.
namespace cli {

void noteRead(const QString& path);
void forgetFilesRead();

// Throws UsageError when the output is one of these files, by whatever name.
void refuseToReplaceInput(const QString& output);

// The files that this call has written are not replaced by what it writes under other names, through links.
void noteWritten(const QString& output);
// Throws UsageError when the output leads to one of these files.
void refuseToReplaceOutput(const QString& output);

} // namespace cli
