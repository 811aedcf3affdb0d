// SPDX-License-Identifier: MIT
#include "canvas/scene/frame_layout.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/edits/maps/map_locks.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace view {

namespace {

// The most frames of maps; more, and their moves, would take longer than an event of a drag may.
constexpr std::size_t maxFrames = 10'000;
constexpr std::size_t maxSelected = 1000; // selected maps that are never left out

class Builder {
public:
    Builder(const HandleModel& handles, const CanvasSelection& selection, const document::Fractal& fractal,
            const attractor::Camera& camera)
        : m_handles(handles),
          m_fractal(fractal),
          m_camera(camera),
          m_focused(selection.focused().map),
          m_isSelected(std::size_t(selection.mapCount()), false) {
        for (const std::size_t index : selection.mapIndices())
            m_isSelected[index] = true;
    }

    FrameLayout hint(ifs::MapId pointed) {
        const auto& maps = document::system2(m_fractal)->maps;
        const auto map = std::ranges::find(maps, pointed, &ifs::WeightedMap<2>::id);
        if (pointed == ifs::MapId::None || map == maps.end()) return {};
        const auto index = std::size_t(map - maps.begin());
        add(*m_handles.maps(), index, {}, colourOf(index), true);
        return std::move(m_layout);
    }

    FrameLayout maps() {
        const document::MapHandles& maps = *m_handles.maps();
        for (const std::size_t index : shown(maps))
            add(maps, index, maps.corners(index), colourOf(index), m_isSelected[index]);
        if (!m_fractal.mapLabels.isEmpty())
            for (MapFrame& frame : m_layout.frames)
                frame.isLocked = document::isLocked(m_fractal, std::size_t(frame.index));
        return std::move(m_layout);
    }

    FrameLayout branch() {
        if (const document::MapHandles* map = m_handles.branchMap())
            add(*map, 0, map->corners(0), colourOf(std::size_t(m_handles.branch().front())), true);
        return std::move(m_layout);
    }

private:
    QColor colourOf(std::size_t index) const {
        const attractor::Rgba colour = m_handles.colourOf(index);
        return {colour.red, colour.green, colour.blue};
    }

    void add(const document::MapHandles& maps, std::size_t index, const std::vector<ifs::Vector<2>>& corners,
             const QColor& colour, bool selected) {
        m_layout.frames.push_back({int(index), pixelsOf(m_camera, corners),
                                   pixelsOf(m_camera, maps.outline(index)), colour, selected,
                                   maps.maps()[index].enabled});
    }

    // Maps to show. If there are too many, those near the view; if these are too many, every n-th one of
    // them.
    std::vector<std::size_t> shown(const document::MapHandles& maps) {
        std::vector<std::size_t> indices(maps.count());
        std::iota(indices.begin(), indices.end(), std::size_t(0));
        if (indices.size() <= maxFrames) return indices;
        const bool keepsSelected = std::ranges::count(m_isSelected, true) <= std::ptrdiff_t(maxSelected);
        const auto mayGo = [&](std::size_t index) {
            return !(keepsSelected && m_isSelected[index]) && int(index) != m_focused;
        };
        const QRectF view(0, 0, m_camera.width, m_camera.height);
        const QSizeF margin = maps.bends() ? view.size() : QSizeF(1, 1);
        const QRectF near = view.adjusted(-margin.width(), -margin.height(), margin.width(), margin.height());
        const std::vector<document::Box> boxes = maps.boxes();
        std::erase_if(indices, [&](std::size_t index) {
            const QRectF box = pixelsOf(m_camera, boxes[index].min, boxes[index].max)
                                   .adjusted(-1, -1, 1, 1); // enlarged, because flat boxes are empty
            return mayGo(index) && !near.intersects(box);
        });
        const std::size_t stride = (indices.size() + maxFrames - 1) / maxFrames;
        m_layout.isThinnedOut = stride > 1;
        if (m_layout.isThinnedOut)
            std::erase_if(indices, [&, k = std::size_t(0)](std::size_t index) mutable {
                return k++ % stride != 0 && mayGo(index);
            });
        return indices;
    }

    const HandleModel& m_handles;
    const document::Fractal& m_fractal;
    const attractor::Camera& m_camera;
    int m_focused;
    std::vector<bool> m_isSelected;
    FrameLayout m_layout;
};

} // namespace

FrameLayout frameLayout(const HandleModel& handles, const CanvasSelection& selection,
                        const document::Fractal& fractal, const attractor::Camera& camera) {
    if (!handles.cage()) return {};
    Builder builder(handles, selection, fractal, camera);
    switch (handles.target()) {
    case HandleTarget::Maps:
        return builder.maps();
    case HandleTarget::Branch:
        return builder.branch();
    case HandleTarget::Cage:
        break;
    }
    return builder.hint(selection.pointed());
}

} // namespace view
