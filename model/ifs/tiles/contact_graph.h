// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ifs {

// Which contacts of two tiles the contacts of their pieces are: a graph with as many edges from one vertex to
// another as there are pairs of pieces.
class ContactGraph {
public:
    static constexpr std::size_t maxVertices = 1024;

    explicit ContactGraph(std::size_t vertices) : m_edges(vertices) {}
    void join(std::size_t from, std::size_t to) { m_edges[from].push_back(to); }

    // Leaves the vertices from which a walk can go on for ever, the only ones that stand for common points.
    // Returns how many those are; they keep their order.
    std::size_t prune();

    // An interval that holds the spectral radius of the matrix of numbers of edges (Collatz and Wielandt).
    // nullopt where it is not found to 1e-11 of its size; usually it is, to 1e-14.
    struct Radius {
        double least = 0;
        double most = 0;
    };
    std::optional<Radius> spectralRadius() const;

private:
    std::vector<std::vector<std::size_t>> strongParts() const;
    std::optional<Radius> radiusOf(const std::vector<std::size_t>& part) const;

    std::vector<std::vector<std::size_t>> m_edges;
};

} // namespace ifs
