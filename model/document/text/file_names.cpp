// SPDX-License-Identifier: MIT
#include "document/text/file_names.h"

#include <QChar>

namespace document {

namespace {

// Letters, marks and blanks that fonts leave out or draw as nothing, by Unicode's property
// Default_Ignorable_Code_Point and the empty pattern of Braille.
bool isLeftOut(char32_t c) {
    const auto isIn = [c](char32_t first, char32_t last) { return first <= c && c <= last; };
    return c == 0x034f || isIn(0x115f, 0x1160) || isIn(0x17b4, 0x17b5) || isIn(0x180b, 0x180f) ||
           c == 0x2065 || c == 0x2800 || c == 0x3164 || isIn(0xfe00, 0xfe0e) || c == 0xffa0 ||
           isIn(0xfff0, 0xfff8) || isIn(0xe0000, 0xe0fff);
}

bool isSeen(char32_t c) {
    if (isLeftOut(c)) return false;
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

// Asks for an emoji in colours; where there is none before it, nobody sees it.
constexpr char32_t inColours = 0xfe0f;

bool mayBeInColours(char32_t c) {
    return QChar::category(c) == QChar::Symbol_Other || QChar::category(c) == QChar::Number_DecimalDigit;
}

// Walks code points, because invisible ones may take two code units. Halves alone are bytes that are no
// UTF-8.
template <class Keeps> QString withUnderscores(const QString& text, const Keeps& keeps) {
    QString kept;
    char32_t before = 0;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool isPair = text[i].isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate();
        const char32_t c =
            isPair ? QChar::surrogateToUcs4(text[i], text[i + 1]) : char32_t(text[i].unicode());
        const bool isLost = c == inColours && !mayBeInColours(before);
        before = c;
        kept += keeps(c) && !isLost ? text.sliced(i, isPair ? 2 : 1) : QStringLiteral("_");
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
    // The replacement character would mean that Qt could not read the name.
    QString part = withUnderscores(
        text, [](char32_t c) { return c != U'/' && c != QChar::ReplacementCharacter && isSeen(c); });
    if (part.startsWith(u'.')) part[0] = u'_';
    part = cutTo(part, maxBytes);
    return part.trimmed().isEmpty() ? QStringLiteral("_") : part;
}

QString oneLine(const QString& text) {
    return withUnderscores(text, isSeen);
}

} // namespace document
