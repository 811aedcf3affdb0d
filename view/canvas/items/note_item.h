// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QFont>
#include <QString>

#include <vector>

namespace view {

// A sentence on the canvas, in a quiet box; nothing while the text is empty.
class NoteItem : public OverlayItem {
public:
    enum class Edge { Top, Bottom };
    explicit NoteItem(Edge edge) : m_edge(edge) {}

    void setText(const QString& text);
    const QString& text() const { return m_text; }
    void setDismissible(bool dismissible); // shows that a click dismisses the note
    void setView(const QRectF& view);
    void setFont(const QFont& font);
    // Points that must stay in sight, in pixels, and a box that the note must not cover.
    void avoid(std::vector<QPointF> points, const QRectF& other);
    QRectF box() const;

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QRectF boxAt(int place) const;
    int obstaclesAt(int place) const;
    void choosePlace();

    Edge m_edge;
    int m_place = 0;
    std::vector<QPointF> m_points;
    QRectF m_other;
    QString m_text;
    QRectF m_view;
    QFont m_font;
    bool m_isDismissible = false;
};

} // namespace view
