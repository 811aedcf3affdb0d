// SPDX-License-Identifier: MIT
#include "document/edits/maps/link_edits.h"

#include "document/text/text.h"
#include "ifs/system/links.h"

namespace document {

QString linkObstacle(const Fractal& fractal) {
    if (space(fractal)) return Text::tr("Maps in space cannot be linked.");
    const System2* system = system2(fractal);
    if (!system) return Text::tr("This entry could not be read, so its maps cannot be linked.");
    if (system->maps.size() > maxLinkedMaps)
        return Text::tr("More than %1 maps cannot be linked.").arg(maxLinkedMaps);
    return {};
}

Fractal withLink(Fractal fractal, int from, int to, double weight) {
    System2& system = *system2(fractal);
    ifs::setLink(system, {system.maps[std::size_t(from)].id, system.maps[std::size_t(to)].id, weight});
    return fractal;
}

Fractal withoutLinks(Fractal fractal) {
    if (System2* system = system2(fractal)) system->links.clear();
    return fractal;
}

} // namespace document
