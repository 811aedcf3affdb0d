// SPDX-License-Identifier: MIT
#include "dialogs/export/animation_export_dialog.h"
#include "document/animated_fractal.h"
#include "document/edits/animation_edits.h"
#include "panels/timeline/timeline_panel.h"
#include "panels/timeline/track_view.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QLabel>

#include <memory>

// The window says when an animation loses its attractor: in the timeline, and before an export.
class LostAttractorTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void theTimelineSaysWhen();
    void motionsAreNamedWhereThereAreSome();
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
    QCOMPARE(redPixels(ruler(frame + 6)), 0);

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

QTEST_MAIN(LostAttractorTest)
#include "lost_attractor_test.moc"
