// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "io/collection_reader.h"
#include "io/exchange/aifs.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>

// Numbers from docs/mathematics.md, "Affine invariant form".
class IfstileTest : public QObject {
    Q_OBJECT

private slots:
    void sierpinskiIsTheMatrixOfMidpoints();
    void flower();
    void rowsSumToOneAndGiveTheMapsBack();
    void sameMatricesWhereverTheSimplexIs();
    void writesWhatIFStileReads();
    void namesAndSwitchedOffMaps();
    void everyBlockHasAName();
    void systemsInSpace();
    void readsBackWhatItWrites();
    void namesWhatItDoesNotRead_data();
    void namesWhatItDoesNotRead();
};

namespace {

using Simplex = ifs::Simplex<2>;

const Simplex unit{ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)};

document::System2 flower() {
    return canonical::system(canonical::flower());
}

void compare(const Eigen::Matrix3d& actual, const Eigen::Matrix3d& expected, double tolerance = 1e-13) {
    QVERIFY((actual - expected).cwiseAbs().maxCoeff() <= tolerance);
}

// Ŵ = T Sᵀ T⁻¹: the map that takes the vertices to the points with the rows as coordinates.
ifs::AffineMap<2> mapOf(const io::RowStochastic& s, const Simplex& simplex) {
    Simplex image;
    for (int j = 0; j < 3; ++j)
        image[std::size_t(j)] = ifs::point<2>(simplex, s.row(j).transpose());
    return ifs::simplexMap<2>(simplex, image);
}

QByteArray text(const document::Fractal& fractal) {
    return io::writeAifs({std::make_shared<const document::Fractal>(fractal)});
}

} // namespace

void IfstileTest::sierpinskiIsTheMatrixOfMidpoints() {
    const Simplex simplex{ifs::Vector<2>(-3, 1), ifs::Vector<2>(5, 2), ifs::Vector<2>(0, 7)};
    document::System2 system;
    for (const auto& vertex : simplex)
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, vertex.x() / 2, vertex.y() / 2));
    const auto form = io::affineInvariantForm(system, simplex);
    QCOMPARE(form.maps.size(), std::size_t(3));
    compare(form.maps[0], (Eigen::Matrix3d() << 1, 0, 0, .5, .5, 0, .5, 0, .5).finished());
    compare(form.maps[1], (Eigen::Matrix3d() << .5, .5, 0, 0, 1, 0, 0, .5, .5).finished());
    compare(form.maps[2], (Eigen::Matrix3d() << .5, 0, .5, 0, .5, .5, 0, 0, 1).finished());
}

void IfstileTest::flower() {
    const auto form = io::affineInvariantForm(::flower(), unit);
    compare(form.maps[0],
            (Eigen::Matrix3d() << -1.11, .37, 1.74, -1.28, .84, 1.44, -1.88, .67, 2.21).finished());
    compare(form.maps[1],
            (Eigen::Matrix3d() << -.41, -.34, 1.75, -1.18, .14, 2.04, -.60, -.63, 2.23).finished());
}

void IfstileTest::rowsSumToOneAndGiveTheMapsBack() {
    const Simplex simplex{ifs::Vector<2>(-1, -2), ifs::Vector<2>(4, 0.5), ifs::Vector<2>(1, 3)};
    const document::System2 system = ::flower();
    const auto form = io::affineInvariantForm(system, simplex);
    for (std::size_t i = 0; i < form.maps.size(); ++i) {
        for (int j = 0; j < 3; ++j)
            QVERIFY(std::abs(form.maps[i].row(j).sum() - 1) <= 1e-13);
        const auto back = mapOf(form.maps[i], simplex);
        QVERIFY((back.linear - system.maps[i].map.linear).norm() <= 1e-13);
        QVERIFY((back.translation - system.maps[i].map.translation).norm() <= 1e-13);
    }
}

void IfstileTest::sameMatricesWhereverTheSimplexIs() {
    const Simplex moved{ifs::Vector<2>(2, 2), ifs::Vector<2>(3, 5), ifs::Vector<2>(-1, 4)};
    const auto system = ::flower();
    const auto transported = ifs::conjugate<2>(ifs::simplexMap<2>(unit, moved), system);
    QVERIFY(transported);
    const auto here = io::affineInvariantForm(system, unit);
    const auto there = io::affineInvariantForm(*transported, moved);
    for (std::size_t i = 0; i < here.maps.size(); ++i)
        compare(there.maps[i], here.maps[i], 1e-12);
}

void IfstileTest::writesWhatIFStileReads() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("2nd fern!");
    document::System2 system;
    ifs::append(system, ifs::affineMap(0.85, 0.04, -0.04, 0.85, 1e-7, 1.6), 0.9);
    ifs::append(system, ifs::affineMap(0, 0, 0, 0.16, 0, 0), 0.1);
    fractal.shape = document::Shape<2>{system};
    const QByteArray bytes = text(fractal);
    QVERIFY2(bytes.startsWith("@s_2nd_fern_:\n$dim=2\n$n=2nd fern!\n"
                              "f1=[0.0000001,1.6]*[0.85,0.04,-0.04,0.85]\n"
                              "f2=[0,0]*[0,0,0,0.16]\n"
                              "A=(f1|f2)*A\n"
                              "# weights: 0.9 0.1\n"
                              "# control triangle at rest: ["),
             bytes.constData());
    QVERIFY2(bytes.contains("\n# S2=[["), bytes.constData());
    for (const QByteArray& line : bytes.split('\n'))
        QVERIFY2(!line.startsWith('f') || !line.contains('e'), line.constData());
}

void IfstileTest::namesAndSwitchedOffMaps() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("leaf\n@evil:");
    document::System2 system = ::flower();
    system.maps[0].enabled = false;
    fractal.shape = document::Shape<2>{system};
    const QByteArray bytes = text(fractal);
    QVERIFY2(bytes.startsWith("@leaf__evil_:\n$dim=2\n$n=leaf @evil:\nf2="), bytes.constData());
    QVERIFY(bytes.contains("\nA=(f2)*A\n"));
    system.maps[1].enabled = false;
    fractal.shape = document::Shape<2>{system};
    QVERIFY(text(fractal).isEmpty());
}

// Names that differ in signs only, or are numbered already.
void IfstileTest::everyBlockHasAName() {
    QList<std::shared_ptr<const document::Fractal>> fractals;
    for (const char* name : {"a!b", "a?b", "a_b", "a_b_2", "A_b", "1", "s_1", "é", "-x", "+x", "_y", "a#b"}) {
        document::Fractal fractal = support::fractalOf(::flower(), QString::fromUtf8(name));
        fractals << std::make_shared<const document::Fractal>(fractal);
    }
    const QByteArray text = io::writeAifs(fractals);
    QStringList ids;
    const QRegularExpression block(QStringLiteral("^@([A-Za-z][A-Za-z0-9_]*):$"),
                                   QRegularExpression::MultilineOption);
    for (auto it = block.globalMatch(QString::fromUtf8(text)); it.hasNext();)
        ids << it.next().captured(1);
    QCOMPARE(ids.size(), fractals.size());
    QCOMPARE(ids.first(), QStringLiteral("a_b"));
    QCOMPARE(ids.removeDuplicates(), 0);
    QVERIFY(text.contains("$n=a?b\n"));
    QVERIFY(text.contains("$n=a_b\n") && !text.contains("a#b")); // a comment would begin there
}

// Vector first, then the matrix row by row.
void IfstileTest::systemsInSpace() {
    document::System3 system;
    ifs::AffineMap<3> map;
    map.linear << .1, .2, .3, .4, .5, .6, .7, .8, .9;
    map.translation << 1, 2, 3;
    ifs::append(system, map, 1.0);
    document::Fractal fractal = support::fractalOf(system, QStringLiteral("cube"));
    QCOMPARE(text(fractal),
             QByteArray("@cube:\n$dim=3\n$n=cube\nf1=[1,2,3]*[0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9]\n"
                        "A=(f1)*A\n# weights: 1\n"));
}

// Through the reader of every file: the same maps, weights and names, to the last digit.
void IfstileTest::readsBackWhatItWrites() {
    document::Fractal plane;
    plane.name = QStringLiteral("größer: a|b (c) = $x");
    document::System2 maps;
    ifs::append(maps, ifs::affineMap(1.0 / 3, -1e-17, 0.1, 0.7, 1e5, -2.5e-9));
    ifs::append(maps, ifs::affineMap(0.48, -0.29, 0.29, 0.48, -0.34, 0));
    maps.maps[0].weight = 0.3;
    maps.maps[1].weight = 0.7;
    plane.shape = document::Shape<2>{maps};
    document::Fractal space;
    space.name = QStringLiteral("tetra");
    document::System3 tetra;
    for (int i = 0; i < 3; ++i) {
        ifs::WeightedMap<3> map;
        map.map.linear = ifs::Matrix<3>::Random();
        map.map.translation = ifs::Vector<3>::Random();
        map.weight = 0.25 * (i + 1);
        tetra.maps.push_back(map);
    }
    space.shape = document::Shape<3>{tetra};
    const QByteArray written = io::writeAifs(
        {std::make_shared<const document::Fractal>(plane), std::make_shared<const document::Fractal>(space)});
    const io::Collection read = io::readCollection(written);
    QCOMPARE(read.format, QStringLiteral("aifs"));
    QVERIFY(read.file.problems.isEmpty());
    QCOMPARE(read.file.entries.size(), 2);
    QCOMPARE(read.file.entries[0].fractal->name, plane.name);
    const auto* back = document::system2(*read.file.entries[0].fractal);
    QVERIFY(back && back->maps.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        QVERIFY(back->maps[i].map == maps.maps[i].map);
        QCOMPARE(*back->maps[i].weight, *maps.maps[i].weight);
    }
    const auto& solid = *document::system3(*read.file.entries[1].fractal);
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(solid.maps[i].map.linear == tetra.maps[i].map.linear);
        QVERIFY(solid.maps[i].map.translation == tetra.maps[i].map.translation);
    }
    QCOMPARE(io::writeAifs({read.file.entries[0].fractal, read.file.entries[1].fractal}), written);
}

void IfstileTest::namesWhatItDoesNotRead_data() {
    QTest::addColumn<QByteArray>("line");
    for (const char* line :
         {"f2=[1,0]*[.5,0,0]", "f2=f1^2", "$companion([1,2])", "f2=[1,x]*[.5,0,0,.5]", "A=(f1|f9)*A",
          "A=(f1)*B", "$dim=5", "f1=[0,0]*[.5,0,0,.5]", "f2=[1,0]*[1e99,0,0,.5]"})
        QTest::newRow(line) << QByteArray(line);
}

// Such a block is named and left out, and stops no other.
void IfstileTest::namesWhatItDoesNotRead() {
    QFETCH(QByteArray, line);
    const io::Collection read =
        io::readCollection("# by hand\n@odd:\nf1=[0,0]*[.5,0,0,.5]\n" + line +
                           "\nA=(f1)*A\n@good:\r\ng=[0, 1]*[.5,0,0,.5]\r\nA=( g ) * A\r\n");
    QCOMPARE(read.file.entries.size(), 2);
    const document::Entry& odd = read.file.entries[0];
    QCOMPARE(document::dimension(*odd.fractal), 0);
    QCOMPARE(odd.problems.size(), 1);
    QVERIFY2(odd.problems[0].message.contains(QString::fromUtf8(line)), qPrintable(odd.problems[0].message));
    QCOMPARE(odd.problems[0].line, 4);
    QCOMPARE(document::system2(*read.file.entries[1].fractal)->maps.size(), std::size_t(1));
}

BARYCAGE_TEST(IfstileTest);
#include "ifstile_test.moc"
