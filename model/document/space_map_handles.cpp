// SPDX-License-Identifier: MIT
#include "document/space_map_handles.h"
#include "document/branch_as_map.h"
#include "document/space_geometry.h"

#include "ifs/cage/map_handles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace document {

std::optional<SpaceMapHandles> SpaceMapHandles::of(std::shared_ptr<const Fractal> fractal,
                                                   const ifs::ControlCage<3>& cage,
                                                   const ifs::AffineMap<3>& within) {
    const System3* system = system3(*fractal);
    if (!system) return std::nullopt;
    SpaceMapHandles handles;
    const auto rest = cage.rest.size() == handles.m_rest.size()
                          ? cage.rest
                          : fractal->supports.simplexInSpace(*system).rest;
    std::ranges::copy(rest, handles.m_rest.begin());
    handles.m_cage = cage;
    handles.m_placed = ifs::displayMap(cage) * within;
    if (ifs::isInvertible(cage)) handles.m_back = ifs::inverse(handles.m_placed);
    handles.m_fractal = std::move(fractal);
    return handles;
}

SpaceMapHandles::Corners SpaceMapHandles::corners(std::size_t index) const {
    Corners result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = m_placed(system3(*m_fractal)->maps[index].map(m_rest[i]));
    return result;
}

std::optional<SpaceMapHandles::Corners> SpaceMapHandles::corners(const ifs::Word& branch) const {
    const auto& maps = system3(*m_fractal)->maps;
    ifs::AffineMap<3> map;
    for (const int index : branch) {
        if (std::size_t(index) >= maps.size()) return std::nullopt;
        map = map * maps[std::size_t(index)].map;
    }
    Corners result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = m_placed(map(m_rest[i]));
    return result;
}

Fractal SpaceMapHandles::withCornersMoved(std::size_t index, const Corners& offsets) const {
    const bool stays = std::ranges::all_of(offsets, [](const ifs::Vector<3>& by) { return by.isZero(0); });
    Fractal fractal = *m_fractal;
    if (stays || !m_back) return fractal;
    space(fractal)->cage = m_cage;
    ifs::AffineMap<3>& map = system3(fractal)->maps[index].map;
    for (std::size_t i = 0; i < offsets.size(); ++i)
        map = ifs::withHandleMoved(map, m_rest, i, m_back->linear * offsets[i]);
    return fractal;
}

Fractal SpaceMapHandles::withMapSwung(std::size_t index, const ifs::Vector<3>& root,
                                      const ifs::Vector<3>& axis, double angle) const {
    Fractal fractal = *m_fractal;
    if (angle == 0 || !m_back) return fractal;
    space(fractal)->cage = m_cage;
    ifs::AffineMap<3>& map = system3(fractal)->maps[index].map;
    const ifs::Vector<3> pivot = m_placed(map(root));
    const ifs::Matrix<3> turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    map = *m_back * (ifs::AffineMap<3>{turn, pivot - turn * pivot} * (m_placed * map));
    return fractal;
}

std::optional<ifs::Vector<3>> rootInSpace(const Fractal& fractal, const ifs::Vector<3>& up) {
    const auto cage = isSpaceExtentKnown(fractal) ? knownSpaceCage(fractal) : std::nullopt;
    const auto attractor = cage ? spaceSupport(fractal) : nullptr;
    if (!attractor) return std::nullopt;
    const ifs::Vector<3> down = -(ifs::displayMap(*cage).linear.transpose() * up);
    return (*attractor)(down, 1e-9 * attractor->radius() * down.norm()).point;
}

std::optional<SpaceBranchHandles> branchHandlesInSpace(const std::shared_ptr<const Fractal>& fractal,
                                                       const ifs::ControlCage<3>& cage,
                                                       const ifs::Word& branch, BranchEdit edit) {
    const System3* system = system3(*fractal);
    if (!system || branch.empty() || keepsCode(edit)) return std::nullopt;
    const ifs::ActiveMaps<3> active = ifs::activeMaps(*system);
    auto letters = ifs::overMaps(branch, active.index);
    const bool divides = edit == BranchEdit::OwnMap && branch.size() > 1;
    if (!letters || (divides && active.isLinked())) return std::nullopt;
    std::size_t index = 0;
    std::shared_ptr<const Fractal> code = fractal;
    ifs::AffineMap<3> within;
    if (divides) {
        code = std::make_shared<const Fractal>(withBranchAsMap<3>(*fractal, *letters));
    } else {
        letters->pop_back();
        within = ifs::composed<3>(active.maps, *letters);
        index = std::size_t(branch.back());
    }
    auto handles = SpaceMapHandles::of(std::move(code), cage, within);
    if (!handles) return std::nullopt;
    return SpaceBranchHandles{*std::move(handles), index};
}

} // namespace document
