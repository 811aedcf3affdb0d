// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "io/animation/request_text.h"
#include "io/fractint/fractint_reader.h"
#include "io/sums/picture_request.h"
#include "io/sums/picture_sums.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace io;
using attractor::ColourBy;
using attractor::PicturePart;

class PictureSumsTest : public QObject {
    Q_OBJECT

private slots:
    void theRequestSaysAll();
    void otherPixelsAreAnotherRequest();
    void partsAddUpToThePicture_data();
    void partsAddUpToThePicture();
    void bandsAddUpToo();
    void mergingIsAssociative();
    void nothingIsCountedTwice();
    void anotherPictureIsRefused();
    void anIncompletePictureIsRefused();
    void resumingAddsAPass();
    void aDamagedPartIsNamed();

private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    QByteArray bytes(const QString& name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString part(const PlaneExport& picture, int index, int count,
                 const QString& prefix = QStringLiteral("p")) {
        const QString name = QStringLiteral("%1%2of%3.sum").arg(prefix).arg(index).arg(count);
        const PicturePart units{std::uint64_t(index), std::uint64_t(count)};
        const auto outcome = exportSums(partOf(picture, 0, picture.request.camera.height, units), path(name));
        return outcome.failure || outcome.stopped ? QString() : path(name);
    }
    Failure merge(const QStringList& parts, const QString& output) {
        const auto files = std::make_shared<SumFiles>(parts);
        if (files->failure()) return files->failure();
        const LoadedSums loaded = sumsIn(files, 2);
        if (loaded.failure) return loaded.failure;
        const bool isSum = output.endsWith(QLatin1String(".sum"));
        return (isSum ? exportSums(loaded.sums, path(output)) : exportPicture(loaded.sums, path(output)))
            .failure;
    }
    QTemporaryDir m_folder;
};

namespace {

document::Fractal maple() {
    document::Fractal found;
    const QByteArray text = loadFile(support::sourcePath(QStringLiteral("ifs_library/paper.ifs"))).bytes;
    for (const document::Entry& entry : readFractint(text).entries)
        if (entry.fractal->name == u"maple") found = *entry.fractal;
    return found;
}

PlaneExport picture(ColourBy colourBy = ColourBy::Density, int supersample = 1) {
    attractor::Camera camera;
    camera.width = 301;
    camera.height = 211;
    PlaneExport result;
    result.fractal = maple();
    result.fractal.appearance.colourBy = colourBy;
    result.fractal.appearance.supersample = supersample;
    const auto box = document::displayedBox(result.fractal);
    result.request = document::renderRequest(result.fractal, fitted(camera, box->min, box->max));
    result.request.samples = 40'000'000; // three sample sets
    result.request.seed = 7;
    result.request.threads = 2;
    return result;
}

} // namespace

void PictureSumsTest::theRequestSaysAll() {
    PlaneExport what = picture(ColourBy::Map, 3);
    what.depth = PictureFormat::Depth::Bits16;
    what.dotsPerInch = 300;
    what.request.camera.yAxis = attractor::YAxis::Down;
    const QByteArray text = pictureRequest(what);
    const auto again = pictureOf(text);
    QVERIFY(again);
    QCOMPARE(pictureRequest(*again), text);
    QVERIFY(again->request.camera == what.request.camera);
    QVERIFY(again->request.appearance == what.request.appearance);
    QCOMPARE(again->request.seed, what.request.seed);
    what.request.samples *= 2;
    what.request.threads = 1;
    QCOMPARE(pictureRequest(what), text);
    what.request.seed = 8;
    QVERIFY(pictureRequest(what) != text);
    QVERIFY(!text.contains("rotation"));
    what.request.camera.rotation = attractor::rotationOf(-12.5);
    const auto turned = pictureOf(pictureRequest(what));
    QVERIFY(turned && turned->request.camera == what.request.camera);
    QVERIFY(!pictureOf("entry\n"));
    QVERIFY(!pictureOf(""));
}

// Frames and sums that a program with other pixels has written are not taken for ours.
void PictureSumsTest::otherPixelsAreAnotherRequest() {
    const PlaneExport what = picture();
    const auto hash = [&](const FrameRequestText& request) { return request.hash(what.fractal); };
    const QByteArray ours = hash(FrameRequestText());
    QCOMPARE(hash(FrameRequestText(attractor::pixelVersion)), ours);
    for (const int other : {attractor::pixelVersion - 1, attractor::pixelVersion + 1}) {
        QVERIFY(hash(FrameRequestText(other)) != ours);
        const QByteArray text = pictureRequest(what, other);
        QVERIFY(text != pictureRequest(what));
        QVERIFY(!pictureOf(text));
    }
    QVERIFY(pictureOf(pictureRequest(what)));
}

void PictureSumsTest::partsAddUpToThePicture_data() {
    QTest::addColumn<ColourBy>("colourBy");
    QTest::addColumn<int>("supersample");
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 3, 7})
        QTest::addRow("density, %d", count) << ColourBy::Density << 1 << count;
    QTest::newRow("maps, 3") << ColourBy::Map << 1 << 3;
    QTest::newRow("cells of a half") << ColourBy::Density << 2 << 2;
    QTest::newRow("more parts than units") << ColourBy::Density << 1 << 200;
}

void PictureSumsTest::partsAddUpToThePicture() {
    QFETCH(const ColourBy, colourBy);
    QFETCH(const int, supersample);
    QFETCH(const int, count);
    const PlaneExport what = picture(colourBy, supersample);
    QVERIFY(!exportPlane(what, path(QStringLiteral("whole.png"))).failure);
    QStringList parts;
    for (int i = 0; i < count; ++i) {
        parts.prepend(part(what, i, count));
        QVERIFY(!parts.first().isEmpty());
    }
    QCOMPARE(merge(parts, QStringLiteral("merged.png")), Failure());
    QVERIFY(!bytes(QStringLiteral("whole.png")).isEmpty());
    QVERIFY(bytes(QStringLiteral("merged.png")) == bytes(QStringLiteral("whole.png")));
}

void PictureSumsTest::bandsAddUpToo() {
    const PlaneExport what = picture();
    QVERIFY(!exportPlane(what, path(QStringLiteral("whole.png"))).failure);
    QStringList parts;
    for (const auto& [first, end] : {std::pair(0, 70), std::pair(70, 150), std::pair(150, 211)})
        for (std::uint64_t i = 0; i < 2; ++i) {
            parts << path(QStringLiteral("band%1-%2.sum").arg(first).arg(i));
            PictureSums sums = partOf(what, first, end, {i, 2});
            sums.picture.bandBytes = 20 * attractor::BandedRendering::bytesPerRow(what.request);
            QVERIFY(!exportSums(sums, parts.last()).failure);
        }
    QCOMPARE(merge(parts, QStringLiteral("merged.png")), Failure());
    QVERIFY(bytes(QStringLiteral("merged.png")) == bytes(QStringLiteral("whole.png")));
}

void PictureSumsTest::mergingIsAssociative() {
    const PlaneExport what = picture();
    QStringList parts;
    for (int i = 0; i < 4; ++i)
        parts << part(what, i, 4);
    QCOMPARE(merge({parts[2], parts[0]}, QStringLiteral("even.sum")), Failure());
    QCOMPARE(merge({parts[1], parts[3]}, QStringLiteral("odd.sum")), Failure());
    QCOMPARE(
        merge({path(QStringLiteral("odd.sum")), path(QStringLiteral("even.sum"))}, QStringLiteral("a.png")),
        Failure());
    QCOMPARE(merge(parts, QStringLiteral("b.png")), Failure());
    QVERIFY(bytes(QStringLiteral("a.png")) == bytes(QStringLiteral("b.png")));
}

void PictureSumsTest::nothingIsCountedTwice() {
    const PlaneExport what = picture();
    const QString first = part(what, 0, 2);
    QVERIFY(merge({first, first}, QStringLiteral("twice.sum"))->contains(QLatin1String("counted twice")));
    // Another division with units in common.
    QVERIFY(merge({first, part(what, 2, 4)}, QStringLiteral("twice.sum")));
    QVERIFY(!merge({first, part(what, 1, 4)}, QStringLiteral("once.sum")));
    // A part of no unit at all.
    const QString empty = part(what, 250, 300);
    QVERIFY(merge({empty, empty}, QStringLiteral("twice.sum")));
    QVERIFY(!QFile::exists(path(QStringLiteral("twice.sum"))));
}

void PictureSumsTest::anotherPictureIsRefused() {
    const PlaneExport what = picture();
    PlaneExport other = what;
    other.request.seed = 8;
    QVERIFY(merge({part(what, 0, 2), part(other, 1, 2, QStringLiteral("q"))}, QStringLiteral("x.sum")));
    other = what;
    other.request.samples /= 2;
    QVERIFY(merge({part(what, 0, 2), part(other, 1, 2, QStringLiteral("q"))}, QStringLiteral("x.sum")));
}

void PictureSumsTest::anIncompletePictureIsRefused() {
    const PlaneExport what = picture();
    const Failure failure = merge({part(what, 0, 2)}, QStringLiteral("half.png"));
    QVERIFY(failure && failure->contains(QLatin1String("50 %")));
    QVERIFY(!QFile::exists(path(QStringLiteral("half.png"))));
}

void PictureSumsTest::resumingAddsAPass() {
    const PlaneExport what = picture();
    const QString all = part(what, 0, 1);
    LoadedSums resumed = sumsIn(std::make_shared<SumFiles>(QStringList{all}), 2);
    addPass(resumed.sums, 20'000'000);
    QVERIFY(!exportPicture(resumed.sums, path(QStringLiteral("at once.png"))).failure);
    QVERIFY(!exportSums(resumed.sums, path(QStringLiteral("more.sum"))).failure);
    QCOMPARE(merge({path(QStringLiteral("more.sum"))}, QStringLiteral("later.png")), Failure());
    QVERIFY(bytes(QStringLiteral("at once.png")) == bytes(QStringLiteral("later.png")));
    QCOMPARE(merge({all}, QStringLiteral("before.png")), Failure());
    QVERIFY(bytes(QStringLiteral("at once.png")) != bytes(QStringLiteral("before.png")));
    // The new pass in parts of its own.
    QStringList parts{all};
    for (std::uint64_t i = 0; i < 3; ++i) {
        PictureSums sums = resumed.sums;
        sums.files.reset();
        sums.drawn.front().part = {i, 3};
        parts << path(QStringLiteral("new%1.sum").arg(i));
        QVERIFY(!exportSums(sums, parts.last()).failure);
    }
    QCOMPARE(merge(parts, QStringLiteral("parts.png")), Failure());
    QVERIFY(bytes(QStringLiteral("parts.png")) == bytes(QStringLiteral("later.png")));
}

void PictureSumsTest::aDamagedPartIsNamed() {
    const PlaneExport what = picture();
    const QString first = part(what, 0, 2);
    QFile file(part(what, 1, 2));
    QVERIFY(file.resize(file.size() - 1));
    const Failure failure = merge({first, file.fileName()}, QStringLiteral("x.png"));
    QVERIFY(failure && failure->contains(file.fileName()));
    QVERIFY(merge({path(QStringLiteral("absent.sum"))}, QStringLiteral("x.png")));
    QVERIFY(!QFile::exists(path(QStringLiteral("x.png"))));
}

BARYCAGE_TEST(PictureSumsTest, QCoreApplication);
#include "picture_sums_test.moc"
