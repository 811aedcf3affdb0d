// SPDX-License-Identifier: MIT
#include "io/text/literal_lists.h"

#include "io/text/number.h"
#include "io/text/plain_signs.h"

#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <utility>

namespace io {

namespace {

constexpr int maxDepth = 64;
constexpr qsizetype maxItems = 2'000'000;
constexpr qsizetype maxKey = 200;

bool isWordLetter(QChar c) {
    return c.isLetterOrNumber() || c == u'_' || c == u'$' || c == u'.';
}

QChar closing(QChar open) {
    return open == u'(' ? u')' : open == u'[' ? u']' : u'}';
}

class ListParser {
public:
    explicit ListParser(QStringView text) : m_text(text) {}

    Literals read() && {
        Literals literals;
        while (!isAtEnd()) {
            readItems(literals.root, QChar(), 0);
            ++m_at; // unmatched closing bracket
        }
        literals.isCut = m_isCut;
        return literals;
    }

private:
    bool isAtEnd() const { return m_at >= m_text.size() || m_isCut; }
    QChar at(qsizetype offset = 0) const {
        return m_at + offset < m_text.size() ? m_text[m_at + offset] : QChar();
    }

    // Reads up to the end of the list, or to an unmatched closing bracket.
    void readItems(Literal& list, QChar end, int depth) {
        QString key;
        QString word; // last word, which may name a list or be a key
        const auto flush = [&] {
            if (!word.isEmpty() && depth > 0) add(list, {Literal::Kind::Other, 0, key, word, {}});
            if (!word.isEmpty()) key.clear();
            word.clear();
        };
        while (!isAtEnd()) {
            const QChar c = at();
            if (c == u')' || c == u']' || c == u'}') break;
            if (c.isSpace() || c == u',' || c == u';') {
                // Blanks in "k :" and "f (…)" do not end an item.
                if (c == u',' || c == u';' || c == u'\n') flush();
                ++m_at;
            } else if (c == u':' || c == u'=' || (c == u'<' && at(1) == u'-')) {
                key = word.isEmpty() ? nameOfDimensions(list) : std::exchange(word, {});
                while (QStringView(u":=<>").contains(at()) || (at() == u'-' && m_text[m_at - 1] == u'<'))
                    ++m_at;
            } else if (beginsComment()) {
                skipComment();
            } else if (c == u'"' || c == u'\'') {
                flush();
                readText(list, key, word);
            } else if (c == u'(' || c == u'[' || c == u'{') {
                readList(list, std::exchange(key, {}), std::exchange(word, {}), depth);
            } else if (const auto number = readNumber()) {
                flush();
                const Literal::Kind kind = isOperator(at()) ? Literal::Kind::Other : Literal::Kind::Number;
                const bool isItem = depth > 0 || !key.isEmpty();
                if (isItem) add(list, {kind, *number, std::exchange(key, {}), {}, {}});
                m_number = {*number, m_at, isItem ? m_items : -1};
            } else if (isWordLetter(c)) {
                flush();
                word = readWord();
            } else {
                flush();
                if (depth > 0) add(list, {Literal::Kind::Other, 0, std::exchange(key, {}), {}, {}});
                ++m_at;
            }
        }
        flush();
        if (at() == end && !end.isNull()) ++m_at;
    }

    // Name in "a[4] = …" and "a[] = …" of the following list; the brackets have no contents.
    static QString nameOfDimensions(Literal& list) {
        QString name;
        while (!list.items.isEmpty()) {
            const Literal& last = list.items.last();
            const bool isSize = last.kind == Literal::Kind::List && last.key.isEmpty() &&
                                last.items.size() <= 1 &&
                                (last.items.isEmpty() || last.items[0].items.isEmpty());
            if (!isSize) break;
            name = last.text;
            list.items.removeLast();
            if (!name.isEmpty()) break;
        }
        return name;
    }

    static bool isOperator(QChar c) { return c == u'*' || c == u'/' || c == u'^' || c == u'+' || c == u'-'; }

    void add(Literal& list, Literal&& item) {
        if (++m_items > maxItems) {
            m_isCut = true;
            return;
        }
        list.items.append(std::move(item));
    }

    void readList(Literal& list, QString&& key, QString&& name, int depth) {
        const QChar open = at();
        ++m_at;
        Literal item{Literal::Kind::List, 0, std::move(key), std::move(name), {}};
        if (depth >= maxDepth) {
            m_isCut = true;
            return;
        }
        m_lines += int(m_text.sliced(m_counted, m_at - m_counted).count(u'\n'));
        m_counted = m_at;
        item.line = m_lines + 1;
        const auto before = factorBefore(list, item);
        readItems(item, closing(open), depth + 1);
        const auto behind = factorBehind();
        const bool isOne = item.items.isEmpty() || // dimensions, or an argument
                           (item.items.size() == 1 && item.items[0].kind != Literal::Kind::List);
        if (before && behind)
            scale(item, *before * *behind);
        else if (!isOne)
            item.kind = Literal::Kind::Other; // a product with something that is not read
        makeFraction(item);
        add(list, std::move(item));
    }

    bool isBlank(qsizetype i) const { return i >= 0 && (m_text[i] == u' ' || m_text[i] == u'\t'); }
    static bool isTimes(QChar c) { return c == u'*' || c == u'·' || c == u'×'; }

    // The number that multiplies the list whose bracket was read: 0.5*[…], 1/2 {…}. 1 without one; none for
    // another factor. The number is taken from the items before it.
    std::optional<double> factorBefore(Literal& list, Literal& item) {
        const bool isNamed = !item.text.isEmpty();
        const qsizetype begin = isNamed ? m_word : m_at - 1;
        qsizetype i = begin;
        while (isBlank(i - 1))
            --i;
        const QChar sign = i > 0 ? m_text[i - 1] : QChar();
        const bool isBeside = !isNamed && m_text[m_at - 1] == u'{' && i == m_number.end && i < begin;
        if (isDash(sign) && i > 1) {
            qsizetype left = i - 1;
            while (isBlank(left - 1))
                --left;
            return left > 0 && m_text[left - 1] == u'=' ? -1 : 1;
        }
        if (!isTimes(sign) && !isBeside) return 1;
        if (isTimes(sign)) --i;
        while (isTimes(sign) && isBlank(i - 1))
            --i;
        if (i == 0 || QStringView(u"*/(,[{=:").contains(m_text[i - 1])) return 1; // *arguments
        if (i != m_number.end) return std::nullopt;
        if (m_number.items == m_items && !list.items.isEmpty() && list.items.last().items.isEmpty()) {
            item.key = list.items.last().key;
            list.items.removeLast();
        }
        return m_number.value;
    }

    // The number behind the list that was read, [1, 2]/3. 1 without one; none for another factor.
    std::optional<double> factorBehind() {
        qsizetype i = m_at;
        while (i < m_text.size() && isBlank(i))
            ++i;
        if (i + 1 >= m_text.size()) return 1;
        const bool isOver = m_text[i] == u'/';
        const QChar next = m_text[i + 1];
        if ((!isOver && !isTimes(m_text[i])) || QStringView(u"*/)").contains(next)) return 1;
        ++i;
        while (i < m_text.size() && isBlank(i))
            ++i;
        const auto factor = digitsAt(i);
        if (!factor) return std::nullopt;
        m_at = factor->end;
        return isOver ? 1 / factor->value : factor->value;
    }

    static void scale(Literal& list, double factor) {
        if (factor == 1) return;
        for (Literal& item : list.items) {
            item.number *= factor;
            scale(item, factor);
        }
    }

    // Rational(1, 2) of SymPy and Fraction(1, 2) of Python.
    static void makeFraction(Literal& item) {
        const bool isFraction =
            item.text.endsWith(QStringLiteral("Rational")) || item.text.endsWith(QStringLiteral("Fraction"));
        if (!isFraction || item.items.size() != 2 || item.items[1].number == 0 ||
            item.items[0].kind != Literal::Kind::Number || item.items[1].kind != Literal::Kind::Number)
            return;
        item.kind = Literal::Kind::Number;
        item.number = item.items[0].number / item.items[1].number;
        item.items.clear();
    }

    // Reads a key if a colon follows, else a text, which ends with the line.
    void readText(Literal& list, QString& key, QString& word) {
        const QChar mark = at();
        qsizetype end = m_at + 1;
        while (m_at >= m_openUntil && end < m_text.size() && m_text[end] != mark && m_text[end] != u'\n')
            end += m_text[end] == u'\\' ? 2 : 1;
        if (m_at < m_openUntil || end >= m_text.size() || m_text[end] != mark) {
            m_openUntil = std::max(m_openUntil, end); // apostrophe: avoids another search of this line
            ++m_at;
            return;
        }
        const QString text = m_text.sliced(m_at + 1, end - m_at - 1).left(maxKey).toString();
        m_at = end + 1;
        qsizetype next = m_at;
        while (next < m_text.size() && m_text[next].isSpace())
            ++next;
        if (next < m_text.size() && (m_text[next] == u':' || m_text[next] == u'='))
            word = text;
        else if (const auto number = parseNumber(text)) // "0.5" of a form
            add(list, {Literal::Kind::Number, *number, std::exchange(key, {}), text, {}});
        else
            add(list, {Literal::Kind::Text, 0, std::exchange(key, {}), text, {}});
    }

    QString readWord() {
        const qsizetype begin = m_word = m_at;
        while (m_at < m_text.size() && isWordLetter(at()))
            ++m_at;
        return m_text.sliced(begin, m_at - begin).left(maxKey).toString();
    }

    bool beginsComment() const {
        const QChar c = at();
        const QChar next = at(1);
        return c == u'#' || (c == u'/' && (next == u'/' || next == u'*')) || (c == u'(' && next == u'*') ||
               (c == u'-' && next == u'-' && at(2).isSpace()); // "--" of Lua
    }

    void skipComment() {
        const bool isBlock = at(1) == u'*';
        const QStringView close = at() == u'(' ? u"*)" : u"*/";
        const qsizetype end = isBlock ? m_text.indexOf(close, m_at + 2) : m_text.indexOf(u'\n', m_at);
        m_at = end < 0 ? m_text.size() : end + (isBlock ? 2 : 0);
    }

    // Reads digits with sign, point and exponent, possibly a fraction, and the suffix f of a float.
    std::optional<double> readNumber() {
        const auto first = digitsAt(m_at);
        if (!first) return std::nullopt;
        qsizetype end = first->end;
        double value = first->value;
        if (end < m_text.size() && m_text[end] == u'/')
            if (const auto second = digitsAt(end + 1); second && second->value != 0) {
                value /= second->value;
                end = second->end;
            }
        if (end < m_text.size() && (m_text[end] == u'f' || m_text[end] == u'F') &&
            (end + 1 >= m_text.size() || !isWordLetter(m_text[end + 1])))
            ++end;
        if (end < m_text.size() && isWordLetter(m_text[end])) return std::nullopt; // such as 2x
        m_at = end;
        return value;
    }

    struct Digits {
        double value;
        qsizetype end;
    };
    std::optional<Digits> digitsAt(qsizetype begin) const {
        qsizetype end = begin;
        const auto letter = [&](qsizetype i) { return i < m_text.size() ? m_text[i] : QChar(); };
        if (isDash(letter(end)) || letter(end) == u'+') ++end;
        const qsizetype digits = end;
        const auto isDigit = [&](qsizetype i) { return letter(i) >= u'0' && letter(i) <= u'9'; };
        if (!isDigit(end) && !(letter(end) == u'.' && isDigit(end + 1))) return std::nullopt;
        while (isDigit(end) || letter(end) == u'.')
            ++end;
        if (letter(end) == u'e' || letter(end) == u'E') {
            const qsizetype exponent = end + (letter(end + 1) == u'-' || letter(end + 1) == u'+' ? 2 : 1);
            if (isDigit(exponent)) {
                end = exponent;
                while (isDigit(end))
                    ++end;
            }
        }
        const auto value = parseNumber(m_text.sliced(digits, end - digits));
        if (!value) return std::nullopt;
        const bool isNegative = digits > begin && letter(begin) != u'+';
        return Digits{isNegative ? -*value : *value, end};
    }

    QStringView m_text;
    qsizetype m_at = 0;
    qsizetype m_items = 0;
    qsizetype m_word = 0; // beginning of the last word
    // The last number that was read.
    struct {
        double value = 0;
        qsizetype end = -1;
        qsizetype items = -1; // how many items there were with it; -1: it is none
    } m_number;
    int m_lines = 0; // line ends before m_counted
    qsizetype m_counted = 0;
    qsizetype m_openUntil = 0; // end of the text in which quotation marks are ordinary signs
    bool m_isCut = false;
};

} // namespace

Literals literalsIn(const QString& text) {
    if (!text.contains(u'`') && !text.contains(u"*^")) return ListParser(text).read();
    // Mathematica writes the digits it vouches for behind a number, 0.16`15, and *^ for an exponent.
    static const QRegularExpression precision(QStringLiteral("(?<=[\\d.])`+[\\d.]*"));
    static const QRegularExpression power(QStringLiteral("(?<=[\\d.])\\*\\^(?=-?\\d)"));
    const QString plain = QString(text).remove(precision).replace(power, QStringLiteral("e"));
    return ListParser(plain).read();
}

} // namespace io
