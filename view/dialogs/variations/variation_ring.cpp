// SPDX-License-Identifier: MIT
#include "dialogs/variations/variation_ring.h"

#include "dialogs/variations/picture_tiles.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <utility>

namespace view {

namespace {

constexpr int cells = 4; // cells along each side; the parent takes the four in the middle
constexpr int usualCell = 138;
constexpr int minCell = 72;

using Cell = std::pair<int, int>; // row, column

constexpr std::array<Cell, VariationRing::count> ring{
    {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 0}, {1, 3}, {2, 0}, {2, 3}, {3, 0}, {3, 1}, {3, 2}, {3, 3}}};

// −1: the parent
int childOf(const QModelIndex& index) {
    const auto found = std::ranges::find(ring, Cell(index.row(), index.column()));
    return found == ring.end() ? -1 : int(found - ring.begin());
}

} // namespace

VariationRing::VariationRing(QWidget* parent) : QTableWidget(cells, cells, parent) {
    setItemDelegate(new PictureTiles(this));
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column)
            setItem(row, column, new QTableWidgetItem);
    setSpan(1, 1, 2, 2);
    parentItem()->setData(PictureTiles::chosenRole, true);
    setCurrentItem(parentItem(), QItemSelectionModel::NoUpdate);
    setSelectionMode(QAbstractItemView::NoSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QHeaderView* header : {horizontalHeader(), verticalHeader()}) {
        header->hide();
        header->setMinimumSectionSize(minCell);
        header->setSectionResizeMode(QHeaderView::Stretch);
    }
    const int frame = 2 * frameWidth();
    setMinimumSize(cells * minCell + frame, cells * minCell + frame);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    policy.setHorizontalStretch(1);
    setSizePolicy(policy);
}

QSize VariationRing::sizeHint() const {
    const int side = cells * usualCell + 2 * frameWidth();
    return {side, side};
}

int VariationRing::cell() const {
    return std::min(viewport()->width(), viewport()->height()) / cells;
}

int VariationRing::childSide() const {
    return cell() - 2 * PictureTiles::margin;
}

int VariationRing::parentSide() const {
    return 2 * cell() - 2 * PictureTiles::margin;
}

QTableWidgetItem* VariationRing::parentItem() const {
    return item(1, 1);
}

QTableWidgetItem* VariationRing::childItem(int child) const {
    const auto [row, column] = ring[std::size_t(child)];
    return item(row, column);
}

void VariationRing::showParent(const Thumbnail& thumbnail, const QString& description) {
    PictureTiles::show(model(), indexFromItem(parentItem()), thumbnail);
    parentItem()->setData(Qt::AccessibleTextRole, description);
}

void VariationRing::showChild(int child, const Thumbnail& thumbnail, const QString& description) {
    PictureTiles::show(model(), indexFromItem(childItem(child)), thumbnail);
    childItem(child)->setData(Qt::AccessibleTextRole, description);
}

QPixmap VariationRing::childPicture(int child) const {
    return PictureTiles::shown(indexFromItem(childItem(child))).pixmap;
}

void VariationRing::choose(const QModelIndex& index) {
    const int child = childOf(index);
    m_hasChosen = index.isValid();
    if (child >= 0) emit chosen(child);
}

// Takes Enter, which the dialog would otherwise give to its default button.
void VariationRing::keyPressEvent(QKeyEvent* event) {
    const bool chooses =
        event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (!chooses) return QTableWidget::keyPressEvent(event);
    event->accept();
    if (event->isAutoRepeat()) return;
    if (childOf(currentIndex()) >= 0)
        choose(currentIndex());
    else if (currentIndex().isValid())
        emit used();
}

void VariationRing::mousePressEvent(QMouseEvent* event) {
    m_pressed = event->button() == Qt::LeftButton ? indexAt(event->position().toPoint()) : QModelIndex();
    m_hasChosen = false;
    QTableWidget::mousePressEvent(event);
}

void VariationRing::mouseReleaseEvent(QMouseEvent* event) {
    const QModelIndex pressed = std::exchange(m_pressed, QPersistentModelIndex());
    QTableWidget::mouseReleaseEvent(event);
    if (event->button() == Qt::LeftButton && pressed.isValid() &&
        pressed == indexAt(event->position().toPoint()))
        choose(pressed);
}

// The first click has brought it to the middle.
void VariationRing::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_hasChosen) emit used();
    event->accept();
}

void VariationRing::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    emit resized();
}

} // namespace view
