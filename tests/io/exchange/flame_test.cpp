// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "ifs/canonical_systems.h"
#include "ifs/system/links.h"
#include "io/exchange/flame.h"
#include "io/exchange/text_formats.h"
#include "io/picture/plane_export.h"
#include "support/named_test.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <vector>

using document::System2;

class FlameTest : public QObject {
    Q_OBJECT

private slots:
    void readsColumnsAndFlipsY();
    void linearAmountAndPostAreApplied();
    void refusesWhatIsNotAffine_data();
    void refusesWhatIsNotAffine();
    void flamesInSpace();
    void linearLeavesZOut();
    void refusesADocumentType();
    void kindsOfSymmetry_data();
    void kindsOfSymmetry();
    void transformsOfSymmetry();
    void symmetriesComeBack_data();
    void symmetriesComeBack();
    void oneBadFlameDoesNotStopTheOthers();
    void writesWhatFlamesExpect();
    void roundTripIsExact();
    void flam3DrawsTheSame_data();
    void flam3DrawsTheSame();
    void weightsComeBackAsTheyWere();
    void opacitiesAreNotKept();
    void palettesBackgroundsAndColoursAreRead_data();
    void palettesBackgroundsAndColoursAreRead();
    void coloursComeBack_data();
    void coloursComeBack();
    void contrastAndVibrancyAreReadAndWritten();
    void namesStayWhole();
    void survivesDamage();
};

namespace {

QByteArray flame(const QByteArray& xform) {
    return "<flames>\n<flame name=\"a\" size=\"10 10\">\n" + xform + "\n</flame></flames>";
}

const System2& onlySystem(const document::FractalFile& file) {
    static const System2 none;
    if (file.entries.size() != 1) return none;
    const System2* system = document::system2(*file.entries.first().fractal);
    return system ? *system : none;
}

document::Fractal randomFractal(QRandomGenerator& random, int index) {
    document::Fractal fractal;
    fractal.name = QStringLiteral("random%1").arg(index);
    System2 system;
    const int count = random.bounded(1, 9);
    for (int i = 0; i < count; ++i) {
        double c[6];
        for (double& value : c)
            value = random.generateDouble() * 2 - 1;
        ifs::append(system, ifs::affineMap(c[0] / 2, c[1] / 2, c[2] / 2, c[3] / 2, c[4], c[5]), 1.0 / count);
    }
    fractal.shape = document::Shape<2>{system};
    return fractal;
}

// The pixels drawn in one picture near which the other shows no trace.
int missing(const QImage& a, const QImage& b) {
    constexpr int drawn = 120;
    constexpr int traced = 12;
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            if (qGray(a.pixel(x, y)) < drawn) continue;
            bool found = false;
            for (int dy = -1; dy <= 1 && !found; ++dy)
                for (int dx = -1; dx <= 1 && !found; ++dx)
                    found = b.valid(x + dx, y + dy) && qGray(b.pixel(x + dx, y + dy)) > traced;
            count += !found;
        }
    return count;
}

// What flam3-render draws of the flames in a file, at that part of their size; null when it fails.
QImage drawnByFlam3(const QString& program, const QString& flames, double part) {
    const QString output = flames + QStringLiteral(".png");
    QProcess flam3;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("in"), flames);
    environment.insert(QStringLiteral("out"), output);
    environment.insert(QStringLiteral("ss"), QString::number(part));
    environment.insert(QStringLiteral("isaac_seed"), QStringLiteral("7"));
    flam3.setProcessEnvironment(environment);
    flam3.start(program, QStringList());
    return flam3.waitForFinished(120'000) ? QImage(output) : QImage();
}

} // namespace

void FlameTest::readsColumnsAndFlipsY() {
    const QByteArray bytes = flame(R"(<xform weight="0.25" linear="1" coefs="1 2 3 4 5 6"/>)");
    const System2 written = onlySystem(io::readFlame(bytes, io::FlameAxis::AsWritten));
    QCOMPARE(written.maps.size(), std::size_t(1));
    // x' = 1x + 3y + 5, y' = 2x + 4y + 6
    QVERIFY(written.maps[0].map == ifs::affineMap(1, 3, 2, 4, 5, 6));
    QCOMPARE(written.maps[0].weight.value(), 0.25);
    const System2 upright = onlySystem(io::readFlame(bytes));
    QVERIFY(upright.maps[0].map == ifs::affineMap(1, -3, -2, 4, 5, -6));
}

void FlameTest::linearAmountAndPostAreApplied() {
    const System2 system = onlySystem(
        io::readFlame(flame(R"(<xform weight="1" linear="0.5" coefs="1 0 0 1 2 4" post="0 1 -1 0 10 20"/>)"),
                      io::FlameAxis::AsWritten));
    // p → post(½ p + (1, 2)), post a quarter turn and (10, 20): x' = −(½y + 2) + 10, y' = ½x + 1 + 20
    QVERIFY(system.maps.at(0).map == ifs::affineMap(0, -0.5, 0.5, 0, 8, 21));
}

void FlameTest::refusesWhatIsNotAffine_data() {
    QTest::addColumn<QByteArray>("xform");
    QTest::addColumn<QString>("because");
    QTest::newRow("variation") << QByteArray(
                                      R"(<xform weight="1" linear="1" spherical="0.2" coefs="1 0 0 1 0 0"/>)")
                               << "spherical";
    QTest::newRow("chaos") << QByteArray(
                                  R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0" chaos="1 -0.5"/>)")
                           << "chaos";
    QTest::newRow("final")
        << QByteArray(
               R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0"/><finalxform spherical="1" coefs="1 0 0 1 0 0"/>)")
        << "final";
    QTest::newRow("flat final")
        << QByteArray(
               R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0"/><finalxform linear="1" coefs="1 0 0 0 0 0"/>)")
        << "final";
    QTest::newRow("coefs") << QByteArray(R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0x"/>)") << "coefs";
    QTest::newRow("opacity") << QByteArray(
                                    R"(<xform weight="1" linear="1" opacity="0" coefs="1 0 0 1 0 0"/>)")
                             << "opacity";
    QTest::newRow("plotmode") << QByteArray(
                                     R"(<xform weight="1" linear="1" plotmode="off" coefs="1 0 0 1 0 0"/>)")
                              << "opacity";
    QTest::newRow("random symmetry") << QByteArray(R"(<symmetry kind="0"/>)") << "symmetry";
    QTest::newRow("25 mirrors") << QByteArray(R"(<symmetry kind="-25"/>)") << "symmetry";
    QTest::newRow("space")
        << QByteArray(R"(<xform weight="1" linear="1" yzPost="1 0 0 1 0 2" coefs="1 0 0 1 0 0"/>)")
        << "yzPost";
    QTest::newRow("space numbers")
        << QByteArray(R"(<xform weight="1" linear="1" zxCoefs="1 0 0 1 0" coefs="1 0 0 1 0 0"/>)")
        << "zxCoefs";
}

void FlameTest::refusesWhatIsNotAffine() {
    QFETCH(QByteArray, xform);
    QFETCH(QString, because);
    const document::FractalFile file = io::readFlame(flame(xform));
    QVERIFY(file.entries.isEmpty());
    QCOMPARE(file.problems.size(), 1);
    QVERIFY2(file.problems.first().message.contains(because), qPrintable(file.problems.first().message));
    QCOMPARE(file.problems.first().line, 3);
}

void FlameTest::kindsOfSymmetry_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("elements");
    QTest::newRow("none") << 1 << 1;
    QTest::newRow("mirror") << -1 << 2;
    QTest::newRow("rotation") << 6 << 6;
    QTest::newRow("dihedral") << -5 << 10;
    QTest::newRow("even dihedral") << -4 << 8;
}

// As flam3 reads them: n − 1 rotations and, of a negative kind, the mirror image x → −x generate the group.
void FlameTest::kindsOfSymmetry() {
    QFETCH(int, kind);
    QFETCH(int, elements);
    const QByteArray bytes = flame("<symmetry kind=\"" + QByteArray::number(kind) +
                                   R"("/><xform weight="1" linear="1" coefs=".5 0 0 .5 1 0"/>)");
    const System2 system = onlySystem(io::readFlame(bytes));
    QCOMPARE(system.maps.size(), std::size_t(1));
    const auto group = ifs::elements(system.symmetry);
    QCOMPARE(int(group.size()), elements);
    const ifs::AffineMap<2> mirror = ifs::affineMap(-1, 0, 0, 1, 0, 0);
    QCOMPARE(std::ranges::any_of(
                 group, [&](const auto& element) { return (element.linear - mirror.linear).norm() < 1e-12; }),
             kind < 0);
}

void FlameTest::transformsOfSymmetry() {
    const QByteArray map = R"(<xform weight=".5" color="0.25" linear="1" coefs=".5 0 0 .5 1 0"/>)";
    const QByteArray third =
        R"(<xform weight="1" color="1" color_speed="0" animate="0" linear="1" coefs="-0.5 0.866025 -0.866025 -0.5 0 0"/>)";
    const QByteArray mirror = R"(<xform weight="1" symmetry="1" linear="1" coefs="-1 0 0 1 0 0"/>)";
    const System2 rotated = onlySystem(io::readFlame(flame(map + third)));
    QCOMPARE(rotated.maps.size(), std::size_t(1));
    QVERIFY(rotated.symmetry.group == ifs::SymmetryGroup::Rotation);
    QCOMPARE(rotated.symmetry.order, 3);
    const System2 dihedral = onlySystem(io::readFlame(flame(mirror + map + third)));
    QCOMPARE(dihedral.maps.size(), std::size_t(1));
    QCOMPARE(dihedral.maps[0].weight.value(), 0.5);
    QVERIFY(dihedral.symmetry.group == ifs::SymmetryGroup::Dihedral);
    // Both forms at once, as newer programs write them.
    const System2 twice = onlySystem(io::readFlame(flame("<symmetry kind=\"3\"/>" + map + third)));
    QCOMPARE(twice.maps.size(), std::size_t(1));
    QCOMPARE(twice.symmetry.order, 3);
    // What makes no finite group, or moves in animations, is a map.
    const QByteArray odd =
        R"(<xform weight="1" animate="0" linear="1" coefs="0.9689124 0.247404 -0.247404 0.9689124 0 0"/>)";
    QCOMPARE(onlySystem(io::readFlame(flame(map + odd))).maps.size(), std::size_t(2));
    const QByteArray moving = R"(<xform weight="1" linear="1" coefs="-1 0 0 -1 0 0"/>)";
    const System2 plain = onlySystem(io::readFlame(flame(map + moving)));
    QCOMPARE(plain.maps.size(), std::size_t(2));
    QVERIFY(plain.symmetry.group == ifs::SymmetryGroup::None);
}

void FlameTest::symmetriesComeBack_data() {
    using enum ifs::SymmetryGroup;
    QTest::addColumn<ifs::Symmetry<2>>("symmetry");
    QTest::addColumn<bool>("hasKind");
    QTest::newRow("rotation") << ifs::Symmetry<2>{Rotation, 7} << true;
    QTest::newRow("mirror along y") << ifs::Symmetry<2>{Mirror, 1, 90} << true;
    QTest::newRow("dihedral") << ifs::Symmetry<2>{Dihedral, 6} << true;
    QTest::newRow("mirror") << ifs::Symmetry<2>{Mirror, 1, 30} << false;
    QTest::newRow("elsewhere") << ifs::Symmetry<2>{Rotation, 6, 0, {1, 0.5}} << false;
    QTest::newRow("turned") << ifs::Symmetry<2>{Dihedral, 5, 10, {1, 0.5}} << false;
}

void FlameTest::symmetriesComeBack() {
    QFETCH(ifs::Symmetry<2>, symmetry);
    QFETCH(bool, hasKind);
    auto fractal = std::make_shared<document::Fractal>();
    fractal->name = QStringLiteral("star");
    document::System2 system;
    ifs::append(system, ifs::affineMap(.5, .1, -.1, .5, 1, .25), 1.0);
    system.symmetry = symmetry;
    fractal->shape = document::Shape<2>{system};
    const QByteArray bytes = io::writeFlame({fractal});
    QCOMPARE(bytes.contains("<symmetry kind="), hasKind);
    const System2 back = onlySystem(io::readFlame(bytes));
    QCOMPARE(back.maps.size(), std::size_t(1));
    QVERIFY(back.maps[0].map == system.maps[0].map);
    const auto group = ifs::elements(symmetry), found = ifs::elements(back.symmetry);
    QCOMPARE(found.size(), group.size());
    for (const auto& element : group)
        QVERIFY(std::ranges::any_of(found, [&](const auto& each) {
            return (each.linear - element.linear).norm() + (each.translation - element.translation).norm() <
                   1e-12;
        }));
    // A frame that keeps no angles is listed.
    document::system2(*fractal)->symmetry.frame << 1, 1, 0, 1;
    const System2 listed = onlySystem(io::readFlame(io::writeFlame({fractal})));
    QCOMPARE(listed.maps.size(), group.size());
    QVERIFY(listed.symmetry.group == ifs::SymmetryGroup::None);
}

// XY first, then YZ, then ZX; two-by-twos column by column. docs/formats.md, "Flame XML".
void FlameTest::flamesInSpace() {
    const QByteArray xform = R"(<xform weight="2" linear3D="0.5" coefs="1 2 3 4 5 6" )"
                             R"(yzCoefs="2 1 1 3 7 8" zxCoefs="1 1 2 5 9 10"/>)"
                             R"(<xform weight="1" linear3D="1" coefs="0.5 0 0 0.5 0 0"/>)";
    const document::FractalFile file = io::readFlame(flame(xform), io::FlameAxis::AsWritten);
    QCOMPARE(file.entries.size(), 1);
    const document::System3* system = document::system3(*file.entries.first().fractal);
    QVERIFY(system && system->maps.size() == 2);
    QCOMPARE(*system->maps[0].weight, 2.0);
    // By hand: x → (x + 3y, 2x + 4y, z) → y' = 2y + z, z' = y + 3z → x' = x + 2z, z' = x + 5z.
    const auto image = [](double x, double y, double z) {
        const double x1 = x + 3 * y, y1 = 2 * x + 4 * y, z1 = z;
        const double y2 = 2 * y1 + z1, z2 = y1 + 3 * z1;
        return ifs::Vector<3>(0.5 * (x1 + 2 * z2 + 5 + 9), 0.5 * (y2 + 6 + 7), 0.5 * (x1 + 5 * z2 + 8 + 10));
    };
    for (const auto& [x, y, z] :
         {std::array{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {2.0, -1.0, 3.0}})
        QVERIFY((system->maps[0].map(ifs::Vector<3>(x, y, z)) - image(x, y, z)).norm() < 1e-12);
    // The right way up: y as −y, before and after.
    const document::FractalFile turned = io::readFlame(flame(xform));
    const auto& map = document::system3(*turned.entries.first().fractal)->maps[0].map;
    const ifs::Vector<3> expected = image(2, 1, 3);
    QVERIFY(
        (map(ifs::Vector<3>(2, -1, 3)) - ifs::Vector<3>(expected.x(), -expected.y(), expected.z())).norm() <
        1e-12);
}

// `linear` leaves z out unless the flame keeps it.
void FlameTest::linearLeavesZOut() {
    const QByteArray xform = R"(<xform weight="1" linear="0.5" coefs="1 0 0 1 0 0" yzCoefs="1 0 0 1 0 3"/>)";
    const auto zOf = [](const QByteArray& bytes) {
        const document::FractalFile file = io::readFlame(bytes);
        return document::system3(*file.entries.first().fractal)->maps[0].map(ifs::Vector<3>(0, 0, 1)).z();
    };
    QCOMPARE(zOf(flame(xform)), 0.0);
    QByteArray kept = flame(xform);
    kept.replace("<flame ", "<flame preserve_z=\"1\" ");
    QCOMPARE(zOf(kept), 2.0);
}

void FlameTest::refusesADocumentType() {
    const document::FractalFile file =
        io::readFlame("<!DOCTYPE x [<!ENTITY e \"eeeeeeee\">]><flames><flame name=\"&e;\"/></flames>");
    QVERIFY(file.entries.isEmpty());
    QVERIFY(!file.problems.isEmpty());
}

void FlameTest::oneBadFlameDoesNotStopTheOthers() {
    const QByteArray good =
        R"(<flame name="g"><xform weight="1" linear="1" coefs="0.5 0 0 0.5 0 0"/></flame>)";
    const QByteArray bad = R"(<flame name="b"><xform weight="1" julia="1" coefs="0.5 0 0 0.5 0 0"/></flame>)";
    const document::FractalFile file = io::readFlame("<x>" + bad + good + bad + good + "</x>");
    QCOMPARE(file.entries.size(), 2);
    QCOMPARE(file.problems.size(), 2);
    QVERIFY(file.entries[0].fractal->name != file.entries[1].fractal->name);
}

void FlameTest::writesWhatFlamesExpect() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("half");
    System2 system;
    ifs::append(system, ifs::affineMap(0.5, 0.1, -0.2, 0.4, 3, 7), 1.0);
    fractal.shape = document::Shape<2>{system};
    const QByteArray bytes = io::writeFlame({std::make_shared<const document::Fractal>(fractal)});
    QVERIFY2(bytes.contains(R"(coefs="0.5 0.2 -0.1 0.4 3 -7")"), bytes.constData());
    QVERIFY(bytes.contains("linear=\"1\""));
    QVERIFY(bytes.contains("count=\"256\""));
    QVERIFY(io::looksLikeFlame(bytes));
    QVERIFY(io::looksLikeFlame("\xef\xbb\xbf" + bytes));
    QVERIFY(io::looksLikeFlame("<!-- " + QByteArray(5000, 'x') + " -->\n" + bytes));
    QVERIFY(!io::looksLikeFlame("<svg><!-- <flams> --></svg>"));
}

void FlameTest::flam3DrawsTheSame_data() {
    QTest::addColumn<int>("index");
    QTest::newRow("maple") << 0;
    QTest::newRow("fern") << 1;
    QTest::newRow("sierpinski") << 2;
    QTest::newRow("linked") << 3;
}

// The same way up, in the same place: what one draws, the other draws beside it at most.
void FlameTest::flam3DrawsTheSame() {
    if (!qEnvironmentVariableIsSet("BARYCAGE_OTHER_PROGRAMS"))
        QSKIP("./dev test --programs asks other programs");
    QFETCH(int, index);
    const QString program = QStandardPaths::findExecutable(QStringLiteral("flam3-render"));
    if (program.isEmpty()) QSKIP("flam3-render is not installed (package flam3-utils)");
    document::Fractal fractal;
    fractal.name = QStringLiteral("both");
    System2 system;
    for (const auto& map : index == 0   ? canonical::maple()
                           : index == 1 ? canonical::fern()
                                        : canonical::sierpinskiRight())
        ifs::append(system, map);
    if (index == 3) ifs::setLinks(system, std::vector<double>{1, 0, 1, 1, 1, 1, 1, 1, 1});
    fractal.shape = document::Shape<2>{system};
    fractal.appearance.colourBy = attractor::ColourBy::Plain;
    fractal.appearance.plain = {255, 255, 255, 255};
    fractal.appearance.background = {0, 0, 0, 255};
    fractal.appearance.brightness = 1000;
    QString text = QString::fromUtf8(io::writeFlame({std::make_shared<const document::Fractal>(fractal)}));
    const auto attribute = [&](const char* name) {
        const QRegularExpression value(QStringLiteral("%1=\"([^\"]*)\"").arg(QLatin1String(name)));
        return value.match(text).captured(1).split(u' ');
    };
    constexpr double part = 0.2; // of the size that the flame says
    attractor::Camera camera;
    camera.width = int(attribute("size")[0].toDouble() * part);
    camera.height = int(attribute("size")[1].toDouble() * part);
    camera.pixelsPerUnit = attribute("scale")[0].toDouble() * part;
    camera.centre = {attribute("center")[0].toDouble(), -attribute("center")[1].toDouble()};
    // Neither smoothed nor dim.
    text.replace(QStringLiteral("<flame "), QStringLiteral("<flame estimator_radius=\"0\" filter=\"0.3\" "
                                                           "quality=\"1000\" brightness=\"30\" "));

    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("in.flame")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text.toUtf8());
    file.close();
    const QImage theirs = drawnByFlam3(program, file.fileName(), part);
    QCOMPARE(theirs.size(), QSize(camera.width, camera.height));

    const auto drawn = [&] {
        io::PlaneExport png{fractal, document::renderRequest(fractal, camera), {}};
        png.request.samples = 20'000'000;
        return io::drawPicture(png).image;
    };
    const QImage ours = drawn();
    QCOMPARE(missing(theirs, ours), 0);
    QCOMPARE(missing(ours, theirs), 0);
    if (index == 3) { // in the other order, other pieces are missing
        ifs::setLinks(*document::system2(fractal), std::vector<double>{1, 1, 1, 0, 1, 1, 1, 1, 1});
        QVERIFY(missing(theirs, drawn()) > 20);
    }
    QVERIFY(missing(ours, theirs.mirrored()) > 100); // it could fail
}

void FlameTest::roundTripIsExact() {
    QRandomGenerator random(7);
    for (int i = 0; i < 200; ++i) {
        const document::Fractal fractal = randomFractal(random, i);
        const System2 back =
            onlySystem(io::readFlame(io::writeFlame({std::make_shared<const document::Fractal>(fractal)})));
        const System2& system = *document::system2(fractal);
        QCOMPARE(back.maps.size(), system.maps.size());
        for (std::size_t k = 0; k < system.maps.size(); ++k)
            QVERIFY(back.maps[k].map == system.maps[k].map);
    }
}

void FlameTest::weightsComeBackAsTheyWere() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("fern");
    System2 system;
    for (const double weight : {0.01, 0.85, 0.07, 0.0, 0.08})
        ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, weight, 0), weight);
    system.maps[4].enabled = false;
    fractal.shape = document::Shape<2>{system};
    const System2 back =
        onlySystem(io::readFlame(io::writeFlame({std::make_shared<const document::Fractal>(fractal)})));
    QCOMPARE(back.maps.size(), std::size_t(5));
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(back.maps[i].weight == system.maps[i].weight);
    QCOMPARE(back.maps[4].weight, std::optional(0.0)); // was off
    system.maps[1].weight.reset();
    fractal.shape = document::Shape<2>{system};
    const System2 ruled =
        onlySystem(io::readFlame(io::writeFlame({std::make_shared<const document::Fractal>(fractal)})));
    QVERIFY(ruled.maps[0].weight == ruled.maps[1].weight); // the determinant rule
}

void FlameTest::palettesBackgroundsAndColoursAreRead_data() {
    QTest::addColumn<QByteArray>("palette");
    QByteArray hex;
    QByteArray opaque;
    QByteArray colours;
    QByteArray old;
    for (int i = 0; i < 256; ++i) {
        const QByteArray rgb = QByteArray(1, char(i)).toHex() + QByteArray(1, char(255 - i)).toHex() + "80";
        hex += (i % 8 == 0 ? "\n   " : "") + rgb.toUpper();
        opaque += rgb + "ff";
        old += "00" + rgb;
        const QByteArray number = QByteArray::number(i);
        colours += "<color index=\"" + number + "\" rgb=\"" + number + ' ' + QByteArray::number(255 - i) +
                   " 128.2\"/>\n";
    }
    QTest::newRow("palette") << "<palette count=\"256\" format=\"RGB\">" + hex + "\n</palette>";
    QTest::newRow("palette with opacity")
        << "<palette count=\"256\" format=\"RGBA\">" + opaque + "</palette>";
    QTest::newRow("colours") << colours;
    QTest::newRow("data") << "<colors count=\"256\" data=\"" + old + "\"/>";
}

void FlameTest::palettesBackgroundsAndColoursAreRead() {
    QFETCH(QByteArray, palette);
    const document::FractalFile file =
        io::readFlame("<flame name=\"a\" background=\"0 0.2 1\">"
                      "<xform weight=\"1\" color=\"0\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/>"
                      "<xform weight=\"1\" color=\"0.4 0\" linear=\"1\" coefs=\".5 0 0 .5 1 0\"/>"
                      "<xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 1 0\"/>" +
                      palette + "</flame>");
    QCOMPARE(file.entries.size(), 1);
    QVERIFY(file.entries.first().problems.isEmpty());
    const attractor::Appearance& read = file.entries.first().fractal->appearance;
    QVERIFY((read.background == attractor::Rgba{0, 51, 255, 255}));
    QVERIFY(read.colourBy == attractor::ColourBy::Blend);
    const auto* first = read.mapColours.find(ifs::MapId{1});
    const auto* second = read.mapColours.find(ifs::MapId{2});
    QVERIFY(first != nullptr && second != nullptr && !read.mapColours.find(ifs::MapId{3}));
    QVERIFY((*first == attractor::Rgba{0, 255, 128, 255}));
    QVERIFY((*second == attractor::Rgba{102, 153, 128, 255}));
    for (int i = 0; i < 256; ++i) { // within a level
        const attractor::Rgba colour = attractor::colourAt(read.palette, i / 255.0);
        QVERIFY(std::abs(colour.red - i) <= 1 && std::abs(colour.green - (255 - i)) <= 1);
        QVERIFY(std::abs(colour.blue - 128) <= 1);
    }
}

void FlameTest::opacitiesAreNotKept() {
    const document::FractalFile file =
        io::readFlame(flame(R"(<xform weight="1" linear="1" opacity="1" coefs=".5 0 0 .5 0 0"/>)"
                            R"(<xform weight="1" linear="1" opacity="0.25" coefs=".5 0 0 .5 1 0"/>)"));
    const document::Problems problems = file.entries.first().problems;
    QCOMPARE(problems.size(), 1);
    QCOMPARE(problems.first().message,
             QStringLiteral("Transform 2 has opacity 0.25; its points are drawn in full."));
}

void FlameTest::coloursComeBack_data() {
    QTest::addColumn<int>("colourBy");
    QTest::addColumn<int>("maps");
    QTest::newRow("density") << int(attractor::ColourBy::Density) << 3;
    QTest::newRow("address") << int(attractor::ColourBy::Address) << 3;
    QTest::newRow("one map") << int(attractor::ColourBy::Map) << 1;
    QTest::newRow("three maps") << int(attractor::ColourBy::Map) << 3;
    QTest::newRow("many maps") << int(attractor::ColourBy::Map) << 200;
}

void FlameTest::coloursComeBack() {
    QFETCH(int, colourBy);
    QFETCH(int, maps);
    for (const attractor::Palette& palette : attractor::builtInPalettes()) {
        document::Fractal fractal;
        fractal.name = QStringLiteral("colours");
        System2 system;
        for (int i = 0; i < maps; ++i)
            ifs::append(system, ifs::affineMap(0.5, 0, 0, 0.5, i, 0), 1.0);
        fractal.appearance.palette = palette;
        fractal.appearance.colourBy = attractor::ColourBy(colourBy);
        fractal.appearance.background = {1, 77, 254, 255};
        if (colourBy == int(attractor::ColourBy::Map))
            fractal.appearance.mapColours[system.maps.front().id] = {1, 2, 3, 255};
        fractal.shape = document::Shape<2>{system};
        const auto file = io::readFlame(io::writeFlame({std::make_shared<const document::Fractal>(fractal)}));
        QCOMPARE(file.entries.size(), 1);
        const attractor::Appearance& back = file.entries.first().fractal->appearance;
        QVERIFY(back.colourBy == fractal.appearance.colourBy);
        QVERIFY(back.background == fractal.appearance.background);
        if (back.colourBy != attractor::ColourBy::Map) {
            QVERIFY(back.palette == palette);
            QVERIFY(back.mapColours.empty());
        }
        const System2& same = *document::system2(*file.entries.first().fractal);
        for (std::size_t i = 0; i < same.maps.size(); ++i)
            QVERIFY(attractor::mapColour(back, same.maps[i].id, i) ==
                    attractor::mapColour(fractal.appearance, system.maps[i].id, i));
    }
}

void FlameTest::contrastAndVibrancyAreReadAndWritten() {
    const QByteArray map = "<xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/>";
    const auto lookOf = [&](const QByteArray& attributes) {
        return io::readFlame("<flame name=\"a\" " + attributes + '>' + map + "</flame>")
            .entries.first()
            .fractal->appearance;
    };
    const attractor::Appearance read = lookOf("brightness=\"9\" contrast=\"2.5\" vibrancy=\"0.15\"");
    QCOMPARE(read.contrast, 2.5);
    QCOMPARE(read.vibrancy, 0.15);
    QCOMPARE(lookOf("vibrancy=\"7\"").vibrancy, 1.0); // in some programs, up to 30
    QCOMPARE(lookOf("vibrancy=\"-1\"").vibrancy, 0.0);
    for (const char* usual :
         {"", "contrast=\"0\" vibrancy=\"much\"", "contrast=\"-2\"", "contrast=\"inf\""}) {
        QCOMPARE(lookOf(usual).contrast, 1.0);
        QCOMPARE(lookOf(usual).vibrancy, 1.0);
    }

    QRandomGenerator random(3);
    document::Fractal fractal = randomFractal(random, 0);
    const auto written = [&] { return io::writeFlame({std::make_shared<const document::Fractal>(fractal)}); };
    QVERIFY(!written().contains("contrast=") && !written().contains("vibrancy=")); // bytes as they were
    fractal.appearance.contrast = 1.0 / 3;
    fractal.appearance.vibrancy = 0;
    QVERIFY(!io::lossOf(io::TextFormat::Flame, fractal));
    const attractor::Appearance back = io::readFlame(written()).entries.first().fractal->appearance;
    QCOMPARE(back.contrast, 1.0 / 3);
    QCOMPARE(back.vibrancy, 0.0);
}

void FlameTest::namesStayWhole() {
    const QString longName = QStringLiteral("Eq. Sierpiński triangle, rotated by 60 degrees (b33rheart)");
    const QByteArray one = "<flame name=\"" + longName.toUtf8() +
                           "\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 0 0\"/></flame>";
    const document::FractalFile file = io::readFlame("<flames>" + one + one + "</flames>");
    QCOMPARE(file.entries.size(), 2);
    QCOMPARE(file.entries[0].fractal->name, longName);
    QCOMPARE(file.entries[1].fractal->name, longName + QStringLiteral("_2"));
    QVERIFY(io::writeFlame({file.entries[0].fractal}).contains("name=\"" + longName.toUtf8() + '"'));
}

void FlameTest::survivesDamage() {
    QRandomGenerator random(11);
    const QByteArray whole =
        io::writeFlame({std::make_shared<const document::Fractal>(randomFractal(random, 0)),
                        std::make_shared<const document::Fractal>(randomFractal(random, 1))});
    for (int i = 0; i < 500; ++i) {
        QByteArray damaged = whole;
        for (int k = 0; k < 8; ++k)
            damaged[random.bounded(int(damaged.size()))] = char(random.bounded(256));
        const document::FractalFile file = io::readFlame(damaged.left(random.bounded(int(damaged.size()))));
        QVERIFY(!file.entries.isEmpty() || !file.problems.isEmpty());
    }
}

BARYCAGE_TEST(FlameTest);
#include "flame_test.moc"
