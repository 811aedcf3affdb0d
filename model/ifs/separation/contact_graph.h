// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ifs {

// Contacts of two pieces as made of contacts of smaller pieces: a graph with as many edges from one vertex to
// another as there are pairs of these, or with weights.
class ContactGraph {
public:
    static constexpr std::size_t maxVertices = 1024; // limit of those who look for contacts

    explicit ContactGraph(std::size_t vertices) : m_edges(vertices) {}
    void join(std::size_t from, std::size_t to, double weight = 1) { m_edges[from].push_back({to, weight}); }

    // Leaves the vertices from which a walk can go on for ever, the only ones that stand for common points.
    // Returns what they were before, in order.
    std::vector<std::size_t> prune();

    // An interval that holds the spectral radius of the matrix of sums of weights (Collatz and Wielandt).
    // nullopt where it is not found to 1e-11 of its size; usually it is, to 1e-14.
    struct Radius {
        double least = 0;
        double most = 0;
    };
    std::optional<Radius> spectralRadius() const;

private:
    std::vector<std::vector<std::size_t>> strongParts() const;
    void close(std::size_t first, std::vector<std::size_t>& open, std::vector<char>& isOpen,
               std::vector<std::vector<std::size_t>>& parts) const;
    std::optional<Radius> radiusOf(const std::vector<std::size_t>& part) const;

    struct Edge {
        std::size_t to;
        double weight;
    };
    std::vector<std::vector<Edge>> m_edges;
};

} // namespace ifs
