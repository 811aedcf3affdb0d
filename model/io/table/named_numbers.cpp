// SPDX-License-Identifier: MIT
#include "io/table/named_numbers.h"

#include "io/table/table_cells.h"
#include "io/table/table_columns.h"
#include "io/table/table_fields.h"

#include <QRegularExpression>
#include <QStringList>

namespace io {

namespace {

constexpr qsizetype longestText = 4 * 1024 * 1024;

bool isColumnName(const QString& name) {
    return tableColumn(name) || (name.size() == 1 && name[0] >= u'a' && name[0] <= u'l');
}

// The numbers of a map by the order of the first one's names; empty when the names are others.
QStringList ordered(const QStringList& wanted, const QStringList& names, const QStringList& numbers) {
    if (names.size() != wanted.size()) return {};
    QStringList cells;
    for (const QString& name : wanted) {
        const qsizetype index = names.indexOf(name);
        if (index < 0) return {};
        cells << numbers[index];
    }
    return cells;
}

} // namespace

QList<MarkupRow> namedNumbers(const QString& text) {
    static const QRegularExpression pair(
        QStringLiteral(R"((?<![\p{L}\d_.])(\p{L}+)(?:_?\{?\d{1,3}\}?)?\s*[:=]\s*([^\s,;|&=:]++)(?!\s*[:=]))"),
        QRegularExpression::UseUnicodePropertiesOption);
    if (text.size() > longestText) return {};
    QList<MarkupRow> rows;
    QStringList names, numbers, wanted;
    int line = 1, begun = 1;
    qsizetype before = 0;
    bool isGood = true;
    const auto endRow = [&] {
        if (names.isEmpty()) return;
        if (wanted.isEmpty()) {
            wanted = names;
            rows << MarkupRow{names, begun};
        }
        const QStringList cells = ordered(wanted, names, numbers);
        isGood = isGood && !cells.isEmpty() && rows.size() <= maxTableRows;
        rows << MarkupRow{cells, begun};
        names.clear();
        numbers.clear();
    };
    auto found = pair.globalMatch(text);
    while (found.hasNext() && isGood) {
        const auto match = found.next();
        const QString name = match.captured(1).toLower();
        if (!isColumnName(name)) continue;
        line += int(QStringView(text).sliced(before, match.capturedStart() - before).count(u'\n'));
        before = match.capturedStart();
        if (names.contains(name)) endRow();
        if (names.isEmpty()) begun = line;
        names << name;
        numbers << match.captured(2);
        const QStringView behind = QStringView(text).sliced(match.capturedEnd());
        const bool isCut = behind.size() > 1 && behind[0] == u',' && behind[1].isDigit(); // a=0,25
        isGood = isGood && !isCut &&
                 numberIn(Cell{numbers.last(), line, 1}, Dialect{Separator::Tab, false, false});
    }
    endRow();
    return isGood && rows.size() > 2 && nameAllColumns(wanted) ? rows : QList<MarkupRow>();
}

} // namespace io
