// SPDX-License-Identifier: MIT
#include "document/text/file_names.h"

#include <QChar>

namespace document {

namespace {

bool isSeen(char32_t c) {
    switch (QChar::category(c)) {
    case QChar::Other_Control:
    case QChar::Other_Format: // marks that change the direction of a text, and zero-width blanks
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
        return false;
    default:
        return true;
    }
}

// Walks code points, because invisible ones may take two code units. Halves alone are bytes that are no
// UTF-8.
template <class Keeps> QString withUnderscores(const QString& text, const Keeps& keeps) {
    QString kept;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool isPair = text[i].isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate();
        const char32_t c =
            isPair ? QChar::surrogateToUcs4(text[i], text[i + 1]) : char32_t(text[i].unicode());
        kept += keeps(c) ? text.sliced(i, isPair ? 2 : 1) : QStringLiteral("_");
        if (isPair) ++i;
    }
    return kept;
}

} // namespace

QString cutTo(QString text, qsizetype bytes) {
    if (text.size() > bytes) { // each letter takes at least one byte
        text.truncate(bytes);
        if (!text.isEmpty() && text.back().isHighSurrogate()) text.chop(1);
    }
    while (text.toUtf8().size() > bytes)
        text.chop(text.back().isLowSurrogate() ? 2 : 1);
    return text;
}

QString fileNamePart(const QString& text, qsizetype maxBytes) {
    QString part = withUnderscores(text, [](char32_t c) { return c != U'/' && isSeen(c); });
    if (part.startsWith(u'.')) part[0] = u'_';
    part = cutTo(part, maxBytes);
    return part.trimmed().isEmpty() ? QStringLiteral("_") : part;
}

QString oneLine(const QString& text) {
    return withUnderscores(text, isSeen);
}

} // namespace document
