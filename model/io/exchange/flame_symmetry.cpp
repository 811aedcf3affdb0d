// SPDX-License-Identifier: MIT
#include "io/exchange/flame_symmetry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace io {

namespace {

constexpr double tolerance = 1e-5; // accepts six digits, as usual in flames
constexpr std::size_t maxElements = 2 * ifs::maxSymmetryOrder;

bool isNear(const ifs::AffineMap<2>& a, const ifs::AffineMap<2>& b) {
    const double size = 1 + std::max(a.translation.norm(), b.translation.norm());
    return (a.linear - b.linear).cwiseAbs().maxCoeff() <= tolerance &&
           (a.translation - b.translation).cwiseAbs().maxCoeff() <= tolerance * size;
}

bool contains(const std::vector<ifs::AffineMap<2>>& maps, const ifs::AffineMap<2>& map) {
    return std::ranges::any_of(maps, [&](const ifs::AffineMap<2>& each) { return isNear(each, map); });
}

// Multiples of 180°/n added to the angle lead to the mirror along y.
bool hasMirrorAlongY(const ifs::Symmetry<2>& symmetry) {
    const double steps = (90 - symmetry.angle) * symmetry.order / 180;
    return std::abs(steps - std::round(steps)) < 1e-9;
}

} // namespace

std::optional<int> flameKind(const ifs::Symmetry<2>& symmetry) {
    using enum ifs::SymmetryGroup;
    if (symmetry.centre != ifs::Vector<2>::Zero() || symmetry.frame != ifs::Matrix<2>::Identity())
        return std::nullopt;
    if (symmetry.group == Rotation) return symmetry.order;
    const bool hasMirrors = symmetry.group == Mirror || symmetry.group == Dihedral;
    return hasMirrors && hasMirrorAlongY(symmetry) ? std::optional(-symmetry.order) : std::nullopt;
}

std::optional<ifs::Symmetry<2>> symmetryOfKind(int kind) {
    using enum ifs::SymmetryGroup;
    if (kind == 0 || std::abs(std::int64_t(kind)) > ifs::maxSymmetryOrder) return std::nullopt;
    if (kind == 1) return ifs::Symmetry<2>{};
    if (kind > 0) return ifs::Symmetry<2>{Rotation, kind};
    const double step = 180.0 / -kind;
    const double angle = kind == -1 || std::fmod(90, step) != 0 ? std::fmod(90, step) : 0;
    return ifs::Symmetry<2>{kind == -1 ? Mirror : Dihedral, -kind, angle};
}

std::vector<ifs::AffineMap<2>> symmetryTransforms(const ifs::Symmetry<2>& symmetry) {
    if (symmetry.group == ifs::SymmetryGroup::None || flameKind(symmetry) ||
        symmetry.frame != ifs::Matrix<2>::Identity())
        return {};
    std::vector<ifs::AffineMap<2>> maps = ifs::elements(symmetry);
    maps.erase(maps.begin());
    return maps;
}

bool flameHoldsSymmetry(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    return system && system->symmetry.frame == ifs::Matrix<2>::Identity() &&
           (system->symmetry.group == ifs::SymmetryGroup::None || ifs::copiesOfEachMap(*system) > 1);
}

ifs::Symmetry<2> generatedSymmetry(const std::vector<ifs::AffineMap<2>>& maps) {
    std::vector<ifs::AffineMap<2>> group{{}};
    for (std::size_t i = 0; i < group.size(); ++i)
        for (const ifs::AffineMap<2>& map : maps)
            if (const ifs::AffineMap<2> product = group[i] * map; !contains(group, product)) {
                if (group.size() == maxElements) return {};
                group.push_back(product);
            }
    return ifs::symmetryOf(group, 10 * tolerance);
}

bool FlameSymmetryReader::readKind(int kind) {
    m_kind = symmetryOfKind(kind);
    return m_kind.has_value();
}

void FlameSymmetryReader::addTransform(std::size_t index, const ifs::AffineMap<2>& map) {
    const bool isIsometry =
        (map.linear.transpose() * map.linear - ifs::Matrix<2>::Identity()).cwiseAbs().maxCoeff() <=
        2 * tolerance;
    if (!isIsometry) return;
    m_indices.push_back(index);
    m_maps.push_back(map);
}

FlameSymmetryReader::Outcome FlameSymmetryReader::outcome() const {
    if (m_kind && m_kind->group != ifs::SymmetryGroup::None) {
        Outcome result{*m_kind, {}};
        const std::vector<ifs::AffineMap<2>> group = ifs::elements(*m_kind);
        for (std::size_t i = 0; i < m_maps.size(); ++i) // newer programs write both
            if (contains(group, m_maps[i])) result.transforms.push_back(m_indices[i]);
        return result;
    }
    if (m_maps.empty()) return {};
    Outcome result{generatedSymmetry(m_maps), m_indices};
    if (result.symmetry.group == ifs::SymmetryGroup::None) result.transforms.clear();
    return result;
}

} // namespace io
