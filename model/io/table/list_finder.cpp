// SPDX-License-Identifier: MIT
#include "io/table/list_finder.h"

#include "io/table/table_columns.h"
#include "io/table/table_fields.h"
#include "io/text/number.h"

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

constexpr qsizetype mostSystems = 1000;
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
        if (isNumber(item) && key.isEmpty()) return std::nullopt; // a: 0,25
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
            if (item.kind != Kind::List || m_found.size() >= mostSystems) continue;
            const bool isUseless = item.key.isEmpty() || isOneOf(item.key, mapsKeys);
            const QString shown = isUseless ? own : item.key;
            if (!take(item, shown, weights)) search(item, shown);
        }
    }

    // Which items of a sequence are its maps, which their vectors, and which neither.
    struct Sequence {
        std::vector<Map> maps;
        std::vector<qsizetype> starts; // positions of the maps
        std::vector<qsizetype> vectors;
        std::vector<qsizetype> others;
    };

    // The name of an item without its number, or that of its call.
    static QString kindOf(const Literal& item) {
        static const QRegularExpression digits(QStringLiteral("_?\\d+$"));
        const QString stem = QString(item.key).remove(digits);
        if (!stem.isEmpty() || item.kind != Kind::List) return stem;
        return QString(item.text).remove(digits);
    }

    // The name of the call inside, as matrix(…) in the rules of CSS.
    static QString callIn(const Literal& item) {
        const Literal& inner = bare(item);
        return &inner == &item || inner.kind != Kind::List ? QString() : inner.text;
    }

    // A list without a name among maps without names.
    static bool isLikeMap(const Literal& item) {
        return item.kind == Kind::List && item.items.size() > 1 &&
               (item.items[0].kind == Kind::List || item.items.size() > 5);
    }

    // Names such as A1, A3: A2 is missing.
    static std::optional<std::size_t> gapIn(const Literal& root, const std::vector<qsizetype>& starts) {
        static const QRegularExpression digits(QStringLiteral("(\\d{1,6})$"));
        std::optional<int> before;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const auto match = digits.match(root.items[starts[i]].key);
            if (!match.hasMatch()) return std::nullopt;
            const int number = match.captured(1).toInt();
            if (before && number > *before + 1 &&
                kindOf(root.items[starts[i]]) == kindOf(root.items[starts[0]]))
                return i;
            before = number;
        }
        return std::nullopt;
    }

    static std::optional<UnreadMap> unreadIn(const Literal& root, const Sequence& sequence) {
        QSet<QString> kinds, calls;
        for (const qsizetype position : sequence.starts)
            calls << callIn(root.items[position]);
        for (const auto* positions : {&sequence.starts, &sequence.vectors})
            for (const qsizetype position : *positions)
                kinds << kindOf(root.items[position]);
        const bool areNameless = kindOf(root.items[sequence.starts.front()]).isEmpty();
        for (const qsizetype other : sequence.others) {
            const Literal& item = root.items[other];
            const QString kind = kindOf(item);
            const QString call = callIn(item);
            const bool isCall = !call.isEmpty() && calls.contains(call);
            const bool isOfTheirs = kind.isEmpty() ? areNameless && isLikeMap(item) : kinds.contains(kind);
            if (!isCall && !isOfTheirs) continue;
            const auto before = std::ranges::count_if(sequence.starts, [&](auto at) { return at < other; });
            return UnreadMap{int(before) + 1, item.line, item.key.isEmpty() ? item.text : item.key};
        }
        if (const auto gap = gapIn(root, sequence.starts)) {
            const Literal& item = root.items[sequence.starts[*gap]];
            return UnreadMap{int(*gap) + 1, item.line, item.key};
        }
        return std::nullopt;
    }

    void takeSequence(const Literal& root) {
        Sequence sequence;
        std::vector<Map>& maps = sequence.maps;
        const Literal* weights = nullptr;
        Weights chances; // weights such as p1 = 0.25
        for (qsizetype i = 0; i < root.items.size(); ++i) {
            const Literal& item = root.items[i];
            const QString key = kindOf(item);
            const bool isWeight = isOfWeights(key);
            if (isWeight && isNumber(item)) {
                chances.name = key;
                chances.numbers.push_back(item.number);
            }
            if (item.kind != Kind::List) {
                if (item.kind == Kind::Other) sequence.others.push_back(i);
                continue;
            }
            auto map = mapOf(item); // w1 = [six numbers] is a map
            if (!map && isWeight && numbersOf(bare(item))) {
                weights = &item;
                continue;
            }
            const qsizetype start = i;
            if (!map && i + 1 < root.items.size()) {
                map = ofParts(item, root.items[i + 1]);
                if (map) sequence.vectors.push_back(++i);
            }
            if (!map) {
                sequence.others.push_back(i);
                continue;
            }
            if (!maps.empty() && !areAlike(*map, maps.front())) return;
            sequence.starts.push_back(start);
            maps.push_back(*std::move(map));
        }
        if (maps.size() < 2) return;
        if (weights) chances = {weights->key, *numbersOf(bare(*weights))};
        const UnusedWeights unused = weigh(maps, chances);
        m_found << ListedMaps{{}, tableOf(maps), qsizetype(maps.size()), Notation::Lists, {}, unused};
        m_found.back().unread = unreadIn(root, sequence);
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
        if (maps.empty()) return takeUnread(list, name);
        if (maps.size() == 1 && !maps.front().isNamed) return false;
        UnusedWeights unused;
        if (weights) unused = weigh(maps, {weights->key, *numbersOf(bare(*weights))});
        m_found << ListedMaps{name, tableOf(maps), qsizetype(maps.size()), Notation::Lists, {}, unused};
        return true;
    }

    // A list whose items are maps but for some that are not understood.
    bool takeUnread(const Literal& list, const QString& name) {
        if (list.items.size() < 2 || !std::ranges::all_of(list.items, [](const Literal& item) {
                return item.kind == Kind::List || item.kind == Kind::Other;
            }))
            return false;
        std::vector<Map> maps;
        std::optional<UnreadMap> unread;
        for (qsizetype i = 0; i < list.items.size(); ++i) {
            auto map = mapOf(list.items[i]);
            const bool isLost = !map || (!maps.empty() && !areAlike(*map, maps.front()));
            if (isLost && !unread) unread = UnreadMap{int(i) + 1, list.items[i].line, {}};
            if (!isLost) maps.push_back(*std::move(map));
        }
        if (maps.empty() || 2 * qsizetype(maps.size()) < list.items.size()) return false;
        m_found << ListedMaps{name, tableOf(maps), qsizetype(maps.size()), Notation::Lists, {}};
        m_found.back().unread = unread;
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

} // namespace

QList<ListedMaps> mapsInLists(const Literal& root) {
    return Finder().find(root);
}

QList<ListedMaps> mapsInSequence(const Literal& root) {
    return Finder().findSequence(root);
}

} // namespace io
