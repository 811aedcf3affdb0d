// SPDX-License-Identifier: MIT
#include "panels/maps/maps_columns.h"

#include "panels/maps/maps_delegate.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QStyle>
#include <QTableView>

#include <algorithm>
#include <numeric>
#include <vector>

namespace view {

namespace {

constexpr int narrowest = 30;        // pixels of a column of numbers
constexpr int narrowestInSpace = 20; // pixels in space, where there are twice as many columns
constexpr int eye = 22;
constexpr int lock = 18;
constexpr int picture = 36;
constexpr int shortestName = 48, longestName = 110;
constexpr int leastDecimals = 2;          // a coefficient is rarely larger than 1
constexpr double narrowestFigures = 0.72; // share of the usual width

// Digits that must be shown are drawn narrower, as in a drag, rather than left out of sight; the gaps between
// numbers stay.
void squeeze(std::vector<int>& widths, int room) {
    constexpr int gap = 2 * MapsDelegate::numberMargin;
    const int gaps = int(widths.size()) * gap;
    const int figures = std::accumulate(widths.begin(), widths.end(), -gaps);
    const double share = std::max(double(room - gaps) / figures, narrowestFigures);
    for (int& width : widths)
        width = gap + int((width - gap) * share);
}

} // namespace

MapsColumns::MapsColumns(QTableView* table, MapsModel* model)
    : QObject(table), m_table(table), m_model(model) {
    table->installEventFilter(this);
}

bool MapsColumns::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange) fit();
    return QObject::eventFilter(watched, event);
}

// The width of the numbers, and of the letter over them.
int MapsColumns::widthOf(int column) const {
    const QString name = m_model->headerData(column, Qt::Horizontal).toString();
    const QAbstractItemView* view = m_table; // base class, in which the hint is public
    return std::max({m_model->dimension() == 3 ? narrowestInSpace : narrowest,
                     view->sizeHintForColumn(column),
                     m_table->horizontalHeader()->fontMetrics().horizontalAdvance(name) + 12});
}

// The width for the columns. It must not depend on whether there is a scroll bar beside the rows, which
// depends on the widths: the scroll bar has its room unless all rows are in sight even above the other scroll
// bar.
int MapsColumns::available() const {
    const int scrollBar = m_table->style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, m_table);
    const int rows = m_table->verticalHeader()->length() + m_table->horizontalHeader()->sizeHint().height();
    const bool areInSight = rows + scrollBar + 2 * m_table->frameWidth() <= m_table->height();
    return m_table->width() - 2 * m_table->frameWidth() - m_table->verticalHeader()->sizeHint().width() -
           (areInSight ? 0 : scrollBar) - eye - lock - picture;
}

void MapsColumns::fit() {
    m_table->setColumnWidth(MapsModel::Enabled, eye);
    m_table->setColumnWidth(MapsModel::Lock, lock);
    m_table->setColumnWidth(MapsModel::Colour, picture);
    const bool isNamed = !m_table->isColumnHidden(MapsModel::Name);
    const int wantedName = isNamed ? std::min(widthOf(MapsModel::Name), longestName) : 0;
    const int name = std::min(wantedName, shortestName);
    const int room = available() - name;
    const int codeEnd = m_model->columnOf(MapsModel::Weight) + 1;
    std::vector<int> code(std::size_t(codeEnd - MapsModel::A)); // coefficients and weight
    std::iota(code.begin(), code.end(), int(MapsModel::A));
    std::vector<int> widths(code.size());
    int decimals = maxDecimals;
    for (; decimals >= leastDecimals; --decimals) {
        m_model->limitDecimals(decimals);
        std::ranges::transform(code, widths.begin(), [this](int column) { return widthOf(column); });
        if (std::accumulate(widths.begin(), widths.end(), 0) <= room) break;
    }
    if (decimals < leastDecimals) squeeze(widths, room);
    // Remaining width: for longer names if all digits are there, then for numbers that appear in a drag.
    int left = std::max(0, room - std::accumulate(widths.begin(), widths.end(), 0));
    if (isNamed) {
        const int given = decimals == maxDecimals ? std::min(wantedName - name, left) : 0;
        m_table->setColumnWidth(MapsModel::Name, name + given);
        left -= given;
    }
    for (std::size_t i = 0; i < code.size(); ++i)
        if (!m_table->isColumnHidden(code[i]))
            m_table->setColumnWidth(code[i], widths[i] + std::min(left / int(code.size()), narrowest));
    for (int column = codeEnd; column < m_model->columnCount(); ++column)
        if (!m_table->isColumnHidden(column)) m_table->setColumnWidth(column, widthOf(column));
}

} // namespace view
