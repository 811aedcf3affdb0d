// SPDX-License-Identifier: MIT
#include "attractor/solid/space_view.h"

#include <algorithm>

namespace attractor {

SpaceView spaceView(const OrbitCamera& camera, const ifs::AffineMap<3>& cage) {
    SpaceView view;
    view.size = camera.size;
    const double scale = pixelsPerUnit(camera);
    const ifs::Matrix<3> axes =
        ifs::Vector<3>(scale, -scale, scale).asDiagonal() * worldToCamera(camera).linear;
    // Relative to the target before it is magnified.
    view.toPixels = {axes * cage.linear, axes * (cage.translation - camera.target)};
    if (camera.projection == OrbitCamera::Projection::Perspective)
        view.eyeDistance = scale * eyeDistance(camera);
    return view;
}

double SeenWord::size() const {
    return 2 * std::max({half.x(), half.y(), half.z() * scale});
}

bool SeenWord::meets(const RasterSize& size) const {
    if (isBehind) return false;
    if (reachesEye) return true;
    const double x = onScreen.translation.x();
    const double y = onScreen.translation.y();
    return x + half.x() >= 0 && x - half.x() <= size.width && y + half.y() >= 0 &&
           y - half.y() <= size.height;
}

// With W the distance of the word's middle from the eye and d the first-order change of x: the point whose
// depth differs by c is seen at x + d·W/(W + c).
SeenWord seen(const ifs::AffineMap<3>& word, const SpaceView& view) {
    SeenWord result;
    result.onScreen = word;
    ifs::Vector<3>& middle = result.onScreen.translation;
    ifs::Matrix<3>& linear = result.onScreen.linear;
    const double depth = linear.row(2).cwiseAbs().sum();
    if (view.isPerspective()) {
        const double away = view.eyeDistance + middle.z();
        const double least = nearestShare * view.eyeDistance;
        result.isBehind = away + depth < least;
        result.reachesEye = !(away - depth >= least);
        if (result.reachesEye) {
            result.half.setConstant(depth);
            // The farther from the eye, the wider the view is.
            const double widest = (away + depth) / (2 * view.eyeDistance);
            const ifs::Vector<2> nearest =
                middle.head<2>().cwiseAbs() - linear.topRows<2>().cwiseAbs().rowwise().sum();
            if (nearest.x() > widest * view.size.width || nearest.y() > widest * view.size.height)
                result.isBehind = true;
            return result;
        }
        result.scale = view.eyeDistance / away;
        for (int row = 0; row < 2; ++row) {
            linear.row(row) = result.scale * (linear.row(row) - middle[row] / away * linear.row(2));
            middle[row] *= result.scale;
        }
        result.half = linear.cwiseAbs().rowwise().sum();
        const double share = depth / (away - depth);
        const ifs::Vector<2> miss = share * result.half.head<2>();
        result.half.head<2>() += miss;
        result.miss = miss.maxCoeff();
    } else {
        result.half = linear.cwiseAbs().rowwise().sum();
    }
    middle.x() += view.size.width / 2.0;
    middle.y() += view.size.height / 2.0;
    return result;
}

} // namespace attractor
