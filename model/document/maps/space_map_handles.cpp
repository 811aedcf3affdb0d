// SPDX-License-Identifier: MIT
#include "document/maps/space_map_handles.h"
#include "document/branches/shown_branch.h"
#include "document/fractal/space_geometry.h"

#include "ifs/cage/cage_preimage.h"
#include "ifs/cage/map_handles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace document {

namespace {

// The largest one between corners of a cage, of a few of them where there are many. What it is mapped to
// stays in the cage as the attractor does, where bends are tame.
std::optional<ifs::Simplex<3>> largestTetrahedron(const std::vector<ifs::Vector<3>>& corners) {
    constexpr std::size_t few = 24;
    const std::size_t step = corners.size() / (few + 1) + 1;
    std::optional<ifs::Simplex<3>> result;
    double largest = 0; // six times the volume
    for (std::size_t a = 0; a < corners.size(); a += step)
        for (std::size_t b = a + step; b < corners.size(); b += step)
            for (std::size_t c = b + step; c < corners.size(); c += step)
                for (std::size_t d = c + step; d < corners.size(); d += step) {
                    const ifs::Vector<3>& from = corners[a];
                    const double volume = (corners[b] - from).cross(corners[c] - from).dot(corners[d] - from);
                    if (!(std::abs(volume) > (1 + 1e-9) * largest)) continue; // the first among equals
                    largest = std::abs(volume);
                    result = {from, corners[b], volume > 0 ? corners[c] : corners[d],
                              volume > 0 ? corners[d] : corners[c]};
                }
    return result;
}

} // namespace

SpaceMapHandles::SpaceMapHandles(std::shared_ptr<const Fractal> fractal, const ifs::ControlCage<3>& cage,
                                 const ifs::AffineMap<3>& within)
    : m_fractal(std::move(fractal)),
      m_cage(cage),
      m_placed(ifs::displayMap(cage) * within),
      m_within(within) {
    if (cage.rest.size() == m_rest.size())
        std::ranges::copy(cage.rest, m_rest.begin());
    else if (const auto inCage = largestTetrahedron(cage.rest))
        m_rest = *inCage;
    else
        std::ranges::copy(m_fractal->supports.simplexInSpace(*system3(*m_fractal)).rest, m_rest.begin());
    if (ifs::isValid(cage) && ifs::bends(cage)) {
        m_bend = std::make_shared<const ifs::CageDeformation>(cage.rest, cage.current);
        m_back = ifs::inverse(within);
    } else if (ifs::isInvertible(cage)) {
        m_back = ifs::inverse(m_placed);
    }
}

SpaceMapHandles SpaceMapHandles::ofBranch(const std::shared_ptr<const Fractal>& fractal,
                                          const ifs::ControlCage<3>& cage, const ifs::Word& branch,
                                          bool recurs) {
    ShownBranch<3> shown = shownBranch(*space(*fractal), branch, recurs);
    SpaceMapHandles handles(fractal, cage, shown.within);
    handles.m_branch = std::move(shown.word);
    handles.m_branchMap = shown.map;
    return handles;
}

ifs::AffineMap<3> SpaceMapHandles::mapAt(std::size_t index) const {
    return m_branch.empty() ? system3(*m_fractal)->maps[index].map : m_branchMap;
}

ifs::Vector<3> SpaceMapHandles::shown(const ifs::Vector<3>& x) const {
    return m_bend ? (*m_bend)(m_within(x)) : m_placed(x);
}

ifs::Vector<3> SpaceMapHandles::inPiece(const ifs::Vector<3>& x, const ifs::Vector<3>& offset) const {
    if (!m_bend) return m_back->linear * offset;
    const ifs::Vector<3> from = m_within(x);
    const auto to = ifs::preimage(*m_bend, (*m_bend)(from) + offset, from);
    return to ? ifs::Vector<3>(m_back->linear * (*to - from)) : ifs::Vector<3>::Zero();
}

bool SpaceMapHandles::canBeMoved() const {
    return m_back && (m_branch.empty() || ifs::inverse(m_branchMap));
}

SpaceMapHandles::Corners SpaceMapHandles::corners(std::size_t index) const {
    Corners result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = shown(mapAt(index)(m_rest[i]));
    return result;
}

std::optional<SpaceMapHandles::Corners> SpaceMapHandles::corners(const ifs::Word& branch) const {
    const auto& maps = system3(*m_fractal)->maps;
    const auto isMap = [&](int index) { return std::size_t(index) < maps.size(); };
    if (!std::ranges::all_of(branch, isMap)) return std::nullopt;
    ifs::AffineMap<3> map = movedBy(*space(*m_fractal), branch);
    for (const int index : branch)
        map = map * maps[std::size_t(index)].map;
    Corners result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = shown(map(m_rest[i]));
    return result;
}

Fractal SpaceMapHandles::withCornersMoved(std::size_t index, const Corners& offsets) const {
    return withCornersMoved(std::span(&index, 1), std::span(&offsets, 1));
}

Fractal SpaceMapHandles::withCornersMoved(std::span<const std::size_t> indices,
                                          std::span<const Corners> offsets) const {
    Fractal fractal = *m_fractal;
    for (std::size_t k = 0; k < indices.size() && canBeMoved(); ++k)
        if (!std::ranges::all_of(offsets[k], [](const ifs::Vector<3>& by) { return by.isZero(0); }))
            moveCorners(fractal, indices[k], offsets[k]);
    return fractal;
}

void SpaceMapHandles::moveCorners(Fractal& fractal, std::size_t index, const Corners& offsets) const {
    const ifs::AffineMap<3> before = mapAt(index);
    Corners by;
    for (std::size_t i = 0; i < by.size(); ++i)
        by[i] = inPiece(before(m_rest[i]), offsets[i]);
    if (!m_branch.empty()) {
        ifs::Simplex<3> corners;
        for (std::size_t i = 0; i < by.size(); ++i)
            corners[i] = before(m_rest[i]);
        ifs::AffineMap<3> change;
        for (std::size_t i = 0; i < by.size(); ++i)
            change = ifs::withHandleMoved(change, corners, i, by[i]);
        return moveShown(*space(fractal), m_branch, change);
    }
    space(fractal)->cage = m_cage;
    ifs::AffineMap<3>& map = system3(fractal)->maps[index].map;
    for (std::size_t i = 0; i < by.size(); ++i)
        map = ifs::withHandleMoved(map, m_rest, i, by[i]);
}

std::optional<ifs::AffineMap<3>> SpaceMapHandles::swung(const ifs::AffineMap<3>& map,
                                                        const ifs::Vector<3>& root,
                                                        const ifs::Matrix<3>& turn) const {
    ifs::AffineMap<3> placed = m_placed;
    std::optional<ifs::AffineMap<3>> back = m_back;
    if (m_bend) {
        const ifs::Vector<3> middle = m_within(map((m_rest[0] + m_rest[1] + m_rest[2] + m_rest[3]) / 4));
        const ifs::Matrix<3> linear = ifs::derivative(*m_bend, middle);
        placed = ifs::AffineMap<3>{linear, (*m_bend)(middle)-linear * middle} * m_within;
        back = ifs::inverse(placed);
    }
    if (!back) return std::nullopt;
    const ifs::Vector<3> pivot = placed(map(root));
    return *back * (ifs::AffineMap<3>{turn, pivot - turn * pivot} * (placed * map));
}

Fractal SpaceMapHandles::withMapsSwung(std::span<const std::size_t> indices, const ifs::Vector<3>& root,
                                       const ifs::Vector<3>& axis, double angle) const {
    if (angle == 0 || !canBeMoved()) return *m_fractal;
    const ifs::Matrix<3> turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    Fractal fractal = *m_fractal;
    for (const std::size_t index : indices) {
        ifs::AffineMap<3>& map = system3(fractal)->maps[index].map;
        const auto moved = swung(map, root, turn);
        if (!moved) continue;
        map = *moved;
        space(fractal)->cage = m_cage;
    }
    return fractal;
}

std::optional<ifs::Vector<3>> rootInSpace(const Fractal& fractal, const ifs::Vector<3>& up) {
    const auto cage = isSpaceExtentKnown(fractal) ? knownSpaceCage(fractal) : std::nullopt;
    const auto attractor = cage ? spaceSupport(fractal) : nullptr;
    if (!attractor) return std::nullopt;
    const ifs::Vector<3> down = -(ifs::displayMap(*cage).linear.transpose() * up);
    return (*attractor)(down, 1e-9 * attractor->radius() * down.norm()).point;
}

} // namespace document
