// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/tools/polygon_tool.h"
#include "document/maps/map_handles.h"

namespace view {

// Drags the maps by the images of the cage: selects them, moves a corner, or moves, turns and scales all that
// are selected.
class MapsTool : public PolygonTool {
    Q_OBJECT

public:
    using PolygonTool::PolygonTool;

    // A drag stops where the attractor would be lost, unless this is allowed.
    void setAllowsNoAttractor(bool allows) { m_allowsNoAttractor = allows; }
    bool allowsNoAttractor() const { return m_allowsNoAttractor; }
    // The share of a change, after(0) to after(1), that may be shown: all of it, or as much as leaves an
    // attractor. Then the canvas says why. The result of `after` must live until the next call.
    virtual double shareToShow(const std::function<const document::Fractal&(double)>& after);
    void dismissStop(); // removes the sentence of the last stop

    bool walk(int step) override;
    bool keyPress(const QKeyEvent& event) override;
    void start() override;
    void stop() override;

protected:
    std::optional<DragSubject> dragSubject(const CanvasPart& part, DragMode mode) override;
    Shown preview(const std::function<DragResult(double)>& resultAt) override;
    void pressed(const CanvasPart& part, Qt::KeyboardModifiers modifiers) override;
    void clicked(const CanvasPart& part, const Pointer& pointer) override;
    void ended() override;
    std::optional<std::vector<std::size_t>> selectedItems() const override;
    void selectItems(const std::vector<std::size_t>& indices) override;
    std::vector<std::size_t> enclosedBy(const QRectF& band) const override;

    // Maps held by a press: all maps as they are at the press, and the indices of those that move. Empty if
    // the press holds nothing.
    struct HeldMaps {
        std::optional<document::MapHandles> maps;
        std::vector<std::size_t> indices;
    };
    virtual HeldMaps hold(const CanvasPart& part);
    virtual QString stepText(DragMode mode, std::optional<std::size_t> corner) const;

private:
    document::Fractal after(const DragResult& result) const;
    void selectOnly(int index);

    bool m_allowsNoAttractor = false;
    HeldMaps m_held;                     // state at the press
    std::optional<std::size_t> m_corner; // corner of the first map, if it moves alone
};

} // namespace view
