// SPDX-License-Identifier: MIT
#include "bridges/attractor_watch.h"
#include "dialogs/export/animation_export_dialog.h"
#include "document/edits/timeline/animation_edits.h"
#include "document/moments/animated_fractal.h"
#include "panels/timeline/timeline_panel.h"
#include "panels/timeline/track_view.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QLabel>

#include <algorithm>
#include <memory>

// The window says when an animation loses its attractor: in the timeline, and before an export.
class LostAttractorTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void theTimelineSaysWhen();
    void motionsAreNamedWhereThereAreSome();
    void theKeysToChangeAreNamed();
    void allFramesWithoutOneAreMarked();
    void longAnimationsAreLookedAtHereAndThere();
    void theExportSaysWhen();
};

namespace {

constexpr int patience = 60'000;

// Maps that swell from 0.8 to 0.8·(1 + strength) and back within 32 frames.
document::Fractal breathing(double strength) {
    document::Shape<2> shape;
    ifs::append(shape.system, ifs::affineMap(.8, 0, 0, .8, 0, 0), 1);
    ifs::append(shape.system, ifs::affineMap(.8, 0, 0, .8, 1, 0), 1);
    shape.animation.emplace();
    shape.animation->length = 32;
    shape.animation->motions = {animation::Breathe<2>{{}, strength, 1, {0, 0}}};
    document::Fractal fractal;
    fractal.name = QStringLiteral("breath");
    fractal.shape = std::move(shape);
    return fractal;
}

// A map that is keyed to grow.
document::Fractal growing() {
    document::Fractal fractal = breathing(0);
    document::Shape<2>& shape = *document::plane(fractal);
    shape.animation->motions.clear();
    shape.animation->maps = {{shape.system.maps[0].id,
                              {{0, {ifs::affineMap(.5, 0, 0, .5, 0, 0), 1}, {}},
                               {32, {ifs::affineMap(1.5, 0, 0, 1.5, 0, 0), 1}, {}}}}};
    return fractal;
}

// One map keyed with these factors at frames 0, 24 and 48.
document::Fractal keyed(double first, double middle, double last) {
    document::Fractal fractal = growing();
    document::Shape<2>& shape = *document::plane(fractal);
    shape.animation->length = 48;
    auto& keys = shape.animation->maps[0].keys;
    keys.clear();
    for (const auto& [frame, factor] : {std::pair{0, first}, {24, middle}, {48, last}})
        keys.push_back({frame, {ifs::affineMap(factor, 0, 0, factor, 0, 0), 1}, {}});
    return fractal;
}

QLabel* warningIn(const QWidget& widget) {
    for (auto* label : widget.findChildren<QLabel*>())
        if (label->accessibleName() == QStringLiteral("Frame without an attractor")) return label;
    return nullptr;
}

int redPixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor colour = picture.pixelColor(x, y);
            count += colour.red() > 150 && colour.green() < 120 && colour.blue() < 120;
        }
    return count;
}

} // namespace

void LostAttractorTest::theTimelineSaysWhen() {
    document::Document document;
    view::TimelinePanel panel(&document);
    panel.resize(900, 300);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const QLabel* warning = warningIn(panel);
    QVERIFY(warning);
    QVERIFY(!warning->isVisible());
    document.setFile(document::fileOf(breathing(0.5)));
    QTRY_VERIFY_WITH_TIMEOUT(warning->isVisible(), patience);
    const auto lost = document::firstWithoutAttractor(document.entryFractal());
    QVERIFY(lost);
    const auto frame = int(lost->moment.numerator / lost->moment.denominator); // 33 moments: whole frames
    QVERIFY(frame > 0);
    QVERIFY2(warning->text().contains(QStringLiteral("frame %1,").arg(frame)), qPrintable(warning->text()));
    QCOMPARE(document.moment(), animation::moment(0)); // the playhead is elsewhere
    const view::TrackView& tracks = *panel.trackView();
    const auto ruler = [&](int at) {
        const QPoint middle = tracks.rulerPosition(at);
        return tracks.viewport()->grab(QRect(middle - QPoint(3, 6), QSize(7, 12))).toImage();
    };
    QVERIFY(redPixels(ruler(frame)) > 12);
    QCOMPARE(redPixels(ruler(frame + 16)), 0); // where the maps shrink

    document.editEntry(QStringLiteral("Weaken"), breathing(0.1));
    QTRY_VERIFY_WITH_TIMEOUT(!warning->isVisible(), patience);
    QCOMPARE(redPixels(ruler(frame)), 0);
    document.undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(warning->isVisible(), patience);
    document.setFile(document::fileOf(document::sierpinskiTriangle()));
    QVERIFY(!warning->isVisible()); // at once: it was about another entry
}

void LostAttractorTest::motionsAreNamedWhereThereAreSome() {
    document::Document document;
    view::TimelinePanel panel(&document);
    panel.show();
    const QLabel* warning = warningIn(panel);
    document.setFile(document::fileOf(growing()));
    QTRY_VERIFY_WITH_TIMEOUT(warning->isVisible(), patience);
    QVERIFY2(warning->text().contains(QStringLiteral("no attractor")), qPrintable(warning->text()));
    QVERIFY2(!warning->text().contains(QStringLiteral("motion")), qPrintable(warning->text()));
    document.setFile(document::fileOf(breathing(0.5)));
    QTRY_VERIFY_WITH_TIMEOUT(warning->text().contains(QStringLiteral("motions")), patience);
}

// And the frame is one that can be gone to, though the moments that are tried first are 1.5 frames apart.
void LostAttractorTest::theKeysToChangeAreNamed() {
    document::Document document;
    view::TimelinePanel panel(&document);
    panel.show();
    const QLabel* warning = warningIn(panel);
    document.setFile(document::fileOf(keyed(0.5, 1.3, 0.5)));
    QTRY_VERIFY_WITH_TIMEOUT(warning->isVisible(), patience);
    QVERIFY2(warning->text().contains(QStringLiteral("(frames: 24)")), qPrintable(warning->text()));
    QVERIFY2(!warning->text().contains(QStringLiteral(".5")), qPrintable(warning->text()));
    const auto loss = view::attractorLoss(document.entryFractal(), {});
    QVERIFY(loss && loss->isAtKeys);
    QCOMPARE(loss->keys, std::vector<int>{24});
    QCOMPARE(loss->first.moment, animation::moment(loss->frames.front()));
    QVERIFY(warning->text().contains(QStringLiteral("At frame %1,").arg(loss->frames.front())));
    QVERIFY(!view::attractorLoss(keyed(0.5, 0.9, 0.5), {}));
}

void LostAttractorTest::allFramesWithoutOneAreMarked() {
    document::Document document;
    view::TimelinePanel panel(&document);
    panel.resize(900, 300);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    document.setFile(document::fileOf(keyed(0.5, 1.3, 0.5)));
    QTRY_VERIFY_WITH_TIMEOUT(warningIn(panel)->isVisible(), patience);
    const view::TrackView& tracks = *panel.trackView();
    for (int frame = 1; frame < 48; ++frame) {
        const QPoint top = tracks.rulerPosition(frame);
        const QImage mark = tracks.viewport()->grab(QRect(top - QPoint(1, 6), QSize(3, 12))).toImage();
        const bool isLost = document::lossAt(document.entryFractal(), animation::moment(frame)).has_value();
        QVERIFY2((redPixels(mark) > 6) == isLost, qPrintable(QString::number(frame)));
    }
}

void LostAttractorTest::longAnimationsAreLookedAtHereAndThere() {
    document::Fractal fractal = keyed(0.5, 1.3, 0.5);
    document::plane(fractal)->animation->length = 100'000;
    document::plane(fractal)->animation->maps[0].keys[2].frame = 99'999;
    const auto loss = view::attractorLoss(fractal, {});
    QVERIFY(loss);
    QVERIFY(loss->frames.size() < 500);
    QVERIFY(std::ranges::find(loss->frames, 24) != loss->frames.end()); // all keys are looked at
    QCOMPARE(loss->keys, std::vector<int>{24});
}

void LostAttractorTest::theExportSaysWhen() {
    document::Document document;
    document.setFile(document::fileOf(breathing(0.5)));
    view::AnimationExportDialog dialog(&document, attractor::View{});
    dialog.show();
    const QLabel* warning = warningIn(dialog);
    QVERIFY(warning);
    QTRY_VERIFY_WITH_TIMEOUT(warning->isVisible(), patience);
    const auto lost = document::firstWithoutAttractor(document.entryFractal());
    const QString frame = QStringLiteral("frame %1,").arg(lost->moment.numerator / lost->moment.denominator);
    QVERIFY2(warning->text().contains(frame), qPrintable(warning->text()));
}

BARYCAGE_TEST(LostAttractorTest, QApplication);
#include "lost_attractor_test.moc"
