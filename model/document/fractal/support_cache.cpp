// SPDX-License-Identifier: MIT
#include "document/fractal/support_cache.h"

#include "ifs/extent/extent.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace document {

namespace {

template <int Dim> using System = ifs::IteratedFunctionSystem<Dim>;
template <int Dim> using Support = std::shared_ptr<const ifs::SupportFunction<Dim>>;

constexpr std::size_t fewMaps = 256; // limit below which comparing is hardly worthwhile
constexpr std::size_t maxKnown = 4;

template <int Dim> Support<Dim> computed(const System<Dim>& system) {
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    if (active.isLinked()) return nullptr; // linked maps have a different one
    auto support = ifs::SupportFunction<Dim>::of(active.maps);
    return support ? std::make_shared<const ifs::SupportFunction<Dim>>(*std::move(support)) : nullptr;
}

ifs::ControlCage<3> restingSimplex(const System<3>& system, const Support<3>& support) {
    if (!support) return ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    return ifs::cageAtRest<3>(simplexAround(system, *support));
}

// Extents of one system, computed once: a second caller waits for the first.
template <int Dim> class Extents {
public:
    explicit Extents(const System<Dim>& system) : m_system(system) {}

    const System<Dim>& system() const { return m_system; }
    Support<Dim> support() {
        std::call_once(m_supportOnce, [this] { m_support = computed(m_system); });
        return m_support;
    }
    ifs::ControlCage<3> simplex() requires(Dim == 3) {
        std::call_once(m_simplexOnce, [this] {
            m_simplex = restingSimplex(m_system, support());
            m_isSimplexKnown = true;
        });
        return m_simplex;
    }
    bool isSimplexKnown() const { return m_isSimplexKnown; }

private:
    System<Dim> m_system;
    std::once_flag m_supportOnce;
    Support<Dim> m_support;
    std::once_flag m_simplexOnce;
    ifs::ControlCage<3> m_simplex;
    std::atomic<bool> m_isSimplexKnown{false};
};

template <int Dim> class ExtentsList {
public:
    using Pointer = std::shared_ptr<Extents<Dim>>;

    Pointer find(const System<Dim>& system) const {
        const std::lock_guard lock(m_mutex);
        const auto found = position(system);
        return found == m_known.end() ? nullptr : *found;
    }
    Pointer of(const System<Dim>& system) {
        const std::lock_guard lock(m_mutex);
        if (const auto found = position(system); found != m_known.end()) return *found;
        if (m_known.size() == maxKnown) m_known.pop_back();
        m_known.insert(m_known.begin(), std::make_shared<Extents<Dim>>(system));
        return m_known.front();
    }

private:
    typename std::vector<Pointer>::const_iterator position(const System<Dim>& system) const {
        return std::ranges::find_if(m_known, [&](const Pointer& known) { return known->system() == system; });
    }
    mutable std::mutex m_mutex;
    std::vector<Pointer> m_known; // newest first
};

} // namespace

struct SupportCache::Newest {
    ExtentsList<2> plane;
    ExtentsList<3> space;
};

SupportCache::SupportCache() : m_newest(std::make_shared<Newest>()) {}

Support<2> SupportCache::support(const System<2>& system) const {
    if (!m_newest || system.maps.size() <= fewMaps) return computed(system);
    return m_newest->plane.of(system)->support();
}

Support<3> SupportCache::support(const System<3>& system) const {
    if (!m_newest || system.maps.size() <= fewMaps) return computed(system);
    return m_newest->space.of(system)->support();
}

ifs::ControlCage<3> SupportCache::simplexInSpace(const System<3>& system) const {
    if (m_newest && system.maps.size() > fewMaps) return m_newest->space.of(system)->simplex();
    return restingSimplex(system, computed(system));
}

bool SupportCache::isSimplexKnown(const System<3>& system) const {
    if (system.maps.size() <= manyMapsInSpace) return true;
    const auto known = m_newest ? m_newest->space.find(system) : nullptr;
    return known && known->isSimplexKnown();
}

double extentTolerance(const System<3>& system) {
    return system.maps.size() > manyMapsInSpace ? 1e-2 : 1e-6;
}

ifs::Simplex<3> simplexAround(const System<3>& system, const ifs::SupportFunction<3>& support) {
    const double radius = support.radius();
    auto simplex = ifs::minimalCanonicalSimplex(support, extentTolerance(system) * radius);
    constexpr double rounding = 1e-14; // limit that shows zeros instead of rounding errors in tables
    for (ifs::Vector<3>& vertex : simplex.vertices)
        vertex = vertex.unaryExpr([&](double x) { return std::abs(x) <= rounding * radius ? 0 : x; });
    return simplex.vertices;
}

} // namespace document
