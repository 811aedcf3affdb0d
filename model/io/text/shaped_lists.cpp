// SPDX-License-Identifier: MIT
#include "io/text/shaped_lists.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace io {

namespace {

// Rows and columns; 0 where nothing says how many.
struct MatrixSize {
    qsizetype rows = 0;
    qsizetype columns = 0;
    bool areColumnsFirst = false;
};

bool isListOfNumbers(const Literal& list) {
    return list.kind == Literal::Kind::List && !list.items.isEmpty() &&
           std::ranges::all_of(list.items,
                               [](const Literal& item) { return item.kind == Literal::Kind::Number; });
}

qsizetype countOf(const Literal& item) {
    const bool isCount = item.kind == Literal::Kind::Number && item.number >= 1 && item.number <= 1e6 &&
                         item.number == std::floor(item.number);
    return isCount ? qsizetype(item.number) : 0;
}

// The arguments behind the first, as R orders them.
MatrixSize sizeIn(const QList<Literal>& arguments) {
    MatrixSize found;
    found.areColumnsFirst = true;
    for (const Literal& item : arguments.sliced(1)) {
        const qsizetype count = countOf(item);
        if (item.key == u"byrow")
            found.areColumnsFirst = item.text != u"TRUE" && item.text != u"T";
        else if (item.key == u"nrow" || (item.key.isEmpty() && found.rows == 0))
            found.rows = count;
        else if (item.key == u"ncol" || item.key.isEmpty())
            found.columns = count;
    }
    return found;
}

// Leaves the list as it is where the numbers do not fill the matrix.
void shape(Literal& list, const QList<Literal>& numbers, MatrixSize size) {
    const qsizetype count = numbers.size();
    if (size.rows == 0 && size.columns > 0) size.rows = count / size.columns;
    if (size.columns == 0 && size.rows > 0) size.columns = count / size.rows;
    if (size.rows == 0 || size.columns == 0 || size.rows * size.columns != count) return;
    if (size.columns == 1) {
        list.items = numbers;
        return;
    }
    QList<Literal> rows(size.rows);
    for (qsizetype row = 0; row < size.rows; ++row)
        for (qsizetype column = 0; column < size.columns; ++column)
            rows[row].items
                << numbers[size.areColumnsFirst ? column * size.rows + row : row * size.columns + column];
    list.items = std::move(rows);
}

} // namespace

void shapeMatrices(Literal& root) {
    for (qsizetype i = 0; i < root.items.size(); ++i) {
        Literal& item = root.items[i];
        if (item.kind != Literal::Kind::List) continue;
        if (item.text == u"matrix" && item.items.size() > 1 && isListOfNumbers(item.items[0])) {
            const QList<Literal> numbers = item.items[0].items;
            shape(item, numbers, sizeIn(item.items));
        } else if (item.text == u".reshape" && i > 0 && item.items.size() == 2) {
            Literal& before = root.items[i - 1];
            const Literal& inner = before.items.size() == 1 ? before.items[0] : before;
            if (isListOfNumbers(inner)) {
                const QList<Literal> numbers = inner.items;
                shape(before, numbers, {countOf(item.items[0]), countOf(item.items[1]), false});
                root.items.removeAt(i--);
            }
        } else {
            shapeMatrices(item);
        }
    }
}

} // namespace io
