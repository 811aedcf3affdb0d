// SPDX-License-Identifier: MIT
#include "io/table/equation_maps.h"

#include "io/text/affine_expression.h"
#include "io/text/coefficient.h"
#include "io/text/latex_text.h"
#include "io/text/plain_signs.h"

#include <QHash>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace io {

namespace {

constexpr qsizetype maxText = 4 * 1024 * 1024;
constexpr std::size_t maxMaps = 250'000;

// LaTeX line by line, so that lines stay; "&" only aligns.
QString plainLines(const QString& text) {
    if (!text.contains(u'\\')) return text;
    QStringList lines;
    for (QString line : withoutLatexComments(text).split(u'\n')) {
        static const QRegularExpression rowEnd(QStringLiteral(R"(\\\\\*?(\[[^\]]{0,1000}\])?)"));
        line.replace(rowEnd, QStringLiteral(" ; ")).remove(u'&');
        lines << plainLatex(line);
    }
    return lines.join(u'\n');
}

// A side of an equation: x' = …; index 0 for x.
struct Equation {
    int index = 0;
    AffineExpression value;
    qsizetype begin = 0, end = 0;
    QString spelling;    // of the left side but for its letter: "'" of x', empty for x alone
    bool isWhole = true; // the right side was understood to its end
};

// A point at once: (…, …).
struct Point {
    std::vector<AffineExpression> values;
    qsizetype begin = 0, end = 0;
};

// Returns false if what follows an expression would continue it: it was not understood.
bool endsThere(QStringView text, qsizetype at) {
    if (at >= text.size()) return true;
    // "x[0]", "x(j)", "0.85d0" and "0,85".
    if (QStringView(u"([{").contains(text[at]) || text[at].isLetterOrNumber()) return false;
    if (text[at] == u',' && at + 1 < text.size() && text[at + 1].isDigit() && at > 0 &&
        text[at - 1].isDigit())
        return false;
    const qsizetype from = at;
    while (at < text.size() && (text[at] == u' ' || text[at] == u'\t' || text[at] == u'\u00a0'))
        ++at;
    const QStringView rest = text.sliced(at);
    if (rest.isEmpty() || rest.startsWith(u"//") || rest.startsWith(u"=>") || rest.startsWith(u"--") ||
        rest.startsWith(u"->"))
        return true;
    // A dash between words, as in "0.5 x – the stem".
    if (at > from && (rest[0] == u'–' || rest[0] == u'—')) return true;
    return !QStringView(u"*/^=<>?·×+").contains(rest[0]) && !isDash(rest[0]);
}

// The same for x' and x′, x_1 and x_2, xn+1 and x_{n+1}.
QString spellingOf(const QString& before, QString behind) {
    static const QRegularExpression mark(QStringLiteral("[′’]"));
    static const QRegularExpression number(QStringLiteral("^_?\\d$"));
    static const QRegularExpression next(QStringLiteral("[nkit].*\\+|₊"));
    if (behind.contains(next)) return QStringLiteral("+");
    return before + behind.replace(mark, QStringLiteral("'")).replace(number, QStringLiteral("1"));
}

bool hasDigitOnLine(QStringView text) {
    for (const QChar c : text) {
        if (c == u'\n' || c == u';') return false;
        if (c.isDigit()) return true;
    }
    return false;
}

std::vector<Equation> equationsIn(const QString& text) {
    static const QRegularExpression side(QStringLiteral(
        R"((?<![\w.\\])(?:(new_?|next_?|n|t|tmp_?|temp_?)?([xyzXYZ])()"
        R"('|′|’|\*|_?[nN]ew|_?[nN]ext|ₙ₊₁|\s?_?[nk]\s?\+\s?1|_[({]?[nk]\s?\+\s?1[)}]?|\{n\+1\}|\[[nki]\s?\+\s?1\]|)"
        R"(\([nkit]\s?\+\s?1\)|1|2|_1|_2|n|_?t|_?tmp|_?temp)?)(?:\([^()=\n]{0,12}\))?\s*(?::=|=|←|<-|->|→|↦)(?!=)\s*)"));
    std::vector<Equation> equations;
    auto found = side.globalMatch(text);
    while (found.hasNext() && equations.size() < 4 * maxMaps) {
        const auto match = found.next();
        const auto value = affineExpression(QStringView(text).sliced(match.capturedEnd()));
        if (!value) continue;
        const qsizetype end = match.capturedEnd() + value->end;
        const bool isWhole = endsThere(text, end);
        if (!isWhole && !hasDigitOnLine(QStringView(text).sliced(match.capturedEnd()))) continue; // a x + b y
        equations.push_back({match.capturedView(2)[0].toLower().unicode() - u'x', *value,
                             match.capturedStart(), end, spellingOf(match.captured(1), match.captured(3)),
                             isWhole});
    }
    return equations;
}

// Those whose left sides are spelled as most are: others copy the point, or place it in a picture.
std::vector<Equation> ofOneSpelling(std::vector<Equation> equations) {
    QHash<QString, int> counts;
    for (const Equation& equation : equations)
        ++counts[equation.spelling];
    QString most;
    for (const Equation& equation : equations)
        if (counts[equation.spelling] > counts.value(most)) most = equation.spelling;
    std::erase_if(equations, [&](const Equation& equation) { return equation.spelling != most; });
    return equations;
}

// Returns true if the parameters of a function end there: (x, y) -> …
bool areParameters(QStringView text, qsizetype at) {
    while (at < text.size() && text[at].isSpace())
        ++at;
    const QStringView rest = text.sliced(std::min(at, text.size()));
    return rest.startsWith(u"->") || rest.startsWith(u"=>") || rest.startsWith(u'→') || rest.startsWith(u'↦');
}

// Behind "=", ":", "→" or "return": two or three expressions between commas.
std::vector<Point> pointsIn(const QString& text) {
    static const QRegularExpression opening(QStringLiteral(
        R"((?:(?<![<>=!])=(?!=)>?|→|↦|->|lambda [^:\n]{0,40}:|\breturn\b)\s*[A-Za-z.]{0,20}\s*(?:\(\s*\[|[\(\[\{])?)"));
    std::vector<Point> points;
    if (!QStringView(text).isValidUtf16()) return points;
    for (qsizetype from = 0; points.size() < maxMaps;) {
        const auto match = opening.match(text, from, QRegularExpression::NormalMatch,
                                         QRegularExpression::DontCheckSubjectStringMatchOption);
        if (!match.hasMatch()) return points;
        from = match.capturedEnd();
        const bool isOpen = QStringView(u"([{").contains(text[from - 1]);
        Point point{{}, match.capturedStart(), from};
        for (;;) {
            const auto value = affineExpression(QStringView(text).sliced(point.end));
            if (!value) break;
            point.values.push_back(*value);
            point.end += value->end;
            while (point.end < text.size() && text[point.end].isSpace() &&
                   (isOpen || text[point.end] != u'\n'))
                ++point.end;
            const bool isParted =
                point.end < text.size() && (text[point.end] == u',' || (isOpen && text[point.end] == u';'));
            if (!isParted || point.values.size() > 3) break;
            ++point.end;
        }
        const bool isClosed =
            !isOpen || (point.end < text.size() && QStringView(u")]}").contains(text[point.end]));
        const std::size_t count = point.values.size();
        const bool isMap = std::ranges::any_of(point.values, [](const auto& v) { return !v.isConstant(); });
        if ((count != 2 && count != 3) || !isClosed || !isMap ||
            !endsThere(text, point.end + (isOpen ? 1 : 0)) ||
            areParameters(text, point.end + (isOpen ? 1 : 0)))
            continue;
        from = point.end;
        points.push_back(std::move(point));
    }
    return points;
}

WrittenMap mapOf(const std::vector<AffineExpression>& sides) {
    WrittenMap map;
    for (const AffineExpression& side : sides)
        for (std::size_t i = 0; i < sides.size(); ++i)
            map.numbers.push_back(side.factors[i]);
    for (const AffineExpression& side : sides)
        map.numbers.push_back(side.shift);
    return map;
}

struct Found {
    std::vector<WrittenMap> maps;
    std::vector<std::pair<qsizetype, qsizetype>> places;

    void add(WrittenMap&& map, qsizetype begin, qsizetype end) {
        if (!std::ranges::all_of(map.numbers, [](double n) { return isCoefficient(n); })) return;
        maps.push_back(std::move(map));
        places.emplace_back(begin, end);
    }
};

// Returns true if y stands before x in every pair.
bool beginsWithY(const std::vector<Equation>& equations) {
    if (equations.empty() || equations.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < equations.size(); ++i)
        if (equations[i].index != (i % 2 == 0 ? 1 : 0)) return false;
    return true;
}

// Equations for x, y and perhaps z, one after the other. Where x and y only get numbers, a program begins.
// None if a map would be lost, because one of its sides is missing or not understood.
Found mapsOf(std::vector<Equation> equations) {
    if (beginsWithY(equations))
        for (std::size_t i = 0; i + 1 < equations.size(); i += 2)
            std::swap(equations[i].index, equations[i + 1].index),
                std::swap(equations[i].value, equations[i + 1].value);
    const bool isSpace = std::ranges::any_of(equations, [](const Equation& e) { return e.index == 2; });
    const std::size_t dim = isSpace ? 3 : 2;
    Found found;
    for (std::size_t i = 0; i < equations.size();) {
        std::vector<AffineExpression> sides;
        bool isWhole = true;
        bool isStart = equations[i].spelling.isEmpty();
        for (std::size_t k = 0; k < dim && i + k < equations.size() && equations[i + k].index == int(k);
             ++k) {
            sides.push_back(equations[i + k].value);
            isStart = isStart && equations[i + k].value.isConstant();
            isWhole = isWhole && equations[i + k].isWhole;
        }
        const bool isMeant = !equations[i].spelling.isEmpty() || !equations[i].value.isConstant();
        if (!isWhole || (sides.size() < dim && isMeant && !equations[i].spelling.isEmpty())) return {};
        if (sides.size() < dim || isStart) {
            ++i;
            continue;
        }
        found.add(mapOf(sides), equations[i].begin, equations[i + dim - 1].end);
        i += dim;
    }
    return found;
}

Found mapsOf(const std::vector<Point>& points) {
    Found found;
    const std::size_t dim = points.empty() ? 2 : points.front().values.size();
    for (const Point& point : points)
        if (point.values.size() == dim) found.add(mapOf(point.values), point.begin, point.end);
    return found;
}

// Returns true if a factor of some map is neither 0 nor ±1: otherwise a program counts.
bool areMaps(const Found& found) {
    return found.maps.size() >= 2 && std::ranges::any_of(found.maps, [](const WrittenMap& map) {
               const std::size_t dim = map.numbers.size() > 6 ? 3 : 2;
               return std::any_of(map.numbers.begin(), map.numbers.begin() + std::ptrdiff_t(dim * dim),
                                  [](double factor) { return factor != 0 && std::abs(factor) != 1; });
           });
}

// 0.5 for 0,5 where no number has a point; else empty.
QString withDecimalPoints(const QString& text) {
    static const QRegularExpression point(QStringLiteral("\\d[.]\\d|(?<![\\d.])[.]\\d"));
    static const QRegularExpression comma(QStringLiteral("(?<=\\d),(?=\\d)"));
    if (!text.contains(comma) || text.contains(point)) return {};
    return QString(text).replace(comma, QStringLiteral("."));
}

// x and y for p[0] and p[1], or for p[1] and p[2]; else empty.
QString withLetters(const QString& text) {
    static const QRegularExpression first(QStringLiteral("\\b[A-Za-z]\\w{0,20}\\[0\\]"));
    static const QRegularExpression indexed(QStringLiteral("\\b[A-Za-z]\\w{0,20}\\[([0-3])\\]"));
    const int start = text.contains(first) ? 0 : 1;
    QString replaced;
    qsizetype before = 0;
    for (auto found = indexed.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        const int index = match.capturedView(1).toInt() - start;
        if (index > 2) return {};
        replaced += QStringView(text).sliced(before, match.capturedStart() - before);
        replaced += QChar(u'x' + index);
        before = match.capturedEnd();
    }
    return before == 0 ? QString() : replaced + text.sliced(before);
}

// The first spelling of the text that has maps: in equations, or else at once, as points.
std::pair<QString, Found> foundIn(const QStringList& spellings) {
    for (const bool arePoints : {false, true})
        for (const QString& text : spellings) {
            Found found = text.isEmpty() ? Found()
                          : arePoints    ? mapsOf(pointsIn(text))
                                         : mapsOf(ofOneSpelling(equationsIn(text)));
            if (areMaps(found)) return {text, std::move(found)};
        }
    return {};
}

} // namespace

std::vector<WrittenMap> equationMaps(const QString& source) {
    if (source.size() > maxText) return {};
    const QString plain = plainLines(source);
    const QStringList spellings{plain, withDecimalPoints(plain), withLetters(plain)};
    const auto [text, found] = foundIn(spellings);
    if (found.maps.empty()) return {};
    QStringList between;
    qsizetype before = 0;
    int line = 1;
    std::vector<WrittenMap> maps = found.maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto [begin, end] = found.places[i];
        line += int(QStringView(text).sliced(before, begin - before).count(u'\n'));
        maps[i].line = line;
        between << text.sliced(before, begin - before);
        line += int(QStringView(text).sliced(begin, end - begin).count(u'\n'));
        before = end;
    }
    between << text.sliced(before);
    const auto weights = weightsBetween(between);
    for (std::size_t i = 0; i < maps.size(); ++i)
        maps[i].weight = weights[i];
    return maps;
}

} // namespace io
