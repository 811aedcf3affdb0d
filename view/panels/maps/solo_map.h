// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QObject>

namespace view {

// The map that is shown alone, if any: how the picture is looked at, no part of the document. It ends when
// the map goes, when another entry is shown, and when maps can no longer be shown alone.
class SoloMap : public QObject {
    Q_OBJECT

public:
    SoloMap(document::Document* document, QObject* parent);

    ifs::MapId map() const { return m_map; } // None: all maps are shown
    void toggle(ifs::MapId map);             // shows the map alone or, if it is alone already, all maps

signals:
    void changed();
    void message(const QString& sentence);

private:
    void follow(const document::Change& change);
    void set(ifs::MapId map);

    document::Document* m_document;
    ifs::MapId m_map = ifs::MapId::None;
};

} // namespace view
