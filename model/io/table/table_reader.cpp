// SPDX-License-Identifier: MIT
#include "io/table/table_reader.h"

#include "document/text/text.h"
#include "io/table/table_cells.h"
#include "io/table/table_fields.h"
#include "io/text/coefficient.h"
#include "io/text/number.h"
#include "io/text/plain_signs.h"
#include "io/text/typed_coefficient.h"

#include <algorithm>
#include <cmath>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxRow =
    maxTableRows + 1; // label and a cell for each map, in a table with columns for them
constexpr qsizetype maxProblems = 10;

QString plainLinesOf(QString text) {
    text.replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u'\n');
    return withoutOrnaments(std::move(text));
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
        if (std::ranges::count(m_columns, TableColumn::Other) > 0) take(pickedByOrder(m_columns));
    }

    bool beginsWithMatrices() && { return beginsWithACount(rows(5)); }
    bool countsItsMaps() && { return countMaps(rows(maxTransposed + 1), m_dialect); }

    Table read() && {
        const QList<Row> beginning = rows(maxTransposed + 1);
        if (beginsWithACount(beginning)) {
            startOver();
            readMatrices();
        } else if (const auto turned = transposed(beginning)) {
            for (const Row& row : *turned)
                readRow(row);
        } else {
            m_isCounted = !m_chosen && countMaps(beginning, m_dialect);
            startOver();
            qsizetype words = 0; // rows of words before the first map
            for (QList<Row> row = rows(1); !row.isEmpty() && m_table.problems.size() < maxProblems;
                 row = rows(1)) {
                readRow(row.first());
                if (m_table.rows.empty() && m_table.spaceRows.empty() && ++words > maxWords) break;
            }
        }
        if (m_table.rows.empty() && m_table.spaceRows.empty() && m_table.problems.isEmpty())
            fail({}, Text::tr("There are no rows of numbers: a row consists of a b c d e f and optionally a "
                              "weight."));
        if (std::ranges::count(m_columns, TableColumn::Cumulative) > 0) takeDifferences(m_table.rows);
        if (m_space == SpaceHeader::Cumulative) takeDifferences(m_table.spaceRows);
        return std::move(m_table);
    }

private:
    static constexpr qsizetype maxTransposed = 14; // rows of a table that has a column for every map
    static constexpr qsizetype maxWords = 100'000; // rows: a table begins before
    static constexpr qsizetype planeNumbers = 6;   // of a map without its weight
    static constexpr qsizetype spaceNumbers = 12;

    std::optional<double> value(const Cell& cell) const { return numberIn(cell, m_dialect); }
    // Unit of a number in a row of `count` numbers.
    NumberUnit unitOf(std::size_t number, std::size_t count) const {
        return count < std::size_t(spaceNumbers) ? unitOfNumber(m_columns, number, count) : NumberUnit::None;
    }

    void startOver() { m_next = m_line = 0; }

    // Next rows that are not empty, at most `most`.
    QList<Row> rows(qsizetype most) {
        QList<Row> found;
        while (m_next < m_text.size() && found.size() < most) {
            const qsizetype feed = m_text.indexOf(u'\n', m_next);
            const qsizetype end = feed < 0 ? m_text.size() : feed;
            Row cells =
                cellsOf(QStringView(m_text).sliced(m_next, end - m_next), ++m_line, m_dialect, maxRow);
            cells = withSignsJoined(std::move(cells), m_dialect);
            if (!cells.isEmpty() && !isRemark(cells) && !isRule(cells) && !isSum(cells) &&
                !isProse(cells, m_dialect, 1))
                found << std::move(cells);
            m_next = end + 1;
        }
        return found;
    }

    // "# …" is a comment, unless it names the columns or is a label, "#1"; and so are "% …" and "// …".
    static bool isRemark(Row& cells) {
        const QString& first = cells.first().text;
        const bool isDouble = first.startsWith(QStringLiteral("//")) || first == u"--";
        const qsizetype mark = first.startsWith(u'#') || first.startsWith(u'%') ? 1 : isDouble ? 2 : 0;
        if (mark == 0 || (first.size() > 1 && first[1].isDigit()) || (first == u"%" && cells.size() == 7))
            return false;
        Row named = cells;
        named.first().text.remove(0, mark);
        if (named.first().text.isEmpty()) named.removeFirst();
        if (!tableColumns(textsOf(named)) && spaceHeader(textsOf(named)) == SpaceHeader::None) return true;
        cells = named;
        return false;
    }

    bool isHeader(const Row& cells) const {
        return std::none_of(cells.begin(), cells.end(),
                            [this](const Cell& cell) { return value(cell).has_value(); });
    }

    // Rows of a table with a column for each map: every row begins with the name of its values. A row of map
    // names may precede them, and rows of words may follow.
    std::optional<QList<Row>> transposed(QList<Row> table) const {
        if (areColumnsNamed(table)) return std::nullopt;
        for (Row& row : table)
            if (row.size() > 1 && row[1].text == u"=") row.remove(1);
        if (!table.isEmpty() && !tableColumn(nameOfRow(table.first()))) table.removeFirst();
        const bool isSpace = isInSpace(table);
        if (!isSpace) table.removeIf([](const Row& row) { return !tableColumn(nameOfRow(row)); });
        const qsizetype fewest = isSpace ? spaceNumbers : planeNumbers;
        if (table.size() < fewest || table.size() > fewest + 1 || table.first().size() < 2)
            return std::nullopt;
        QStringList names;
        for (Row& row : table) {
            if (row.size() != table.first().size()) return std::nullopt;
            names << (row.first().text = nameOfRow(row));
        }
        if (!nameAllColumns(names)) return std::nullopt;
        QList<Row> turned(table.first().size());
        for (const Row& row : table)
            for (qsizetype i = 0; i < row.size(); ++i)
                turned[i] << row[i];
        return turned;
    }

    static bool isInSpace(const QList<Row>& table) {
        QStringList names;
        for (const Row& row : table)
            names << nameOfRow(row);
        return spaceHeader(names) != SpaceHeader::None;
    }

    static QString nameOfRow(const Row& row) {
        QString name = row.first().text;
        while (name.endsWith(u':') || name.endsWith(u'='))
            name.chop(1);
        return name;
    }

    // True for "3" followed by a line with the weight of each map and three lines of a matrix that ends in 0
    // 0 1, or by all ten numbers on a line.
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
        const bool hasMaps = !m_table.rows.empty() || !m_table.spaceRows.empty();
        if (hasMaps && isProse(cells, m_dialect, 0)) return;
        if (hasMaps || m_isOrderKnown)
            return fail(cells.first(), Text::tr("“%1” is not a number.").arg(cells.first().text));
        m_header = cells;
        if (m_chosen) return pickForOrder();
        QStringList names = textsOf(cells);
        m_isOrderKnown = takeNames(names);
        const auto first = tableColumn(names.first());
        const bool isOverLabels = !first || !isWeight(*first);
        if (!m_isOrderKnown && isOverLabels && names.size() > planeNumbers) { // possibly named in words
            names.remove(0, wordsOfField(cells));
            m_isOrderKnown = takeNames(names);
            m_labels = m_isOrderKnown ? Labels::Named : Labels::Unknown;
        }
        if (!m_isOrderKnown)
            if (auto picks = pickedByName(namesOf(cells)); picks && isWanted(*picks)) {
                take(*std::move(picks));
                m_isOrderKnown = true;
            }
        m_table.isOrdered = m_isOrderKnown;
        m_table.isTable = m_isOrderKnown;
    }

    bool isWanted(const Picks& picks) const { return !picks.isSpace() || m_wanted != TableMaps::Plane; }

    void take(Picks&& picks) {
        m_space = picks.space;
        if (!picks.isSpace()) m_columns = picks.columns;
        m_picks = std::move(picks);
    }

    // Picks columns if there are more than the chosen order has: those with its names, or else those with
    // numbers in the first row.
    void pickForOrder() {
        const QStringList names = namesOf(m_header);
        if (m_picks || names.size() <= qsizetype(m_columns.size()) + 1) return;
        Picks picks{m_columns, {}, {}, names.size()};
        for (qsizetype i = 0; i < names.size(); ++i)
            if (tableColumn(names[i])) picks.fields.push_back(i);
        if (m_isToPick = !fits(picks); !m_isToPick) take(std::move(picks));
    }

    bool fits(const Picks& picks) const {
        return picks.fields.size() == m_columns.size() ||
               (picks.fields.size() + 1 == m_columns.size() && m_columns.back() == TableColumn::Weight);
    }

    void pickNumbers(const Row& cells) {
        m_isToPick = false;
        const QList<Row> fields = fieldsOf(cells);
        Picks picks{m_columns, {}, {}, fields.size()};
        for (qsizetype i = 0; i < fields.size(); ++i)
            if (fields[i].size() == 1 && value(fields[i].first())) picks.fields.push_back(i);
        if (picks.fields.size() == m_columns.size() + 1) picks.fields.erase(picks.fields.begin()); // labels
        if (fits(picks)) take(std::move(picks));
    }

    // Reads the chosen columns of a row with others.
    void readPicked(const Row& cells) {
        const Picks& picks = *m_picks;
        const QList<Row> fields = fieldsOf(cells);
        const bool isByPosition = m_dialect.separator != Separator::Blank || !picks.areAdjacent();
        const bool mayEndEarly = !picks.isSpace() && picks.columns.back() == TableColumn::Weight;
        const qsizetype shift = isByPosition ? 0 : shiftOf(cells, mayEndEarly);
        Row chosen;
        for (const qsizetype field : picks.fields) {
            const qsizetype at = field + shift;
            const bool isLast = mayEndEarly && field == picks.fields.back();
            if (at >= fields.size() || fields[at].first().text.isEmpty()) {
                if (isLast) break;
                return fail(at < fields.size() ? fields[at].first() : cells.first(),
                            at < fields.size() ? notANumber(fields[at].first())
                                               : Text::tr("The header names %2 columns, but this row has %1.")
                                                     .arg(fields.size())
                                                     .arg(picks.width));
            }
            Cell cell = fields[at].first();
            if (isLast && !isByPosition && !weightOf(cell)) break; // words follow
            cell.text = textsOf(fields[at]).join(u' ');
            chosen << cell;
        }
        sayWhatIsNotRead(fields, shift);
        addRow(chosen);
    }

    // Number of cells by which the label of a row is longer than the header's, if blanks separate cells;
    // negative if it is shorter.
    qsizetype shiftOf(const Row& cells, bool mayEndEarly) const {
        const qsizetype first = m_picks->fields.front();
        const qsizetype needed = qsizetype(m_picks->fields.size()) - (mayEndEarly ? 1 : 0);
        const auto isGood = [&](qsizetype begin) {
            return begin + needed <= cells.size() &&
                   std::all_of(cells.begin() + begin, cells.begin() + begin + needed,
                               [this](const Cell& cell) { return value(cell).has_value(); });
        };
        if (isGood(first)) return 0;
        for (qsizetype begin = 0; begin + needed <= cells.size(); ++begin)
            if (isGood(begin)) return begin - first;
        return 0;
    }

    // Reports columns of numbers that are neither read nor labels, once.
    void sayWhatIsNotRead(const QList<Row>& fields, qsizetype shift) {
        if (m_table.rows.size() + m_table.spaceRows.size() > 0 || m_header.isEmpty()) return;
        const QList<Row> names = fieldsOf(m_header);
        QStringList unread;
        for (qsizetype i = 1; i < std::min(names.size(), fields.size() - shift); ++i)
            if (std::ranges::count(m_picks->fields, i) == 0 && i + shift >= 0 &&
                weightOf(fields[i + shift].first()) && names[i].first().text != u"")
                unread << textsOf(names[i]).join(u' ');
        if (!unread.isEmpty())
            m_table.problems.append({Problem::Severity::Warning,
                                     {},
                                     m_header.first().line,
                                     1,
                                     Text::tr("Columns that do not belong to a map are not read: %1.")
                                         .arg(unread.join(QStringLiteral(", ")))});
    }

    // Returns true if the names determine the columns.
    bool takeNames(const QStringList& names) {
        if (const SpaceHeader space = spaceHeader(names); space != SpaceHeader::None) {
            if (m_wanted == TableMaps::Plane) return false;
            m_space = space;
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
        const QString sentence = Text::tr("The header does not say which column is a, b, c, d, e and f; "
                                          "choose the order of the columns.");
        if (m_table.problems.isEmpty() || m_table.problems.last().message != sentence)
            fail(m_header.first(), sentence);
    }

    void readRow(const Row& all) {
        if (isHeader(all)) return readHeader(all);
        if (m_isToPick) pickNumbers(all);
        if (m_picks) return readPicked(all);
        const Row cells = withLoneSignsJoined(withoutWords(all));
        if (!m_chosen && !m_isOrderKnown && !m_header.isEmpty()) {
            const bool isParted = m_dialect.separator != Separator::Blank;
            const qsizetype names = isParted ? fieldsOf(m_header).size() : m_header.size();
            const bool isOverIt = isParted ? fieldsOf(cells).size() >= names : cells.size() == names;
            if (isOverIt && names >= planeNumbers) return failOrder();
            m_header.clear(); // title
        }
        const auto start = beginOfNumbers(cells);
        const qsizetype count = cells.size() - start.value_or(0);
        if (!start || (!isExpected(count) && !isWithoutItsWeight(count))) return failCount(cells, count);
        const bool isUnnamed = m_header.isEmpty() || (m_isOrderKnown && m_labels != Labels::Named);
        if (*start > 0 && !isNextLabel(cells.first()))
            return isUnnamed ? failCount(cells, cells.size()) : failOrder();
        if (m_labels == Labels::Unknown) m_labels = *start > 0 ? Labels::Found : Labels::None;
        addRow(cells.sliced(*start));
    }

    // Row without the words behind its numbers.
    Row withoutWords(const Row& cells) const {
        const auto isNumber = [this](const Cell& cell) { return weightOf(cell).has_value(); };
        const auto first = std::find_if(cells.begin(), cells.end(), isNumber);
        const auto end = std::find_if_not(first, cells.end(), isNumber);
        if (end == cells.end() || !looksLikeWords(textsOf(cells.sliced(end - cells.begin())).join(u' ')))
            return cells;
        const qsizetype count = end - first;
        return isExpected(count) || isExpected(count - 1) ? cells.first(end - cells.begin()) : cells;
    }

    // "- 0.04" between blanks, where the row has too many cells otherwise.
    Row withLoneSignsJoined(Row cells) const {
        if (m_dialect.separator != Separator::Blank || isExpected(cells.size())) return cells;
        Row joined = cells;
        for (qsizetype i = 0; i + 1 < joined.size(); ++i)
            if (joined[i].text.size() == 1 && isDash(joined[i].text[0]) && value(joined[i + 1])) {
                joined[i].text += joined[i + 1].text;
                joined.removeAt(i + 1);
            }
        return isExpected(joined.size()) || isExpected(joined.size() - 1) ? joined : cells;
    }

    // "85 %" is 0.85.
    std::optional<double> weightOf(const Cell& cell) const {
        if (!cell.text.endsWith(u'%')) return value(cell);
        Cell share = cell;
        share.text.chop(1);
        const auto percent = value(share);
        return percent ? std::optional(*percent / 100) : std::nullopt;
    }

    bool isExpected(qsizetype count) const {
        if (m_most > 0) return count == m_most || count == m_fewest;
        return count == planeNumbers || count == planeNumbers + 1 ||
               (m_wanted == TableMaps::PlaneOrSpace && !m_dialect.isMixed &&
                (count == spaceNumbers || count == spaceNumbers + 1));
    }

    // True for ".5,0,0,.5,0,0," under a header: separators show that the last cell is empty.
    bool isWithoutItsWeight(qsizetype count) const {
        return m_dialect.separator != Separator::Blank && m_columns.back() == TableColumn::Weight &&
               m_most > 0 && count == m_most - 1;
    }

    // Index of the first number. Text before it is a label only if it cannot be a mistyped number, and if as
    // many numbers remain as a row has. nullopt: both are possible.
    std::optional<qsizetype> beginOfNumbers(const Row& cells) const {
        if (m_labels == Labels::None) return 0;
        if (m_labels == Labels::Named) return wordsOfField(cells);
        if (value(cells.first())) {
            if (m_isCounted) return 1;
            if (isExpected(cells.size())) return m_labels == Labels::Found ? std::nullopt : std::optional(0);
            const bool isUnderNames = m_isOrderKnown && isExpected(cells.size() - 1); // as R prints tables
            return (m_header.isEmpty() || isUnderNames) && !m_dialect.isMixed ? 1 : 0;
        }
        const qsizetype words = wordsOfLabel(cells);
        return looksLikeLabel(cells.first().text) && isExpected(cells.size() - words) ? words : 0;
    }

    static qsizetype wordsOfField(const Row& cells) {
        const auto next =
            std::find_if(cells.begin() + 1, cells.end(), [](const Cell& cell) { return !cell.isContinued; });
        return next - cells.begin();
    }

    // Number of words of the label: two in "map 1,0.5,0 …", one in "w1 0.5,0 …"; 0 if both are possible.
    qsizetype wordsOfLabel(const Row& cells) const {
        const qsizetype words = wordsOfField(cells);
        if (words == 1 || QStringView(u"):=").contains(cells.first().text.back())) return 1;
        const bool one = isExpected(cells.size() - 1);
        const bool all = isExpected(cells.size() - words);
        return one && all ? 0 : all ? words : 1;
    }

    // True for labels that count the maps.
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
        if (cell.text.isEmpty()) return Text::tr("A cell of this row is empty.");
        return Text::tr("“%1” is not a decimal number.").arg(cell.text.left(40));
    }

    void addRow(const Row& cells) {
        const auto good = std::count_if(cells.begin(), cells.end(),
                                        [this](const Cell& cell) { return value(cell).has_value(); });
        m_table.isTable = m_table.isTable || 2 * good > cells.size();
        std::vector<double> numbers;
        for (qsizetype i = 0; i < cells.size(); ++i) {
            const NumberUnit unit = unitOf(std::size_t(i), std::size_t(cells.size()));
            const auto number =
                isWeightColumn(i, cells.size()) ? weightOf(cells[i]) : numberIn(cells[i], m_dialect, unit);
            if (!number) return fail(cells[i], notANumber(cells[i]));
            numbers.push_back(*number);
        }
        if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return isCoefficient(number); }))
            return fail(cells.first(), Text::tr("A number in this row is too large for a coefficient (the "
                                                "largest absolute value is 3.4e38)."));
        if (m_table.rows.size() + m_table.spaceRows.size() >= std::size_t(maxTableRows))
            return fail(cells.first(),
                        Text::tr("The table has more than %1 rows, which is the limit.").arg(maxTableRows));
        if (cells.size() < spaceNumbers) {
            m_table.rows.push_back(mapOf(m_columns, numbers));
            keepTyped(m_table.rows.back(), cells);
        } else {
            m_table.spaceRows.push_back(spaceMapOf(numbers));
            keepTyped(m_table.spaceRows.back(), cells);
        }
        m_table.lines.push_back(cells.first().line);
        if (!m_table.rows.empty() && !m_table.spaceRows.empty())
            fail(cells.first(), Text::tr("The table mixes maps of the plane and maps of space."));
        else if (!m_table.spaceRows.empty())
            m_table.isOrdered = true;
    }

    // Keeps fractions and roots if the cell is the coefficient itself.
    template <int Dim> void keepTyped(ifs::WeightedMap<Dim>& map, const Row& cells) const {
        const auto count = std::size_t(cells.size());
        for (std::size_t i = 0; i < count; ++i) {
            const auto which = Dim == 3 ? std::optional(int(i)) : coefficientOf(m_columns, i, count);
            if (which) io::keepTyped(map, *which, plainSigns(cells[qsizetype(i)].text));
        }
    }

    bool isWeightColumn(qsizetype i, qsizetype count) const {
        if (count >= spaceNumbers) return i == spaceNumbers;
        return count == qsizetype(m_columns.size()) && m_columns[std::size_t(i)] == TableColumn::Weight;
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

    void takeDifferences(auto& rows) {
        m_table.isCumulative = true;
        double before = 0;
        for (auto& row : rows) {
            const double sum = row.weight.value_or(before);
            row.weight = sum - before;
            before = sum;
        }
    }

    void fail(const Cell& where, const QString& message) {
        m_table.problems.append({Problem::Severity::Error, {}, where.line, where.column, message});
    }

    // Named: header with a column of labels. Found: label in the first row, and so in every row.
    enum class Labels { Unknown, None, Found, Named };

    const QString& m_text; // line ends are LF
    Dialect m_dialect;
    bool m_chosen;
    TableMaps m_wanted;
    TableColumns m_columns;
    SpaceHeader m_space = SpaceHeader::None;
    qsizetype m_next = 0; // beginning of the next line
    int m_line = 0;       // number of lines before it
    Row m_header;
    bool m_isOrderKnown = false;        // from the header
    std::optional<Picks> m_picks;       // there are other columns as well
    bool m_isToPick = false;            // by the numbers of the first row
    bool m_isCounted = false;           // every row begins with its number
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
    const QString lines = plainLinesOf(text);
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

bool isOrderOpen(const QString& text) {
    const Table table = readTable(text);
    return table.isTable && !table.isOrdered && !hasErrors(readTable(text, fractintColumns()));
}

bool isTableToFractintUnknown(const QString& beginning) {
    if (beginning.contains(u'{')) return false;
    const QString lines = plainLinesOf(beginning);
    const Dialect dialect = dialectsOf(lines).first();
    if (TableParser(lines, dialect, std::nullopt, TableMaps::PlaneOrSpace).beginsWithMatrices()) return true;
    const QString whole = lines.left(lines.lastIndexOf(u'\n') < 0 ? lines.size() : lines.lastIndexOf(u'\n'));
    if (TableParser(whole, dialect, std::nullopt, TableMaps::PlaneOrSpace).countsItsMaps()) return true;
    return dialect.separator == Separator::Semicolon &&
           !hasErrors(TableParser(whole, dialect, std::nullopt, TableMaps::PlaneOrSpace).read());
}

} // namespace io
