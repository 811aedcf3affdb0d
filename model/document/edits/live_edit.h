// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <functional>
#include <optional>

namespace document {

// An edit in one field, from the first key or pixel to its end: shown at once, one undo step.
class LiveEdit {
public:
    explicit LiveEdit(Document* document) : m_document(document) {}

    // Applies `change` to the fractal as it was when the edit began, which is now if none is under way. The
    // kind: see EditGesture::describe().
    void preview(const QString& text, const std::function<void(Fractal&)>& change, int kind = -1);
    void commit();
    void cancel();
    bool isOpen() const { return m_gesture && m_gesture->isOpen(); }
    // The fractal when the edit began; the present one when no edit is open.
    const Fractal& before() const;

private:
    Document* m_document;
    std::optional<EditGesture> m_gesture;
};

} // namespace document
