// SPDX-License-Identifier: MIT
#include "io/table/table_reader.h"

#include "io/table/table_cells.h"
#include "io/text/coefficient.h"
#include "io/text/export_weights.h"
#include "io/text/number.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxRows = 250'000;
constexpr qsizetype maxRow = maxRows + 1; // cells: a label, and of a table that has a column for every map
constexpr qsizetype maxProblems = 10;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

QString withLineFeeds(QString text) {
    return text.replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u'\n');
}

// A word that nobody meant as a number: w1, ƒ1, "f(1)", 1: — and neither O.5 nor nan.
bool looksLikeLabel(const QString& text) {
    if (text.endsWith(u':') || text.endsWith(u')')) return true;
    for (const char* number : {"nan", "inf", "infinity"})
        if (text.compare(QLatin1String(number), Qt::CaseInsensitive) == 0) return false;
    return !text.isEmpty() && (text[0].isLetter() || text[0] == u'#') && !text.contains(u'.') &&
           !text.contains(u',');
}

// Names of the columns a … l of a map in space, with or without its weight.
enum class SpaceHeader { None, Plain, Weighted };
SpaceHeader spaceHeader(const QStringList& names) {
    QString letters;
    for (const QString& name : names)
        letters += name.toLower();
    return letters == u"abcdefghijkl"    ? SpaceHeader::Plain
           : letters == u"abcdefghijklp" ? SpaceHeader::Weighted
                                         : SpaceHeader::None;
}

class TableParser {
public:
    TableParser(const QString& text, const Dialect& dialect, const std::optional<TableColumns>& columns,
                TableMaps wanted)
        : m_text(text),
          m_dialect(dialect),
          m_chosen(columns.has_value()),
          m_wanted(m_chosen ? TableMaps::Plane : wanted),
          m_columns(columns.value_or(fractintColumns())) {
        m_table.isOrdered = m_chosen;
    }

    bool beginsWithMatrices() && { return beginsWithACount(rows(5)); }

    Table read() && {
        const QList<Row> beginning = rows(maxTransposed + 1);
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
        if (m_table.rows.empty() && m_table.spaceRows.empty() && m_table.problems.isEmpty())
            fail({},
                 Text::tr(
                     "There are no rows of numbers: a row consists of a b c d e f and optionally a weight."));
        if (std::find(m_columns.begin(), m_columns.end(), TableColumn::Cumulative) != m_columns.end())
            takeDifferences();
        return std::move(m_table);
    }

private:
    static constexpr qsizetype maxTransposed = 12; // rows of a table that has a column for every map
    static constexpr qsizetype planeNumbers = 6;   // of a map without its weight
    static constexpr qsizetype spaceNumbers = 12;

    std::optional<double> value(const Cell& cell) const { return numberIn(cell, m_dialect); }
    // Of a number in a row with that many.
    NumberUnit unitOf(std::size_t number, std::size_t count) const {
        return count < std::size_t(spaceNumbers) ? unitOfNumber(m_columns, number, count) : NumberUnit::None;
    }

    void startOver() { m_next = m_line = 0; }

    // The next rows that are not empty, at most so many.
    QList<Row> rows(qsizetype most) {
        QList<Row> found;
        while (m_next < m_text.size() && found.size() < most) {
            const qsizetype feed = m_text.indexOf(u'\n', m_next);
            const qsizetype end = feed < 0 ? m_text.size() : feed;
            Row cells =
                cellsOf(QStringView(m_text).sliced(m_next, end - m_next), ++m_line, m_dialect, maxRow);
            if (!cells.isEmpty() && !isRemark(cells)) found << std::move(cells);
            m_next = end + 1;
        }
        return found;
    }

    // "# …" is a comment, unless it names the columns.
    static bool isRemark(Row& cells) {
        if (!cells.first().text.startsWith(u'#') || looksLikeNumberSign(cells.first().text)) return false;
        Row named = cells;
        named.first().text.remove(0, 1);
        if (named.first().text.isEmpty()) named.removeFirst();
        if (!tableColumns(namesIn(named)) && spaceHeader(namesIn(named)) == SpaceHeader::None) return true;
        cells = named;
        return false;
    }

    // "#1" as a label.
    static bool looksLikeNumberSign(const QString& text) { return text.size() > 1 && text[1].isDigit(); }

    bool isHeader(const Row& cells) const {
        return std::none_of(cells.begin(), cells.end(),
                            [this](const Cell& cell) { return value(cell).has_value(); });
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

    // "3", then for every map a line with its weight and three lines of a matrix that ends in 0 0 1; or all
    // ten on a line.
    bool beginsWithACount(const QList<Row>& table) const {
        if (table.size() < 2 || table[0].size() != 1 || !value(table[0][0])) return false;
        return table[1].size() == 10 || (table.size() >= 5 && table[1].size() == 1 && table[2].size() == 3);
    }

    void readMatrices() {
        const Cell count = rows(1).first().first();
        m_columns = fractintColumns();
        m_table.isOrdered = true;
        Row map;
        for (QList<Row> row = rows(1); !row.isEmpty() && m_table.problems.isEmpty(); row = rows(1)) {
            map += row.first();
            for (; map.size() >= 10 && m_table.problems.isEmpty(); map.remove(0, 10))
                addMatrix(map);
        }
        if (!m_table.problems.isEmpty()) return;
        if (!map.isEmpty())
            fail(map.first(),
                 Text::tr("After the count, a map consists of its weight and a matrix of 3 rows."));
        else if (value(count) != double(m_table.rows.size()))
            fail(count, Text::tr("The count says %1, but the number of maps is %2.")
                            .arg(count.text)
                            .arg(m_table.rows.size()));
    }

    void addMatrix(const Row& map) {
        if (value(map[7]) != 0.0 || value(map[8]) != 0.0 || value(map[9]) != 1.0)
            return fail(map[7], Text::tr("The last row of the matrix of an affine map must be 0 0 1."));
        addRow({map[1], map[2], map[4], map[5], map[3], map[6], map[0]});
    }

    void readHeader(const Row& cells) {
        if (!m_table.rows.empty() || !m_table.spaceRows.empty() || m_isOrderKnown)
            return fail(cells.first(), Text::tr("“%1” is not a number.").arg(cells.first().text));
        m_header = cells;
        if (m_chosen) return;
        QStringList names = namesIn(cells);
        m_isOrderKnown = takeNames(names);
        if (!m_isOrderKnown && names.size() > planeNumbers) { // what stands over the labels, perhaps in words
            names.remove(0, wordsOfField(cells));
            m_isOrderKnown = takeNames(names);
            m_labels = m_isOrderKnown ? Labels::Named : Labels::Unknown;
        }
        m_table.isOrdered = m_isOrderKnown;
        m_table.isTable = m_isOrderKnown;
    }

    // Whether the names say which column is which.
    bool takeNames(const QStringList& names) {
        if (const SpaceHeader space = spaceHeader(names); space != SpaceHeader::None) {
            if (m_wanted == TableMaps::Plane) return false;
            m_fewest = names.size();
            m_most = spaceNumbers + 1;
            return true;
        }
        const auto columns = tableColumns(names);
        if (!columns) return false;
        m_columns = *columns;
        m_fewest = names.size();
        m_most = planeNumbers + 1;
        return true;
    }

    void failOrder() {
        m_table.isTable = true;
        fail(m_header.first(),
             Text::tr("The header does not say which column is a, b, c, d, e and f; choose the order of "
                      "the columns."));
    }

    void readRow(const Row& cells) {
        if (isHeader(cells)) return readHeader(cells);
        if (!m_chosen && !m_isOrderKnown && !m_header.isEmpty()) {
            const bool isOverIt = m_dialect.separator == Separator::Blank ? cells.size() == m_header.size()
                                                                          : cells.size() >= m_header.size();
            if (isOverIt && m_header.size() >= planeNumbers) return failOrder();
            m_header.clear(); // a title
        }
        const auto start = beginOfNumbers(cells);
        const qsizetype count = cells.size() - start.value_or(0);
        if (!start || (!isExpected(count) && !isWithoutItsWeight(count))) return failCount(cells, count);
        if (*start > 0 && !isNextLabel(cells.first()))
            return m_header.isEmpty() ? failCount(cells, cells.size()) : failOrder();
        if (m_labels == Labels::Unknown) m_labels = *start > 0 ? Labels::Found : Labels::None;
        addRow(cells.sliced(*start));
    }

    bool isExpected(qsizetype count) const {
        if (m_most > 0) return count == m_most || count == m_fewest;
        return count == planeNumbers || count == planeNumbers + 1 ||
               (m_wanted == TableMaps::PlaneOrSpace && !m_dialect.isMixed &&
                (count == spaceNumbers || count == spaceNumbers + 1));
    }

    // ".5,0,0,.5,0,0," under a header: separators show that it is the last cell that is empty.
    bool isWithoutItsWeight(qsizetype count) const {
        return m_dialect.separator != Separator::Blank && m_columns.back() == TableColumn::Weight &&
               m_most > 0 && count == m_most - 1;
    }

    // What stands before the numbers is a label only where it cannot be a number gone wrong, and where as
    // many numbers are left as a row has. nullopt: it could be both.
    std::optional<qsizetype> beginOfNumbers(const Row& cells) const {
        if (m_labels == Labels::None) return 0;
        if (m_labels == Labels::Named) return wordsOfField(cells);
        if (value(cells.first())) {
            if (isExpected(cells.size())) return m_labels == Labels::Found ? std::nullopt : std::optional(0);
            return m_header.isEmpty() && !m_dialect.isMixed ? 1 : 0;
        }
        const qsizetype words = wordsOfLabel(cells);
        return looksLikeLabel(cells.first().text) && isExpected(cells.size() - words) ? words : 0;
    }

    static qsizetype wordsOfField(const Row& cells) {
        const auto next =
            std::find_if(cells.begin() + 1, cells.end(), [](const Cell& cell) { return !cell.isContinued; });
        return next - cells.begin();
    }

    // Of "map 1,0.5,0 …" two, of "w1 0.5,0 …" one; 0 of what could be both.
    qsizetype wordsOfLabel(const Row& cells) const {
        const qsizetype words = wordsOfField(cells);
        if (words == 1) return 1;
        const bool one = isExpected(cells.size() - 1);
        const bool all = isExpected(cells.size() - words);
        return one && all ? 0 : all ? words : 1;
    }

    // Labels that are numbers count the maps.
    bool isNextLabel(const Cell& cell) {
        const auto number = value(cell);
        if (!number) return true;
        const bool isNext =
            m_lastLabel ? *number == *m_lastLabel + 1 : *number >= 0 && *number == std::floor(*number);
        m_lastLabel = number;
        return isNext;
    }

    void failCount(const Row& cells, qsizetype count) {
        const bool isNoNumber = !value(cells.first());
        if (isNoNumber && m_labels != Labels::Named) return fail(cells.first(), notANumber(cells.first()));
        if (m_most > 0 && m_fewest == m_most)
            return fail(cells.first(),
                        Text::tr("The header names %2 columns, but this row has %1.").arg(count).arg(m_most));
        fail(cells.first(),
             Text::tr("A map has 6 numbers, or 7 with its weight; this row has %1.").arg(count));
    }

    static QString notANumber(const Cell& cell) {
        return cell.text.isEmpty() ? Text::tr("A cell of this row is empty.")
                                   : Text::tr("“%1” is not a decimal number.").arg(cell.text.left(40));
    }

    void addRow(const Row& cells) {
        const auto good = std::count_if(cells.begin(), cells.end(),
                                        [this](const Cell& cell) { return value(cell).has_value(); });
        m_table.isTable = m_table.isTable || 2 * good > cells.size();
        std::vector<double> numbers;
        for (const Cell& cell : cells) {
            const auto number = numberIn(cell, m_dialect, unitOf(numbers.size(), std::size_t(cells.size())));
            if (!number) return fail(cell, notANumber(cell));
            numbers.push_back(*number);
        }
        if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return isCoefficient(number); }))
            return fail(cells.first(), Text::tr("A number in this row is too large for a coefficient (the "
                                                "largest absolute value is 3.4e38)."));
        if (m_table.rows.size() + m_table.spaceRows.size() >= std::size_t(maxRows))
            return fail(cells.first(),
                        Text::tr("The table has more than %1 rows, which is the limit.").arg(maxRows));
        if (cells.size() < spaceNumbers)
            m_table.rows.push_back(mapOf(m_columns, numbers));
        else
            m_table.spaceRows.push_back(spaceMapOf(numbers));
        m_table.lines.push_back(cells.first().line);
        if (!m_table.rows.empty() && !m_table.spaceRows.empty())
            fail(cells.first(), Text::tr("The table mixes maps of the plane and maps of space."));
        else if (!m_table.spaceRows.empty())
            m_table.isOrdered = true;
    }

    static ifs::WeightedMap<3> spaceMapOf(const std::vector<double>& numbers) {
        ifs::WeightedMap<3> row;
        for (std::size_t i = 0; i < 9; ++i)
            row.map.linear(Eigen::Index(i / 3), Eigen::Index(i % 3)) = numbers[i];
        for (std::size_t i = 0; i < 3; ++i)
            row.map.translation[Eigen::Index(i)] = numbers[9 + i];
        if (numbers.size() > 12) row.weight = numbers[12];
        return row;
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
        m_table.problems.append({Problem::Severity::Error, {}, where.line, where.column, message});
    }

    // Named: the header has a column for them. Found: the first row had one, so every row has.
    enum class Labels { Unknown, None, Found, Named };

    const QString& m_text; // lines end in LF
    Dialect m_dialect;
    bool m_chosen;
    TableMaps m_wanted;
    TableColumns m_columns;
    qsizetype m_next = 0; // where the next line begins
    int m_line = 0;       // lines before it
    Row m_header;
    bool m_isOrderKnown = false;        // from the header
    qsizetype m_fewest = 0, m_most = 0; // numbers of a row that the header allows; 0: nothing is known
    Labels m_labels = Labels::Unknown;
    std::optional<double> m_lastLabel;
    Table m_table;
};

} // namespace

Table readTable(const QString& text, const std::optional<TableColumns>& columns, TableMaps wanted) {
    if (text.size() > maxTable) {
        Table table;
        table.problems.append(
            {Problem::Severity::Error,
             {},
             0,
             0,
             Text::tr("The text is larger than 64 MB, which is the limit for a table of numbers.")});
        return table;
    }
    const QString lines = withLineFeeds(text);
    const QList<Dialect> dialects = dialectsOf(lines);
    Table table = TableParser(lines, dialects.first(), columns, wanted).read();
    if (dialects.size() == 1) return table;
    Table other = TableParser(lines, dialects.last(), columns, wanted).read();
    if (hasErrors(other) || (table.rows == other.rows && table.spaceRows == other.spaceRows)) return table;
    if (!hasErrors(table))
        other.problems.append({Problem::Severity::Error,
                               {},
                               0,
                               0,
                               Text::tr("A comma can be a decimal comma or a separator here; both readings "
                                        "give complete rows. Use decimal points.")});
    return other;
}

bool hasErrors(const Table& table) {
    return std::any_of(table.problems.begin(), table.problems.end(),
                       [](const Problem& problem) { return problem.severity == Problem::Severity::Error; });
}

namespace {

template <int Dim> ifs::IteratedFunctionSystem<Dim> numbered(const std::vector<ifs::WeightedMap<Dim>>& rows) {
    ifs::IteratedFunctionSystem<Dim> system{rows};
    std::uint32_t number = 0;
    for (auto& map : system.maps)
        map.id = static_cast<ifs::MapId>(++number);
    return system;
}

} // namespace

bool isOrderOpen(const QString& text) {
    const Table table = readTable(text);
    return table.isTable && !table.isOrdered && !hasErrors(readTable(text, fractintColumns()));
}

ifs::IteratedFunctionSystem<2> systemOf(const Table& table) {
    return numbered(table.rows);
}

ifs::IteratedFunctionSystem<3> spaceSystemOf(const Table& table) {
    return numbered(table.spaceRows);
}

bool isTableToFractintUnknown(const QString& beginning) {
    if (beginning.contains(u'{')) return false;
    const QString lines = withLineFeeds(beginning);
    const Dialect dialect = dialectsOf(lines).first();
    if (TableParser(lines, dialect, std::nullopt, TableMaps::PlaneOrSpace).beginsWithMatrices()) return true;
    const QString whole = lines.left(lines.lastIndexOf(u'\n') < 0 ? lines.size() : lines.lastIndexOf(u'\n'));
    return dialect.separator == Separator::Semicolon &&
           !hasErrors(TableParser(whole, dialect, std::nullopt, TableMaps::PlaneOrSpace).read());
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

namespace {

QByteArray mark(TableSeparator separator) {
    return separator == TableSeparator::Comma ? "," : "\t";
}

template <typename Numbers> QByteArray line(const Numbers& numbers, TableSeparator separator) {
    QByteArrayList cells;
    for (const double number : numbers)
        cells << formatNumber(number);
    return cells.join(mark(separator)) + '\n';
}

} // namespace

QByteArray writeTable(const ifs::IteratedFunctionSystem<2>& system, const TableColumns& columns,
                      TableSeparator separator) {
    const bool cumulative =
        std::find(columns.begin(), columns.end(), TableColumn::Cumulative) != columns.end();
    QByteArray text = columnNames(columns).join(QString::fromLatin1(mark(separator))).toLatin1() + '\n';
    const std::vector<double> weights = exportWeights(system);
    double sum = 0;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        sum += weights[i];
        text += line(numbersOf(columns, system.maps[i].map, cumulative ? sum : weights[i]), separator);
    }
    return text;
}

QByteArray writeTable(const ifs::IteratedFunctionSystem<3>& system, TableSeparator separator) {
    QByteArray text = QByteArray("a b c d e f g h i j k l p\n").replace(" ", mark(separator));
    const std::vector<double> weights = exportWeights(system);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const auto& [linear, translation] = system.maps[i].map;
        std::vector<double> numbers;
        for (const double number : linear.reshaped<Eigen::RowMajor>())
            numbers.push_back(number);
        for (const double number : {translation[0], translation[1], translation[2], weights[i]})
            numbers.push_back(number);
        text += line(numbers, separator);
    }
    return text;
}

} // namespace io
