// SPDX-License-Identifier: MIT
#include "document/edit_gesture.h"

#include <utility>

namespace document {

EditGesture::EditGesture(Document& document, const QString& text) : m_document(&document), m_text(text) {
    document.commitGesture();
    m_before = document.currentEntry().fractal;
    document.m_gesture = this;
}

EditGesture::~EditGesture() {
    cancel();
}

bool EditGesture::isOpen() const {
    return m_document && m_document->m_gesture == this;
}

void EditGesture::preview(Fractal fractal) {
    if (!isOpen() || m_document->m_index < 0) return;
    auto shown = std::make_shared<const Fractal>(std::move(fractal));
    m_previewed |= difference(m_document->fractal(), *shown);
    m_document->show(shown, Document::Live::Yes);
}

void EditGesture::commit() {
    if (!isOpen()) return;
    const auto after = m_document->currentEntry().fractal;
    if (*after == *m_before) return cancel();
    // The step's own announcement ends what was live; m_gesture stays set until then so that nothing is
    // missed.
    m_document->push(m_text, {m_document->m_current, m_before, {}}, {m_document->m_current, after, {}});
}

void EditGesture::cancel() {
    if (!isOpen()) return;
    m_document->m_gesture = nullptr;
    m_document->show(m_before, Document::Live::No, m_previewed);
}

} // namespace document
