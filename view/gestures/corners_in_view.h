// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <functional>
#include <utility>

namespace view {

// A command that takes corners out of a view that showed them all fits the view. A drag may leave it: the
// hand wants so.
class CornersInView {
public:
    struct View {
        std::function<bool()> showsAll; // every corner
        std::function<bool()> isShown;
        std::function<bool()> isHeld; // by a hand or a key in the view; fields elsewhere only command
        std::function<void()> fit;
    };
    CornersInView(document::Document* document, View view) : m_document(document), m_view(std::move(view)) {}

    void follow(const document::Change& change, QObject* context); // after the view has followed it
    void look() { m_wereInView = m_view.showsAll(); }              // after the camera has moved

private:
    document::Document* m_document;
    View m_view;
    bool m_wereInView = true; // state after the last change of the cage
    bool m_isDragged = false; // true while a gesture moves the cage
};

} // namespace view
