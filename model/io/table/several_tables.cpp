// SPDX-License-Identifier: MIT
#include "io/table/several_tables.h"

#include "io/table/table_columns.h"
#include "io/table/table_fields.h"

#include <QRegularExpression>
#include <QStringList>

namespace io {

namespace {

constexpr qsizetype longestHeader = 400;
constexpr qsizetype mostTables = 1000;

// Names of all columns, perhaps behind one for the labels of the rows.
bool isHeader(const QString& line) {
    static const QRegularExpression parting(QStringLiteral("[\\s,;|]+"));
    if (line.size() > longestHeader) return false;
    const QStringList words = line.split(parting, Qt::SkipEmptyParts);
    return words.size() >= 6 && (nameAllColumns(words) || nameAllColumns(words.sliced(1)));
}

} // namespace

QList<TitledTable> severalTables(const QString& text) {
    QList<TitledTable> tables;
    QString title;
    bool isInside = false;
    for (const QString& line : text.split(u'\n')) {
        const QString words = line.trimmed();
        if (isHeader(words)) {
            if (tables.size() == mostTables) return {};
            tables << TitledTable{title, line + u'\n'};
            isInside = true;
        } else if (words.isEmpty()) {
            isInside = isInside && tables.last().table.count(u'\n') < 2; // rule between header and rows
        } else if (isInside) {
            tables.last().table += line + u'\n';
        }
        title = isInside || words.isEmpty() ? QString() : words;
    }
    return tables.size() > 1 ? tables : QList<TitledTable>();
}

} // namespace io
