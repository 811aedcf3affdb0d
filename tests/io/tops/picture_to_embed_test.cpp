// SPDX-License-Identifier: MIT
#include "io/tops/picture_to_embed.h"

#include "document/tops/kept_theft.h"
#include "io/tops/picture_reader.h"
#include "support/named_test.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

// What is stored of a picture in an entry.
class PictureToEmbedTest : public QObject {
    Q_OBJECT

private slots:
    void smallFilesStayAsTheyAre();
    void largeOnesBecomeSmaller_data();
    void largeOnesBecomeSmaller();
    void saysWhyNot();

private:
    QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    QTemporaryDir m_folder;
};

void PictureToEmbedTest::smallFilesStayAsTheyAre() {
    QImage image(40, 30, QImage::Format_RGB32);
    image.fill(Qt::green);
    const QString small = path("small.bmp");
    QVERIFY(image.save(small));
    QFile file(small);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const io::PictureToEmbed found = io::pictureToEmbed(small);
    QVERIFY(!found.failure);
    QCOMPARE(found.bytes, file.readAll());
}

void PictureToEmbedTest::largeOnesBecomeSmaller_data() {
    QTest::addColumn<bool>("transparent");
    QTest::newRow("opaque") << false;
    QTest::newRow("transparent") << true;
}

// Noise, which nothing compresses, over a left half that is red in the mean and a right half that is blue.
void PictureToEmbedTest::largeOnesBecomeSmaller() {
    QFETCH(bool, transparent);
    QImage noise(1500, 1000, transparent ? QImage::Format_ARGB32 : QImage::Format_RGB32);
    std::mt19937 random(4);
    for (int y = 0; y < noise.height(); ++y)
        for (int x = 0; x < noise.width(); ++x) {
            const int bright = 155 + int(random() % 100), dark = int(random() % 100);
            noise.setPixel(x, y, x < 750 ? qRgba(bright, dark, dark, 255) : qRgba(dark, dark, bright, 255));
        }
    const QString large = path("noise.png");
    QVERIFY(noise.save(large));
    QVERIFY(QFile(large).size() > 10 * document::maxEmbeddedPicture);
    const io::PictureToEmbed found = io::pictureToEmbed(large);
    QVERIFY(!found.failure);
    QVERIFY(!found.bytes.isEmpty() && found.bytes.size() <= document::maxEmbeddedPicture);
    const io::ReadPicture read = io::decodePicture(found.bytes);
    QVERIFY(!read.failure);
    const int width = read.picture.width(), height = read.picture.height();
    QVERIFY(width >= 100 && std::abs(double(width) / height - 1.5) < .03);
    const auto left = read.picture.at(width * .25, height * .5, 64);
    const auto right = read.picture.at(width * .75, height * .5, 64);
    QVERIFY(left.red > 2 * left.blue && right.blue > 2 * right.red);
}

void PictureToEmbedTest::saysWhyNot() {
    const io::PictureToEmbed absent = io::pictureToEmbed(path("absent.png"));
    QVERIFY(absent.bytes.isEmpty());
    QVERIFY(absent.failure && absent.failure->contains(QStringLiteral("absent.png")));
    QFile damaged(path("damaged.png"));
    QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("no picture") > 0);
    damaged.close();
    const io::PictureToEmbed wrong = io::pictureToEmbed(damaged.fileName());
    QVERIFY(wrong.bytes.isEmpty() && wrong.failure);
}

BARYCAGE_TEST(PictureToEmbedTest, QCoreApplication);
#include "picture_to_embed_test.moc"
