// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/solid_walk.h"
#include "attractor/solid/covers.h"
#include "attractor/solid/depth_range.h"
#include "ifs/system/affine_map.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// Covers without invisible points: wherever a word lies between the pixels, these share theirs with a nearer
// point of the same cover. Perspective and bent cages show every word from another side, so thinning is done
// for the linear maps that turn up, near ones together, and kept while they do. A thinned cover leaves the
// same keys as the whole one. docs/mathematics.md, "Solids".
class ThinnedCovers {
public:
    // Prepares for a system whose maps all shrink by `ratio` without turning anything.
    void use(const Covers& covers, double ratio);

    // A thinned replacement for the one of `covers` that would draw a word with this linear map to pixels and
    // depth, where `depthScale` is the depth of a pixel. It is exact only for words of that size
    // (Cover::onlyFor). nullptr where none is known or it would not be exact. Valid until the next call.
    const kernels::Cover* find(const ifs::Matrix<3>& linear, double depthScale,
                               std::span<const kernels::Cover> covers);

    // Reports `points` points that were drawn with whole covers, which allows as much work for thinning some.
    void missed(std::size_t points) { m_credit += points; }

    // Returns true if rounding moves nothing by more than the slacks below, in pixels, in pictures of that
    // width and depth.
    static bool isExact(double ratio, int width, const DepthRange& range);
    static constexpr float pixelSlack = 1.0F / 128;
    static constexpr float depthSlack = 1.0F / 64;

private:
    struct Thinned {
        const float* from = nullptr; // cover that was thinned
        ifs::Matrix<3> linear;       // linear part of a word drawn with it
        ifs::Matrix<3> inverse;
        ifs::Matrix<3> room; // greatest difference of other linear parts
        std::uint64_t used = 0;
        std::size_t padded = 0; // 0: not worthwhile
        std::vector<float> coordinates;

        bool holdsFor(const ifs::Matrix<3>& other) const;
    };
    Thinned* known(const ifs::Matrix<3>& linear, const kernels::Cover& of);
    Thinned* thin(const ifs::Matrix<3>& linear, const kernels::Cover& of);

    Covers m_covers;
    double m_ratio = 0;
    std::uint64_t m_clock = 0;
    std::size_t m_credit = 0;
    std::size_t m_tried = 0;
    std::size_t m_worthwhile = 0;
    std::size_t m_last = 0;
    std::vector<Thinned> m_thinned;
    kernels::Cover m_found;
};

} // namespace attractor
