// SPDX-License-Identifier: MIT
#include "io/table/table_systems.h"

#include <cstdint>

namespace io {

namespace {

template <int Dim> ifs::IteratedFunctionSystem<Dim> numbered(const std::vector<ifs::WeightedMap<Dim>>& rows) {
    ifs::IteratedFunctionSystem<Dim> system{rows};
    std::uint32_t number = 0;
    for (auto& map : system.maps)
        map.id = static_cast<ifs::MapId>(++number);
    return system;
}

} // namespace

ifs::IteratedFunctionSystem<2> systemOf(const Table& table) {
    return numbered(table.rows);
}

ifs::IteratedFunctionSystem<3> spaceSystemOf(const Table& table) {
    return numbered(table.spaceRows);
}

} // namespace io
