// SPDX-License-Identifier: MIT
#include "dialogs/paste_table_dialog.h"

#include "dialogs/column_orders.h"
#include "widgets/numbers/number_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>
#include <numeric>

namespace view {

namespace {

constexpr int shownMaps = 100;

document::Problems errorsOf(const io::Table& table) {
    document::Problems errors;
    std::copy_if(table.problems.begin(), table.problems.end(), std::back_inserter(errors),
                 [](const auto& problem) { return problem.severity == document::Problem::Severity::Error; });
    return errors;
}

// Maps, counted from 1, that do not contract.
QStringList stretching(const document::MapRows& rows) {
    QStringList found;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (ifs::spectralNorm(rows[i].map.linear) >= 1) found << QString::number(i + 1);
    return found;
}

// Returns true if the weights look like running sums, as weights of their own never do.
bool addUpToOneOrHundred(const document::MapRows& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i].weight || *rows[i].weight <= (i > 0 ? *rows[i - 1].weight : 0)) return false;
    return rows.size() > 1 && (*rows.back().weight == 1 || *rows.back().weight == 100);
}

} // namespace

PasteTableDialog::PasteTableDialog(document::Document* document, const document::Rows& rows,
                                   const QString& text, QWidget* parent)
    : QDialog(parent),
      m_text(text),
      m_rows(rows),
      m_gesture(document->beginGesture(tr("Paste maps"))),
      m_columns(new ColumnOrders(tr("The rows do not say which column is which, and programs differ. Choose "
                                    "the order that gives the picture you expect in the background."),
                                 this)),
      m_maps(new QTableWidget(0, 7, this)),
      m_verdict(new QLabel(this)) {
    setWindowTitle(tr("Paste a Table"));
    m_maps->setHorizontalHeaderLabels({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"),
                                       QStringLiteral("d"), QStringLiteral("e"), QStringLiteral("f"),
                                       QStringLiteral("p")});
    m_maps->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_maps->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_maps->setTabKeyNavigation(false);
    m_maps->setSelectionMode(QAbstractItemView::NoSelection);
    m_maps->setAlternatingRowColors(true);
    m_maps->setShowGrid(false);
    m_maps->setAccessibleName(tr("The maps as they will be pasted"));
    m_maps->setWhatsThis(tr("The maps in the chosen order: (x, y) goes to (a x + b y + e, c x + d y + f)."));
    m_verdict->setWordWrap(true);
    m_verdict->setAccessibleName(tr("What the maps do"));
    m_verdict->setMinimumHeight(2 * m_verdict->fontMetrics().lineSpacing());
    m_verdict->setAlignment(Qt::AlignTop | Qt::AlignLeft);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_accept = buttons->button(QDialogButtonBox::Ok);
    m_accept->setText(tr("&Paste"));
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("C&olumns:"), m_columns);
    layout->addRow(m_maps);
    layout->addRow(m_verdict);
    layout->addRow(buttons);
    resize(fontMetrics().averageCharWidth() * 78, fontMetrics().lineSpacing() * 20);

    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    guess();
    connect(m_columns, &ColumnOrders::changed, this, &PasteTableDialog::update);
    update();
}

void PasteTableDialog::askForColumns(document::Document* document, const QString& table, QWidget* parent) {
    const document::System2* system = document::system2(document->fractal());
    if (!system) return;
    document::Rows all(system->maps.size());
    std::iota(all.begin(), all.end(), 0);
    auto* dialog = new PasteTableDialog(document, all, table, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Order of the Columns"));
    dialog->m_accept->setText(tr("&Use This Order"));
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->setText(tr("&Keep as It Is"));
    dialog->open();
}

// The first order in which every map contracts.
void PasteTableDialog::guess() {
    const QStringList orders = m_columns->known();
    for (const QString& order : orders) {
        m_columns->choose(order);
        const io::Table table = io::readTable(m_text, m_columns->columns());
        if (!errorsOf(table).isEmpty() || !stretching(table.rows).isEmpty()) continue;
        if (m_columns->isFractints() && addUpToOneOrHundred(table.rows)) m_columns->chooseCumulative();
        return;
    }
    m_columns->choose(orders.first());
}

void PasteTableDialog::update() {
    m_table = io::readTable(m_text, m_columns->columns());
    const QString obstacle = m_columns->obstacle();
    const document::Problems errors = errorsOf(m_table);
    const bool usable = obstacle.isEmpty() && errors.isEmpty() && !m_table.rows.empty();
    m_accept->setEnabled(usable);
    m_maps->setRowCount(usable ? std::min(count(), shownMaps) : 0);
    for (int row = 0; row < m_maps->rowCount(); ++row) {
        const auto& [map, weight] =
            std::pair{m_table.rows[std::size_t(row)].map, m_table.rows[std::size_t(row)].weight};
        const double numbers[] = {map.linear(0, 0), map.linear(0, 1),    map.linear(1, 0),
                                  map.linear(1, 1), map.translation.x(), map.translation.y()};
        for (int column = 0; column < 7; ++column) {
            auto* cell = new QTableWidgetItem(column < 6 ? shortNumber(numbers[column])
                                              : weight   ? shortNumber(*weight)
                                                         : QString());
            cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_maps->setItem(row, column, cell);
        }
    }
    if (!usable) {
        m_verdict->setText(!obstacle.isEmpty() ? obstacle
                           : errors.isEmpty()
                               ? tr("There are no rows of 6 or 7 numbers.")
                               : tr("Line %1: %2").arg(errors.first().line).arg(errors.first().message));
        m_gesture.preview(m_gesture.before());
        return;
    }
    const QStringList wild = stretching(m_table.rows);
    m_verdict->setText(
        wild.isEmpty()
            ? tr("In this order every map contracts.")
            : tr("In this order these maps do not contract: %1. The columns may have a different meaning.")
                  .arg(wild.join(QStringLiteral(", "))));
    document::MapsEdit edit = withMapsPasted(m_gesture.before(), m_rows, m_table.rows);
    m_touched = std::move(edit.touched);
    m_gesture.preview(std::move(edit.fractal));
}

void PasteTableDialog::done(int result) {
    if (result == QDialog::Accepted && m_gesture.isOpen()) {
        m_gesture.commit();
        emit pasted(m_touched);
    } else {
        m_gesture.cancel();
    }
    QDialog::done(result);
}

} // namespace view
