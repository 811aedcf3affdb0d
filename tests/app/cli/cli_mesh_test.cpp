// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QtEndian>

#include <algorithm>

// barycage-cli convert for solids of systems in space, and between plane and space.
class CliMeshTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void writesSurfaces_data();
    void writesSurfaces();
    void everyNameLeavesAllVertices();
    void resolutionIsThatOfTheLongestSide();
    void writesOpenScad();
    void writesPointsWithNormals();
    void liftsAndFlattens();
    void whatIsLiftedTooFarIsSaid();
    void animationsThatStayBehindAreSaid();
    void whatIsTurnedIsNotFlattened();
    void nothingIsPrintedIntoAFile();
    void optionsThatMakeNoSenseAreRefused_data();
    void optionsThatMakeNoSenseAreRefused();
};

void CliMeshTest::init() {
    write("tetra.ifs", "tetra (3D) {\n"
                       " .5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n .5 0 0 0 .5 0 0 0 .5 5 5 0 .25\n"
                       " .5 0 0 0 .5 0 0 0 .5 5 0 5 .25\n .5 0 0 0 .5 0 0 0 .5 0 5 5 .25\n}\n");
}

void CliMeshTest::writesSurfaces_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("begin");
    QTest::newRow("stl") << QByteArray("tetra.stl") << QByteArray("Barycage: binary STL");
    QTest::newRow("obj") << QByteArray("tetra.obj") << QByteArray("# Barycage");
    QTest::newRow("glb") << QByteArray("tetra.glb") << QByteArray("glTF\2\0\0\0", 8);
    QTest::newRow("ply") << QByteArray("tetra.ply") << QByteArray("ply\nformat binary");
}

void CliMeshTest::writesSurfaces() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, begin);
    const Result result = run("convert tetra.ifs " + name + " --voxel .5 --wall 1 --fill");
    QCOMPARE(result.status, 0);
    QCOMPARE(result.err, QByteArray());
    QVERIFY(read(name).startsWith(begin));
    static const QRegularExpression size(
        QStringLiteral("Size: (\\S+) × (\\S+) × (\\S+) mm; volume: \\S+ mm³"));
    const auto match = size.match(QString::fromUtf8(result.out));
    QVERIFY2(match.hasMatch(), result.out.constData());
    for (int k = 1; k <= 3; ++k) { // the cube of side 10, and the wall around it
        const double side = match.captured(k).toDouble();
        QVERIFY(side >= 10 && side <= 12);
    }
    QVERIFY2(result.out.contains("√3 · 0.5 mm"), result.out.constData());
}

// A backslash at the end of a line joins it with the next, as other programs read OBJ.
void CliMeshTest::everyNameLeavesAllVertices() {
    const QByteArray plain = read("tetra.ifs");
    qsizetype expected = 0;
    for (const char* name : {"tetra", "\\", "a\\", "a\xe2\x80\xa8v", "a\x01", "#"}) {
        write("named.ifs", name + plain.mid(5));
        const Result result = run("convert named.ifs named.obj --voxel .5 --wall 1 --fill");
        QVERIFY2(result.status == 0, result.err.constData());
        const QList<QByteArray> lines = read("named.obj").replace("\\\n", "").split('\n');
        const auto isVertex = [](const QByteArray& line) { return line.startsWith("v "); };
        const qsizetype vertices = std::ranges::count_if(lines, isVertex);
        if (expected == 0) expected = vertices;
        QVERIFY(vertices > 3);
        QCOMPARE(vertices, expected);
        QVERIFY2(lines[1].startsWith("o ") && !lines[1].contains('\1'), lines[1].constData());
    }
}

void CliMeshTest::resolutionIsThatOfTheLongestSide() {
    const Result result = run("convert tetra.ifs tetra.stl --resolution 20 --longest 40");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.out.contains("Size: 40 × 40 × 40 mm"), result.out.constData());
    QVERIFY2(result.out.contains("√3 · 1.92308 mm + 0 mm"), result.out.constData()); // less than 40 / 20
    // Without --wall nothing is thickened, which is what the help says; a voxel of thickness takes more.
    QVERIFY(
        run("convert --help").out.simplified().contains("thinner parts are thickened. By default, none is"));
    QVERIFY(
        run("convert tetra.ifs walls.stl --resolution 20 --longest 40 --wall 1.2").out.contains("+ 0 mm"));
    QCOMPARE(read("walls.stl"), read("tetra.stl"));
    QVERIFY(!run("convert tetra.ifs walls.stl --resolution 20 --longest 40 --wall 2 --overwrite")
                 .out.contains("+ 0 mm"));
    const Result usual = run("convert tetra.ifs tetra.stl");
    QVERIFY2(usual.out.contains("√3 · 0.078125 mm"), usual.out.constData());
}

void CliMeshTest::writesOpenScad() {
    QCOMPARE(run("convert tetra.ifs tetra.scad").status, 0);
    const QByteArray text = read("tetra.scad");
    QCOMPARE(text.count("multmatrix"), 4);
    QVERIFY(text.contains("depth = 4;"));
    QCOMPARE(run("convert tetra.ifs tetra.scad --voxel 5").status, 0);
    QVERIFY(read("tetra.scad").contains("depth = 2;")); // √3 · 10/4 < 5
    QCOMPARE(run("convert tetra.ifs tetra.scad --voxel 1e-9").status, 1);
}

void CliMeshTest::writesPointsWithNormals() {
    QCOMPARE(run("convert tetra.ifs points.ply --points 100").status, 0);
    const QByteArray ply = read("points.ply");
    QVERIFY(ply.contains("element vertex 100\n"));
    const qsizetype header = ply.indexOf("end_header\n") + 11;
    constexpr qsizetype row = 3 * 8 + 3 * 4 + 3 + 4 + 8;
    QCOMPARE(ply.size(), header + 100 * row);
    int directed = 0;
    for (qsizetype at = header; at < ply.size(); at += row) {
        double length = 0;
        for (int k = 0; k < 3; ++k) {
            const auto n = double(qFromLittleEndian<float>(ply.constData() + at + 24 + 4 * k));
            length += n * n;
            const auto x = qFromLittleEndian<double>(ply.constData() + at + 8 * k);
            QVERIFY(x >= -1e-9 && x <= 10 + 1e-9);
        }
        QVERIFY(length == 0 || std::abs(length - 1) < 1e-5);
        directed += length > 0 ? 1 : 0;
        const auto map = qFromLittleEndian<qint32>(ply.constData() + at + 39);
        QVERIFY(map >= 1 && map <= 4);
        const auto address = qFromLittleEndian<double>(ply.constData() + at + 43);
        QCOMPARE(int(address * 4), map - 1); // the newest map comes first
    }
    QVERIFY(directed > 50);
    QCOMPARE(run("convert tetra.ifs points.csv --points 10").status, 0);
    QVERIFY(read("points.csv").startsWith("x,y,z,map\n"));
    QCOMPARE(read("points.csv").count('\n'), 11);
}

void CliMeshTest::liftsAndFlattens() {
    QCOMPARE(run("convert systems.ifs lifted.ifs --entry fern --lift auto").status, 0);
    QVERIFY(read("lifted.ifs").contains("(3D)"));
    QCOMPARE(run("convert lifted.ifs back.csv --flatten 0,0,1").status, 0);
    QCOMPARE(run("convert systems.ifs fern.csv --entry fern").status, 0);
    QCOMPARE(read("back.csv"), read("fern.csv"));
    QCOMPARE(run("convert systems.ifs thick.csv --entry fern --lift 0.25").status, 0);
    QCOMPARE(read("thick.csv").count(",0.25,"), 4);
    const Result solid = run("convert systems.ifs fern.stl --entry fern --lift 0.3 --resolution 40");
    QCOMPARE(solid.status, 0);
    QVERIFY(solid.out.contains("mm³"));
}

void CliMeshTest::whatIsLiftedTooFarIsSaid() {
    for (const char* scale : {"1", "-1", "2.5"})
        for (const char* strict : {"", " --strict"}) {
            const Result result =
                run(QByteArray("convert systems.ifs tall.ifs --entry fern --lift=") + scale + strict);
            QCOMPARE(result.status, 0);
            QVERIFY2(result.err.contains("warning") && result.err.contains("has no attractor in space"),
                     result.err.constData());
        }
    for (const char* scale : {"0", "0.999", "-0.5", "auto"})
        QVERIFY(!run(QByteArray("convert systems.ifs low.ifs --entry fern --lift=") + scale)
                     .err.contains("attractor"));
}

void CliMeshTest::animationsThatStayBehindAreSaid() {
    const QByteArray motion = "  ; barycage: animation 96 24/1 cycle\n  ; barycage: motion sway\n"
                              "  ; barycage: strength 7\n  ; barycage: pivot 0 0\n  ; barycage: wave 1\n"
                              "  ; barycage: value 0.5 0 20\n";
    write("moving.ifs", "a {\n" + motion + " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    const Result result = run("convert moving.ifs lifted.ifs --lift auto");
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("The animation of “a” cannot be taken"), result.err.constData());
    QVERIFY(!read("lifted.ifs").contains("animation"));
    QCOMPARE(run("convert lifted.ifs back.ifs --flatten 0,0,1").err, QByteArray());
}

void CliMeshTest::whatIsTurnedIsNotFlattened() {
    write("turned.ifs", "turned (3D) {\n .5 0 0 0 .5 .1 0 -.1 .5 0 0 0 1\n}\n");
    const Result result = run("convert turned.ifs flat.ifs --flatten 0,0,1");
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.contains("Map 1"), result.err.constData());
    QVERIFY(!QFile::exists(path("flat.ifs")));
    QCOMPARE(run("convert turned.ifs flat.ifs --flatten 1,0,0").status, 0);
}

void CliMeshTest::nothingIsPrintedIntoAFile() {
    const Result result = run("convert tetra.ifs - --to stl --resolution 8");
    QCOMPARE(result.status, 0);
    QCOMPARE(result.out.size(), 84 + 50 * qsizetype(qFromLittleEndian<quint32>(result.out.constData() + 80)));
}

void CliMeshTest::optionsThatMakeNoSenseAreRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* name, const char* arguments, int status, const char* message) {
        QTest::newRow(name) << QByteArray(arguments) << status << QByteArray(message);
    };
    row("plane", "systems.ifs a.stl --entry fern", 1, "--lift");
    row("both", "tetra.ifs a.stl --voxel 1 --resolution 9", 2, "--voxel already");
    row("no solid", "tetra.ifs a.csv --voxel 1", 2, "only to solids");
    row("wall", "tetra.ifs a.scad --wall 1", 2, "only to solids");
    row("ply", "tetra.ifs a.ply", 2, "--resolution");
    row("negative", "tetra.ifs a.stl --voxel -1", 2, "--voxel");
    row("resolution", "tetra.ifs a.stl --resolution 0", 2, "--resolution");
    row("too fine", "tetra.ifs a.stl --voxel 1e-6", 1, "million voxels");
    row("longest", "systems.ifs a.stl --entry fern --lift 0.3 --longest 1e300", 2, "1000000 mm");
    row("lift", "systems.ifs a.ifs --lift high", 2, "factor for z");
    row("lift space", "tetra.ifs a.ifs --lift 1", 1, "not a system in the plane");
    row("flatten", "tetra.ifs a.ifs --flatten 0,0", 2, "direction");
    row("flatten nothing", "tetra.ifs a.ifs --flatten 0,0,0", 2, "direction");
    row("flatten plane", "systems.ifs a.ifs --entry fern --flatten 0,0,1", 1, "not a system in space");
    row("there and back", "tetra.ifs a.ifs --lift 1 --flatten 0,0,1", 2, "the opposite");
}

void CliMeshTest::optionsThatMakeNoSenseAreRefused() {
    QFETCH(QByteArray, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, message);
    const Result result = run("convert " + arguments);
    QCOMPARE(result.status, status);
    QVERIFY2(result.err.contains(message), result.err.constData());
    QVERIFY(!QFile::exists(path(arguments.split(' ')[1])));
}

BARYCAGE_TEST(CliMeshTest, QGuiApplication);
#include "cli_mesh_test.moc"
