// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

namespace io {

struct TitledTable {
    QString title; // line above the header, unless it belongs to the previous table
    QString table; // table for readTable(), including its header
};

// The tables of a text, as a paper or a page has them one below the other, each under a header of its own
// that names its columns. Empty when there is only one header.
QList<TitledTable> severalTables(const QString& text);

} // namespace io
