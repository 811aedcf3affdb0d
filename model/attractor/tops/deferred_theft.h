// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/threads/workers.h"
#include "attractor/tops/key_tops.h"
#include "attractor/tops/stolen_picture.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace attractor {

// Steals colours for one picture after another and keeps the keys of the last one: while F, its camera, the
// number of points and the seed stay, only the colours are looked up anew. The pixels are those of steal().
// docs/mathematics.md, "Fractal tops".
class DeferredTheft {
public:
    explicit DeferredTheft(int threads) : m_workers(std::size_t(threads)) {}

    // 0xAARRGGBB, premultiplied: as many as the camera has. False when stopped; samples only, not exactly.
    bool draw(const CoupledSystem& system, const MipPicture& picture, const TheftRequest& request,
              std::span<std::uint32_t> pixels, const std::stop_token& stop);

    // Lays the picture itself, with this opacity, behind the attractor of G seen through request.camera.
    void layUnder(std::span<std::uint32_t> pixels, const MipPicture& picture, const TheftRequest& request,
                  double opacity);

    bool hasKeptKeys() const { return m_hasKeptKeys; } // true if the last draw() could reuse its keys

private:
    bool keep(const CoupledSystem& system, const TheftRequest& request, const std::stop_token& stop);

    Workers m_workers;
    // The state for which the keys were drawn; without keys for a pixel, they belong to none.
    std::vector<ifs::AffineMap<2>> m_from;
    std::vector<double> m_probabilities;
    Camera m_camera;
    std::uint64_t m_points = 0, m_seed = 0;
    std::optional<KeyTops> m_tops;
    std::vector<std::uint32_t> m_keys;
    bool m_hasKeptKeys = false;
};

} // namespace attractor
