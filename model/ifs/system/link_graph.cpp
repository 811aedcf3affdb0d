// SPDX-License-Identifier: MIT
#include "ifs/system/link_graph.h"

#include <algorithm>

namespace ifs {

namespace {

using Flags = std::vector<char>;

// Removes states that have no edge to a state that stays, until all have. `edge(i, j)`: from i to j.
template <class Edge> Flags lasting(Flags stays, Edge edge) {
    const std::size_t n = stays.size();
    std::vector<std::size_t> exits(n, 0);
    std::vector<std::size_t> gone;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            exits[i] += stays[i] && stays[j] && edge(i, j) ? 1 : 0;
        if (stays[i] && exits[i] == 0) gone.push_back(i);
    }
    while (!gone.empty()) {
        const std::size_t j = gone.back();
        gone.pop_back();
        stays[j] = 0;
        for (std::size_t i = 0; i < n; ++i)
            if (stays[i] && edge(i, j) && --exits[i] == 0) gone.push_back(i);
    }
    return stays;
}

// Tarjan's algorithm with a stack of its own: a part is complete before those that lead to it.
class PartSearch {
public:
    PartSearch(std::span<const double> matrix, std::size_t size)
        : m_matrix(matrix), m_size(size), m_number(size, 0), m_low(size, 0), m_isOpen(size, 0) {}

    std::vector<std::vector<std::size_t>> parts() {
        for (std::size_t i = 0; i < m_size; ++i)
            if (m_number[i] == 0) walkFrom(i);
        return std::move(m_parts);
    }

private:
    struct Visit {
        std::size_t state;
        std::size_t next; // next successor to visit
    };

    void enter(std::size_t state) {
        m_number[state] = m_low[state] = ++m_count;
        m_open.push_back(state);
        m_isOpen[state] = 1;
        m_path.push_back({state, 0});
    }

    void walkFrom(std::size_t start) {
        enter(start);
        while (!m_path.empty()) {
            const auto [state, next] = m_path.back();
            if (next == m_size) {
                leave();
                continue;
            }
            ++m_path.back().next;
            if (!(m_matrix[state * m_size + next] > 0)) continue;
            if (m_number[next] == 0)
                enter(next);
            else if (m_isOpen[next])
                m_low[state] = std::min(m_low[state], m_number[next]);
        }
    }

    void leave() {
        const std::size_t state = m_path.back().state;
        m_path.pop_back();
        if (!m_path.empty()) {
            std::size_t& low = m_low[m_path.back().state];
            low = std::min(low, m_low[state]);
        }
        if (m_low[state] != m_number[state]) return;
        std::vector<std::size_t> part;
        do {
            part.push_back(m_open.back());
            m_isOpen[part.back()] = 0;
            m_open.pop_back();
        } while (part.back() != state);
        std::ranges::sort(part);
        m_parts.push_back(std::move(part));
    }

    std::span<const double> m_matrix;
    std::size_t m_size;
    std::size_t m_count = 0;
    std::vector<std::size_t> m_number, m_low, m_open;
    Flags m_isOpen;
    std::vector<Visit> m_path;
    std::vector<std::vector<std::size_t>> m_parts;
};

// Returns true if every state leads to states of its part only.
bool isClosed(std::span<const double> matrix, std::size_t size, const std::vector<std::size_t>& part) {
    for (const std::size_t i : part)
        for (std::size_t j = 0; j < size; ++j)
            if (matrix[i * size + j] > 0 && !std::ranges::binary_search(part, j)) return false;
    return true;
}

} // namespace

std::vector<LinkState> statesOf(std::vector<double> matrix, const std::vector<char>& on) {
    const std::size_t n = on.size();
    std::vector<LinkState> states(n, LinkState::TakesPart);
    const Flags goesOn = lasting(on, [&](auto i, auto j) { return matrix[i * n + j] > 0; });
    const Flags hasPast = lasting(goesOn, [&](auto i, auto j) { return matrix[j * n + i] > 0; });
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (!goesOn[i] || !goesOn[j]) matrix[i * n + j] = 0;
    for (const auto& part : connectedParts(matrix, n)) {
        if (isClosed(matrix, n, part) && goesOn[part.front()]) continue;
        for (const std::size_t i : part)
            states[i] = !on[i]        ? LinkState::Off
                        : !goesOn[i]  ? LinkState::Ends
                        : !hasPast[i] ? LinkState::Unreached
                                      : LinkState::Left;
    }
    return states;
}

std::vector<std::vector<std::size_t>> connectedParts(std::span<const double> matrix, std::size_t size) {
    return PartSearch(matrix, size).parts();
}

} // namespace ifs
