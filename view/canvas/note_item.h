// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/overlay_item.h"

#include <QFont>
#include <QString>

namespace view {

// A sentence on the canvas, in a quiet box; nothing while the text is empty.
class NoteItem : public OverlayItem {
public:
    enum class Place { Top, Bottom };
    explicit NoteItem(Place place) : m_place(place) {}

    void setText(const QString& text);
    const QString& text() const { return m_text; }
    void setView(const QRectF& view);
    void setFont(const QFont& font);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QRectF box() const;

    Place m_place;
    QString m_text;
    QRectF m_view;
    QFont m_font;
};

} // namespace view
