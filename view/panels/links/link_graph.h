// SPDX-License-Identifier: MIT
#pragma once

#include "panels/links/link_layout.h"

#include <QWidget>

namespace view {

class LinksModel;

// The links of the entry being edited as a graph: its maps on a circle, an arrow to each map that may follow.
// Dragging from one map to another links them; a selected arrow is deleted. Each is one step of the history.
class LinkGraph : public QWidget {
    Q_OBJECT

public:
    explicit LinkGraph(LinksModel* model, QWidget* parent = nullptr); // `model` must outlive the graph

    const LinkLayout& graph() const { return m_layout; }
    int currentMap() const { return m_map; }    // −1: none
    int selectedTarget() const { return m_to; } // target of the selected arrow from the current map; −1: none
    void select(int from, int to);              // arrow, or with −1 the map alone

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void selected(int from, int to);   // sent for selections by the user
    void editWanted(int from, int to); // sent to edit the weight of the arrow

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void lay();
    void choose(int from, int to); // selects on behalf of the user
    void link(int from, int to);
    void removeSelected();
    void walkMaps(int step);
    void walkArrows(int step);
    bool isLinked(int from, int to) const;
    bool takes(int key) const;
    void describe();
    QString tipAt(const QPoint& position) const;
    void paintArrows(QPainter& painter) const;
    void paintNode(QPainter& painter, int map) const;
    void paintPull(QPainter& painter) const;

    LinksModel* m_model;
    LinkLayout m_layout;
    int m_map = -1;
    int m_to = -1;
    int m_pulledFrom = -1; // source of an arrow being drawn; −1: none
    // True once the pointer has left m_pulledFrom; returning then links the map to itself.
    bool m_hasLeft = false;
    QPointF m_pointer;
    int m_keyTarget = -1; // target of an arrow being drawn with the keyboard; −1: none
};

} // namespace view
