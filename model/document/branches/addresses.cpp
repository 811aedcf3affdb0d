// SPDX-License-Identifier: MIT
#include "document/branches/addresses.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"

#include "ifs/cage/cage_preimage.h"
#include "ifs/cage/map_handles.h"
#include "ifs/extent/address_search.h"

#include <QStringList>

#include <algorithm>

namespace document {

Addresses::Addresses(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return;
    m_active = ifs::activeMaps(*system);
    m_attractor = supportFunction(fractal);
    m_placement = placement(fractal);
    m_pieces = ifs::pieces<2>(ifs::overMaps<2>(movedBranches(fractal), m_active.index), m_active.maps.size());
    for (const ifs::MovedBranch<2>& piece : m_pieces)
        m_unmoved.push_back(ifs::inverse(piece.change));
}

ifs::Word Addresses::at(const ifs::Vector<2>& displayed, double pixel) const {
    constexpr double reach = 3; // pixels
    if (!m_attractor) return {};
    const auto point = ifs::preimage(m_placement, displayed, m_attractor->centre());
    if (!point) return {};
    const auto back = ifs::inverse(ifs::firstOrder(m_placement, *point));
    if (!back) return {};
    const double inCode = pixel * ifs::spectralNorm<2>(back->linear);
    std::vector<ifs::AddressQuery> sought;
    for (std::size_t k = 0; k < m_pieces.size(); ++k)
        if (const auto& unmoved = m_unmoved[k])
            sought.push_back({(*unmoved)(*point), ifs::spectralNorm<2>(unmoved->linear), m_pieces[k].word});
    const auto nearest = ifs::addressNear(*m_attractor, sought, reach * inCode, inCode);
    ifs::Word word;
    for (const int letter : nearest ? nearest->address : ifs::Word{})
        word.push_back(int(m_active.index[std::size_t(letter)]));
    return word;
}

std::optional<ifs::Vector<2>> Addresses::fixedPoint(const ifs::Word& word) const {
    const auto letters = ifs::overMaps(word, m_active.index);
    if (word.empty() || !letters) return std::nullopt;
    const auto point = ifs::addressPoint<2>(m_active.maps, {}, *letters);
    if (!point) return std::nullopt;
    std::size_t longest = 0;
    for (const ifs::MovedBranch<2>& piece : m_pieces)
        longest = std::max(longest, piece.word.size());
    ifs::Word address;
    while (address.size() < longest)
        address.insert(address.end(), letters->begin(), letters->end());
    return m_placement(ifs::pieceOf<2>(m_pieces, address).change(*point));
}

namespace {

// A displayed point in coordinates of the code, and the length there of a displayed length `pixel`.
struct PointInCode {
    ifs::Vector<3> at;
    double pixel = 0;
};
std::optional<PointInCode> inCode(const Shape<3>& shape, const ifs::Vector<3>& displayed, double pixel) {
    const ifs::AffineMap<3> placed = shape.cage ? ifs::displayMap(*shape.cage) : ifs::AffineMap<3>();
    auto back = ifs::inverse(placed);
    ifs::Vector<3> at = back ? (*back)(displayed) : ifs::Vector<3>::Zero();
    if (shape.cage && ifs::bends(*shape.cage)) {
        const ifs::CageDeformation bend(shape.cage->rest, shape.cage->current);
        const auto found = ifs::preimage(bend, displayed, at);
        if (!found) return std::nullopt;
        at = *found;
        back = ifs::inverse(ifs::AffineMap<3>{ifs::derivative(bend, at), ifs::Vector<3>::Zero()});
    }
    if (!back) return std::nullopt;
    return PointInCode{at, pixel * ifs::spectralNorm<3>(back->linear)};
}

} // namespace

ifs::Word addressInSpace(const Fractal& fractal, const ifs::Vector<3>& displayed, double pixel) {
    constexpr double reach = 3;     // pixels
    constexpr int maxNodes = 4'000; // limit while the pointer moves
    const Shape<3>* shape = space(fractal);
    if (!shape || !isSpaceExtentKnown(fractal)) return {};
    const auto attractor = spaceSupport(fractal);
    const auto point = attractor ? inCode(*shape, displayed, pixel) : std::nullopt;
    if (!point) return {};
    const ifs::ActiveMaps<3> active = ifs::activeMaps(shape->system);
    std::vector<ifs::AddressQueryIn<3>> sought;
    const auto moved = ifs::overMaps<3>(movedBranches(*shape), active.index);
    for (const auto& [word, change] : ifs::pieces<3>(moved, active.maps.size()))
        if (const auto back = ifs::inverse(change))
            sought.push_back({(*back)(point->at), ifs::spectralNorm<3>(back->linear), word});
    const auto nearest = ifs::addressNear(*attractor, sought, reach * point->pixel, point->pixel, maxNodes);
    ifs::Word word;
    for (const int letter : nearest ? nearest->address : ifs::Word{})
        word.push_back(int(active.index[std::size_t(letter)]));
    return word;
}

QString addressText(const ifs::Word& word, std::size_t longest) {
    QStringList numbers;
    for (std::size_t i = 0; i < word.size() && i < longest; ++i)
        numbers << QString::number(word[i] + 1);
    if (word.size() > longest) numbers << QStringLiteral("…");
    return numbers.join(u' ');
}

} // namespace document
