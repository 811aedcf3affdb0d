// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "ifs/system/barycentric.h"

#include <QString>

#include <optional>
#include <vector>

// What a document does with the control cage of its current entry, one step of the history each, from the
// values of cage_edits.h. Each returns the sentence that says why nothing was done, or nullopt when it was.
namespace document {

// The smallest triangle with its legs along the axes that holds what is displayed. The picture stays.
std::optional<QString> fitMinimalCanonicalSimplex(Document& document);

// Every vertex back to rest: the code as it is written.
std::optional<QString> resetCage(Document& document);
std::optional<QString> resetVertex(Document& document, int index);

// The placement becomes the code, T∘w∘T⁻¹, and the cage rests where it is. The picture stays.
std::optional<QString> bakeCage(Document& document);

// These three vertices hold the picture from now on. The picture stays.
std::optional<QString> defineTriangle(Document& document, const ifs::Simplex<2>& vertices);
std::optional<QString> defineTetrahedron(Document& document, const ifs::Simplex<3>& vertices);

// One vertex more on the edge from vertex `edge` to the next, `share` of the way; these vertices less, given
// in increasing order; the vertices on the regular polygon nearest to them.
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

// Whether the placement can be undone, as fitting, defining and baking need it.
bool isPlacementInvertible(const Fractal& fractal);

} // namespace document
