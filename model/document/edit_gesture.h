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
        GestureHost* host = nullptr; // null once the gesture has ended
        std::shared_ptr<const Fractal> before;
    };
    explicit EditGesture(std::shared_ptr<const Link> link);
    ~EditGesture(); // cancels unless committed

    EditGesture(EditGesture&&) noexcept = default; // the other is not open afterwards
    EditGesture(const EditGesture&) = delete;
    EditGesture& operator=(const EditGesture&) = delete;

    bool isOpen() const; // until commit, cancel, undo, or another edit ends it
    // The fractal when the gesture began; compute every step from it.
    const Fractal& before() const { return *m_link->before; }
    // The text of the step, now that its values are known. Steps of one `kind` that follow each other within
    // a second become one step; −1: none of them.
    void describe(const QString& text, int kind = -1);
    void preview(Fractal fractal);    // shown at once, not in the history; ignored once the gesture has ended
    void previewEntry(Fractal entry); // the same, of Document::entryFractal() with its animation
    void commit();                    // one step; none when the fractal is as it was
    void cancel();                    // back to the beginning, exactly

private:
    std::shared_ptr<const Link> m_link; // null in a gesture that was moved away
};

} // namespace document
