// SPDX-License-Identifier: MIT
#include "io/exchange/space_points.h"

#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/space_orbit.h"
#include "attractor/voxels/voxel_cover.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/cage/cage_surface.h"
#include "io/exchange/point_colour.h"
#include "io/text/number.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace io {

namespace {

// Surroundings of an attractor in voxels, as needed for its normals.
class Surroundings {
public:
    Surroundings() = default;
    Surroundings(const attractor::PreparedSpace& system, const ifs::AffineMap<3>& placement,
                 const std::stop_token& stop) {
        constexpr double resolution = 192;
        ifs::Vector<3> low = ifs::Vector<3>::Constant(HUGE_VAL), high = -low;
        for (const attractor::PreparedSpace::Piece& piece : system.pieces()) {
            const ifs::AffineMap<3> box = placement * system.fromBox() * piece.map;
            const ifs::Vector<3> half = box.linear.cwiseAbs().rowwise().sum();
            low = low.cwiseMin(box.translation - half);
            high = high.cwiseMax(box.translation + half);
        }
        const double side = (high - low).maxCoeff() / resolution;
        if (!system.isCertified || !(side > 0)) return;
        m_cover = attractor::voxelCover({system, placement, low, high, side, reach}, {}, stop);
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
          system(attractor::preparedSpace(shape.system, document::movedBranches(shape))),
          orbit(system, wanted.seed,
                attractor::colourCoordinates<3>(wanted.fractal.appearance, shape.system, system)),
          bytes(headerOf(wanted)) {
        if (shape.cage) placement = ifs::displayMap(*shape.cage);
        if (shape.cage && ifs::bends(*shape.cage)) bend.emplace(shape.cage->rest, shape.cage->current);
        if (wanted.format == PointFormat::Ply) surroundings = Surroundings(system, placement, stop);
        for (const ifs::MovedBranch<3>& piece : pieces)
            if (piece.word.size() > address.size()) address.resize(piece.word.size());
        for (std::size_t known = 0; known < address.size(); ++known)
            next();
    }

    const attractor::SpaceOrbit::Point& next() {
        const attractor::SpaceOrbit::Point& point = orbit.next();
        if (address.empty()) return point;
        std::shift_right(address.begin(), address.end(), 1);
        address.front() = int(point.lastMap);
        return point;
    }

    // Displayed place of a point of the orbit, in its possibly moved branch.
    ifs::Vector<3> shown(const ifs::Vector<3>& x) const {
        return address.empty() ? x : ifs::pieceOf<3>(pieces, address).change(x);
    }

    const PointCloud& cloud;
    const document::Shape<3>& shape;
    attractor::PreparedSpace system;
    attractor::SpaceOrbit orbit;
    std::vector<ifs::MovedBranch<3>> pieces = ifs::pieces<3>(system.moved, system.maps.size());
    ifs::Word address; // address of the newest point, long enough to determine its piece
    ifs::AffineMap<3> placement;
    std::optional<ifs::CageDeformation> bend; // replaces the placement, which still gives the normals
    Surroundings surroundings;
    QByteArray bytes;
};

SpacePoints::SpacePoints(const PointCloud& cloud, const std::stop_token& stop)
    : m_state(std::make_unique<State>(cloud, stop)) {}

SpacePoints::~SpacePoints() = default;

void SpacePoints::add() {
    State& state = *m_state;
    const attractor::SpaceOrbit::Point& point = state.next();
    const std::size_t map = state.system.index[point.lastMap];
    const ifs::Vector<3> inCode = state.shown(point.x);
    const ifs::Vector<3> x = state.bend ? (*state.bend)(inCode) : state.placement(inCode);
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
