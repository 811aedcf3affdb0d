// SPDX-License-Identifier: MIT
#include "dialogs/column_orders.h"

#include <QComboBox>
#include <QCoreApplication>

namespace view {

namespace {

struct ColumnOrders {
    Q_DECLARE_TR_FUNCTIONS(ColumnOrders)
};

} // namespace

void addColumnOrders(QComboBox* box) {
    for (const auto& [text, names] :
         {std::pair{ColumnOrders::tr("a b c d e f p: Fractint, Barnsley"), "a b c d e f p"},
          {ColumnOrders::tr("a b e c d f p: each equation in a row"), "a b e c d f p"},
          {ColumnOrders::tr("a c b d e f p: column by column"), "a c b d e f p"},
          {ColumnOrders::tr("p a b c d e f: the weight first"), "p a b c d e f"},
          {ColumnOrders::tr("r s theta phi e f p: scales, and angles in degrees"), "r s theta phi e f p"}})
        box->addItem(text, QString::fromLatin1(names));
}

io::TableColumns chosenColumns(const QComboBox* box) {
    return io::tableColumns(box->currentData().toString()).value_or(io::fractintColumns());
}

} // namespace view
