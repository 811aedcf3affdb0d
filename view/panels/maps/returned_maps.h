// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QObject>

#include <vector>

namespace view {

// Tells of maps that come back when their deletion is undone, so that they can be selected again.
class ReturnedMaps : public QObject {
    Q_OBJECT

public:
    ReturnedMaps(document::Document* document, QObject* parent);

signals:
    void returned(const std::vector<ifs::MapId>& maps);

private:
    void look();

    document::Document* m_document;
    document::EntryId m_entry = document::EntryId::None; // entry examined last; its maps are in m_maps
    std::vector<ifs::MapId> m_maps;
};

} // namespace view
