// SPDX-License-Identifier: MIT
#include "io/collection_reader.h"
#include "io/exchange/flame.h"
#include "support/named_test.h"

#include <QTest>

// Flames as other programs and people leave them.
class WildFlamesTest : public QObject {
    Q_OBJECT

private slots:
    void affineFinalTransformsMoveTheMaps();
    void whatIsLinearInThePlaneIsRead();
    void oneLayerIsAFlame();
    void damagedFlamesAreMended();
    void flamesOfPagesAreRead();
    void timesAreKeys();
};

// The picture is F(A), which is the attractor of F w F⁻¹.
void WildFlamesTest::affineFinalTransformsMoveTheMaps() {
    const auto mapOf = [](const QByteArray& final) {
        const auto file = io::readFlame("<flame><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .25 1 2\"/>" +
                                            final + "</flame>",
                                        io::FlameAxis::AsWritten);
        return file.entries.isEmpty() ? ifs::AffineMap<2>()
                                      : document::system2(*file.entries[0].fractal)->maps[0].map;
    };
    const ifs::AffineMap<2> w = ifs::affineMap(.5, 0, 0, .25, 1, 2);
    QVERIFY(mapOf("<finalxform linear=\"1\" coefs=\"1 0 0 1 0 0\"/>") == w);
    QVERIFY(mapOf("<symmetry kind=\"3\"/><finalxform linear=\"1\" coefs=\"2 0 0 1 0 0\"/>") ==
            ifs::AffineMap<2>()); // refused
    // F(x, y) = 2 (−y + 1, x): w in the coordinates of F
    const ifs::AffineMap<2> map = mapOf("<finalxform linear=\"2\" coefs=\"0 1 -1 0 1 0\" color=\"0\"/>");
    const ifs::AffineMap<2> f = ifs::affineMap(0, -2, 2, 0, 2, 0);
    for (const auto& x : {ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(3, -2)})
        QVERIFY((map(f(x)) - f(w(x))).norm() < 1e-14);
}

void WildFlamesTest::whatIsLinearInThePlaneIsRead() {
    const auto file = io::readFlame("<flame><xform weight=\"1\" pre_linear=\"0.5\" linear=\"2\" "
                                    "flatten=\"1\" coefs=\".5 0 0 .25 1 2\"/></flame>",
                                    io::FlameAxis::AsWritten);
    QVERIFY(file.problems.isEmpty());
    QVERIFY(document::system2(*file.entries.value(0).fractal)->maps[0].map ==
            ifs::affineMap(.5, 0, 0, .25, 1, 2));
}

void WildFlamesTest::oneLayerIsAFlame() {
    const QByteArray xform = "<xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .25 1 2\"/>";
    const QByteArray one =
        "<jwf-flame name=\"a\" smooth_gradient=\"0\">\n<layer name=\"\" weight=\"1.0\" density=\"1.0\">\n" +
        xform + "\n</layer>\n</jwf-flame>";
    QVERIFY(io::looksLikeFlame(one));
    const auto file = io::readFlame(one);
    QVERIFY(file.problems.isEmpty());
    QCOMPARE(file.entries.size(), 1);
    QCOMPARE(document::system2(*file.entries[0].fractal)->maps.size(), std::size_t(1));
    const auto two =
        io::readFlame("<jwf-flame><layer>" + xform + "</layer><layer>" + xform + "</layer></jwf-flame>");
    QVERIFY(two.entries.isEmpty() && two.problems.value(0).message.contains(QStringLiteral("layers")));
}

void WildFlamesTest::damagedFlamesAreMended() {
    const QByteArray xform = "<xform weight=\"1\"linear=\"1\" coefs=\".5 0 0 .25 1 2\" weight=\"7\"/>\n";
    const auto file = io::readFlame("<flames>\n<flame name=\"R&D\">\n" + xform +
                                    "</flame>\n<flame name=\"b\">\n<xform weight=\n"
                                    "</flame>\n<flame name=\"lost\">\n" +
                                    xform + "<flame name=\"c\">\n" + xform + "</flame>\n");
    QCOMPARE(file.entries.size(), 2);
    QCOMPARE(file.entries[0].fractal->name, QStringLiteral("R&D"));
    QCOMPARE(file.entries[1].fractal->name, QStringLiteral("c"));
    for (const document::Entry& entry : file.entries)
        QCOMPARE(*document::system2(*entry.fractal)->maps[0].weight, 1.0);
    QList<int> errors;
    QList<int> warnings;
    for (const document::Problem& problem : file.problems)
        (problem.severity == document::Problem::Severity::Error ? errors : warnings) << problem.line;
    QCOMPARE(errors.size(), 2); // of b and the one without an end
    QVERIFY(errors[0] >= 6 && errors[0] <= 7);
    QCOMPARE(warnings.first(), 2); // the ampersand
    QVERIFY(warnings.contains(3) && warnings.contains(11));
}

// With the quotation marks of a word processor, and as the listing of a page.
void WildFlamesTest::flamesOfPagesAreRead() {
    const QByteArray flame = "<flame name=\"a\"><xform weight=\"1\" linear=\"1\" "
                             "coefs=\".5 0 0 .25 1 2\"/></flame>\n";
    QByteArray quoted = flame;
    quoted.replace('"', "”");
    QByteArray listing = flame;
    listing.replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    for (const QByteArray& text :
         {quoted, "<html><body><p>My flame:</p><pre>" + listing + "</pre></body></html>"}) {
        const io::Collection collection = io::readCollection(text);
        QCOMPARE(collection.format, QStringLiteral("flame"));
        QCOMPARE(collection.file.entries.size(), 1);
        QVERIFY(document::system2(*collection.file.entries[0].fractal)->maps[0].map ==
                ifs::affineMap(.5, 0, 0, .25, 1, -2));
    }
}

// Control points of an animation.
void WildFlamesTest::timesAreKeys() {
    const auto flame = [](const char* time, const char* shift) {
        return QByteArray("<flame name=\"m\" time=\"") + time +
               "\"><xform weight=\"1\" linear=\"1\" coefs=\".5 0 0 .5 " + shift + " 0\"/></flame>";
    };
    const auto file =
        io::readFlame("<flames>" + flame("30", "3") + flame("10", "1") + flame("20", "2") + "</flames>");
    QCOMPARE(file.entries.size(), 1);
    const auto* plane = document::plane(*file.entries[0].fractal);
    QVERIFY(plane->animation);
    QCOMPARE(plane->animation->length, 20);
    QCOMPARE(plane->animation->maps.size(), std::size_t(1));
    const auto& keys = plane->animation->maps[0].keys;
    QCOMPARE(keys.size(), std::size_t(3));
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(keys[std::size_t(i)].frame, 10 * i);
        QCOMPARE(keys[std::size_t(i)].value.map.translation.x(), i + 1.0);
    }
    QCOMPARE(plane->system.maps[0].map.translation.x(), 1.0);
    QCOMPARE(file.entries[0].problems.size(), 1);
    QCOMPARE(io::readFlame("<flames>" + flame("0", "1") + flame("0", "2") + "</flames>").entries.size(), 2);
}

BARYCAGE_TEST(WildFlamesTest);
#include "wild_flames_test.moc"
