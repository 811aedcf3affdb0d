// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/facts.h"
#include "ifs/system/branch.h"
#include "io/report/json_writer.h"

#include <cstddef>
#include <vector>

namespace io {

void writeNull(JsonWriter& json, const char* key);

// Maps counted from 1, in the order of the file.
void writeWord(JsonWriter& json, const char* key, const ifs::Word& word,
               const std::vector<std::size_t>& indices);

// How the pieces of an attractor meet, and what invertible affine maps of it do not change, as members of the
// object that is open.
template <int Dim> void writeInvariants(JsonWriter& json, const ifs::Facts<Dim>& facts);

} // namespace io
