// SPDX-License-Identifier: MIT
#include "panels/maps/maps_row_header.h"

#include "panels/maps/maps_delegate.h"

#include <QMouseEvent>
#include <QPainter>

namespace view {

MapsRowHeader::MapsRowHeader(QWidget* parent) : QHeaderView(Qt::Vertical, parent) {
    setSectionsMovable(true);
    setFirstSectionMovable(true);
    setSectionsClickable(true);
    setHighlightSections(true);
    setSectionResizeMode(QHeaderView::Fixed);
    setDefaultAlignment(Qt::AlignCenter);
    setMouseTracking(true);
    setAccessibleName(tr("Numbers of the maps"));
    this->setWhatsThis(tr("Drag a number to move the map. A warning sign marks a map that does not contract, "
                          "or that a negative weight switches off."));
    connect(this, &QHeaderView::sectionMoved, this, &MapsRowHeader::putBack);
}

void MapsRowHeader::putBack(int, int from, int to) {
    {
        const QSignalBlocker blocker(this);
        moveSection(to, from);
    }
    // Queued until the header has handled the mouse, because the model may reset it.
    QMetaObject::invokeMethod(
        this, [this, from, to] { emit rowDragged(from, to); }, Qt::QueuedConnection);
}

void MapsRowHeader::mouseMoveEvent(QMouseEvent* event) {
    setCursor(event->buttons() & Qt::LeftButton ? Qt::ClosedHandCursor : Qt::OpenHandCursor);
    emit rowPointed(logicalIndexAt(event->position().toPoint()));
    QHeaderView::mouseMoveEvent(event);
}

void MapsRowHeader::leaveEvent(QEvent* event) {
    emit rowPointed(-1);
    QHeaderView::leaveEvent(event);
}

// The size of any row: all have the same, which is asked for many of them at a time.
QSize MapsRowHeader::sectionSizeFromContents(int row) const {
    if (m_sizedCount != count() || m_sizedFont != font()) {
        m_sizedCount = count();
        m_sizedFont = font();
        const int digits = fontMetrics().horizontalAdvance(QString::number(count()));
        m_size = {digits + 26, QHeaderView::sectionSizeFromContents(row).height()};
    }
    return m_size;
}

void MapsRowHeader::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange) m_sizedCount = -1;
    QHeaderView::changeEvent(event);
}

void MapsRowHeader::paintSection(QPainter* painter, const QRect& area, int row) const {
    painter->save();
    QHeaderView::paintSection(painter, area, row);
    painter->restore();

    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(palette().color(QPalette::PlaceholderText));
    for (int dot = -1; dot <= 1; ++dot)
        painter->drawEllipse(QPointF(area.left() + 5.5, area.center().y() + 0.5 + 4 * dot), 1.1, 1.1);
    if (!model()->headerData(row, Qt::Vertical, MapsModel::WarningRole).toString().isEmpty()) {
        QRectF sign(0, 0, 9, 8);
        sign.moveCenter(QPointF(area.right() - 6.5, area.center().y() + 0.5));
        paintWarningSign(*painter, sign, palette());
    }
    painter->restore();
}

} // namespace view
