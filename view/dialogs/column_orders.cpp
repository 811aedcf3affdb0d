// SPDX-License-Identifier: MIT
#include "dialogs/column_orders.h"

#include "widgets/choices.h"

#include <QComboBox>
#include <QLineEdit>
#include <QVBoxLayout>

namespace view {

namespace {

const QString cumulative = QStringLiteral("a b c d e f cumulative");

} // namespace

ColumnOrders::ColumnOrders(const QString& whatsThis, QWidget* parent)
    : QWidget(parent), m_known(new QComboBox(this)), m_typed(new QLineEdit(this)) {
    for (const auto& [text, names] :
         {std::pair{tr("a b c d e f p: Fractint, Barnsley"), QStringLiteral("a b c d e f p")},
          {tr("a b e c d f p: one equation after the other"), QStringLiteral("a b e c d f p")},
          {tr("a c b d e f p: column by column"), QStringLiteral("a c b d e f p")},
          {tr("p a b c d e f: the weight first"), QStringLiteral("p a b c d e f")},
          {tr("r s theta phi e f p: scales, and angles in degrees"), QStringLiteral("r s theta phi e f p")},
          {tr("a b c d e f, and cumulative weights"), cumulative}})
        addChoice(m_known, text, names);
    addChoice(m_known, tr("Other…"), QString());
    m_known->setAccessibleName(tr("Order of the columns"));
    m_known->setWhatsThis(whatsThis);
    m_typed->setAccessibleName(tr("Column names in order"));
    m_typed->setWhatsThis(tr("The names of the columns in order: a b c d or r s theta phi, then e and f, "
                             "each once; if there are weights, also p, or cumulative for running sums of "
                             "weights. x′ = a·x + b·y + e and y′ = c·x + d·y + f."));
    m_typed->setToolTip(tr("The names of the columns in their order, such as a b c d e f p"));
    m_typed->hide();
    setFocusProxy(m_known);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_known);
    layout->addWidget(m_typed);
    connect(m_known, &QComboBox::currentIndexChanged, this, [this] {
        const auto order = chosenValue<QString>(m_known);
        m_typed->setVisible(order.isEmpty());
        if (!order.isEmpty())
            m_typed->setText(order); // start value for another order
        else
            m_typed->setFocus();
        emit changed();
    });
    m_typed->setText(chosenValue<QString>(m_known));
    connect(m_typed, &QLineEdit::textEdited, this, &ColumnOrders::changed);
}

io::TableColumns ColumnOrders::columns() const {
    return io::tableColumns(m_typed->text()).value_or(io::fractintColumns());
}

QString ColumnOrders::obstacle() const {
    return io::columnsObstacle(m_typed->text());
}

QStringList ColumnOrders::known() const {
    QStringList orders;
    for (int row = 0; row < m_known->count(); ++row)
        if (const QString order = m_known->itemData(row).toString(); !order.isEmpty()) orders << order;
    return orders;
}

void ColumnOrders::choose(const QString& order) {
    chooseValue(m_known, order);
}

void ColumnOrders::chooseCumulative() {
    choose(cumulative);
}

bool ColumnOrders::isFractints() const {
    return columns() == io::fractintColumns();
}

} // namespace view
