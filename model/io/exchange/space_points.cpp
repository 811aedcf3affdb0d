// SPDX-License-Identifier: MIT
#include "io/exchange/space_points.h"

#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/space_orbit.h"
#include "attractor/voxels/voxel_cover.h"
#include "document/space_geometry.h"
#include "ifs/cage/cage_surface.h"
#include "io/exchange/point_colour.h"
#include "io/text/number.h"

#include <QtEndian>

#include <array>
#include <cmath>
#include <optional>

namespace io {

namespace {

// What lies where around an attractor, as far as its normals ask.
class Surroundings {
public:
    Surroundings() = default;
    Surroundings(const attractor::PreparedSpace& system, const ifs::AffineMap<3>& placement,
                 const std::stop_token& stop) {
        constexpr double resolution = 192;
        const ifs::Vector<3> middle = placement(system.centre);
        const ifs::Vector<3> half = placement.linear.cwiseAbs() * system.halfExtent;
        const double side = 2 * half.maxCoeff() / resolution;
        if (!system.isCertified || !(side > 0)) return;
        m_cover =
            attractor::voxelCover({system, placement, middle - half, middle + half, side, reach}, {}, stop);
        m_isKnown = m_cover.outcome == attractor::VoxelCover::Outcome::Done;
    }

    ifs::Vector<3> normal(const ifs::Vector<3>& x) const {
        ifs::Vector<3> away = ifs::Vector<3>::Zero();
        if (!m_isKnown) return away;
        const ifs::Vector<3> at = (x - m_cover.origin) / m_cover.side;
        attractor::VoxelGrid::Index middle{};
        for (std::size_t k = 0; k < 3; ++k)
            middle[k] = int(std::floor(at[Eigen::Index(k)]));
        double weight = 0;
        for (int dz = -reach; dz <= reach; ++dz)
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    if (dx * dx + dy * dy + dz * dz > reach * reach ||
                        !m_cover.grid.isFilled({middle[0] + dx, middle[1] + dy, middle[2] + dz}))
                        continue;
                    away -= ifs::Vector<3>(dx, dy, dz);
                    ++weight;
                }
        const double length = away.norm();
        return length > 1e-3 * weight ? ifs::Vector<3>(away / length) : ifs::Vector<3>::Zero();
    }

private:
    static constexpr int reach = 3; // voxels

    attractor::VoxelCover m_cover;
    bool m_isKnown = false;
};

template <class Number> void append(QByteArray& bytes, Number value) {
    std::array<char, sizeof value> raw{};
    qToLittleEndian(value, raw.data());
    bytes.append(raw.data(), qsizetype(raw.size()));
}

QByteArray headerOf(const PointCloud& cloud) {
    if (cloud.format == PointFormat::Csv) return "x,y,z,map\n";
    return "ply\nformat binary_little_endian 1.0\ncomment Barycage\nelement vertex " +
           QByteArray::number(qulonglong(cloud.points)) +
           "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float "
           "ny\nproperty float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty "
           "int map\nproperty double address\nend_header\n";
}

} // namespace

struct SpacePoints::State {
    State(const PointCloud& wanted, const std::stop_token& stop)
        : cloud(wanted),
          shape(*document::space(wanted.fractal)),
          system(attractor::preparedSpace(shape.system)),
          orbit(system, wanted.seed,
                attractor::colourCoordinates<3>(wanted.fractal.appearance, shape.system, system)),
          bytes(headerOf(wanted)) {
        if (shape.cage) placement = ifs::displayMap(*shape.cage);
        if (shape.cage && ifs::bends(*shape.cage)) bend.emplace(shape.cage->rest, shape.cage->current);
        if (wanted.format == PointFormat::Ply) surroundings = Surroundings(system, placement, stop);
    }

    const PointCloud& cloud;
    const document::Shape<3>& shape;
    attractor::PreparedSpace system;
    attractor::SpaceOrbit orbit;
    ifs::AffineMap<3> placement;
    std::optional<ifs::CageDeformation> bend; // in place of it; normals are those of the placement
    Surroundings surroundings;
    QByteArray bytes;
};

SpacePoints::SpacePoints(const PointCloud& cloud, const std::stop_token& stop)
    : m_state(std::make_unique<State>(cloud, stop)) {}

SpacePoints::~SpacePoints() = default;

void SpacePoints::add() {
    State& state = *m_state;
    const attractor::SpaceOrbit::Point& point = state.orbit.next();
    const std::size_t map = state.system.index[point.lastMap];
    const ifs::Vector<3> x = state.bend ? (*state.bend)(point.x) : state.placement(point.x);
    if (state.cloud.format == PointFormat::Csv) {
        for (int k = 0; k < 3; ++k)
            state.bytes += formatNumber(x[k]) + ',';
        state.bytes += QByteArray::number(qulonglong(map) + 1) + '\n';
        return;
    }
    const ifs::Vector<3> normal = state.surroundings.normal(x);
    for (int k = 0; k < 3; ++k)
        append(state.bytes, x[k]);
    for (int k = 0; k < 3; ++k)
        append(state.bytes, float(normal[k]));
    const attractor::Rgba colour = pointColour(state.cloud.fractal.appearance,
                                               state.shape.system.maps[map].id, map, point.colourCoordinate);
    for (const std::uint8_t channel : {colour.red, colour.green, colour.blue})
        state.bytes += char(channel);
    append(state.bytes, qint32(map) + 1);
    append(state.bytes, point.addressCoordinate);
}

const QByteArray& SpacePoints::bytes() const {
    return m_state->bytes;
}

attractor::RenderNote SpacePoints::note() const {
    return m_state->system.note;
}

} // namespace io
