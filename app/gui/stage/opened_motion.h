// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QObject>

#include <functional>

namespace view {
class Playback;
}

// Plays an entry that moves as soon as it is opened or chosen, unless motion is to be reduced. Undo
// brings entries back at rest.
class OpenedMotion : public QObject {
public:
    struct Parts {
        document::Document* document;
        view::Playback* playback;
        std::function<void()> showTimeline;
        std::function<bool()> isGuided; // true during a lesson, which decides itself what moves
    };
    OpenedMotion(Parts parts, QObject* parent);

private:
    void begin();

    Parts m_parts;
    int m_index = 0;         // index in the history when the entry was opened
    bool m_isOpened = false; // true until the motion is decided
};
