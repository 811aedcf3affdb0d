// SPDX-License-Identifier: MIT
#include "process/output_names.h"

#include "document/text/file_names.h"

#include <QFileInfo>

#include <algorithm>

namespace cli {

namespace {

// Start of the file name. Names of folders are no patterns.
qsizetype startOfName(const QString& path) {
    return path.lastIndexOf(u'/') + 1;
}

// The letters of the placeholders, in order.
QString letters(const QString& pattern) {
    QString found;
    for (qsizetype i = startOfName(pattern); i + 1 < pattern.size(); ++i)
        if (pattern[i] == u'%') found += pattern[++i];
    return found;
}

QString padded(int number, int largest) {
    return QString::number(number).rightJustified(QString::number(largest).size(), u'0');
}

} // namespace

bool hasPlaceholders(const QString& pattern) {
    const QString found = letters(pattern);
    return found.contains(u'e') || found.contains(u'n') || found.contains(u'f');
}

bool hasIterations(const QString& pattern) {
    return letters(pattern).contains(u'i');
}

namespace {

// `maxPart` is how many bytes of a name of an entry or a file are taken.
QString filledIn(const QString& pattern, const OutputName& name, qsizetype maxPart) {
    const qsizetype start = startOfName(pattern);
    QString result = pattern.left(start);
    for (qsizetype i = start; i < pattern.size(); ++i) {
        const QChar letter = pattern[i] == u'%' && i + 1 < pattern.size() ? pattern[i + 1] : QChar();
        const QChar known = letter == u'i' && !name.iterations ? QChar() : letter;
        switch (known.unicode()) {
        case u'e':
            result += document::fileNamePart(name.entry, maxPart);
            break;
        case u'n':
            result += padded(name.number, name.numbers);
            break;
        case u'f':
            result += document::fileNamePart(name.file == u"-" ? QStringLiteral("standard-input")
                                                               : QFileInfo(name.file).completeBaseName(),
                                             maxPart);
            break;
        case u'i':
            result += padded(*name.iterations, name.maxIterations);
            break;
        case u'%':
            result += u'%';
            break;
        default:
            result += pattern[i];
            continue;
        }
        ++i;
    }
    return result;
}

} // namespace

// Names that would be too long are cut, as long as the rest of the pattern leaves room.
QString outputFor(const QString& pattern, const OutputName& name) {
    const auto size = [&](const QString& path) { return path.sliced(startOfName(path)).toUtf8().size(); };
    const QString whole = filledIn(pattern, name, document::maxFileName);
    if (size(whole) <= document::maxFileName) return whole;
    const QString found = letters(pattern);
    const qsizetype parts = found.count(u'e') + found.count(u'f');
    if (parts == 0) return whole;
    const qsizetype rest = size(filledIn(pattern, name, 1)) - parts;
    return filledIn(pattern, name, std::max<qsizetype>((document::maxFileName - rest) / parts, 1));
}

} // namespace cli
