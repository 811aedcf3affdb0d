// SPDX-License-Identifier: MIT
#include "io/point_cloud.h"

#include "attractor/chaos_game.h"
#include "attractor/drawable_system.h"
#include "io/number.h"

#include <QCoreApplication>
#include <QtEndian>

#include <array>

namespace io {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Text)
};

class Writer {
public:
    explicit Writer(const PointCloud& cloud)
        : m_cloud(cloud),
          m_system(attractor::drawable(*document::system2(cloud.fractal),
                                       document::movedBranches(cloud.fractal))) {
        if (cloud.fractal.cage) m_display = ifs::displayMap(*cloud.fractal.cage);
        m_bytes = header();
    }

    const attractor::DrawableSystem& system() const { return m_system; }
    const QByteArray& bytes() const { return m_bytes; }

    void add(const attractor::Orbit::Point& point) {
        const ifs::Vector<2> x = m_display(point.x);
        const std::size_t place = m_system.index[point.lastMap];
        if (m_cloud.format == PointFormat::Csv) {
            m_bytes += formatNumber(x.x()) + ',' + formatNumber(x.y()) + ',' +
                       QByteArray::number(qulonglong(place) + 1) + '\n';
            return;
        }
        addNumber(x.x());
        addNumber(x.y());
        addNumber(0);
        const attractor::Rgba colour = colourOf(point, place);
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

    attractor::Rgba colourOf(const attractor::Orbit::Point& point, std::size_t place) const {
        const attractor::Appearance& appearance = m_cloud.fractal.appearance;
        switch (appearance.colourBy) {
        case attractor::ColourBy::Map:
            return attractor::mapColour(appearance, document::system2(m_cloud.fractal)->maps[place].id,
                                        place);
        case attractor::ColourBy::Address:
            return attractor::colourAt(appearance.palette, point.addressCoordinate);
        case attractor::ColourBy::Plain:
            return appearance.plain;
        case attractor::ColourBy::Density: // the bright part, as in the pictures made of shapes
            break;
        }
        return attractor::colourAt(appearance.palette, 0.75);
    }

    const PointCloud& m_cloud;
    attractor::DrawableSystem m_system;
    ifs::AffineMap<2> m_display;
    QByteArray m_bytes;
};

} // namespace

Failure obstacle(const PointCloud& cloud) {
    const document::System2* system = document::system2(cloud.fractal);
    if (!system)
        return Text::tr("“%1” is not a system in the plane, of which alone points are written.")
            .arg(cloud.fractal.name);
    if (ifs::activeMaps(*system).maps.empty())
        return Text::tr("“%1” has no map that takes part, so it has no points.").arg(cloud.fractal.name);
    if (cloud.fractal.cage && cloud.fractal.cage->rest.size() != 3)
        return Text::tr(
            "A cage of more than three corners bends the picture, and its points are not written.");
    if (cloud.points < 1 || cloud.points > PointCloud::mostPoints)
        return Text::tr("A point cloud has from 1 to %1 points.").arg(PointCloud::mostPoints);
    return std::nullopt;
}

ExportOutcome exportPoints(const PointCloud& cloud, const QString& path, const Progress& progress,
                           std::stop_token stop) {
    constexpr std::uint64_t between = 1 << 16; // points between two looks at the clock
    ExportOutcome outcome;
    outcome.failure = obstacle(cloud);
    if (outcome.failure) return outcome;
    Writer writer(cloud);
    outcome.note = writer.system().note;
    attractor::Orbit orbit(writer.system(), cloud.seed);
    for (std::uint64_t i = 0; i < cloud.points && !outcome.stopped; ++i) {
        writer.add(orbit.next());
        if (i % between != 0) continue;
        outcome.stopped = stop.stop_requested();
        if (progress) progress(double(i) / double(cloud.points));
    }
    if (!outcome.stopped) outcome.failure = saveFile(path, writer.bytes());
    if (progress) progress(1);
    return outcome;
}

} // namespace io
