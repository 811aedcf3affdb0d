// SPDX-License-Identifier: MIT
#include "attractor/solid/bend_tree.h"

#include <algorithm>
#include <functional>

namespace attractor {

BendTree::BendTree(std::size_t byteLimit) : m_byteLimit(byteLimit) {
    clear();
}

BendTree::~BendTree() = default;

void BendTree::clear() {
    m_nodes.clear();
    m_bytes = m_known = 0;
    m_isFull = false;
    m_view = 0;
    m_root = grow(1);
}

void BendTree::follow(const ifs::CageDeformation& bend, const ifs::AffineMap<3>& after,
                      const ifs::AffineMap<3>& box, std::span<const ifs::AffineMap<3>> maps) {
    const bool isSame = m_rest && std::ranges::equal(m_rest->vertices(), bend.rest()->vertices()) &&
                        m_box == box && std::ranges::equal(m_maps, maps);
    // Restarts when it is full of words that have left the view.
    if (!isSame || (m_isFull && 2 * m_asked < m_known) || m_view + 1 == 0) clear();
    m_rest = bend.rest();
    m_box = box;
    m_maps.assign(maps.begin(), maps.end());
    m_bend = PixelBend(bend, after);
    m_asked = 0;
    ++m_view;
}

bool BendTree::takes(std::size_t bytes) {
    if (m_bytes.fetch_add(bytes) + bytes <= m_byteLimit) return true;
    m_bytes -= bytes;
    m_isFull = true;
    return false;
}

BendTree::Node* BendTree::grow(std::size_t count) {
    if (!takes(count * sizeof(Node))) return nullptr;
    const std::scoped_lock lock(m_growth);
    return m_nodes.emplace_back(count).data();
}

std::mutex& BendTree::lockOf(const Node& node) {
    return m_locks[std::hash<const Node*>()(&node) / sizeof(Node) % m_locks.size()];
}

BendTree::Node* BendTree::child(Node& node, std::size_t map) {
    Node* children = node.children.load(std::memory_order_acquire);
    if (children == nullptr) {
        const std::scoped_lock lock(lockOf(node));
        children = node.children.load(std::memory_order_relaxed);
        if (children == nullptr) {
            children = grow(m_maps.size());
            node.children.store(children, std::memory_order_release);
        }
    }
    return children == nullptr ? nullptr : children + map;
}

const BentWord* BendTree::bent(Node& node, const ifs::AffineMap<3>& word) {
    if (node.view.load(std::memory_order_acquire) == m_view) return &node.known->bent;
    const std::scoped_lock lock(lockOf(node));
    if (node.view.load(std::memory_order_relaxed) == m_view) return &node.known->bent;
    if (!node.known) {
        if (!takes(sizeof(Known) + WordCoordinates::bytes(m_rest->size()))) return nullptr;
        node.known = std::make_unique<Known>(Known{WordCoordinates(*m_rest, word), {}});
        ++m_looks;
        ++m_known;
    }
    node.known->bent = node.known->coordinates.bent(word, m_bend);
    ++m_asked;
    node.view.store(m_view, std::memory_order_release);
    return &node.known->bent;
}

} // namespace attractor
