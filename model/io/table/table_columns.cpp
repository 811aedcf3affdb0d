// SPDX-License-Identifier: MIT
#include "io/table/table_columns.h"

#include "attractor/arithmetic/arithmetic.h"
#include "document/text/text.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace io {

namespace {

using enum TableColumn;

constexpr double degree = std::numbers::pi / 180;

// Exact at right angles.
double sine(double degrees) {
    return std::remainder(degrees, 90) == 0 ? attractor::sineOfDegrees(degrees) : std::sin(degrees * degree);
}

double cosine(double degrees) {
    return std::remainder(degrees, 90) == 0 ? attractor::cosineOfDegrees(degrees)
                                            : std::cos(degrees * degree);
}

struct Name {
    const char* name;
    TableColumn column;
};
// The first name of a column is the one we write.
constexpr std::array columnsByName{Name{"a", A},
                                   Name{"b", B},
                                   Name{"c", C},
                                   Name{"d", D},
                                   Name{"e", E},
                                   Name{"f", F},
                                   Name{"p", Weight},
                                   Name{"r", R},
                                   Name{"s", S},
                                   Name{"theta", Theta},
                                   Name{"phi", Phi},
                                   Name{"cumulative", Cumulative},
                                   Name{"θ", Theta},
                                   Name{"φ", Phi},
                                   Name{"ϕ", Phi},
                                   Name{"ϑ", Theta},
                                   Name{"h", E},
                                   Name{"k", F},
                                   Name{"prob", Weight},
                                   Name{"probability", Weight},
                                   Name{"weight", Weight},
                                   Name{"p%", Weight},
                                   Name{"%", Weight},
                                   Name{"weights", Weight},
                                   Name{"prob.", Weight},
                                   Name{"probabilities", Weight},
                                   Name{"probs", Weight},
                                   Name{"cum", Cumulative},
                                   Name{"cumulative p", Cumulative},
                                   Name{"cumulative probability", Cumulative},
                                   Name{"cumulative weight", Cumulative},
                                   Name{"a11", A},
                                   Name{"a12", B},
                                   Name{"a21", C},
                                   Name{"a22", D},
                                   Name{"b1", E},
                                   Name{"b2", F},
                                   Name{"t1", E},
                                   Name{"t2", F},
                                   Name{"tx", E},
                                   Name{"ty", F},
                                   Name{"m11", A},
                                   Name{"m12", B},
                                   Name{"m21", C},
                                   Name{"m22", D},
                                   Name{"xx", A},
                                   Name{"xy", B},
                                   Name{"yx", C},
                                   Name{"yy", D},
                                   Name{"x0", E},
                                   Name{"y0", F},
                                   Name{"dx", E},
                                   Name{"dy", F},
                                   Name{"e1", E},
                                   Name{"e2", F}};

// Words of other languages, and words with others behind: "Prob. (p)", "probabilité", "kumuliert".
std::optional<TableColumn> columnInWords(const QString& name) {
    static const QRegularExpression sum(QStringLiteral("\\b(cumul|kumul|acumul|кумул|running (sum|total))"),
                                        QRegularExpression::CaseInsensitiveOption |
                                            QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression weight(
        QStringLiteral(
            "^(prob(\\b|a)|wahrsch|weight\\b|gewicht|poids\\b|peso\\b|веројат|вероят|тежин|chance)"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    if (name.size() < 4) return std::nullopt;
    if (name.contains(sum)) return Cumulative;
    return name.contains(weight) ? std::optional(Weight) : std::nullopt;
}

bool isPolar(TableColumn column) {
    return column >= R && column <= Phi;
}

// The name without the index of the map behind the letter, the unit in parentheses, and mathematical markup.
QString bareName(QString name) {
    static const QRegularExpression unit(QStringLiteral("\\s*([(\\[](%|deg|degrees?|[°º])[)\\]]|[°º]| %)$"));
    static const QRegularExpression index(QStringLiteral("^([a-zA-Zθφϕϑ])(_?[ijkn]|_\\{[ijkn]\\}|[ₙᵢⱼₖ])$"));
    static const QRegularExpression lowered(QStringLiteral("^([abemtxy])_\\{?(\\d\\d?|[xy])\\}?$"));
    name = name.trimmed().remove(u'$').remove(u'*').remove(unit);
    return name.replace(index, QStringLiteral("\\1")).replace(lowered, QStringLiteral("\\1\\2"));
}

std::optional<TableColumn> columnOf(const QString& text) {
    const QString name = bareName(text);
    const auto* const known =
        std::find_if(columnsByName.begin(), columnsByName.end(), [&name](const Name& candidate) {
            return name.compare(QString::fromUtf8(candidate.name), Qt::CaseInsensitive) == 0;
        });
    return known == columnsByName.end() ? columnInWords(name) : std::optional(known->column);
}

bool isComplete(TableColumns columns) {
    std::sort(columns.begin(), columns.end());
    return columns == TableColumns{A, B, C, D, E, F, Weight} ||
           columns == TableColumns{A, B, C, D, E, F, Cumulative} ||
           columns == TableColumns{R, S, Theta, Phi, E, F, Weight} ||
           columns == TableColumns{R, S, Theta, Phi, E, F, Cumulative};
}

// The words, or the letters of the only one.
QStringList namesIn(QString text) {
    text.replace(u',', u' ');
    const QStringList names = text.simplified().split(u' ', Qt::SkipEmptyParts);
    if (names.size() != 1) return names;
    QStringList letters;
    for (const QChar letter : names.first())
        letters << QString(letter);
    return letters;
}

} // namespace

TableColumns fractintColumns() {
    return {A, B, C, D, E, F, Weight};
}

std::optional<TableColumns> tableColumns(const QStringList& names) {
    TableColumns columns;
    for (const QString& name : names) {
        const std::optional<TableColumn> column = columnOf(name);
        if (!column) return std::nullopt;
        columns.push_back(*column);
    }
    if (std::none_of(columns.begin(), columns.end(), isWeight)) columns.push_back(Weight);
    return isComplete(columns) ? std::optional(columns) : std::nullopt;
}

std::optional<TableColumns> tableColumns(const QString& text) {
    return tableColumns(namesIn(text));
}

std::optional<TableColumn> tableColumn(const QString& name) {
    return columnOf(name);
}

std::optional<TableColumns> columnsToRead(const QString& text) {
    if (const auto columns = tableColumns(text)) return columns;
    TableColumns columns;
    TableColumns known;
    for (const QString& name : namesIn(text)) {
        const std::optional<TableColumn> column = columnOf(name);
        const bool isOther = name == u"-" || name == u"_" || name.size() > 1;
        if (!column && !isOther) return std::nullopt;
        columns.push_back(column.value_or(Other));
        if (column) known.push_back(*column);
    }
    if (std::none_of(known.begin(), known.end(), isWeight)) known.push_back(Weight);
    return isComplete(known) ? std::optional(columns) : std::nullopt;
}

QString columnsObstacle(const QString& text) {
    TableColumns columns;
    for (const QString& name : namesIn(text)) {
        const std::optional<TableColumn> column = columnOf(name);
        if (!column)
            return Text::tr("There is no column “%1”: the columns are a b c d or r s theta phi, e f, and p "
                            "or cumulative.")
                .arg(name);
        if (std::find(columns.begin(), columns.end(), *column) != columns.end())
            return Text::tr("“%1” occurs twice.").arg(name);
        columns.push_back(*column);
    }
    if (std::count_if(columns.begin(), columns.end(), isWeight) > 1)
        return Text::tr("A row has only one weight: p or cumulative.");
    const bool polar = std::any_of(columns.begin(), columns.end(), isPolar);
    TableColumns missing = polar ? TableColumns{R, S, Theta, Phi, E, F} : TableColumns{A, B, C, D, E, F};
    for (const TableColumn column : columns)
        if (std::erase(missing, column) == 0 && !isWeight(column))
            return Text::tr("a b c d and r s theta phi cannot be combined.");
    if (missing.empty()) return {};
    return Text::tr("Missing: %1.").arg(columnNames(missing).join(u' '));
}

QStringList columnNames(const TableColumns& columns) {
    QStringList names;
    for (const TableColumn column : columns)
        names << QString::fromUtf8(
            std::find_if(columnsByName.begin(), columnsByName.end(), [column](const Name& known) {
                return known.column == column;
            })->name);
    return names;
}

ifs::WeightedMap<2> mapOf(const TableColumns& columns, std::span<const double> numbers) {
    std::array<double, 13> value{};
    std::optional<double> weight;
    const bool hasWeight = numbers.size() == columns.size();
    std::size_t next = 0;
    for (const TableColumn column : columns) {
        if (!isWeight(column))
            value[std::size_t(column)] = numbers[next++];
        else if (hasWeight)
            weight = numbers[next++];
    }
    const auto of = [&value](TableColumn column) { return value[std::size_t(column)]; };
    ifs::WeightedMap<2> row;
    row.map = ifs::affineMap(of(A), of(B), of(C), of(D), of(E), of(F));
    if (std::find(columns.begin(), columns.end(), R) != columns.end())
        row.map = ifs::affineMap(of(R) * cosine(of(Theta)), -of(S) * sine(of(Phi)), of(R) * sine(of(Theta)),
                                 of(S) * cosine(of(Phi)), of(E), of(F));
    row.weight = weight;
    return row;
}

namespace {

// The column of the number in a row of so many.
std::optional<TableColumn> columnOf(const TableColumns& columns, std::size_t number, std::size_t count) {
    for (const TableColumn column : columns) {
        if (isWeight(column) && count < columns.size()) continue;
        if (number == 0) return column;
        --number;
    }
    return std::nullopt;
}

} // namespace

NumberUnit unitOfNumber(const TableColumns& columns, std::size_t number, std::size_t count) {
    const auto column = columnOf(columns, number, count);
    return column == Theta || column == Phi ? NumberUnit::Degrees : NumberUnit::None;
}

std::optional<int> coefficientOf(const TableColumns& columns, std::size_t number, std::size_t count) {
    const auto column = columnOf(columns, number, count);
    if (column == E || column == F) return column == E ? 4 : 5;
    return column >= A && column <= D ? std::optional(int(*column)) : std::nullopt;
}

std::vector<double> numbersOf(const TableColumns& columns, const ifs::AffineMap<2>& map, double weight) {
    const auto& m = map.linear;
    std::vector<double> numbers;
    for (const TableColumn column : columns) {
        switch (column) {
        case A:
            numbers.push_back(m(0, 0));
            break;
        case B:
            numbers.push_back(m(0, 1));
            break;
        case C:
            numbers.push_back(m(1, 0));
            break;
        case D:
            numbers.push_back(m(1, 1));
            break;
        case E:
            numbers.push_back(map.translation.x());
            break;
        case F:
            numbers.push_back(map.translation.y());
            break;
        case R:
            numbers.push_back(m.col(0).norm());
            break;
        case S:
            numbers.push_back(m.col(1).norm());
            break;
        case Theta:
            numbers.push_back(std::atan2(m(1, 0), m(0, 0)) / degree);
            break;
        case Phi:
            numbers.push_back(std::atan2(-m(0, 1), m(1, 1)) / degree);
            break;
        case Weight:
        case Cumulative:
            numbers.push_back(weight);
            break;
        case Other:
            break;
        }
    }
    return numbers;
}

} // namespace io
