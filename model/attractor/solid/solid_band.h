// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/depth_raster.h"
#include "attractor/kernels/solid_walk.h"
#include "attractor/samples/prepared_space.h"
#include "attractor/solid/covers.h"
#include "attractor/solid/depth_range.h"
#include "attractor/solid/facing_cover.h"
#include "attractor/solid/space_view.h"
#include "attractor/solid/thinned_covers.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace attractor {

// Everything that determines the keys of a picture.
struct SolidScene {
    PreparedSpace system;
    std::vector<ifs::AffineMap<3>> boxMaps; // maps of the system in box coordinates
    std::vector<std::uint8_t> colours;      // colours of the maps: their indices in the system
    SolidKey key = SolidKey::Map;
    std::optional<BoxMaps> coefficients;
    Covers covers;
    SpaceView view;
    DepthRange range;
    FacingCover facing;
    std::optional<double> thinningRatio; // set if words are seen from many sides

    // A word from which walks begin, in box coordinates.
    struct Root {
        ifs::AffineMap<3> word;
        int colour = kernels::SolidWord::uncoloured;
        ifs::Word address{};  // maps that lead to the word
        bool isMoved = false; // true if the word is not where its maps put it
    };
    std::vector<Root> roots;

    // Points of words that are drawn as one; more of them would hide each other unseen.
    static constexpr std::size_t leafPoints = 1024;
    static constexpr std::size_t facingPoints = 8192;

    void setSystem(PreparedSpace prepared);
    void setKey(SolidKey newKey);
    void setView(const SpaceView& newView);

private:
    std::shared_ptr<BendTree> m_bends; // null until a view bends
};

// Draws rows of a picture, from the root of the address tree. Memory is kept from one call to the next.
class SolidBand {
public:
    // rows ≤ kernels::KeyBand::maxRows. Stopped, it leaves the raster as it is.
    void draw(const SolidScene& scene, int firstRow, int rows, DepthRaster& raster,
              const std::stop_token& stop);

    struct Work {
        std::size_t words = 0;
        std::size_t points = 0;
        bool isCoarse = false; // true if there were too many words to examine, with visible effect
    };
    Work takeWork(); // work since the last call

private:
    struct Open {
        WalkedWord word; // box → SpaceView::toPixels
        int colour = kernels::SolidWord::uncoloured;
        SeenWord seen{}; // glimpsed only, if the word does not follow
    };
    bool walk(const SolidScene& scene, int firstRow, const std::stop_token& stop);
    bool draw(const SolidScene& scene, Open& open, int firstRow, const std::stop_token& stop);
    void expand(const SolidScene& scene, const Open& open, int firstRow);
    void openSorted(const SolidScene& scene, int firstRow);
    bool isHidden(const SolidScene& scene, const SeenWord& word, int firstRow);
    const kernels::Cover* coverFor(double size) const;
    bool drawWhole(const SeenWord& seen, const kernels::SolidWord& word, const std::stop_token& stop);

    kernels::KeyBand m_keys;
    kernels::SolidJob m_job;
    std::vector<kernels::Cover> m_covers; // starts with the thinned one, if any
    ThinnedCovers m_thinned;
    bool m_isThinning = false;
    std::size_t m_wideBudget = 0; // words that may still be composed in double precision
    std::vector<Open> m_open;
    std::vector<Open> m_children;
    std::vector<std::pair<double, std::size_t>> m_order;
    bool m_isCoarse = false; // state of one band
};

} // namespace attractor
