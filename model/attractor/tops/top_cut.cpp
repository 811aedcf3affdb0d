// SPDX-License-Identifier: MIT
#include "attractor/tops/top_cut.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace attractor {

namespace {

constexpr double finest = 0.5; // pixels

// nullopt when there are more words, or when stopped.
std::optional<std::vector<TopWord>> wordsOf(const CoupledSystem& system, const Camera& camera, double size,
                                            std::size_t maxWords, const std::stop_token& stop) {
    std::vector<TopWord> done, open;
    const std::size_t maps = system.from.size();
    const std::size_t maxLooks = 64 * (maxWords + maps);
    open.push_back({worldToPixel(camera), {}});
    for (std::size_t looks = 0; !open.empty(); ++looks) {
        if (looks > maxLooks || (looks % 1024 == 0 && stop.stop_requested())) return std::nullopt;
        TopWord word = open.back();
        open.pop_back();
        word.box = boxOf(word.shown, system.around);
        if (!word.box.meets(camera.width, 0, camera.height)) continue;
        if (word.box.size() <= size) {
            if (done.size() == maxWords) return std::nullopt;
            done.push_back(word);
            continue;
        }
        if (open.size() + maps > maxLooks) return std::nullopt;
        const double step = word.step / double(maps);
        for (std::size_t i = maps; i-- > 0;) // the first map comes last, on top
            open.push_back({word.shown * system.from[i], word.to * system.to[i],
                            word.address + double(i) * step, step, word.areaRatio * system.areaRatios[i]});
    }
    return done;
}

} // namespace

TopCut topCut(const CoupledSystem& system, const Camera& camera, std::size_t maxWords,
              const std::stop_token& stop) {
    const double whole = boxOf(worldToPixel(camera), system.around).size();
    TopCut best{{}, whole};
    for (double size = whole; size >= finest && std::isfinite(size); size /= std::sqrt(2.0)) {
        auto words = wordsOf(system, camera, size, maxWords, stop);
        if (!words) break;
        best = {std::move(*words), size};
    }
    if (best.words.empty() && !stop.stop_requested())
        if (auto words = wordsOf(system, camera, std::max(whole, finest), 1, stop)) best.words = *words;
    return best;
}

} // namespace attractor
