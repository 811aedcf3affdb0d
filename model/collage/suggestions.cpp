// SPDX-License-Identifier: MIT
#include "collage/suggestions.h"

#include "collage/fit/attractor_fit.h"
#include "collage/fit/collage_fit.h"
#include "collage/random_start.h"

#include "animation/morph.h"
#include "attractor/threads/job_shares.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

namespace collage {

namespace {

using Clock = std::chrono::steady_clock;
using Maps = std::vector<ifs::AffineMap<2>>;

// The longer side of the target, in cells, at the three stages, and how many cells the last one may have:
// thin shapes are fitted at a finer scale.
constexpr int coarseSide = 64, mediumSide = 128, fineSide = 512, fineCells = 16'000;
constexpr double levelMargin = 0.25, pictureMargin = 0.25; // margins as shares of the side
// Share of the starts that go on from the coarse level: one in so many.
constexpr std::size_t goingOn = 4;
constexpr std::size_t trialBatches = 3; // batches in which all numbers of maps are tried
constexpr std::size_t finalCounts = 3;  // numbers of maps that are pursued after these batches
constexpr std::size_t poolSize = 24;    // candidates for each number of maps
constexpr double searchShare = 0.5;     // share of the time; the rest refines the best fit
constexpr double pricePerMap = 0.0004;  // share of the target's size
constexpr double maxNorm = 0.9;         // norm of a map in a result
constexpr double alike = 0.05;          // share of the size by which equivalent systems differ at most

struct Candidate {
    Maps maps; // maps of the plane
    double score = 0;
    std::uint64_t start = 0;
    std::vector<double> weights;

    bool operator<(const Candidate& other) const {
        return std::tie(score, start) < std::tie(other.score, other.start);
    }
};

Target level(const Mask& picture, int side) {
    return target(picture, factorFor(picture, side), levelMargin);
}

Target fineLevel(const Mask& picture) {
    const int byArea = int(std::ceil(std::sqrt(double(area(picture)) / fineCells)));
    return target(picture, std::max(byArea, factorFor(picture, fineSide)), levelMargin);
}

Maps inGrid(const Grid& grid, const Maps& maps) {
    Maps result;
    for (const auto& map : maps)
        result.push_back(collage::inGrid(grid, map));
    return result;
}

Maps fromGrid(const Grid& grid, const Maps& maps) {
    Maps result;
    for (const auto& map : maps)
        result.push_back(collage::fromGrid(grid, map));
    return result;
}

// The search itself: starts in batches, so that which of them go on does not depend on the threads.
class Search {
public:
    Search(const Mask& picture, const SearchOptions& options, const std::function<void(double)>& progress,
           const std::stop_token& stop)
        : m_options(options),
          m_progress(progress),
          m_stop(stop),
          m_picture(target(picture, 1, pictureMargin)),
          m_coarse(level(picture, coarseSide)),
          m_medium(level(picture, mediumSide)),
          m_fine(fineLevel(picture)),
          m_workers(std::size_t(std::max(1, options.threads))) {
        for (int maps = options.minMaps; maps <= options.maxMaps; ++maps)
            m_counts.push_back(maps);
        for (std::size_t thread = 0; thread < m_workers.size(); ++thread) {
            m_coarseFits.push_back(std::make_unique<CollageFit>(m_coarse));
            m_mediumFits.push_back(std::make_unique<CollageFit>(m_medium));
        }
    }

    Suggestions run() {
        std::size_t starts = 0;
        while (!m_stop.stop_requested() && !isFull(starts)) {
            const std::size_t count =
                m_options.starts == 0 ? batchSize() : std::min(batchSize(), m_options.starts - starts);
            batch(starts, count);
            starts += count;
            if (starts >= trialBatches * batchSize()) keepPromisingCounts();
            report(searchShare * doneShare(starts));
        }
        Suggestions result;
        result.starts = starts;
        result.list = distinct(refined(shortlist()));
        return result;
    }

private:
    std::size_t batchSize() const { return m_counts.size() * (m_counts.size() == 1 ? 32 : 8); }
    double doneShare(std::size_t starts) const {
        return m_options.starts > 0 ? double(starts) / double(m_options.starts)
                                    : (Clock::now() - m_begin) / (searchShare * m_options.time);
    }
    bool isFull(std::size_t starts) const { return starts > 0 && doneShare(starts) >= 1; }
    void report(double share) const {
        if (m_progress) m_progress(std::min(1.0, share));
    }
    void inParallel(std::size_t jobs, const std::function<void(std::size_t, std::size_t)>& work) {
        attractor::JobShares shares;
        shares.reset(jobs, m_workers);
        shares.run(m_workers, m_stop, work);
    }

    Candidate begun(std::uint64_t start, int maps, CollageFit& fit) const;
    void keepPromisingCounts();
    void goOn(Candidate& candidate, CollageFit& fit) const;
    void batch(std::size_t first, std::size_t count);
    std::vector<Candidate> shortlist() const;
    std::vector<Candidate> refined(std::vector<Candidate> candidates);
    std::vector<Suggestion> distinct(const std::vector<Candidate>& candidates);
    double price(const Target& target, const Maps& maps) const;
    Suggestion suggestion(const Candidate& candidate) const;

    const SearchOptions& m_options;
    const std::function<void(double)>& m_progress;
    const std::stop_token& m_stop;
    Clock::time_point m_begin = Clock::now();
    Target m_picture, m_coarse, m_medium, m_fine;
    attractor::Workers m_workers;
    std::vector<std::unique_ptr<CollageFit>> m_coarseFits, m_mediumFits; // one for each thread
    std::vector<int> m_counts;                                           // numbers of maps still being tried
    std::map<std::size_t, std::vector<Candidate>> m_pools; // candidates by number of maps, best first
};

// Returns true for every other of the starts of each number of maps, whatever the batches.
bool isLed(std::uint64_t start) {
    return (start * 0x9E3779B97F4A7C15 >> 40) % 2 == 0;
}

// E/(1 − s), so that maps near the identity, whose collage is good and whose attractor is not, do not win.
double score(double error, const Target& target, const Maps& maps) {
    return error * target.grid.cell / (1 - contraction(maps));
}

// Leaves the rest of the starts to the best numbers of maps, once each number has had its chance.
void Search::keepPromisingCounts() {
    if (m_counts.size() <= finalCounts) return;
    const auto bestScore = [this](int maps) {
        const std::vector<Candidate>& pool = m_pools[std::size_t(maps)];
        return pool.empty() ? HUGE_VAL : pool.front().score + pricePerMap * m_picture.size * maps;
    };
    std::ranges::stable_sort(m_counts, std::less<>(), bestScore);
    m_counts.resize(finalCounts);
    std::ranges::sort(m_counts);
    std::erase_if(m_pools, [this](const auto& pool) {
        return std::ranges::find(m_counts, int(pool.first)) == m_counts.end();
    });
}

Candidate Search::begun(std::uint64_t start, int count, CollageFit& fit) const {
    Maps maps = isLed(start) ? ledStart(m_coarse, count, m_options.constraints, m_options.seed, start)
                             : randomStart(m_coarse, count, m_options.constraints, m_options.seed, start);
    fit.improve(maps, {m_options.constraints, 25, isLed(start) ? 0 : 15, 0.75, maxNorm});
    return {fromGrid(m_coarse.grid, maps), score(fit.error(maps), m_coarse, maps), start, {}};
}

void Search::goOn(Candidate& candidate, CollageFit& fit) const {
    Maps maps = inGrid(m_medium.grid, candidate.maps);
    fit.improve(maps, {m_options.constraints, 15, 0, maxNorm, maxNorm});
    fit.error(maps);
    candidate.weights = ifs::shares(fit.shares(), 0.01);
    candidate.maps = fromGrid(m_medium.grid, maps);
    candidate.score = visibleError(m_medium, attractorAgreement(m_medium, candidate.maps));
}

void Search::batch(std::size_t first, std::size_t count) {
    std::vector<Candidate> begun(count);
    inParallel(count, [&](std::size_t job, std::size_t thread) {
        begun[job] = this->begun(first + job, m_counts[job % m_counts.size()], *m_coarseFits[thread]);
    });
    std::map<std::size_t, std::vector<Candidate>> byMaps;
    for (Candidate& candidate : begun)
        byMaps[candidate.maps.size()].push_back(std::move(candidate));
    std::vector<Candidate> going;
    for (auto& [maps, candidates] : byMaps) {
        std::ranges::sort(candidates, std::less<>());
        candidates.resize((candidates.size() + goingOn - 1) / goingOn);
        std::ranges::move(candidates, std::back_inserter(going));
    }
    inParallel(going.size(),
               [&](std::size_t job, std::size_t thread) { goOn(going[job], *m_mediumFits[thread]); });
    if (m_stop.stop_requested()) return;
    for (Candidate& candidate : going)
        m_pools[candidate.maps.size()].push_back(std::move(candidate));
    for (auto& [maps, pool] : m_pools) {
        std::ranges::sort(pool, std::less<>());
        pool.resize(std::min(pool.size(), poolSize));
    }
}

// Returns true if two of Candidate or Suggestion are near each other.
bool areNear(const auto& a, const auto& b, double size) {
    const auto found = animation::correspondence<2>({a.maps, a.weights, {}}, {b.maps, b.weights, {}});
    return found && found->total < alike * alike * size * size;
}

std::vector<Candidate> Search::shortlist() const {
    const std::size_t each = m_counts.size() == 1 ? 8 : 4;
    std::vector<Candidate> list;
    for (const auto& [maps, pool] : m_pools) {
        std::vector<Candidate> distinct;
        for (const Candidate& candidate : pool) {
            const bool isKnown = std::ranges::any_of(
                distinct, [&](const Candidate& other) { return areNear(candidate, other, m_picture.size); });
            if (!isKnown && distinct.size() < each) distinct.push_back(candidate);
        }
        std::ranges::move(distinct, std::back_inserter(list));
    }
    return list;
}

double Search::price(const Target& target, const Maps& maps) const {
    return visibleError(target, attractorAgreement(target, maps)) +
           pricePerMap * m_picture.size * double(maps.size());
}

// First all of them on the medium level, then the best on the fine one.
std::vector<Candidate> Search::refined(std::vector<Candidate> candidates) {
    inParallel(candidates.size(), [&](std::size_t job, std::size_t thread) {
        Candidate& one = candidates[job];
        one.maps = fittedAttractor(m_medium, one.maps, {m_options.constraints, 8, maxNorm}, {}, m_stop);
        one.score = price(m_medium, one.maps);
        if (thread == 0) report(searchShare + 0.2 * double(job + 1) / double(candidates.size()));
    });
    std::ranges::sort(candidates, std::less<>());
    candidates.resize(std::min(candidates.size(), m_options.maxResults));
    inParallel(candidates.size(), [&](std::size_t job, std::size_t) {
        Candidate& one = candidates[job];
        one.maps = fittedAttractor(m_fine, one.maps, {m_options.constraints, 3, maxNorm}, {}, m_stop);
        one.score = price(m_fine, one.maps);
    });
    std::ranges::sort(candidates, std::less<>());
    report(searchShare + 0.35);
    return candidates;
}

Suggestion Search::suggestion(const Candidate& candidate) const {
    CollageFit fit(m_medium);
    fit.error(inGrid(m_medium.grid, candidate.maps));
    return {candidate.maps, ifs::shares(fit.shares(), 0.01), collageMeasure(m_picture, candidate.maps),
            attractorAgreement(m_picture, candidate.maps)};
}

std::vector<Suggestion> Search::distinct(const std::vector<Candidate>& candidates) {
    std::vector<Suggestion> all(candidates.size());
    inParallel(all.size(), [&](std::size_t job, std::size_t) { all[job] = suggestion(candidates[job]); });
    if (m_stop.stop_requested()) return {};
    std::vector<Suggestion> list;
    for (Suggestion& one : all) {
        const bool isKnown = std::ranges::any_of(
            list, [&](const Suggestion& other) { return areNear(one, other, m_picture.size); });
        if (!isKnown) list.push_back(std::move(one));
    }
    return list;
}

} // namespace

bool isAlike(const Suggestion& a, const Suggestion& b, double size) {
    return areNear(a, b, size);
}

Suggestions suggestions(const Mask& picture, const SearchOptions& options,
                        const std::function<void(double)>& progress, const std::stop_token& stop) {
    return Search(picture, options, progress, stop).run();
}

} // namespace collage
