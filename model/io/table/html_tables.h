// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/markup_table.h"

#include <QString>
#include <QStringView>

namespace io {

// The tables of a page, each row of cells by itself; also rows without a table around them.
QList<MarkupTable> htmlTables(const QString& text);

// A text without tags, with its entities as signs (&minus; &frac12; &#8722;) and its blanks simplified.
QString textOfHtml(QStringView text);

// What stands between <pre> and </pre>, or <code> and </code>, without tags and entities; lines stay.
QString preformattedText(const QString& page);

} // namespace io
