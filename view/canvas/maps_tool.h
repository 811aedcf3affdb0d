// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/polygon_tool.h"
#include "document/map_handles.h"

namespace view {

// Takes the maps by the images of the cage: selects them, moves a corner, or moves, turns and scales all that
// are selected.
class MapsTool : public PolygonTool {
    Q_OBJECT

public:
    using PolygonTool::PolygonTool;

    // A drag stops where the attractor would be lost, unless this is allowed.
    void setAllowsNoAttractor(bool allows) { m_allowsNoAttractor = allows; }
    bool allowsNoAttractor() const { return m_allowsNoAttractor; }
    // How much of a change, after(0) to after(1), may be shown: all of it, or as much as leaves an attractor.
    // Then the canvas says why.
    double shareToShow(const std::function<document::Fractal(double)>& after);

    void walk(int step) override;
    bool keyPress(const QKeyEvent& event) override;
    void start() override;
    void stop() override;

protected:
    std::optional<Grip> grip(const CanvasPart& part, PolygonDrag::Mode mode) override;
    double preview(const std::function<DragResult(double)>& resultAt) override;
    void taken(const CanvasPart& part, Qt::KeyboardModifiers modifiers) override;
    void clicked(const CanvasPart& part, const Pointer& pointer) override;
    void ended() override;
    std::optional<std::vector<std::size_t>> selection() const override;
    void setSelection(const std::vector<std::size_t>& places) override;
    std::vector<std::size_t> enclosedBy(const QRectF& band) const override;

    // What a press on the part takes: the handles of the moment, and the places among them. Empty: nothing.
    struct Taken {
        std::optional<document::MapHandles> handles;
        std::vector<std::size_t> places;
    };
    virtual Taken take(const CanvasPart& part);
    virtual QString stepText(PolygonDrag::Mode mode, std::optional<std::size_t> corner) const;
    const std::vector<std::size_t>& places() const { return m_places; }

private:
    document::Fractal after(const DragResult& result) const;
    void selectOnly(int place);

    bool m_allowsNoAttractor = false;
    std::optional<document::MapHandles> m_handles; // at the press
    std::vector<std::size_t> m_places;             // of the maps that move
    std::optional<std::size_t> m_corner;           // when only this one of the first does
};

} // namespace view
