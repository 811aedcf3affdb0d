// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/target.h"

#include "ifs/existence/attractor_existence.h"

#include <optional>
#include <span>
#include <vector>

// Agreement of a collage, or of an attractor, with a target. Distances are in cells of the target's grid,
// which are pixels for a target made with the factor 1. docs/mathematics.md, "Collages".
namespace collage {

struct Agreement {
    double coverage = 0;  // |B ∩ L| / |L| for the target L and what is compared with it, B
    double excess = 0;    // |B ∖ L| / |L|
    double iou = 0;       // |B ∩ L| / |B ∪ L|
    double mean = 0;      // mean of the distances from B to L and from L to B, both with equal weight
    double p95 = 0;       // distance that 95 % of all cells of B and L keep to the other set
    double hausdorff = 0; // largest distance
    ifs::Vector<2> worst = ifs::Vector<2>::Zero(); // place of the largest distance, in the plane
};

struct CollageMeasure {
    Agreement images;       // B = W(L), the union of the images of the target
    double overlap = 1;     // Σ |w_i(L)| / |W(L)|: 1 where no two images have a cell in common
    double contraction = 0; // s, the largest spectral norm of a map
    // Upper bound of the Hausdorff distance of target and attractor, in pixels: C (d_H(L, W(L)) + (2 +
    // s)/√2)/(1 − γ), where every map contracts by γ in the norm with |x| ≤ ‖x‖ ≤ C|x|. For a target made
    // with the factor 1; nullopt where no such norm is known.
    std::optional<double> bound;
    // The norm of the bound; Euclidean, with γ = s and C = 1, unless another one says more.
    ifs::ContractingNorm<2> norm;
};

// Measures of a collage, and the cells that its images meet.
struct MeasuredCollage {
    CollageMeasure measure;
    Mask images; // union on the grid of the target
};
// Effort spent on finding a norm for maps that contract, but not in the Euclidean norm.
enum class NormSearch { Thorough, Hurried };
// The maps are those of the plane; there must be one at least, and all must be finite.
MeasuredCollage measuredCollage(const Target& target, std::span<const ifs::AffineMap<2>> maps,
                                NormSearch search = NormSearch::Thorough);
CollageMeasure collageMeasure(const Target& target, std::span<const ifs::AffineMap<2>> maps);
// B = the attractor of the maps, which must contract in some norm.
Agreement attractorAgreement(const Target& target, std::span<const ifs::AffineMap<2>> maps);

// Objective of a fit of an attractor, in units of the plane: the mean distance, plus 0.003 of the size of the
// target times 1 − iou, so that solid shapes come out solid.
double visibleError(const Target& target, const Agreement& attractor);

double contraction(std::span<const ifs::AffineMap<2>> maps); // s, the largest spectral norm

// The cells that the attractor meets, on the grid of the target.
Mask attractorMask(const Grid& grid, std::span<const ifs::AffineMap<2>> maps);

} // namespace collage
