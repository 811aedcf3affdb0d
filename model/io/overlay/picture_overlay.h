// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/fractal.h"

#include <QColor>
#include <QImage>
#include <QPolygonF>

#include <vector>

namespace io {

// What explains a picture, drawn over it.
struct PictureOverlay {
    bool maps = false;        // the image of the cage under each map, in the map's colour
    bool hull = false;        // the convex hull of the attractor
    bool cage = false;        // the current polygon, and the rest polygon dashed where it differs
    bool fixedPoints = false; // of the maps
    bool numbers = false;     // of the maps, each in its image of the cage

    friend bool operator==(const PictureOverlay&, const PictureOverlay&) = default;
};

// The shapes of an overlay, worked out once for all rows of a picture. Needs a QGuiApplication for the
// letters.
class OverlayShapes {
public:
    // The fractal is a system of the plane.
    OverlayShapes(const document::Fractal& fractal, const attractor::Camera& camera,
                  const PictureOverlay& overlay);

    // Over the rows of the picture from `firstRow` on.
    void paint(QImage& rows, int firstRow) const;

private:
    struct Map {
        std::size_t number = 0; // from 1
        QPolygonF image;        // of the cage
        QColor colour;
        bool takesPart = true;
        bool hasFixedPoint = false;
        QPointF fixedPoint;
    };
    void addMaps(const document::Fractal& fractal);
    void addHull(const document::Fractal& fractal);
    void paintMap(QPainter& painter, const Map& map) const;
    void paintFixedPoint(QPainter& painter, const Map& map) const;
    void paintNumber(QPainter& painter, const Map& map) const;
    QPointF onScreen(const ifs::Vector<2>& displayed) const;

    attractor::Camera m_camera;
    PictureOverlay m_overlay;
    document::Fractal m_fractal; // for its cage
    std::vector<Map> m_maps;
    QPolygonF m_hull;
    QColor m_ink, m_halo; // on this background
    double m_width = 1;   // of a line, in pixels
};

} // namespace io
