// SPDX-License-Identifier: MIT
#include "document/saved_views.h"

#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_strict.h"
#include "io/fractint/fractint_writer.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using attractor::OrbitCamera;
using attractor::View;
using document::Fractal;
using document::SavedView;

namespace {

const QString detail = QStringLiteral("Detail of the leaf");

Fractal inSpace() {
    Fractal fractal = document::sierpinskiTriangle();
    document::Shape<3> shape;
    ifs::WeightedMap<3> map;
    map.map.linear = ifs::Matrix<3>::Identity() / 2;
    map.id = ifs::MapId{1};
    shape.system.maps = {map};
    fractal.shape = shape;
    return fractal;
}

Fractal throughAFile(const Fractal& fractal) {
    const document::FractalFile read = io::readFractint(io::writeFractint(document::fileOf(fractal)));
    if (read.entries.size() != 1 || !read.entries.first().problems.isEmpty()) return {};
    return *read.entries.first().fractal;
}

OrbitCamera orbitCamera() {
    OrbitCamera camera;
    camera.target = {.1, -1. / 3, 1e-9};
    camera.orientation = attractor::orbit(33.3, -12.7, 5);
    camera.height = 2. / 7;
    camera.fieldOfView = 35.5;
    camera.projection = OrbitCamera::Projection::Perspective;
    return camera;
}

} // namespace

// Views with names, in an entry and in files.
class SavedViewsTest : public QObject {
    Q_OBJECT

private slots:
    void aViewComesBackToTheBit_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("height");
        QTest::addColumn<bool>("down");
        QTest::newRow("usual") << .5 << -1.25 << 3.5 << false;
        QTest::newRow("down") << .5 << -1.25 << 3.5 << true;
        QTest::newRow("deep") << -0.74364388703715876 << 0.13182590420531197 << 1.2345678901234567e-13
                              << false;
        QTest::newRow("far") << -1.2345678901234567e29 << 1e30 << 9.87654321e29 << true;
    }

    void aViewComesBackToTheBit() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, height);
        QFETCH(bool, down);
        const View view{{x, y}, height, down ? attractor::YAxis::Down : attractor::YAxis::Up};
        Fractal fractal = document::sierpinskiTriangle();
        fractal.comments << QStringLiteral("a comment of the user");
        const Fractal kept = document::withSavedView(fractal, {detail, view});
        for (const QString& comment : kept.comments)
            QVERIFY2(comment.toUtf8().size() < 70, qPrintable(comment));
        QCOMPARE(kept.comments.first(), fractal.comments.first());
        const Fractal read = throughAFile(kept);
        QCOMPARE(document::savedViews(read).size(), std::size_t{1});
        QVERIFY(document::savedView(read, detail) == (SavedView{detail, view}));
        QVERIFY(document::withoutSavedView(kept, detail) == fractal);
    }

    // A view that is not turned is written as before there were rotations.
    void aRotationComesBackToTheBit() {
        for (const double degrees : {30.0, -0.000001, 180.0, -123.456789}) {
            const View view{{.5, -1.25}, 3.5, attractor::YAxis::Down, attractor::rotationOf(degrees)};
            const Fractal kept = document::withSavedView(document::sierpinskiTriangle(), {detail, view});
            QVERIFY(document::savedView(throughAFile(kept), detail) == (SavedView{detail, view}));
        }
        const View upright{{.5, -1.25}, 3.5};
        View turned = upright;
        turned.rotation = attractor::rotationOf(30);
        const auto lineOf = [](const View& view) {
            return document::withSavedView(document::sierpinskiTriangle(), {detail, view}).comments.last();
        };
        QCOMPARE(lineOf(upright), QStringLiteral("barycage: view-camera 0.5 -1.25 3.5 1"));
        QCOMPARE(lineOf(turned), QStringLiteral("barycage: view-camera 0.5 -1.25 3.5 1 30"));
    }

    void aCameraInSpaceComesBackToTheBit() {
        const Fractal kept = document::withSavedView(inSpace(), {detail, orbitCamera()});
        for (const QString& comment : kept.comments)
            QVERIFY2(comment.toUtf8().size() < 70, qPrintable(comment));
        QVERIFY(document::savedView(throughAFile(kept), detail) == (SavedView{detail, orbitCamera()}));
    }

    void namesOfOneDimensionHideThoseOfTheOther() {
        Fractal fractal = document::withSavedView(document::sierpinskiTriangle(), {detail, View{{1, 2}, 3}});
        const auto plane = fractal.shape;
        fractal.shape = inSpace().shape;
        QVERIFY(document::savedViews(fractal).empty());
        fractal = document::withSavedView(fractal, {detail, orbitCamera()});
        QVERIFY(document::savedView(fractal, detail) == (SavedView{detail, orbitCamera()}));
        fractal = document::withoutSavedView(fractal, detail);
        fractal.shape = plane;
        QVERIFY(document::savedView(fractal, detail) == (SavedView{detail, View{{1, 2}, 3}}));
        QVERIFY(document::withSavedView(fractal, {detail, orbitCamera()}) == fractal); // it is of the plane
    }

    void savingAgainReplacesInPlace() {
        Fractal fractal = document::sierpinskiTriangle();
        for (const char* name : {"a", "b", "c"})
            fractal = document::withSavedView(fractal, {QLatin1String(name), View{{0, 0}, 1}});
        fractal.comments << QStringLiteral("behind");
        const Fractal before = fractal;
        fractal = document::withSavedView(fractal, {QStringLiteral("b"), View{{1. / 3, 2. / 3}, 1e-7}});
        QStringList names;
        for (const SavedView& view : document::savedViews(fractal))
            names << view.name;
        QCOMPARE(names, (QStringList{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}));
        QCOMPARE(std::get<View>(document::savedView(fractal, QStringLiteral("b"))->camera).height, 1e-7);
        QCOMPARE(fractal.comments.last(), QStringLiteral("behind"));
        QVERIFY(document::withSavedView(before, {QStringLiteral("b"), View{{0, 0}, 1}}) == before);
    }

    void aViewIsRenamed() {
        Fractal fractal = document::sierpinskiTriangle();
        for (const char* name : {"a", "b"})
            fractal = document::withSavedView(fractal, {QLatin1String(name), View{{0, 0}, 1}});
        const Fractal renamed =
            document::withViewRenamed(fractal, QStringLiteral("a"), QStringLiteral("  the   root "));
        QVERIFY(document::savedView(renamed, QStringLiteral("the root")));
        QVERIFY(!document::savedView(renamed, QStringLiteral("a")));
        QVERIFY(document::withViewRenamed(fractal, QStringLiteral("a"), QStringLiteral("b")) == fractal);
        QVERIFY(document::withViewRenamed(fractal, QStringLiteral("a"), QStringLiteral(" ")) == fractal);
        QVERIFY(document::withViewRenamed(fractal, QStringLiteral("z"), QStringLiteral("y")) == fractal);
    }

    void namesFitOnALine_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("stored");
        QTest::newRow("plain") << "View 1"
                               << "View 1";
        QTest::newRow("blanks") << "  a \t b\n c "
                                << "a b c";
        QTest::newRow("marks") << "a; b } { % é"
                               << "a; b } { % é";
        QTest::newRow("none") << " \n "
                              << "";
        QTest::newRow("long") << QString(80, u'x') << QString(48, u'x');
        QTest::newRow("long in Cyrillic") << QString(80, u'ж') << QString(24, u'ж');
        QTest::newRow("long in pairs")
            << QStringLiteral("😀").repeated(20) << QStringLiteral("😀").repeated(12);
    }

    void namesFitOnALine() {
        QFETCH(QString, typed);
        QFETCH(QString, stored);
        QCOMPARE(document::storableViewName(typed), stored);
        if (stored.isEmpty()) return;
        const Fractal kept =
            document::withSavedView(document::sierpinskiTriangle(), {stored, View{{1, 2}, 3}});
        QVERIFY(document::savedView(throughAFile(kept), stored));
    }

    void nonsenseIsPassedOver() {
        Fractal fractal = document::sierpinskiTriangle();
        for (const char* line : {"barycage: view-camera 1 2 3 1",
                                 "barycage: view",
                                 "barycage: view nothing",
                                 "barycage: view few",
                                 "barycage: view-camera 1 2 3",
                                 "barycage: view many",
                                 "barycage: view-camera 1 2 3 1 5 6",
                                 "barycage: view letters",
                                 "barycage: view-camera 1 x 3 1",
                                 "barycage: view endless",
                                 "barycage: view-camera 1 inf 3 1",
                                 "barycage: view no number",
                                 "barycage: view-camera 1 nan 3 1",
                                 "barycage: view flat",
                                 "barycage: view-camera 1 2 0 1",
                                 "barycage: view upside",
                                 "barycage: view-camera 1 2 -3 1",
                                 "barycage: view axis",
                                 "barycage: view-camera 1 2 3 2",
                                 "barycage: view far",
                                 "barycage: view-camera 1e300 2 3 1",
                                 "barycage: view good",
                                 "barycage: view-camera 1 2",
                                 "barycage: view-camera 3 -1",
                                 "barycage: view good",
                                 "barycage: view-camera 9 9 9 1"})
            fractal.comments << QLatin1String(line);
        const auto views = document::savedViews(fractal);
        QCOMPARE(views.size(), std::size_t{1});
        QVERIFY(views.front() ==
                (SavedView{QStringLiteral("good"), View{{1, 2}, 3, attractor::YAxis::Down}}));
        QVERIFY(document::savedViews(document::withoutSavedView(fractal, QStringLiteral("good"))).empty());

        Fractal solid = inSpace();
        for (const char* line : {"barycage: view turned", "barycage: view-camera 0 0 0 2 0 0 0 1 40 0",
                                 "barycage: view wide", "barycage: view-camera 0 0 0 1 0 0 0 1 180 0",
                                 "barycage: view half", "barycage: view-camera 0 0 0 1 0 0 0 1 40 .5",
                                 "barycage: view none", "barycage: view-camera 0 0 0 0 0 0 0 1 40 1"})
            solid.comments << QLatin1String(line);
        QVERIFY(document::savedViews(solid).empty());
        solid.comments << QStringLiteral("barycage: view rounded")
                       << QStringLiteral("barycage: view-camera 0 0 0 .7071 0 .7071 0 1 40 1");
        const auto rounded = document::savedView(solid, QStringLiteral("rounded"));
        QVERIFY(rounded);
        QVERIFY(std::abs(std::get<OrbitCamera>(rounded->camera).orientation.norm() - 1) < 1e-15);
    }

    void aFloodOfLinesIsRead() {
        Fractal fractal = document::sierpinskiTriangle();
        for (int i = 0; i < 20'000; ++i)
            fractal.comments << QStringLiteral("barycage: view %1").arg(i)
                             << QStringLiteral("barycage: view-camera 1 2 3 1");
        QCOMPARE(document::savedViews(fractal).size(), document::maxSavedViews);
        const SavedView another{QStringLiteral("another"), View{{0, 0}, 1}};
        QVERIFY(document::withSavedView(fractal, another) == fractal);
    }

    void otherBytesOfTheEntryStay() {
        const QByteArray text =
            "first { ; title\r\n ; of the user\r\n .5 0 0 .50 0 0 .3\r\n  .5 0 0 .5 1 0 .7 ; "
            "right\r\n}\r\n\r\nsecond {\r\n .5 0 0 .5 0 0\r\n}\r\n";
        document::FractalFile file = io::readFractint(text);
        QCOMPARE(file.entries.size(), 2);
        const Fractal& first = *file.entries.first().fractal;
        file.entries.first().fractal = std::make_shared<const Fractal>(
            document::withSavedView(first, {QStringLiteral("right"), View{{1, 0}, .25}}));
        const QByteArray written = io::writeFractint(file);
        QByteArray rest = written;
        for (const char* line : {"barycage: view right", "barycage: view-camera 1 0 0.25 1"}) {
            const qsizetype at = rest.indexOf(line);
            QVERIFY2(at > 0, written);
            const qsizetype begin = rest.lastIndexOf('\n', at) + 1;
            rest.remove(begin, rest.indexOf('\n', at) + 1 - begin);
        }
        QCOMPARE(rest, text);
        file = io::readFractint(written);
        QVERIFY(document::savedView(*file.entries.first().fractal, QStringLiteral("right")));
        file.entries.first().fractal = std::make_shared<const Fractal>(
            document::withoutSavedView(*file.entries.first().fractal, QStringLiteral("right")));
        QCOMPARE(io::writeFractint(file), text);
    }

    void otherFormatsSayWhatIsLost() {
        const document::FractalFile file = document::fileOf(
            document::withSavedView(document::sierpinskiTriangle(), {detail, View{{1, 2}, 3}}));
        const auto strict = io::writeStrict(file);
        QVERIFY(!strict.bytes.contains("view"));
        QVERIFY(std::ranges::any_of(strict.problems, [](const document::Problem& problem) {
            return problem.message.contains(QLatin1String("its saved views"));
        }));
    }
};

BARYCAGE_TEST(SavedViewsTest, QCoreApplication);
#include "saved_views_test.moc"
