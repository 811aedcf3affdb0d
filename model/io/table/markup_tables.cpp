// SPDX-License-Identifier: MIT
#include "io/table/markup_tables.h"

#include "io/table/html_tables.h"
#include "io/table/table_cells.h"
#include "io/text/expression.h"
#include "io/text/latex_text.h"
#include "io/text/number.h"
#include "io/text/plain_signs.h"

#include <QHash>
#include <QRegularExpression>
#include <QStringView>

#include <algorithm>
#include <functional>
#include <queue>
#include <vector>

namespace io {

namespace {

constexpr qsizetype fewestCells = 6; // cells of a single row

class Lines {
public:
    explicit Lines(QStringView text) {
        for (qsizetype i = 0; i < text.size(); ++i)
            if (text[i] == u'\n') m_feeds.push_back(i);
    }
    int at(qsizetype position) const {
        return int(std::lower_bound(m_feeds.begin(), m_feeds.end(), position) - m_feeds.begin()) + 1;
    }

private:
    std::vector<qsizetype> m_feeds;
};

constexpr qsizetype longestArgument = 1000; // characters of an argument of an environment or of a row end

// Behind the group that opens here, if it is no longer than an argument.
qsizetype endOfGroup(QStringView text, qsizetype open) {
    int depth = 0;
    for (qsizetype i = open; i < std::min(text.size(), open + longestArgument); ++i) {
        if (text[i] == u'\\')
            ++i;
        else if (text[i] == u'{')
            ++depth;
        else if (text[i] == u'}' && --depth == 0)
            return i + 1;
    }
    return open;
}

// Behind the bracket that closes what opens here, if it is no longer than an argument.
qsizetype endOfOption(QStringView text, qsizetype open) {
    const QStringView near = text.sliced(open, std::min(text.size() - open, longestArgument));
    return open + near.indexOf(u']') + 1;
}

struct Environment {
    QString name;
    qsizetype begin = 0; // position of \begin
    qsizetype body = 0;
    qsizetype bodyEnd = -1;
    qsizetype end = -1;
};

Environment openedAt(const QRegularExpressionMatch& match, QStringView text) {
    Environment one{match.captured(2), match.capturedStart(), match.capturedEnd()};
    if (one.body < text.size() && text[one.body] == u'[') one.body = endOfOption(text, one.body);
    const bool hasWidth = one.name.startsWith(u"tabular") && one.name.size() > 7;
    const int arguments = one.name.contains(u"matrix") ? 0 : hasWidth ? 2 : 1;
    for (int i = 0; i < arguments && one.body < text.size() && text[one.body] == u'{'; ++i)
        one.body = endOfGroup(text, one.body);
    return one;
}

// The environments of tables and matrices, in their order. One without an end ends where the next begins.
std::vector<Environment> allEnvironments(const QString& text) {
    static const QRegularExpression tag(QStringLiteral(
        R"(\\(begin|end)\{((?:tabular[xy]?|longtable|tabu|tblr|array|[pbBvV]?(?:small)?matrix)\*?)\})"));
    std::vector<Environment> all;
    QHash<QString, std::vector<std::size_t>> open; // positions by name, innermost last
    for (auto tags = tag.globalMatch(text); tags.hasNext() && all.size() < std::size_t(maxTableRows);) {
        const auto match = tags.next();
        if (!all.empty() && match.capturedStart() < all.back().body) continue; // inside an argument
        std::vector<std::size_t>& same = open[match.captured(2)];
        if (match.capturedView(1) == u"begin") {
            same.push_back(all.size());
            all.push_back(openedAt(match, text));
        } else if (!same.empty()) {
            all[same.back()].bodyEnd = match.capturedStart();
            all[same.back()].end = match.capturedEnd();
            same.pop_back();
        }
    }
    qsizetype next = text.size();
    for (auto one = all.rbegin(); one != all.rend(); next = one++->begin)
        if (one->end < 0) one->bodyEnd = one->end = std::max(next, one->body);
    return all;
}

// Environments; of one inside another only the outer one where `isNested` is false, else none deep inside
// many.
QList<Environment> environments(const QString& text, bool isNested) {
    constexpr std::size_t deepest = 8;
    QList<Environment> found;
    // Ends of the enclosing environments.
    std::priority_queue<qsizetype, std::vector<qsizetype>, std::greater<>> ends;
    for (const Environment& one : allEnvironments(text)) {
        while (!ends.empty() && ends.top() <= one.begin)
            ends.pop();
        if (ends.size() < (isNested ? deepest : 1)) found << one;
        ends.push(one.end);
    }
    return found;
}

// Cells between "&" and rows that end in "\\", outside of groups and inner environments.
class RowSplitter {
public:
    explicit RowSplitter(QStringView text) : m_text(text) {}

    struct Raw {
        QList<QStringView> cells;
        qsizetype end = 0; // position of its last sign in the text
    };

    QList<Raw> split(bool linesEndRows) && {
        for (; m_at < m_text.size() && m_rows.size() < maxTableRows; ++m_at) {
            const QChar c = m_text[m_at];
            if (c == u'\\')
                command();
            else if (c == u'{' || c == u'}')
                m_depth += c == u'{' ? 1 : -1;
            else if (c == u'&' && m_depth == 0)
                endCell();
            else if (c == u'\n' && linesEndRows && m_depth == 0)
                endRow(1);
        }
        endRow(0);
        return std::move(m_rows);
    }

private:
    void command() {
        const QStringView rest = m_text.sliced(m_at);
        if (rest.startsWith(u"\\begin{")) {
            ++m_depth;
            m_at += 6 - 1; // stops at the brace, which is counted separately
        } else if (rest.startsWith(u"\\end{")) {
            --m_depth;
            m_at += 4 - 1;
        } else if (rest.startsWith(u"\\\\") && m_depth == 0) {
            endRow(2);
            skipOption();
        } else if (rest.startsWith(u"\\tabularnewline") && m_depth == 0) {
            endRow(15);
            skipOption();
        } else if (rest.startsWith(u"\\cr") && m_depth == 0 && (rest.size() == 3 || !rest[3].isLetter())) {
            endRow(3);
        } else {
            ++m_at;
        }
    }

    // Skips "*" and "[2pt]" behind the end of a row, whose last sign is at m_at.
    void skipOption() {
        if (m_at + 1 < m_text.size() && m_text[m_at + 1] == u'*') ++m_at;
        if (m_at + 1 >= m_text.size() || m_text[m_at + 1] != u'[') return;
        if (const qsizetype end = endOfOption(m_text, m_at + 1); end > m_at + 1) m_at = end - 1;
        m_begin = m_at + 1;
    }

    void endCell() {
        m_row.cells << m_text.sliced(m_begin, m_at - m_begin);
        m_begin = m_at + 1;
    }

    void endRow(qsizetype sign) {
        endCell();
        m_row.end = m_at;
        while (m_row.end > 0 && m_text[m_row.end - 1].isSpace())
            --m_row.end;
        m_rows << std::exchange(m_row, {});
        m_at += std::max<qsizetype>(sign - 1, 0);
        m_begin = m_at + 1;
    }

    QStringView m_text;
    qsizetype m_at = 0;
    qsizetype m_begin = 0;
    int m_depth = 0;
    Raw m_row;
    QList<Raw> m_rows;
};

bool isEmptyRow(const QStringList& cells) {
    return std::ranges::all_of(cells, [](const QString& cell) { return cell.isEmpty(); });
}

QStringList plainCells(const QList<QStringView>& cells) {
    QStringList plain;
    for (const QStringView cell : cells)
        plain << plainLatex(cell).simplified();
    return plain;
}

MarkupTable latexTable(QStringView text, qsizetype begin, qsizetype end, bool linesEndRows,
                       const Lines& lines) {
    MarkupTable table;
    for (const auto& raw : RowSplitter(text.sliced(begin, end - begin)).split(linesEndRows)) {
        const QStringList cells = plainCells(raw.cells);
        if (!isEmptyRow(cells)) table.rows << MarkupRow{cells, lines.at(begin + raw.end)};
    }
    return table;
}

// The lines with cells of a table without \begin.
std::optional<MarkupTable> looseLatexTable(const QString& text, const Lines& lines) {
    qsizetype begin = -1;
    qsizetype end = 0;
    for (qsizetype at = 0, feed = 0; at < text.size(); at = feed + 1) {
        feed = text.indexOf(u'\n', at);
        if (feed < 0) feed = text.size();
        if (QStringView(text).sliced(at, feed - at).count(u'&') < fewestCells - 1) continue;
        if (begin < 0) begin = at;
        end = feed;
    }
    if (begin < 0) return std::nullopt;
    const bool linesEndRows = !QStringView(text).sliced(begin, end - begin).contains(u"\\\\");
    MarkupTable table = latexTable(text, begin, end, linesEndRows, lines);
    table.rows.removeIf([](const MarkupRow& row) { return row.cells.size() < fewestCells; });
    return table;
}

QList<MarkupTable> latexTables(const QString& source) {
    if (!source.contains(u'&')) return {};
    const QString text = withoutLatexComments(source);
    const Lines lines(text);
    QList<MarkupTable> tables;
    for (const Environment& one : environments(text, false)) {
        const bool isMatrix = one.name.contains(u"matrix") || one.name == u"array";
        MarkupTable table = latexTable(text, one.body, one.bodyEnd, false, lines);
        const bool isWide = std::ranges::any_of(
            table.rows, [](const MarkupRow& row) { return row.cells.size() >= fewestCells; });
        const bool isTall = table.rows.size() >= fewestCells;
        if (isWide || isTall || !isMatrix) tables << std::move(table);
    }
    if (tables.isEmpty() && !text.contains(QStringLiteral("\\begin{")))
        if (auto loose = looseLatexTable(text, lines)) tables << *std::move(loose);
    return tables;
}

// "| a | b |" of Markdown, Org and programs that draw frames; "^ a ^" and "||a||" of wikis.
std::optional<QStringList> ruledCells(QString line) {
    for (const QChar frame : {u'│', u'┃', u'║'})
        line.replace(frame, u'|');
    line = line.trimmed();
    if (line.startsWith(u"||")) line.replace(QStringLiteral("||"), QStringLiteral("|"));
    if (line.count(u'|') < (line.startsWith(u'|') ? 2 : fewestCells - 1)) return std::nullopt;
    line.replace(QStringLiteral("\\|"), QStringLiteral("\u2223"));
    if (line.startsWith(u'|')) line.remove(0, 1);
    if (line.endsWith(u'|')) line.chop(1);
    QStringList cells;
    for (QString cell : line.split(u'|')) {
        cell = cell.trimmed();
        for (const QString& mark :
             {QStringLiteral("**"), QStringLiteral("__"), QStringLiteral("*"), QStringLiteral("`")})
            if (cell.size() > 2 * mark.size() && cell.startsWith(mark) && cell.endsWith(mark))
                cell = cell.sliced(mark.size(), cell.size() - 2 * mark.size());
        static const QRegularExpression escaped(QStringLiteral(R"(\\([-+.*_#()!~]))"));
        cell.replace(escaped, QStringLiteral("\\1"));
        cells << (cell.contains(u'\\') || cell.contains(u'$') ? plainLatex(cell).simplified()
                                                              : textOfHtml(cell));
    }
    return cells;
}

bool isRule(const QStringList& cells) {
    return std::ranges::all_of(cells, [](const QString& cell) {
        return std::ranges::all_of(cell,
                                   [](QChar c) { return isDash(c) || QStringView(u":=+").contains(c); });
    });
}

QList<MarkupTable> markdownTables(const QString& text) {
    QList<MarkupTable> tables;
    bool isInside = false;
    int number = 0;
    for (const QStringView line : QStringView(text).split(u'\n')) {
        ++number;
        const bool isFrame = !line.trimmed().isEmpty() && isRule({line.trimmed().toString()});
        const auto cells = isFrame ? std::nullopt : ruledCells(line.toString());
        if (!cells) {
            isInside = isInside && isFrame;
            continue;
        }
        if (!isInside) tables << MarkupTable{Markup::Markdown, {}};
        isInside = true;
        if (!isRule(*cells) && tables.last().rows.size() < maxTableRows)
            tables.last().rows << MarkupRow{*cells, number};
    }
    tables.removeIf([](const MarkupTable& table) { return table.rows.size() < 2; });
    return tables;
}

// "{|" to "|}": rows part at "|-", cells begin with "|" or "!", or "||" and "!!" in a line; text before a
// single "|" in a cell is formatting.
class WikiReader {
public:
    QList<MarkupTable> read(const QString& text) && {
        int number = 0;
        for (const QStringView raw : QStringView(text).split(u'\n')) {
            ++number;
            const QStringView line = raw.trimmed();
            if (line.startsWith(u"{|")) {
                m_tables << MarkupTable{Markup::Wiki, {}};
                m_isInside = true;
            } else if (!m_isInside) {
                continue;
            } else if (line.startsWith(u"|}")) {
                endRow();
                m_isInside = false;
            } else if (line.startsWith(u"|-")) {
                endRow();
            } else if ((line.startsWith(u'|') && !line.startsWith(u"|+")) || line.startsWith(u'!')) {
                m_row.line = number;
                addCells(line.sliced(1).toString());
            }
        }
        endRow();
        return std::move(m_tables);
    }

private:
    void addCells(QString line) {
        line.replace(QStringLiteral("!!"), QStringLiteral("||"));
        for (QString cell : line.split(QStringLiteral("||"))) {
            const qsizetype bar = cell.indexOf(u'|');
            if (bar >= 0 && cell.first(bar).contains(u'=')) cell = cell.sliced(bar + 1);
            m_row.cells << textOfWiki(cell);
        }
    }

    // Contents of {{math|0.5}}, [[target|text]] and '''bold''' without markup.
    static QString textOfWiki(QString cell) {
        if (cell.size() > longestArgument) return cell; // too long for a number
        static const QRegularExpression model(QStringLiteral(
            R"(\{\{(?:(?:math|mvar|nowrap|nobold|small|big|center|right)\s*\|)?([^{}|]*)\}\})"));
        static const QRegularExpression fraction(
            QStringLiteral(R"(\{\{[st]?frac\s*\|([^{}|=]*)\|([^{}|=]*)\}\})"));
        static const QRegularExpression exponent(
            QStringLiteral(R"(\{\{val\s*\|([^{}|=]*)\|e=([^{}|=]*)\}\})"));
        static const QRegularExpression value(QStringLiteral(R"(\{\{(?:val|gaps)\s*\|([^{}|=]*)\}\})"));
        static const QRegularExpression note(QStringLiteral("<ref[^>/]*(?:/>|>.*?</ref>)"));
        cell.remove(note);
        cell.replace(fraction, QStringLiteral("\\1/\\2")).replace(exponent, QStringLiteral("\\1e\\2"));
        cell.replace(value, QStringLiteral("\\1"));
        static const QRegularExpression link(QStringLiteral(R"(\[\[(?:[^\]|]*\|)?([^\]]*)\]\])"));
        static const QRegularExpression math(QStringLiteral("<math[^>]*>(.*?)</math>"));
        cell.replace(QStringLiteral("{{minus}}"), QStringLiteral("-"));
        cell.replace(model, QStringLiteral("\\1")).replace(link, QStringLiteral("\\1"));
        cell.remove(QStringLiteral("'''")).remove(QStringLiteral("''"));
        for (auto found = math.match(cell); found.hasMatch(); found = math.match(cell))
            cell.replace(found.capturedStart(), found.capturedLength(), plainLatex(found.capturedView(1)));
        return textOfHtml(cell);
    }

    void endRow() {
        if (m_isInside && !isEmptyRow(m_row.cells) && m_tables.last().rows.size() < maxTableRows)
            m_tables.last().rows << m_row;
        m_row = {};
    }

    bool m_isInside = false;
    MarkupRow m_row;
    QList<MarkupTable> m_tables;
};

} // namespace

QList<MarkupTable> markupTables(const QString& text) {
    QList<MarkupTable> tables = htmlTables(text);
    if (tables.isEmpty() && text.contains(QStringLiteral("{|"))) tables = WikiReader().read(text);
    if (tables.isEmpty()) tables = markdownTables(text);
    if (tables.isEmpty()) tables = latexTables(text);
    return tables;
}

QList<LatexMatrix> latexMatrices(const QString& source) {
    const QString text = withoutLatexComments(source);
    QList<LatexMatrix> matrices;
    for (const Environment& one : environments(text, true)) {
        if (!one.name.contains(u"matrix") && one.name != u"array") continue;
        LatexMatrix matrix{{}, one.begin, one.end};
        for (const auto& raw :
             RowSplitter(QStringView(text).sliced(one.body, one.bodyEnd - one.body)).split(false)) {
            const QStringList cells = plainCells(raw.cells);
            if (!isEmptyRow(cells)) matrix.rows << cells;
        }
        matrices << matrix;
    }
    return matrices;
}

namespace {

// An angle, whose number depends on its column: 90° and π/2 are the same, and 90 in a column of degrees.
bool hasUnit(QStringView text, double value) {
    const auto degrees = evaluate(text, NumberUnit::Degrees);
    return degrees && *degrees != value;
}

} // namespace

QString tableCell(const QString& text) {
    static const QRegularExpression decimalComma(QStringLiteral("^[-+]?\\d*,\\d+([eE][-+]?\\d+)?%?$"));
    QString cell = withPowersOfTen(plainSigns(text).simplified());
    if (cell.startsWith(u"- ")) cell.remove(1, 1);
    if (cell.endsWith(u" %")) cell.remove(cell.size() - 2, 1);
    if (decimalComma.match(cell).hasMatch()) cell.replace(u',', u'.');
    const bool isShare = cell.endsWith(u'%');
    const QStringView number = QStringView(cell).chopped(isShare ? 1 : 0);
    const bool hasDigit = std::ranges::any_of(number, [](QChar c) { return c.isDigit(); });
    if (const auto value = hasDigit || number == u"π" ? evaluate(number) : std::nullopt) {
        if (hasUnit(number, *value)) return number.toString().remove(u' ');
        return QString::fromLatin1(formatNumber(*value)) + (isShare ? QStringLiteral("%") : QString());
    }
    for (QChar& c : cell)
        if (QStringView(u",;\"\t").contains(c)) c = u' ';
    cell = cell.simplified();
    return cell.contains(u' ') ? u'"' + cell + u'"' : cell;
}

} // namespace io
