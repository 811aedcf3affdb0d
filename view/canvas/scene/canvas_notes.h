// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "canvas/items/note_item.h"
#include "document/fractal/fractal.h"

#include <QCoreApplication>

#include <vector>

namespace view {

// The sentences on the canvas: about the picture at the top, for the user at the bottom.
class CanvasNotes {
    Q_DECLARE_TR_FUNCTIONS(view::Canvas)

public:
    std::vector<OverlayItem*> items();
    void setView(const QRectF& view);    // pixels
    void setCovered(const QRectF& area); // area covered by something else; empty: none
    void setFont(const QFont& font);
    void avoid(const std::vector<QPointF>& handles); // pixels of handles that no sentence covers

    void forget() { m_isStale = true; } // called when the fractal has changed
    // `isEmpty`: the picture has nothing in this view.
    void describe(const document::Fractal& fractal, attractor::RenderNote note, bool isEmpty = false);
    // A warning that tells nothing new can be put away, by a click on it or by Esc, until there is another.
    bool dismissAt(const QPointF& position); // pixels; true if there was a note
    bool dismiss();
    QString note() const { return m_noteItem.text(); } // sentence at the top; empty: none

    void setMode(const QString& note); // shown if there is no remark on the picture

    void setPrompt(const QString& prompt); // request of the tool; empty: none
    void setHint(const QString& hint);     // shown while there is no prompt
    const QString& hint() const { return m_hint; }

private:
    QRectF room() const; // free area beside, above or below the covered one

    NoteItem m_noteItem{NoteItem::Edge::Top};
    NoteItem m_promptItem{NoteItem::Edge::Bottom};
    void say();

    attractor::RenderNote m_described = attractor::RenderNote::None;
    bool m_isEmpty = false;
    QString m_text; // remark on the picture, shown or dismissed
    QString m_mode;
    QString m_dismissed; // warning that was dismissed
    bool m_isWarning = false;
    bool m_isStale = true;
    QRectF m_view;
    QRectF m_covered;
    std::vector<QPointF> m_handles;
    QString m_prompt;
    QString m_hint;
};

} // namespace view
