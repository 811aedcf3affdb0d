// SPDX-License-Identifier: MIT
#include "document/lesson/lesson_cage.h"

#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"

#include <utility>
#include <variant>
#include <vector>

namespace document {

std::optional<Fractal> withLessonCage(const Fractal& fractal, const LessonCage& cage) {
    const auto moved = [&](auto present, const auto& corners) -> std::optional<Fractal> {
        if (!present || present->current.size() != corners.size()) return std::nullopt;
        if (present->current == corners) return fractal;
        present->current = corners;
        return withCageMoved(fractal, *std::move(present), CageMode::Place);
    };
    if (std::holds_alternative<LessonAtRest>(cage))
        return isAtRest(fractal) ? fractal : withCageAtRest(fractal);
    if (const auto* plane = std::get_if<std::vector<ifs::Vector<2>>>(&cage))
        return moved(document::plane(fractal) ? std::optional(effectiveCage(fractal)) : std::nullopt, *plane);
    if (const auto* space = std::get_if<std::vector<ifs::Vector<3>>>(&cage))
        return moved(document::space(fractal) ? spaceCage(fractal) : std::nullopt, *space);
    return fractal;
}

} // namespace document
