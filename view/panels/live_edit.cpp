// SPDX-License-Identifier: MIT
#include "panels/live_edit.h"

namespace view {

void LiveEdit::preview(const QString& text, const std::function<void(document::Fractal&)>& change) {
    if (!isOpen()) // none yet, or another gesture has ended ours
        m_gesture.emplace(*m_document, text);
    document::Fractal fractal = m_gesture->before();
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

const document::Fractal& LiveEdit::before() const {
    return isOpen() ? m_gesture->before() : m_document->fractal();
}

} // namespace view
