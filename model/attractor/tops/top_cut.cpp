// SPDX-License-Identifier: MIT
#include "attractor/tops/top_cut.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace attractor {

namespace {

constexpr double finest = 0.5; // pixels

// nullopt when there are more words, or when stopped.
std::optional<TopCut> cutOf(const CoupledSystem& system, const Camera& camera, double size,
                            std::size_t maxWords, const std::stop_token& stop) {
    TopCut result;
    result.size = size;
    std::vector<TopWord>& done = result.words;
    std::vector<TopWord> open;
    const std::size_t maps = system.from.size();
    const std::size_t maxVisits = 64 * (maxWords + maps);
    open.push_back({worldToPixel(camera)});
    for (std::size_t visits = 0; !open.empty(); ++visits) {
        if (visits > maxVisits || (visits % 1024 == 0 && stop.stop_requested())) return std::nullopt;
        TopWord word = open.back();
        open.pop_back();
        word.box = boxOf(word.shown, system.around);
        if (!word.box.meets(camera.width, 0, camera.height)) continue;
        if (word.box.size() <= size) {
            if (done.size() == maxWords) return std::nullopt;
            done.push_back(word);
            continue;
        }
        if (open.size() + maps > maxVisits) return std::nullopt;
        const double step = word.step / double(maps);
        for (std::size_t i = maps; i-- > 0;) // first map last, on top
            open.push_back({word.shown * system.from[i], result.tree.longer(word.number, i),
                            word.address + double(i) * step, step});
    }
    return result;
}

} // namespace

TopCut topCut(const CoupledSystem& system, const Camera& camera, std::size_t maxWords,
              const std::stop_token& stop) {
    const double whole = boxOf(worldToPixel(camera), system.around).size();
    TopCut best;
    best.size = whole;
    for (double size = whole; size >= finest && std::isfinite(size); size /= std::sqrt(2.0)) {
        auto cut = cutOf(system, camera, size, maxWords, stop);
        if (!cut) break;
        best = std::move(*cut);
    }
    if (best.words.empty() && !stop.stop_requested())
        if (auto cut = cutOf(system, camera, std::max(whole, finest), 1, stop)) {
            cut->size = best.size;
            best = std::move(*cut);
        }
    return best;
}

} // namespace attractor
