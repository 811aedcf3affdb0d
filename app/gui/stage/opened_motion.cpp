// SPDX-License-Identifier: MIT
#include "stage/opened_motion.h"

#include "desktop/reduced_motion.h"
#include "panels/timeline/playback.h"

#include <utility>

OpenedMotion::OpenedMotion(Parts parts, QObject* parent) : QObject(parent), m_parts(std::move(parts)) {
    connect(m_parts.document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        // Checked now: an entry that gets its first key later was not opened in motion.
        const bool moves = document::animationFacts(m_parts.document->entryFractal()).has_value();
        if (!(change.parts & (Change::Current | Change::File)) || !moves) return;
        if (std::exchange(m_isOpened, true)) return;
        m_index = m_parts.document->undoStack()->index();
        QMetaObject::invokeMethod(this, &OpenedMotion::begin, Qt::QueuedConnection);
    });
}

void OpenedMotion::begin() {
    m_isOpened = false;
    const document::Document& document = *m_parts.document;
    const bool isUndone = m_parts.document->undoStack()->index() < m_index;
    if (isUndone || m_parts.isGuided() || !document::animationFacts(document.entryFractal())) return;
    m_parts.showTimeline();
    if (!view::reducesMotion()) m_parts.playback->setPlaying(true);
}
