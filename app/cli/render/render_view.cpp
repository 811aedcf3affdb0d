// SPDX-License-Identifier: MIT
#include "render/render_view.h"

#include "options/tr.h"
#include "options/usage_error.h"

#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"

#include <cmath>
#include <vector>

namespace cli {

namespace {

constexpr double maxCopies = 1e7;

class Extent {
public:
    void add(const ifs::Vector<2>& point) {
        m_min = m_min.cwiseMin(point);
        m_max = m_max.cwiseMax(point);
    }
    ViewBox box(bool certified) const { return {m_min, m_max, certified}; }

private:
    ifs::Vector<2> m_min = ifs::Vector<2>::Constant(HUGE_VAL);
    ifs::Vector<2> m_max = ifs::Vector<2>::Constant(-HUGE_VAL);
};

} // namespace

ViewBox boxOfIterate(const document::Fractal& fractal, int n) {
    const attractor::PreparedSystem system =
        attractor::prepared(*document::system2(fractal), document::movedBranches(fractal));
    const std::vector<ifs::AffineMap<2>>& maps = system.maps;
    if (std::pow(double(maps.size()), n) > maxCopies)
        throw UsageError{tr("--iterations %1 would draw %2 copies of the cage; the limit is 10 million.")
                             .arg(n)
                             .arg(std::pow(double(maps.size()), n), 0, 'g', 3)};
    struct Copy {
        ifs::AffineMap<2> map;
        int left;
    };
    const auto rest = document::effectiveCage(fractal).rest;
    const ifs::Placement toDisplay = document::placement(fractal);
    Extent extent;
    std::vector<Copy> open;
    for (const auto& [word, change] : ifs::pieces<2>(system.moved, maps.size(), std::size_t(n)))
        open.push_back({change * ifs::composed<2>(maps, word), n - int(word.size())});
    while (!open.empty()) {
        const Copy copy = open.back();
        open.pop_back();
        for (std::size_t i = 0; copy.left == 0 && i < rest.size(); ++i)
            extent.add(toDisplay(copy.map(rest[i])));
        for (std::size_t i = 0; copy.left > 0 && i < maps.size(); ++i)
            open.push_back({copy.map * maps[i], copy.left - 1});
    }
    return extent.box(true);
}

} // namespace cli
