// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "io/flame.h"
#include "io/png_export.h"

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using document::System2;

class FlameTest : public QObject {
    Q_OBJECT

private slots:
    void readsColumnsAndFlipsY();
    void linearAmountAndPostAreApplied();
    void refusesWhatIsNotAffine_data();
    void refusesWhatIsNotAffine();
    void refusesADocumentType();
    void oneBadFlameDoesNotStopTheOthers();
    void writesWhatFlamesExpect();
    void roundTripIsExact();
    void flam3DrawsTheSame_data();
    void flam3DrawsTheSame();
    void weightsComeBackAsTheyWere();
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
    fractal.system = system;
    return fractal;
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
    QTest::newRow("chaos") << QByteArray(R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0" chaos="1 0"/>)")
                           << "chaos";
    QTest::newRow("final")
        << QByteArray(
               R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0"/><finalxform linear="1" coefs="1 0 0 1 0 0"/>)")
        << "final";
    QTest::newRow("coefs") << QByteArray(R"(<xform weight="1" linear="1" coefs="1 0 0 1 0 0x"/>)") << "coefs";
    QTest::newRow("opacity") << QByteArray(
                                    R"(<xform weight="1" linear="1" opacity="0" coefs="1 0 0 1 0 0"/>)")
                             << "opacity";
    QTest::newRow("plotmode") << QByteArray(
                                     R"(<xform weight="1" linear="1" plotmode="off" coefs="1 0 0 1 0 0"/>)")
                              << "opacity";
    QTest::newRow("space")
        << QByteArray(R"(<xform weight="1" linear="1" yzCoefs="1 0 0 1 0 0" coefs="1 0 0 1 0 0"/>)")
        << "yzCoefs";
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
    fractal.system = system;
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
    fractal.system = system;
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
    QProcess flam3;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("in"), file.fileName());
    environment.insert(QStringLiteral("out"), folder.filePath(QStringLiteral("out.png")));
    environment.insert(QStringLiteral("ss"), QString::number(part));
    environment.insert(QStringLiteral("isaac_seed"), QStringLiteral("7"));
    flam3.setProcessEnvironment(environment);
    flam3.start(program, QStringList());
    QVERIFY(flam3.waitForFinished(120'000));
    const QImage theirs(folder.filePath(QStringLiteral("out.png")));
    QCOMPARE(theirs.size(), QSize(camera.width, camera.height));

    io::PngExport png{fractal, document::renderRequest(fractal, camera), {}};
    png.request.samples = 20'000'000;
    const QImage ours = io::drawPicture(png).image;
    const auto missing = [](const QImage& a, const QImage& b) {
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
    };
    QCOMPARE(missing(theirs, ours), 0);
    QCOMPARE(missing(ours, theirs), 0);
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
    fractal.system = system;
    const System2 back =
        onlySystem(io::readFlame(io::writeFlame({std::make_shared<const document::Fractal>(fractal)})));
    QCOMPARE(back.maps.size(), std::size_t(5));
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(back.maps[i].weight == system.maps[i].weight);
    QCOMPARE(back.maps[4].weight, std::optional(0.0)); // was off
    system.maps[1].weight.reset();
    fractal.system = system;
    const System2 ruled =
        onlySystem(io::readFlame(io::writeFlame({std::make_shared<const document::Fractal>(fractal)})));
    QVERIFY(ruled.maps[0].weight == ruled.maps[1].weight); // the determinant rule
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

QTEST_APPLESS_MAIN(FlameTest)
#include "flame_test.moc"
