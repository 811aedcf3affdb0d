// SPDX-License-Identifier: MIT
#include "shown_frame.h"

#include "arguments.h"
#include "usage_error.h"

#include "attractor/samples/prepared_space.h"
#include "document/space_geometry.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>
#include <memory>

namespace cli {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

// Moments that are looked at for the view of all frames; margins cover what is between them.
std::vector<animation::Moment> sampled(const document::AnimationFacts& facts, int most) {
    return document::moments(facts, std::min(most, facts.length + 1));
}

ViewBox boxOfFrames(const document::Fractal& entry, const document::AnimationFacts& facts) {
    constexpr int most = 121;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ViewBox box{ifs::Vector<2>::Constant(infinity), ifs::Vector<2>::Constant(-infinity), true};
    for (const animation::Moment& moment : sampled(facts, most)) {
        const ViewBox next = boxOfAttractor(document::frameAt(entry, moment).fractal);
        box.min = box.min.cwiseMin(next.min);
        box.max = box.max.cwiseMax(next.max);
        box.certified = box.certified && next.certified;
    }
    return box;
}

// The support function of one frame, as it is displayed.
attractor::Support supportOf(const document::Shape<3>& shape) {
    if (shape.cage && ifs::bends(*shape.cage)) return document::reachOfVertices(shape.cage->current);
    const attractor::PreparedSpace system = attractor::preparedSpace(shape.system);
    const ifs::AffineMap<3> cage = shape.cage ? ifs::displayMap(*shape.cage) : ifs::AffineMap<3>();
    auto support = system.isCertified ? ifs::SupportFunction<3>::of(system.maps) : std::nullopt;
    if (!support)
        return [=, centre = system.centre, halfExtent = system.halfExtent](const ifs::Vector<3>& u) {
            const ifs::Vector<3> inner = cage.linear.transpose() * u;
            return u.dot(cage(centre)) + inner.cwiseAbs().dot(halfExtent);
        };
    const auto shared = std::make_shared<const ifs::SupportFunction<3>>(*std::move(support));
    return [=](const ifs::Vector<3>& u) {
        constexpr double tolerance = 1e-4; // of the size: a margin is hundreds of times wider
        const ifs::Vector<3> inner = cage.linear.transpose() * u;
        const auto value = (*shared)(inner, tolerance * shared->radius() * inner.norm());
        return u.dot(cage.translation) + value.value + value.error;
    };
}

attractor::Support supportOfFrames(const document::Fractal& entry, const document::AnimationFacts& facts) {
    constexpr int most = 33;
    std::vector<attractor::Support> supports;
    for (const animation::Moment& moment : sampled(facts, most))
        supports.push_back(supportOf(*document::space(document::frameAt(entry, moment).fractal)));
    return [supports = std::move(supports)](const ifs::Vector<3>& u) {
        double farthest = -std::numeric_limits<double>::infinity();
        for (const attractor::Support& support : supports)
            farthest = std::max(farthest, support(u));
        return farthest;
    };
}

bool hasCameraKeys(const document::Fractal& entry) {
    if (const auto* shape = document::plane(entry)) return !shape->animation->camera.empty();
    return !document::space(entry)->animation->camera.empty();
}

} // namespace

QString frameObstacle(const document::Fractal& entry, const animation::Moment& moment) {
    const auto facts = document::animationFacts(entry);
    if (!facts) return {};
    const int last = animation::lastFrame(facts->loop, facts->length);
    if (!animation::isAfter(moment, last)) return {};
    return tr("“%1” has the frames 0 to %2; --frame is after the last one.").arg(entry.name).arg(last);
}

Frames::Frames(const document::Fractal& entry, const RenderArguments& arguments)
    : m_arguments(arguments), m_entry(entry) {
    if (document::plane(entry)) applyAppearance(m_entry.appearance, arguments);
    const auto facts = document::animationFacts(entry);
    if (!facts || arguments.view || hasCameraKeys(entry)) return;
    if (document::plane(entry))
        m_common.box = boxOfFrames(entry, *facts);
    else
        m_common.support = supportOfFrames(entry, *facts);
}

Shown Frames::at(const animation::Moment& moment) const {
    if (const QString obstacle = frameObstacle(m_entry, moment); !obstacle.isEmpty())
        throw UsageError{obstacle};
    const document::AnimatedFrame frame = document::frameAt(m_entry, moment);
    Shown shown = m_common;
    shown.entry = m_entry;
    shown.fractal = frame.fractal;
    shown.view = frame.view;
    shown.camera = frame.camera;
    shown.orbit = frame.orbit;
    if (document::plane(m_entry)) applyAppearance(shown.fractal.appearance, m_arguments); // over keys as well
    return shown;
}

Shown shownBy(const document::Fractal& entry, const RenderArguments& arguments) {
    if (arguments.frame) return Frames(entry, arguments).at(momentArgument("--frame", *arguments.frame));
    Shown shown{entry, entry};
    if (document::plane(entry)) applyAppearance(shown.fractal.appearance, arguments);
    return shown;
}

} // namespace cli
