// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cut/address_cut.h"
#include "attractor/folds/sample_colours.h"
#include "attractor/request/colour_coordinates.h"
#include "attractor/request/render_request.h"
#include "attractor/samples/prepared_system.h"

#include <cstdint>
#include <vector>

namespace attractor {

// A request with data derived from it before the first sample: camera · cage, the maps that take part, the
// colours of samples.
class PreparedRequest {
public:
    // Keeps results of the request before that still hold, where the system or the cage at rest is the same.
    void set(RenderRequest request);

    const RenderRequest& request() const { return m_request; } // threads and supersample in range
    const PreparedSystem& system() const { return m_system; }
    const Projection& projection() const { return m_projection; }
    int cellsPerPixel() const { return m_request.appearance.supersample; } // cells per side

    bool isDrawable() const; // true if there is something to draw, and pixels to draw it on
    // The reason why this view of the system is not exact: None, Degenerate or TooDeep.
    RenderNote viewNote() const;

    bool coloured() const { return coloursSamples(m_request.appearance.colourBy); }
    const ColourCoordinates& coordinates() const { return m_coordinates; }
    // The colour of a sample; its map is counted among those that take part.
    const ColourCell& colourOf(std::uint32_t map, double addressCoordinate) const {
        return m_colours.of(map, addressCoordinate);
    }

    // Colours of the maps that take part, where samples have the colour of their map.
    std::span<const ColourCell> mapColours() const { return m_colours.ofMaps(); }

private:
    ifs::Placement placement();
    void makeColours();

    RenderRequest m_request;
    PreparedSystem m_system;
    Projection m_projection;
    SampleColours m_colours;
    ColourCoordinates m_coordinates;
    // Rest corners of a bending cage, for which the coordinates were chosen.
    std::vector<ifs::Vector<2>> m_bent;
    ifs::Coordinates m_cageCoordinates = ifs::Coordinates::MeanValue;
};

} // namespace attractor
