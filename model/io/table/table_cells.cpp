// SPDX-License-Identifier: MIT
#include "io/table/table_cells.h"

#include "io/text/number.h"
#include "io/text/plain_signs.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

bool isSeparator(QChar c, Separator separator) {
    switch (separator) {
    case Separator::Semicolon:
        return c == u';';
    case Separator::Tab:
        return c == u'\t';
    case Separator::Comma:
        return c == u',';
    case Separator::Blank:
        break;
    }
    return false;
}

// Up to the words behind the numbers, or a comment: their commas and blanks part nothing. A header stays.
QString withoutWords(const QString& line) {
    constexpr qsizetype fewest = 6;
    qsizetype numbers = 0;
    bool isInNumber = false;
    bool isInWord = false;
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QChar c = line[i];
        const bool isParted = c.isSpace() || c == u',' || c == u'\t' || c == u'"';
        const bool isEnd = c.isLetter() || c == u'#' || c == u'(' || (c == u'/' && line.mid(i, 2) == u"//");
        if (numbers >= fewest && isEnd && !isInNumber && !isInWord) return line.first(i);
        if (!isInNumber && !isInWord && !isParted) {
            isInWord = c.isLetter();
            isInNumber = !isInWord;
            if (isInNumber) ++numbers;
        } else if (isParted) {
            isInNumber = isInWord = false;
        }
    }
    return line;
}

class LineReader {
public:
    LineReader(QStringView text, int line, const Dialect& dialect)
        : m_text(text), m_line(line), m_dialect(dialect) {}

    Row read(qsizetype most) && {
        bool isField = false; // true if the current field has a cell
        skipBlanks();
        while (!atEnd() && m_cells.size() <= most) {
            if (isSeparator(m_text[m_at], m_dialect.separator)) {
                if (!isField) m_cells << cellHere();
                isField = false;
                advance();
            } else {
                Cell cell = m_text[m_at] == u'"' ? quoted() : plain();
                cell.isContinued = isField && m_dialect.separator != Separator::Blank;
                m_cells << cell;
                isField = true;
            }
            skipBlanks();
        }
        while (!m_cells.isEmpty() && m_cells.last().text.isEmpty())
            m_cells.removeLast();
        return std::move(m_cells);
    }

private:
    bool atEnd() const {
        return m_at >= m_text.size() ||
               (m_text[m_at] == u';' && m_dialect.separator != Separator::Semicolon) || atComment();
    }
    // True behind as many numbers as a map has. Directly behind a number, "%" belongs to the number.
    bool atComment() const {
        constexpr qsizetype fewest = 6;
        const QChar c = m_text[m_at];
        if (c != u'#' && c != u'%' && c != u'/' && c != u'-') return false;
        const bool isParted =
            m_at > 0 && (m_text[m_at - 1].isSpace() || isSeparator(m_text[m_at - 1], m_dialect.separator));
        if (m_cells.size() + (isParted ? 0 : 1) < fewest) return false;
        if (c == u'/') return m_at + 1 < m_text.size() && m_text[m_at + 1] == u'/';
        if (c == u'#') return true;
        if (c == u'-') return isParted && m_text.sliced(m_at).startsWith(u"-- ");
        const QStringView rest = m_text.sliced(m_at + 1);
        return isParted && !rest.trimmed().isEmpty() && !isSeparator(rest.front(), m_dialect.separator);
    }
    Cell cellHere() const { return {{}, m_line, m_column, false}; }

    void advance() {
        const char16_t c = m_text[m_at++].unicode();
        // Bytes in UTF-8; halves of a surrogate pair have 4 bytes together.
        m_column += c < 0x80 ? 1 : c < 0x800 || QChar::isSurrogate(c) ? 2 : 3;
    }

    void skipBlanks() {
        while (!atEnd() && m_text[m_at].isSpace() && !isSeparator(m_text[m_at], m_dialect.separator))
            advance();
    }

    Cell plain() {
        Cell cell = cellHere();
        for (; !atEnd() && !isSeparator(m_text[m_at], m_dialect.separator); advance()) {
            const bool isAfterSign = cell.text.size() == 1 && (isDash(cell.text[0]) || cell.text[0] == u'+');
            if (m_text[m_at].isSpace() && !(isAfterSign && isSettingBlank(m_text[m_at]))) break;
            if (!m_text[m_at].isSpace()) cell.text += m_text[m_at];
        }
        return cell;
    }

    // "" inside stands for a quotation mark. Without a closing mark, it is ordinary text.
    Cell quoted() {
        const qsizetype from = m_at;
        Cell cell = cellHere();
        for (qsizetype i = from + 1; i < m_text.size(); ++i) {
            const bool isMark = m_text[i] == u'"';
            const bool isDoubled = isMark && i + 1 < m_text.size() && m_text[i + 1] == u'"';
            if (isMark && !isDoubled) {
                while (m_at <= i)
                    advance();
                cell.text = cell.text.trimmed();
                return cell;
            }
            cell.text += m_text[i];
            if (isDoubled) ++i;
        }
        return plain();
    }

    QStringView m_text;
    int m_line;
    const Dialect& m_dialect;
    qsizetype m_at = 0;
    int m_column = 1;
    Row m_cells;
};

// Names of columns such as “e” and “phi” are constants as well; no column is called “pi”.
bool isName(QStringView text) {
    // Φ° is the name of a column.
    if (!text.isEmpty() && QStringView(u"°º˚").contains(text.back())) text.chop(1);
    const bool isWord = std::ranges::all_of(text, [](QChar c) { return c.isLetter(); });
    return isWord && text != u"π" && text.compare(u"pi", Qt::CaseInsensitive) != 0;
}

} // namespace

QString withoutOrnaments(QString text) {
    static const QRegularExpression ornament(
        QStringLiteral("^[ \\t]*(?:\\[\\d+,\\]|(?:\\[,\\d+\\][ \\t]*)+$|[*•‣▪◦●·][ \\t]+(?=[-+−.\\d])|"
                       "(?:\\d+[ \\t]+)?DATA[ \\t]+(?=[-+.\\d])|(?:\\d+[ \\t]+)?REM\\b[^\\n]*|"
                       "\\d+[x×]\\d+ [A-Z][^\\n:]{0,80}:$)"),
        QRegularExpression::MultilineOption);
    const auto mayBeOne = [](QChar c) { return QStringView(u"[*•‣▪◦●·Dx×R").contains(c); };
    if (std::ranges::none_of(text, mayBeOne)) return text;
    const QString source = text;
    for (auto found = ornament.globalMatch(source); found.hasNext();) {
        const auto match = found.next();
        for (qsizetype i = match.capturedStart(); i < match.capturedEnd(); ++i)
            text[i] = u' ';
    }
    return text;
}

// Words with at most two numbers, whose commas part neither cells nor digits.
static bool isSentence(const QString& line) {
    qsizetype words = 0, numbers = 0;
    for (const QStringView part : QStringView(line).tokenize(u' ')) {
        const auto letters = std::count_if(part.begin(), part.end(), [](QChar c) { return c.isLetter(); });
        words += letters >= 3;
        numbers += letters == 0 && std::any_of(part.begin(), part.end(), [](QChar c) { return c.isDigit(); });
    }
    return words >= 3 && numbers <= 2;
}

QList<Dialect> dialectsOf(QStringView text) {
    constexpr qsizetype minSeparators = 5;
    bool semicolons = false;
    bool tabs = false;
    bool commas = false; // true for commas outside comments
    bool blanks = false; // true for blanks between two signs other than commas
    for (const QStringView line : text.tokenize(u'\n')) {
        semicolons = semicolons || line.count(u';') >= minSeparators;
        tabs = tabs || line.trimmed().count(u'\t') >= minSeparators;
        const qsizetype comment = line.indexOf(u';');
        const QString content =
            withoutWords(line.first(comment < 0 ? line.size() : comment).toString().simplified());
        if (isSentence(content)) continue;
        commas = commas || content.contains(u',');
        for (qsizetype i = content.indexOf(u' '); i > 0 && !blanks; i = content.indexOf(u' ', i + 1))
            blanks = content[i - 1] != u',' && i + 1 < content.size() && content[i + 1] != u',';
    }
    if (semicolons) return {{Separator::Semicolon, text.contains(u',')}};
    if (tabs) return {{Separator::Tab, commas}};
    if (!commas) return {{Separator::Blank, false}};
    if (!blanks) return {{Separator::Comma, false}};
    return {{Separator::Comma, false, true}, {Separator::Blank, true}};
}

Row cellsOf(QStringView text, int line, const Dialect& dialect, qsizetype most) {
    return LineReader(text, line, dialect).read(most);
}

std::optional<double> numberIn(const Cell& cell, const Dialect& dialect, NumberUnit unit) {
    QString text = withPowersOfTen(plainSigns(cell.text));
    static const QRegularExpression accounting(QStringLiteral("^\\(\\d*[.,]?\\d+\\)$"));
    if (text.startsWith(u'(') && text.contains(accounting)) return std::nullopt; // (0.2) is −0.2 to some
    // Decimal comma: between separating commas, only quotation marks could enclose it.
    if (dialect.decimalComma || dialect.separator == Separator::Comma) {
        if (dialect.decimalComma && text.contains(u'.')) return std::nullopt;
        if (text.contains(u'.') && text.contains(u',')) return std::nullopt;
        text.replace(u',', u'.');
    }
    const qsizetype sign = text.startsWith(u'-') || text.startsWith(u'+') ? 1 : 0;
    if (text.size() == sign + 1) { // ½ → 1⁄2; 1½ is not a fraction
        const QString parts = text.normalized(QString::NormalizationForm_KD);
        if (parts.contains(QChar(0x2044))) text = parts;
    }
    text.replace(QChar(0x2044), u'/');
    const qsizetype slash = text.indexOf(u'/');
    if (slash < 0) return isName(text) ? parseNumber(text) : evaluate(text, unit);
    const auto numerator = parseNumber(text.left(slash));
    const auto denominator = parseNumber(text.mid(slash + 1));
    if (!numerator || !denominator) return evaluate(text, unit);
    return std::isfinite(*numerator / *denominator) ? std::optional(*numerator / *denominator) : std::nullopt;
}

} // namespace io
