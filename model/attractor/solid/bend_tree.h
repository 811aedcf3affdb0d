// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/solid/bent_word.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace attractor {

// The bends of words near the root of the address tree, each worked out once for a view, whoever asks for it.
// What depends on the cage at rest alone is kept from one view to the next, and never changes a bit.
class BendTree {
    struct Known;

public:
    static constexpr std::size_t maxBytes = std::size_t{16} << 20;

    // An address. What is known of it is written once for a view.
    class Node {
        friend class BendTree;
        std::atomic<std::uint32_t> view = 0; // number of the view for which `known` is up to date
        std::atomic<Node*> children = nullptr;
        std::unique_ptr<Known> known;
    };

    explicit BendTree(std::size_t byteLimit = maxBytes);
    ~BendTree();

    // Switches to this bend followed by the map `after`, and to words of `maps` that begin with `box`, in
    // coordinates of the box. No other thread may use the tree meanwhile.
    void follow(const ifs::CageDeformation& bend, const ifs::AffineMap<3>& after,
                const ifs::AffineMap<3>& box, std::span<const ifs::AffineMap<3>> maps);

    // Thread-safe. nullptr where the tree is full.
    Node* root() const { return m_root; }
    Node* child(Node& node, std::size_t map);
    // The bend of the word with that address, which lasts until the next follow(); nullptr where the tree is
    // full.
    const BentWord* bent(Node& node, const ifs::AffineMap<3>& word);

    std::size_t bytes() const { return m_bytes; }
    std::size_t looks() const { return m_looks; } // evaluations of the cage since the tree was made

private:
    struct Known {
        WordCoordinates coordinates;
        BentWord bent;
    };
    void clear();
    bool takes(std::size_t bytes); // false if memory would run out
    Node* grow(std::size_t count);
    std::mutex& lockOf(const Node& node);

    std::size_t m_byteLimit;
    std::shared_ptr<const ifs::CageCoordinates> m_rest;
    ifs::AffineMap<3> m_box;
    std::vector<ifs::AffineMap<3>> m_maps;
    PixelBend m_bend;
    std::uint32_t m_view = 0;
    std::atomic<std::size_t> m_bytes = 0;
    std::atomic<std::size_t> m_looks = 0;
    std::atomic<std::size_t> m_known = 0; // words with known coordinates
    std::atomic<std::size_t> m_asked = 0; // words requested in this view
    std::atomic<bool> m_isFull = false;
    Node* m_root = nullptr;
    std::mutex m_growth;
    std::deque<std::vector<Node>> m_nodes; // first the root; then one vector for each set of siblings
    std::array<std::mutex, 64> m_locks;
};

} // namespace attractor
