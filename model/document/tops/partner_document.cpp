// SPDX-License-Identifier: MIT
#include "document/tops/partner_document.h"

#include <utility>

namespace document {

PartnerDocument::PartnerDocument(Document* host) : m_host(host) {
    m_document.undoStack()->setUndoLimit(1); // the history is the host's
    connect(host, &Document::changed, this, [this](const Change& change) {
        if (!change.live) take();
    });
    connect(host, &Document::cageModeChanged, &m_document, &Document::setCageMode);
    m_document.setCageMode(host->cageMode());
    connect(m_document.undoStack(), &QUndoStack::indexChanged, this, &PartnerDocument::give);
}

// The host may be gone, and the history ends by one more change.
PartnerDocument::~PartnerDocument() {
    m_document.undoStack()->disconnect(this);
}

void PartnerDocument::setPartner(EntryId id) {
    if (indexOf(m_host->file(), id) < 0) id = EntryId::None;
    if (std::exchange(m_id, id) == id) return;
    id == EntryId::None ? clear() : take();
    emit partnerChanged();
}

void PartnerDocument::take() {
    if (m_id == EntryId::None) return;
    const qsizetype index = indexOf(m_host->file(), m_id);
    if (index < 0) {
        m_id = EntryId::None;
        clear();
        emit partnerChanged();
        return;
    }
    const std::shared_ptr<const Fractal>& fractal = m_host->file().entries[index].fractal;
    if (m_shown == m_id && *fractal == m_document.entryFractal()) return;
    // Shares the fractal instead of copying it, so that caches recognise it.
    FractalFile file = m_shown == m_id ? m_document.file() : fileOf(*fractal);
    file.entries.front().fractal = fractal;
    m_isTaking = true;
    if (std::exchange(m_shown, m_id) == m_id)
        m_document.editFile(QString(), std::move(file));
    else
        m_document.setFile(std::move(file));
    m_isTaking = false;
}

void PartnerDocument::clear() {
    m_shown = EntryId::None;
    m_isTaking = true;
    m_document.setFile({});
    m_isTaking = false;
}

void PartnerDocument::give() {
    const qsizetype index = indexOf(m_host->file(), m_id);
    if (m_isTaking || index < 0) return;
    const std::shared_ptr<const Fractal>& fractal = m_document.currentEntry().fractal;
    FractalFile file = m_host->file();
    if (*fractal == *file.entries[index].fractal) return;
    file.entries[index].fractal = fractal;
    m_host->editFile(m_document.undoStack()->undoText(), std::move(file), m_host->currentId());
}

} // namespace document
