// SPDX-License-Identifier: MIT
#include "io/exchange/point_cloud.h"

#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_space.h"
#include "attractor/samples/prepared_system.h"
#include "document/fractal/fractal_geometry.h"
#include "document/text/text.h"
#include "io/exchange/point_colour.h"
#include "io/exchange/space_points.h"
#include "io/text/number.h"

#include <QtEndian>

#include <array>

namespace io {

namespace {

class Writer {
public:
    explicit Writer(const PointCloud& cloud)
        : m_cloud(cloud),
          m_system(
              attractor::prepared(*document::system2(cloud.fractal), document::movedBranches(cloud.fractal))),
          m_display(document::placement(cloud.fractal)),
          m_bytes(header()) {}

    const attractor::PreparedSystem& system() const { return m_system; }
    const QByteArray& bytes() const { return m_bytes; }

    void add(const attractor::Orbit::Point& point) {
        const ifs::Vector<2> x = m_display(point.x);
        const std::size_t index = m_system.index[point.lastMap];
        if (m_cloud.format == PointFormat::Csv) {
            m_bytes += formatNumber(x.x()) + ',' + formatNumber(x.y()) + ',' +
                       QByteArray::number(qulonglong(index) + 1) + '\n';
            return;
        }
        addNumber(x.x());
        addNumber(x.y());
        addNumber(0);
        const attractor::Rgba colour =
            pointColour(m_cloud.fractal.appearance, document::system2(m_cloud.fractal)->maps[index].id, index,
                        point.colourCoordinate);
        for (const std::uint8_t channel : {colour.red, colour.green, colour.blue})
            m_bytes += char(channel);
    }

private:
    QByteArray header() const {
        if (m_cloud.format == PointFormat::Csv) return "x,y,map\n";
        return "ply\nformat binary_little_endian 1.0\ncomment Barycage\nelement vertex " +
               QByteArray::number(qulonglong(m_cloud.points)) +
               "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty "
               "uchar "
               "green\nproperty uchar blue\nend_header\n";
    }

    void addNumber(double value) {
        std::array<char, sizeof value> bytes{};
        qToLittleEndian(value, bytes.data());
        m_bytes.append(bytes.data(), sizeof value);
    }

    const PointCloud& m_cloud;
    attractor::PreparedSystem m_system;
    ifs::Placement m_display; // bends if the cage does
    QByteArray m_bytes;
};

} // namespace

Failure obstacle(const PointCloud& cloud) {
    const document::Shape<3>* space = document::space(cloud.fractal);
    const document::System2* system = document::system2(cloud.fractal);
    if (!space && !system)
        return Text::tr("“%1” could not be read, so it has no points.").arg(cloud.fractal.name);
    if (space ? attractor::preparedSpace(space->system).maps.empty() : ifs::activeMaps(*system).maps.empty())
        return Text::tr("“%1” has no active map, so it has no points.").arg(cloud.fractal.name);
    if (space && space->cage && ifs::bends(*space->cage))
        return Text::tr("A cage with more than four corners bends the solid; its points cannot be written.");
    if (cloud.points < 1 || cloud.points > PointCloud::maxPoints)
        return Text::tr("A point cloud can have from 1 to %1 points.").arg(PointCloud::maxPoints);
    return std::nullopt;
}

namespace {

// `points` times add(), unless stopped.
template <class Add>
void addAll(const PointCloud& cloud, const Add& add, const Progress& progress, const std::stop_token& stop,
            ExportOutcome& outcome) {
    constexpr std::uint64_t between = 1 << 16; // points between two checks of the time
    for (std::uint64_t i = 0; i < cloud.points && !outcome.stopped; ++i) {
        add();
        if (i % between != 0) continue;
        outcome.stopped = stop.stop_requested();
        if (progress) progress(double(i) / double(cloud.points));
    }
}

} // namespace

ExportOutcome exportPoints(const PointCloud& cloud, const QString& path, const Progress& progress,
                           std::stop_token stop) {
    ExportOutcome outcome;
    outcome.failure = obstacle(cloud);
    if (outcome.failure) return outcome;
    const auto save = [&](const QByteArray& bytes) {
        if (!outcome.stopped) outcome.failure = saveFile(path, bytes);
        if (progress) progress(1);
    };
    if (document::space(cloud.fractal)) {
        SpacePoints points(cloud, stop);
        outcome.note = points.note();
        addAll(
            cloud, [&points] { points.add(); }, progress, stop, outcome);
        save(points.bytes());
        return outcome;
    }
    Writer writer(cloud);
    outcome.note = writer.system().note;
    const document::System2& system = *document::system2(cloud.fractal);
    attractor::Orbit orbit(
        writer.system(), cloud.seed, attractor::Orbit::skipped,
        attractor::colourCoordinates<2>(cloud.fractal.appearance, system, writer.system()));
    addAll(
        cloud, [&] { writer.add(orbit.next()); }, progress, stop, outcome);
    save(writer.bytes());
    return outcome;
}

} // namespace io
