// SPDX-License-Identifier: MIT
#include "attractor/samples/space_orbit.h"
#include "attractor/space_systems.h"
#include "attractor/voxels/voxel_cover.h"
#include "document/fractal/fractal_geometry.h"
#include "io/exchange/point_cloud.h"
#include "io/solid/openscad.h"
#include "io/solid/printable_solid.h"
#include "io/text/number.h"
#include "support/named_test.h"

#include <Eigen/Geometry>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using ifs::Vector;

namespace {

// A tetrahedron of which one corner is shown elsewhere, turned.
document::Fractal movedTetrahedron() {
    document::Fractal fractal;
    fractal.name = u"moved"_s;
    document::Shape<3> shape{systems::tetrahedron()};
    const auto& maps = shape.system.maps;
    const ifs::AffineMap<3> out{Eigen::AngleAxisd(0.7, Vector<3>::UnitX()).toRotationMatrix(),
                                Vector<3>(1.5, 0.5, -0.25)};
    shape.moved = {{{maps[2].id, maps[1].id}, out}};
    fractal.shape = shape;
    return fractal;
}

// change(w₃ w₂(x)) of points in that branch, in coordinates of the code.
bool isInBranch(const document::Fractal& fractal, const Vector<3>& at) {
    const ifs::AffineMap<3>& change = document::space(fractal)->moved.front().change;
    const auto maps = ifs::mapsOf(*document::system3(fractal));
    const Vector<3> x = (*ifs::inverse(change * maps[2] * maps[1]))(at);
    return x.minCoeff() > -1e-9 && x.maxCoeff() < 1 + 1e-9;
}

} // namespace

// Files that hold a solid hold its branches where they are shown.
class MovedExportTest : public QObject {
    Q_OBJECT

private slots:
    void pointsAreWhereTheirBranchIsShown() {
        QTemporaryDir folder;
        document::Fractal fractal = movedTetrahedron();
        const auto written = [&] {
            const QString path = folder.filePath(u"points"_s);
            QFile file(path);
            std::vector<Vector<3>> points;
            if (io::exportPoints({fractal, 3000, 5, io::PointFormat::Csv}, path).failure ||
                !file.open(QIODevice::ReadOnly))
                return points;
            for (const QByteArray& line : file.readAll().trimmed().split('\n').mid(1)) {
                const auto cells = QString::fromLatin1(line).split(u',');
                points.emplace_back(io::parseNumber(cells.value(0)).value_or(NAN),
                                    io::parseNumber(cells.value(1)).value_or(NAN),
                                    io::parseNumber(cells.value(2)).value_or(NAN));
            }
            return points;
        };
        std::size_t moved = 0, outside = 0;
        const std::vector<Vector<3>> points = written();
        QCOMPARE(points.size(), std::size_t(3000));
        for (const Vector<3>& point : points) {
            const bool isIn = point.minCoeff() > -1e-9 && point.maxCoeff() < 1 + 1e-9;
            outside += !isIn;
            moved += !isIn && isInBranch(fractal, point);
        }
        QCOMPARE(moved, outside);
        QVERIFY2(std::abs(double(moved) - 3000 / 16.0) < 60, qPrintable(QString::number(moved)));
    }

    void voxelsCoverThem() {
        const document::Fractal fractal = movedTetrahedron();
        const document::Shape<3>& shape = *document::space(fractal);
        const auto moved = document::movedBranches(shape);
        const attractor::PreparedSpace prepared = attractor::preparedSpace(shape.system, moved);
        const Vector<3> low(-1, -1, -1), high(3, 3, 3);
        const auto cover = attractor::voxelCover({prepared, {}, low, high, 0.03, 0});
        QVERIFY(cover.outcome == attractor::VoxelCover::Outcome::Done);
        const auto isFilled = [&](const Vector<3>& x) {
            const Vector<3> at = (x - cover.origin) / cover.side;
            return cover.grid.isFilled(
                {int(std::floor(at.x())), int(std::floor(at.y())), int(std::floor(at.z()))});
        };
        const auto pieces = ifs::pieces<3>(prepared.moved, prepared.maps.size());
        attractor::SpaceOrbit orbit(prepared, 1);
        ifs::Word address{0, 0};
        std::size_t away = 0, left = 0;
        for (int n = 0; n < 20'000; ++n) {
            const auto& point = orbit.next();
            address = {int(point.lastMap), address.front()};
            if (n < 30) continue;
            QVERIFY(isFilled(ifs::pieceOf<3>(pieces, address).change(point.x)));
            if (address != ifs::Word{2, 1}) continue;
            ++away;
            left += isFilled(point.x);
        }
        QVERIFY(away > 500 && left < away / 5); // where it has been, but for its neighbours
    }

    void theBodyHoldsThem() {
        document::Fractal fractal = movedTetrahedron();
        io::SolidOptions options;
        options.resolution = 60;
        const io::PrintableSolid solid = io::printableSolid(fractal, options, {}, {});
        QVERIFY2(!solid.failure, qPrintable(solid.failure.value_or(QString())));
        std::size_t beyond = 0;
        for (const auto& point : solid.mesh.points) {
            const Vector<3> at =
                solid.origin + solid.unit * Vector<3>(double(point[0]), double(point[1]), double(point[2]));
            beyond += at.x() > 1.1;
        }
        QVERIFY(beyond > 50);
        QCOMPARE(solid.facts.islands > 1, true);
    }

    // The parts of the program are those of the pieces.
    void openScadPlacesThem() {
        const QString text = QString::fromUtf8(io::openScad(movedTetrahedron()).text);
        const QStringList lines = text.trimmed().split(u'\n');
        QCOMPARE(text.count(u"part(max(0, depth - 2));"_s), 4); // 3 1, 3 2, 3 3 and 3 4
        QCOMPARE(text.count(u"part(max(0, depth - 1));"_s), 3); // 1, 2 and 4
        QVERIFY(lines.last().startsWith(u"multmatrix("_s));
        QVERIFY(!text.contains(u"part(depth);"_s));
    }
};

BARYCAGE_TEST(MovedExportTest, QCoreApplication);
#include "moved_export_test.moc"
