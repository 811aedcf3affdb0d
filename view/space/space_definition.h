// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "ifs/system/barycentric.h"
#include "space/space_outlines_item.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace view {

// A control tetrahedron as it is defined with four clicks: three in the plane through the target that was
// parallel to the screen at the first one, the fourth in a plane parallel to it, as far towards the eye as
// makes the tetrahedron about regular. The view may turn in between.
class SpaceDefinition {
    Q_DECLARE_TR_FUNCTIONS(SpaceDefinition)

public:
    explicit SpaceDefinition(SpaceOutlinesItem& lines) : m_lines(lines) {}

    bool isActive() const { return m_isActive; }
    void setActive(bool active);

    // The tetrahedron once this is the fourth click; one on an earlier point, or along the plane, counts for
    // nothing.
    std::optional<ifs::Simplex<3>> click(const attractor::OrbitCamera& camera, const ifs::Vector<2>& pixel);
    void follow(const attractor::OrbitCamera& camera,
                const ifs::Vector<2>& pixel); // vertex that a click would set
    bool hasBegun() const { return !m_points.empty(); }
    bool isLifting() const { return m_points.size() == 3; }
    void lift(double share); // distance towards the eye, in heights of the regular tetrahedron
    bool takeBack();         // removes the last point; false if there is none
    QString prompt() const;  // text for the next click; empty while inactive

private:
    std::optional<ifs::Vector<3>> pointAt(const attractor::OrbitCamera& camera,
                                          const ifs::Vector<2>& pixel) const;
    double regularHeight() const;
    void show();

    SpaceOutlinesItem& m_lines;
    std::vector<ifs::Vector<3>> m_points;
    std::optional<ifs::Vector<3>> m_next;
    ifs::Vector<3> m_origin = ifs::Vector<3>::Zero(); // origin of the plane
    ifs::Vector<3> m_normal = ifs::Vector<3>::UnitZ();
    double m_lift = 1; // height of the fourth point, in heights of the regular tetrahedron
    bool m_isActive = false;
};

} // namespace view
