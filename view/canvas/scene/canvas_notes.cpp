// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_notes.h"

#include "canvas/geometry/canvas_note.h"

namespace view {

std::vector<OverlayItem*> CanvasNotes::items() {
    return {&m_noteItem, &m_promptItem};
}

void CanvasNotes::setView(const QRectF& view) {
    m_noteItem.setView(view);
    m_promptItem.setView(view);
}

void CanvasNotes::setFont(const QFont& font) {
    m_noteItem.setFont(font);
    m_promptItem.setFont(font);
}

void CanvasNotes::avoid(const std::vector<QPointF>& handles) {
    m_noteItem.avoid(handles, {});
    m_promptItem.avoid(handles, m_noteItem.box());
}

void CanvasNotes::describe(const document::Fractal& fractal, attractor::RenderNote note) {
    if (note == m_described && !m_isStale) return;
    m_described = note;
    m_isStale = false;
    m_noteItem.setText(noteOn(fractal, note));
}

void CanvasNotes::setPrompt(const QString& prompt) {
    m_prompt = prompt;
    m_promptItem.setText(m_prompt.isEmpty() ? m_hint : m_prompt);
}

void CanvasNotes::setHint(const QString& hint) {
    m_hint = hint;
    setPrompt(m_prompt);
}

} // namespace view
