// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cut/address_cut.h"
#include "attractor/folds/picture_part.h"
#include "attractor/folds/sum_fold.h"
#include "attractor/kernels/sample_set.h"
#include "attractor/samples/address_strata.h"
#include "attractor/threads/job_shares.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace attractor {

// Number of words of the cut for a pass of `samples` samples: none takes more of a sample set than there is.
int wordsFor(std::uint64_t samples);

// Number of sample sets into which a pass of `samples` samples is divided.
std::uint64_t sampleSetsFor(std::uint64_t samples, const PreparedSystem& system);

// Algorithm::Density: every word of the cut takes its part of sample sets of the invariant measure.
class DensityFold : public SumFold {
public:
    explicit DensityFold(const PreparedRequest& prepared) : SumFold(prepared) {}

    void start(Workers& workers) override;
    void rewind(const CellWindow& window) override;
    bool complete(const std::stop_token& stop) override;
    bool interrupted() const override { return SumFold::interrupted() || m_shares.left(); }
    bool finished() const override { return m_cut && m_cut->words.empty(); }
    double samplesOverAttractor() const override { return m_overAttractor; }
    const std::optional<AddressCut>& cut() const { return m_cut; } // cut of the newest sample set

    // Restricts gathering to the units of the part, from the next sample set on. samples(),
    // samplesOverAttractor() and exposure() remain those of the whole picture. rewind() makes it whole again.
    void setPart(const PicturePart& part) { m_part = part; }
    using SumFold::sums; // public, so that sums of other parts can be added
    double measure() const override { return m_cut ? m_cut->probability : 1; }

protected:
    std::span<const ColourCell> layers() const override;

private:
    // A run of m_order, or a part of a single word with very many samples.
    struct Job {
        std::uint32_t firstWord = 0;
        std::uint32_t endWord = 0;
        std::uint64_t part = 0; // > 0: that many samples of the first word
        std::size_t place = 0;  // place of the sample set
    };

    struct SampleSetKey {
        std::uint64_t seed = 0;
        std::uint64_t number = 0;
        friend bool operator==(const SampleSetKey&, const SampleSetKey&) = default;
    };

    CutSettings cutSettings() const;
    bool makeFirstCut(const std::stop_token& stop);
    bool makeCut(const std::stop_token& stop);
    // Sample sets that are counted together:
    SampleSetKey keyOf(std::size_t place) const { return {prepared().request().seed, m_sampleSets + place}; }
    bool holdsSampleSet(std::size_t place) const;
    bool isInPart(std::size_t place) const;
    void makePlaces(std::size_t sets);
    void drawSampleSet(std::size_t place);
    void drawSampleSets();
    const SampleSet& samplesOf(std::size_t word, std::size_t place) const {
        return m_samples[place + m_cut->sampleSet(word)]; // linked maps share one place
    }
    std::uint64_t countOf(std::size_t word, std::size_t place) const {
        return m_counts[place * m_cut->words.size() + word];
    }
    void planSampleSets();
    void planSampleSet(std::size_t place);
    void orderWords();
    void planJobs();
    void runJob(const Job& job, std::size_t thread);
    void countWord(std::uint32_t k, std::size_t place, std::uint64_t count, std::size_t thread);
    void plotExactly(std::uint32_t k, const SampleSet& samples, std::uint64_t count, std::size_t thread);

    std::optional<AddressCut> m_cut;
    std::uint64_t m_cutOfSet = 0; // sample set for which m_cut was made
    CutMemory m_cutMemory;
    AddressStrata m_strata;
    // Sample sets by place; for linked maps, as many as AddressCut::sampleSets distinguishes.
    std::vector<SampleSet> m_samples;
    std::vector<std::optional<SampleSetKey>> m_drawn; // keys of m_samples, without links
    std::uint64_t m_sampleSets = 0;                   // sample sets planned so far
    std::size_t m_together = 0;                       // number of places in use
    std::vector<std::uint64_t> m_counts;              // samples of each word, place by place
    std::vector<std::uint32_t> m_order;               // words in the order of counting
    std::vector<Job> m_jobs;
    JobShares m_shares;
    double m_overAttractor = 0;
    PicturePart m_part;
};

} // namespace attractor
