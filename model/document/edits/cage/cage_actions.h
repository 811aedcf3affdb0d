// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "ifs/system/barycentric.h"

#include <QString>

#include <optional>
#include <vector>

// Actions of a document on the control cage of its current entry, one step of the history each, by the
// functions of cage_edits.h. Each returns the sentence that says why nothing was done, or nullopt when it
// was.
namespace document {

// Fits the smallest triangle with its legs along the axes that holds the displayed picture. The picture
// stays.
std::optional<QString> fitMinimalCanonicalSimplex(Document& document);

// Moves every vertex, or one, back to rest.
std::optional<QString> resetCage(Document& document);
std::optional<QString> resetVertex(Document& document, int index);

// The placement becomes the code, T∘w∘T⁻¹, and the cage rests where it is. The picture stays.
std::optional<QString> bakeCage(Document& document);

// Makes these vertices the cage. The picture stays.
std::optional<QString> defineTriangle(Document& document, const ifs::Simplex<2>& vertices);
std::optional<QString> defineTetrahedron(Document& document, const ifs::Simplex<3>& vertices);

// Edits of the polygon: a new vertex on the edge from vertex `edge` to the next, at `share` of it; removing
// vertices, given in increasing order; moving the vertices to the nearest regular polygon.
std::optional<QString> insertVertex(Document& document, int edge, double share);
std::optional<QString> removeVertices(Document& document, const std::vector<std::size_t>& vertices);
std::optional<QString> makeCageRegular(Document& document);

// Bake the other way round: the placement is taken out of the code. The picture stays.
std::optional<QString> unbakeCage(Document& document);

std::optional<QString> moveVertex(Document& document, int index, const ifs::Vector<2>& position);

// Why the document cannot bake, and why its cage cannot be moved in its mode; empty where it can. Of an entry
// whose maps have keys, both would change some maps at one frame and others at all.
QString bakeObstacle(const Document& document);
QString moveCageObstacle(const Document& document);

// Returns true if the placement can be undone, as fitting, defining and baking need it.
bool isPlacementInvertible(const Fractal& fractal);

} // namespace document
