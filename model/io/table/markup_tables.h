// SPDX-License-Identifier: MIT
#pragma once

#include "io/table/markup_table.h"

#include <QList>
#include <QString>
#include <QStringList>

// Tables as LaTeX, HTML, Markdown and wikis write them, and matrices of LaTeX.
namespace io {

// The tables in the order of the text. Rules between rows are left out, and so are hidden text and mere
// typesetting. Lines of cells alone, without the beginning of a table, form one as well.
QList<MarkupTable> markupTables(const QString& text);

// A matrix or a column of numbers in LaTeX, with its place in the text.
struct LatexMatrix {
    QList<QStringList> rows;
    qsizetype begin = 0, end = 0; // extent of the environment
};
QList<LatexMatrix> latexMatrices(const QString& text);

// The text of a cell in the way readTable() takes it between tabs: a number, or words in quotation marks.
QString tableCell(const QString& text);

} // namespace io
