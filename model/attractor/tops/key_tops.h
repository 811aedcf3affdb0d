// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/key_splat.h"
#include "attractor/request/camera.h"
#include "attractor/tops/coupled_samples.h"
#include "attractor/tops/coupled_system.h"
#include "attractor/tops/word_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace attractor {

// Tops by samples: the minimum fold of the key rank(σ)·S + rank(s) over the words σ of a cut and the samples
// s of a set, an order of their addresses. It depends on neither threads nor bands. What a pixel shows is
// found from its key afterwards. docs/mathematics.md, "Fractal tops".
class KeyTops {
public:
    static constexpr std::uint64_t maxPoints = (std::uint64_t{1} << 32) - 2 * CoupledSamples::usual;

    // `points` is approximate and includes points outside the view, which are not drawn; 1 to maxPoints.
    KeyTops(const CoupledSystem& system, const Camera& camera, std::uint64_t points, std::uint64_t seed,
            const std::stop_token& stop);

    // Rows of the picture from `firstRow` on, as many as there are points. False when stopped.
    bool draw(int firstRow, std::span<TopPoint> points, const std::stop_token& stop) const;

    // The same in two steps. Keys depend on F, the camera, the number of points and the seed alone: while
    // only G moves, they stay.
    bool drawKeys(int firstRow, std::span<std::uint32_t> keys, const std::stop_token& stop) const;
    void decode(std::span<const std::uint32_t> keys, std::span<TopPoint> points) const;
    // Decodes as if made from this system, which has the same F.
    void moveTo(const CoupledSystem& system);

    // The decoder of a key: its piece is key / samples().size(), its sample the remainder.
    struct Piece {
        ifs::AffineMap<2> to;
        double stretch; // |det v_σ / det w_σ|, times the ratio of the whole attractors
        double address, step;
    };
    std::span<const Piece> pieces() const { return m_pieces; }
    std::span<const CoupledSamples::Image> samples() const { return m_samples.images; }

private:
    TopPoint pointOf(std::uint32_t key) const;
    void movePieces(const CoupledSystem& system);

    struct Source {
        std::uint32_t word; // index in the tree
        ifs::Matrix<2> from;
    };

    int m_width;
    CoupledSamples m_samples;
    WordTree m_tree;
    // Tables by rank:
    std::vector<kernels::KeyWord> m_words;
    std::vector<PixelBox> m_boxes;
    std::vector<Source> m_sources;
    std::vector<Piece> m_pieces;
};

} // namespace attractor
