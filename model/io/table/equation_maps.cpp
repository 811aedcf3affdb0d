// SPDX-License-Identifier: MIT
#include "io/table/equation_maps.h"

#include "io/text/affine_expression.h"
#include "io/text/coefficient.h"
#include "io/text/latex_text.h"
#include "io/text/plain_signs.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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
    QString text;        // what was not
};

// A point at once: (…, …).
struct Point {
    std::vector<AffineExpression> values;
    qsizetype begin = 0, end = 0;
    QString unread{}; // its text if it was not understood
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

QString lineAt(QStringView text, qsizetype from) {
    qsizetype end = from;
    constexpr qsizetype longest = 400;
    while (end < std::min(text.size(), from + longest) && text[end] != u'\n' && text[end] != u';')
        ++end;
    return text.sliced(from, end - from).trimmed().toString();
}

// a x + b y + e: no digits, and at least so many letters beside those of the point.
bool isGeneralForm(const QString& text, qsizetype fewest) {
    QSet<QChar> letters;
    for (const QChar c : text) {
        if (c.isDigit()) return false;
        if (c.isLetter() && !QStringView(u"xyzXYZ").contains(c)) letters << c;
    }
    return letters.size() >= fewest;
}

bool hasCoordinate(QStringView text) {
    static const QRegularExpression coordinate(QStringLiteral("(?<![A-Za-z])[xyz](?![A-Za-z])"));
    return text.contains(coordinate);
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
        const qsizetype end = match.capturedEnd() + (value ? value->end : 0);
        const bool isWhole = value && endsThere(text, end);
        equations.push_back({match.capturedView(2)[0].toLower().unicode() - u'x',
                             value.value_or(AffineExpression()), match.capturedStart(), end,
                             spellingOf(match.captured(1), match.captured(3)), isWhole,
                             isWhole ? QString() : lineAt(text, match.capturedEnd())});
    }
    return equations;
}

// Those whose left sides are spelled as most are: others copy the point, or place it in a picture.
std::vector<Equation> ofOneSpelling(std::vector<Equation> equations) {
    QHash<QString, int> counts;
    for (const Equation& equation : equations)
        if (equation.isWhole) ++counts[equation.spelling];
    QString most;
    for (const Equation& equation : equations)
        if (counts[equation.spelling] > counts.value(most)) most = equation.spelling;
    std::erase_if(equations, [&](const Equation& equation) { return equation.spelling != most; });
    return equations;
}

// Without the general form before or behind the maps, x' = a x + b y + e.
std::vector<Equation> withoutGeneralForm(std::vector<Equation> equations) {
    const auto isWhole = [](const Equation& equation) { return equation.isWhole; };
    const auto first = std::ranges::find_if(equations, isWhole);
    const auto last = std::find_if(equations.rbegin(), equations.rend(), isWhole).base();
    std::vector<Equation> kept;
    for (auto one = equations.begin(); one != equations.end(); ++one)
        if ((one >= first && one < last) || !isGeneralForm(one->text, 2)) kept.push_back(*one);
    return kept;
}

// Returns true if the parameters of a function end there: (x, y) -> …
bool areParameters(QStringView text, qsizetype at) {
    while (at < text.size() && text[at].isSpace())
        ++at;
    const QStringView rest = text.sliced(std::min(at, text.size()));
    return rest.startsWith(u"->") || rest.startsWith(u"=>") || rest.startsWith(u'→') || rest.startsWith(u'↦');
}

// Behind the names of parameters, as f(x, y) = …, or def f(x, y): return ….
bool isOfFunction(QStringView text, const QRegularExpressionMatch& opening) {
    static const QRegularExpression parameters(
        QStringLiteral(R"(\(\s*[A-Za-z_]\w{0,20}\s*[,;]\s*[A-Za-z_]\w{0,20}[^()\n]{0,40}\)\s*:?\s*$)"));
    constexpr qsizetype longest = 160;
    const QStringView sign = opening.capturedView();
    if (sign.startsWith(u"lambda") || sign.startsWith(u"→") || sign.startsWith(u"↦") ||
        sign.startsWith(u"->") || sign.startsWith(u"=>"))
        return true;
    const qsizetype from = std::max<qsizetype>(0, opening.capturedStart() - longest);
    return text.sliced(from, opening.capturedStart() - from).toString().contains(parameters);
}

// Behind the names of the coordinates: x, y = ….
bool isOfCoordinates(QStringView text, qsizetype begin) {
    static const QRegularExpression names(
        QStringLiteral("(?<![A-Za-z])x\\w{0,5}['′]?\\s*,\\s*y\\w{0,5}['′]?\\s*\\)?\\s*:?$"));
    constexpr qsizetype longest = 30;
    const qsizetype from = std::max<qsizetype>(0, begin - longest);
    return text.sliced(from, begin - from).toString().contains(names);
}

// Two or three expressions between commas; none unless they are understood to the end.
std::optional<Point> pointAt(const QString& text, qsizetype begin, qsizetype from, bool isOpen,
                             bool mayBeConstant) {
    Point point{{}, begin, from};
    for (;;) {
        const auto value = affineExpression(QStringView(text).sliced(point.end));
        if (!value) break;
        point.values.push_back(*value);
        point.end += value->end;
        while (point.end < text.size() && text[point.end].isSpace() && (isOpen || text[point.end] != u'\n'))
            ++point.end;
        const bool isParted =
            point.end < text.size() && (text[point.end] == u',' || (isOpen && text[point.end] == u';'));
        if (!isParted || point.values.size() > 3) break;
        ++point.end;
    }
    const bool isClosed =
        !isOpen || (point.end < text.size() && QStringView(u")]}").contains(text[point.end]));
    const std::size_t count = point.values.size();
    const bool isMap =
        mayBeConstant || std::ranges::any_of(point.values, [](const auto& v) { return !v.isConstant(); });
    const qsizetype behind = point.end + (isOpen ? 1 : 0);
    if ((count != 2 && count != 3) || !isClosed || !isMap || !endsThere(text, behind) ||
        areParameters(text, behind))
        return std::nullopt;
    return point;
}

// The text of two or three parts between commas that was not understood; empty for something else.
QString unreadPoint(QStringView text, qsizetype from, bool isOpen) {
    constexpr qsizetype longest = 1000;
    int depth = 0;
    qsizetype parts = 1, end = from;
    for (; end < text.size() && end < from + longest; ++end) {
        const QChar c = text[end];
        if (QStringView(u"([{").contains(c)) ++depth;
        if (QStringView(u")]}").contains(c) && --depth < 0) break;
        if (!isOpen && depth == 0 && (c == u'\n' || c == u';')) break;
        if (depth == 0 && (c == u',' || c == u';')) ++parts;
    }
    const QStringView inner = text.sliced(from, end - from);
    if (parts < 2 || parts > 3 || !hasCoordinate(inner)) return {};
    if (isOpen && areParameters(text, std::min(end + 1, text.size()))) return {};
    return inner.trimmed().toString();
}

// Behind "=", ":", "→" or "return": two or three expressions between commas, perhaps in a call.
std::vector<Point> pointsIn(const QString& text) {
    static const QRegularExpression opening(QStringLiteral(
        R"((?:(?<![<>=!])=(?!=)>?|→|↦|->|lambda [^:\n]{0,40}:|\breturn\b)\s*([A-Za-z][A-Za-z.]{0,20}\s*(?=[\(\[\{]))?(\(\s*\[|[\(\[\{])?)"));
    std::vector<Point> points;
    if (!QStringView(text).isValidUtf16()) return points;
    for (qsizetype from = 0; points.size() < maxMaps;) {
        const auto match = opening.match(text, from, QRegularExpression::NormalMatch,
                                         QRegularExpression::DontCheckSubjectStringMatchOption);
        if (!match.hasMatch()) return points;
        from = match.capturedEnd();
        const qsizetype begin = match.capturedStart();
        const bool isOpen = match.hasCaptured(2);
        const bool isFunction = isOfFunction(text, match);
        auto point = pointAt(text, begin, from, isOpen, isFunction);
        if (!point && isOpen) // (x + 1)/2, …
            point =
                pointAt(text, begin, match.capturedStart(match.hasCaptured(1) ? 1 : 2), false, isFunction);
        if (point) {
            from = point->end;
            points.push_back(*std::move(point));
        } else if (isFunction || isOfCoordinates(text, begin)) {
            const QString unread = unreadPoint(text, from, isOpen);
            if (!unread.isEmpty()) points.push_back({{}, begin, from, unread});
        }
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
    std::optional<UnreadMap> unread{};
    qsizetype unreadAt = 0;

    void add(WrittenMap&& map, qsizetype begin, qsizetype end) {
        if (!std::ranges::all_of(map.numbers, [](double n) { return isCoefficient(n); })) return;
        maps.push_back(std::move(map));
        places.emplace_back(begin, end);
    }
    void miss(const QString& text, qsizetype at) {
        constexpr qsizetype longest = 60;
        if (!unread) unread = {int(maps.size()) + 1, 0, text.left(longest)}, unreadAt = at;
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
// One is unread if one of its sides is missing or not understood.
Found mapsOf(std::vector<Equation> equations, QStringView text) {
    if (beginsWithY(equations))
        for (std::size_t i = 0; i + 1 < equations.size(); i += 2)
            std::swap(equations[i].index, equations[i + 1].index),
                std::swap(equations[i].value, equations[i + 1].value);
    const bool isSpace = std::ranges::any_of(equations, [](const Equation& e) { return e.index == 2; });
    const std::size_t dim = isSpace ? 3 : 2;
    Found found;
    for (std::size_t i = 0; i < equations.size();) {
        std::vector<AffineExpression> sides;
        const Equation* damaged = nullptr;
        bool isStart = equations[i].spelling.isEmpty();
        bool isMoved = false; // a coordinate stands on the right
        for (std::size_t k = 0; k < dim && i + k < equations.size() && equations[i + k].index == int(k);
             ++k) {
            const Equation& side = equations[i + k];
            sides.push_back(side.value);
            isStart = isStart && side.isWhole && side.value.isConstant();
            isMoved = isMoved || hasCoordinate(side.text) || (side.isWhole && !side.value.isConstant());
            if (!side.isWhole && !damaged) damaged = &side;
        }
        const bool isProgram = equations[i].spelling.isEmpty();
        const bool isComplete = sides.size() == dim;
        if (isProgram ? damaged && isComplete && isMoved : damaged || !isComplete) {
            const Equation& first = damaged ? *damaged : equations[i];
            found.miss(damaged ? damaged->text : lineAt(text, equations[i].begin), first.begin);
        }
        if (damaged || !isComplete || isStart) {
            ++i;
            continue;
        }
        found.add(mapOf(sides), equations[i].begin, equations[i + dim - 1].end);
        i += dim;
    }
    return found;
}

Found mapsOf(const std::vector<Point>& points, QStringView text) {
    const auto isRead = [](const Point& point) { return point.unread.isEmpty(); };
    const auto first = std::ranges::find_if(points, isRead);
    const std::size_t dim = first == points.end() ? 2 : first->values.size();
    const auto last = std::find_if(points.rbegin(), points.rend(), isRead).base();
    Found found;
    for (auto one = points.begin(); one != points.end(); ++one) {
        if (isRead(*one) && one->values.size() == dim)
            found.add(mapOf(one->values), one->begin, one->end);
        else if ((one >= first && one < last) || !isGeneralForm(one->unread, 4))
            found.miss(isRead(*one) ? lineAt(text, one->begin) : one->unread, one->begin);
    }
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

// The first spelling of the text whose maps are all understood: in equations, or else at once, as points.
// Else the first that has maps.
std::pair<QString, Found> foundIn(const QStringList& spellings) {
    std::pair<QString, Found> nearly;
    for (const bool arePoints : {false, true})
        for (const QString& text : spellings) {
            Found found = text.isEmpty() ? Found()
                          : arePoints    ? mapsOf(pointsIn(text), text)
                                         : mapsOf(withoutGeneralForm(ofOneSpelling(equationsIn(text))), text);
            if (!areMaps(found)) continue;
            if (!found.unread) return {text, std::move(found)};
            if (nearly.second.maps.empty()) nearly = {text, std::move(found)};
        }
    return nearly;
}

} // namespace

WrittenMaps equationMaps(const QString& source) {
    if (source.size() > maxText) return {};
    const QString plain = plainLines(source);
    const QStringList spellings{plain, withDecimalPoints(plain), withLetters(plain)};
    const auto [text, found] = foundIn(spellings);
    if (found.maps.empty()) return {};
    if (found.unread) {
        UnreadMap unread = *found.unread;
        unread.line = 1 + int(QStringView(text).first(found.unreadAt).count(u'\n'));
        return {found.maps, unread};
    }
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
    return {std::move(maps)};
}

} // namespace io
