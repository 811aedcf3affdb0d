// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <memory>

namespace document {

// Interface of the document towards the gesture that it began. At most one gesture is open at a time.
class GestureHost {
public:
    virtual void previewGesture(Fractal fractal) = 0;
    virtual void previewGestureOfEntry(Fractal entry) = 0;
    virtual void commitGesture() = 0;
    virtual void cancelGesture() = 0;
    virtual void describeGesture(const QString& text, int kind) = 0;

protected:
    ~GestureHost() = default;
};

// A drag, or the typing in one cell: shows values live and leaves one undo step, or none. Handed out by
// Document::beginGesture().
class EditGesture {
public:
    // State shared by the host and its gesture.
    struct Link {
        GestureHost* host = nullptr; // null after the end of the gesture
        std::shared_ptr<const Fractal> before;
    };
    explicit EditGesture(std::shared_ptr<const Link> link);
    ~EditGesture(); // cancels an open gesture

    EditGesture(EditGesture&&) noexcept = default; // leaves the other gesture closed
    EditGesture(const EditGesture&) = delete;
    EditGesture& operator=(const EditGesture&) = delete;

    bool isOpen() const; // true until commit, cancel, undo or another edit
    // The fractal when the gesture began; compute every step from it.
    const Fractal& before() const { return *m_link->before; }
    // The text of the step, now that its values are known. Steps of one `kind` that follow each other within
    // a second become one step; −1: none of them.
    void describe(const QString& text, int kind = -1);
    // Shown at once without a step of the history; ignored after the end of the gesture.
    void preview(Fractal fractal);
    void previewEntry(Fractal entry); // preview of Document::entryFractal() including its animation
    void commit();                    // adds one step to the history; none if the fractal is unchanged
    void cancel();                    // restores the state before the gesture exactly

private:
    std::shared_ptr<const Link> m_link; // null after a move
};

} // namespace document
