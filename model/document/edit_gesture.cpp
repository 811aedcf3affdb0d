// SPDX-License-Identifier: MIT
#include "document/edit_gesture.h"

#include <utility>

namespace document {

EditGesture::EditGesture(std::shared_ptr<const Link> link) : m_link(std::move(link)) {}

EditGesture::~EditGesture() {
    cancel();
}

bool EditGesture::isOpen() const {
    return m_link && m_link->host != nullptr;
}

void EditGesture::preview(Fractal fractal) {
    if (isOpen()) m_link->host->previewGesture(std::move(fractal));
}

void EditGesture::previewEntry(Fractal entry) {
    if (isOpen()) m_link->host->previewGestureOfEntry(std::move(entry));
}

void EditGesture::describe(const QString& text, int kind) {
    if (isOpen()) m_link->host->describeGesture(text, kind);
}

void EditGesture::commit() {
    if (isOpen()) m_link->host->commitGesture();
}

void EditGesture::cancel() {
    if (isOpen()) m_link->host->cancelGesture();
}

} // namespace document
