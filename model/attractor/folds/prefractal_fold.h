// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/sum_fold.h"

#include <vector>

namespace attractor {

// Algorithm::Deterministic: the images of the rest cage under Wⁿ, in one pass.
class PrefractalFold : public SumFold {
public:
    explicit PrefractalFold(const PreparedRequest& prepared) : SumFold(prepared) {}

    void start(Workers& workers) override;
    void rewind(const CellWindow& window) override;
    bool complete(const std::stop_token& stop) override;
    bool finished() const override { return m_isDrawn; }
    int iterations() const override { return m_iterations; }
    RenderNote note() const override; // None or FewerIterations

    bool hasFixedExposure() const override { return true; }
    std::optional<Exposure> exposure(const std::stop_token& stop) override;

protected:
    double densityPerSample(const Exposure& exposure) const override;
    std::uint64_t maxInACell() const override { return 1U << 20; }

private:
    std::vector<ifs::Vector<2>> polygon() const; // rest cage, or else the box of the system

    int m_iterations = 0;
    bool m_isDrawn = false;
};

} // namespace attractor
