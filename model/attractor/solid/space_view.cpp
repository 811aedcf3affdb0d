// SPDX-License-Identifier: MIT
#include "attractor/solid/space_view.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

// The axes from the world, relative to the target, to SpaceView::toPixels. An eye beside the camera's sees
// points behind the target shifted to its own side.
ifs::Matrix<3> pixelAxes(const OrbitCamera& camera, double eyeShift) {
    const double scale = pixelsPerUnit(camera);
    ifs::Matrix<3> axes = ifs::Vector<3>(scale, -scale, scale).asDiagonal() * worldToCamera(camera).linear;
    axes.row(0) += eyeShift * axes.row(2);
    return axes;
}

PixelClip inPixels(const SpaceClip& clip, const OrbitCamera& camera, double eyeShift) {
    const ifs::Vector<3> normal =
        pixelAxes(camera, eyeShift).transpose().partialPivLu().solve(clip.normal.normalized());
    const double length = normal.norm();
    const double unit = clip.normal.norm();
    const double middle = clip.normal.normalized().dot(camera.target);
    PixelClip result{normal / length, (clip.lowest / unit - middle) / length,
                     (clip.highest / unit - middle) / length};
    const double missing = 1 - (result.highest - result.lowest);
    if (missing > 0) {
        result.lowest -= missing / 2;
        result.highest += missing / 2;
    }
    return result;
}

} // namespace

SpaceView spaceView(const OrbitCamera& camera, const ifs::AffineMap<3>& cage, double eyeShift) {
    SpaceView view;
    view.size = camera.size;
    const double scale = pixelsPerUnit(camera);
    const ifs::Matrix<3> axes = pixelAxes(camera, eyeShift);
    // Subtracts the target before magnifying.
    view.toPixels = {axes * cage.linear, axes * (cage.translation - camera.target)};
    if (camera.projection == OrbitCamera::Projection::Perspective)
        view.eyeDistance = scale * eyeDistance(camera);
    return view;
}

SpaceView spaceView(const SpaceRequest& request, const ifs::AffineMap<3>& cage) {
    SpaceView view = spaceView(request.camera, cage, request.eyeShift);
    if (request.clip && isUsable(*request.clip) && isUsable(request.camera))
        view.clip = inPixels(*request.clip, request.camera, request.eyeShift);
    if (request.cage && ifs::isValid(*request.cage) && ifs::bends(*request.cage)) {
        view.bend = std::make_shared<const ifs::CageDeformation>(request.cage->rest, request.cage->current);
        view.afterBend = spaceView(request.camera, {}, request.eyeShift).toPixels;
        view.toPixels = {};
    }
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

StraightWord straightened(const ifs::AffineMap<3>& word, const SpaceView& view) {
    if (!view.bend) return {word};
    const ifs::CageDeformation& bend = *view.bend;
    StraightWord result;
    const ifs::AffineMap<3>& toPixels = view.afterBend;
    const ifs::Vector<3> middle = bend(word.translation);
    ifs::Vector<3> along = ifs::Vector<3>::Zero(); // offsets of the midpoints of the sides
    for (int side = 0; side < 3; ++side) {
        const ifs::Vector<3> high = bend(word.translation + word.linear.col(side));
        const ifs::Vector<3> low = bend(word.translation - word.linear.col(side));
        const ifs::Vector<3> off = toPixels.linear * ((high + low) / 2 - middle);
        result.word.linear.col(side) = toPixels.linear * ((high - low) / 2);
        result.miss += off.cwiseAbs();
        along += off;
    }
    result.word.translation = toPixels(middle);
    // Mixed terms of two directions: each corner shows those of one of these four.
    ifs::Vector<3> mixed = ifs::Vector<3>::Zero();
    for (const auto& corner : {ifs::Vector<3>(1, 1, 1), ifs::Vector<3>(1, -1, -1), ifs::Vector<3>(-1, 1, -1),
                               ifs::Vector<3>(-1, -1, 1)}) {
        const ifs::Vector<3> off = toPixels(bend(word(corner))) - result.word(corner) - along;
        mixed = mixed.cwiseMax(off.cwiseAbs());
    }
    constexpr double beyond = 1.5; // factor for terms of higher order
    result.miss = beyond * (result.miss + mixed);
    return result;
}

namespace {

constexpr double maxModelPixels = 0x1p-4; // error bound of a BentWord, in pixels

// The square of a coordinate runs from 0 to 1: with half of it in the middle, it misses but the other half.
StraightWord straightened(const BentWord& model, const ifs::AffineMap<3>& within) {
    StraightWord result;
    result.miss = model.miss;
    const ifs::Vector<3>& at = within.translation;
    result.word.translation = model.middle + model.linear * at;
    result.word.linear = model.linear * within.linear;
    for (int row = 0; row < 3; ++row) {
        const ifs::Matrix<3>& second = model.second[std::size_t(row)];
        const ifs::Vector<3> slope = second * at;
        const ifs::Matrix<3> left = within.linear.transpose() * second * within.linear;
        result.word.translation[row] += at.dot(slope) / 2 + left.trace() / 4;
        result.word.linear.row(row) += slope.transpose() * within.linear;
        result.miss[row] += left.diagonal().cwiseAbs().sum() / 4 + std::abs(left(0, 1)) +
                            std::abs(left(0, 2)) + std::abs(left(1, 2));
    }
    return result;
}

// The bend of the word itself: from the tree if it has the address, else from the cage.
std::shared_ptr<const BentWord> bentWord(const WalkedWord& word, const SpaceView& view) {
    if (view.bends && word.node != nullptr)
        if (const BentWord* known = view.bends->bent(*word.node, word.word))
            return {std::shared_ptr<const void>(), known}; // owned by the tree
    const PixelBend bend(*view.bend, view.afterBend);
    return std::make_shared<const BentWord>(
        WordCoordinates(*view.bend->rest(), word.word).bent(word.word, bend));
}

// Ratio of the displayed size at that place to that in the plane of the target.
double magnification(const ifs::Vector<3>& middle, const SpaceView& view) {
    if (!view.isPerspective()) return 1;
    return std::max(1.0, view.eyeDistance / std::max(1.0, view.eyeDistance + middle.z()));
}

} // namespace

WalkedWord WalkedWord::inside(const ifs::AffineMap<3>& map) const {
    return {word * map, nullptr, bent, bent ? within * map : ifs::AffineMap<3>(), follows};
}

WalkedWord rootWord(const ifs::AffineMap<3>& box, const SpaceView& view) {
    return {box, view.bends ? view.bends->root() : nullptr};
}

WalkedWord childWord(const WalkedWord& word, std::size_t index, const ifs::AffineMap<3>& map,
                     const SpaceView& view) {
    WalkedWord result = word.inside(map);
    if (word.node != nullptr && !word.follows) result.node = view.bends->child(*word.node, index);
    return result;
}

WalkedWord walkedTo(const ifs::Word& address, WalkedWord word, std::span<const ifs::AffineMap<3>> maps,
                    const SpaceView& view) {
    for (const int letter : address) {
        const auto index = static_cast<std::size_t>(letter);
        word = childWord(word, index, maps[index], view);
    }
    return word;
}

StraightWord straightened(WalkedWord& word, const SpaceView& view) {
    if (!view.bend) return {word.word};
    if (word.follows) {
        StraightWord result = straightened(*word.bent, word.within);
        // Twice, because the word may be nearer to the eye than the bent one.
        const double most = 2 * maxModelPixels;
        if (word.bent->miss.maxCoeff() * magnification(result.word.translation, view) <= most) return result;
    }
    word.bent = bentWord(word, view);
    word.within = {};
    const BentWord& model = *word.bent;
    word.follows = model.miss.maxCoeff() * magnification(model.middle, view) <= maxModelPixels;
    return straightened(model, {});
}

namespace {

// The displayed word. With W the distance of the word's middle from the eye and d the first-order change of
// x: the point whose depth differs by c is seen at x + d·W/(W + c).
SeenWord seen(const StraightWord& straight, const SpaceView& view) {
    SeenWord result;
    result.onScreen = straight.word;
    ifs::Vector<3>& middle = result.onScreen.translation;
    ifs::Matrix<3>& linear = result.onScreen.linear;
    const double depth = linear.row(2).cwiseAbs().sum() + straight.miss.z();
    if (view.clip) {
        const double at = view.clip->normal.dot(middle);
        const double half = (view.clip->normal.transpose() * linear).cwiseAbs().sum() + straight.miss.norm();
        result.isBehind = !(at + half >= view.clip->lowest && at - half <= view.clip->highest);
        if (result.isBehind) return result;
        result.isCut = at - half < view.clip->lowest || at + half > view.clip->highest;
    }
    if (view.isPerspective()) {
        const double away = view.eyeDistance + middle.z();
        const double least = nearestShare * view.eyeDistance;
        result.isBehind = away + depth < least;
        result.reachesEye = !(away - depth >= least);
        if (result.reachesEye) {
            result.half.setConstant(depth);
            // Width of the view at this depth.
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
        result.half.head<2>() += result.scale * straight.miss.head<2>();
        result.half.z() += straight.miss.z();
        const double share = depth / (away - depth);
        const ifs::Vector<2> miss = share * result.half.head<2>();
        result.half.head<2>() += miss;
        result.miss = miss.maxCoeff() + result.scale * straight.miss.maxCoeff();
    } else {
        result.half = linear.cwiseAbs().rowwise().sum();
        result.half += straight.miss;
        result.miss = straight.miss.maxCoeff();
    }
    middle.x() += view.size.width / 2.0;
    middle.y() += view.size.height / 2.0;
    return result;
}

} // namespace

SeenWord seen(const ifs::AffineMap<3>& word, const SpaceView& view) {
    return seen(straightened(word, view), view);
}

SeenWord seen(WalkedWord& word, const SpaceView& view) {
    return seen(straightened(word, view), view);
}

SeenWord glimpsed(WalkedWord& word, const SpaceView& view) {
    if (!view.bend || word.follows || !word.bent) return seen(word, view);
    return seen(straightened(*word.bent, word.within), view);
}

} // namespace attractor
