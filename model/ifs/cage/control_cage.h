// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/cage/generalized_coordinates.h"
#include "ifs/extent/support_function.h"
#include "ifs/system/barycentric.h"
#include "ifs/system/iterated_function_system.h"

#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace ifs {

// Effect of a cage of more than Dim + 1 vertices on its content.
enum class Deformation {
    Bend,      // generalized coordinates: every vertex is followed, and no affine code has the picture
    AffineFit, // affine map that misses the current vertices least
};

// The polygon by which an attractor is held. The rest vertices say where the attractor is held, and are never
// degenerate; the current vertices are where the user has dragged them, and may be anything finite.
// Both lists have the same length ≥ Dim + 1. With exactly Dim + 1 vertices the deformation is affine.
template <int Dim> struct ControlCage {
    std::vector<Vector<Dim>> rest;
    std::vector<Vector<Dim>> current;
    Deformation deformation = Deformation::Bend;

    friend bool operator==(const ControlCage&, const ControlCage&) = default;
};

template <int Dim> ControlCage<Dim> polygonAtRest(std::vector<Vector<Dim>> vertices);
template <int Dim> ControlCage<Dim> cageAtRest(const Simplex<Dim>& simplex);

// Returns true if the lists match, every number is finite, and the rest vertices define coordinates: a
// simplex that is not flat; in the plane, a simple polygon of at most 64 corners.
template <int Dim> bool isValid(const ControlCage<Dim>& cage);

// The map from rest to displayed coordinates: T_c·T_0⁻¹ of a cage with Dim + 1 vertices, the affine fit of
// one with more. Only the rest is inverted, so the current vertices may lie on one line. Exactly the identity
// when current equals rest.
template <int Dim> AffineMap<Dim> displayMap(const ControlCage<Dim>& cage);

// Returns true if the cage is set to bend, and its vertices are where no affine map takes them.
template <int Dim> bool bends(const ControlCage<Dim>& cage);

// Returns true if an affine map undoes the placement: the cage does not bend, and σ_min > 1e-6·σ_max of the
// display map. Baking, fitting and picking need it.
template <int Dim> bool isInvertible(const ControlCage<Dim>& cage);

// "Bake": the code becomes M_c∘w∘M_c⁻¹ and the cage rests where it is (an affine fit: where the fit takes
// its rest). nullopt when the cage bends or is too flat.
template <int Dim> struct Baked {
    IteratedFunctionSystem<Dim> system;
    ControlCage<Dim> cage;
};
template <int Dim>
std::optional<Baked<Dim>> bake(const IteratedFunctionSystem<Dim>& system, const ControlCage<Dim>& cage);

// The cage that shows the same picture through other vertices: the current ones are `vertices`, the rest ones
// M_c⁻¹(vertices). nullopt when they hold no coordinates or the present placement bends or is flat.
template <int Dim>
std::optional<ControlCage<Dim>> redefine(const ControlCage<Dim>& present,
                                         std::type_identity_t<std::span<const Vector<Dim>>> vertices);

// Wachspress only while the certified hull lies in a strictly convex cage (they have poles outside), else
// mean value. Without `support` nothing is certified. `pieces`: the attractor is shown by these maps.
Coordinates suitableCoordinates(std::span<const Vector<2>> rest, const SupportFunction<2>* support,
                                std::span<const AffineMap<2>> pieces = {});

// The map from rest to displayed coordinates, bent or not.
class Placement {
public:
    Placement() = default;                // identity
    Placement(const AffineMap<2>& affine) // NOLINT: an affine map is a placement
        : m_affine(affine) {}
    Placement(const ControlCage<2>& cage, Coordinates coordinates); // requires a valid cage

    Vector<2> operator()(const Vector<2>& x) const { return m_bend ? (*m_bend)(x) : m_affine(x); }
    const AffineMap<2>& affine() const { return m_affine; } // whole placement or, for a bend, its affine fit
    const PolygonDeformation* bend() const { return m_bend.get(); } // nullptr: affine

private:
    AffineMap<2> m_affine;
    std::shared_ptr<const PolygonDeformation> m_bend;
};

// Defects of a cage that bends, for a warning.
enum class CageFlaw {
    None,
    Concave, // notch, at rest or now: the picture can fold over itself there
    Folded,  // crossing edges, or parts of the inside turned over
};
CageFlaw flawOf(const ControlCage<2>& cage, const Placement& placement);

// Adds a vertex on the edge from vertex `edge` to the next one, at the same share of it at rest and now.
// nullopt when the cage would not be valid.
std::optional<ControlCage<2>> withVertexInserted(const ControlCage<2>& cage, std::size_t edge, double share);
std::optional<ControlCage<2>> withVertexRemoved(const ControlCage<2>& cage, std::size_t vertex);

// The regular polygon nearest to the vertices, with the same centre and sense; nullopt when they have none.
std::optional<std::vector<Vector<2>>> regularPolygonNear(std::span<const Vector<2>> vertices);

} // namespace ifs
