// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace web {

// The lines of the list for tops: what every pixel of one fractal shows of another, by samples and exactly.
std::string topsHashes();

} // namespace web
