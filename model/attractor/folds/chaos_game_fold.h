// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/folds/sum_fold.h"
#include "attractor/samples/chaos_game.h"

#include <optional>

namespace attractor {

// Algorithm::ChaosGame: the points of one orbit, on the calling thread.
class ChaosGameFold : public SumFold {
public:
    explicit ChaosGameFold(const PreparedRequest& prepared) : SumFold(prepared) {}

    void rewind(const CellWindow& window) override;
    void begin(std::uint64_t samples) override; // counts only samples that the request still wants
    bool complete(const std::stop_token& stop) override;
    bool finished() const override { return samples() >= prepared().request().samples; }

private:
    std::optional<Orbit> m_orbit;
};

} // namespace attractor
