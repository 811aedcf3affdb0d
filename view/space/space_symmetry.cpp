// SPDX-License-Identifier: MIT
#include "space/space_symmetry.h"

#include "document/edits/maps/symmetry_edits.h"
#include "ifs/cage/control_cage.h"
#include "space/seen_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace view {

namespace {

constexpr double reach = 110; // pixels in the plane of the target; half of a line
const QPointF aside(30, -30); // offset of the handle from the centre

// nullopt: there is no symmetry, or the cage bends.
std::optional<ifs::AffineMap<3>> placementOf(const document::Fractal& fractal) {
    const document::Shape<3>* shape = document::space(fractal);
    if (shape == nullptr || shape->system.symmetry.group == ifs::SymmetryGroup::None) return std::nullopt;
    if (!shape->cage) return ifs::AffineMap<3>();
    if (ifs::bends(*shape->cage)) return std::nullopt;
    return ifs::displayMap(*shape->cage);
}

// Axes in the standard position of the group.
std::vector<ifs::Vector<3>> linesOf(const ifs::Symmetry<3>& symmetry) {
    std::vector<ifs::Vector<3>> lines{ifs::Vector<3>::UnitZ()};
    switch (symmetry.group) {
    case ifs::SymmetryGroup::None:
    case ifs::SymmetryGroup::Rotation:
        break;
    case ifs::SymmetryGroup::Mirror:
    case ifs::SymmetryGroup::Dihedral:
        for (int k = 0; k < symmetry.order; ++k) {
            const double angle = std::numbers::pi * k / symmetry.order;
            lines.emplace_back(std::cos(angle), std::sin(angle), 0);
        }
        break;
    case ifs::SymmetryGroup::Tetrahedral:
    case ifs::SymmetryGroup::Octahedral:
    case ifs::SymmetryGroup::Icosahedral:
        lines.push_back(ifs::Vector<3>::UnitX());
        lines.push_back(ifs::Vector<3>::UnitY());
        break;
    }
    const double turn = symmetry.angle * std::numbers::pi / 180;
    const double c = std::cos(turn), s = std::sin(turn);
    for (ifs::Vector<3>& line : lines)
        line = symmetry.frame *
               ifs::Vector<3>(c * line.x() - s * line.y(), s * line.x() + c * line.y(), line.z());
    return lines;
}

} // namespace

std::optional<ifs::Vector<3>> displayedCentre(const document::Fractal& fractal) {
    const auto placement = placementOf(fractal);
    return placement ? std::optional((*placement)(document::space(fractal)->system.symmetry.centre))
                     : std::nullopt;
}

std::optional<SymmetryMarks> symmetryLayout(const document::Fractal& fractal,
                                            const attractor::OrbitCamera& camera) {
    const auto placement = placementOf(fractal);
    if (!placement) return std::nullopt;
    const ifs::Symmetry<3>& symmetry = document::space(fractal)->system.symmetry;
    const ifs::Vector<3> centre = (*placement)(symmetry.centre);
    SymmetryMarks marks;
    marks.centre = seenPoint(camera, centre);
    marks.knob = marks.centre + aside;
    for (const ifs::Vector<3>& line : linesOf(symmetry)) {
        const ifs::Vector<3> along = placement->linear * line;
        if (!(along.norm() > 0)) continue; // flat cage
        const ifs::Vector<3> half = along.normalized() * (reach / pixelsPerUnit(camera));
        if (const auto seen = seenLine(camera, centre - half, centre + half)) marks.mirrors.push_back(*seen);
    }
    return marks;
}

std::function<document::Fractal(const std::vector<ifs::Vector<3>>&)>
afterCentreMoved(const std::shared_ptr<const document::Fractal>& before) {
    const auto placement = placementOf(*before);
    const auto inCode = placement ? ifs::inverse(*placement) : std::nullopt;
    if (!inCode) return nullptr;
    return [before, inCode = *inCode](const std::vector<ifs::Vector<3>>& points) {
        ifs::Symmetry<3> symmetry = document::space(*before)->system.symmetry;
        symmetry.centre = inCode(points.front());
        return document::withSymmetry(*before, symmetry);
    };
}

} // namespace view
