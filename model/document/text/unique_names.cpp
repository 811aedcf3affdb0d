// SPDX-License-Identifier: MIT
#include "document/text/unique_names.h"

#include "document/text/file_names.h"

#include <algorithm>

namespace document {

namespace {

constexpr qsizetype maxName = 18; // bytes that Fractint 19, 20 and Iterated Dynamics compare

QString legalName(const QString& name) {
    QString legal;
    for (const QChar c : name.trimmed()) {
        if (c.isSpace() || c == QLatin1Char(':'))
            legal += QLatin1Char('_'); // prefixes such as "ifs:" or "par:" would hide the entry
        else if (c.isPrint() || c.isSurrogate())
            legal += QStringLiteral("(){};").contains(c) ? QString() : QString(c);
    }
    legal = cutTo(legal, maxName);
    if (legal.isEmpty()) return QStringLiteral("fractal");
    const bool isCommentWord = legal.compare(QLatin1String("comment"), Qt::CaseInsensitive) == 0;
    return isCommentWord ? legal + QLatin1Char('_') : legal;
}

} // namespace

void UniqueNames::take(const QString& name) {
    m_taken.insert(name.toCaseFolded());
}

QString UniqueNames::give(const QString& name) {
    const QString legal = legalName(name);
    QString candidate = legal;
    int& number = m_numbers[legal.toCaseFolded()];
    for (number = std::max(number, 2); m_taken.contains(candidate.toCaseFolded()); ++number) {
        const QString suffix = QStringLiteral("_%1").arg(number);
        candidate = cutTo(legal, maxName - suffix.size()) + suffix;
    }
    take(candidate);
    return candidate;
}

} // namespace document
