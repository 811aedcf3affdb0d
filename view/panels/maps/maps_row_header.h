// SPDX-License-Identifier: MIT
#pragma once

#include <QHeaderView>

namespace view {

// The numbers of the maps, each a handle to drag its row by. A dragged row is reported and put back: the
// model moves it.
class MapsRowHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit MapsRowHeader(QWidget* parent = nullptr);

signals:
    void rowPointed(int row);          // row under the pointer; −1: none
    void rowDragged(int from, int to); // `to`: row of the drop

protected:
    void paintSection(QPainter* painter, const QRect& area, int row) const override;
    QSize sectionSizeFromContents(int row) const override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void putBack(int row, int from, int to);

    mutable QSize m_size; // size of each section for m_sizedCount rows and m_sizedFont
    mutable int m_sizedCount = -1;
    mutable QFont m_sizedFont;
};

} // namespace view
