// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "document/fractal/fractal.h"
#include "ifs/cage/map_handles.h"

#include <QString>

namespace document {
enum class CageMode;
}

namespace view {

// Why the canvas does not show the expected picture, as whole sentences; empty when it does. The note is that
// of the last picture.
QString noteOn(const document::Fractal& fractal, attractor::RenderNote note);

// The same of a system in space.
QString noteInSpace(const document::Fractal& fractal, attractor::RenderNote note, bool isCoarse);

// Said where a view shows none of the picture.
QString nothingHere();

// A note on the effect of moving the cage, where users may not expect it; else empty.
QString modeNote(document::CageMode mode);

// Why a drag of maps stops: the word that would lose the attractor, and its effect. `system` must have the
// same active maps as those of `way`.
template <int Dim>
QString stopNote(const ifs::IteratedFunctionSystem<Dim>& system, const ifs::SafeWay<Dim>& way);

} // namespace view
