// SPDX-License-Identifier: MIT
#include "attractor/tops/word_tree.h"

namespace attractor {

std::vector<WordTree::Image> WordTree::images(const CoupledSystem& system) const {
    std::vector<Image> result(m_steps.size());
    for (std::size_t k = 1; k < m_steps.size(); ++k) {
        const Image& before = result[m_steps[k].before];
        const std::uint32_t symbol = m_steps[k].symbol;
        result[k] = {before.to * system.to[symbol], before.areaRatio * system.areaRatios[symbol]};
    }
    return result;
}

} // namespace attractor
