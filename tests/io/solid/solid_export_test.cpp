// SPDX-License-Identifier: MIT
#include "attractor/samples/space_orbit.h"
#include "attractor/space_systems.h"
#include "io/solid/openscad.h"
#include "io/solid/solid_export.h"
#include "support/fractals.h"
#include "support/named_test.h"
#include "support/processor_timer.h"
#include "support/thorough.h"

#include <QBuffer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <cmath>
#include <map>
#include <numbers>

using namespace Qt::StringLiterals;

// Bodies to print, and the files that hold them.
class SolidExportTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void theBoundHolds_data();
    void theBoundHolds();
    void lengthsAreMillimetres();
    void theLongestSideIsThatOfTheFile_data();
    void theLongestSideIsThatOfTheFile();
    void wallsAreThick();
    void cavitiesAreFilledOnRequest();
    void islandsAreReported();
    void everyFormatHoldsTheSameSurface();
    void glbIsWellFormed();
    void admeshFindsNothing_data();
    void admeshFindsNothing();
    void openScadGrowsWithTheMaps();
    void openScadPartsLieOnTheAttractor();
    void whatHasNoSolid_data();
    void whatHasNoSolid();
    void lowerThanTheLowestIsNotAdvised();
    void theHighestResolutionIsNamed();
    void hardSystemsEnd_data();
    void hardSystemsEnd();
    void stopsWithoutAFile();

private:
    QByteArray written(const document::Fractal& fractal, const io::SolidOptions& options,
                       io::MeshFormat format, QString* report = nullptr);

    QTemporaryDir m_folder;
};

namespace {

using Vector3 = ifs::Vector<3>;

document::Fractal solidOf(const systems::System3& system) {
    return support::fractalOf(system, QStringLiteral("solid"));
}

io::SolidOptions resolution(int n) {
    io::SolidOptions options;
    options.resolution = n;
    return options;
}

template <class Number> Number numberAt(const QByteArray& bytes, qsizetype at) {
    return qFromLittleEndian<Number>(bytes.constData() + at);
}

struct Surface {
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<quint32, 3>> triangles;

    double volume() const {
        double sixfold = 0;
        for (const auto& t : triangles) {
            const auto at = [&](int k) {
                const auto& p = points[t[std::size_t(k)]];
                return Vector3(double(p[0]), double(p[1]), double(p[2]));
            };
            ifs::Matrix<3> corners;
            corners << at(0), at(1), at(2);
            sixfold += corners.determinant();
        }
        return sixfold / 6;
    }
};

Surface stl(const QByteArray& bytes) {
    Surface surface;
    std::map<std::array<float, 3>, quint32> known;
    const auto count = numberAt<quint32>(bytes, 80);
    for (quint32 i = 0; i < count; ++i) {
        std::array<quint32, 3> triangle{};
        for (int k = 0; k < 3; ++k) {
            std::array<float, 3> p{};
            for (int c = 0; c < 3; ++c)
                p[std::size_t(c)] = numberAt<float>(bytes, 84 + 50 * qsizetype(i) + 12 + 12 * k + 4 * c);
            const auto [place, isNew] = known.emplace(p, quint32(surface.points.size()));
            if (isNew) surface.points.push_back(p);
            triangle[std::size_t(k)] = place->second;
        }
        surface.triangles.push_back(triangle);
    }
    return surface;
}

Surface obj(const QByteArray& bytes) {
    Surface surface;
    for (const QByteArray& line : bytes.split('\n')) {
        const QByteArrayList cells = line.split(' ');
        if (cells[0] == "v")
            surface.points.push_back({cells[1].toFloat(), cells[2].toFloat(), cells[3].toFloat()});
        if (cells[0] == "f")
            surface.triangles.push_back(
                {cells[1].toUInt() - 1, cells[2].toUInt() - 1, cells[3].toUInt() - 1});
    }
    return surface;
}

Surface ply(const QByteArray& bytes) {
    const auto count = [&](const QByteArray& element) {
        const qsizetype at = bytes.indexOf("element " + element + ' ') + element.size() + 9;
        return bytes.mid(at, bytes.indexOf('\n', at) - at).toLongLong();
    };
    Surface surface;
    qsizetype at = bytes.indexOf("end_header\n") + 11;
    for (qlonglong i = 0; i < count("vertex"); ++i, at += 12)
        surface.points.push_back(
            {numberAt<float>(bytes, at), numberAt<float>(bytes, at + 4), numberAt<float>(bytes, at + 8)});
    for (qlonglong i = 0; i < count("face"); ++i, at += 13)
        surface.triangles.push_back({numberAt<quint32>(bytes, at + 1), numberAt<quint32>(bytes, at + 5),
                                     numberAt<quint32>(bytes, at + 9)});
    return at == bytes.size() ? surface : Surface();
}

QJsonObject sceneOf(const QByteArray& glb) {
    return QJsonDocument::fromJson(glb.mid(20, numberAt<quint32>(glb, 12))).object();
}

Surface glb(const QByteArray& bytes) {
    Surface surface;
    const QJsonArray accessors = sceneOf(bytes)["accessors"_L1].toArray();
    const QJsonArray views = sceneOf(bytes)["bufferViews"_L1].toArray();
    const qsizetype binary = 20 + qsizetype(numberAt<quint32>(bytes, 12)) + 8;
    qsizetype at = binary + views[0]["byteOffset"_L1].toInt();
    for (int i = 0; i < accessors[0]["count"_L1].toInt(); i += 3, at += 12)
        surface.triangles.push_back({numberAt<quint32>(bytes, at), numberAt<quint32>(bytes, at + 4),
                                     numberAt<quint32>(bytes, at + 8)});
    at = binary + views[1]["byteOffset"_L1].toInt();
    for (int i = 0; i < accessors[1]["count"_L1].toInt(); ++i, at += 12)
        surface.points.push_back(
            {numberAt<float>(bytes, at), numberAt<float>(bytes, at + 4), numberAt<float>(bytes, at + 8)});
    return surface;
}

// Every edge once in each direction.
bool isClosed(const Surface& surface) {
    std::map<std::pair<quint32, quint32>, int> edges;
    for (const auto& t : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{t[k], t[(k + 1) % 3]}];
        }
    for (const auto& [edge, count] : edges)
        if (count != 1 || !edges.contains({edge.second, edge.first})) return false;
    return !surface.triangles.empty();
}

systems::System3 dust() { // eight corners that never touch
    systems::System3 system;
    for (int k = 0; k < 8; ++k)
        ifs::append<3>(system, systems::scaled(0.3, 0.7 * (k & 1), 0.7 * (k >> 1 & 1), 0.7 * (k >> 2)));
    return system;
}

// The six faces of a cube as squares that are filled: hollow inside.
systems::System3 box() {
    systems::System3 system;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int quarter = 0; quarter < 4; ++quarter) {
                ifs::AffineMap<3> map;
                map.linear *= 0.5;
                map.linear(axis, axis) = 0;
                map.translation[(axis + 1) % 3] = 0.5 * (quarter & 1);
                map.translation[(axis + 2) % 3] = 0.5 * (quarter >> 1);
                map.translation[axis] = side;
                ifs::append<3>(system, map);
            }
    return system;
}

} // namespace

QByteArray SolidExportTest::written(const document::Fractal& fractal, const io::SolidOptions& options,
                                    io::MeshFormat format, QString* report) {
    const QString path = m_folder.filePath(u"solid."_s + io::suffixOf(format));
    const io::ExportOutcome outcome = io::exportSolid({fractal, options, format,
                                                       [&](const io::SolidFacts& facts) {
                                                           if (report)
                                                               *report = io::summaryOf(facts, options);
                                                       }},
                                                      path);
    if (outcome.failure) qWarning("%s", qPrintable(*outcome.failure));
    QFile file(path);
    return !outcome.failure && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void SolidExportTest::theBoundHolds_data() {
    QTest::addColumn<systems::System3>("system");
    QTest::newRow("menger") << systems::menger();
    QTest::newRow("tetrahedron") << systems::tetrahedron();
    QTest::newRow("fern") << systems::fern3();
}

// Every point of the surface is within the bound of points of the attractor, of which there are many.
void SolidExportTest::theBoundHolds() {
    QFETCH(systems::System3, system);
    const io::PrintableSolid solid = io::printableSolid(solidOf(system), resolution(20));
    QVERIFY(!solid.failure);
    QVERIFY(std::abs(solid.facts.bound - std::numbers::sqrt3 * solid.facts.voxel) < 1e-12);
    const double cell = solid.facts.bound;
    std::map<std::array<int, 3>, std::vector<Vector3>> cells;
    const attractor::PreparedSpace prepared = attractor::preparedSpace(system);
    attractor::SpaceOrbit orbit(prepared, 1);
    const auto cellOf = [cell](const Vector3& x) {
        return std::array{int(std::floor(x.x() / cell)), int(std::floor(x.y() / cell)),
                          int(std::floor(x.z() / cell))};
    };
    for (int i = 0; i < 400'000; ++i) {
        const Vector3& x = orbit.next().x;
        auto& there = cells[cellOf(x)];
        if (there.size() < 400) there.push_back(x);
    }
    for (const auto& point : solid.mesh.points) {
        const Vector3 at = solid.origin + solid.unit * Vector3(point[0], point[1], point[2]);
        double nearest = HUGE_VAL;
        const auto [i, j, k] = cellOf(at);
        for (int n = 0; n < 27; ++n)
            if (const auto there = cells.find({i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1});
                there != cells.end())
                for (const Vector3& x : there->second)
                    nearest = std::min(nearest, (x - at).norm());
        QVERIFY2(nearest <= solid.facts.bound, qPrintable(QString::number(nearest / solid.facts.bound)));
    }
}

void SolidExportTest::lengthsAreMillimetres() {
    io::SolidOptions options;
    options.longest = 60;
    options.voxel = 2;
    const io::PrintableSolid solid = io::printableSolid(solidOf(systems::menger()), options);
    QVERIFY(!solid.failure);
    QVERIFY(solid.facts.voxel > 1.8 && solid.facts.voxel <= 2);
    for (int k = 0; k < 3; ++k)
        QVERIFY(std::abs(solid.facts.size[k] - 60) < 1e-9);
    QVERIFY(solid.facts.volume > 0 && solid.facts.volume < std::pow(60, 3));
    document::Fractal large = solidOf(systems::menger());
    ifs::ControlCage<3> cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    cage.current = {{0, 0, 0}, {10, 0, 0}, {0, 20, 0}, {0, 0, 30}};
    document::space(large)->cage = cage;
    const io::PrintableSolid caged = io::printableSolid(large, resolution(30));
    QVERIFY(caged.facts.size.x() >= 10 && caged.facts.size.x() < 12);
    QVERIFY(caged.facts.size.z() >= 30 && caged.facts.size.z() < 32);
}

void SolidExportTest::theLongestSideIsThatOfTheFile_data() {
    QTest::addColumn<double>("wall");
    for (const double wall : {0.0, 1.0, 12.0})
        QTest::addRow("wall %g", wall) << wall;
}

// Though its voxels and its wall extend beyond the attractor; the wall has its thickness nevertheless.
void SolidExportTest::theLongestSideIsThatOfTheFile() {
    QFETCH(double, wall);
    io::SolidOptions options = resolution(64);
    options.longest = 50;
    options.wall = wall;
    const io::PrintableSolid solid = io::printableSolid(solidOf(systems::menger()), options);
    QVERIFY2(!solid.failure, qPrintable(solid.failure.value_or(QString())));
    const Surface surface = stl(written(solidOf(systems::menger()), options, io::MeshFormat::Stl));
    Vector3 low = Vector3::Constant(HUGE_VAL), high = -low;
    for (const auto& p : surface.points)
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], double(p[std::size_t(k)]));
            high[k] = std::max(high[k], double(p[std::size_t(k)]));
        }
    QVERIFY(std::abs((high - low).maxCoeff() - 50) < 1e-4);
    QVERIFY((solid.facts.size - (high - low)).cwiseAbs().maxCoeff() < 1e-4);
    const double side = solid.facts.dilation > 0 ? 8 * solid.unit : 0; // of a voxel
    const double layers = side > 0 ? solid.facts.dilation / (std::numbers::sqrt3 * side) : 0;
    QVERIFY((2 * layers + 1) * 8 * solid.unit >= wall * (1 - 1e-9));
}

void SolidExportTest::wallsAreThick() {
    io::SolidOptions options;
    options.voxel = 0.5;
    options.wall = 3;
    systems::System3 point;
    ifs::append<3>(point, systems::scaled(0.5, 1, 1, 1));
    const io::PrintableSolid solid = io::printableSolid(solidOf(point), options);
    QVERIFY(!solid.failure);
    for (int k = 0; k < 3; ++k)
        QVERIFY(solid.facts.size[k] >= 3 && solid.facts.size[k] <= 4);
    QVERIFY(solid.facts.dilation > 0);
    QCOMPARE(solid.facts.bound, std::numbers::sqrt3 * 0.5 + solid.facts.dilation);
}

void SolidExportTest::cavitiesAreFilledOnRequest() {
    io::SolidOptions options = resolution(20);
    const io::PrintableSolid hollow = io::printableSolid(solidOf(box()), options);
    QCOMPARE(hollow.facts.cavities, std::uint64_t(1));
    QVERIFY(hollow.facts.volume < 0.6);
    options.fillsCavities = true;
    const io::PrintableSolid filled = io::printableSolid(solidOf(box()), options);
    QVERIFY(std::abs(filled.facts.volume - (hollow.facts.volume + hollow.facts.cavityVolume)) < 1e-9);
    QVERIFY(filled.facts.volume > 1);
    QVERIFY(io::summaryOf(filled.facts, options).contains(u"filled: 1"_s));
}

void SolidExportTest::islandsAreReported() {
    const io::PrintableSolid solid = io::printableSolid(solidOf(dust()), resolution(20));
    QCOMPARE(solid.facts.islands, std::uint64_t(64));
    QVERIFY(io::summaryOf(solid.facts, {}).contains(u"Separate bodies: 64"_s));
}

void SolidExportTest::everyFormatHoldsTheSameSurface() {
    const document::Fractal fractal = solidOf(systems::tetrahedron());
    const io::SolidOptions options = resolution(24);
    const io::PrintableSolid solid = io::printableSolid(fractal, options);
    QString report;
    const std::array surfaces{stl(written(fractal, options, io::MeshFormat::Stl, &report)),
                              obj(written(fractal, options, io::MeshFormat::Obj)),
                              ply(written(fractal, options, io::MeshFormat::Ply)),
                              glb(written(fractal, options, io::MeshFormat::Glb))};
    for (const Surface& surface : surfaces) {
        QVERIFY(isClosed(surface));
        QCOMPARE(surface.points.size(), solid.mesh.points.size());
        QCOMPARE(surface.triangles.size(), solid.mesh.triangles.size());
        QVERIFY(std::abs(surface.volume() - solid.facts.volume) < 1e-4 * solid.facts.volume);
    }
    QVERIFY(report.contains(u"mm³"_s) && report.contains(u"√3"_s));
}

// The header, the chunks and the accessors, by the specification of glTF 2.0.
void SolidExportTest::glbIsWellFormed() {
    const QByteArray bytes = written(solidOf(systems::menger()), resolution(12), io::MeshFormat::Glb);
    QVERIFY(bytes.startsWith("glTF"));
    QCOMPARE(numberAt<quint32>(bytes, 4), quint32(2));
    QCOMPARE(qsizetype(numberAt<quint32>(bytes, 8)), bytes.size());
    const auto json = qsizetype(numberAt<quint32>(bytes, 12));
    QCOMPARE(json % 4, qsizetype(0));
    QCOMPARE(bytes.mid(16, 4), QByteArray("JSON"));
    QCOMPARE(bytes.mid(20 + json + 4, 4), QByteArray("BIN\0", 4));
    QCOMPARE(28 + json + qsizetype(numberAt<quint32>(bytes, 20 + json)), bytes.size());
    const QJsonObject scene = sceneOf(bytes);
    QCOMPARE(scene["asset"_L1]["version"_L1].toString(), u"2.0"_s);
    QCOMPARE(scene["buffers"_L1][0]["byteLength"_L1].toInteger(), qint64(bytes.size() - 28 - json));
    const QJsonArray views = scene["bufferViews"_L1].toArray();
    QCOMPARE(views[1]["byteOffset"_L1].toInteger(), views[0]["byteLength"_L1].toInteger());
    const Surface surface = glb(bytes);
    std::array<float, 3> low = surface.points[0], high = low;
    for (const auto& p : surface.points)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    const QJsonObject positions = scene["accessors"_L1][1].toObject();
    for (int k = 0; k < 3; ++k) {
        QCOMPARE(float(positions["min"_L1][k].toDouble()), low[std::size_t(k)]);
        QCOMPARE(float(positions["max"_L1][k].toDouble()), high[std::size_t(k)]);
    }
    for (const auto& triangle : surface.triangles)
        for (const quint32 point : triangle)
            QVERIFY(point < surface.points.size());
}

void SolidExportTest::admeshFindsNothing_data() {
    theBoundHolds_data();
    QTest::newRow("dust") << dust();
    QTest::newRow("box") << box();
}

// What a program for repairing prints says of our files.
void SolidExportTest::admeshFindsNothing() {
    QFETCH(systems::System3, system);
    const QString admesh = QStandardPaths::findExecutable(u"admesh"_s);
    QVERIFY2(!admesh.isEmpty(), "admesh is missing");
    QVERIFY(!written(solidOf(system), resolution(40), io::MeshFormat::Stl).isEmpty());
    QProcess process;
    process.start(admesh, {m_folder.filePath(u"solid.stl"_s)});
    QVERIFY(process.waitForFinished(60'000));
    const QString said = QString::fromLatin1(process.readAllStandardOutput());
    QCOMPARE(process.exitCode(), 0);
    const auto number = [&said](const QString& label) { // the last of its line
        const auto match = QRegularExpression(label + u"[^\\n]*?(\\d+)\\s*\\n"_s).match(said);
        return match.hasMatch() ? match.captured(1).toLongLong() : -1;
    };
    for (const QString& flaw :
         {u"Total disconnected facets"_s, u"Degenerate facets"_s, u"Edges fixed"_s, u"Facets removed"_s,
          u"Facets added"_s, u"Facets reversed"_s, u"Backwards edges"_s})
        QVERIFY2(number(flaw) == 0, qPrintable(said));
}

void SolidExportTest::openScadGrowsWithTheMaps() {
    document::Fractal fractal = solidOf(systems::menger());
    const io::OpenScad usual = io::openScad(fractal);
    QVERIFY(!usual.failure);
    QCOMPARE(usual.text.count("multmatrix"), 20);
    QCOMPARE(usual.depth, 2);
    const io::OpenScad fine = io::openScad(fractal, 0.1); // √3/27 < 0.1 < √3/9
    QCOMPARE(fine.depth, 3);
    QVERIFY(fine.bound <= 0.1 && fine.text.size() == usual.text.size());
    QVERIFY(io::openScad(fractal, 1e-6).failure);
    ifs::ControlCage<3> cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    cage.current[3] = {0, 0, 2};
    document::space(fractal)->cage = cage;
    QCOMPARE(io::openScad(fractal).text.count("multmatrix"), 21);
}

// The program read and worked out by ourselves: matrices and the box at the bottom.
void SolidExportTest::openScadPartsLieOnTheAttractor() {
    const systems::System3 system = systems::fern3();
    const QString text = QString::fromUtf8(io::openScad(solidOf(system)).text);
    std::vector<std::vector<double>> found;
    static const QRegularExpression matrix(u"multmatrix\\(\\[(.*)\\]\\) part\\(level - 1\\);"_s);
    for (auto it = matrix.globalMatch(text); it.hasNext();) {
        std::vector<double> numbers;
        static const QRegularExpression separators(u"[\\[\\], ]+"_s);
        for (const QString& cell : it.next().captured(1).split(separators, Qt::SkipEmptyParts))
            numbers.push_back(cell.toDouble());
        found.push_back(numbers);
    }
    QCOMPARE(found.size(), system.maps.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const ifs::AffineMap<3>& map = system.maps[i].map;
        QCOMPARE(found[i].size(), std::size_t(16));
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                QCOMPARE(found[i][std::size_t(4 * row + column)], map.linear(row, column));
            QCOMPARE(found[i][std::size_t(4 * row + 3)], map.translation[row]);
        }
        QCOMPARE(found[i][15], 1.0);
    }
    QVERIFY(text.contains(u"module part(level)"_s) && text.contains(u"translate(["_s));
    QVERIFY(text.endsWith(u"part(depth);\n"_s));
}

void SolidExportTest::whatHasNoSolid_data() {
    QTest::addColumn<systems::System3>("system");
    QTest::addColumn<io::SolidOptions>("options");
    QTest::addColumn<QString>("because");
    systems::System3 growing;
    ifs::append<3>(growing, systems::scaled(2, 0, 0, 0));
    ifs::append<3>(growing, systems::scaled(2, 1, 0, 0));
    QTest::newRow("no attractor") << growing << resolution(20) << u"no certified attractor"_s;
    QTest::newRow("no maps") << systems::System3() << resolution(20) << u"no certified attractor"_s;
    systems::System3 point;
    ifs::append<3>(point, systems::scaled(0.5, 0, 0, 0));
    QTest::newRow("a point") << point << resolution(20) << u"single point"_s;
    io::SolidOptions fine;
    fine.voxel = 1e-9;
    QTest::newRow("too fine") << systems::menger() << fine << u"million voxels"_s;
    io::SolidOptions thick = resolution(100);
    thick.wall = 1e9;
    QTest::newRow("too thick") << systems::menger() << thick << u"wall"_s;
    QTest::newRow("too many voxels") << systems::menger() << resolution(1000) << u"at most 510"_s;
    systems::System3 far;
    for (int k = 0; k < 4; ++k)
        ifs::append<3>(far, systems::scaled(0.5, 5e8 + (k & 1), k >> 1, 0));
    QTest::newRow("far away") << far << resolution(100) << u"distance from the origin"_s;
}

void SolidExportTest::lowerThanTheLowestIsNotAdvised() {
    systems::System3 slow; // whose words are as large as the whole, however long
    ifs::append<3>(slow, systems::scaled(0.99999999, 0, 0, 0));
    ifs::append<3>(slow, systems::scaled(0.99999999, 1, 0.3, 0.2));
    const auto said = [&](int voxels) {
        const auto solid = io::printableSolid(solidOf(slow), resolution(voxels));
        return solid.failure.value_or(QString());
    };
    QVERIFY(said(io::SolidOptions::leastOffered + 1).contains(u"Choose a lower resolution"));
    QVERIFY(said(io::SolidOptions::leastOffered).contains(u"even at the lowest resolution"));
    QVERIFY(!said(io::SolidOptions::leastOffered).contains(u"Choose"));
}

void SolidExportTest::whatHasNoSolid() {
    QFETCH(systems::System3, system);
    QFETCH(io::SolidOptions, options);
    QFETCH(QString, because);
    const QString path = m_folder.filePath(u"none.stl"_s);
    const auto outcome = io::exportSolid({solidOf(system), options, io::MeshFormat::Stl}, path);
    QVERIFY(outcome.failure.has_value());
    QCOMPARE(io::obstacleToSolid(solidOf(system), options),
             because == u"distance from the origin"_s ? io::Failure() : outcome.failure);
    QVERIFY2(outcome.failure->contains(because), qPrintable(*outcome.failure));
    QVERIFY(!QFile::exists(path));
}

// The resolution that the sentence names is the highest that fits, also with a wall.
void SolidExportTest::theHighestResolutionIsNamed() {
    for (const double wall : {0.0, 20.0}) {
        io::SolidOptions options = resolution(io::SolidOptions::maxResolution);
        options.longest = 80;
        options.wall = wall;
        const document::Fractal fractal = solidOf(systems::menger());
        const io::Failure obstacle = io::obstacleToSolid(fractal, options);
        QVERIFY(obstacle);
        static const QRegularExpression number(u"at most ([0-9]+)"_s);
        options.resolution = number.match(*obstacle).captured(1).toInt();
        QVERIFY2(options.resolution > 300, qPrintable(*obstacle));
        QVERIFY(!io::obstacleToSolid(fractal, options));
        ++options.resolution;
        QCOMPARE(io::obstacleToSolid(fractal, options), obstacle);
    }
}

void SolidExportTest::hardSystemsEnd_data() {
    QTest::addColumn<systems::System3>("system");
    canonical::Random random(11);
    systems::System3 needle, huge, many, overlapping;
    for (int k = 0; k < 4; ++k) {
        ifs::AffineMap<3> map = systems::scaled(0.5, k & 1, 1e-9 * (k >> 1), 1e-12 * (k == 3));
        ifs::append<3>(needle, map);
        ifs::append<3>(huge, systems::scaled(0.5, 1e30 * (k & 1), 1e30 * (k >> 1), 1e29 * (k == 3)));
    }
    for (int k = 0; k < (support::isThorough() ? 10'000 : 3'000); ++k) {
        ifs::AffineMap<3> map;
        map.linear = canonical::randomMatrix<3>(random, 0.02);
        map.translation = canonical::randomVector<3>(random, 1);
        ifs::append<3>(many, map);
    }
    for (int k = 0; k < (support::isThorough() ? 12 : 4); ++k)
        ifs::append<3>(overlapping,
                       {0.9 * ifs::Matrix<3>::Identity(), canonical::randomVector<3>(random, 1)});
    QTest::newRow("needle") << needle;
    QTest::newRow("huge") << huge;
    QTest::newRow("thousands of maps") << many;
    QTest::newRow("overlapping") << overlapping;
}

// A surface, or a sentence, in bounded time.
void SolidExportTest::hardSystemsEnd() {
    QFETCH(systems::System3, system);
    const support::ProcessorTimer clock;
    const io::PrintableSolid solid =
        io::printableSolid(solidOf(system), resolution(support::isThorough() ? 100 : 20));
    QVERIFY2(clock.elapsed() < 240'000, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(solid.failure ? !solid.failure->isEmpty() : !solid.mesh.triangles.empty());
}

void SolidExportTest::stopsWithoutAFile() {
    std::stop_source source;
    source.request_stop();
    const QString path = m_folder.filePath(u"stopped.stl"_s);
    const auto outcome = io::exportSolid({solidOf(systems::menger()), resolution(300), io::MeshFormat::Stl},
                                         path, {}, source.get_token());
    QVERIFY(outcome.stopped && !outcome.failure);
    QVERIFY(!QFile::exists(path));
}

BARYCAGE_TEST(SolidExportTest, QCoreApplication);
#include "solid_export_test.moc"
