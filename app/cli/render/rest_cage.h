// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/cage/cage_fits.h"

#include <optional>
#include <string>

namespace cli {

template <int Dim> struct AskedFit {
    document::CageFit<Dim> fit;
    int corners;
};

// The fit named by --rest-cage ID, or ID:N with N corners; nullopt for other texts. Throws UsageError where
// no such number of corners is possible.
template <int Dim> std::optional<AskedFit<Dim>> askedFit(const std::string& text);

} // namespace cli
