// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/tops/top_address.h"

#include <optional>
#include <vector>

namespace ifs {

// T_FG = φ_G∘τ_F: the point of the attractor of G that has the top address of a point of the attractor of F.
// The maps correspond by their indices, and the first are on top. docs/mathematics.md, "Fractal tops".
class FractalTransformation {
public:
    // `to`: equally many maps of G as `from` has; they must have an attractor.
    FractalTransformation(SupportFunction<2> from, std::vector<AffineMap<2>> to)
        : m_search(std::move(from)), m_to(std::move(to)) {}

    struct Answer {
        std::optional<TopAddress> top;
        std::optional<Vector<2>> image;
        bool isCutShort = false;
    };
    Answer at(const Vector<2>& x) const {
        TopSearch::Answer found = m_search.at(x);
        Answer answer{std::move(found.top), std::nullopt, found.isCutShort};
        if (answer.top) answer.image = pointOf(*answer.top, m_to);
        return answer;
    }

    const TopSearch& search() const { return m_search; }

private:
    TopSearch m_search;
    std::vector<AffineMap<2>> m_to;
};

} // namespace ifs
