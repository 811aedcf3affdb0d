// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/address_cut.h"
#include "attractor/cell_sums.h"
#include "attractor/chaos_game.h"
#include "attractor/drawable_system.h"
#include "attractor/renderer.h"
#include "attractor/tone_map.h"
#include "attractor/workers.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace attractor {

// Words of the cut for a pass of so many samples: none takes more of a sample set than there is.
int wordsFor(std::uint64_t samples);

// The picture in the making behind Rendering and BandedRendering: what has fallen into the cells of some of
// its rows.
struct Picture {
    // A run of words, or a part of a single word with very many samples.
    struct Job {
        std::uint32_t firstWord = 0;
        std::uint32_t endWord = 0;
        std::uint64_t part = 0; // > 0: that many samples of the first word
    };

    RenderRequest request;
    DrawableSystem system;
    Projection projection;
    CellSums sums;
    std::unique_ptr<Workers> workers;
    std::vector<ColourCell> colours; // by map, or along the address coordinate
    RenderNote note = RenderNote::None;
    std::vector<ifs::Vector<2>> bent; // rest of a cage that bends, for which the coordinates were chosen
    ifs::Coordinates coordinates = ifs::Coordinates::MeanValue;
    bool drawable = false; // there is something to draw and something to draw on

    // Density
    std::optional<AddressCut> cut;
    std::uint64_t cutOfSet = 0; // the sample set that `cut` was made for
    CutMemory cutMemory;
    SampleSet samples;
    std::uint64_t sampleSets = 0; // drawn so far
    std::vector<std::uint64_t> counts;
    std::vector<Job> jobs;
    std::vector<std::atomic<std::size_t>> nextJobs; // of the share of every thread
    std::uint64_t sinceCarry = 0;

    std::optional<Orbit> orbit; // ChaosGame
    int iterations = 0;         // Deterministic

    std::uint64_t remaining = 0; // of the present pass
    std::uint64_t drawn = 0;
    double overAttractor = 0; // samples as they would be without culling
    int passes = 0;
    std::optional<Exposure> exposure;
    std::uint64_t exposedAt = 0; // of the samples drawn
    double milliseconds = 0;

    void start(RenderRequest newRequest);  // rewind() comes next
    void rewind(int firstRow, int endRow); // nothing drawn yet; counts rows [firstRow, endRow) of the pixels
    ifs::Placement placement();
    RenderNote placementNote() const;
    void makeColours();
    bool finished() const;
    bool interrupted() const { return remaining > 0 || jobsLeft(); }
    bool jobsLeft() const;
    std::size_t endOfJobs(std::size_t share) const { return jobs.size() * (share + 1) / nextJobs.size(); }
    bool complete(const std::stop_token& stop); // the present pass
    bool makeCut(const std::stop_token& stop);
    bool completeDensity(const std::stop_token& stop);
    void planSampleSet();
    void planJobs();
    void runJobs(const std::stop_token& stop);
    void runJob(const Job& job, std::size_t thread);
    bool completeOrbit(const std::stop_token& stop);
    void plotExactly(std::uint32_t k, std::uint64_t count, std::size_t thread);
    bool plot(const ifs::Vector<2>& x, const ColourCell* colour, std::size_t thread);
    bool completePreattractor(const std::stop_token& stop);
    std::vector<ifs::Vector<2>> restPolygon() const;
    const ColourCell& colourOf(std::uint32_t map, double addressCoordinate) const;
    bool coloured() const {
        return request.appearance.colourBy == ColourBy::Map ||
               request.appearance.colourBy == ColourBy::Address;
    }
    double samplesOverAttractor() const {
        return request.algorithm == Algorithm::Density ? overAttractor : static_cast<double>(drawn);
    }
    void measureExposure(const std::stop_token& stop = {});
    ToneSettings toneSettings(const Exposure& shown) const;
    std::uint64_t mostInACell() const;
    // Of the rows that are counted; stopped, of some of them.
    void tonePixels(const Exposure& shown, std::span<std::uint32_t> pixels, const std::stop_token& stop);
    Frame frame(Frame reuse, const std::stop_token& stop, const std::optional<Exposure>& other);
};

} // namespace attractor
