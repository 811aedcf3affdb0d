// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/variations/chance.h"
#include "document/variations/may_change.h"

#include <memory>
#include <vector>

namespace document {

// Crossings of a fractal with another one of the same dimension. docs/mathematics.md, "Crossing".
template <int Dim> class Crossing {
public:
    // Both must have a system of this dimension. The partner's picture, as its first frame and its cage have
    // it, is scaled and moved so that its measure has the mean and the size of the parent's.
    Crossing(std::shared_ptr<const Fractal> parent, const Fractal& partner);

    // The parent with some maps of the partner in place of its own, some half-way between, some more and some
    // less; with the symmetry, colours and weights of either, as far as they may change. Locked maps stay,
    // and so do those that are off. At least one map is not the parent's alone, if the shape may change.
    Fractal child(const MayChange& may, Chance& chance) const;

private:
    struct Pair {
        std::size_t mine = 0; // index in the parent's system
        std::size_t its = 0;  // index in the partner's system
    };
    struct Inherited;

    void align(const ifs::ActiveMaps<Dim>& mine, const ifs::ActiveMaps<Dim>& its);
    void pairUp();
    std::vector<Inherited> draw(Chance& chance, bool mayLose) const;
    bool canTakeSymmetry(std::size_t maps) const;
    void inherit(const Inherited& from, const MayChange& may, Fractal& child) const;
    void mixBlends(const std::vector<Inherited>& drawn, Fractal& child) const;

    std::shared_ptr<const Fractal> m_parent;
    ifs::IteratedFunctionSystem<Dim> m_partner; // partner in coordinates of the parent's code
    attractor::Appearance m_partnerAppearance;
    std::vector<double> m_parentWeights, m_partnerWeights; // probabilities, one for each listed map
    ifs::Vector<Dim> m_reference = ifs::Vector<Dim>::Zero();
    std::vector<Pair> m_pairs;
    std::vector<std::size_t> m_onlyMine, m_onlyIts; // maps that take part and have no counterpart
    std::vector<std::size_t> m_resting;             // maps of the parent that are off
};

} // namespace document
