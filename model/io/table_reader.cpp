// SPDX-License-Identifier: MIT
#include "io/table_reader.h"

#include "io/coefficient.h"
#include "io/number.h"
#include "io/written_weights.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxRows = 250'000;
constexpr qsizetype longestRow =
    maxRows + 1; // cells: a label, and of a table that has a column for every map
constexpr qsizetype maxProblems = 10;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

struct Cell {
    QString text;
    int line = 1;
    int column = 1; // both from 1; the column in bytes of the UTF-8 text
};
using Row = QList<Cell>;

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
Row cellsOf(QStringView text, int line, const Dialect& dialect) {
    Row cells;
    Cell cell;
    cell.line = line;
    int column = 1;
    for (const QChar c : text) {
        if (c == QLatin1Char(';') && dialect.separator != Separator::Semicolon) break; // a comment
        if (isSeparator(c, dialect) || c.isSpace()) {
            if (!cell.text.isEmpty()) cells << cell;
            if (cells.size() > longestRow) return cells;
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
    if (text.size() <= 2) text = text.normalized(QString::NormalizationForm_KD); // ½ → 1⁄2
    text.replace(QChar(0x2044), QLatin1Char('/'));
    const qsizetype slash = text.indexOf(QLatin1Char('/'));
    if (slash < 0) return parseNumber(text);
    const auto numerator = parseNumber(text.left(slash));
    const auto denominator = parseNumber(text.mid(slash + 1));
    if (!numerator || !denominator || !std::isfinite(*numerator / *denominator)) return std::nullopt;
    return *numerator / *denominator;
}

// Semicolons or tabs between all numbers of a row leave the comma free to be the decimal one. Fewer
// semicolons begin a comment, as in Fractint's files.
Dialect dialectOf(QStringView text) {
    constexpr qsizetype fewestSeparators = 5;
    bool semicolons = false;
    bool tabs = false;
    bool comma = false; // outside of comments
    for (const QStringView line : text.tokenize(u'\n')) {
        semicolons = semicolons || line.count(u';') >= fewestSeparators;
        tabs = tabs || line.trimmed().count(u'\t') >= fewestSeparators;
        const qsizetype comment = line.indexOf(u';');
        comma = comma || line.first(comment < 0 ? line.size() : comment).contains(u',');
    }
    if (semicolons) return {Separator::Semicolon, text.contains(u',')};
    if (tabs) return {Separator::Tab, comma};
    return {comma ? Separator::Comma : Separator::Blank, false};
}

class TableParser {
public:
    TableParser(const QString& text, const std::optional<TableColumns>& columns)
        : m_text(withLineFeeds(text)),
          m_dialect(dialectOf(m_text)),
          m_chosen(columns.has_value()),
          m_columns(columns.value_or(fractintColumns())) {
        m_table.isOrdered = m_chosen;
    }

    bool beginsWithMatrices() && { return beginsWithACount(rows(5)); }

    Table read() && {
        const QList<Row> beginning = rows(mostTransposed + 1);
        if (beginsWithACount(beginning)) {
            startOver();
            readMatrices();
        } else if (const auto turned = transposed(beginning)) {
            for (const Row& row : *turned)
                readRow(row);
        } else {
            startOver();
            for (QList<Row> row = rows(1); !row.isEmpty() && m_table.problems.size() < maxProblems;
                 row = rows(1))
                readRow(row.first());
        }
        if (m_table.rows.empty() && m_table.problems.isEmpty())
            fail({}, Text::tr("There are no rows of numbers: a row is a b c d e f and perhaps a weight."));
        if (std::find(m_columns.begin(), m_columns.end(), TableColumn::Cumulative) != m_columns.end())
            takeDifferences();
        return std::move(m_table);
    }

private:
    static constexpr qsizetype mostTransposed = 12; // rows of a table that has a column for every map

    static QString withLineFeeds(QString text) {
        return text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"))
            .replace(QLatin1Char('\r'), QLatin1Char('\n'));
    }

    void startOver() { m_next = m_line = 0; }

    // The next rows that are not empty, at most so many.
    QList<Row> rows(qsizetype most) {
        QList<Row> found;
        while (m_next < m_text.size() && found.size() < most) {
            const qsizetype feed = m_text.indexOf(u'\n', m_next);
            const qsizetype end = feed < 0 ? m_text.size() : feed;
            Row cells = cellsOf(QStringView(m_text).sliced(m_next, end - m_next), ++m_line, m_dialect);
            if (!cells.isEmpty()) found << std::move(cells);
            m_next = end + 1;
        }
        return found;
    }

    bool isHeader(const Row& cells) const {
        return std::none_of(cells.begin(), cells.end(),
                            [this](const Cell& cell) { return value(cell.text, m_dialect).has_value(); });
    }

    static QStringList namesIn(const Row& cells) {
        QStringList names;
        for (const Cell& cell : cells)
            names << cell.text;
        return names;
    }

    // One column per map: every row begins with the name of what it holds.
    std::optional<QList<Row>> transposed(const QList<Row>& table) const {
        if (table.size() < 6 || table.size() > 7 || isHeader(table.first())) return std::nullopt;
        QStringList names;
        for (const Row& row : table) {
            if (row.size() != table.first().size()) return std::nullopt;
            names << row.first().text;
        }
        if (!tableColumns(names)) return std::nullopt;
        QList<Row> turned(table.first().size());
        for (const Row& row : table)
            for (qsizetype i = 0; i < row.size(); ++i)
                turned[i] << row[i];
        return turned;
    }

    // "3", then for every map a line with its weight and three lines of a matrix that ends in 0 0 1.
    bool beginsWithACount(const QList<Row>& table) const {
        return table.size() >= 5 && table[0].size() == 1 && table[1].size() == 1 && table[2].size() == 3 &&
               value(table[0][0].text, m_dialect).has_value();
    }

    void readMatrices() {
        const Cell count = rows(1).first().first();
        m_columns = fractintColumns();
        m_table.isOrdered = true;
        for (QList<Row> map = rows(4); !map.isEmpty() && m_table.problems.isEmpty(); map = rows(4)) {
            if (map.size() != 4 || map[0].size() != 1 || map[1].size() != 3 || map[2].size() != 3 ||
                map[3].size() != 3)
                return fail(map[0][0],
                            Text::tr("After the count, a map is its weight and a matrix of 3 rows."));
            const Row flat{map[1][0], map[1][1], map[2][0], map[2][1], map[1][2], map[2][2], map[0][0]};
            const auto last = [&](qsizetype i) { return value(map[3][i].text, m_dialect); };
            if (last(0) != 0.0 || last(1) != 0.0 || last(2) != 1.0)
                return fail(map[3][0], Text::tr("The last row of the matrix of an affine map is 0 0 1."));
            addRow(flat);
        }
        if (m_table.problems.isEmpty() && value(count.text, m_dialect) != double(m_table.rows.size()))
            fail(count, Text::tr("The table says that it has %1 maps, and it has %2.")
                            .arg(count.text)
                            .arg(m_table.rows.size()));
    }

    void readHeader(const Row& cells) {
        if (!m_table.rows.empty() || m_hasHeader)
            return fail(cells.first(), Text::tr("“%1” is not a number.").arg(cells.first().text));
        m_hasHeader = true;
        if (m_chosen) return;
        QStringList names = namesIn(cells);
        auto columns = tableColumns(names);
        if (!columns && names.size() > 6) {
            names.removeFirst(); // what stands over the labels
            columns = tableColumns(names);
        }
        if (columns) {
            m_columns = *columns;
            m_table.isOrdered = true;
        } else {
            m_unknownHeader = cells;
        }
    }

    void readRow(Row cells) {
        if (isHeader(cells)) return readHeader(cells);
        if (cells.size() == m_unknownHeader.size() && cells.size() >= 6) {
            m_table.isTable = true;
            return fail(
                m_unknownHeader.first(),
                Text::tr("The header does not say which column is a, b, c, d, e and f; choose the order of "
                         "the columns."));
        }
        m_unknownHeader.clear();
        if (!value(cells.first().text, m_dialect) || cells.size() == 8)
            cells.removeFirst(); // a label: ƒ1, w1, 1
        if (cells.size() != 6 && cells.size() != 7)
            return fail(cells.isEmpty() ? Cell{} : cells.first(),
                        Text::tr("This row has %1 numbers; a map is 6 numbers, or 7 with its weight.")
                            .arg(cells.size()));
        addRow(cells);
    }

    void addRow(const Row& cells) {
        std::vector<double> numbers;
        for (const Cell& cell : cells) {
            const auto number = value(cell.text, m_dialect);
            if (!number) return fail(cell, Text::tr("“%1” is not a decimal number.").arg(cell.text.left(40)));
            numbers.push_back(*number);
        }
        if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return isCoefficient(number); }))
            return fail(
                cells.first(),
                Text::tr("A number of this row is larger than a coefficient can be (3.4e38 in size)."));
        if (static_cast<qsizetype>(m_table.rows.size()) >= maxRows)
            return fail(cells.first(),
                        Text::tr("The table has more than %1 rows, which is the limit.").arg(maxRows));
        m_table.rows.push_back(mapOf(m_columns, numbers));
        m_table.isTable = true;
    }

    void takeDifferences() {
        double before = 0;
        for (auto& row : m_table.rows) {
            const double sum = row.weight.value_or(before);
            row.weight = sum - before;
            before = sum;
        }
    }

    void fail(const Cell& where, const QString& message) {
        const int line = where.text.isEmpty() ? 0 : where.line;
        m_table.problems.append({Problem::Severity::Error, {}, line, line == 0 ? 0 : where.column, message});
    }

    QString m_text; // lines end in LF
    Dialect m_dialect;
    bool m_chosen;
    TableColumns m_columns;
    qsizetype m_next = 0; // where the next line begins
    int m_line = 0;       // lines before it
    bool m_hasHeader = false;
    Row m_unknownHeader;
    Table m_table;
};

} // namespace

Table readTable(const QString& text, const std::optional<TableColumns>& columns) {
    if (text.size() > largestTable) {
        Table table;
        table.problems.append(
            {Problem::Severity::Error,
             {},
             0,
             0,
             Text::tr("The text has more than 64 MB, which is the limit for a table of numbers.")});
        return table;
    }
    return TableParser(text, columns).read();
}

ifs::IteratedFunctionSystem<2> systemOf(const Table& table) {
    ifs::IteratedFunctionSystem<2> system{table.rows};
    std::uint32_t number = 0;
    for (auto& map : system.maps)
        map.id = static_cast<ifs::MapId>(++number);
    return system;
}

bool beginsWithMatrices(const QString& beginning) {
    return TableParser(beginning, std::nullopt).beginsWithMatrices();
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

QByteArray writeTable(const ifs::IteratedFunctionSystem<2>& system, const TableColumns& columns,
                      TableSeparator separator) {
    const bool cumulative =
        std::find(columns.begin(), columns.end(), TableColumn::Cumulative) != columns.end();
    const QByteArray between(1, separator == TableSeparator::Comma ? ',' : '\t');
    QByteArray text = columnNames(columns).join(QString::fromLatin1(between)).toLatin1() + '\n';
    const std::vector<double> weights = writtenWeights(system);
    double sum = 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        sum += weights[i];
        QByteArrayList cells;
        for (const double number : numbersOf(columns, system.maps[i].map, cumulative ? sum : weights[i]))
            cells << formatNumber(number);
        text += cells.join(between) + '\n';
    }
    return text;
}

} // namespace io
