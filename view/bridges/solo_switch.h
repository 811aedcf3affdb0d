// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <QObject>

namespace view {

// A child of each bridge: the map whose part of the attractor is drawn alone, where that is possible. None:
// all is drawn.
class SoloSwitch : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    static ifs::MapId of(const QObject& bridge);
    void set(ifs::MapId map);

signals:
    void changed();

private:
    ifs::MapId m_map = ifs::MapId::None;
};

} // namespace view
