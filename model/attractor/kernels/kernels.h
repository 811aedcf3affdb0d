// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/cells.h"
#include "attractor/kernels/word.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The loops that take the time, compiled for several instruction sets; the best one of the machine runs. All
// give the same bits.
namespace attractor {

// The name of the set in use: scalar, sse4, avx2, avx512 (which may also be called avx3) or neon. The
// environment variable BARYCAGE_SIMD forces one.
std::string simdName();
std::vector<std::string> simdNames(); // all that this processor supports, best first
// Forces a set; false, and nothing changes, when the machine lacks it or the name is unknown. Not while
// rendering.
bool selectSimd(std::string_view name);
// Chooses the instruction set by the environment, once, before the first kernel runs, unless a caller has
// selected one. Every kernel calls it first.
void heedEnvironment();

namespace kernels {

constexpr std::size_t chunk = 128; // number of points; runs are read up to a multiple of it

struct Run {
    const float* x = nullptr;
    const float* y = nullptr;
    std::size_t count = 0;
};

// Counts every point of the run in its cell of the window, or in an overflow cell.
void addToCounts(const ShownWord& shown, const Run& run, const CellWindow& window, std::uint32_t* counts);
// A faster version for runs known to lie in the window.
void addInside(const ShownWord& shown, const Run& run, const CellWindow& window, std::uint32_t* counts);

// The cells of a run that covers at most `patchCells`, all inside the window; (column, row) is the first.
// They are counted in several small copies, because increments of one counter have to wait for each other.
struct Patch {
    int column = 0;
    int row = 0;
    int width = 0;
    int height = 0;
};
constexpr int patchCells = 256;
void addToPatch(const Word& word, const Run& run, const Patch& patch, const CellWindow& window,
                std::uint32_t* counts);

// Returns the bits seen in all sums.
std::uint32_t addToColours(const ShownWord& shown, const Run& run, const CellWindow& window,
                           const ColourCell& colour, ColourCell* cells);
std::uint32_t addToColoursInside(const ShownWord& shown, const Run& run, const CellWindow& window,
                                 const ColourCell& colour, ColourCell* cells);

// 64 orbits side by side.
struct Lanes {
    static constexpr std::size_t count = 64;
    alignas(64) std::array<std::array<std::uint32_t, count>, 4> random{}; // xoshiro128++
    alignas(64) std::array<float, count> x{};
    alignas(64) std::array<float, count> y{};
};

// Alias table (see AliasTable) and maps as arrays, each of `size` entries, a power of two ≥ 16.
struct ChaosTables {
    std::size_t size = 16;
    const std::int32_t* threshold = nullptr;
    const std::int32_t* alias = nullptr;
    std::array<const float*, 6> coefficients{}; // a b c d e f, in box coordinates
    float escapeRadius = 0;
};

// With On, an orbit that leaves the escape radius restarts at 0.
enum class Guard { Off, On };

// `steps` steps of every orbit. Where x and y are given, the point of orbit `lane` after step `k` goes to
// x[64 k + lane], y[64 k + lane].
void iterate(Lanes& lanes, const ChaosTables& tables, Guard guard, std::size_t steps, float* x, float* y);

// pixels[k] = palette[toneIndex(Σ counts[thread][k])]; palette[0] where there are no counts at all. The
// sums must stay below 2³¹.
constexpr std::size_t exactCounts = 128;
std::size_t toneIndex(std::uint64_t samples); // exact below 128, then 64 steps per power of two
void mapTones(std::span<const std::uint32_t* const> counts, std::size_t size, const std::uint32_t* palette,
              std::uint32_t* pixels);

} // namespace kernels
} // namespace attractor
