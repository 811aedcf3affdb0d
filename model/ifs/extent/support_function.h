// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_value.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/barycentric.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <type_traits>
#include <vector>

// Certified extents of an attractor, from h_A(u) = max over x in A of ⟨u,x⟩ by branch and bound over
// addresses with merging of equal states. docs/mathematics.md, "Support function".
namespace ifs {

class Outline;
struct Existence;
template <int Dim> struct Conditioned;
template <int Dim> struct SupportContainer;

// Answers h_A(u) for one list of maps. Construction classifies the system and finds a container of the
// attractor.
template <int Dim> class SupportFunction {
public:
    // nullopt when no factor below 1 is known by which the maps contract.
    static std::optional<SupportFunction> of(std::span<const AffineMap<Dim>> maps);

    // Stops at `tolerance` (absolute, ≥ a few ulps of the size) or when `maxNodes` words are open; either way
    // the error returned is certified. u need not be unit; u = 0 gives 0. In the plane, a known outline of
    // the attractor shortens the search: the better it is, the more. It is seen from centre(), or from that
    // of conditioning()->support in the coordinates there.
    SupportValue<Dim> operator()(const Vector<Dim>& u, double tolerance = 0, int maxNodes = 200'000,
                                 const Outline* known = nullptr) const;

    // Bounds of the attractor known after the first question, good enough to keep most searches short. In the
    // plane; nullptr in space. They stay coarser when the first caller is stopped.
    const Outline* outline(const std::stop_token& stop = {}) const;

    // A ⊂ Ball(centre, radius).
    const Vector<Dim>& centre() const { return m_centre; }
    double radius() const { return m_radius; }
    Vector<Dim> pointOfAttractor() const; // fixed point of the first map
    const std::vector<AffineMap<Dim>>& maps() const { return m_maps; }
    // Indices of those maps that can lead to extreme points: of many in the plane, the outer ones.
    const std::vector<std::size_t>& mapsToTheHull() const;

    // Coordinates in which everything is worked out when maps stretch before they contract: there x is
    // image(…) of a point, and `error` is the distance by which rounding may have moved it. nullptr if the
    // maps need no conditioning.
    struct Conditioning;
    const Conditioning* conditioning() const { return m_conditioning.get(); }

    // max ‖A_i‖_* < 1 and C with |x| ≤ ‖x‖_* ≤ C|x|, as contractingNorm() found them.
    double contractivity() const { return m_contractivity; }
    double normEquivalence() const { return m_normEquivalence; }

    // Bound of the rounding error of a support value at |u| = 1, for addresses of `depth` symbols.
    double roundingError(int depth) const;

private:
    SupportFunction() = default;
    static std::optional<SupportFunction> of(std::span<const AffineMap<Dim>> maps,
                                             const Existence& existence);
    static std::optional<SupportFunction> through(const Conditioned<Dim>& better,
                                                  std::span<const AffineMap<Dim>> maps);
    const SupportContainer<Dim>* finerContainer() const; // nullptr if there is none
    Vector<Dim> follow(const std::vector<int>& address, const Vector<Dim>& start) const;

    std::vector<AffineMap<Dim>> m_maps;
    Vector<Dim> m_centre = Vector<Dim>::Zero();
    double m_radius = 0;
    double m_contractivity = 0;
    double m_normEquivalence = 1;
    std::shared_ptr<const SupportContainer<Dim>> m_container;
    struct LazyOutline;
    std::shared_ptr<LazyOutline> m_outline; // set by the first call of outline()
    struct LazyContainer;
    std::shared_ptr<LazyContainer> m_finer; // set by the first call of finerContainer()
    std::shared_ptr<const Conditioning> m_conditioning;
};

template <int Dim> struct SupportFunction<Dim>::Conditioning {
    SupportFunction support; // support of the attractor in coordinates y
    AffineMap<Dim> image;    // x = image(y)
    double error = 0;        // bound of the rounding error in y

    SupportValue<Dim> ask(const Vector<Dim>& u, double tolerance, int maxNodes, const Outline* known) const;
    double errorOf(double distance) const; // error in coordinates x for a distance in y
    double rounding() const;               // rounding error of an image
};

} // namespace ifs
