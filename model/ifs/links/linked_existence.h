// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/attractor_existence.h"
#include "ifs/system/iterated_function_system.h"

namespace ifs {

// The same for linked maps: only admissible words count. EventuallyContractive: every admissible word has a
// beginning of at most `wordLength` maps whose norm is at most `contractivity` to the power of its length; of
// a circle of `wordLength` maps, that of the word of all of them in an ellipsoidal norm. From any point c,
// the attractor lies within normEquivalence·max |w_i(c) − c|/(1 − contractivity) of it. None: the witness is
// a word that may follow itself. Of maps that contract without their links, the certificate is that of
// classify(). docs/mathematics.md, "Linked maps".
template <int Dim> Existence classifyLinked(const ActiveMaps<Dim>& active, int maxProducts = 20'000);

} // namespace ifs
