// SPDX-License-Identifier: MIT
#include "io/animation/frames_view.h"

#include "attractor/samples/prepared_space.h"
#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "ifs/extent/support_function.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace io {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Moments sampled for the view of all frames; margins cover the time between them.
std::vector<animation::Moment> sampled(const document::Fractal& entry, int most) {
    const document::AnimationFacts facts = *document::animationFacts(entry);
    return document::moments(facts, std::min(most, facts.length + 1));
}

bool isLost(const document::Fractal& entry, const animation::Moment& moment) {
    return document::lossAt(entry, moment) == ifs::Verdict::None;
}

struct FrameSupport {
    attractor::Support support;
    bool isCertified = true;
};

// The support function of one frame, as it is displayed.
FrameSupport supportOf(const document::Shape<3>& shape) {
    if (shape.cage && ifs::bends(*shape.cage)) return {document::reachOfVertices(shape.cage->current)};
    const attractor::PreparedSpace system = attractor::preparedSpace(shape.system);
    const ifs::AffineMap<3> cage = shape.cage ? ifs::displayMap(*shape.cage) : ifs::AffineMap<3>();
    auto support = system.isCertified ? ifs::SupportFunction<3>::of(system.maps) : std::nullopt;
    std::vector<ifs::AffineMap<3>> pieces = document::shownPieces(shape);
    for (ifs::AffineMap<3>& piece : pieces)
        piece = cage * piece;
    const auto farthest = [pieces](const auto& reach) {
        double result = -infinity;
        for (const ifs::AffineMap<3>& placed : pieces)
            result = std::max(result, reach(placed));
        return result;
    };
    if (!support)
        return {[=, centre = system.centre, halfExtent = system.halfExtent](const ifs::Vector<3>& u) {
                    return farthest([&](const ifs::AffineMap<3>& placed) {
                        const ifs::Vector<3> inner = placed.linear.transpose() * u;
                        return u.dot(placed(centre)) + inner.cwiseAbs().dot(halfExtent);
                    });
                },
                false};
    const auto shared = std::make_shared<const ifs::SupportFunction<3>>(*std::move(support));
    return {[=](const ifs::Vector<3>& u) {
        constexpr double tolerance = 1e-4; // relative to the size; margins are hundreds of times wider
        return farthest([&](const ifs::AffineMap<3>& placed) {
            const ifs::Vector<3> inner = placed.linear.transpose() * u;
            const auto value = (*shared)(inner, tolerance * shared->radius() * inner.norm());
            return u.dot(placed.translation) + value.value + value.error;
        });
    }};
}

} // namespace

ViewBox boxOfAttractor(const document::Fractal& fractal, attractor::YAxis yAxis) {
    if (const auto box = document::boxWithShadow(fractal, yAxis)) return {box->min, box->max, true};
    const attractor::PreparedSystem system =
        attractor::prepared(*document::system2(fractal), document::movedBranches(fractal));
    const ifs::Placement toDisplay = document::placement(fractal);
    ViewBox box{ifs::Vector<2>::Constant(infinity), ifs::Vector<2>::Constant(-infinity), false};
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            const ifs::Vector<2> corner =
                toDisplay(system.centre + ifs::Vector<2>(x, y).cwiseProduct(system.halfExtent));
            box.min = box.min.cwiseMin(corner);
            box.max = box.max.cwiseMax(corner);
        }
    return box;
}

ViewBox boxOfFrames(const document::Fractal& entry, attractor::YAxis yAxis) {
    constexpr int maxMoments = 121;
    std::optional<ViewBox> found, lost;
    for (const animation::Moment& moment : sampled(entry, maxMoments)) {
        const ViewBox next = boxOfAttractor(document::frameAt(entry, moment).fractal, yAxis);
        std::optional<ViewBox>& all = !next.certified && isLost(entry, moment) ? lost : found;
        if (!all) all = next;
        all->min = all->min.cwiseMin(next.min);
        all->max = all->max.cwiseMax(next.max);
        all->certified = all->certified && next.certified;
    }
    return found ? *found : *lost;
}

attractor::Support supportOfFrames(const document::Fractal& entry) {
    constexpr int maxMoments = 33;
    std::vector<attractor::Support> supports, lost;
    for (const animation::Moment& moment : sampled(entry, maxMoments)) {
        const document::AnimatedFrame frame = document::frameAt(entry, moment);
        FrameSupport next = supportOf(*document::space(frame.fractal));
        next.support = supportBefore(frame.orbit, std::move(next.support));
        std::vector<attractor::Support>& all = !next.isCertified && isLost(entry, moment) ? lost : supports;
        all.push_back(std::move(next.support));
    }
    if (supports.empty()) supports = std::move(lost);
    return [supports = std::move(supports)](const ifs::Vector<3>& u) {
        double farthest = -infinity;
        for (const attractor::Support& support : supports)
            farthest = std::max(farthest, support(u));
        return farthest;
    };
}

attractor::Support supportBefore(std::span<const animation::CameraTurn> turns, attractor::Support support) {
    const auto motion = animation::motionOf(turns);
    if (!motion || turns.empty()) return support;
    return [support = std::move(support), motion = *motion](const ifs::Vector<3>& u) {
        const ifs::Vector<3> turned = motion.linear * u;
        return support(turned) - turned.dot(motion.translation);
    };
}

attractor::OrbitCamera cameraOfFrame(const attractor::OrbitCamera& atRest,
                                     std::span<const animation::CameraTurn> turns,
                                     const attractor::Support& allFrames, double margin) {
    if (animation::motionOf(turns)) // also true for no turns
        return animation::orbited(attractor::fitted(atRest, allFrames, margin), turns);
    return attractor::fitted(animation::orbited(atRest, turns), allFrames, margin);
}

attractor::OrbitCamera cameraOfFrames(document::Fractal entry, const attractor::OrbitCamera& camera) {
    using animation::OrbitPivot;
    std::vector<animation::Orbit<3>*> aboutTarget;
    for (animation::Motion<3>& motion : document::space(entry)->animation->motions)
        if (auto* orbit = std::get_if<animation::Orbit<3>>(&motion);
            orbit && orbit->pivot == OrbitPivot::Target)
            aboutTarget.push_back(orbit);
    attractor::Support all = supportOfFrames(entry);
    if (aboutTarget.empty()) return attractor::fitted(camera, all);
    // The target can be any point on the axis: the middle. Extents around it are made equal on all sides, so
    // that it is also in the middle of the view.
    ifs::Vector<3> middle;
    for (int i = 0; i < 3; ++i)
        middle[i] = (all(ifs::Vector<3>::Unit(i)) - all(-ifs::Vector<3>::Unit(i))) / 2;
    for (animation::Orbit<3>* orbit : aboutTarget) {
        orbit->centre = middle;
        orbit->pivot = OrbitPivot::Centre;
    }
    all = supportOfFrames(entry);
    const ifs::Matrix<3> axes = camera.orientation.toRotationMatrix();
    return attractor::fitted(camera, [&](const ifs::Vector<3>& u) {
        const ifs::Vector<3> inView = axes.transpose() * u;
        double farthest = -infinity;
        for (int signs = 0; signs < 8; ++signs) {
            const ifs::Vector<3> flip(1 - 2 * (signs & 1), 1 - (signs & 2), 1 - 2 * (signs >> 2));
            const ifs::Vector<3> mirrored = axes * inView.cwiseProduct(flip);
            farthest = std::max(farthest, all(mirrored) - mirrored.dot(middle));
        }
        return farthest + u.dot(middle);
    });
}

bool hasCameraKeys(const document::Fractal& entry) {
    if (const auto* shape = document::plane(entry)) return !shape->animation->camera.empty();
    return !document::space(entry)->animation->camera.empty();
}

} // namespace io
