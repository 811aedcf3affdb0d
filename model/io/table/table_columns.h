// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"
#include "io/text/expression.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

// Meaning of the columns of a table of maps. Programs and books differ in their order.
namespace io {

// x' = A x + B y + E, y' = C x + D y + F, weight P; or the linear part as scales R, S and angles Theta, Phi
// in degrees: A = R cos Theta, B = −S sin Phi, C = R sin Theta, D = S cos Phi. Cumulative: the sum of the
// weights up to this row. Other: what is not read; only in an order to read by.
enum class TableColumn { A, B, C, D, R, S, Theta, Phi, E, F, Weight, Cumulative, Other };

inline bool isWeight(TableColumn column) {
    return column == TableColumn::Weight || column == TableColumn::Cumulative;
}

// All of A B C D or all of R S Theta Phi, E and F, each once and in any order; and one of Weight and
// Cumulative.
using TableColumns = std::vector<TableColumn>;

TableColumns fractintColumns(); // order a b c d e f p

// The column of that name: "a", "a_i", "a11", "theta", "h" (another name for e), "p (%)".
std::optional<TableColumn> tableColumn(const QString& name);

// Columns from names like "a", "theta" or "h" (another name for e); nullopt when they do not say everything.
// A weight that is not named comes last.
std::optional<TableColumns> tableColumns(const QStringList& names);
// The same out of "a b c d e f p" or "abecdfp".
std::optional<TableColumns> tableColumns(const QString& text);

// An order to read by, which may name further columns, as words or "-": "map a b c d e f p - colour".
std::optional<TableColumns> columnsToRead(const QString& text);

// Why a text names no such order, as a sentence; empty when it does.
QString columnsObstacle(const QString& text);

QStringList columnNames(const TableColumns& columns);

// Builds a map from one number for every column; `numbers` may be one shorter if the weight is missing from
// the row.
ifs::WeightedMap<2> mapOf(const TableColumns& columns, std::span<const double> numbers);
// Degrees of angles. In such a row with `count` numbers.
NumberUnit unitOfNumber(const TableColumns& columns, std::size_t number, std::size_t count);
// Index of the coefficient, 0 … 5 for A … F; nullopt for a weight, and if coefficients are computed from the
// column.
std::optional<int> coefficientOf(const TableColumns& columns, std::size_t number, std::size_t count);
// The numbers of a row; `weight` goes under Weight or Cumulative.
std::vector<double> numbersOf(const TableColumns& columns, const ifs::AffineMap<2>& map, double weight);

} // namespace io
