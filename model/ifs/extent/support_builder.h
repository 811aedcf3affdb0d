// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/support_container.h"

#include <memory>
#include <span>

namespace ifs {

// A container of the attractor of maps that contract in `norm`; in the plane, where the maps are many, over
// those alone that can lead to extreme points. nullptr when its numbers are not finite.
template <int Dim>
std::shared_ptr<const SupportContainer<Dim>> supportContainer(std::span<const AffineMap<Dim>> maps,
                                                              const ContractingNorm<Dim>& norm);

// The same inside a known one, about the same centre and over many more directions: for maps so slow that the
// states of a search, which a coarse container does not tell apart, run out of bounds. Takes some tenths of a
// second. nullptr when the maps are too many for that.
template <int Dim>
std::shared_ptr<const SupportContainer<Dim>> finerContainer(std::span<const AffineMap<Dim>> maps,
                                                            const ContractingNorm<Dim>& norm,
                                                            const SupportContainer<Dim>& known);

} // namespace ifs
