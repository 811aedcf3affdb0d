// SPDX-License-Identifier: MIT
#include "io/text/affine_expression.h"

#include "io/text/expression.h"
#include "io/text/number.h"
#include "io/text/plain_signs.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr int maxParentheses = 32;

class AffineParser {
public:
    explicit AffineParser(QStringView text) : m_text(text) {}

    std::optional<AffineExpression> read() && {
        auto sum = readSum(0);
        if (sum) sum->end = m_at;
        return m_isBroken ? std::nullopt : sum;
    }

private:
    using Value = AffineExpression;

    QChar at(qsizetype offset = 0) const {
        return m_at + offset < m_text.size() ? m_text[m_at + offset] : QChar();
    }
    void skipBlanks() {
        while (at() == u' ' || at() == u'\t' || at() == u'\u00a0' || isSettingBlank(at()))
            ++m_at;
    }
    static bool isTimes(QChar c) { return c == u'*' || c == u'·' || c == u'×' || c == u'⋅'; }

    std::optional<Value> readSum(int depth) {
        if (depth > maxParentheses) return std::nullopt;
        std::optional<Value> sum;
        for (;;) {
            const qsizetype before = m_at;
            skipBlanks();
            double sign = 1;
            bool hasSign = false;
            while (isDash(at()) || at() == u'+') {
                if (isDash(at())) sign = -sign;
                hasSign = true;
                ++m_at;
                skipBlanks();
            }
            if (sum && !hasSign) {
                m_at = before;
                return sum;
            }
            const auto term = readTerm(depth);
            if (!term) {
                m_at = before;
                return sum;
            }
            if (!sum) sum = Value();
            add(*sum, *term, sign);
        }
    }

    // Returns true if a name begins there, behind blanks.
    bool wordAt(qsizetype i) const {
        while (i < m_text.size() && m_text[i].isSpace())
            ++i;
        return i < m_text.size() && m_text[i].isLetter();
    }

    static void add(Value& sum, const Value& term, double sign) {
        for (std::size_t i = 0; i < 3; ++i)
            sum.factors[i] += sign * term.factors[i];
        sum.shift += sign * term.shift;
        sum.usesZ = sum.usesZ || term.usesZ;
    }

    std::optional<Value> readTerm(int depth) {
        bool endsInNumber = at().isDigit() || at() == u'.';
        auto product = readFactor(depth);
        while (product) {
            const qsizetype before = m_at;
            skipBlanks();
            const bool isDivided = at() == u'/' && at(1) != u'/';
            const bool isTimed = isTimes(at());
            if (isDivided || isTimed) ++m_at;
            skipBlanks();
            const bool hasSign = (isDivided || isTimed) && isDash(at());
            if (hasSign) ++m_at;
            if (!isDivided && !isTimed && at() == u'[') { // "x[0]" is a coordinate of a point
                m_at = before;
                return product;
            }
            const bool isApart = m_at > before && !isDivided && !isTimed;
            const bool isNumber = at().isDigit() || at() == u'.';
            if (!isDivided && !isTimed && endsInNumber && at() == u'.' && at(1).isDigit()) return broken();
            auto factor = !isDivided && !isTimed && at().isDigit() ? std::nullopt : readFactor(depth);
            endsInNumber = isNumber;
            const bool isWord = before < m_text.size() && wordAt(before);
            if (!factor || (isApart && factor->isConstant() && !isWord)) { // number of an equation: "x (2)"
                m_at = before;
                break;
            }
            if (hasSign) {
                Value negative;
                add(negative, *factor, -1);
                factor = negative;
            }
            product = isDivided ? divided(*product, *factor) : multiplied(*product, *factor);
        }
        return product;
    }

    std::optional<Value> multiplied(const Value& left, const Value& right) {
        if (!left.isConstant() && !right.isConstant()) return broken();
        const Value& value = left.isConstant() ? right : left;
        const double factor = left.isConstant() ? left.shift : right.shift;
        Value product;
        add(product, value, factor);
        product.usesZ = left.usesZ || right.usesZ;
        return product;
    }

    std::optional<Value> divided(const Value& above, const Value& below) {
        if (!below.isConstant() || below.shift == 0) return broken();
        Value quotient = above;
        for (double& factor : quotient.factors)
            factor /= below.shift;
        quotient.shift /= below.shift;
        return quotient;
    }

    std::optional<Value> broken() {
        m_isBroken = true;
        return std::nullopt;
    }

    std::optional<Value> readFactor(int depth) {
        auto base = readBase(depth);
        if (!base) return std::nullopt;
        const qsizetype before = m_at;
        skipBlanks();
        const bool isPower = at() == u'^' || (at() == u'*' && at(1) == u'*');
        const bool isSquare = at() == u'²' || at() == u'³';
        if (!isPower && !isSquare) {
            m_at = before;
            return base;
        }
        if (!base->isConstant()) return broken();
        if (isSquare) {
            base->shift = std::pow(base->shift, at() == u'²' ? 2 : 3);
            ++m_at;
            return base;
        }
        m_at += at() == u'^' ? 1 : 2;
        skipBlanks();
        const bool isNegative = isDash(at());
        if (isNegative) ++m_at;
        const auto power = readBase(depth);
        if (!power || !power->isConstant()) return broken();
        base->shift = std::pow(base->shift, isNegative ? -power->shift : power->shift);
        return base;
    }

    std::optional<Value> readBase(int depth) {
        const QChar c = at();
        if (c == u'(' || c == u'[' || c == u'{') return readGroup(depth);
        if (c.isDigit() || (c == u'.' && at(1).isDigit())) return readNumber();
        if (c == u'π' || c == u'√') return readSign(depth);
        if (!c.isLetter() && c.script() != QChar::Script_Latin) return readFraction();
        return readWord(depth);
    }

    std::optional<Value> readGroup(int depth) {
        const qsizetype begin = m_at;
        const QChar close = at() == u'(' ? u')' : at() == u'[' ? u']' : u'}';
        ++m_at;
        const auto inner = readSum(depth + 1);
        skipBlanks();
        if (inner && at() == close) {
            ++m_at;
            return inner;
        }
        m_at = begin;
        return std::nullopt;
    }

    static Value constant(double value) {
        Value result;
        result.shift = value;
        return result;
    }

    std::optional<Value> readNumber() {
        qsizetype end = m_at;
        const auto letter = [&](qsizetype i) { return i < m_text.size() ? m_text[i] : QChar(); };
        bool hasPoint = false; // another one ends the sentence
        for (; letter(end).isDigit() || (letter(end) == u'.' && !hasPoint); ++end)
            hasPoint = hasPoint || letter(end) == u'.';
        const bool isDouble = letter(end).toLower() == u'd'; // 0.85d0 of Fortran
        if (letter(end).toLower() == u'e' || isDouble) {
            const qsizetype digits = end + (letter(end + 1) == u'-' || letter(end + 1) == u'+' ? 2 : 1);
            if (letter(digits).isDigit()) {
                end = digits;
                while (letter(end).isDigit())
                    ++end;
            }
        }
        QString number = m_text.sliced(m_at, end - m_at).toString();
        if (isDouble) number.replace(QChar(u'd'), QChar(u'e'), Qt::CaseInsensitive);
        const auto value = parseNumber(number);
        if (!value) return std::nullopt;
        m_at = end;
        if (at() == u'f' && !at(1).isLetterOrNumber()) ++m_at; // suffix of a float: 0.85f
        return constant(*value);
    }

    std::optional<Value> readFraction() { // character such as ½
        const auto value = at().isNull() ? std::nullopt : fractionOf(at());
        if (!value) return std::nullopt;
        ++m_at;
        return constant(*value);
    }

    static std::optional<double> fractionOf(QChar c) {
        const QString parts = QString(c).normalized(QString::NormalizationForm_KD);
        const qsizetype slash = parts.indexOf(QChar(0x2044));
        if (slash < 0) return std::nullopt;
        const auto above = parseNumber(parts.left(slash));
        const auto below = parseNumber(parts.mid(slash + 1));
        return above && below && *below != 0 ? std::optional(*above / *below) : std::nullopt;
    }

    std::optional<Value> readSign(int depth) {
        const bool isRoot = at() == u'√';
        const qsizetype begin = m_at++;
        if (!isRoot) return constant(*evaluate(u"pi"));
        const auto of = readBase(depth);
        if (of && of->isConstant() && of->shift >= 0) return constant(std::sqrt(of->shift));
        m_at = begin;
        return std::nullopt;
    }

    // Reads a letter with its index, or a function of a number.
    std::optional<Value> readWord(int depth) {
        const qsizetype begin = m_at;
        const qsizetype dot =
            m_text.sliced(begin).startsWith(u"Math.") || m_text.sliced(begin).startsWith(u"math.") ? 5
            : m_text.sliced(begin).startsWith(u"np.")                                              ? 3
                                                                                                   : 0;
        qsizetype end = begin + dot;
        while (end < m_text.size() && (m_text[end].isLetterOrNumber() || m_text[end] == u'_'))
            ++end;
        const QString word = m_text.sliced(begin + dot, end - begin - dot).toString().toLower();
        // Reads a single variable; "xy" would be a product of two.
        for (const auto& [letter, index] : {std::pair{u'x', 0}, {u'y', 1}, {u'z', 2}})
            if (isLetterWithIndex(word, letter)) {
                m_at = end;
                skipIndex();
                Value value;
                value.factors[std::size_t(index)] = 1;
                value.usesZ = index == 2;
                return value;
            }
        if (word == u"pi") {
            m_at = end;
            return constant(*evaluate(u"pi"));
        }
        if (const auto value = functionOfDegrees(word, end)) return value;
        if (word.isEmpty() || end >= m_text.size() || m_text[end] != u'(') return std::nullopt;
        m_at = end;
        const auto of = readGroup(depth);
        const auto value = of && of->isConstant()
                               ? evaluate(word + u'(' + QString::fromLatin1(formatNumber(of->shift)) + u')')
                               : std::nullopt;
        if (value) return constant(*value);
        m_at = begin;
        return std::nullopt;
    }

    // cos 60° and cos(60°): exact, which the sine of a product with π is not.
    std::optional<Value> functionOfDegrees(const QString& word, qsizetype end) {
        static const QRegularExpression angle(
            QStringLiteral(R"(^\s{0,3}(\(?)\s{0,3}([-−]?\d{0,9}[.]?\d{1,9})\s?°\s{0,3}(\)?))"));
        constexpr qsizetype longest = 40;
        if (word != u"sin" && word != u"cos" && word != u"tan") return std::nullopt;
        const auto match = angle.match(m_text.sliced(end, std::min(longest, m_text.size() - end)).toString());
        if (!match.hasMatch() || match.captured(1).isEmpty() != match.captured(3).isEmpty())
            return std::nullopt;
        const auto value = evaluate(QStringLiteral("%1(%2°)").arg(word, plainSigns(match.captured(2))));
        if (!value) return std::nullopt;
        m_at = end + match.capturedEnd();
        return constant(*value);
    }

    static bool isLetterWithIndex(const QString& word, QChar letter) {
        if (word.isEmpty() || word[0] != letter) return false;
        const QString index = word.sliced(1);
        return index.isEmpty() || index == u"n" || index == u"_n" || index == u"k" || index == u"_k" ||
               index == u"_i" || index == u"_old" || index == u"old" || index == u"ₙ" || index == u"_" ||
               index == u"0" || index == u"_0" || index == u"_t";
    }

    // x_{n}, x[i], xₙ, x(n) and x_{n-1}; no point, x[0], and no product, x(2).
    void skipIndex() {
        static const QRegularExpression index(QStringLiteral(
            R"(_?(?:\([ijknt](?:\s?[-−]\s?1)?\)|\[(?:[ijknt](?:\s?[-−]\s?1)?|-1)\]|\{[ijknt](?:\s?[-−]\s?1)?\})|[ₙₖ])"));
        constexpr qsizetype longest = 10;
        const QString near = m_text.sliced(m_at, std::min(longest, m_text.size() - m_at)).toString();
        const auto match = index.match(near, 0, QRegularExpression::NormalMatch,
                                       QRegularExpression::AnchorAtOffsetMatchOption);
        if (match.hasMatch()) m_at += match.capturedLength();
    }

    QStringView m_text;
    qsizetype m_at = 0;
    bool m_isBroken = false;
};

} // namespace

std::optional<AffineExpression> affineExpression(QStringView text) {
    return AffineParser(text).read();
}

} // namespace io
