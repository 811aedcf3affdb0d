// SPDX-License-Identifier: MIT
#include "bridges/solo_switch.h"

#include <utility>

namespace view {

ifs::MapId SoloSwitch::of(const QObject& bridge) {
    const auto* solo = bridge.findChild<SoloSwitch*>({}, Qt::FindDirectChildrenOnly);
    return solo != nullptr ? solo->m_map : ifs::MapId::None;
}

void SoloSwitch::set(ifs::MapId map) {
    if (std::exchange(m_map, map) != map) emit changed();
}

} // namespace view
