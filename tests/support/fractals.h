// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/iterated_function_system.h"

#include <QString>

#include <utility>
#include <vector>

namespace support {

template <int Dim>
document::Fractal fractalOf(ifs::IteratedFunctionSystem<Dim> system, const QString& name = {}) {
    document::Fractal fractal;
    if (!name.isNull()) fractal.name = name;
    fractal.shape = document::Shape<Dim>{std::move(system)};
    return fractal;
}

// Of maps with equal weights.
template <int Dim>
document::Fractal fractalOf(const std::vector<ifs::AffineMap<Dim>>& maps, const QString& name = {}) {
    ifs::IteratedFunctionSystem<Dim> system;
    for (const auto& map : maps)
        ifs::append<Dim>(system, map);
    return fractalOf(std::move(system), name);
}

} // namespace support
