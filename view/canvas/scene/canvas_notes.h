// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "canvas/items/note_item.h"
#include "document/fractal/fractal.h"

#include <vector>

namespace view {

// The sentences on the canvas: about the picture at the top, for the user at the bottom.
class CanvasNotes {
public:
    std::vector<OverlayItem*> items();
    void setView(const QRectF& view);    // pixels
    void setCovered(const QRectF& area); // something else lies there; empty: nothing
    void setFont(const QFont& font);
    void avoid(const std::vector<QPointF>& handles); // in pixels: the sentences cover none

    void forget() { m_isStale = true; } // the fractal has changed
    void describe(const document::Fractal& fractal, attractor::RenderNote note);
    QString note() const { return m_noteItem.text(); } // the sentence about the picture, if one is shown

    void setPrompt(const QString& prompt); // what the tool asks for; empty: none
    void setHint(const QString& hint);     // shown while there is no prompt
    const QString& hint() const { return m_hint; }

private:
    QRectF room() const; // beside what is covered, or above or below it

    NoteItem m_noteItem{NoteItem::Edge::Top};
    NoteItem m_promptItem{NoteItem::Edge::Bottom};
    attractor::RenderNote m_described = attractor::RenderNote::None;
    bool m_isStale = true;
    QRectF m_view;
    QRectF m_covered;
    std::vector<QPointF> m_handles;
    QString m_prompt;
    QString m_hint;
};

} // namespace view
