// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <QObject>
#include <QPointF>

namespace view {

// The view of a canvas, changed by gestures alike in plane and space. Positions are pixels of the viewport.
class ViewNavigation : public QObject {
    Q_OBJECT

public:
    virtual void adoptViewport() = 0; // adopts size and pixel ratio of the viewport
    virtual QPointF middle() const = 0;
    virtual void fit() = 0;
    virtual bool isFitted() const = 0; // true if fitted and not moved by the user since
    virtual void zoomAt(const QPointF& position, double factor) = 0;
    virtual void resetZoom() = 0;                                      // 100 %: one unit is a hundred pixels
    virtual void twistAt(const QPointF& position, double degrees) = 0; // clockwise rotation by two fingers

    // The view is held as it is now. From there moveHeld() zooms it about a position, then shifts it.
    virtual void hold() = 0;
    virtual void moveHeld(const QPointF& shift, const QPointF& about = {}, double factor = 1) = 0;
    virtual void restoreHeld() = 0;

protected:
    template <class Camera>
    static Camera moved(const Camera& held, const QPointF& shift, const QPointF& about, double factor) {
        const Camera zoomed = factor == 1 ? held : zoomedAt(held, {about.x(), about.y()}, factor);
        return panned(zoomed, {shift.x(), shift.y()});
    }
};

} // namespace view
