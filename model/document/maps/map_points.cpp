// SPDX-License-Identifier: MIT
#include "document/maps/map_points.h"

#include "attractor/request/orbit_camera.h"
#include "attractor/samples/chaos_game.h"
#include "document/fractal/fractal_geometry.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>

namespace document {

namespace {

constexpr int pointCount = 8000;
constexpr int pointsSkipped = 30;
constexpr double edge = 1.5;   // free pixels around the whole
constexpr double away = 1e12;  // distance at which an orbit is restarted
constexpr double azimuth = 30; // degrees; same direction as in thumbnails of solids
constexpr double elevation = 20;

std::vector<ifs::Vector<2>> pointsOf(const System2& system) {
    std::vector<ifs::Vector<2>> points;
    const attractor::PreparedSystem prepared = attractor::prepared(system);
    if (prepared.maps.empty()) return points;
    attractor::Orbit orbit(prepared, 1);
    points.reserve(pointCount);
    for (int k = 0; k < pointCount; ++k)
        points.push_back(orbit.next().x);
    return points;
}

std::vector<ifs::Vector<3>> pointsOf(const System3& system) {
    std::vector<ifs::Vector<3>> points;
    const ifs::ActiveMaps<3> active = ifs::activeMaps(system);
    if (active.maps.empty()) return points;
    std::minstd_rand random(1);
    std::discrete_distribution<std::size_t> next(active.probabilities.begin(), active.probabilities.end());
    points.reserve(pointCount);
    ifs::Vector<3> x = ifs::Vector<3>::Zero();
    for (int k = -pointsSkipped; k < pointCount; ++k) {
        x = active.maps[next(random)](x);
        if (!(x.cwiseAbs().maxCoeff() < away)) x.setZero();
        if (k >= 0) points.push_back(x);
    }
    return points;
}

QRgb blended(const attractor::Rgba& below, float belowShare, const attractor::Rgba& above, float share) {
    const float alpha = share + belowShare * (1 - share);
    if (!(alpha > 0)) return 0;
    const auto channel = [&](int b, int a) { // premultiplied channel
        return int(std::lround(float(a) * share + float(b) * belowShare * (1 - share)));
    };
    return qRgba(channel(below.red, above.red), channel(below.green, above.green),
                 channel(below.blue, above.blue), int(std::lround(255 * alpha)));
}

// Coverage of pixels by their counts, scaled so that a typical pixel is nearly covered.
class Cover {
public:
    explicit Cover(const std::vector<float>& counts) {
        float sum = 0;
        float covered = 0;
        for (const float count : counts) {
            sum += count;
            covered += count > 0 ? 1.F : 0.F;
        }
        if (sum > 0) m_rate = 2 * covered / sum;
    }
    float operator()(float count) const { return 1 - std::exp(-m_rate * count); }

private:
    float m_rate = 0;
};

} // namespace

MapPoints::MapPoints(const Fractal& fractal, int width, int height) : m_width(width), m_height(height) {
    const auto colour = [&](const auto& maps) {
        m_colours.reserve(maps.size());
        for (std::size_t i = 0; i < maps.size(); ++i)
            m_colours.push_back(attractor::mapColour(fractal.appearance, maps[i].id, i));
    };
    if (const System2* system = system2(fractal)) {
        colour(system->maps);
        take<2>(*system, pointsOf(*system), placement(fractal));
    } else if (const Shape<3>* solid = space(fractal)) {
        colour(solid->system.maps);
        attractor::OrbitCamera camera;
        camera.orientation = attractor::orbit(azimuth, elevation);
        const ifs::AffineMap<3> toCamera = attractor::worldToCamera(camera);
        const ifs::AffineMap<3> seen = solid->cage ? toCamera * ifs::displayMap(*solid->cage) : toCamera;
        take<3>(solid->system, pointsOf(solid->system),
                [seen](const ifs::Vector<3>& x) { return ifs::Vector<2>(seen(x).head<2>()); });
    }
}

template <int Dim, class Display>
void MapPoints::take(const ifs::IteratedFunctionSystem<Dim>& system, std::vector<ifs::Vector<Dim>> points,
                     Display display) {
    std::erase_if(points, [](const ifs::Vector<Dim>& x) { return !x.allFinite(); });
    std::vector<ifs::Vector<2>> shown;
    shown.reserve(points.size());
    for (const ifs::Vector<Dim>& x : points)
        shown.push_back(display(x));
    frame(shown);
    m_whole.assign(std::size_t(m_width) * std::size_t(m_height), 0);
    for (const ifs::Vector<2>& at : shown)
        count(m_whole, at);
    m_countImage = [this, maps = ifs::mapsOf(system), points = std::move(points),
                    display = std::move(display)](std::size_t index, Counts& counts) {
        for (const ifs::Vector<Dim>& x : points)
            count(counts, display(maps[index](x)));
    };
}

void MapPoints::frame(const std::vector<ifs::Vector<2>>& shown) {
    ifs::Vector<2> low = ifs::Vector<2>::Constant(HUGE_VAL), high = -low;
    for (const ifs::Vector<2>& at : shown)
        if (at.allFinite()) {
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
        }
    const ifs::Vector<2> size = high - low;
    if (!size.allFinite()) return;
    m_middle = low + size / 2;
    const ifs::Vector<2> room(m_width - 2 * edge, m_height - 2 * edge);
    m_scale = std::min(size.x() > 0 ? room.x() / size.x() : HUGE_VAL,
                       size.y() > 0 ? room.y() / size.y() : HUGE_VAL);
    if (!std::isfinite(m_scale)) m_scale = 1; // single point
}

void MapPoints::count(Counts& counts, const ifs::Vector<2>& shown) const {
    const double x = m_width / 2.0 + m_scale * (shown.x() - m_middle.x());
    const double y = m_height / 2.0 - m_scale * (shown.y() - m_middle.y());
    if (x >= 0 && x < m_width && y >= 0 && y < m_height)
        ++counts[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
}

QImage MapPoints::picture(std::size_t index, const attractor::Rgba& faint) const {
    if (!(m_scale > 0) || index >= m_colours.size()) return {};
    Counts image(m_whole.size(), 0);
    m_countImage(index, image);
    const Cover ofWhole(m_whole), ofImage(image);
    QImage picture(m_width, m_height, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < m_height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < m_width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(m_width) + std::size_t(x);
            line[x] = blended(faint, ofWhole(m_whole[at]) * float(faint.alpha) / 255, m_colours[index],
                              ofImage(image[at]));
        }
    }
    return picture;
}

} // namespace document
