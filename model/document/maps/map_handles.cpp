// SPDX-License-Identifier: MIT
#include "document/maps/map_handles.h"
#include "document/branches/shown_branch.h"
#include "document/fractal/fractal_geometry.h"

#include "ifs/cage/map_handles.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/map_interpolation.h"

#include <algorithm>
#include <utility>

namespace document {

using ifs::AffineMap;
using ifs::Vector;

MapHandles::MapHandles(std::shared_ptr<const Fractal> fractal, const ifs::ControlCage<2>& cage,
                       const AffineMap<2>& within)
    : m_fractal(std::move(fractal)), m_cage(cage), m_placement(placement(*m_fractal)), m_within(within) {}

MapHandles MapHandles::ofBranch(const std::shared_ptr<const Fractal>& fractal,
                                const ifs::ControlCage<2>& cage, const ifs::Word& branch, bool recurs) {
    MapHandles handles(fractal, cage);
    ShownBranch<2> shown = shownBranch(*plane(*fractal), branch, recurs);
    handles.m_within = shown.within;
    handles.m_branchMap = {{system2(*fractal)->maps[std::size_t(branch.back())].id, shown.map, {}}};
    handles.m_branch = std::move(shown.word);
    return handles;
}

std::vector<Vector<2>> MapHandles::corners(std::size_t index) const {
    std::vector<Vector<2>> result;
    for (const Vector<2>& vertex : m_cage.rest)
        result.push_back(m_placement(m_within(maps()[index].map(vertex))));
    return result;
}

std::vector<Vector<2>> MapHandles::outline(std::size_t index) const {
    if (!bends()) return corners(index);
    constexpr int parts = 12; // parts of an edge
    std::vector<Vector<2>> result;
    for (std::size_t i = 0; i < m_cage.rest.size(); ++i) {
        const Vector<2>& from = m_cage.rest[i];
        const Vector<2> edge = m_cage.rest[(i + 1) % m_cage.rest.size()] - from;
        for (int k = 0; k < parts; ++k)
            result.push_back(m_placement(m_within(maps()[index].map(from + edge * (double(k) / parts)))));
    }
    return result;
}

std::vector<Box> MapHandles::boxes() const {
    Vector<2> low = m_cage.rest.front(), high = low;
    for (const Vector<2>& vertex : m_cage.rest) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const Vector<2> centre = (low + high) / 2, half = (high - low) / 2;
    const AffineMap<2> seen = m_placement.affine() * m_within;
    std::vector<Box> result;
    result.reserve(count());
    for (const ifs::WeightedMap<2>& map : maps()) {
        const Vector<2> at = map.map(centre);
        const Vector<2> middle = bends() ? m_placement(m_within(at)) : seen(at);
        const Vector<2> reach = (seen.linear * map.map.linear).cwiseAbs() * half;
        result.push_back({middle - reach, middle + reach});
    }
    return result;
}

bool MapHandles::canBeMoved() const {
    return (bends() || ifs::isInvertible(m_cage)) && ifs::inverse(m_within) &&
           (m_branch.empty() || ifs::inverse(m_branchMap.front().map));
}

AffineMap<2> MapHandles::around(std::size_t index) const {
    Vector<2> middle = Vector<2>::Zero();
    for (const Vector<2>& vertex : m_cage.rest)
        middle += m_within(maps()[index].map(vertex)) / double(m_cage.rest.size());
    return ifs::firstOrder(m_placement, middle) * m_within;
}

Fractal MapHandles::changed() const {
    Fractal fractal = *m_fractal;
    if (m_branch.empty()) plane(fractal)->cage = m_cage;
    return fractal;
}

void MapHandles::change(Fractal& fractal, std::size_t index, const AffineMap<2>& change) const {
    if (m_branch.empty()) {
        AffineMap<2>& map = system2(fractal)->maps[index].map;
        map = change * map;
        return;
    }
    moveShown(*plane(fractal), m_branch, change);
}

void MapHandles::changeDisplayed(Fractal& fractal, std::size_t index, const AffineMap<2>& displayed) const {
    const auto back = ifs::inverse(around(index));
    if (const auto inCode = back ? ifs::conjugate(*back, displayed) : std::nullopt)
        change(fractal, index, *inCode);
}

Fractal MapHandles::withCornerMoved(std::size_t index, std::size_t corner, const Vector<2>& offset) const {
    const auto inCode = ifs::inverse(around(index));
    const auto outOf = ifs::inverse(m_within);
    if (offset.isZero(0) || !inCode || !outOf) return *m_fractal;
    const Vector<2> held = maps()[index].map(m_cage.rest[corner]);
    const Vector<2> seen = m_within(held);
    const auto target = ifs::preimage(m_placement, m_placement(seen) + offset, seen);
    Fractal fractal = changed();
    Vector<2> moved = inCode->linear * offset;
    if (target) moved = outOf->linear * (*target - seen);
    const AffineMap<2>& map = maps()[index].map;
    if (m_branch.empty()) {
        system2(fractal)->maps[index].map = ifs::withHandleMoved(map, m_cage.rest, corner, moved);
        return fractal;
    }
    std::vector<Vector<2>> polygon;
    for (const Vector<2>& vertex : m_cage.rest)
        polygon.push_back(map(vertex));
    change(fractal, index, ifs::withHandleMoved({}, polygon, corner, moved));
    return fractal;
}

Fractal MapHandles::withMapsMoved(std::span<const std::size_t> indices, const Vector<2>& offset) const {
    return withMapsMoved(indices, std::vector<Vector<2>>(indices.size(), offset));
}

Fractal MapHandles::withMapsMoved(std::span<const std::size_t> indices,
                                  std::span<const Vector<2>> offsets) const {
    const auto isZero = [](const Vector<2>& offset) { return offset.isZero(0); };
    if (std::ranges::all_of(offsets, isZero)) return *m_fractal;
    Fractal fractal = changed();
    for (std::size_t k = 0; k < indices.size(); ++k)
        if (const auto inCode = ifs::inverse(around(indices[k])); inCode && !isZero(offsets[k]))
            change(fractal, indices[k], {ifs::Matrix<2>::Identity(), inCode->linear * offsets[k]});
    return fractal;
}

Fractal MapHandles::withMapsChanged(std::span<const std::size_t> indices, const AffineMap<2>& change) const {
    if (change == AffineMap<2>{}) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t index : indices)
        changeDisplayed(fractal, index, change);
    return fractal;
}

Fractal MapHandles::withMapsSwung(std::span<const std::size_t> indices, const Vector<2>& root,
                                  double angle) const {
    if (angle == 0) return *m_fractal;
    Fractal fractal = changed();
    for (const std::size_t index : indices)
        changeDisplayed(fractal, index,
                        ifs::swung({}, m_placement(m_within(maps()[index].map(root))), angle));
    return fractal;
}

bool isMoved(const Fractal& fractal, const ifs::Word& branch) {
    if (const Shape<3>* shape = space(fractal)) return isMoved(*shape, branch);
    const Shape<2>* shape = plane(fractal);
    return shape && isMoved(*shape, branch);
}

AffineMap<2> recurringMap(const Fractal& fractal, const ifs::Word& branch) {
    return recurringMap(*plane(fractal), branch);
}

Fractal withBranchPutBack(Fractal fractal, const ifs::Word& branch) {
    if (Shape<3>* shape = space(fractal)) putBack(*shape, branch);
    if (Shape<2>* shape = plane(fractal)) putBack(*shape, branch);
    return fractal;
}

std::optional<Vector<2>> root(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return std::nullopt;
    if (const auto linked = linkedExtent(fractal)) {
        const AffineMap<2> seen = ifs::firstOrder(placement(fractal), linked->centre());
        return (*linked)(seen.linear.transpose() * Vector<2>(0, -1), 1e-9 * linked->radius()).point;
    }
    const auto attractor = supportFunction(fractal);
    if (!attractor) return std::nullopt;
    const AffineMap<2> seen = ifs::firstOrder(placement(fractal), attractor->centre());
    const Vector<2> down = seen.linear.transpose() * Vector<2>(0, -1);
    return (*attractor)(down, 1e-9 * attractor->radius() * down.norm()).point;
}

} // namespace document
