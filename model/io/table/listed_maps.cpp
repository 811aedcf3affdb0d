// SPDX-License-Identifier: MIT
#include "io/table/listed_maps.h"

#include "document/text/text.h"
#include "io/table/equation_maps.h"
#include "io/table/gimp_maps.h"
#include "io/table/list_finder.h"
#include "io/table/markup_tables.h"
#include "io/table/matrix_maps.h"
#include "io/table/named_numbers.h"
#include "io/table/several_tables.h"
#include "io/table/table_columns.h"
#include "io/table/table_fields.h"
#include "io/table/table_reader.h"
#include "io/text/export_weights.h"
#include "io/text/literal_lists.h"
#include "io/text/shaped_lists.h"
#include "io/text/yaml_lists.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace io {

namespace {

constexpr qsizetype maxSystems = 1000;

Notation notationOf(Markup markup) {
    switch (markup) {
    case Markup::Latex:
        return Notation::LatexTable;
    case Markup::Html:
        return Notation::HtmlTable;
    case Markup::Markdown:
        return Notation::MarkdownTable;
    case Markup::Wiki:
        return Notation::WikiTable;
    }
    return Notation::LatexTable;
}

// Tables that can be read; else the first that holds numbers in the way of maps.
QList<ListedMaps> markedUp(const QString& text) {
    QList<ListedMaps> good;
    QList<ListedMaps> bad;
    for (const MarkupTable& markup : markupTables(text)) {
        ListedMaps listed{{}, {}, 0, notationOf(markup.markup), {}};
        for (const MarkupRow& row : markup.rows) {
            QStringList cells;
            for (const QString& cell : row.cells)
                cells << tableCell(cell);
            listed.table += cells.join(u'\t') + u'\n';
            listed.lines.push_back(row.line);
        }
        const Table table = readTable(listed.table, std::nullopt, TableMaps::PlaneOrSpace);
        const bool isBad = hasErrors(table) && !isOrderOpen(listed.table);
        listed.maps = std::ssize(table.rows) + std::ssize(table.spaceRows);
        if (table.isTable && good.size() < maxSystems) (isBad ? bad : good) << listed;
    }
    return good.isEmpty() ? bad.first(std::min<qsizetype>(bad.size(), 1)) : good + bad;
}

QList<ListedMaps> written(const WrittenMaps& found, Notation notation) {
    const std::vector<WrittenMap>& maps = found.maps;
    if (found.unread) {
        ListedMaps listed{{}, {}, 0, notation, {}};
        listed.unread = found.unread;
        return {listed};
    }
    if (maps.empty()) return {};
    ListedMaps listed{{}, tableOf(maps), qsizetype(maps.size()), notation, {maps.front().line}};
    for (const WrittenMap& map : maps)
        listed.lines.push_back(map.line);
    const auto hasWeight = [](const WrittenMap& map) { return map.weight.has_value(); };
    const auto without = std::ranges::find_if_not(maps, hasWeight);
    if (without != maps.end() && std::ranges::any_of(maps, hasWeight))
        listed.withoutWeight = std::size_t(without - maps.begin());
    return listed.table.isEmpty() ? QList<ListedMaps>() : QList{listed};
}

QList<ListedMaps> listsIn(const Literals& literals, Notation notation) {
    if (literals.isCut) return {};
    QList<ListedMaps> found = mapsInLists(literals.root);
    for (ListedMaps& listed : found)
        listed.notation = notation;
    return found;
}

QList<ListedMaps> sequenceIn(const Literals& literals) {
    return literals.isCut ? QList<ListedMaps>() : mapsInSequence(literals.root);
}

// The first reading with nothing unread, else the first one.
QList<ListedMaps> best(const QList<QList<ListedMaps>>& readings) {
    QList<ListedMaps> nearly;
    for (const QList<ListedMaps>& reading : readings) {
        const bool isGood =
            std::ranges::none_of(reading, [](const ListedMaps& listed) { return listed.unread.has_value(); });
        if (isGood && !reading.isEmpty()) return reading;
        if (nearly.isEmpty()) nearly = reading;
    }
    return nearly;
}

// Rows between semicolons or ends of lines, as Matlab and Julia write them, as lists: [1 2; 3 4] is
// [[1,2],[3,4]], and a column [1; 2] is [1,2]. Empty where there are none.
QString rowsAsLists(QString text) {
    static const QRegularExpression continued(QStringLiteral("\\.\\.\\.[^\n]*\n"));
    static const QRegularExpression comment(QStringLiteral("%[^\n]*"));
    static const QRegularExpression rows(
        QStringLiteral(R"(\[([^\[\](){};\n]*+(?:[;\n][^\[\](){};\n]*+)++)\])"));
    static const QRegularExpression blanks(QStringLiteral(R"([\s,]+)"));
    static const QRegularExpression rowEnd(QStringLiteral("[;\n]"));
    text.replace(continued, QStringLiteral(" ")).remove(comment);
    QString lists;
    qsizetype before = 0;
    auto found = rows.globalMatch(text);
    while (found.hasNext()) {
        const auto match = found.next();
        QList<QStringList> cells;
        for (const QString& row : match.captured(1).split(rowEnd))
            if (const QStringList words = row.split(blanks, Qt::SkipEmptyParts); !words.isEmpty())
                cells << words;
        const bool isColumn = std::ranges::all_of(cells, [](const auto& row) { return row.size() == 1; });
        QStringList parts;
        for (const QStringList& row : cells)
            parts << (isColumn ? row.first() : u'[' + row.join(u',') + u']');
        lists += QStringView(text).sliced(before, match.capturedStart() - before);
        lists += u'[' + parts.join(u',') + u']';
        before = match.capturedEnd();
    }
    return before == 0 ? QString() : lists + text.sliced(before);
}

QList<ListedMaps> named(const QList<MarkupRow>& rows) {
    if (rows.isEmpty()) return {};
    ListedMaps listed{{}, {}, rows.size() - 1, Notation::Lists, {}};
    for (const MarkupRow& row : rows) {
        listed.table += row.cells.join(u'\t') + u'\n';
        listed.lines.push_back(row.line);
    }
    return {listed};
}

// The lists one below the other; none unless all can be read.
QList<ListedMaps> oneBelowTheOther(const QString& text) {
    QList<ListedMaps> found;
    for (const TitledTable& titled : severalTables(text)) {
        const Table table = readTable(titled.table, std::nullopt, TableMaps::PlaneOrSpace);
        if (hasErrors(table) || !table.isTable) return {};
        const qsizetype maps = std::ssize(table.rows) + std::ssize(table.spaceRows);
        found << ListedMaps{titled.title, titled.table, maps, Notation::Lists, {}};
    }
    return found;
}

} // namespace

QList<ListedMaps> listedMaps(const QString& text) {
    if (auto found = written(gimpMaps(text), Notation::Gimp); !found.isEmpty()) return found;
    QList<ListedMaps> nearly = markedUp(text);
    const bool isGood = !nearly.isEmpty() && nearly.first().maps > 0;
    if (isGood) return nearly;
    if (auto found = written(matrixMaps(text), Notation::LatexMatrices); !found.isEmpty()) return found;
    Literals literals = literalsIn(text);
    shapeMatrices(literals.root);
    const QString semicolons = rowsAsLists(text);
    const Literals lists = semicolons.isEmpty() ? Literals() : literalsIn(semicolons);
    if (auto found = best({listsIn(literals, Notation::Lists), listsIn(lists, Notation::Lists)});
        !found.isEmpty())
        return found;
    if (auto found = listsIn(yamlLiterals(text), Notation::Yaml); !found.isEmpty()) return found;
    if (auto found = best({sequenceIn(lists), sequenceIn(literals)}); !found.isEmpty()) return found;
    if (auto found = written(equationMaps(text), Notation::Equations); !found.isEmpty()) return found;
    if (auto found = oneBelowTheOther(text); !found.isEmpty()) return found;
    if (auto found = named(namedNumbers(text)); !found.isEmpty()) return found;
    return nearly;
}

QString unusedWeightsRemark(const ListedMaps& listed) {
    if (listed.withoutWeight) return missingWeightRemark(*listed.withoutWeight + 1);
    if (listed.unused.name.isEmpty()) return {};
    return Text::tr("“%1” has %2 numbers for %3 maps, so it is not read as their weights, which are computed "
                    "from the determinants.")
        .arg(listed.unused.name, QString::number(listed.unused.numbers), QString::number(listed.maps));
}

QString tableIn(const QString& text) {
    if (!hasErrors(readTable(text, fractintColumns(), TableMaps::PlaneOrSpace))) return text;
    const QList<ListedMaps> listed = listedMaps(text);
    return listed.isEmpty() || listed.first().unread ? text : listed.first().table;
}

} // namespace io
