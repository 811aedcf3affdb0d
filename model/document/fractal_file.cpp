// SPDX-License-Identifier: MIT
#include "document/fractal_file.h"

#include <algorithm>

namespace document {

namespace {

constexpr qsizetype longestName = 18; // bytes that Fractint 19, 20 and Iterated Dynamics compare

bool isTaken(const FractalFile& file, const QString& name, EntryId except) {
    return std::any_of(file.entries.begin(), file.entries.end(), [&](const Entry& entry) {
        return entry.id != except && entry.fractal->name.compare(name, Qt::CaseInsensitive) == 0;
    });
}

QString cutTo(QString name, qsizetype bytes) {
    while (name.toUtf8().size() > bytes)
        name.chop(name.back().isLowSurrogate() ? 2 : 1);
    return name;
}

QString legalName(const QString& name) {
    QString legal;
    for (const QChar c : name.trimmed()) {
        if (c.isSpace() || c == QLatin1Char(':'))
            legal += QLatin1Char('_'); // "ifs:", "par:" … would hide the entry
        else if (c.isPrint() || c.isSurrogate())
            legal += QStringLiteral("(){};").contains(c) ? QString() : QString(c);
    }
    legal = cutTo(legal, longestName);
    if (legal.isEmpty()) return QStringLiteral("fractal");
    const bool isCommentWord = legal.compare(QLatin1String("comment"), Qt::CaseInsensitive) == 0;
    return isCommentWord ? legal + QLatin1Char('_') : legal;
}

} // namespace

bool operator==(const Entry& a, const Entry& b) {
    return a.id == b.id && a.source == b.source && a.problems == b.problems &&
           (a.fractal == b.fractal || *a.fractal == *b.fractal);
}

bool operator==(const FractalFile& a, const FractalFile& b) {
    return a.entries == b.entries && a.head == b.head && a.tail == b.tail && a.lineEnd == b.lineEnd &&
           a.problems == b.problems;
}

EntryId freshId(const FractalFile& file) {
    std::uint32_t largest = 0;
    for (const Entry& entry : file.entries)
        largest = std::max(largest, static_cast<std::uint32_t>(entry.id));
    return static_cast<EntryId>(largest + 1);
}

qsizetype indexOf(const FractalFile& file, EntryId id) {
    const auto found = std::find_if(file.entries.begin(), file.entries.end(),
                                    [id](const Entry& entry) { return entry.id == id; });
    return found == file.entries.end() ? -1 : found - file.entries.begin();
}

QString uniqueName(const FractalFile& file, const QString& name, EntryId except) {
    return uniqueName(name, [&](const QString& candidate) { return isTaken(file, candidate, except); });
}

QString uniqueName(const QString& name, const std::function<bool(const QString&)>& isTaken) {
    const QString legal = legalName(name);
    QString candidate = legal;
    for (int number = 2; isTaken(candidate); ++number) {
        const QString suffix = QStringLiteral("_%1").arg(number);
        candidate = cutTo(legal, longestName - suffix.size()) + suffix;
    }
    return candidate;
}

FractalFile fileOf(Fractal fractal) {
    FractalFile file;
    file.entries.append({freshId(file), std::make_shared<const Fractal>(std::move(fractal)), nullptr, {}});
    return file;
}

} // namespace document
