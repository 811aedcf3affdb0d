// SPDX-License-Identifier: MIT
#include "document/edits/live_edit.h"

namespace document {

void LiveEdit::preview(const QString& text, const std::function<void(Fractal&)>& change, int kind) {
    if (!isOpen()) // not begun, or ended by another gesture
        m_gesture.emplace(m_document->beginGesture(text));
    m_gesture->describe(text, kind);
    Fractal fractal = m_gesture->before();
    change(fractal);
    m_gesture->preview(std::move(fractal));
}

void LiveEdit::commit() {
    if (isOpen()) m_gesture->commit();
    m_gesture.reset();
}

void LiveEdit::cancel() {
    if (isOpen()) m_gesture->cancel();
    m_gesture.reset();
}

const Fractal& LiveEdit::before() const {
    return isOpen() ? m_gesture->before() : m_document->fractal();
}

} // namespace document
