// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/prepared_request.h"
#include "attractor/kernels/cells.h"
#include "attractor/light/tone_map.h"
#include "attractor/light/tone_map16.h"
#include "attractor/request/render_request.h"
#include "attractor/threads/workers.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

namespace attractor {

// picture = fold(⊕, camera · cage · w_σ · sample): a commutative, associative ⊕ gathers the samples of each
// cell, so that neither order nor threads change a byte, and the result becomes light. A picture is drawn in
// passes, each of which may be stopped and completed later. Not thread-safe; uses a team of workers.
class Fold {
public:
    Fold() = default;
    Fold(const Fold&) = delete;
    Fold& operator=(const Fold&) = delete;
    virtual ~Fold() = default;

    // Prepares for the current state of the prepared request, reusing memory. Call rewind() next.
    virtual void start(Workers& workers) = 0;
    // Empties the picture; from now on samples in the window are gathered.
    virtual void rewind(const CellWindow& window) = 0;

    // Begins the next pass, of `samples` samples; the one before is complete.
    virtual void begin(std::uint64_t samples) = 0;
    // The rest of the pass. False when stopped, within milliseconds.
    virtual bool complete(const std::stop_token& stop) = 0;
    virtual bool interrupted() const = 0; // true within a pass
    virtual bool finished() const = 0;    // true when further passes gain nothing

    virtual std::uint64_t samples() const = 0; // samples drawn since rewind()
    // Samples as they would be if those outside the view were drawn as well.
    virtual double samplesOverAttractor() const = 0;
    // The measure of the words that meet the view, estimated.
    virtual double measure() const { return 1; }
    virtual int iterations() const { return 0; } // steps drawn; 0 for algorithms without steps
    // The reason why the picture is incomplete, if it is.
    virtual RenderNote note() const { return RenderNote::None; }

    // Returns true if exposure() is the same for every picture and known before anything is drawn.
    virtual bool hasFixedExposure() const { return false; }
    // The exposure, measured once and kept for the passes to come. nullopt when stopped.
    virtual std::optional<Exposure> exposure(const std::stop_token& stop) = 0;
    virtual Occupancy
    occupancy(double share) const = 0; // share of occupied pixels in the window; see attractor::occupancy

    // The pixels of the window. False when stopped, within milliseconds: then of some of its rows.
    virtual bool tone(const Exposure& exposure, std::span<std::uint32_t> pixels,
                      const std::stop_token& stop) const = 0;
    virtual bool tone(const Exposure& exposure, std::span<Rgba16> pixels,
                      const std::stop_token& stop) const = 0;
};

} // namespace attractor
