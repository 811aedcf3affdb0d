// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/geometry/canvas_part.h"
#include "document/document.h"

#include <QObject>

#include <vector>

namespace view {

// The maps and vertices that are selected, and the parts that the pointer and the keyboard are at.
class CanvasSelection : public QObject {
    Q_OBJECT

public:
    explicit CanvasSelection(const document::Document& document) : m_document(document) {}

    const std::vector<ifs::MapId>& maps() const { return m_maps; } // in the order of the system
    void setMaps(const std::vector<ifs::MapId>& maps); // ignores ids that the system does not have
    std::vector<std::size_t> mapIndices() const;       // indices in the system
    void setMapIndices(const std::vector<std::size_t>& indices);
    bool isMapSelected(int index) const;
    int mapCount() const; // number of maps in the system, selected or not

    // The map that the pointer is at elsewhere in the window; none mostly.
    ifs::MapId pointed() const { return m_pointed; }
    void setPointed(ifs::MapId map);

    // Vertices of the cage that move together, in increasing order.
    const std::vector<std::size_t>& vertices() const { return m_vertices; }
    void setVertices(std::vector<std::size_t> vertices);

    CanvasPart hovered() const { return m_hovered; }
    CanvasPart pressed() const { return m_pressed; }
    CanvasPart focused() const { return m_focused; }
    void setHovered(CanvasPart part);
    void setPressed(CanvasPart part);
    void setFocused(CanvasPart part);

    void clear(); // keeps what is pressed and hovered

signals:
    void mapsChanged();
    void pointedChanged();
    void verticesChanged();
    void marksChanged(); // sent for hovered, pressed and focused parts
    void focusChanged();
    void focusMoved(); // sent when the part in focus has moved

private:
    const std::vector<ifs::WeightedMap<2>>& systemMaps() const;

    const document::Document& m_document;
    std::vector<ifs::MapId> m_maps;
    ifs::MapId m_pointed = ifs::MapId::None;
    std::vector<std::size_t> m_vertices;
    CanvasPart m_hovered;
    CanvasPart m_pressed;
    CanvasPart m_focused;
};

} // namespace view
