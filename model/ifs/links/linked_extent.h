// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/extent.h"
#include "ifs/system/iterated_function_system.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace ifs {

template <int Dim> struct ExactMap;

// Certified extents of the parts A_j = ∪ w_j(A_i) over the i with P_ij > 0, of linked maps in the plane whose
// attractor exists; A is the union of the parts. docs/mathematics.md, "Linked maps".
class LinkedExtent {
public:
    // nullopt unless `existence`, that of the same maps, says that there is an attractor.
    static std::optional<LinkedExtent> of(const ActiveMaps<2>& active, const Existence& existence);

    // max ⟨u,x⟩ over A, or over one part: the value is within `error` below the truth.
    struct Height {
        double value = 0;
        double error = 0;
        Vector<2> point = Vector<2>::Zero(); // point of the attractor at which the value is reached
    };
    // The error may be as large as `tolerance`, which ends the search sooner.
    Height operator()(const Vector<2>& u, double tolerance = 0) const;
    Height ofPart(std::size_t part, const Vector<2>& u, double tolerance = 0) const;

    const Vector<2>& centre() const { return m_centre; } // A lies in Ball(centre, radius)
    double radius() const { return m_radius; }
    std::size_t parts() const { return m_active.maps.size(); }
    const Vector<2>& pointOf(std::size_t part) const { return m_points[part]; } // point of the part

private:
    struct Node;
    Node exactNode(std::size_t last, ExactMap<2> map, const Vector<2>& u) const;
    Node first(std::size_t part, const Vector<2>& u) const;
    // `apart` grows by how far two vectors merged in one cell may lie apart; `exactLeft` is how many letters
    // may still be composed without rounding.
    std::vector<Node> lengthened(const std::vector<Node>& open, const Vector<2>& u, double& apart,
                                 int& exactLeft) const;
    Node child(const Node& node, std::size_t map, const Vector<2>& u, int& exactLeft) const;
    bool isWide(const Vector<2>& u) const;
    void boundParts();
    double boundOfRest(const Node& node) const; // bound of ⟨v, x⟩ over the points x that may follow a word
    Height ofPoint(std::size_t part, const Vector<2>& u) const;
    Height search(std::vector<Node> open, const Vector<2>& u, double tolerance) const;

    ActiveMaps<2> m_active;                         // active maps with centre() as the origin
    std::vector<std::vector<std::size_t>> m_before; // the maps i with P_ij > 0, for each j
    std::vector<AffineMap<2>> m_maps;               // unchanged maps
    std::vector<Vector<2>> m_points;                // one point of each part
    double m_pointError = 0;                        // error bound of m_points
    std::vector<Vector<2>> m_seen;                  // m_points relative to the centre
    bool m_arePoints = false;                       // true if every part is a single point
    bool m_isCancelling = false;                    // true if words are much longer than their maps make them
    Vector<2> m_centre = Vector<2>::Zero();
    double m_radius = 0;
    // Bounds of the heights of each part from the centre, in directions of equal angle; empty where the ball
    // does.
    std::vector<std::vector<double>> m_bounds;
};

// Extents as of plain maps, exact to rounding where the search allows it.
BoundingBox<2> boundingBox(const LinkedExtent& extent);
CanonicalSimplex<2> minimalCanonicalSimplex(const LinkedExtent& extent);
// The boxes of the parts by the maps that make them; `copies` consecutive ones are the copies of one map. No
// box for a map that takes no part; none at all unless maps are linked, at most 64, and the attractor exists.
std::vector<std::optional<BoundingBox<2>>>
boxesOfParts(const ActiveMaps<2>& active, const Existence& existence, std::size_t maps, std::size_t copies);
std::optional<ConvexHull> convexHull(const LinkedExtent& extent, double tolerance,
                                     const std::stop_token& stop = {}); // nullopt if stopped

} // namespace ifs
