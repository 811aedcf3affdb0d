// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/animation_edits.h"

#include <QString>

#include <vector>

namespace view {

class Timeline;

// What can be done to the keys of a timeline: those that are selected, or one at the playhead. Every edit is
// one step of the history.
class KeyCommands {
public:
    explicit KeyCommands(Timeline* timeline) : m_timeline(timeline) {}

    void set();           // in the current track at the playhead
    void setInAll();      // in all tracks that have keys; where none has, in all
    void toggle(int row); // at the playhead
    void remove();        // or the current motion
    void move(int by, document::KeyMove how);
    void setEase(const animation::Ease& ease);
    animation::Ease ease() const; // of the first selected key
    void copy();
    bool canPaste() const { return !m_copied.empty(); }
    void paste();

private:
    void edit(const QString& text, document::Fractal entry);
    const document::Fractal& entry() const;

    Timeline* m_timeline;
    std::vector<document::CopiedKey> m_copied;
};

} // namespace view
