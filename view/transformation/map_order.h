// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QWidget>

#include <cstddef>
#include <vector>

class QListWidget;
class QToolButton;

namespace view {

// The order of the maps, the one on top first, each in its colour: dragged, moved by two buttons, or all
// put back by a third.
class MapOrder : public QWidget {
    Q_OBJECT

public:
    explicit MapOrder(QWidget* parent = nullptr);

    // The active maps of the fractal; where the order does not name each once, they are shown as they are.
    void show(const document::Fractal& fractal, const std::vector<std::size_t>& order);

signals:
    // Sent for changes by the user; empty: original order.
    void ordered(const std::vector<std::size_t>& order);

private:
    void move(int by);
    void report();
    void updateButtons();

    QListWidget* m_list;
    QToolButton* m_up;
    QToolButton* m_down;
    QToolButton* m_reset;
    std::vector<std::size_t> m_maps; // active maps in their original order
};

} // namespace view
