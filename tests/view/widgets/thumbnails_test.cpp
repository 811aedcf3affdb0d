// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "io/picture/thumbnail_cache.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "support/slow_disk.h"
#include "widgets/thumbnails.h"

#include <QElapsedTimer>
#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <set>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;
using view::Thumbnail;
using view::Thumbnails;

namespace {

using Pointer = Thumbnails::FractalPointer;

Pointer triangle() {
    return std::make_shared<const document::Fractal>(document::sierpinskiTriangle());
}

Pointer changed(const Pointer& fractal, double shift) {
    document::Fractal other = *fractal;
    document::system2(other)->maps[0].map.translation.x() += shift;
    return std::make_shared<const document::Fractal>(other);
}

int lightPixels(const QPixmap& pixmap) {
    const QImage image = pixmap.toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += qGray(image.pixel(x, y)) > 80 ? 1 : 0;
    return count;
}

} // namespace

class ThumbnailsTest : public QObject {
    Q_OBJECT

private slots:
    void drawsTheAttractor();
    void asksOncePerValue();
    void sameLookNeedsNoNewPicture();
    void aMovedBranchNeedsANewPicture();
    void earlierPictureStaysMeanwhile();
    void oneSizeAndRatio();
    void clearForgetsWhatIsUnderway();
    void newestFirst();
    void noAttractor();
    void aSolid();
    void otherKinds();
    void sidewaysPlacement();
    void aCachedPictureIsNotDrawnAgain();
    void aCacheThatDoesNotAnswerHoldsNothingUp();
};

void ThumbnailsTest::drawsTheAttractor() {
    Thumbnails thumbnails;
    thumbnails.setSize(64, 1);
    const Pointer fractal = triangle();
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    QCOMPARE(thumbnails.thumbnail(7, fractal).state, Thumbnail::State::Pending);
    QVERIFY(ready.wait());
    QCOMPARE(ready.front().front().toULongLong(), 7ULL);
    const Thumbnail thumbnail = thumbnails.thumbnail(7, fractal);
    QCOMPARE(thumbnail.state, Thumbnail::State::Ready);
    QCOMPARE(thumbnail.pixmap.size(), QSize(64, 64));
    const int light = lightPixels(thumbnail.pixmap);
    QVERIFY2(light > 300 && light < 2400, qPrintable(QString::number(light)));

    // Its middle third is the removed triangle; the picture is symmetric left to right.
    const QImage image = thumbnail.pixmap.toImage();
    int lower = 0;
    int upper = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            (y < 32 ? upper : lower) += qGray(image.pixel(x, y)) > 80 ? 1 : 0;
    QVERIFY2(lower > upper, "the triangle stands on its base");
    QCOMPARE(qAlpha(image.pixel(0, 0)), 0); // rounded corner
}

void ThumbnailsTest::asksOncePerValue() {
    Thumbnails thumbnails;
    const Pointer fractal = triangle();
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    for (int i = 0; i < 20; ++i)
        thumbnails.thumbnail(1, fractal);
    QVERIFY(ready.wait());
    for (int i = 0; i < 20; ++i)
        thumbnails.thumbnail(1, fractal);
    QTRY_COMPARE(thumbnails.pending(), 0);
    QCOMPARE(thumbnails.drawn(), std::uint64_t{1});
}

void ThumbnailsTest::sameLookNeedsNoNewPicture() {
    Thumbnails thumbnails;
    const Pointer fractal = triangle();
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.thumbnail(1, fractal);
    QVERIFY(ready.wait());
    document::Fractal renamed = *fractal;
    renamed.name = u"another"_s;
    renamed.comments = QStringList{u"said"_s};
    QCOMPARE(thumbnails.thumbnail(1, std::make_shared<const document::Fractal>(renamed)).state,
             Thumbnail::State::Ready);
    QCOMPARE(thumbnails.pending(), 0);
}

void ThumbnailsTest::aMovedBranchNeedsANewPicture() {
    Thumbnails thumbnails;
    const Pointer fractal = triangle();
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.thumbnail(1, fractal);
    QVERIFY(ready.wait());
    document::Fractal moved = *fractal;
    const ifs::MapId first = document::system2(moved)->maps.front().id;
    document::plane(moved)->moved = {{{first}, ifs::affineMap(1, 0, 0, 1, -1, 0)}};
    QCOMPARE(thumbnails.thumbnail(1, std::make_shared<const document::Fractal>(moved)).state,
             Thumbnail::State::Pending);
}

void ThumbnailsTest::earlierPictureStaysMeanwhile() {
    Thumbnails thumbnails;
    const Pointer fractal = triangle();
    const Pointer other = changed(fractal, 0.3);
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.thumbnail(1, fractal);
    QVERIFY(ready.wait());
    const QImage before = thumbnails.thumbnail(1, fractal).pixmap.toImage();
    const Thumbnail meanwhile = thumbnails.thumbnail(1, other);
    QCOMPARE(meanwhile.state, Thumbnail::State::Pending);
    QCOMPARE(meanwhile.pixmap.toImage(), before);
    QVERIFY(ready.wait());
    QCOMPARE(thumbnails.thumbnail(1, other).state, Thumbnail::State::Ready);
    QVERIFY(thumbnails.thumbnail(1, other).pixmap.toImage() != before);
}

void ThumbnailsTest::oneSizeAndRatio() {
    Thumbnails thumbnails;
    const Pointer fractal = triangle();
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.setSize(40, 1);
    thumbnails.thumbnail(1, fractal);
    QVERIFY(ready.wait());
    thumbnails.setSize(40, 1);
    QCOMPARE(thumbnails.thumbnail(1, fractal).state, Thumbnail::State::Ready);
    thumbnails.setSize(40, 1.5);
    QCOMPARE(thumbnails.thumbnail(1, fractal).state, Thumbnail::State::Pending);
    QVERIFY(ready.wait());
    QCOMPARE(thumbnails.thumbnail(1, fractal).pixmap.size(), QSize(60, 60));
    QCOMPARE(thumbnails.thumbnail(1, fractal).pixmap.deviceIndependentSize(), QSizeF(40, 40));
}

void ThumbnailsTest::clearForgetsWhatIsUnderway() {
    Thumbnails thumbnails;
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    for (quint64 key = 1; key <= 30; ++key)
        thumbnails.thumbnail(key, triangle());
    QVERIFY(ready.wait());
    thumbnails.clear();
    QCOMPARE(thumbnails.pending(), 0);
    const auto before = ready.count();
    constexpr quint64 later = 31;
    thumbnails.thumbnail(later, triangle());
    QTRY_VERIFY(ready.count() > before);
    QCOMPARE(ready.count(), before + 1);
    QCOMPARE(ready.last().first().toULongLong(), later);
}

void ThumbnailsTest::newestFirst() {
    Thumbnails thumbnails;
    const Pointer fractal = triangle();
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    for (quint64 key = 1; key <= 2000; ++key)
        thumbnails.thumbnail(key, fractal);
    QVERIFY2(thumbnails.pending() < 1000, "requests scrolled past long ago are dropped");
    QVERIFY(ready.wait());
    QCOMPARE(ready.front().front().toULongLong(), 2000ULL);
}

void ThumbnailsTest::noAttractor() {
    document::Fractal fractal = document::sierpinskiTriangle();
    for (auto& map : document::system2(fractal)->maps)
        map.map.linear *= 5;
    const auto pointer = std::make_shared<const document::Fractal>(fractal);
    Thumbnails thumbnails;
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.thumbnail(1, pointer);
    QVERIFY(ready.wait());
    QCOMPARE(thumbnails.thumbnail(1, pointer).state, Thumbnail::State::NoAttractor);
    QCOMPARE(thumbnails.pending(), 0);
}

void ThumbnailsTest::aSolid() {
    document::Fractal fractal;
    document::Shape<3> cube;
    for (int corner = 0; corner < 8; ++corner)
        ifs::append<3>(cube.system,
                       {0.5 * ifs::Matrix<3>::Identity(),
                        ifs::Vector<3>((corner & 1) / 2.0, (corner >> 1 & 1) / 2.0, (corner >> 2) / 2.0)});
    fractal.shape = cube;
    const auto pointer = std::make_shared<const document::Fractal>(fractal);
    Thumbnails thumbnails;
    thumbnails.setSize(64, 1);
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.thumbnail(1, pointer);
    QVERIFY(ready.wait());
    const Thumbnail thumbnail = thumbnails.thumbnail(1, pointer);
    QCOMPARE(thumbnail.state, Thumbnail::State::Ready);
    const QImage image = thumbnail.pixmap.toImage();
    QVERIFY(image.pixelColor(32, 32).lightness() > 60); // the faces of the cube are lit
    QVERIFY(image.pixelColor(32, 3).lightness() < 40);  // and there is nothing above it
}

void ThumbnailsTest::otherKinds() {
    Thumbnails thumbnails;
    QCOMPARE(thumbnails.thumbnail(2, std::make_shared<const document::Fractal>()).state,
             Thumbnail::State::Unreadable);
    QCOMPARE(thumbnails.pending(), 0);
}

// The picture is framed as placed by its cage: stretched to four times its width it still fits.
void ThumbnailsTest::sidewaysPlacement() {
    document::Fractal fractal = document::sierpinskiTriangle();
    ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    for (auto& corner : cage.current)
        corner = {4 * corner.x() + 50, corner.y()};
    document::plane(fractal)->cage = cage;
    const auto pointer = std::make_shared<const document::Fractal>(fractal);
    Thumbnails thumbnails;
    thumbnails.setSize(64, 1);
    QSignalSpy ready(&thumbnails, &Thumbnails::ready);
    thumbnails.thumbnail(1, pointer);
    QVERIFY(ready.wait());
    const QImage image = thumbnails.thumbnail(1, pointer).pixmap.toImage();
    std::set<int> columns;
    std::set<int> rows;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (qGray(image.pixel(x, y)) > 80) {
                columns.insert(x);
                rows.insert(y);
            }
    QVERIFY(!columns.empty());
    const int width = *columns.rbegin() - *columns.begin();
    const int height = *rows.rbegin() - *rows.begin();
    QVERIFY2(width > 48 && width < 62, qPrintable(QString::number(width)));
    QVERIFY2(height > 6 && height < 20, qPrintable(QString::number(height)));
}

void ThumbnailsTest::aCachedPictureIsNotDrawnAgain() {
    const QTemporaryDir folder;
    const Pointer fractal = triangle();
    const Pointer empty = std::make_shared<const document::Fractal>([] {
        document::Fractal none = document::sierpinskiTriangle();
        for (auto& map : document::system2(none)->maps)
            map.enabled = false;
        return none;
    }());
    QImage first;
    for (const std::uint64_t expected : {1, 0}) {
        Thumbnails thumbnails;
        thumbnails.setCache(std::make_unique<io::ThumbnailCache>(folder.path()));
        thumbnails.setSize(48, 1);
        thumbnails.thumbnail(1, fractal);
        thumbnails.thumbnail(2, empty);
        QTRY_COMPARE(thumbnails.thumbnail(1, fractal).state, Thumbnail::State::Ready);
        QTRY_COMPARE(thumbnails.thumbnail(2, empty).state, Thumbnail::State::NoAttractor);
        QCOMPARE(thumbnails.drawn(), expected);
        const QImage image = thumbnails.thumbnail(1, fractal).pixmap.toImage();
        if (first.isNull()) first = image;
        QCOMPARE(image, first);
    }
}

void ThumbnailsTest::aCacheThatDoesNotAnswerHoldsNothingUp() {
    constexpr auto never = 30s;
    const QTemporaryDir folder;
    const support::SlowDisk disk(folder.path(), never);
    QElapsedTimer clock;
    clock.start();
    {
        Thumbnails thumbnails;
        thumbnails.setCache(std::make_unique<io::ThumbnailCache>(folder.path()));
        const Pointer one = triangle();
        const Pointer other = changed(one, 0.1);
        thumbnails.thumbnail(1, one);
        thumbnails.thumbnail(2, other);
        QTRY_COMPARE(thumbnails.pending(), 0);
        QCOMPARE(thumbnails.drawn(), 2);
        thumbnails.thumbnail(3, changed(one, 0.2));
    }
    QVERIFY(disk.waited() > 0);
    QVERIFY(std::chrono::milliseconds(clock.elapsed()) < never);
}

BARYCAGE_TEST(ThumbnailsTest, QApplication);
#include "thumbnails_test.moc"
