// SPDX-License-Identifier: MIT
#include "io/text/latex_text.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <utility>

namespace io {

namespace {

constexpr int maxBraces = 32;
constexpr qsizetype longestOption = 1000;

struct Command {
    const char* name;
    const char* text; // replacement
};
constexpr std::array replaced{Command{"cdot", "*"},
                              Command{"times", "*"},
                              Command{"ast", "*"},
                              Command{"div", "/"},
                              Command{"pi", "π"},
                              Command{"phi", "phi"},
                              Command{"varphi", "phi"},
                              Command{"theta", "theta"},
                              Command{"vartheta", "theta"},
                              Command{"circ", "°"},
                              Command{"degree", "°"},
                              Command{"prime", "'"},
                              Command{"to", "→"},
                              Command{"mapsto", "→"},
                              Command{"rightarrow", "→"},
                              Command{"leftarrow", "="},
                              Command{"gets", "="},
                              Command{"coloneqq", "="},
                              Command{"approx", "="},
                              Command{"quad", " "},
                              Command{"qquad", " "},
                              Command{"newline", " "},
                              Command{"textminus", "-"},
                              Command{"textendash", "-"},
                              Command{"textperiodcentered", "*"},
                              Command{"percent", "%"}};

// Commands whose arguments are not shown either: how many there are in braces.
struct Hidden {
    const char* name;
    int arguments;
};
constexpr std::array hidden{
    Hidden{"phantom", 1},      Hidden{"hphantom", 1},      Hidden{"vphantom", 1},  Hidden{"hspace", 1},
    Hidden{"vspace", 1},       Hidden{"hskip", 0},         Hidden{"rule", 2},      Hidden{"label", 1},
    Hidden{"tag", 1},          Hidden{"cite", 1},          Hidden{"rowcolor", 1},  Hidden{"cellcolor", 1},
    Hidden{"columncolor", 1},  Hidden{"color", 1},         Hidden{"cmidrule", 1},  Hidden{"cline", 1},
    Hidden{"caption", 1},      Hidden{"footnote", 1},      Hidden{"setlength", 2}, Hidden{"arraycolsep", 0},
    Hidden{"ref", 1},          Hidden{"footnotemark", 0},  Hidden{"begin", 1},     Hidden{"end", 1},
    Hidden{"renewcommand", 2}, Hidden{"extrarowheight", 0}};

// Commands whose last argument is shown.
constexpr std::array lastShown{Hidden{"multicolumn", 3}, Hidden{"multirow", 3}, Hidden{"textcolor", 2},
                               Hidden{"colorbox", 2},    Hidden{"scalebox", 2}, Hidden{"raisebox", 2},
                               Hidden{"parbox", 2},      Hidden{"href", 2}};

template <typename List> auto find(const List& list, const QString& name) {
    return std::ranges::find_if(list, [&](const auto& known) { return name == QLatin1String(known.name); });
}

bool isFraction(const QString& name) {
    return name == u"frac" || name == u"tfrac" || name == u"dfrac" || name == u"cfrac" || name == u"sfrac" ||
           name == u"nicefrac";
}

bool isFunction(const QString& name) {
    return name == u"sin" || name == u"cos" || name == u"tan" || name == u"exp" || name == u"ln" ||
           name == u"log";
}

bool isOfDigits(const QString& text) {
    return !text.isEmpty() && std::ranges::all_of(text, [](QChar c) { return c.isDigit(); });
}

class Converter {
public:
    Converter(QStringView source, int depth) : m_source(source), m_depth(depth) {}

    QString convert() && {
        while (m_at < m_source.size())
            step();
        return m_text;
    }

private:
    QChar at() const { return m_at < m_source.size() ? m_source[m_at] : QChar(); }

    QString inner(QStringView source) const {
        return m_depth < maxBraces ? Converter(source, m_depth + 1).convert() : QString();
    }

    void step() {
        const QChar c = at();
        if (c == u'\\') return command();
        if (c == u'{') return addGroup();
        ++m_at;
        if (c == u'$' || c == u'}') return;
        if (c == u'~' || c == u'\n') {
            m_text += u' ';
        } else if (c == u'^') {
            addPower();
        } else if (c == u'_' && at() == u'{') {
            m_text += u'_' + argument();
        } else if (c == u'-' && at() == u'-') {
            while (at() == u'-')
                ++m_at;
            m_text += u'-';
        } else {
            m_text += c;
        }
    }

    // Adds groups such as 0{,}5 and {-}1, and groups without a meaning.
    void addGroup() {
        const QString text = argument();
        m_text += text == u"," ? QStringLiteral(".") : text;
    }

    void addPower() {
        const QString power = argument().trimmed();
        const bool isMark = power == u"°" || power == u"'";
        m_text += isMark                                 ? power
                  : power.size() == 1 || power.isEmpty() ? u'^' + power
                                                         : QStringLiteral("^(%1)").arg(power);
    }

    void command() {
        ++m_at;
        if (!at().isLetter()) return sign();
        const qsizetype begin = m_at;
        while (at().isLetter())
            ++m_at;
        QString name = m_source.sliced(begin, m_at - begin).toString();
        if (at() == u'*') ++m_at;
        if (isFraction(name)) return fraction();
        if (name == u"sqrt") return root();
        if (isFunction(name)) return function(name);
        if (name == u"left" || name == u"right") {
            if (at() == u'.') ++m_at;
            return;
        }
        if (const auto known = find(replaced, name); known != replaced.end()) {
            m_text += QString::fromUtf8(known->text);
        } else if (const auto drop = find(hidden, name); drop != hidden.end()) {
            option();
            for (int i = 0; i < drop->arguments; ++i)
                argument();
        } else if (const auto last = find(lastShown, name); last != lastShown.end()) {
            for (int i = 1; i < last->arguments; ++i)
                argument();
            m_text += argument();
        } else if (name == u"num" || name == u"tablenum" || name == u"SI" || name == u"qty" ||
                   name == u"ang") {
            number(name);
        } else if (name == u"addlinespace" || name == u"toprule" || name == u"midrule" ||
                   name == u"bottomrule" || name == u"hline") {
            option();
        }
    }

    // Reads a sign: "\," and the like separate nothing; "\%" is a sign.
    void sign() {
        const QChar c = at();
        ++m_at;
        if (c == u' ' || c == u'\n') m_text += u' ';
        if (QStringView(u"%&_#{}").contains(c)) m_text += c;
    }

    void fraction() {
        const QString above = argument().trimmed();
        const QString below = argument().trimmed();
        if (!m_text.isEmpty() && m_text.back().isDigit()) m_text += u' '; // 1½ might also be a product
        m_text += isOfDigits(above) && isOfDigits(below) ? above + u'/' + below
                                                         : QStringLiteral("((%1)/(%2))").arg(above, below);
    }

    void root() {
        const QString degree = option();
        const QString of = argument();
        if (!m_text.isEmpty() && (m_text.back().isDigit() || m_text.back() == u')')) m_text += u'*';
        m_text += degree.isEmpty() ? QStringLiteral("sqrt(%1)").arg(of)
                                   : QStringLiteral("((%2)^(1/(%1)))").arg(degree, of);
    }

    // Reads the argument of a function without parentheses.
    void function(const QString& name) {
        skipBlanks();
        if (!m_text.isEmpty() && m_text.back().isDigit()) m_text += u'*';
        m_text += name;
        if (at() == u'(' || m_source.sliced(m_at).startsWith(u"\\left") || at() == u'^') return;
        const qsizetype begin = m_at;
        while (at().isDigit() || at() == u'.' || at() == u'/')
            ++m_at;
        for (const QStringView mark : {u"^{\\circ}", u"^\\circ", u"\\pi", u"°"})
            if (m_source.sliced(m_at).startsWith(mark)) m_at += mark.size();
        const QString of = begin != m_at   ? inner(m_source.sliced(begin, m_at - begin))
                           : at() == u'\\' ? commandAlone()
                                           : argument();
        m_text += u'(' + of + u')';
    }

    // The command with its arguments, as in \cos\frac{\pi}{3}.
    QString commandAlone() {
        const QString before = std::exchange(m_text, {});
        command();
        return std::exchange(m_text, before);
    }

    void number(const QString& name) {
        option();
        QString text = argument().remove(u' ');
        if (!text.contains(u'.')) text.replace(u',', u'.');
        m_text += name == u"ang" ? text + u'°' : text;
        if (name == u"SI" || name == u"qty") {
            const QString unit = argument();
            if (unit.contains(u'%') || unit.contains(u'°')) m_text += unit;
        }
    }

    void skipBlanks() {
        while (at().isSpace())
            ++m_at;
    }

    // Next group, command or sign, as text.
    QString argument() {
        skipBlanks();
        if (at() == u'{') {
            const qsizetype begin = ++m_at;
            for (int depth = 1; m_at < m_source.size(); ++m_at) {
                if (at() == u'\\')
                    ++m_at;
                else if (at() == u'{')
                    ++depth;
                else if (at() == u'}' && --depth == 0)
                    break;
            }
            const qsizetype end = std::min(m_at, m_source.size());
            m_at = std::min(end + 1, m_source.size());
            return inner(m_source.sliced(begin, end - begin));
        }
        if (m_at >= m_source.size()) return {};
        const qsizetype begin = m_at++;
        if (m_source[begin] == u'\\') {
            while (at().isLetter())
                ++m_at;
            if (m_at == begin + 1 && m_at < m_source.size()) ++m_at;
        }
        const QStringView token = m_source.sliced(begin, m_at - begin);
        return token.size() == 1 ? token.toString() : inner(token);
    }

    QString option() {
        for (const auto& [open, close] : {std::pair{u'[', u']'}, std::pair{u'(', u')'}}) {
            if (at() != open) continue;
            const QStringView near = m_source.sliced(m_at, std::min(m_source.size() - m_at, longestOption));
            const qsizetype end = m_at + near.indexOf(close);
            if (end < m_at) return {};
            const QString text = inner(m_source.sliced(m_at + 1, end - m_at - 1));
            m_at = end + 1;
            if (open == u'(' || at() != u'(') return text;
        }
        return {};
    }

    QStringView m_source;
    int m_depth;
    qsizetype m_at = 0;
    QString m_text;
};

} // namespace

QString plainLatex(QStringView source) {
    // 2.75 · 10⁻⁵ at once: the product is rounded.
    static const QRegularExpression power(
        QStringLiteral(R"((?<![\w.^/])(\d+\.?\d*|\.\d+)\s?\*\s?10\^(?:\((-?\d{1,3})\)|(\d)))"));
    static const QRegularExpression over(
        QStringLiteral(R"(\{([^{}]{1,100})\\over(?![a-z])([^{}]{1,100})\})"));
    QString text =
        source.contains(u"\\over")
            ? Converter(source.toString().replace(over, QStringLiteral("\\frac{\\1}{\\2}")), 0).convert()
            : Converter(source, 0).convert();
    if (text.contains(QStringLiteral("10^"))) text.replace(power, QStringLiteral("\\1e\\2\\3"));
    return text;
}

QString withoutLatexComments(QString source) {
    bool isComment = false;
    for (qsizetype i = 0; i < source.size(); ++i) {
        if (source[i] == u'\n') isComment = false;
        if (source[i] == u'\\' && !isComment) {
            ++i;
            continue;
        }
        isComment = isComment || source[i] == u'%';
        if (isComment) source[i] = u' ';
    }
    return source;
}

} // namespace io
