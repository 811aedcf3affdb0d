// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QFont>
#include <QString>

namespace view {

// The result of a gesture so far, in a small box at the pointer; hidden while the text is empty.
class ReadoutItem : public OverlayItem {
public:
    void setText(const QString& text, const QPointF& pointer); // pixels of the view
    const QString& text() const { return m_text; }
    void setView(const QRectF& view); // area that contains the text
    void setFont(const QFont& font);
    QRectF box() const; // area beside the pointer, never under it

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QString m_text;
    QPointF m_pointer;
    QRectF m_view;
    QFont m_font;
};

} // namespace view
