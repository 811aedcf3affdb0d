// SPDX-License-Identifier: MIT
#include "io/sums/space_sums.h"

#include "document/edits/cage/cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "io/fractint/fractint_reader.h"
#include "io/sums/picture_request.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace io;
using attractor::ColourBy;
using attractor::LookInSpace;
using attractor::PicturePart;

// Pictures in space that several machines draw: parts of a cloud, bands of a cloud or a solid.
class SpaceSumsTest : public QObject {
    Q_OBJECT

private slots:
    void theRequestSaysAll();
    void partsOfACloudAddUp_data();
    void partsOfACloudAddUp();
    void bandsAndPartsOfACloudAddUp();
    void bandsOfASolidAddUp_data();
    void bandsOfASolidAddUp();
    void nothingIsCountedTwice();
    void anotherPictureIsRefused();
    void anIncompletePictureIsRefused();
    void aHugePictureIsRefused();
    void resumingAddsAPass();

private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    QByteArray bytes(const QString& name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString part(const SpaceExport& picture, std::pair<int, int> rows, const PicturePart& units);
    QString part(const SpaceExport& picture, std::uint64_t index, std::uint64_t count) {
        return part(picture, {0, picture.request.camera.size.height}, {index, count});
    }
    Failure merge(const QStringList& parts, const QString& output);

    QTemporaryDir m_folder;
    int m_parts = 0;
};

namespace {

constexpr attractor::RasterSize size{301, 211};

QByteArray whole(const SpaceExport& picture) {
    QByteArray png;
    const ExportOutcome outcome = drawSpaceFile(picture, png);
    return outcome.failure || outcome.stopped ? QByteArray() : png;
}

// A sponge, sliced, in a cage that is moved, in perspective: all that a request may have to say.
document::Fractal sponge(LookInSpace look) {
    document::Fractal found;
    const QString path = support::sourcePath(QStringLiteral("ifs_library/space_sponges.ifs"));
    for (const document::Entry& entry : readFractint(loadFile(path).bytes).entries)
        if (entry.fractal->name == u"menger") found = *entry.fractal;
    found.inSpace.look = look;
    found.inSpace.clip = attractor::SpaceClip{};
    found.inSpace.clip->normal = {1, 0.3, 0};
    found.inSpace.clip->highest = 1.1;
    ifs::ControlCage<3> cage = *document::spaceCage(found);
    cage.current[1] += ifs::Vector<3>(0.1, 0.2, 1.0 / 3);
    return document::withCageMoved(found, cage, document::CageMode::Place);
}

SpaceExport pictureOf(document::Fractal fractal) {
    attractor::OrbitCamera camera;
    camera.size = size;
    camera.orientation = attractor::orbit(33, 21, 4);
    camera.projection = attractor::OrbitCamera::Projection::Perspective;
    camera = document::fittedToPicture(fractal, camera, 0.05);
    SpaceExport picture;
    picture.look = fractal.inSpace.look;
    picture.solid = document::solidAppearance(fractal);
    picture.request = document::spaceRequest(fractal, camera);
    picture.request.samples = 40'000'000; // three sample sets
    picture.request.seed = 7;
    picture.request.threads = 2;
    picture.fractal = std::move(fractal);
    return picture;
}

SpaceExport cloud(ColourBy colourBy = ColourBy::Density, int supersample = 1,
                  LookInSpace look = LookInSpace::Cloud) {
    document::Fractal fractal = sponge(look);
    fractal.appearance.colourBy = colourBy;
    fractal.appearance.supersample = supersample;
    return pictureOf(std::move(fractal));
}

} // namespace

QString SpaceSumsTest::part(const SpaceExport& picture, std::pair<int, int> rows, const PicturePart& units) {
    const QString name = path(QStringLiteral("p%1.sum").arg(++m_parts));
    const ExportOutcome outcome = exportSums(partOf(picture, rows.first, rows.second, units), name);
    return outcome.failure || outcome.stopped ? QString() : name;
}

Failure SpaceSumsTest::merge(const QStringList& parts, const QString& output) {
    const auto files = std::make_shared<SumFiles>(parts);
    if (files->failure()) return files->failure();
    if (!areOfSpace(*files)) return QStringLiteral("not of space");
    const LoadedSpaceSums loaded = spaceSumsIn(files, 2);
    if (loaded.failure) return loaded.failure;
    const bool isSum = output.endsWith(QLatin1String(".sum"));
    return (isSum ? exportSums(loaded.sums, path(output)) : exportPicture(loaded.sums, path(output))).failure;
}

void SpaceSumsTest::theRequestSaysAll() {
    SpaceExport what = pictureOf(sponge(LookInSpace::Ink));
    what.depth = PictureFormat::Depth::Bits16;
    what.dotsPerInch = 300;
    what.supersample = 3;
    what.solid.background = {13, 16, 23, 100};
    const QByteArray text = pictureRequest(what);
    QVERIFY(isOfSpace(text));
    const auto again = spacePictureOf(text);
    QVERIFY(again);
    QCOMPARE(pictureRequest(*again), text);
    QVERIFY(again->request.camera == what.request.camera);
    QCOMPARE(again->look, LookInSpace::Ink);
    QCOMPARE(again->supersample, 3);
    QVERIFY(again->solid.background == what.solid.background);
    QVERIFY(again->request.clip && again->request.cage);
    QCOMPARE(again->request.seed, what.request.seed);
    what.request.samples *= 2;
    what.request.threads = 1;
    QCOMPARE(pictureRequest(what), text);
    what.request.camera.fieldOfView += 1;
    QVERIFY(pictureRequest(what) != text);
    QVERIFY(!spacePictureOf(pictureRequest(what, attractor::pixelVersion + 1)));
    QVERIFY(!pictureOf(text));
    QVERIFY(!spacePictureOf("entry\n"));
}

void SpaceSumsTest::partsOfACloudAddUp_data() {
    QTest::addColumn<SpaceExport>("what");
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 3, 7})
        QTest::addRow("density, %d", count) << cloud() << count;
    QTest::newRow("maps, 3") << cloud(ColourBy::Map) << 3;
    QTest::newRow("x-ray, 2") << cloud(ColourBy::Density, 1, LookInSpace::XRay) << 2;
    QTest::newRow("cells of a half") << cloud(ColourBy::Density, 2) << 2;
    QTest::newRow("more parts than units") << cloud() << 200;
}

void SpaceSumsTest::partsOfACloudAddUp() {
    QFETCH(const SpaceExport, what);
    QFETCH(const int, count);
    const QByteArray expected = whole(what);
    QVERIFY(!expected.isEmpty());
    QStringList parts;
    for (int i = 0; i < count; ++i) {
        parts.prepend(part(what, std::uint64_t(i), std::uint64_t(count)));
        QVERIFY(!parts.first().isEmpty());
    }
    QCOMPARE(merge(parts, QStringLiteral("merged.png")), Failure());
    QVERIFY(bytes(QStringLiteral("merged.png")) == expected);
}

void SpaceSumsTest::bandsAndPartsOfACloudAddUp() {
    const SpaceExport what = cloud(ColourBy::Map, 2);
    QStringList parts;
    for (const auto& rows : {std::pair(0, 70), std::pair(70, 150), std::pair(150, 211)})
        for (std::uint64_t i = 0; i < 2; ++i)
            parts << part(what, rows, {i, 2});
    // Nested, in another order.
    QCOMPARE(merge({parts[5], parts[0], parts[3]}, QStringLiteral("odd.sum")), Failure());
    QCOMPARE(merge({parts[4], parts[2], parts[1]}, QStringLiteral("even.sum")), Failure());
    QCOMPARE(merge({path(QStringLiteral("odd.sum")), path(QStringLiteral("even.sum"))},
                   QStringLiteral("merged.png")),
             Failure());
    QVERIFY(bytes(QStringLiteral("merged.png")) == whole(what));
}

void SpaceSumsTest::bandsOfASolidAddUp_data() {
    QTest::addColumn<SpaceExport>("what");
    const auto add = [](const char* name, LookInSpace look, auto change) {
        SpaceExport what = pictureOf(sponge(look));
        change(what);
        QTest::newRow(name) << what;
    };
    add("stone", LookInSpace::Stone, [](SpaceExport&) {});
    add("stone of 16 bits", LookInSpace::Stone,
        [](SpaceExport& what) { what.depth = PictureFormat::Depth::Bits16; });
    add("transparent ink", LookInSpace::Ink, [](SpaceExport& what) {
        what.solid.background = {255, 255, 255, 0};
    });
    add("rough normals", LookInSpace::Normals, [](SpaceExport& what) { what.supersample = 1; });
    add("depths", LookInSpace::Depth, [](SpaceExport&) {});
}

void SpaceSumsTest::bandsOfASolidAddUp() {
    QFETCH(const SpaceExport, what);
    const QByteArray expected = whole(what);
    QVERIFY(!expected.isEmpty());
    QStringList bands;
    for (const auto& rows : {std::pair(150, 211), std::pair(0, 70), std::pair(70, 150)})
        bands << part(what, rows, {});
    QCOMPARE(merge(bands, QStringLiteral("merged.png")), Failure());
    QVERIFY(bytes(QStringLiteral("merged.png")) == expected);
    const Failure twice = merge(bands + bands.first(1), QStringLiteral("twice.png"));
    QVERIFY(twice && twice->contains(QLatin1String("counted twice")));
    const Failure few = merge(bands.first(2), QStringLiteral("few.png"));
    QVERIFY(few && few->contains(QLatin1String("62")));
}

void SpaceSumsTest::nothingIsCountedTwice() {
    const SpaceExport what = cloud();
    const QString first = part(what, 0, 2);
    QVERIFY(merge({first, first}, QStringLiteral("twice.sum"))->contains(QLatin1String("counted twice")));
    QVERIFY(merge({first, part(what, 2, 4)}, QStringLiteral("twice.sum")));
    QVERIFY(!merge({first, part(what, 1, 4)}, QStringLiteral("once.sum")));
    const QString empty = part(what, 250, 300);
    QVERIFY(merge({empty, empty}, QStringLiteral("twice.sum")));
    QVERIFY(!QFile::exists(path(QStringLiteral("twice.sum"))));
}

void SpaceSumsTest::anotherPictureIsRefused() {
    const SpaceExport what = cloud();
    SpaceExport other = what;
    other.request.camera.orientation = attractor::orbit(34, 21, 4);
    QVERIFY(merge({part(what, 0, 2), part(other, 1, 2)}, QStringLiteral("x.sum")));
    other = what;
    other.request.samples /= 2;
    QVERIFY(merge({part(what, 0, 2), part(other, 1, 2)}, QStringLiteral("x.sum")));
}

void SpaceSumsTest::anIncompletePictureIsRefused() {
    const Failure failure = merge({part(cloud(), 0, 2)}, QStringLiteral("half.png"));
    QVERIFY(failure && failure->contains(QLatin1String("50 %")));
    QVERIFY(!QFile::exists(path(QStringLiteral("half.png"))));
}

// A damaged or hostile file may ask for any size: it is refused before there is memory for it.
void SpaceSumsTest::aHugePictureIsRefused() {
    SumHeader header;
    SpaceExport what = cloud();
    what.request.camera.size = {900'000, 900'000};
    header.request = pictureRequest(what);
    header.columns = header.rows = 900'000;
    header.passes = {1};
    QFile file(path(QStringLiteral("huge.sum")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    SumWriter(file, header).finish();
    file.close();
    const Failure failure = merge({file.fileName()}, QStringLiteral("huge.png"));
    QVERIFY(failure && failure->contains(QLatin1String("4 GB")));
}

void SpaceSumsTest::resumingAddsAPass() {
    const SpaceExport what = cloud();
    const QString all = part(what, 0, 1);
    LoadedSpaceSums resumed = spaceSumsIn(std::make_shared<SumFiles>(QStringList{all}), 2);
    addPass(resumed.sums, 20'000'000);
    QVERIFY(!exportPicture(resumed.sums, path(QStringLiteral("at once.png"))).failure);
    QVERIFY(!exportSums(resumed.sums, path(QStringLiteral("more.sum"))).failure);
    QCOMPARE(merge({path(QStringLiteral("more.sum"))}, QStringLiteral("later.png")), Failure());
    QVERIFY(!bytes(QStringLiteral("later.png")).isEmpty());
    QVERIFY(bytes(QStringLiteral("at once.png")) == bytes(QStringLiteral("later.png")));
    QVERIFY(bytes(QStringLiteral("at once.png")) != whole(what));
}

BARYCAGE_TEST(SpaceSumsTest, QCoreApplication);
#include "space_sums_test.moc"
