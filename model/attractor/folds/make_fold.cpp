// SPDX-License-Identifier: MIT
#include "attractor/folds/make_fold.h"

#include "attractor/folds/chaos_game_fold.h"
#include "attractor/folds/density_fold.h"
#include "attractor/folds/prefractal_fold.h"

namespace attractor {

std::unique_ptr<Fold> makeFold(Algorithm algorithm, const PreparedRequest& prepared) {
    switch (algorithm) {
    case Algorithm::ChaosGame:
        return std::make_unique<ChaosGameFold>(prepared);
    case Algorithm::Deterministic:
        return std::make_unique<PrefractalFold>(prepared);
    case Algorithm::Density:
        break;
    }
    return std::make_unique<DensityFold>(prepared);
}

} // namespace attractor
