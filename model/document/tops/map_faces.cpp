// SPDX-License-Identifier: MIT
#include "document/tops/map_faces.h"

namespace document {

MapFaces facesOfPartner(const Fractal& from, const Fractal& to) {
    const System2 *f = system2(from), *g = system2(to);
    if (f == nullptr || g == nullptr) return {};
    const std::vector<std::size_t> sources = ifs::activeMaps(*f).index, indices = ifs::activeMaps(*g).index;
    if (sources.size() != indices.size()) return {};
    MapFaces faces;
    for (std::size_t i = 0; i < g->maps.size(); ++i)
        faces.push_back({attractor::mapColour(to.appearance, g->maps[i].id, i), 0});
    // Backwards, because the first copy under a symmetry decides.
    for (std::size_t k = indices.size(); k-- > 0;) {
        const std::size_t source = sources[k];
        faces[indices[k]] = {attractor::mapColour(from.appearance, f->maps[source].id, source), source + 1};
    }
    return faces;
}

} // namespace document
