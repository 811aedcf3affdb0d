// SPDX-License-Identifier: MIT
#include "ifs/links/linked_existence.h"

#include "ifs/existence/common_matrix.h"
#include "ifs/existence/exact_matrix.h"
#include "ifs/existence/expansion.h"
#include "ifs/linear/rounding.h"
#include "ifs/system/link_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace ifs {

namespace {

// Words are lengthened at their inner end until they contract. When all have, any admissible word is a
// product of words that do, and of a rest of bounded length.
template <int Dim> class WordSearch {
public:
    WordSearch(const ActiveMaps<Dim>& active, int maxProducts) : m_active(active), m_left(maxProducts) {}

    // Verdict on the words of these maps, which no other map may follow.
    Existence result(const std::vector<std::size_t>& maps) {
        std::vector<Word> open;
        for (const std::size_t i : maps)
            open.push_back({{int(i)}, m_active.maps[i].linear, 0, {}});
        Existence found;
        for (int length = 1; !open.empty() && length <= maxLength; ++length) {
            found.wordLength = length;
            if (const Word* witness = expanding(open)) {
                found.verdict = Verdict::None;
                found.contractivity = std::pow(std::max(witness->exact ? radiusOf<Dim>(*witness->exact)
                                                                       : spectralRadius<Dim>(witness->linear),
                                                        1.0),
                                               1.0 / length);
                found.witness = witness->symbols;
                return found;
            }
            settle(open);
            if (m_left <= 0) break;
            open = lengthened(open);
        }
        found.contractivity = m_worst;
        if (!open.empty()) return found;
        found.verdict = Verdict::EventuallyContractive;
        found.witness = m_witness;
        found.normEquivalence = m_longest * found.wordLength;
        return found;
    }

private:
    struct Word {
        std::vector<int> symbols; // outermost first
        Matrix<Dim> linear;
        double error = 0;                        // rounding error in the Frobenius norm
        std::optional<ExactMatrix<Dim>> exact{}; // set if rounding would be too large a share
    };
    static constexpr int maxLength = 64;
    static constexpr double margin = 1 - 1e-9;
    static constexpr double negligible = 0x1p-40; // relative to a product; far below the margin

    bool follows(int before, int after) const { // in the order of application
        return m_active.links[std::size_t(before) * m_active.maps.size() + std::size_t(after)] > 0;
    }

    // Word that may be repeated for ever and is proved not to contract.
    const Word* expanding(const std::vector<Word>& words) {
        const auto found = std::ranges::find_if(words, [this](const Word& word) {
            return follows(word.symbols.front(), word.symbols.back()) && expansionOf(word) == Expansion::Yes;
        });
        return found == words.end() ? nullptr : &*found;
    }

    Expansion expansionOf(const Word& word) {
        if (word.exact) return exactExpansion<Dim>(*word.exact);
        const Expansion known = expansion<Dim>(word.linear, word.error);
        const int length = int(word.symbols.size());
        if (known != Expansion::Unknown || m_askedLeft < length) return known;
        m_askedLeft -= length;
        return exactExpansion<Dim>(m_active.maps, word.symbols);
    }

    void settle(std::vector<Word>& words) {
        std::erase_if(words, [this](const Word& word) {
            double norm = spectralNorm<Dim>(word.linear);
            if (!(word.error <= negligible * norm)) norm += word.error;
            if (!(norm <= m_longest)) m_longest = norm;
            if (!(norm <= margin)) return false;
            const double each = std::pow(norm, 1.0 / double(word.symbols.size()));
            if (each >= m_worst) {
                m_worst = std::max(each, 1e-3);
                m_witness = word.symbols;
            }
            return true;
        });
    }

    std::vector<Word> lengthened(const std::vector<Word>& words) {
        std::vector<Word> result;
        for (const Word& word : words)
            for (std::size_t i = 0; i < m_active.maps.size() && m_left > 0; ++i) {
                if (!follows(int(i), word.symbols.back())) continue;
                --m_left;
                result.push_back(word);
                lengthen(result.back(), i);
            }
        return result;
    }

    // The error grows with the norms of the factors, however short their product is. If they cancel, the
    // product is computed without rounding, within the time allowed.
    void lengthen(Word& word, std::size_t map) {
        constexpr double tiny = 0x1p-900; // negligible in any sum
        const Matrix<Dim>& factor = m_active.maps[map].linear;
        word.symbols.push_back(int(map));
        const double terms = (word.linear.cwiseAbs() * factor.cwiseAbs()).maxCoeff();
        word.error = word.error * factor.reshaped().stableNorm() + Dim * Dim * roundingUnit * terms;
        word.error = word.error * (1 + 0x1p-48) + underflow;
        word.linear = word.linear * factor;
        const bool isKnown = word.error <= std::max(tiny, negligible * word.linear.reshaped().stableNorm());
        const int work = word.exact ? 1 : int(word.symbols.size());
        if ((isKnown && !word.exact) || m_exactLeft < work) return word.exact.reset();
        m_exactLeft -= work;
        if (word.exact)
            word.exact = *word.exact * exactMatrix<Dim>(factor);
        else
            word.exact = exactProduct(word.symbols);
        word.linear = rounded<Dim>(*word.exact);
        word.error = 4 * roundingUnit * Dim * word.linear.cwiseAbs().maxCoeff() + underflow;
    }

    ExactMatrix<Dim> exactProduct(const std::vector<int>& word) const {
        auto result = exactMatrix<Dim>(Matrix<Dim>::Identity());
        for (const int symbol : word)
            result = result * exactMatrix<Dim>(m_active.maps[std::size_t(symbol)].linear);
        return result;
    }

    const ActiveMaps<Dim>& m_active;
    int m_left;
    int m_exactLeft = 4'000;   // factors still allowed without rounding
    int m_askedLeft = 100'000; // letters of words still allowed for exact decisions
    double m_worst = 1e-3;
    double m_longest = 1;
    std::vector<int> m_witness;
};

// The maps of a part in the order in which they are applied; empty unless each has one successor.
template <int Dim>
std::vector<std::size_t> circleOf(const ActiveMaps<Dim>& active, const std::vector<std::size_t>& part) {
    const std::size_t n = active.maps.size();
    std::vector<std::size_t> result{part.front()};
    for (;;) {
        std::optional<std::size_t> next;
        for (std::size_t j = 0; j < n; ++j) {
            if (!(active.links[result.back() * n + j] > 0)) continue;
            if (next) return {};
            next = j;
        }
        if (!next) return {};
        if (*next == result.front()) return result;
        result.push_back(*next);
    }
}

// Admissible words of maps that follow one another in a circle alone are powers of the word of all of them,
// and beginnings of these. The sum of their norms is at most n·C·M/(1 − γ), where the word contracts by γ in
// a norm with this C and beginnings have norms up to M, whichever map comes first.
template <int Dim>
Existence circleExistence(const ActiveMaps<Dim>& active, const std::vector<std::size_t>& circle) {
    constexpr std::size_t maxMeasured = 64;
    const std::size_t n = circle.size();
    Existence result{.verdict = Verdict::EventuallyContractive, .contractivity = 1, .wordLength = int(n)};
    for (std::size_t k = n; k-- > 0;)
        result.witness.push_back(int(circle[k]));
    const auto letter = [&](std::size_t k) {
        return exactMatrix<Dim>(active.maps[std::size_t(result.witness[k % n])].linear);
    };
    for (std::size_t first = 0; first < n; ++first) {
        ExactMatrix<Dim> product = letter(first);
        double longest = 1;
        for (std::size_t k = 1; k < n; ++k) {
            longest = std::max(longest, rounded<Dim>(product).norm() * (1 + 1e-12));
            product = product * letter(first + k);
        }
        if (first == 0 && exactExpansion<Dim>(product) == Expansion::Yes) {
            result.verdict = Verdict::None;
            result.contractivity = std::pow(std::max(radiusOf<Dim>(product), 1.0), 1.0 / double(n));
            return result;
        }
        const auto norm = n <= maxMeasured ? exactMatrixNorm<Dim>(product) : std::nullopt;
        if (!norm || norm->contractivity == 1) {
            result.contractivity = 1;
            result.normEquivalence = std::numeric_limits<double>::infinity();
            return result;
        }
        result.contractivity = std::pow(norm->contractivity, 1.0 / double(n)) * (1 + 0x1p-52);
        result.normEquivalence =
            std::max(result.normEquivalence, double(n) * norm->equivalence * longest * (1 + 1e-12));
    }
    result.contractivity = std::min(result.contractivity, 1.0);
    return result;
}

// Circles by the exact radius of their word, the other parts by the search. nullopt where no part is a
// circle.
template <int Dim> std::optional<Existence> existenceByParts(const ActiveMaps<Dim>& active, int maxProducts) {
    constexpr std::size_t maxLetters = 1'000;
    std::vector<std::size_t> others;
    std::optional<Existence> slowest;
    std::size_t letters = 0;
    const auto add = [&slowest](const Existence& found) {
        if (!slowest) {
            slowest = found;
            return;
        }
        const double equivalence = std::max(slowest->normEquivalence, found.normEquivalence);
        if (found.contractivity > slowest->contractivity) slowest = found;
        slowest->normEquivalence = equivalence;
    };
    for (const auto& part : connectedParts(active.links, active.maps.size())) {
        const auto circle = circleOf<Dim>(active, part);
        letters += circle.size();
        if (circle.empty() || letters > maxLetters) {
            others.insert(others.end(), part.begin(), part.end());
            continue;
        }
        const Existence found = circleExistence<Dim>(active, circle);
        if (found.verdict == Verdict::None) return found;
        add(found);
    }
    if (!slowest || others.empty()) return slowest;
    const Existence rest = WordSearch<Dim>(active, maxProducts).result(others);
    if (!rest.exists()) return rest;
    add(rest);
    return slowest;
}

} // namespace

template <int Dim> Existence classifyLinked(const ActiveMaps<Dim>& active, int maxProducts) {
    const Existence plain = classify<Dim>(active.maps, maxProducts);
    if (!active.isLinked() || plain.exists() || active.maps.empty()) return plain;
    if (!std::ranges::all_of(active.maps, isFinite<Dim>)) return {};
    std::vector<std::size_t> all(active.maps.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    const Existence found = WordSearch<Dim>(active, maxProducts).result(all);
    if (found.verdict != Verdict::Undecided) return found;
    return existenceByParts<Dim>(active, maxProducts).value_or(found);
}

template Existence classifyLinked<2>(const ActiveMaps<2>&, int);
template Existence classifyLinked<3>(const ActiveMaps<3>&, int);

} // namespace ifs
