// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/timeline/animation_edits.h"
#include "panels/timeline/ruler_marks.h"

#include <QAbstractScrollArea>
#include <QPointF>

#include <optional>
#include <vector>

class QToolButton;

namespace view {

class Timeline;

// The ruler, the playhead, and a row for every track and motion: keys as diamonds to select and drag. In
// front of a row a diamond makes or deletes the key at the playhead.
class TrackView : public QAbstractScrollArea {
    Q_OBJECT

public:
    explicit TrackView(Timeline* timeline, QWidget* parent = nullptr);

    // Positions in the viewport, also for code that drives the view.
    QPoint keyPosition(int row, int frame) const;
    QPoint rulerPosition(int frame) const;
    QPoint toggleOf(int row) const; // diamond at the beginning of the row

    RulerPlace rulerPlace() const;
    QRectF playheadFlag() const; // area of the frame number, which covers the ruler

    double pixelsPerFrame() const { return m_scale; }
    void fitLength();                                 // fits all frames into the width
    void reveal();                                    // scrolls to the playhead and the current row
    void setFlawedFrames(std::vector<double> frames); // frames marked in the ruler

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag { None, Playhead, Keys, Band };

    int rowHeight() const;
    int namesWidth() const;
    int left() const; // x of frame 0 before scrolling
    double xOf(double frame) const;
    int frameAt(double x) const;
    int topOf(int row) const;
    int rowAt(double y) const; // −1 above all rows, rowCount() below
    std::optional<document::KeyAt> keyAt(const QPointF& point) const;

    void layOut();
    void zoomAt(double x, double factor);
    void revealPlayhead();
    void describe();
    void refresh() {
        describe();
        viewport()->update();
    }
    int snapped(int by) const;
    document::KeyMove moveKind() const;
    void pressKey(const document::KeyAt& key);
    void dragKeysTo(const QPointF& point);
    std::vector<document::KeyAt> keysIn(const QRectF& band) const;
    bool isOurKey(const QKeyEvent& event) const;
    bool walk(const QKeyEvent& event);
    bool edit(const QKeyEvent& event);

    void paintRuler(QPainter& painter) const;
    void paintRow(QPainter& painter, int row) const;
    void paintName(QPainter& painter, int row) const;
    void paintKeys(QPainter& painter, int row) const;
    void paintPlayhead(QPainter& painter) const;
    RulerUnit rulerUnit() const;
    QString rulerText(int frame) const;

    Timeline* m_timeline;
    QToolButton* m_unit;
    double m_scale = 8; // pixels per frame
    bool m_isFitted = true;
    int m_down = 0; // vertical scroll offset of the rows in pixels
    std::vector<double> m_flawed;
    Drag m_drag = Drag::None;
    QPointF m_pressed, m_pointer;
    Qt::KeyboardModifiers m_modifiers;
    document::KeyAt m_held;
    bool m_hasMoved = false;
    bool m_wasSelected = false;            // true if the held key was selected before the press
    int m_by = 0;                          // frames by which the selected keys have been dragged
    std::vector<document::KeyAt> m_before; // selection before the rubber band
};

} // namespace view
