// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/attractor_existence.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace view {

// Whether the maps that take part have an attractor, and why, in one sentence. rows[k] is the row of their
// k-th map in the system, from 0; in sentences rows are counted from 1.
QString existenceSentence(const ifs::Existence& existence, const std::vector<std::size_t>& rows);

// A word over those maps as the rows that it names: “3 1”.
QString rowsOf(const std::vector<int>& word, const std::vector<std::size_t>& rows);

} // namespace view
