// SPDX-License-Identifier: MIT
#include "panels/timeline/motion_preview.h"

#include "animation/paths/camera_path.h"
#include "attractor/colour/palette.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "ifs/cage/control_cage.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace view {

namespace {

constexpr int points = 700;
constexpr int dropped = 20; // jumps until a point is close to the attractor
constexpr std::size_t maxMaps = 64;
constexpr double margin = 2;            // pixels
constexpr double paletteInMiddle = 0.7; // palette coordinate of points of usual density

// A point as seen from in front and a little from above, through a camera that has gone round.
QPointF seen(const attractor::OrbitCamera& camera, const ifs::Vector<3>& point) {
    const ifs::Vector<3> at = camera.orientation.conjugate() * (point - camera.target);
    return {at.x(), at.y()};
}

// The chaos game with the same random numbers in every frame.
template <int Dim, class Seen>
std::vector<QPointF> chaosGame(const ifs::IteratedFunctionSystem<Dim>& system, Seen shown) {
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    std::vector<QPointF> result;
    if (active.maps.empty()) return result;
    std::mt19937 random(1);
    std::discrete_distribution<std::size_t> choice(active.probabilities.begin(), active.probabilities.end());
    ifs::Vector<Dim> point = ifs::Vector<Dim>::Zero();
    for (int i = 0; i < dropped + points; ++i) {
        point = active.maps[choice(random)](point);
        if (!point.allFinite()) return {};
        if (i >= dropped) result.push_back(shown(point));
    }
    return result;
}

// The box of all frames; of an endless zoom, each frame has its own view.
template <class Frame> QRectF boxOf(const std::vector<Frame>& frames) {
    double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;
    for (const Frame& frame : frames)
        for (const QPointF& point : frame.points) {
            left = std::min(left, point.x());
            right = std::max(right, point.x());
            bottom = std::min(bottom, point.y());
            top = std::max(top, point.y());
        }
    return {left, bottom, right - left, top - bottom};
}

template <class Frame> QPixmap picture(const Frame& frame, const QRectF& box, const PreviewStyle& style) {
    QPixmap pixmap(style.size * style.pixelRatio);
    pixmap.setDevicePixelRatio(style.pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const QSizeF inside(style.size.width() - 2 * margin, style.size.height() - 2 * margin);
    const QPointF centre =
        frame.view ? QPointF(frame.view->centre.x(), frame.view->centre.y()) : box.center();
    const double scale = frame.view ? inside.height() / frame.view->height
                                    : std::min(inside.width() / std::max(box.width(), 1e-9),
                                               inside.height() / std::max(box.height(), 1e-9));
    QColor ink = frame.colour;
    ink.setAlphaF(0.7F);
    painter.setPen(QPen(ink, 0));
    const QPointF middle(style.size.width() / 2.0, style.size.height() / 2.0);
    std::vector<QPointF> dots;
    dots.reserve(frame.points.size());
    const ifs::Matrix<2> turn = attractor::screenTurn(frame.view ? frame.view->rotation : 0);
    for (const QPointF& point : frame.points) {
        const QPointF away = (point - centre) * scale;
        const ifs::Vector<2> dot = turn * ifs::Vector<2>(away.x(), -away.y());
        dots.push_back(middle + QPointF(dot.x(), dot.y()));
    }
    painter.drawPoints(dots.data(), int(dots.size()));
    return pixmap;
}

} // namespace

bool isPreviewed(const document::Fractal& entry) {
    const auto* plane = document::plane(entry);
    const auto* space = document::space(entry);
    const std::size_t maps = plane ? plane->system.maps.size() : space ? space->system.maps.size() : 0;
    return maps > 0 && maps <= maxMaps;
}

MotionPreview::MotionPreview(document::Fractal entry, const PreviewStyle& style)
    : m_entry(std::move(entry)), m_style(style) {
    const auto facts = document::animationFacts(m_entry);
    if (facts && isPreviewed(m_entry)) m_length = animation::frameCount(facts->loop, facts->length);
}

bool MotionPreview::findNext() {
    if (m_length == 0 || m_frames.size() == previewFrames) return false;
    const auto index = std::int64_t(m_frames.size());
    const document::AnimatedFrame frame =
        document::frameAt(m_entry, animation::moment(m_length * index, previewFrames));
    Frame& result = m_frames.emplace_back();
    result.view = frame.view;
    result.colour = m_style.ink;
    if (frame.fractal.appearance.palette != m_entry.appearance.palette) {
        const attractor::Rgba colour = attractor::colourAt(frame.fractal.appearance.palette, paletteInMiddle);
        result.colour = QColor(colour.red, colour.green, colour.blue);
    }
    if (const auto* shape = document::plane(frame.fractal)) {
        const ifs::Placement place = document::placement(frame.fractal);
        result.points = chaosGame<2>(shape->system, [&](const ifs::Vector<2>& point) {
            const ifs::Vector<2> shown = place(point);
            return QPointF(shown.x(), shown.y());
        });
    } else if (const auto* solid = document::space(frame.fractal)) {
        const bool isPlaced = solid->cage && !ifs::bends(*solid->cage);
        const ifs::AffineMap<3> place = isPlaced ? ifs::displayMap(*solid->cage) : ifs::AffineMap<3>();
        attractor::OrbitCamera camera;
        camera.orientation = attractor::orbit(30, 20);
        camera = animation::orbited(camera, frame.orbit);
        result.points = chaosGame<3>(solid->system,
                                     [&](const ifs::Vector<3>& point) { return seen(camera, place(point)); });
    }
    return m_frames.size() < previewFrames;
}

std::vector<QPixmap> MotionPreview::pictures() const {
    const QRectF box = boxOf(m_frames);
    std::vector<QPixmap> result;
    for (const Frame& frame : m_frames)
        result.push_back(picture(frame, box, m_style));
    return result;
}

} // namespace view
