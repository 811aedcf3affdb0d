// SPDX-License-Identifier: MIT
#include "document/tops/kept_theft.h"

#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "support/named_test.h"

#include <QTest>

using document::Fractal;
using document::KeptTheft;
using document::TheftMode;

// What an entry keeps of its fractal transformation, here and in files.
class KeptTheftTest : public QObject {
    Q_OBJECT

private slots:
    void comesBack_data() {
        QTest::addColumn<QString>("picture");
        QTest::newRow("none") << QString();
        QTest::newRow("beside the file") << QStringLiteral("photo.jpg");
        QTest::newRow("elsewhere") << QStringLiteral("../my pictures/a; b {c}.png");
        QTest::newRow("other letters") << QStringLiteral("Übung/цвет %20.png");
        QTest::newRow("long") << QString(500, u'x') + QStringLiteral("/y.png");
    }

    void comesBack() {
        QFETCH(QString, picture);
        KeptTheft theft;
        theft.partner = QStringLiteral("other");
        for (std::size_t k = 0; k < 25; ++k)
            theft.order.push_back(24 - k);
        theft.mode = TheftMode::Posterise;
        theft.pattern = attractor::Pattern::Rings;
        theft.picture = picture;
        theft.view = attractor::View{{.5, -1.25}, 3.5};
        Fractal fractal = document::sierpinskiTriangle();
        fractal.comments << QStringLiteral("a comment of the user");
        const Fractal kept = document::withTheft(fractal, theft);
        QCOMPARE(document::keptTheft(kept), std::optional(theft));
        QCOMPARE(kept.comments.first(), fractal.comments.first());
        for (const QString& comment : kept.comments)
            QVERIFY2(comment.toUtf8().size() < 70, qPrintable(comment));

        const document::FractalFile read = io::readFractint(io::writeFractint(document::fileOf(kept)));
        QCOMPARE(read.entries.size(), 1);
        QVERIFY(read.entries.first().problems.isEmpty());
        QCOMPARE(document::keptTheft(*read.entries.first().fractal), std::optional(theft));
        QVERIFY(document::withTheft(kept, std::nullopt) == fractal);
    }

    // A picture in the entry itself, of all bytes.
    void embeddedPicturesComeBack() {
        KeptTheft theft;
        theft.partner = QStringLiteral("other");
        theft.picture = QStringLiteral("photo.jpg");
        for (int k = 0; k < 5000; ++k)
            theft.embedded += char(k * 37 % 256);
        const Fractal kept = document::withTheft(document::sierpinskiTriangle(), theft);
        for (const QString& comment : kept.comments)
            QVERIFY2(comment.toUtf8().size() < 70, qPrintable(comment));
        const document::FractalFile read = io::readFractint(io::writeFractint(document::fileOf(kept)));
        QCOMPARE(read.entries.size(), 1);
        QVERIFY(read.entries.first().problems.isEmpty());
        QCOMPARE(document::keptTheft(*read.entries.first().fractal), std::optional(theft));
        Fractal longer = kept; // than anybody embeds
        for (int k = 0; k < 20'000; ++k)
            longer.comments << QStringLiteral("barycage: partner-data ") + QString(44, u'A');
        QVERIFY(document::keptTheft(longer)->embedded.size() <= 2 * document::maxEmbeddedPicture);
    }

    void nothingIsKeptWithoutAPartner() {
        const Fractal fractal = document::sierpinskiTriangle();
        KeptTheft theft;
        theft.mode = TheftMode::Posterise;
        QVERIFY(document::withTheft(fractal, theft) == fractal);
        Fractal strayed = fractal;
        strayed.comments << QStringLiteral("barycage: partner-order 1 2");
        QVERIFY(document::withTheft(strayed, theft) == fractal);
        QVERIFY(document::withTheft(strayed, std::nullopt) == fractal);
    }

    void nonsenseIsPassedOver() {
        Fractal fractal = document::sierpinskiTriangle();
        QVERIFY(!document::keptTheft(fractal));
        fractal.comments << QStringLiteral("barycage: partner-order 1 2");
        QVERIFY(!document::keptTheft(fractal));
        fractal.comments << QStringLiteral("barycage: partner other")
                         << QStringLiteral("barycage: partner-mode x")
                         << QStringLiteral("barycage: partner-order 2 -1 z 3")
                         << QStringLiteral("barycage: partner-view 1 nan 2")
                         << QStringLiteral("barycage: partner-pattern none")
                         << QStringLiteral("barycage: partner");
        const auto theft = document::keptTheft(fractal);
        QVERIFY(theft);
        QCOMPARE(theft->partner, QStringLiteral("other"));
        QCOMPARE(theft->mode, TheftMode::StealColours);
        QVERIFY(!theft->view);
    }
};

BARYCAGE_TEST(KeptTheftTest, QCoreApplication);
#include "kept_theft_test.moc"
