// SPDX-License-Identifier: MIT
#include "io/overlay/space_overlay.h"

#include "document/analysis/space_outlines.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/space_map_handles.h"
#include "ifs/cage/cage_surface.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace io {

namespace {

using document::SpaceMapHandles;

constexpr std::array<std::array<int, 2>, 6> tetrahedron{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::vector<std::array<int, 2>> edgesOf(const std::vector<ifs::Vector<3>>& rest) {
    if (const auto surface = ifs::convexSurface(rest)) return surface->edges();
    return {tetrahedron.begin(), tetrahedron.end()};
}

std::optional<SpaceMapHandles> handlesOf(const document::Fractal& fractal,
                                         const std::optional<ifs::ControlCage<3>>& cage) {
    if (!cage) return std::nullopt;
    return SpaceMapHandles(std::make_shared<const document::Fractal>(fractal), *cage);
}

class Marks {
public:
    Marks(const document::Fractal& fractal, const attractor::OrbitCamera& camera)
        : m_camera(camera), m_width(std::max(1.5, std::min(camera.size.width, camera.size.height) / 500.0)) {
        const attractor::Rgba ground = document::backgroundInSpace(fractal);
        m_ink = inkOn(ground);
        m_halo = haloOn(ground);
    }

    void addLines(std::span<const ifs::Vector<3>> points, std::span<const std::array<int, 2>> edges,
                  const QColor& colour) {
        for (const auto& [pen, factor] : {std::pair{m_halo, 2.0}, {colour, 1.0}})
            for (const auto& [from, to] : edges) {
                const auto a = onScreen(points[std::size_t(from)]), b = onScreen(points[std::size_t(to)]);
                if (!a || !b) continue;
                OverlayMark mark;
                mark.polygon = {*a, *b};
                mark.stroke = pen;
                mark.width = factor * m_width;
                m_marks.push_back(std::move(mark));
            }
    }
    // Adds a number in a disc.
    void addNumber(const ifs::Vector<3>& point, std::size_t number, const QColor& disc, const QColor& rim) {
        const double radius = 7.5 * m_width;
        const auto centre = addDisc(point, radius, disc, rim);
        if (!centre) return;
        OverlayMark digits;
        digits.centre = *centre;
        digits.word = QString::number(number);
        digits.letterSize = radius * (digits.word.size() < 3 ? 1.1 : 0.8);
        digits.fill = qGray(disc.rgb()) > 130 ? QColor(14, 18, 26) : QColor(250, 252, 255);
        m_marks.push_back(std::move(digits));
    }
    void addDot(const ifs::Vector<3>& point, const QColor& colour) {
        addDisc(point, 3 * m_width, colour, m_halo);
    }
    const QColor& ink() const { return m_ink; }
    const QColor& halo() const { return m_halo; }
    OverlayMarks taken() { return std::move(m_marks); }

private:
    // Adds a disc; returns its centre, or nullopt behind the eye.
    std::optional<QPointF> addDisc(const ifs::Vector<3>& point, double radius, const QColor& fill,
                                   const QColor& rim) {
        const auto centre = onScreen(point);
        if (!centre) return std::nullopt;
        OverlayMark mark;
        mark.centre = *centre;
        mark.radius = radius;
        mark.fill = fill;
        mark.stroke = rim;
        mark.width = m_width;
        m_marks.push_back(std::move(mark));
        return centre;
    }
    std::optional<QPointF> onScreen(const ifs::Vector<3>& point) const {
        const ifs::Vector<2> pixel = toScreen(m_camera, point).pixel;
        return pixel.allFinite() ? std::optional(QPointF(pixel.x(), pixel.y())) : std::nullopt;
    }

    attractor::OrbitCamera m_camera;
    double m_width; // pixels; width of a line
    QColor m_ink, m_halo;
    OverlayMarks m_marks;
};

void addMaps(Marks& marks, const document::Fractal& fractal, const ifs::ControlCage<3>& cage,
             const PictureOverlay& overlay) {
    const auto handles = handlesOf(fractal, cage);
    const auto& maps = document::system3(fractal)->maps;
    const std::vector<double> shares = ifs::probabilities(*document::system3(fractal));
    const auto colourOf = [&](std::size_t i) {
        const attractor::Rgba colour = attractor::mapColour(fractal.appearance, maps[i].id, i);
        return QColor(colour.red, colour.green, colour.blue);
    };
    const std::size_t count = handles ? handles->count() : 0;
    for (std::size_t i = 0; i < count; ++i)
        if (overlay.maps && shares[i] > 0) marks.addLines(handles->corners(i), tetrahedron, colourOf(i));
    const auto system = document::effectiveSystem<3>(fractal);
    for (std::size_t i = 0; i < count; ++i) {
        const auto fixed =
            system && overlay.fixedPoints ? ifs::fixedPoint(system->maps[i].map) : std::nullopt;
        if (fixed && shares[i] > 0) marks.addDot(*fixed, colourOf(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!overlay.numbers || !(shares[i] > 0)) continue;
        const SpaceMapHandles::Corners corners = handles->corners(i);
        marks.addNumber((corners[0] + corners[1] + corners[2] + corners[3]) / 4, i + 1, colourOf(i),
                        marks.halo());
    }
}

} // namespace

OverlayMarks spaceOverlayMarks(const document::Fractal& fractal, const attractor::OrbitCamera& camera,
                               const PictureOverlay& overlay) {
    const auto cage = document::spaceCage(fractal);
    if (!cage) return {};
    Marks marks(fractal, camera);
    if (const auto hull = overlay.hull ? document::hullOutline(fractal) : std::nullopt)
        marks.addLines(hull->points, hull->edges, marks.ink());
    if (overlay.maps || overlay.fixedPoints || overlay.numbers) addMaps(marks, fractal, *cage, overlay);
    if (overlay.cage) {
        marks.addLines(cage->current, edgesOf(cage->rest), overlay.isCageInked ? marks.ink() : cageColour());
        for (std::size_t k = 0; k < cage->current.size(); ++k)
            marks.addNumber(cage->current[k], k + 1, marks.halo(), marks.ink());
    }
    return marks.taken();
}

std::vector<ifs::Vector<3>> spaceOverlayPoints(const document::Fractal& fractal,
                                               const PictureOverlay& overlay) {
    std::vector<ifs::Vector<3>> points;
    const auto cage = document::spaceCage(fractal);
    if (cage && overlay.cage) points = cage->current;
    const auto handles = overlay.maps ? handlesOf(fractal, cage) : std::nullopt;
    for (std::size_t i = 0; handles && i < handles->count(); ++i)
        for (const ifs::Vector<3>& corner : handles->corners(i))
            points.push_back(corner);
    return points;
}

} // namespace io
