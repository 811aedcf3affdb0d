// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace io {

enum class Markup { Latex, Html, Markdown, Wiki };

struct MarkupRow {
    QStringList cells; // plain text; numbers in readable notation
    int line = 0;      // line of the text, 1-based
};
struct MarkupTable {
    Markup markup = Markup::Latex;
    QList<MarkupRow> rows;
};

} // namespace io
