// SPDX-License-Identifier: MIT
#include "ifs/links/plain_words.h"

#include "ifs/system/links.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ifs {

namespace {

class Chains {
public:
    Chains(const ActiveMaps<2>& active, std::size_t most)
        : m_size(active.maps.size()), m_links(active.links), m_chain(transitions(active)), m_most(most) {}

    // Returns true if chains end: no cycle of maps is left without the maps that end chains or lead only to
    // such maps.
    bool end() const {
        std::vector<bool> ends(m_size);
        for (bool goesOn = true; goesOn;) {
            goesOn = false;
            for (std::size_t j = 0; j < m_size; ++j) {
                if (ends[j] || !(followsAll(j) || leadsTo(ends, j))) continue;
                ends[j] = goesOn = true;
            }
        }
        return std::ranges::find(ends, false) == ends.end();
    }

    std::optional<PlainWords> all() {
        for (std::size_t j = 0; j < m_size; ++j)
            if (!follow({j}, 1)) return std::nullopt;
        double sum = 0;
        for (const double weight : m_found.weights)
            sum += weight;
        for (double& weight : m_found.weights)
            weight /= sum;
        m_found.keepsMeasure = isMemoryless();
        return std::move(m_found);
    }

private:
    bool isLinked(std::size_t from, std::size_t to) const {
        return m_links.empty() || m_links[from * m_size + to] > 0;
    }
    bool followsAll(std::size_t to) const {
        for (std::size_t from = 0; from < m_size; ++from)
            if (!isLinked(from, to)) return false;
        return true;
    }

    bool leadsTo(const std::vector<bool>& ends, std::size_t to) const {
        for (std::size_t from = 0; from < m_size; ++from)
            if (isLinked(from, to) && !ends[from]) return false;
        return true;
    }

    // True if each map that ends a word has a single probability of coming next, whatever preceded it.
    bool isMemoryless() const {
        constexpr double tolerance = 1e-12;
        return std::ranges::all_of(m_found.words, [&](const std::vector<std::size_t>& word) {
            for (std::size_t from = 1; from < m_size; ++from)
                if (std::abs(m_chain.forward[from * m_size + word.back()] - m_chain.forward[word.back()]) >
                    tolerance)
                    return false;
            return true;
        });
    }

    bool follow(const std::vector<std::size_t>& word, double probability) {
        if (word.size() > m_size) return false; // cycle
        const std::size_t innermost = word.back();
        if (followsAll(innermost)) {
            if (m_found.words.size() == m_most) return false;
            m_found.words.push_back(word);
            m_found.weights.push_back(probability * m_chain.stationary[innermost]);
            return true;
        }
        for (std::size_t before = 0; before < m_size; ++before) {
            if (!isLinked(before, innermost)) continue;
            std::vector<std::size_t> longer = word;
            longer.push_back(before);
            if (!follow(longer, probability * m_chain.forward[before * m_size + innermost])) return false;
        }
        return true;
    }

    std::size_t m_size;
    const std::vector<double>& m_links;
    Transitions m_chain;
    std::size_t m_most;
    PlainWords m_found;
};

} // namespace

std::optional<PlainWords> plainWords(const ActiveMaps<2>& active, std::size_t most) {
    if (active.maps.empty()) return std::nullopt;
    return Chains(active, most).all();
}

bool hasPlainWords(const ActiveMaps<2>& active) {
    return !active.maps.empty() && Chains(active, 0).end();
}

} // namespace ifs
