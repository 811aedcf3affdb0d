// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QObject>

namespace document {

// A document for another entry of a document, so that a second canvas can hold it. Finished edits become
// steps of the host's history; changes of the entry there are shown here.
class PartnerDocument : public QObject {
    Q_OBJECT

public:
    explicit PartnerDocument(Document* host);
    ~PartnerDocument() override;

    Document& document() { return m_document; }
    const Document& document() const { return m_document; }
    EntryId id() const { return m_id; } // id in the host; None without a partner
    void setPartner(EntryId id);

signals:
    void partnerChanged(); // also sent when there is none any more

private:
    void take(); // copies from the host
    void clear();
    void give(); // copies to the host

    Document* m_host;
    Document m_document;
    EntryId m_id = EntryId::None;
    EntryId m_shown = EntryId::None;
    bool m_isTaking = false;
};

} // namespace document
