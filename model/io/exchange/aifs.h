// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/aifs.h"

#include <QByteArray>
#include <QList>

#include <array>
#include <memory>
#include <vector>

// The affine invariant form of a system, and IFStile's text format (.aifs), which is written but not read.
namespace io {

// Row j of S holds the barycentric coordinates of w(V_j): r ↦ r·S is w in the coordinates of the simplex, so
// the rows sum to 1 and the matrices are the same wherever the simplex is dragged. docs/mathematics.md,
// "Affine invariant form".
using RowStochastic = ifs::RowStochastic<2>;
struct AffineInvariantForm {
    ifs::Simplex<2> simplex; // vertices of an affine basis
    std::vector<RowStochastic> maps;
};
AffineInvariantForm affineInvariantForm(const document::System2& system, const ifs::Simplex<2>& simplex);

// Writes a block for every system with an active map: what IFStile reads, and in comments the weights and,
// for a plane system, the control triangle at rest and the row-stochastic matrices.
QByteArray writeAifs(const QList<std::shared_ptr<const document::Fractal>>& fractals);

} // namespace io
