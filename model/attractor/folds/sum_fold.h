// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/folds/fold.h"

#include <cstddef>

namespace attractor {

// ⊕ = +: samples and their colours add up, and densities become light.
class SumFold : public Fold {
public:
    void start(Workers& workers) override;
    void rewind(const CellWindow& window) override;

    void begin(std::uint64_t samples) override { m_remaining = samples; }
    bool interrupted() const override { return m_remaining > 0; }

    std::uint64_t samples() const override { return m_drawn; }
    double samplesOverAttractor() const override { return static_cast<double>(m_drawn); }

    std::optional<Exposure> exposure(const std::stop_token& stop) override;
    Occupancy occupancy(double share) const override;
    bool tone(const Exposure& exposure, std::span<std::uint32_t> pixels,
              const std::stop_token& stop) const override;
    bool tone(const Exposure& exposure, std::span<Rgba16> pixels, const std::stop_token& stop) const override;

    const CellSums& sums() const { return m_sums; }

protected:
    explicit SumFold(const PreparedRequest& prepared) : m_prepared(prepared) {}

    const PreparedRequest& prepared() const { return m_prepared; }
    Workers& workers() const { return *m_workers; }
    CellSums& sums() { return m_sums; }

    std::uint64_t remaining() const { return m_remaining; } // samples left in the present pass
    // Marks `samples` of the current pass as done, of which `drawn` are in the sums.
    void settle(std::uint64_t samples, std::uint64_t drawn);

    // Carries counters over if any could wrap before `samples` more are counted.
    void makeRoomFor(std::uint64_t samples);
    void counted(std::uint64_t samples) { m_sinceCarry += samples; }
    // The colours of all samples where there are few enough to count each on its own; see CellSums.
    virtual std::span<const ColourCell> layers() const { return {}; }
    // The cell of a point of the code, if it is in the window.
    std::optional<std::size_t> cellOf(const ifs::Vector<2>& x) const;
    // Counts one point of the code, with its colour where samples have one; not in layers.
    void plot(const ifs::Vector<2>& x, const ColourCell* colour, std::size_t thread);

    void forgetExposure() { m_exposure.reset(); }
    // ρ of a cell that holds one sample.
    virtual double densityPerSample(const Exposure& exposure) const;
    virtual std::uint64_t maxInACell() const { return m_drawn; }

private:
    ToneSettings toneSettings(const Exposure& exposure) const;
    template <class Tones, class Pixel>
    bool toneRows(const Tones& tones, std::span<Pixel> pixels, const std::stop_token& stop) const;

    const PreparedRequest& m_prepared;
    Workers* m_workers = nullptr;
    CellSums m_sums;
    std::uint64_t m_remaining = 0;
    std::uint64_t m_drawn = 0;
    std::uint64_t m_sinceCarry = 0;
    std::optional<Exposure> m_exposure;
};

} // namespace attractor
