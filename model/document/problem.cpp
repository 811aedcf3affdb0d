// SPDX-License-Identifier: MIT
#include "document/problem.h"

#include <algorithm>

namespace document {

bool callsForAttention(const Problem& problem) {
    return problem.severity != Problem::Severity::Remark;
}

bool callsForAttention(const Problems& problems) {
    return std::ranges::any_of(problems, [](const Problem& problem) { return callsForAttention(problem); });
}

QString toText(const Problem& problem, const QString& fileName) {
    const QString severity =
        problem.severity == Problem::Severity::Error ? QStringLiteral("error") : QStringLiteral("warning");
    const QString name = QStringLiteral("“%1”").arg(problem.entry);
    const bool isNamed = problem.entry.isEmpty() || problem.message.startsWith(name);
    const QString entry = isNamed ? QString() : name + QStringLiteral(": ");
    if (problem.line == 0)
        return QStringLiteral("%1: %2: %3%4").arg(fileName, severity, entry, problem.message);
    // Single call of arg(), because the name of a file may contain “%4”.
    return QStringLiteral("%1:%2:%3: %4: %5%6")
        .arg(fileName, QString::number(problem.line), QString::number(problem.column), severity, entry,
             problem.message);
}

} // namespace document
