// SPDX-License-Identifier: MIT
#include "io/table/table_fields.h"

#include "io/text/plain_signs.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace io {

namespace {

bool isNoFiniteNumber(const QString& text) {
    return std::ranges::any_of(std::array{"nan", "inf", "infinity"}, [&](const char* number) {
        return text.compare(QLatin1String(number), Qt::CaseInsensitive) == 0;
    });
}

// "a11" to "a33" and "b1" to "b3" as letters; other names as they are.
QString letterInSpace(const QString& name) {
    static const QRegularExpression element(QStringLiteral("^[am]_?\\{?([123])([123])\\}?$"));
    static const QRegularExpression shift(QStringLiteral("^[bt]_?\\{?([123xyz])\\}?$"));
    const QString small = name.trimmed().toLower().remove(u'$');
    if (const auto match = element.match(small); match.hasMatch())
        return QChar(u'a' + 3 * (match.captured(1).toInt() - 1) + match.captured(2).toInt() - 1);
    if (const auto match = shift.match(small); match.hasMatch()) {
        const QChar index = match.captured(1)[0];
        return QChar(u'j' + (index.isDigit() ? index.unicode() - u'1' : index.unicode() - u'x'));
    }
    return name;
}

bool isOnlyInSpace(const QString& name) {
    const QString letter = letterInSpace(name);
    return letter != name && QStringLiteral("cfghil").contains(letter);
}

// The letters a … l in any order, or names for them.
std::optional<Picks> pickedInSpace(const QStringList& names, qsizetype first, bool hasWeight) {
    Picks picks;
    picks.width = names.size();
    std::map<QString, qsizetype> fields; // by their letters
    std::optional<qsizetype> weight;
    const bool isNumbered = std::any_of(names.begin() + first, names.end(), isOnlyInSpace);
    for (qsizetype i = first; i < names.size(); ++i) {
        const QString letter = isNumbered ? letterInSpace(names[i]) : names[i].toLower();
        if (letter.size() == 1 && QStringLiteral("abcdefghijkl").contains(letter)) {
            if (!fields.emplace(letter, i).second) return std::nullopt;
        } else if (const auto column = tableColumn(names[i]);
                   column && isWeight(*column) && !(hasWeight && column == TableColumn::Cumulative)) {
            if (weight) return std::nullopt;
            weight = i;
        }
    }
    QStringList letters;
    for (const auto& [letter, field] : fields) {
        letters << letter;
        picks.fields.push_back(field);
    }
    if (weight) {
        letters << names[*weight];
        picks.fields.push_back(*weight);
    }
    picks.space = spaceHeader(letters);
    return picks.isSpace() ? std::optional(picks) : std::nullopt;
}

// Picks the fields whose names are known, from `first` on.
std::optional<Picks> picked(const QStringList& names, qsizetype first) {
    Picks picks;
    picks.width = names.size();
    QStringList known;
    constexpr qsizetype most = 1000;
    if (names.size() > most || names.contains(QStringLiteral("|")) || names.contains(QStringLiteral("&")))
        return std::nullopt; // table in another notation, or no table
    const bool hasWeight = std::any_of(names.begin() + first, names.end(), [](const QString& name) {
        return tableColumn(name) == TableColumn::Weight;
    });
    bool isWeighed = false;
    for (qsizetype i = first; i < names.size(); ++i) {
        const auto column = tableColumn(names[i]);
        if (!column || (hasWeight && column == TableColumn::Cumulative)) continue;
        if (isWeight(*column) && std::exchange(isWeighed, true)) continue; // "p" and "probability in %"
        known << names[i];
        picks.fields.push_back(i);
    }
    const bool isInSpace = std::any_of(names.begin() + first, names.end(), isOnlyInSpace);
    if (const auto columns = isInSpace ? std::nullopt : tableColumns(known)) {
        picks.columns = *columns;
        picks.columns.resize(picks.fields.size()); // drops a missing weight
        return picks;
    }
    return pickedInSpace(names, first, hasWeight);
}

} // namespace

bool looksLikeLabel(const QString& text) {
    if (text.endsWith(u':') || text.endsWith(u')')) return true;
    if (isNoFiniteNumber(text)) return false;
    return !text.isEmpty() && (text[0].isLetter() || text[0] == u'#') && !text.contains(u'.') &&
           !text.contains(u',');
}

bool looksLikeWords(const QString& text) {
    if (text.isEmpty() || isNoFiniteNumber(text)) return false;
    if (!text[0].isLetter() && !QStringView(u"([{“‘„«'").contains(text[0])) return false;
    for (qsizetype i = 1; i < text.size(); ++i)
        if (text[i].isDigit() && (text[i - 1] == u'.' || text[i - 1] == u',')) return false;
    return std::ranges::count_if(text, [](QChar c) { return c.isLetter(); }) >= 2;
}

bool isRule(const Row& cells) {
    constexpr qsizetype shortest = 3;
    qsizetype signs = 0;
    for (const Cell& cell : cells)
        for (const QChar c : cell.text) {
            if (!isDash(c) && !QStringView(u"=_+|:").contains(c) && (c < u'\u2500' || c > u'\u257f'))
                return false;
            ++signs;
        }
    return signs >= shortest && (cells.size() == 1 || signs >= shortest * cells.size());
}

Row withSignsJoined(Row cells, const Dialect& dialect) {
    for (qsizetype i = 1; i < cells.size(); ++i) {
        if (!cells[i].isContinued) continue;
        Cell& before = cells[i - 1];
        const bool isSign = before.text.size() == 1 && (isDash(before.text[0]) || before.text == u"+") &&
                            !before.isContinued && numberIn(cells[i], dialect);
        const bool isUnit = cells[i].text == u"%" || cells[i].text == u"°" || cells[i].text == u"deg";
        if (!isSign && (!isUnit || !numberIn(before, dialect))) continue;
        before.text += cells[i].text;
        cells.removeAt(i--);
    }
    return cells;
}

QList<Row> fieldsOf(const Row& cells) {
    QList<Row> fields;
    for (const Cell& cell : cells) {
        if (!cell.isContinued || fields.isEmpty()) fields << Row();
        fields.last() << cell;
    }
    return fields;
}

QStringList textsOf(const Row& cells) {
    QStringList texts;
    for (const Cell& cell : cells)
        texts << cell.text;
    return texts;
}

QStringList namesOf(const Row& header) {
    QStringList names;
    for (const Row& field : fieldsOf(header))
        names << textsOf(field).join(u' ');
    return names;
}

SpaceHeader spaceHeader(const QStringList& names) {
    const QString letters = QStringLiteral("abcdefghijkl");
    if (names.size() < letters.size() || names.size() > letters.size() + 1 ||
        names.first(letters.size()).join(QString()).toLower() != letters)
        return SpaceHeader::None;
    if (names.size() == letters.size()) return SpaceHeader::Plain;
    const auto last = tableColumn(names.last());
    return last == TableColumn::Weight       ? SpaceHeader::Weighted
           : last == TableColumn::Cumulative ? SpaceHeader::Cumulative
                                             : SpaceHeader::None;
}

bool nameAllColumns(const QStringList& names) {
    return tableColumns(names) || spaceHeader(names) != SpaceHeader::None;
}

std::optional<Picks> pickedByName(const QStringList& names) {
    if (auto picks = picked(names, 0)) return picks;
    return names.isEmpty() ? std::nullopt : picked(names, 1); // "f" above the labels is no coefficient
}

bool areColumnsNamed(const QList<Row>& table) {
    constexpr qsizetype coefficients = 6;
    if (table.isEmpty()) return false;
    const auto picks = pickedByName(textsOf(table.first()));
    if (!picks || table.size() <= coefficients) return picks.has_value();
    QStringList names;
    for (const Row& row : table.sliced(1))
        names << row.first().text;
    const bool hasWeight = std::ranges::any_of(textsOf(table.first()), [](const QString& name) {
        const auto column = tableColumn(name);
        return column && isWeight(*column);
    });
    return hasWeight || names.first(coefficients) != QStringLiteral("a b c d e f").split(u' ');
}

bool isSum(const Row& cells) {
    static const QRegularExpression word(QStringLiteral("^(sum|total|summe|somme|suma|сума|Σ|∑)\\s?[:=]?$"),
                                         QRegularExpression::CaseInsensitiveOption |
                                             QRegularExpression::UseUnicodePropertiesOption);
    return cells.size() <= 3 && cells.first().text.contains(word);
}

namespace {

// "r*cosθ", "f(x)": no word.
bool isFormula(const QString& text) {
    for (qsizetype i = 0; i < text.size(); ++i)
        if (QStringView(u"*/^=\\").contains(text[i]) || (text[i] == u'(' && i > 0 && text[i - 1].isLetter()))
            return std::ranges::any_of(text, [](QChar c) { return c.isLetter(); });
    return false;
}

} // namespace

bool isProse(const Row& cells, const Dialect& dialect, int fewestNumbers) {
    constexpr qsizetype leastWords = 3, leastLetters = 3, mostNumbers = 2, fewestFields = 6;
    qsizetype numbers = 0, fields = 0;
    QSet<QString> words;
    for (const Cell& cell : cells) {
        fields += !cell.isContinued;
        if (isFormula(cell.text)) return false;
        if (numberIn(cell, dialect))
            ++numbers;
        else if (std::ranges::count_if(cell.text, [](QChar c) { return c.isLetter(); }) >= leastLetters)
            words.insert(cell.text.toLower());
    }
    if (dialect.separator != Separator::Blank && fields >= fewestFields) return false; // a row of a table
    const bool isSentence = cells.last().text.endsWith(u'.') || cells.first().text.endsWith(u':');
    return words.size() >= std::max(leastWords, 2 * numbers) && numbers >= fewestNumbers &&
           numbers <= mostNumbers && (numbers > 0 || isSentence);
}

bool countMaps(const QList<Row>& table, const Dialect& dialect) {
    double next = 0;
    int counted = 0;
    int fewest = 3;
    for (const Row& row : table) {
        const auto isNumber = [&](const Cell& cell) { return numberIn(cell, dialect).has_value(); };
        if (counted == 0 && std::ranges::none_of(row, isNumber)) {
            const QStringList names = textsOf(row);
            if (!nameAllColumns(names)) continue;
            if (names.size() % 6 != 0) return false; // the weight has a name
            fewest = 2;
            continue;
        }
        const auto number = numberIn(row.first(), dialect);
        if (!number || (row.size() != 7 && row.size() != 13) || row.size() != table.last().size())
            return false;
        const bool isNext = counted == 0 ? *number == 0 || *number == 1 : *number == next;
        if (!isNext) return false;
        next = *number + 1;
        ++counted;
    }
    return counted >= fewest;
}

Picks pickedByOrder(const TableColumns& columns) {
    Picks picks;
    picks.width = qsizetype(columns.size());
    for (qsizetype i = 0; i < picks.width; ++i) {
        const TableColumn column = columns[std::size_t(i)];
        if (column == TableColumn::Other) continue;
        picks.columns.push_back(column);
        picks.fields.push_back(i);
    }
    // Drops the weight, which nobody named, from the end.
    if (std::ranges::count_if(picks.columns, isWeight) == 0) picks.columns.push_back(TableColumn::Weight);
    return picks;
}

} // namespace io
