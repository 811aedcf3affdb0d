// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/thumbnails.h"

#include <QTableWidget>

namespace view {

// The picture of a parent in the middle, and those of its children around it. A click, Enter or Space chooses
// a child; a double click, or the same on the parent, says that it is to be used.
class VariationRing : public QTableWidget {
    Q_OBJECT

public:
    static constexpr int count = 12; // number of children

    explicit VariationRing(QWidget* parent = nullptr);

    int childSide() const; // side of the pictures in pixels of the window
    int parentSide() const;

    void showParent(const Thumbnail& thumbnail, const QString& description);
    void showChild(int child, const Thumbnail& thumbnail, const QString& description);
    QPixmap childPicture(int child) const; // picture as shown
    QTableWidgetItem* parentItem() const;
    QTableWidgetItem* childItem(int child) const;

    QSize sizeHint() const override;

signals:
    void chosen(int child);
    void used(); // sent to use the variation in the middle
    void resized();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void choose(const QModelIndex& index);
    int cell() const; // shorter side of a cell

    QPersistentModelIndex m_pressed;
    bool m_hasChosen = false; // true if the last click chose a child
};

} // namespace view
