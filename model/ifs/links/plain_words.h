// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ifs {

// Linked maps as plain ones. Where map k may follow every map, A_k = w_k(A); any other part is
// A_j = ∪ w_j(A_i) over the maps i that j may follow. If every chain of such i comes to a map that may follow
// all, A is the attractor of the words of these chains. docs/mathematics.md, "Linked maps".
struct PlainWords {
    std::vector<std::vector<std::size_t>> words; // positions in the active maps, outermost first
    std::vector<double> weights; // frequency with which the chaos game ends with the word; sum 1
    bool keepsMeasure = false;   // true if these weights give the same measure, not only the same attractor
};

// nullopt where a chain has no such end, or where there would be more than `most` words.
std::optional<PlainWords> plainWords(const ActiveMaps<2>& active, std::size_t most);

// Returns true if such words exist, however many.
bool hasPlainWords(const ActiveMaps<2>& active);

} // namespace ifs
