// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/facts.h"

#include <QString>

#include <cstddef>
#include <vector>

// Verdicts on a system in words: one wording for `barycage-cli info`, the *Analysis* panel and the status
// bar. Maps are counted from 1; rows[k] is the row of the k-th active map in the system, from 0.
namespace io {

// "3 1": the word as the rows of its maps.
QString wordText(const ifs::Word& word, const std::vector<std::size_t>& rows);

// "hyperbolic, s = 0.85"; "none: …" with the word that contracts in no norm.
QString verdictText(const ifs::Existence& existence, const std::vector<std::size_t>& rows);

QString separationText(ifs::Separation separation);
QString connectednessText(ifs::Connectedness connectedness);
QString openSetText(const ifs::OpenSetFacts& facts);

// A remark in brackets after a blank, or nothing: whether Moran's number, and the entropy divided by the
// Lyapunov exponent, are a dimension or only an upper bound.
template <int Dim> QString openSetNote(const ifs::Facts<Dim>& facts);

// " (within rounding error)", or nothing of an exact proof.
QString roundingNote(bool isExact);

} // namespace io
