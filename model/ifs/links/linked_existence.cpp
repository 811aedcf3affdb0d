// SPDX-License-Identifier: MIT
#include "ifs/links/linked_existence.h"

#include "ifs/existence/expansion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace ifs {

namespace {

// Words are lengthened at their inner end until they contract. When all have, any admissible word is a
// product of words that do, and of a rest of bounded length.
template <int Dim> class WordSearch {
public:
    WordSearch(const ActiveMaps<Dim>& active, int maxProducts) : m_active(active), m_left(maxProducts) {}

    Existence result() {
        std::vector<Word> open;
        for (std::size_t i = 0; i < m_active.maps.size(); ++i)
            open.push_back({{int(i)}, m_active.maps[i].linear});
        Existence found;
        for (int length = 1; !open.empty() && length <= maxLength; ++length) {
            found.wordLength = length;
            if (auto witness = expanding(open)) {
                found.verdict = Verdict::None;
                found.contractivity = std::pow(spectralRadiusOf(*witness), 1.0 / length);
                found.witness = *std::move(witness);
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
    };
    static constexpr int maxLength = 64;
    static constexpr double margin = 1 - 1e-9; // rounding of a product of 64 maps is far below

    bool follows(int before, int after) const { // in the order in which they are applied
        return m_active.links[std::size_t(before) * m_active.maps.size() + std::size_t(after)] > 0;
    }

    double spectralRadiusOf(const std::vector<int>& word) const {
        Matrix<Dim> product = Matrix<Dim>::Identity();
        for (const int symbol : word)
            product = product * m_active.maps[std::size_t(symbol)].linear;
        return spectralRadius<Dim>(product);
    }

    // A word that may be repeated for ever and is proved not to contract.
    std::optional<std::vector<int>> expanding(const std::vector<Word>& words) const {
        for (const Word& word : words) {
            if (!follows(word.symbols.front(), word.symbols.back())) continue;
            const double size = word.linear.norm();
            const double error = 4 * Dim * double(word.symbols.size()) *
                                 std::numeric_limits<double>::epsilon() * std::max(size, 1.0);
            Expansion known = expansion<Dim>(word.linear, error);
            if (known == Expansion::Unknown) known = exactExpansion<Dim>(m_active.maps, word.symbols);
            if (known == Expansion::Yes) return word.symbols;
        }
        return std::nullopt;
    }

    void settle(std::vector<Word>& words) {
        std::erase_if(words, [this](const Word& word) {
            const double norm = spectralNorm<Dim>(word.linear);
            m_longest = std::max(m_longest, norm);
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
                result.back().symbols.push_back(int(i));
                result.back().linear = word.linear * m_active.maps[i].linear;
            }
        return result;
    }

    const ActiveMaps<Dim>& m_active;
    int m_left;
    double m_worst = 1e-3;
    double m_longest = 1;
    std::vector<int> m_witness;
};

} // namespace

template <int Dim> Existence classifyLinked(const ActiveMaps<Dim>& active, int maxProducts) {
    const Existence plain = classify<Dim>(active.maps, maxProducts);
    const bool exists =
        plain.verdict == Verdict::Hyperbolic || plain.verdict == Verdict::EventuallyContractive;
    if (!active.isLinked() || exists || active.maps.empty()) return plain;
    if (!std::ranges::all_of(active.maps, isFinite<Dim>)) return {};
    return WordSearch<Dim>(active, maxProducts).result();
}

template Existence classifyLinked<2>(const ActiveMaps<2>&, int);
template Existence classifyLinked<3>(const ActiveMaps<3>&, int);

} // namespace ifs
