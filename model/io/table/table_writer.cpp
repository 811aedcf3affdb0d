// SPDX-License-Identifier: MIT
#include "io/table/table_writer.h"

#include "io/text/export_weights.h"
#include "io/text/number.h"

#include <QByteArrayList>

#include <algorithm>

namespace io {

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
