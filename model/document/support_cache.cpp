// SPDX-License-Identifier: MIT
#include "document/support_cache.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace document {

namespace {

using System = ifs::IteratedFunctionSystem<2>;
using Support = std::shared_ptr<const ifs::SupportFunction<2>>;

constexpr std::size_t fewMaps = 256; // for which comparing is hardly worth it
constexpr std::size_t maxKnown = 4;

struct Known {
    System system;
    Support support;
};

Support computed(const System& system) {
    const ifs::ActiveMaps<2> active = ifs::activeMaps(system);
    if (active.isLinked()) return nullptr; // that of the maps without their links is another one
    auto support = ifs::SupportFunction<2>::of(active.maps);
    return support ? std::make_shared<const ifs::SupportFunction<2>>(*std::move(support)) : nullptr;
}

} // namespace

struct SupportCache::Newest {
    std::mutex mutex;
    std::vector<Known> known; // newest first

    const Known* find(const System& system) const {
        const auto found = std::ranges::find(known, system, &Known::system);
        return found == known.end() ? nullptr : &*found;
    }
};

SupportCache::SupportCache() : m_newest(std::make_shared<Newest>()) {}

std::shared_ptr<const ifs::SupportFunction<2>> SupportCache::support(const System& system) const {
    if (!m_newest || system.maps.size() <= fewMaps) return computed(system);
    {
        const std::lock_guard lock(m_newest->mutex);
        if (const Known* known = m_newest->find(system)) return known->support;
    }
    Support support = computed(system); // others may ask for other systems meanwhile
    const std::lock_guard lock(m_newest->mutex);
    if (m_newest->find(system) == nullptr) {
        if (m_newest->known.size() == maxKnown) m_newest->known.pop_back();
        m_newest->known.insert(m_newest->known.begin(), {system, support});
    }
    return support;
}

} // namespace document
