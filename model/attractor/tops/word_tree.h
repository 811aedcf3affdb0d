// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/coupled_system.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// Words as numbers: each is one of those before it and a symbol more. The first, 0, is the empty one.
class WordTree {
public:
    std::uint32_t longer(std::uint32_t word, std::size_t symbol) {
        m_steps.push_back({word, std::uint32_t(symbol)});
        return std::uint32_t(m_steps.size() - 1);
    }

    struct Image {
        ifs::AffineMap<2> to;
        double areaRatio = 1; // product of the ratios of its maps
    };
    // v_σ of all words, by their numbers.
    std::vector<Image> images(const CoupledSystem& system) const;

private:
    struct Step {
        std::uint32_t before, symbol;
    };
    std::vector<Step> m_steps{{0, 0}};
};

} // namespace attractor
