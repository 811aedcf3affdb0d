// SPDX-License-Identifier: MIT
#include "attractor/folds/density_fold.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/cells/splat.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/samples/linked_samples.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace attractor {

namespace {

constexpr std::uint64_t maxPerSampleSet = 1U << 24;           // samples; further ones come from a new set
constexpr std::uint64_t maxUninstanced = 2 * SampleSet::size; // limit of a single word
constexpr std::uint64_t samplesPerJob = 1U << 16;             // samples between two checks of the stop token
// Sample sets that are counted word by word, while the cells of the word are in the cache.
constexpr std::uint64_t setsTogether = 8;

double unitInterval(std::uint64_t random) {
    return static_cast<double>(random >> 11) * 0x1p-53;
}

std::uint64_t maxPerSet(const PreparedSystem& system) {
    return system.meanLogarithm < 0 ? maxPerSampleSet : maxUninstanced;
}

} // namespace

int wordsFor(std::uint64_t samples) {
    return static_cast<int>(std::clamp<std::uint64_t>(samples / SampleSet::size, 128, 4096));
}

std::uint64_t sampleSetsFor(std::uint64_t samples, const PreparedSystem& system) {
    return samples / maxPerSet(system) + (samples % maxPerSet(system) > 0 ? 1 : 0);
}

void DensityFold::start(Workers& workers) {
    SumFold::start(workers);
    m_cut.reset();
}

void DensityFold::rewind(const CellWindow& window) {
    SumFold::rewind(window);
    m_jobs.clear();
    m_shares.clear();
    m_sampleSets = 0;
    m_together = 0;
    m_overAttractor = 0;
    m_part = {};
}

bool DensityFold::complete(const std::stop_token& stop) {
    if (!m_cut && !makeFirstCut(stop)) return false;
    while (true) {
        m_shares.run(workers(), stop,
                     [this](std::size_t job, std::size_t thread) { runJob(m_jobs[job], thread); });
        if (m_shares.left()) return false;
        if (remaining() == 0) return true;
        if (!makeCut(stop)) return false;
        if (m_cut->words.empty()) {
            settle(remaining(), 0);
            return true;
        }
        planSampleSets();
    }
}

std::span<const ColourCell> DensityFold::layers() const {
    const std::span<const ColourCell> colours = prepared().mapColours();
    return colours.size() <= CellSums::maxLayers ? colours : std::span<const ColourCell>();
}

CutSettings DensityFold::cutSettings() const {
    const RenderRequest& request = prepared().request();
    const PreparedSystem& system = prepared().system();
    CutSettings settings;
    settings.words = wordsFor(request.samples);
    settings.seed = m_sampleSets == 0 ? request.seed : mixed(request.seed) + m_sampleSets;
    settings.samples = static_cast<double>(request.samples);
    settings.colours = prepared().coordinates();
    const ColourBy colourBy = request.appearance.colourBy;
    settings.mergesCoinciding = system.coincides && !prepared().coloured();
    if (colourBy == ColourBy::Map) settings.minDepth = 1;
    // With blends the cut divides words that need it, unless no word may be longer than the others.
    if (colourBy == ColourBy::Address || (colourBy == ColourBy::Blend && !(system.meanLogarithm < 0)))
        for (std::size_t words = 1; words < 64 && system.maps.size() > 1; words *= system.maps.size())
            ++settings.minDepth;
    if (!(system.meanLogarithm < 0)) settings.maxDepth = settings.minDepth;
    // Limits the search without an attractor: some words of every length grow, so that none becomes small
    // enough.
    if (system.note != RenderNote::None) settings.maxLooks = 1U << 20;
    return settings;
}

// Cuts for the next sample set. Words that stand for others are chosen anew, so that all get their turn.
bool DensityFold::makeCut(const std::stop_token& stop) {
    if (m_cut && (!m_cut->isThinned || m_cutOfSet == m_sampleSets)) return true;
    AddressCut fresh =
        addressCut(prepared().system(), prepared().projection(), cutSettings(), stop, &m_cutMemory);
    if (stop.stop_requested()) return false;
    // Words may be so deep that their measure underflows, if a map does not contract.
    if (fresh.probability < std::numeric_limits<double>::min()) fresh = {};
    m_cut = std::move(fresh);
    m_cutOfSet = m_sampleSets;
    return true;
}

// Makes the first cut: while one thread walks the address tree, another finds the strata and draws the
// samples.
bool DensityFold::makeFirstCut(const std::stop_token& stop) {
    const PreparedSystem& system = prepared().system();
    if (workers().size() < 2 || system.isLinked() || system.note != RenderNote::None || holdsSampleSet(0))
        return makeCut(stop);
    bool made = false;
    workers().run([&](std::size_t thread) {
        if (thread == 0) made = makeCut(stop);
        if (thread == 1) {
            makePlaces(1);
            drawSampleSet(0);
        }
    });
    return made;
}

// Returns true if the samples of an earlier picture can be used again: only the cage or the view has moved.
bool DensityFold::holdsSampleSet(std::size_t place) const {
    return place < m_drawn.size() && m_drawn[place] == keyOf(place) && m_strata.isOf(prepared().system());
}

void DensityFold::makePlaces(std::size_t sets) {
    if (!m_strata.isOf(prepared().system())) {
        m_drawn.clear();
        m_strata.follow(prepared().system());
    }
    m_samples.resize(std::max(m_samples.size(), sets));
    m_drawn.resize(m_samples.size());
}

void DensityFold::drawSampleSet(std::size_t place) {
    if (holdsSampleSet(place)) return;
    const SampleSetKey key = keyOf(place);
    m_drawn[place].reset();
    drawSamples(prepared().system(), key.seed, key.number, m_samples[place], &m_strata);
    m_drawn[place] = key;
}

// Draws the sample sets of which something is counted.
void DensityFold::drawSampleSets() {
    const PreparedSystem& system = prepared().system();
    if (system.isLinked()) {
        if (!isInPart(0)) return;
        m_samples.resize(1 + std::ranges::max(system.sampleSetOf));
        drawLinkedSamples(system, prepared().request().seed, m_sampleSets, m_samples);
        m_drawn.clear();
        return;
    }
    makePlaces(m_together);
    std::vector<std::size_t> missing;
    for (std::size_t place = 0; place < m_together; ++place)
        if (isInPart(place) && !holdsSampleSet(place)) missing.push_back(place);
    if (missing.empty()) return;
    workers().run([&](std::size_t thread) {
        for (std::size_t k = thread; k < missing.size(); k += workers().size())
            drawSampleSet(missing[k]);
    });
}

bool DensityFold::isInPart(std::size_t place) const {
    const std::uint64_t firstUnit = (m_sampleSets + place) * PicturePart::unitsPerSet;
    return m_part.meets(firstUnit, firstUnit + PicturePart::unitsPerSet);
}

// Plans as many sample sets as one cut and one set of places allow.
void DensityFold::planSampleSets() {
    const std::uint64_t most = maxPerSet(prepared().system());
    const bool single = m_cut->isThinned || prepared().system().isLinked();
    m_together = single ? 1 : std::min(setsTogether, sampleSetsFor(remaining(), prepared().system()));
    makeRoomFor(std::min(remaining(), m_together * most));
    drawSampleSets();
    m_counts.clear();
    for (std::size_t place = 0; place < m_together; ++place)
        planSampleSet(place);
    planJobs();
    m_sampleSets += m_together;
}

// Systematic rounding: word k gets the whole numbers between two partial sums, so that its expectation is
// exact.
void DensityFold::planSampleSet(std::size_t place) {
    const std::uint64_t seed = prepared().request().seed;
    const std::uint64_t set = m_sampleSets + place;
    const std::uint64_t number = std::min(remaining(), maxPerSet(prepared().system()));
    const bool inPart = isInPart(place);
    const double perMeasure = static_cast<double>(number) / m_cut->probability;
    double sum = unitInterval(mixed(mixed(seed) ^ set));
    std::uint64_t before = 0;
    const CellWindow& window = sums().window();
    const bool whole = window.firstRow <= 0 && window.endRow >= prepared().projection().grid.height;
    for (std::size_t k = 0; k < m_cut->words.size(); ++k) {
        sum += m_cut->words[k].probability * perMeasure;
        const auto after = static_cast<std::uint64_t>(sum);
        const std::uint64_t unit =
            set * PicturePart::unitsPerSet + k * PicturePart::unitsPerSet / m_cut->words.size();
        // A word does not tell where its samples may fall if they go through the cage one by one.
        const auto isMet = [&] {
            return whole || k >= m_cut->firstExact || meets(m_cut->shown(k), samplesOf(k, place), window);
        };
        m_counts.push_back(inPart && m_part.holds(unit) && isMet() ? after - before : 0);
        counted(m_counts.back());
        before = after;
    }
    m_overAttractor += perMeasure;
    settle(number, before);
}

// Orders the words from the top of the picture to its bottom, so that every thread meets few tiles that
// others meet as well: each of them has to be cleared and added up once per thread. The order changes no sum.
void DensityFold::orderWords() {
    constexpr std::size_t bands = 256;
    const CellWindow& window = sums().window();
    const float perRow = bands / static_cast<float>(std::max(1, window.endRow - window.firstRow));
    const auto bandOf = [&](const Word& word) {
        const float band = (word.y - static_cast<float>(window.firstRow)) * perRow;
        if (!(band > 0)) return std::size_t{0};
        return band < bands ? static_cast<std::size_t>(band) : bands - 1;
    };
    const auto words = static_cast<std::uint32_t>(m_cut->words.size());
    std::array<std::uint32_t, bands + 1> next{};
    for (const Word& word : m_cut->words)
        ++next[bandOf(word) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    m_order.resize(words);
    for (std::uint32_t k = 0; k < words; ++k)
        m_order[next[bandOf(m_cut->words[k])]++] = k;
}

void DensityFold::planJobs() {
    orderWords();
    m_jobs.clear();
    Job job;
    std::uint64_t planned = 0;
    const auto close = [&](std::size_t end) {
        job.endWord = static_cast<std::uint32_t>(end);
        if (job.endWord > job.firstWord) m_jobs.push_back(job);
        job.firstWord = job.endWord;
        planned = 0;
    };
    for (std::size_t at = 0; at < m_order.size(); ++at) {
        std::uint64_t most = 0;
        for (std::size_t place = 0; place < m_together; ++place) {
            const std::uint64_t count = countOf(m_order[at], place);
            most = std::max(most, count);
            planned += count;
        }
        if (most > samplesPerJob) {
            close(at);
            for (std::size_t place = 0; place < m_together; ++place)
                for (std::uint64_t rest = countOf(m_order[at], place); rest > 0;
                     rest -= std::min(rest, samplesPerJob))
                    m_jobs.push_back(
                        {job.firstWord, job.firstWord + 1, std::min(rest, samplesPerJob), place});
            ++job.firstWord;
            continue;
        }
        if (planned >= samplesPerJob) close(at + 1);
    }
    close(m_order.size());
    m_shares.reset(m_jobs.size(), workers());
}

void DensityFold::runJob(const Job& job, std::size_t thread) {
    for (std::uint32_t at = job.firstWord; at < job.endWord; ++at) {
        if (job.part > 0) {
            countWord(m_order[at], job.place, job.part, thread);
            continue;
        }
        for (std::size_t place = 0; place < m_together; ++place)
            countWord(m_order[at], place, countOf(m_order[at], place), thread);
    }
}

void DensityFold::countWord(std::uint32_t k, std::size_t place, std::uint64_t count, std::size_t thread) {
    if (count == 0) return;
    const SampleSet& samples = samplesOf(k, place);
    if (k >= m_cut->firstExact) {
        plotExactly(k, samples, count, thread);
        return;
    }
    const CellWindow& window = sums().window();
    const ShownWord shown = m_cut->shown(k);
    const CellRegion cells = reachedCells(shown, samples, window);
    if (!prepared().coloured()) {
        splat(shown, samples, count, window, sums().counts(thread, cells));
        return;
    }
    const Word& word = shown.word;
    if (sums().layered()) {
        splat(shown, samples, count, window, sums().layer(thread, word.firstMap, cells));
        return;
    }
    const ColourCell& colour = prepared().colourOf(word.firstMap, word.addressCoordinate);
    if (splat(shown, samples, count, window, colour, sums().colours(thread, cells)))
        sums().carryOverColours(thread);
}

// The samples of a word that bends too much for a second-order map, in coordinates of the code.
void DensityFold::plotExactly(std::uint32_t k, const SampleSet& samples, std::uint64_t count,
                              std::size_t thread) {
    const Word& word = m_cut->words[k];
    const ifs::AffineMap<2>& map = m_cut->exact[k - m_cut->firstExact];
    std::uint32_t* const layer = sums().layered() ? sums().layer(thread, word.firstMap) : nullptr;
    const ColourCell* colour =
        prepared().coloured() ? &prepared().colourOf(word.firstMap, word.addressCoordinate) : nullptr;
    for (std::uint64_t n = 0; n < count; ++n) {
        const std::size_t at = word.offset + static_cast<std::size_t>(n % SampleSet::size);
        const ifs::Vector<2> x = map({samples.x[at], samples.y[at]});
        if (layer == nullptr)
            plot(x, colour, thread);
        else if (const auto cell = cellOf(x))
            ++layer[*cell];
    }
}

} // namespace attractor
