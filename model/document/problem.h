// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

namespace document {

// Something a reader found: a whole sentence for the user, and where.
struct Problem {
    // Severity of a problem. A remark looks like a warning but calls for no attention: nothing needs mending.
    enum class Severity { Remark, Warning, Error };

    Severity severity = Severity::Warning;
    QString entry;  // name of the entry; empty: the whole file
    int line = 0;   // 1-based; 0: no single place
    int column = 0; // 1-based, in bytes
    QString message;

    friend bool operator==(const Problem&, const Problem&) = default;
};
using Problems = QList<Problem>;

bool callsForAttention(const Problem& problem);   // false for remarks only
bool callsForAttention(const Problems& problems); // true if one of them does

// "file:line:column: error: sentence"
QString toText(const Problem& problem, const QString& fileName);

} // namespace document
