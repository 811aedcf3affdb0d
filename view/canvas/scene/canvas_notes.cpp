// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_notes.h"

#include "canvas/geometry/canvas_note.h"
#include "document/edits/cage/cage_edits.h"

namespace view {

namespace {

constexpr double readable = 220; // pixels; least width of a sentence beside a covered area
constexpr double edge = 56;      // pixels from the edge of the canvas to a sentence

} // namespace

std::vector<OverlayItem*> CanvasNotes::items() {
    return {&m_noteItem, &m_promptItem};
}

QRectF CanvasNotes::room() const {
    const QRectF covered = m_covered & m_view;
    if (covered.isEmpty()) return m_view;
    QRectF left = m_view, right = m_view, rest = m_view;
    left.setRight(covered.left());
    right.setLeft(covered.right());
    if (covered.center().y() < m_view.center().y())
        rest.setTop(covered.bottom());
    else
        rest.setBottom(covered.top());
    const QRectF& beside = left.width() >= right.width() ? left : right;
    return beside.width() >= readable ? beside : rest;
}

void CanvasNotes::setView(const QRectF& view) {
    m_view = view;
    avoid(m_handles);
}

void CanvasNotes::setCovered(const QRectF& area) {
    if (area == m_covered) return;
    m_covered = area;
    avoid(m_handles);
    m_noteItem.update();
    m_promptItem.update();
}

void CanvasNotes::setFont(const QFont& font) {
    m_noteItem.setFont(font);
    m_promptItem.setFont(font);
}

void CanvasNotes::avoid(const std::vector<QPointF>& handles) {
    m_handles = handles;
    const auto place = [&](NoteItem& item, bool isCovered, const QRectF& other) {
        item.setView(isCovered ? room() : m_view);
        item.avoid(handles, other);
        return !item.box().intersects(m_covered);
    };
    const bool isTop = m_covered.top() < m_view.top() + edge;
    const bool isBottom = m_covered.bottom() > m_view.bottom() - edge;
    if (!place(m_noteItem, isTop, {})) place(m_noteItem, true, {}); // fallback for many lines
    if (!place(m_promptItem, isBottom, m_noteItem.box())) place(m_promptItem, true, m_noteItem.box());
}

void CanvasNotes::describe(const document::Fractal& fractal, attractor::RenderNote note, bool isEmpty) {
    if (note == m_described && isEmpty == m_isEmpty && !m_isStale) return;
    m_described = note;
    m_isEmpty = isEmpty;
    m_isStale = false;
    m_text = noteOn(fractal, note);
    m_isWarning = !m_text.isEmpty() && m_text == document::cageWarning(fractal);
    if (isEmpty && (m_text.isEmpty() || m_isWarning)) {
        m_text = nothingHere();
        m_isWarning = false;
    }
    if (m_text != m_dismissed) m_dismissed.clear();
    say();
}

void CanvasNotes::say() {
    const bool isSaid = !m_text.isEmpty() && m_text != m_dismissed;
    m_noteItem.setDismissible(m_isWarning && isSaid);
    m_noteItem.setText(isSaid ? m_text : m_mode);
    avoid(m_handles);
}

void CanvasNotes::setMode(const QString& note) {
    m_mode = note;
    say();
}

bool CanvasNotes::dismissAt(const QPointF& position) {
    return m_noteItem.box().contains(position) && dismiss();
}

bool CanvasNotes::dismiss() {
    if (!m_isWarning || m_noteItem.text() != m_text) return false;
    m_dismissed = m_text;
    say();
    return true;
}

void CanvasNotes::setPrompt(const QString& prompt) {
    m_prompt = prompt;
    m_promptItem.setText(m_prompt.isEmpty() ? m_hint : m_prompt);
    avoid(m_handles);
}

void CanvasNotes::setHint(const QString& hint) {
    m_hint = hint;
    setPrompt(m_prompt);
}

} // namespace view
