// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <optional>
#include <vector>

// Symmetries of flames: <symmetry kind="n"/> and transforms that only rotate or mirror. docs/formats.md,
// "Flame XML".
namespace io {

// The kind that says this: n for n-fold rotation, −n for the dihedral group with a mirror along y, −1 for
// that mirror alone, all about the origin. nullopt when no kind does.
std::optional<int> flameKind(const ifs::Symmetry<2>& symmetry);

// The other way round. nullopt for 0, which means a random one, and beyond the orders that there are.
std::optional<ifs::Symmetry<2>> symmetryOfKind(int kind);

// The transforms that stand for a symmetry without a kind: its elements but the identity. None when a kind
// does, or when they are no isometries, in which case the flame has to list the maps.
std::vector<ifs::AffineMap<2>> symmetryTransforms(const ifs::Symmetry<2>& symmetry);

// Returns true if a flame has a place for the symmetry of the fractal, or there is none.
bool flameHoldsSymmetry(const document::Fractal& fractal);

// The group that these maps generate; None when it is no finite group of symmetries of the plane.
ifs::Symmetry<2> generatedSymmetry(const std::vector<ifs::AffineMap<2>>& maps);

// The xforms of one flame that only rotate or mirror, and the <symmetry> element.
class FlameSymmetryReader {
public:
    // Returns true if the kind is known.
    bool readKind(int kind);
    // The xform with this index, as it acts here, stands for a symmetry if a group comes of it.
    void addTransform(std::size_t index, const ifs::AffineMap<2>& map);

    // The symmetry of the flame, and the indices, ascending, of the xforms that express it: those are not
    // maps.
    struct Outcome {
        ifs::Symmetry<2> symmetry;
        std::vector<std::size_t> transforms;
    };
    Outcome outcome() const;

private:
    std::optional<ifs::Symmetry<2>> m_kind;
    std::vector<std::size_t> m_indices;
    std::vector<ifs::AffineMap<2>> m_maps;
};

} // namespace io
