// SPDX-License-Identifier: MIT
#include "io/table/listed_maps.h"

#include "document/text/text.h"
#include "io/table/equation_maps.h"
#include "io/table/gimp_maps.h"
#include "io/table/markup_tables.h"
#include "io/table/matrix_maps.h"
#include "io/table/named_numbers.h"
#include "io/table/several_tables.h"
#include "io/table/table_columns.h"
#include "io/table/table_fields.h"
#include "io/table/table_reader.h"
#include "io/text/export_weights.h"
#include "io/text/literal_lists.h"
#include "io/text/number.h"
#include "io/text/shaped_lists.h"
#include "io/text/yaml_lists.h"

#include <QRegularExpression>
#include <QSet>
#include <QStringList>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace io {

namespace {

using Kind = Literal::Kind;
using Numbers = std::vector<double>;

constexpr qsizetype maxSystems = 1000;
constexpr qsizetype maxNumbers = 16; // numbers of a map including its weight
constexpr int maxNesting = 4;        // nested lists of a map
constexpr std::array weightKeys{"p",    "w",     "weight",      "weights",
                                "prob", "probs", "probability", "probabilities"};
constexpr std::array matrixKeys{"linear",    "matrix", "m",      "mat",         "a",
                                "transform", "coefs",  "coeffs", "coefficients"};
constexpr std::array vectorKeys{"translation", "translate", "offset", "shift", "vector", "t", "b", "v"};

constexpr std::array sumKeys{"cumulative", "cum"}; // keys of weights summed up to each map

template <typename Keys> bool isOneOf(const QString& key, const Keys& keys) {
    return std::ranges::any_of(
        keys, [&](const char* known) { return key.compare(QLatin1String(known), Qt::CaseInsensitive) == 0; });
}

bool isNumber(const Literal& literal) {
    return literal.kind == Kind::Number;
}

// Lists around a list alone, as array([…]).
const Literal& bare(const Literal& literal) {
    const Literal* inner = &literal;
    while (inner->kind == Kind::List && inner->items.size() == 1 && inner->items[0].kind == Kind::List)
        inner = &inner->items[0];
    return *inner;
}

std::optional<Numbers> numbersOf(const Literal& list) {
    if (list.kind != Kind::List || list.items.isEmpty() || !std::ranges::all_of(list.items, isNumber))
        return std::nullopt;
    Numbers numbers;
    for (const Literal& item : list.items)
        numbers.push_back(item.number);
    return numbers;
}

// The numbers of a map or a part of it. Longer lists are not looked through: many lists may hold them.
std::optional<Numbers> fewNumbersOf(const Literal& list) {
    return list.items.size() <= maxNumbers ? numbersOf(list) : std::nullopt;
}

// Rows of numbers, all of one length.
std::optional<std::vector<Numbers>> rowsOf(const Literal& list) {
    std::vector<Numbers> rows;
    for (const Literal& item : list.items) {
        auto row = fewNumbersOf(item);
        if (!row || (!rows.empty() && row->size() != rows.front().size()) || rows.size() > 4)
            return std::nullopt;
        rows.push_back(*std::move(row));
    }
    if (rows.empty()) return std::nullopt;
    return rows;
}

// A map as its matrix, row by row, and its vector.
struct Map {
    QStringList names; // names of the numbers; empty: unknown
    Numbers numbers;
    bool hasWeight = false;
    bool isNamed = false; // true if the text names the numbers
};

QStringList letters(std::size_t count) {
    const QString all = count > 7 ? QStringLiteral("abcdefghijkl") : QStringLiteral("abcdef");
    return all.split(QString(), Qt::SkipEmptyParts);
}

// 2×3, 3×4, or the same with 0 0 1 below.
std::optional<Map> ofAugmented(std::vector<Numbers> rows) {
    if (rows.size() == rows.front().size()) {
        Numbers unit(rows.size(), 0);
        unit.back() = 1;
        if (rows.back() != unit) return std::nullopt;
        rows.pop_back();
    }
    const std::size_t dim = rows.size();
    if ((dim != 2 && dim != 3) || rows.front().size() != dim + 1) return std::nullopt;
    Map map{letters(dim * (dim + 1)), {}, false, false};
    for (const Numbers& row : rows)
        map.numbers.insert(map.numbers.end(), row.begin(), row.end() - 1);
    for (const Numbers& row : rows)
        map.numbers.push_back(row.back());
    return map;
}

std::optional<Map> ofParts(const Literal& matrix, const Literal& vector) {
    const auto shift = fewNumbersOf(bare(vector));
    if (!shift || (shift->size() != 2 && shift->size() != 3)) return std::nullopt;
    const std::size_t dim = shift->size();
    Numbers linear;
    if (const auto flat = fewNumbersOf(bare(matrix)))
        linear = *flat;
    else if (const auto rows = rowsOf(bare(matrix)))
        for (const Numbers& row : *rows)
            linear.insert(linear.end(), row.begin(), row.end());
    if (linear.size() != dim * dim) return std::nullopt;
    linear.insert(linear.end(), shift->begin(), shift->end());
    QStringList names = letters(linear.size());
    return Map{std::move(names), std::move(linear), false, false};
}

// Under the name of weights, or that of their sums.
void addWeight(Map& map, double weight, bool isSum) {
    if (map.names.isEmpty() && isSum) map.names = letters(map.numbers.size());
    map.numbers.push_back(weight);
    map.hasWeight = true;
    if (!map.names.isEmpty()) map.names << (isSum ? QStringLiteral("cumulative") : QStringLiteral("p"));
}

bool isOfWeights(const QString& key) {
    return isOneOf(key, weightKeys) || isOneOf(key, sumKeys);
}

std::optional<Map> mapOf(const Literal& literal, int nesting = 0);

// matrix(a, b, c, d, e, f) of SVG and CSS, and the like of other graphics, whose matrix is column by column.
bool isByColumns(const QString& name) {
    static const QRegularExpression names(
        QStringLiteral("^(matrix|(\\w+\\.)?(setTransform|AffineTransform|CGAffineTransform(Make)?))$"));
    return name.contains(names);
}

// bezierCurveTo(…) of a picture takes six numbers, too.
bool isCallThatDraws(const QString& name) {
    static const QRegularExpression names(
        QStringLiteral("curve|bezier|arc|line|rect|triangle|quad|ellipse|colou?r|rgb|print|plot"),
        QRegularExpression::CaseInsensitiveOption);
    return name.contains(names);
}

// The numbers a … l of a map in space, brought into this order.
std::optional<Map> inSpace(const QStringList& names, const Numbers& numbers) {
    Map map{letters(12), {}, false, true};
    for (const QString& letter : map.names) {
        const qsizetype index = names.indexOf(letter);
        if (index < 0 || names.size() != map.names.size()) return std::nullopt;
        map.numbers.push_back(numbers[std::size_t(index)]);
    }
    return map;
}

// Numbers by their names, or a matrix and a vector by theirs.
std::optional<Map> ofKeys(const Literal& object, int nesting) {
    QStringList names;
    Numbers numbers;
    std::optional<double> weight;
    bool isSum = false;
    const Literal* matrix = nullptr;
    const Literal* vector = nullptr;
    for (const Literal& item : object.items) {
        const QString key = item.key.toLower();
        if (item.kind == Kind::List && !vector && isOneOf(key, vectorKeys))
            vector = &item;
        else if (item.kind == Kind::List && !matrix && isOneOf(key, matrixKeys))
            matrix = &item;
        else if (isNumber(item) && isOfWeights(key)) {
            if (weight && isOneOf(key, sumKeys)) continue; // redundant: the weights themselves are there
            weight = item.number;
            isSum = isOneOf(key, sumKeys);
        } else if (isNumber(item) && ((key.size() == 1 && QStringLiteral("abcdefghijklrs").contains(key)) ||
                                      key == u"theta" || key == u"phi")) {
            names << key;
            numbers.push_back(item.number);
        }
    }
    std::optional<Map> map;
    if (matrix && vector)
        map = ofParts(*matrix, *vector);
    else if (matrix)
        map = mapOf(*matrix, nesting + 1);
    else if (tableColumns(names))
        map = Map{names, numbers, false, true};
    else
        map = inSpace(names, numbers);
    if (map && !map->hasWeight && weight) addWeight(*map, *weight, isSum);
    return map;
}

std::optional<Map> mapOf(const Literal& literal, int nesting) {
    const Literal& list = bare(literal);
    if (list.kind != Kind::List || list.items.isEmpty() || nesting > maxNesting) return std::nullopt;
    if (!list.items[0].key.isEmpty()) return ofKeys(list, nesting);
    if (auto flat = fewNumbersOf(list)) {
        const std::size_t count = flat->size();
        if (count != 6 && count != 7 && count != 12 && count != 13) return std::nullopt;
        if (isCallThatDraws(list.text)) return std::nullopt;
        if (count == 6 && isByColumns(list.text)) std::swap((*flat)[1], (*flat)[2]);
        return Map{{}, *std::move(flat), count % 6 == 1, false};
    }
    if (const auto rows = rowsOf(list); rows && rows->front().size() > 2) return ofAugmented(*rows);
    if (list.items.size() > 3) return std::nullopt;
    QList<const Literal*> lists;
    std::optional<double> weight;
    for (const Literal& item : list.items) {
        if (item.kind == Kind::List)
            lists << &item;
        else if (isNumber(item) && !weight)
            weight = item.number;
        else
            return std::nullopt;
    }
    if (lists.size() != 2 && !(lists.size() == 1 && weight)) return std::nullopt;
    auto map = lists.size() == 2 ? ofParts(*lists[0], *lists[1]) : mapOf(*lists[0], nesting + 1);
    if (map && weight && !map->hasWeight) addWeight(*map, *weight, false);
    return map;
}

class Finder {
public:
    QList<ListedMaps> find(const Literal& root) && {
        search(root, {});
        return std::move(m_found);
    }
    // Sequence of maps with names of their own: A1 = [[…]], b1 = […], A2 = …
    QList<ListedMaps> findSequence(const Literal& root) && {
        takeSequence(root);
        return std::move(m_found);
    }

private:
    // Tries each list a few times at most, at any depth: the time is proportional to the length of the text.
    void search(const Literal& list, const QString& name) {
        const QString own = nameIn(list, name);
        if (takeLetters(list, own)) return;
        const Literal* weights = nullptr;
        for (const Literal& item : list.items)
            if (isOfWeights(item.key) && list.items.size() > 1 && numbersOf(bare(item))) weights = &item;
        for (const Literal& item : list.items) {
            if (item.kind != Kind::List || m_found.size() >= maxSystems) continue;
            const bool isUseless = item.key.isEmpty() || isOneOf(item.key, mapsKeys);
            const QString shown = isUseless ? own : item.key;
            if (!take(item, shown, weights)) search(item, shown);
        }
    }

    void takeSequence(const Literal& root) {
        std::vector<Map> maps;
        const Literal* weights = nullptr;
        Weights chances; // weights such as p1 = 0.25
        for (qsizetype i = 0; i < root.items.size(); ++i) {
            const Literal& item = root.items[i];
            static const QRegularExpression digits(QStringLiteral("_?\\d+$"));
            const QString key = QString(item.key).remove(digits);
            const bool isWeight = isOfWeights(key);
            if (isWeight && isNumber(item)) {
                chances.name = key;
                chances.numbers.push_back(item.number);
            }
            if (item.kind != Kind::List) continue;
            auto map = mapOf(item); // w1 = [six numbers] is a map
            if (!map && isWeight && numbersOf(bare(item))) {
                weights = &item;
                continue;
            }
            if (!map && i + 1 < root.items.size()) {
                map = ofParts(item, root.items[i + 1]);
                if (map) ++i;
            }
            if (!map) continue;
            if (!maps.empty() && !areAlike(*map, maps.front())) return;
            maps.push_back(*std::move(map));
        }
        if (maps.size() < 2) return;
        if (weights) chances = {weights->key, *numbersOf(bare(*weights))};
        const UnusedWeights unused = weigh(maps, chances);
        m_found << ListedMaps{{}, tableOf(maps), qsizetype(maps.size()), Notation::Lists, {}, unused};
    }

    // Lists of numbers under the names of columns, all of one length.
    bool takeLetters(const Literal& list, const QString& name) {
        if (list.items.size() < 2) return false;
        QStringList names;
        std::vector<Numbers> columns;
        Weights chances;
        for (const Literal& item : list.items) {
            if (item.kind != Kind::List || item.key.isEmpty()) continue;
            QString key = item.key.toLower().remove(u'$');
            if (isOneOf(key, weightKeys)) key = QStringLiteral("p");
            const bool isName = tableColumn(key) || (key.size() == 1 && key[0] >= u'a' && key[0] <= u'l');
            if (!isName) continue;
            auto column = numbersOf(bare(item));
            if (!column) continue;
            if (isOfWeights(key)) {
                if (chances.name.isEmpty() || isOneOf(chances.name, sumKeys)) chances = {key, *column};
                continue;
            }
            if (names.contains(key) || (!columns.empty() && column->size() != columns.front().size()))
                continue;
            names << key;
            columns.push_back(*std::move(column));
        }
        const bool isWeighed = !columns.empty() && chances.numbers.size() == columns.front().size();
        if (isWeighed) {
            names << chances.name;
            columns.push_back(chances.numbers);
        }
        const bool isPlane = tableColumns(names).has_value();
        if (columns.empty() || columns.front().size() < 2 ||
            (!isPlane && spaceHeader(names) == SpaceHeader::None))
            return false;
        QString table = names.join(u'\t') + u'\n';
        for (std::size_t row = 0; row < columns.front().size(); ++row) {
            QByteArrayList cells;
            for (const Numbers& column : columns)
                cells << formatNumber(column[row]);
            table += QString::fromLatin1(cells.join('\t')) + u'\n';
        }
        m_found << ListedMaps{name, table, qsizetype(columns.front().size()), Notation::Lists, {}};
        if (!isWeighed) m_found.back().unused = {chances.name, chances.numbers.size()};
        return true;
    }

    static QString nameIn(const Literal& list, const QString& otherwise) {
        for (const Literal& item : list.items)
            if (item.kind == Kind::Text && !item.text.isEmpty() &&
                (item.key.compare(u"name", Qt::CaseInsensitive) == 0 ||
                 item.key.compare(u"title", Qt::CaseInsensitive) == 0))
                return item.text;
        return otherwise;
    }

    // List of similar maps; a single map only with names, since six numbers may be anything.
    bool take(const Literal& list, const QString& name, const Literal* weights) {
        if (list.kind != Kind::List || list.items.isEmpty()) return false;
        const Literal& inner = bare(list);
        if (m_useless.contains(&inner)) return false;
        if (takeMaps(inner, &inner != &list, name, weights)) return true;
        if (&inner != &list) m_useless << &inner; // lists around it contain the same
        return false;
    }

    bool takeMaps(const Literal& list, bool mayBeMap, const QString& name, const Literal* weights) {
        std::vector<Map> maps;
        if (auto map = mayBeMap ? mapOf(list) : std::nullopt)
            maps.push_back(*std::move(map));
        else
            maps = mapsAlike(list);
        if (maps.empty()) return false;
        if (maps.size() == 1 && !maps.front().isNamed) return false;
        UnusedWeights unused;
        if (weights) unused = weigh(maps, {weights->key, *numbersOf(bare(*weights))});
        m_found << ListedMaps{name, tableOf(maps), qsizetype(maps.size()), Notation::Lists, {}, unused};
        return true;
    }

    struct Weights {
        QString name;
        Numbers numbers;
    };

    // Gives maps without weights these; ignores them if their number differs.
    static UnusedWeights weigh(std::vector<Map>& maps, const Weights& chances) {
        if (std::ranges::any_of(maps, &Map::hasWeight)) return {};
        if (chances.numbers.size() != maps.size()) return {chances.name, chances.numbers.size()};
        for (std::size_t i = 0; i < maps.size(); ++i)
            addWeight(maps[i], chances.numbers[i], isOneOf(chances.name, sumKeys));
        return {};
    }

    // True if the maps differ at most in a missing weight.
    static bool areAlike(const Map& a, const Map& b) {
        const auto count = [](const Map& map) { return map.numbers.size() - (map.hasWeight ? 1 : 0); };
        const auto names = [](const Map& map) {
            return map.hasWeight && !map.names.isEmpty() ? map.names.first(map.names.size() - 1) : map.names;
        };
        return count(a) == count(b) && names(a) == names(b) &&
               (!a.hasWeight || !b.hasWeight || a.names == b.names);
    }

    // Maps of a list; empty unless all items are maps of one kind.
    static std::vector<Map> mapsAlike(const Literal& list) {
        std::vector<Map> maps;
        for (const Literal& item : list.items) {
            auto map = mapOf(item);
            if (!map || (!maps.empty() && !areAlike(*map, maps.front()))) return {};
            maps.push_back(*std::move(map));
        }
        return maps;
    }

    static QString tableOf(const std::vector<Map>& maps) {
        QString table;
        if (const QStringList& names = maps.front().names; !names.isEmpty())
            table = names.join(u'\t') + u'\n';
        for (const Map& map : maps) {
            QByteArrayList cells;
            for (const double number : map.numbers)
                cells << formatNumber(number);
            table += QString::fromLatin1(cells.join('\t')) + u'\n';
        }
        return table;
    }

    static constexpr std::array mapsKeys{"maps", "transforms", "transformations", "functions", "affine",
                                         "ifs",  "system",     "attractor",       "transform", "data",
                                         "rules"};
    QList<ListedMaps> m_found;
    QSet<const Literal*> m_useless; // lists that contain nothing but one useless list
};

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
    return good.isEmpty() ? bad.first(std::min<qsizetype>(bad.size(), 1)) : good;
}

QList<ListedMaps> written(const std::vector<WrittenMap>& maps, Notation notation) {
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
    QList<ListedMaps> found = Finder().find(literals.root);
    for (ListedMaps& listed : found)
        listed.notation = notation;
    return found;
}

QList<ListedMaps> sequenceIn(const Literals& literals) {
    return literals.isCut ? QList<ListedMaps>() : Finder().findSequence(literals.root);
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
    if (auto found = listsIn(literals, Notation::Lists); !found.isEmpty()) return found;
    if (auto found = listsIn(lists, Notation::Lists); !found.isEmpty()) return found;
    if (auto found = listsIn(yamlLiterals(text), Notation::Yaml); !found.isEmpty()) return found;
    if (auto found = sequenceIn(lists); !found.isEmpty()) return found;
    if (auto found = sequenceIn(literals); !found.isEmpty()) return found;
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
    return listed.isEmpty() ? text : listed.first().table;
}

} // namespace io
