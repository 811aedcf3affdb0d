// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "io/exchange/point_cloud.h"
#include "io/text/number.h"
#include "support/named_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstring>

class PointCloudTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void everyPointIsTheImageOfThePointBefore();
    void plyHoldsTheSamePointsInColour();
    void pointsAreWhereTheyAreShown();
    void pointsBendWithTheCage();
    void sameSeedSameBytes();
    void refusals();
    void stopsWithoutAFile();

private:
    QByteArray written(const io::PointCloud& cloud);

    QTemporaryDir m_folder;
};

namespace {

struct Point {
    double x;
    double y;
    int map;
};

std::vector<Point> pointsIn(const QByteArray& csv) {
    std::vector<Point> points;
    for (const QByteArray& line : csv.trimmed().split('\n').mid(1)) {
        const auto cells = QString::fromLatin1(line).split(u',');
        points.push_back({io::parseNumber(cells.value(0)).value_or(NAN),
                          io::parseNumber(cells.value(1)).value_or(NAN), cells.value(2).toInt()});
    }
    return points;
}

} // namespace

QByteArray PointCloudTest::written(const io::PointCloud& cloud) {
    const QString path = m_folder.filePath(QStringLiteral("points"));
    const auto outcome = io::exportPoints(cloud, path);
    QFile file(path);
    return !outcome.failure && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void PointCloudTest::everyPointIsTheImageOfThePointBefore() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    const QByteArray csv = written({fractal, 1000, 3, io::PointFormat::Csv});
    QVERIFY(csv.startsWith("x,y,map\n"));
    const auto points = pointsIn(csv);
    QCOMPARE(points.size(), std::size_t(1000));
    const auto& maps = document::system2(fractal)->maps;
    for (std::size_t i = 1; i < points.size(); ++i) {
        QVERIFY(points[i].map >= 1 && points[i].map <= 3);
        const ifs::Vector<2> image =
            maps[std::size_t(points[i].map) - 1].map(ifs::Vector<2>(points[i - 1].x, points[i - 1].y));
        QVERIFY((image - ifs::Vector<2>(points[i].x, points[i].y)).norm() < 1e-12);
    }
}

void PointCloudTest::plyHoldsTheSamePointsInColour() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.appearance.colourBy = attractor::ColourBy::Map;
    const auto points = pointsIn(written({fractal, 50, 3, io::PointFormat::Csv}));
    const QByteArray ply = written({fractal, 50, 3, io::PointFormat::Ply});
    QVERIFY(ply.startsWith("ply\nformat binary_little_endian 1.0\n"));
    QVERIFY(ply.contains("element vertex 50\n"));
    const qsizetype begin = ply.indexOf("end_header\n") + 11;
    constexpr qsizetype stride = 3 * 8 + 3;
    QCOMPARE(ply.size() - begin, 50 * stride);
    for (qsizetype i = 0; i < 50; ++i) {
        double xyz[3];
        std::memcpy(xyz, ply.constData() + begin + i * stride, sizeof xyz);
        const Point& point = points[std::size_t(i)];
        QCOMPARE(xyz[0], point.x);
        QCOMPARE(xyz[1], point.y);
        QCOMPARE(xyz[2], 0.0);
        const auto colour = attractor::categoricalColour(std::size_t(point.map) - 1);
        QCOMPARE(std::uint8_t(ply[begin + i * stride + 24]), colour.red);
        QCOMPARE(std::uint8_t(ply[begin + i * stride + 26]), colour.blue);
    }
}

void PointCloudTest::pointsAreWhereTheyAreShown() {
    document::Fractal fractal = document::sierpinskiTriangle();
    const auto code = pointsIn(written({fractal, 20, 5, io::PointFormat::Csv}));
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    for (auto& vertex : document::plane(fractal)->cage->current)
        vertex += ifs::Vector<2>(10, -3);
    const auto moved = pointsIn(written({fractal, 20, 5, io::PointFormat::Csv}));
    QCOMPARE(moved.size(), code.size());
    for (std::size_t i = 0; i < code.size(); ++i) {
        QVERIFY(std::abs(moved[i].x - code[i].x - 10) < 1e-12);
        QVERIFY(std::abs(moved[i].y - code[i].y + 3) < 1e-12);
    }
}

// A square whose upper right corner is pulled out: what lies on its lower edge and its left edge stays.
void PointCloudTest::pointsBendWithTheCage() {
    document::Fractal fractal = document::sierpinskiTriangle();
    const auto code = pointsIn(written({fractal, 400, 5, io::PointFormat::Csv}));
    ifs::ControlCage<2> cage;
    cage.rest = cage.current = {{-0.1, -0.1}, {1.1, -0.1}, {1.1, 1.1}, {-0.1, 1.1}};
    document::plane(fractal)->cage = cage;
    const auto still = pointsIn(written({fractal, 400, 5, io::PointFormat::Csv}));
    document::plane(fractal)->cage->current[2] = {3, 2};
    const auto bent = pointsIn(written({fractal, 400, 5, io::PointFormat::Csv}));
    const ifs::Placement placement = document::placement(fractal);
    QVERIFY(placement.bend() != nullptr);
    QCOMPARE(bent.size(), code.size());
    double farthest = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const ifs::Vector<2> x(code[i].x, code[i].y);
        QVERIFY((ifs::Vector<2>(still[i].x, still[i].y) - x).norm() < 1e-9);
        QVERIFY((ifs::Vector<2>(bent[i].x, bent[i].y) - placement(x)).norm() < 1e-12);
        farthest = std::max(farthest, (placement(x) - x).norm());
    }
    QVERIFY2(farthest > 0.1, qPrintable(QString::number(farthest)));
}

void PointCloudTest::sameSeedSameBytes() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    const QByteArray bytes = written({fractal, 100, 1, io::PointFormat::Ply});
    QVERIFY(!bytes.isEmpty());
    QVERIFY(written({fractal, 100, 1, io::PointFormat::Ply}) == bytes);
    QVERIFY(written({fractal, 100, 2, io::PointFormat::Ply}) != bytes);
}

void PointCloudTest::refusals() {
    const QString path = m_folder.filePath(QStringLiteral("never"));
    document::Fractal fractal = document::sierpinskiTriangle();
    QVERIFY(io::exportPoints({fractal, 0, 1, io::PointFormat::Csv}, path).failure);
    QVERIFY(
        io::exportPoints({fractal, io::PointCloud::maxPoints + 1, 1, io::PointFormat::Csv}, path).failure);
    for (auto& map : document::system2(fractal)->maps)
        map.enabled = false;
    QVERIFY(io::exportPoints({fractal, 10, 1, io::PointFormat::Csv}, path).failure);
    fractal.shape = document::Shape<3>();
    QVERIFY(io::exportPoints({fractal, 10, 1, io::PointFormat::Csv}, path).failure);
    QVERIFY(!QFile::exists(path));
}

void PointCloudTest::stopsWithoutAFile() {
    std::stop_source source;
    const QString path = m_folder.filePath(QStringLiteral("stopped"));
    const auto outcome = io::exportPoints(
        {document::sierpinskiTriangle(), 10'000'000, 1, io::PointFormat::Ply}, path,
        [&source](double) { source.request_stop(); }, source.get_token());
    QVERIFY(outcome.stopped);
    QVERIFY(!QFile::exists(path));
}

BARYCAGE_TEST(PointCloudTest);
#include "point_cloud_test.moc"
