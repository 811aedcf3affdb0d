// SPDX-License-Identifier: MIT
#pragma once

#include "document/animated_fractal.h"

#include <stop_token>

// What animated_fractal.h finds out with many trials, to be stopped between two of them.
namespace document {

// Whether no attractor is certain at one of 33 moments; nullopt when stopped before that is known.
std::optional<bool> losesAttractor(const Fractal& fractal, const std::stop_token& stop);

// withSafeStrength(); nullopt when stopped.
std::optional<Fractal> withSafeStrength(const Fractal& fractal, std::size_t motion,
                                        const std::stop_token& stop);

} // namespace document
