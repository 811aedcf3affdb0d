// SPDX-License-Identifier: MIT
#include "document/addresses.h"

#include "ifs/address_search.h"
#include "ifs/map_handles.h"

#include <QStringList>

#include <algorithm>

namespace document {

Addresses::Addresses(const Fractal& fractal) {
    const System2* system = system2(fractal);
    if (system == nullptr) return;
    m_active = ifs::activeMaps(*system);
    m_attractor = ifs::SupportFunction<2>::of(m_active.maps);
    m_placement = placement(fractal);
}

ifs::Word Addresses::at(const ifs::Vector<2>& displayed, double pixel) const {
    constexpr double reach = 3; // pixels
    if (!m_attractor) return {};
    const auto point = ifs::preimage(m_placement, displayed, m_attractor->centre());
    if (!point) return {};
    const auto back = ifs::inverse(ifs::firstOrder(m_placement, *point));
    if (!back) return {};
    const double inCode = pixel * ifs::spectralNorm<2>(back->linear);
    const auto found = ifs::addressNear(*m_attractor, *point, reach * inCode, inCode);
    if (!found) return {};
    ifs::Word word;
    for (const int letter : found->address)
        word.push_back(int(m_active.index[std::size_t(letter)]));
    return word;
}

std::optional<ifs::Vector<2>> Addresses::fixedPoint(const ifs::Word& word) const {
    if (word.empty()) return std::nullopt;
    ifs::Word letters;
    for (const int place : word) {
        const auto letter = std::ranges::find(m_active.index, std::size_t(place));
        if (letter == m_active.index.end()) return std::nullopt;
        letters.push_back(int(letter - m_active.index.begin()));
    }
    const auto point = ifs::addressPoint<2>(m_active.maps, {}, letters);
    return point ? std::optional(m_placement(*point)) : std::nullopt;
}

QString addressText(const ifs::Word& word, std::size_t longest) {
    QStringList numbers;
    for (std::size_t i = 0; i < word.size() && i < longest; ++i)
        numbers << QString::number(word[i] + 1);
    if (word.size() > longest) numbers << QStringLiteral("…");
    return numbers.join(u' ');
}

} // namespace document
