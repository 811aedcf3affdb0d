// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "panels/timeline/motion_preview.h"

#include <QList>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QAction;
class QToolButton;

namespace view {

// The page in place of an empty table: loops that one click makes, as small moving pictures of the fractal
// itself with their names, and how to make keys.
class MotionPage : public QWidget {
    Q_OBJECT

public:
    // Makes an entry with a motion; nullopt if it cannot have this one.
    using Make = std::function<std::optional<document::Fractal>()>;

    // A button for each action; those with a menu and nothing to do by themselves open it.
    explicit MotionPage(const QList<QAction*>& actions, QWidget* parent = nullptr);

    // Makers of the moving pictures, in the order of the actions. Actions without one keep their icons.
    void setMotions(std::vector<Make> motions) { m_motions = std::move(motions); }
    void renew(); // called when the fractal has changed
    bool isMoving() const { return m_clock.isActive(); }

signals:
    void tableWanted(); // sent to show the rows of the timeline for making keys

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void draw();
    void drawNext(); // draws one frame of one tile, so that the window stays responsive
    void advance();

    struct Tile {
        QToolButton* button;
        std::vector<QPixmap> pictures;
    };
    std::vector<Tile> m_tiles;
    std::vector<Make> m_motions;
    QTimer m_soon;  // delay before pictures are redrawn
    QTimer m_after; // delay before the next tile
    QTimer m_clock; // interval between two pictures
    std::size_t m_frame = 0;
    std::size_t m_next = 0;                 // index of the next tile to draw
    std::optional<MotionPreview> m_preview; // preview of the tile being drawn
};

} // namespace view
