// SPDX-License-Identifier: MIT
#include "io/table/equation_maps.h"

#include "io/text/affine_expression.h"
#include "io/text/coefficient.h"
#include "io/text/latex_text.h"
#include "io/text/plain_signs.h"

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
    bool isMarked = false; // true for x', xn+1 and new_x
};

// A point at once: (…, …).
struct Point {
    std::vector<AffineExpression> values;
    qsizetype begin = 0, end = 0;
};

bool endsThere(QStringView text, qsizetype at) {
    while (at < text.size() && (text[at] == u' ' || text[at] == u'\t' || text[at] == u'\u00a0'))
        ++at;
    if (at >= text.size()) return true;
    const QChar c = text[at];
    // False if a sign follows that would continue the expression.
    return !QStringView(u"*/^=<>?·×").contains(c) || text.sliced(at).startsWith(u"//") ||
           text.sliced(at).startsWith(u"=>");
}

std::vector<Equation> equationsIn(const QString& text) {
    static const QRegularExpression side(QStringLiteral(
        R"((?<![\w.\\])(?:(new_?|next_?|n|t|tmp_?|temp_?)?([xyzXYZ])()"
        R"('|′|’|\*|_?[nN]ew|_?[nN]ext|ₙ₊₁|\s?_?[nk]\s?\+\s?1|_[({]?[nk]\s?\+\s?1[)}]?|\{n\+1\}|\[[nki]\s?\+\s?1\]|)"
        R"(\([nt]\s?\+\s?1\)|1|2|_1|n)?)(?:\([^()=\n]{0,12}\))?\s*(?::=|=|←|<-|->|→|↦)(?!=)\s*)"));
    std::vector<Equation> equations;
    auto found = side.globalMatch(text);
    while (found.hasNext() && equations.size() < 4 * maxMaps) {
        const auto match = found.next();
        const auto value = affineExpression(QStringView(text).sliced(match.capturedEnd()));
        if (!value) continue;
        const qsizetype end = match.capturedEnd() + value->end;
        if (!endsThere(text, end)) continue;
        equations.push_back({match.capturedView(2)[0].toLower().unicode() - u'x', *value,
                             match.capturedStart(), end,
                             !match.captured(1).isEmpty() || !match.captured(3).isEmpty()});
    }
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
        R"((?:(?<![<>=!])=(?!=)>?|→|↦|->|lambda [^:\n]{0,40}:|\breturn\b)\s*[A-Za-z.]{0,20}\s*[\(\[\{]?)"));
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
            if (point.end >= text.size() || text[point.end] != u',' || point.values.size() > 3) break;
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

// Equations for x, y and perhaps z, one after the other. Where x and y only get numbers, a program begins.
Found mapsOf(const std::vector<Equation>& equations) {
    const bool isSpace = std::ranges::any_of(equations, [](const Equation& e) { return e.index == 2; });
    const std::size_t dim = isSpace ? 3 : 2;
    Found found;
    for (std::size_t i = 0; i + dim <= equations.size();) {
        std::vector<AffineExpression> sides;
        bool isStart = true;
        for (std::size_t k = 0; k < dim && equations[i + k].index == int(k); ++k) {
            sides.push_back(equations[i + k].value);
            isStart = isStart && !equations[i + k].isMarked && equations[i + k].value.isConstant();
        }
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

} // namespace

std::vector<WrittenMap> equationMaps(const QString& source) {
    if (source.size() > maxText) return {};
    const QString text = plainLines(source);
    Found found = mapsOf(equationsIn(text));
    if (found.maps.size() < 2) found = mapsOf(pointsIn(text));
    if (found.maps.size() < 2) return {};
    QStringList between;
    qsizetype before = 0;
    int line = 1;
    for (std::size_t i = 0; i < found.maps.size(); ++i) {
        const auto [begin, end] = found.places[i];
        line += int(QStringView(text).sliced(before, begin - before).count(u'\n'));
        found.maps[i].line = line;
        between << text.sliced(before, begin - before);
        line += int(QStringView(text).sliced(begin, end - begin).count(u'\n'));
        before = end;
    }
    between << text.sliced(before);
    const auto weights = weightsBetween(between);
    for (std::size_t i = 0; i < found.maps.size(); ++i)
        found.maps[i].weight = weights[i];
    return std::move(found.maps);
}

} // namespace io
