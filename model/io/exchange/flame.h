// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>
#include <QList>

#include <memory>

// Flame XML (.flame, .flam3), as flam3, Apophysis, JWildfire and Fractorium write it. docs/formats.md, "Flame
// XML".
namespace io {

// Flames grow y downwards. Flipped gives the code that looks the same way up here (A → JAJ, b → Jb, J =
// diag(1,−1)).
enum class FlameAxis { Flipped, AsWritten };

// Reads an entry from every flame that is affine; each of the others gives an error that says why it is
// refused.
document::FractalFile readFlame(const QByteArray& bytes, FlameAxis axis = FlameAxis::Flipped);

bool looksLikeFlame(const QByteArray& bytes);

// The plane systems among the fractals, each as one flame. Weights are the ones given, or the probabilities
// where one is missing; a map that is off has weight 0, which flames never use.
QByteArray writeFlame(const QList<std::shared_ptr<const document::Fractal>>& fractals,
                      FlameAxis axis = FlameAxis::Flipped);

} // namespace io
