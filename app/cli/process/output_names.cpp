// SPDX-License-Identifier: MIT
#include "process/output_names.h"

#include <QFileInfo>

namespace cli {

namespace {

// Where the name of the file begins. Those of its folders are no patterns.
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

// Without what leads to another folder, or changes the order in which a name is read.
QString harmless(QString name) {
    for (QChar& c : name)
        if (c == u'/' || c.category() == QChar::Other_Control || c.category() == QChar::Other_Format)
            c = u'_';
    return name.isEmpty() ? QStringLiteral("_") : name;
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

QString outputFor(const QString& pattern, const OutputName& name) {
    const qsizetype start = startOfName(pattern);
    QString result = pattern.left(start);
    for (qsizetype i = start; i < pattern.size(); ++i) {
        const QChar letter = pattern[i] == u'%' && i + 1 < pattern.size() ? pattern[i + 1] : QChar();
        const QChar known = letter == u'i' && !name.iterations ? QChar() : letter;
        switch (known.unicode()) {
        case u'e':
            result += harmless(name.entry);
            break;
        case u'n':
            result += padded(name.number, name.numbers);
            break;
        case u'f':
            result += harmless(name.file == u"-" ? QStringLiteral("standard-input")
                                                 : QFileInfo(name.file).completeBaseName());
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

} // namespace cli
