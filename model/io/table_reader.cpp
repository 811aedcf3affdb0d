// SPDX-License-Identifier: MIT
#include "io/table_reader.h"

#include "io/number.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxRows = 250'000;
constexpr qsizetype maxProblems = 10;

QString tr(const char* sentence) {
    return QCoreApplication::translate("io", sentence);
}

struct Cell {
    QString text;
    int column = 1; // 1-based, in bytes of the UTF-8 text
};

enum class Separator { Semicolon, Tab, Comma, Blank };

struct Dialect {
    Separator separator = Separator::Blank;
    bool decimalComma = false;
};

bool isSeparator(QChar c, const Dialect& dialect) {
    switch (dialect.separator) {
    case Separator::Semicolon:
        return c == QLatin1Char(';');
    case Separator::Tab:
        return c == QLatin1Char('\t');
    case Separator::Comma:
        return c == QLatin1Char(',') || c.isSpace();
    case Separator::Blank:
        return c.isSpace();
    }
    return false;
}

// Blanks inside a cell separate numbers as well: "0.5 0; 0 0.5" is two cells with two numbers each.
QList<Cell> cellsOf(const QString& line, const Dialect& dialect) {
    QList<Cell> cells;
    Cell cell;
    int column = 1;
    for (const QChar c : line) {
        if (c == QLatin1Char(';') && dialect.separator != Separator::Semicolon) break; // a comment
        if (isSeparator(c, dialect) || c.isSpace()) {
            if (!cell.text.isEmpty()) cells << cell;
            cell.text.clear();
        } else {
            if (cell.text.isEmpty()) cell.column = column;
            cell.text += c;
        }
        // Halves of a surrogate pair make 4 bytes together.
        column += c.unicode() < 0x80 ? 1 : c.unicode() < 0x800 || c.isSurrogate() ? 2 : 3;
    }
    if (!cell.text.isEmpty()) cells << cell;
    return cells;
}

std::optional<double> value(QString text, const Dialect& dialect) {
    text.replace(QChar(0x2212), QLatin1Char('-'));
    if (dialect.decimalComma) {
        if (text.contains(QLatin1Char('.'))) return std::nullopt;
        text.replace(QLatin1Char(','), QLatin1Char('.'));
    }
    return parseNumber(text);
}

// Semicolons or tabs between all numbers of a row leave the comma free to be the decimal one. Fewer
// semicolons begin a comment, as in Fractint's files.
Dialect dialectOf(const QStringList& lines) {
    constexpr qsizetype fewestSeparators = 5;
    const auto separates = [&](QChar c) {
        return std::any_of(lines.begin(), lines.end(),
                           [c](const QString& line) { return line.trimmed().count(c) >= fewestSeparators; });
    };
    const bool comma = std::any_of(lines.begin(), lines.end(), [](const QString& line) {
        return line.section(QLatin1Char(';'), 0, 0).contains(QLatin1Char(','));
    });
    const bool anyComma = std::any_of(lines.begin(), lines.end(),
                                      [](const QString& line) { return line.contains(QLatin1Char(',')); });
    if (separates(QLatin1Char(';'))) return {Separator::Semicolon, anyComma};
    if (separates(QLatin1Char('\t'))) return {Separator::Tab, comma};
    return {comma ? Separator::Comma : Separator::Blank, false};
}

bool isHeader(const QList<Cell>& cells, const Dialect& dialect) {
    return std::none_of(cells.begin(), cells.end(),
                        [&](const Cell& cell) { return value(cell.text, dialect).has_value(); });
}

// The order of the columns is Fractint's unless a header says otherwise.
bool isForeignHeader(const QList<Cell>& cells) {
    static const QStringList letters{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"),
                                     QStringLiteral("d"), QStringLiteral("e"), QStringLiteral("f")};
    QStringList named;
    for (const Cell& cell : cells)
        if (const QString name = cell.text.toLower(); letters.contains(name)) named << name;
    return named.size() == letters.size() && named != letters;
}

class TableParser {
public:
    explicit TableParser(const QString& text) : m_lines(linesOf(text)), m_dialect(dialectOf(m_lines)) {}

    Table read() && {
        int number = 0;
        for (const QString& line : m_lines) {
            ++number;
            const QList<Cell> cells = cellsOf(line, m_dialect);
            if (!cells.isEmpty()) readRow(number, cells);
            if (m_table.problems.size() >= maxProblems) break;
        }
        if (m_table.rows.empty() && m_table.problems.isEmpty())
            fail(0, 0,
                 tr("There are no rows of numbers to paste: a row is a b c d e f and perhaps a weight."));
        return std::move(m_table);
    }

private:
    static QStringList linesOf(QString text) {
        text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"))
            .replace(QLatin1Char('\r'), QLatin1Char('\n'));
        return text.split(QLatin1Char('\n'));
    }

    void readRow(int line, QList<Cell> cells) {
        if (isHeader(cells, m_dialect)) {
            if (!m_table.rows.empty() || m_hasHeader)
                fail(line, cells.first().column, tr("“%1” is not a number.").arg(cells.first().text));
            else if (isForeignHeader(cells))
                fail(line, cells.first().column,
                     tr("The columns are not in the order a b c d e f; reorder them and paste again."));
            m_hasHeader = true;
            return;
        }
        if (!value(cells.first().text, m_dialect) || cells.size() == 8)
            cells.removeFirst(); // a label: ƒ1, w1, 1
        std::array<double, 7> numbers{};
        if (cells.size() != 6 && cells.size() != 7)
            return fail(
                line, cells.isEmpty() ? 1 : cells.first().column,
                tr("This row has %1 numbers; a map is 6 numbers, or 7 with its weight.").arg(cells.size()));
        for (qsizetype i = 0; i < cells.size(); ++i) {
            const auto number = value(cells[i].text, m_dialect);
            if (!number)
                return fail(line, cells[i].column,
                            tr("“%1” is not a decimal number.").arg(cells[i].text.left(40)));
            numbers[static_cast<std::size_t>(i)] = *number;
        }
        addRow(line, numbers, cells.size() == 7);
    }

    void addRow(int line, const std::array<double, 7>& n, bool hasWeight) {
        if (static_cast<qsizetype>(m_table.rows.size()) >= maxRows)
            return fail(line, 1, tr("The table has more than %1 rows, which is the limit.").arg(maxRows));
        ifs::WeightedMap<2> row;
        row.map = ifs::affineMap(n[0], n[1], n[2], n[3], n[4], n[5]);
        if (hasWeight) row.weight = n[6];
        m_table.rows.push_back(row);
    }

    void fail(int line, int column, const QString& message) {
        m_table.problems.append({Problem::Severity::Error, {}, line, column, message});
    }

    QStringList m_lines;
    Dialect m_dialect;
    bool m_hasHeader = false;
    Table m_table;
};

} // namespace

Table readTable(const QString& text) {
    return TableParser(text).read();
}

QString writeTable(const std::vector<ifs::WeightedMap<2>>& rows) {
    QByteArray text;
    for (const auto& row : rows) {
        const auto& [linear, translation] = row.map;
        for (const double number : {linear(0, 0), linear(0, 1), linear(1, 0), linear(1, 1), translation[0]})
            text += formatNumber(number) + '\t';
        text += formatNumber(translation[1]);
        if (row.weight) text += '\t' + formatNumber(*row.weight);
        text += '\n';
    }
    return QString::fromLatin1(text);
}

} // namespace io
