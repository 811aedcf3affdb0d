// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "io/solid/openscad.h"
#include "io/solid/solid_export.h"
#include "support/named_test.h"

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

using namespace Qt::StringLiterals;

// Meshes and OpenSCAD programs, as the programs read them that they are meant for.
class MeshProgramsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!qEnvironmentVariableIsSet("BARYCAGE_OTHER_PROGRAMS"))
            QSKIP("./dev test --programs asks other programs");
        QVERIFY(m_folder.isValid());
        m_fractal.name = u"solid"_s;
        m_fractal.shape = document::Shape<3>{systems::menger()};
    }
    void openScadOpensMeshes();
    void openScadDrawsPrograms();
    void meshLabFindsAClosedSurface_data();
    void meshLabFindsAClosedSurface();
    void assimpReadsAllOfIt_data();
    void assimpReadsAllOfIt();

private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    // The mesh of m_fractal, in a file of that name.
    io::SolidFacts written(const QString& name) const {
        io::SolidFacts result;
        io::SolidOptions options;
        options.resolution = 20;
        const auto outcome = io::exportSolid({m_fractal, options, *io::meshFormat(name.section(u'.', 1)),
                                              [&](const io::SolidFacts& facts) { result = facts; }},
                                             path(name));
        return outcome.failure ? io::SolidFacts() : result;
    }
    // What it says; nullopt where it, or what it needs, is not installed.
    std::optional<QString> answer(const QStringList& command) const;

    QTemporaryDir m_folder;
    document::Fractal m_fractal;
};

namespace {

// The last number of the first line with that label; −1 where there is none.
double numberOf(const QString& said, const QString& label) {
    const auto match = QRegularExpression(label + u"[^\\n]*?(-?[0-9][0-9.e+-]*)[ ]*(\\n|$)"_s).match(said);
    return match.hasMatch() ? match.captured(1).toDouble() : -1;
}

struct OffFile {
    qsizetype points = 0;
    qsizetype triangles = 0;
    double volume = 0;
};

OffFile off(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    QTextStream text(&file);
    OffFile result;
    QString word;
    text >> word >> result.points >> result.triangles >> word;
    std::vector<ifs::Vector<3>> points(std::size_t(result.points), ifs::Vector<3>::Zero());
    for (ifs::Vector<3>& point : points)
        text >> point.x() >> point.y() >> point.z();
    for (qsizetype i = 0; i < result.triangles; ++i) {
        int count = 0;
        std::array<std::size_t, 3> corner{};
        text >> count >> corner[0] >> corner[1] >> corner[2];
        text.readLine(); // its colour
        if (count != 3 || std::ranges::max(corner) >= points.size()) return {};
        result.volume += points[corner[0]].dot(points[corner[1]].cross(points[corner[2]])) / 6;
    }
    return result;
}

} // namespace

std::optional<QString> MeshProgramsTest::answer(const QStringList& command) const {
    for (const QString& word : command)
        if (!word.startsWith(u'-') && !word.contains(u'.') && word != u"info" &&
            QStandardPaths::findExecutable(word).isEmpty())
            return std::nullopt;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"LC_ALL"_s, u"C"_s);
    if (command.front() == u"xvfb-run") environment.remove(u"QT_QPA_PLATFORM"_s); // OpenGL is needed
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.setWorkingDirectory(m_folder.path());
    process.start(command.front(), command.mid(1));
    process.waitForFinished(120'000);
    const bool isDone = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    const QString said = QString::fromUtf8(process.readAll());
    return isDone ? said : u"failed: "_s + said;
}

void MeshProgramsTest::openScadOpensMeshes() {
    const io::SolidFacts facts = written(u"solid.stl"_s);
    write(u"import.scad"_s, "import(\"solid.stl\");\n");
    const auto said = answer({u"openscad"_s, u"-o"_s, u"import.off"_s, u"import.scad"_s});
    if (!said) QSKIP("openscad is not installed");
    const OffFile read = off(path(u"import.off"_s));
    QVERIFY2(read.triangles > 0, qPrintable(*said));
    QCOMPARE(std::uint64_t(read.triangles), facts.triangles);
    QVERIFY(std::abs(read.volume - facts.volume) < 1e-4 * facts.volume);
}

// Two levels of cubes.
void MeshProgramsTest::openScadDrawsPrograms() {
    const io::OpenScad program = io::openScad(m_fractal);
    QCOMPARE(program.depth, 2);
    write(u"solid.scad"_s, program.text);
    const auto said = answer({u"openscad"_s, u"-o"_s, u"solid.off"_s, u"solid.scad"_s});
    if (!said) QSKIP("openscad is not installed");
    QVERIFY2(QRegularExpression(u"Simple:\\s+yes"_s).match(*said).hasMatch(), qPrintable(*said));
    const double volume = off(path(u"solid.off"_s)).volume;
    QVERIFY2(std::abs(volume - std::pow(20.0 / 27, 2)) < 1e-4, qPrintable(QString::number(volume)));
}

// Debian's MeshLab ends by itself at any OBJ file, however small.
void MeshProgramsTest::meshLabFindsAClosedSurface_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("STL") << u"solid.stl"_s;
    QTest::newRow("PLY") << u"solid.ply"_s;
}

void MeshProgramsTest::meshLabFindsAClosedSurface() {
    QFETCH(QString, name);
    const io::SolidFacts facts = written(name);
    write(u"measure.mlx"_s, "<!DOCTYPE FilterScript>\n<FilterScript>\n"
                            "<filter name=\"Compute Topological Measures\"/>\n"
                            "<filter name=\"Compute Geometric Measures\"/>\n</FilterScript>\n");
    const auto said = answer({u"xvfb-run"_s, u"-a"_s, u"meshlabserver"_s, u"-i"_s, name, u"-o"_s,
                              u"copy.ply"_s, u"-s"_s, u"measure.mlx"_s});
    if (!said) QSKIP("meshlabserver or xvfb-run is not installed (packages meshlab and xvfb)");
    QVERIFY2(said->contains(u"Mesh is two-manifold"_s), qPrintable(*said));
    QCOMPARE(numberOf(*said, u"Boundary Edges"_s), 0.0);
    QCOMPARE(numberOf(*said, u"V:.*F:"_s), double(facts.triangles));
    const double volume = numberOf(*said, u"Mesh Volume"_s);
    QVERIFY2(std::abs(volume - facts.volume) < 1e-4 * facts.volume, qPrintable(*said));
}

void MeshProgramsTest::assimpReadsAllOfIt_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("size"); // of a millimetre, in the unit of the format
    QTest::newRow("STL") << u"solid.stl"_s << 1.0;
    QTest::newRow("OBJ") << u"solid.obj"_s << 1.0;
    QTest::newRow("PLY") << u"solid.ply"_s << 1.0;
    QTest::newRow("GLB") << u"solid.glb"_s << 1e-3;
}

void MeshProgramsTest::assimpReadsAllOfIt() {
    QFETCH(QString, name);
    QFETCH(double, size);
    const io::SolidFacts facts = written(name);
    const auto said = answer({u"assimp"_s, u"info"_s, name});
    if (!said) QSKIP("assimp is not installed (package assimp-utils)");
    QCOMPARE(numberOf(*said, u"\\nFaces:"_s), double(facts.triangles));
    const auto corner = QRegularExpression(u"Maximum point\\s+\\((\\S+) (\\S+) (\\S+)\\)"_s).match(*said);
    QVERIFY2(corner.hasMatch(), qPrintable(*said));
    for (int k = 0; k < 3; ++k) // the cube is [0, 1]³, and the mesh lies around it evenly
        QVERIFY2(std::abs(corner.captured(k + 1).toDouble() - size * (1 + facts.size[k]) / 2) < 2e-6,
                 qPrintable(*said));
}

BARYCAGE_TEST(MeshProgramsTest, QCoreApplication);
#include "mesh_programs_test.moc"
