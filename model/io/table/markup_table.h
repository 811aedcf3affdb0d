// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace io {

enum class Markup { Latex, Html, Markdown, Wiki };

struct MarkupRow {
    QStringList cells; // as plain text; numbers as they can be read
    int line = 0;      // of the text, from 1
};
struct MarkupTable {
    Markup markup = Markup::Latex;
    QList<MarkupRow> rows;
};

} // namespace io
