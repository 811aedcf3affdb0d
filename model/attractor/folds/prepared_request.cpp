// SPDX-License-Identifier: MIT
#include "attractor/folds/prepared_request.h"

#include "ifs/extent/support_function.h"

#include <algorithm>
#include <cmath>

namespace attractor {

void PreparedRequest::set(RenderRequest request) {
    const bool sameSystem =
        m_system.maps.size() > 0 && request.system == m_request.system && request.moved == m_request.moved;
    m_request = std::move(request);
    m_request.threads = std::clamp(m_request.threads, 1, 256);
    m_request.appearance.supersample = std::clamp(m_request.appearance.supersample, 1, 4);
    if (!sameSystem) {
        m_system = prepared(m_request.system, m_request.moved);
        m_bent.clear();
    }
    m_projection = attractor::projection(m_request.camera, placement(), cellsPerPixel());
    makeColours();
}

// The placement. The coordinates of a bending cage depend on system and rest alone, and are kept with the
// rest.
ifs::Placement PreparedRequest::placement() {
    if (!m_request.cage || !ifs::isValid(*m_request.cage)) return {};
    if (ifs::bends(*m_request.cage) && m_bent != m_request.cage->rest) {
        const auto support = m_system.isLinked() ? std::nullopt : ifs::SupportFunction<2>::of(m_system.maps);
        m_cageCoordinates = ifs::suitableCoordinates(m_request.cage->rest, support ? &*support : nullptr,
                                                     shownPieces(m_system));
        m_bent = m_request.cage->rest;
    }
    return {*m_request.cage, m_cageCoordinates};
}

bool PreparedRequest::isDrawable() const {
    const Camera& camera = m_request.camera;
    return !m_system.maps.empty() && camera.width > 0 && camera.height > 0 && camera.pixelsPerUnit > 0 &&
           std::isfinite(camera.pixelsPerUnit) && std::isfinite(camera.rotation) && camera.centre.allFinite();
}

RenderNote PreparedRequest::viewNote() const {
    const bool bends = m_projection.cage.bend() != nullptr;
    const ifs::Vector<2> stretch = ifs::singularValues<2>(m_projection.cage.affine().linear);
    if (!bends && !(stretch[1] > 1e-6 * stretch[0])) return RenderNote::Degenerate;
    // Limit of double precision: beyond it, the camera's centre has no digits for a pixel. Bends are
    // evaluated in double.
    const Camera& camera = m_request.camera;
    const double farthest = std::max(camera.centre.cwiseAbs().maxCoeff(), m_system.halfExtent.maxCoeff());
    return camera.pixelsPerUnit * farthest * (bends ? 0x1p-45 : 0x1p-53) > 0.5 ? RenderNote::TooDeep
                                                                               : RenderNote::None;
}

void PreparedRequest::makeColours() {
    std::vector<ifs::MapId> ids;
    if (m_request.appearance.colourBy == ColourBy::Map)
        for (const std::size_t index : m_system.index)
            ids.push_back(m_request.system.maps[index].id);
    m_colours = SampleColours(m_request.appearance, ids, m_system.index);
    m_coordinates = colourCoordinates<2>(m_request.appearance, m_request.system, m_system);
}

} // namespace attractor
