// SPDX-License-Identifier: MIT
#include "bridges/construction.h"

#include "bars/construction_bar.h"
#include "bars/die.h"
#include "bars/start_shape_box.h"
#include "bridges/render_bridge.h"
#include "document/fractal/fractal_geometry.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <memory>

using view::Construction;
using Mode = view::Construction::Mode;

class ConstructionTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>(); // a Sierpiński triangle
        m_bridge = std::make_unique<view::RenderBridge>(m_document.get());
        m_bridge->setQuality(2'000'000);
        attractor::Camera camera;
        camera.width = 200;
        camera.height = 160;
        m_bridge->setCamera(fitted(camera, {0, 0}, {1, 0.87}));
        m_construction = std::make_unique<Construction>(m_document.get(), m_bridge.get());
    }

    void stepsFillFewerPixelsTheMoreThereAre() {
        m_construction->setMode(Mode::Steps);
        QCOMPARE(m_construction->deepest(), 12); // 3¹² < 10⁶ < 3¹³
        QCOMPARE(m_construction->copies(), 1.0);
        double before = 0;
        for (int n = 0; n <= 4; ++n) {
            m_construction->setStep(n);
            const double lit = litPixels();
            QCOMPARE(m_bridge->frame()->iterations, n);
            if (n > 0)
                QVERIFY2(std::abs(lit / before - 0.75) < 0.08, qPrintable(QString::number(lit / before)));
            before = lit;
        }
        QCOMPARE(m_construction->copies(), 81.0);
        m_construction->setStep(99);
        QCOMPARE(m_construction->step(), 12);
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void theFirstJumpsAreCountedAndNotPlotted() {
        view::ConstructionBar bar(m_construction.get());
        m_construction->setMode(Mode::ChaosGame);
        QVERIFY(!bar.die().fallen());
        for (std::uint64_t n = 1; n <= Construction::dropped; ++n) {
            m_construction->jumpOnce();
            QCOMPARE(m_construction->jumps(), n);
            QCOMPARE(m_construction->points(), std::uint64_t{0});
            QVERIFY(!m_construction->trail().back().isPlotted);
            QVERIFY(says(bar, QStringLiteral("jump %1 of the 14").arg(n)));
        }
        QCOMPARE(litPixels(), 0.0);
        m_construction->jumpOnce();
        QCOMPARE(m_construction->points(), std::uint64_t{1});
        QVERIFY(m_construction->trail().back().isPlotted);
        QVERIFY(says(bar, QStringLiteral("1 point")));
        QVERIFY(litPixels() >= 1);
    }

    void theChaosGamePlotsExactlyItsPoints() {
        m_construction->setMode(Mode::ChaosGame);
        QCOMPARE(litPixels(), 0.0);
        dropJumps();
        for (int n = 1; n <= 12; ++n) {
            m_construction->jumpOnce();
            const double lit = litPixels();
            QCOMPARE(m_bridge->frame()->samples, std::uint64_t(n));
            QVERIFY(lit >= 1 && lit <= n);
            QCOMPARE(m_construction->trail().size(), std::size_t(n) + Construction::dropped);
            QVERIFY(m_construction->lastMap() < 3);
        }
        // The newest point of the trail is one of those in the picture.
        const auto pixel = toPixel(m_bridge->camera(), m_construction->trail().back().x);
        QVERIFY(lit(int(pixel.x()), int(pixel.y())));
        m_construction->startAgain();
        QCOMPARE(m_construction->points(), std::uint64_t{0});
        QVERIFY(m_construction->trail().empty());
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    // Every jump is one map, and the point has its colour, whatever the fractal is coloured by.
    void theDieShowsWhichMapFell() {
        view::ConstructionBar bar(m_construction.get());
        m_construction->setMode(Mode::ChaosGame);
        const document::System2& system = *document::system2(m_document->fractal());
        QCOMPARE(m_construction->faces().size(), std::size_t{3});
        for (const auto& face : m_construction->faces())
            QVERIFY(std::abs(face.share - 1.0 / 3) < 1e-9);
        dropJumps();
        for (int n = 0; n < 8; ++n) {
            const ifs::Vector<2> before = m_construction->trail().back().x;
            m_construction->jumpOnce();
            const auto& jump = m_construction->trail().back();
            QVERIFY(system.maps[jump.map].map(before).isApprox(jump.x, 1e-9));
            QCOMPARE(bar.die().fallen(), std::optional(jump.map));
            QVERIFY(litPixels() > 0);
            const auto pixel = toPixel(m_bridge->camera(), jump.x);
            const QColor seen(colourAt(int(pixel.x()), int(pixel.y())));
            const attractor::Rgba face = m_construction->faces()[jump.map].colour;
            const QColor colour(face.red, face.green, face.blue);
            QVERIFY2(std::abs(seen.hslHue() - colour.hslHue()) < 12, qPrintable(seen.name()));
        }
    }

    void runsAndPauses() {
        view::ConstructionBar bar(m_construction.get());
        m_construction->setRunning(true);
        QVERIFY(!m_construction->isRunning()); // only a chaos game runs
        m_construction->setMode(Mode::ChaosGame);
        const auto saysHow = [&bar] {
            const auto labels = bar.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [](const QLabel* label) { return label->text().contains(u'▶'); });
        };
        QVERIFY(saysHow()); // nothing is seen yet
        m_construction->setSpeed(1000);
        bar.run()->click();
        QVERIFY(!saysHow());
        QVERIFY(m_construction->isRunning());
        QTRY_VERIFY(m_construction->points() > 50);
        bar.run()->click();
        QVERIFY(!m_construction->isRunning());
        const std::uint64_t points = m_construction->points();
        QTRY_VERIFY(m_bridge->isCurrent());
        QCOMPARE(m_bridge->frame()->samples, points);
        QSignalSpy frames(m_bridge.get(), &view::RenderBridge::frameChanged);
        document::Document another;
        view::RenderBridge bridge(&another);
        view::Construction running(&another, &bridge);
        running.setMode(Mode::ChaosGame);
        running.setSpeed(1000);
        running.setRunning(true);
        QTRY_VERIFY(running.points() > 50); // meanwhile
        QCOMPARE(m_construction->points(), points);
        QCOMPARE(frames.size(), 0); // nothing is drawn while it is paused
        bar.run()->click();
        m_construction->setMode(Mode::Density);
        QVERIFY(!m_construction->isRunning());
    }

    void theTrailFollowsTheCage() {
        m_construction->setMode(Mode::ChaosGame);
        dropJumps();
        for (int n = 0; n < 3; ++n)
            m_construction->jumpOnce();
        const ifs::Vector<2> before = m_construction->trail().back().x;
        document::Fractal moved = m_document->fractal();
        document::plane(moved)->cage = document::effectiveCage(moved);
        for (auto& vertex : document::plane(moved)->cage->current)
            vertex += ifs::Vector<2>(0.25, 0.5);
        m_document->edit(QStringLiteral("move"), moved);
        QVERIFY((m_construction->trail().back().x - before).isApprox(ifs::Vector<2>(0.25, 0.5), 1e-12));
        QCOMPARE(m_construction->points(), std::uint64_t{3});
        QTRY_VERIFY(m_bridge->isCurrent());
        QCOMPARE(m_bridge->frame()->samples, std::uint64_t{3});
    }

    void backToDensityRefines() {
        m_construction->setMode(Mode::Steps);
        litPixels();
        m_construction->setMode(Mode::Density);
        QTRY_VERIFY(m_bridge->isCurrent() && m_bridge->frame()->samples >= 2'000'000);
    }

    void stepsStartFromAnyShape() {
        m_construction->setMode(Mode::Steps);
        const double triangle = litPixels();
        view::ConstructionBar bar(m_construction.get());
        bar.show();
        support::choose(bar.start()->choice(), view::StepsBridge::Start::Square);
        QCOMPARE(m_construction->steps().start(), view::StepsBridge::Start::Square);
        QTRY_VERIFY(std::abs(litPixels() - triangle) > 0.05 * triangle);
        const double square = litPixels();
        support::choose(bar.start()->choice(), view::StepsBridge::Start::Letter);
        QVERIFY(bar.start()->letter()->isVisible());
        QTest::keyClicks(bar.start()->letter(), QStringLiteral("L")); // replaces what is selected
        QCOMPARE(m_construction->steps().letter(), QStringLiteral("L"));
        QTRY_VERIFY(litPixels() < 0.6 * square);
        QVERIFY(litPixels() > 0);
        m_construction->setStep(1);
        litPixels();
        QCOMPARE(m_bridge->frame()->iterations, 1);
        m_construction->steps().setLetter({}); // nothing is typed: the cage
        QTRY_VERIFY(!m_bridge->isSubstituted());
        m_construction->steps().setStart(view::StepsBridge::Start::Square);
        QVERIFY(m_bridge->isSubstituted());
        m_construction->setMode(Mode::Density);
        QVERIFY(!m_bridge->isSubstituted());
        QCOMPARE(m_document->undoStack()->count(), 0);
    }

    void aPictureIsReadInTheBackground() {
        QTemporaryDir folder;
        QImage image(60, 40, QImage::Format_RGB32);
        image.fill(Qt::white);
        for (int y = 5; y < 35; ++y)
            for (int x = 10; x < 30; ++x)
                image.setPixel(x, y, 0xff000000);
        const QString path = folder.filePath(QStringLiteral("shape.png"));
        QVERIFY(image.save(path));
        m_construction->setMode(Mode::Steps);
        view::StepsBridge& steps = m_construction->steps();
        steps.readPicture(path);
        QTRY_COMPARE(steps.start(), view::StepsBridge::Start::Picture);
        QCOMPARE(steps.pictureName(), QStringLiteral("shape.png"));
        QVERIFY(litPixels() > 0 && m_bridge->isSubstituted());
        steps.readPicture(folder.filePath(QStringLiteral("missing.png")));
        QTRY_VERIFY(!steps.flaw().isEmpty()); // and what was there stays
        QCOMPARE(steps.start(), view::StepsBridge::Start::Picture);
    }

    void theDistanceFollowsStepAndEdit() {
        view::ConstructionBar bar(m_construction.get());
        m_construction->setMode(Mode::Steps);
        QVERIFY(QTest::qWaitFor([&] { return m_construction->steps().distance().has_value(); }, 20'000));
        const double before = *m_construction->steps().distance()->distance;
        m_construction->setStep(2);
        QVERIFY(QTest::qWaitFor(
            [&] {
                const auto& now = m_construction->steps().distance();
                return now && std::abs(*now->distance / before - 0.25) < 0.05;
            },
            20'000));
        QVERIFY(bar.distanceText().contains(QChar(0x2248)));
        document::Fractal wide = m_document->fractal();
        document::system2(wide)->maps[0].map.linear *= 2.02; // does not contract
        m_document->edit(QStringLiteral("widen"), wide);
        QVERIFY(QTest::qWaitFor([&] { return bar.distanceText().contains(QStringLiteral("1.01")); }, 20'000));
        m_construction->setMode(Mode::Density);
        QVERIFY(bar.distanceText().isEmpty());
    }

    void theBarShowsTheState() {
        view::ConstructionBar bar(m_construction.get());
        bar.show();
        for (auto* button : bar.findChildren<QToolButton*>())
            if (button->isCheckable()) button->click();
        QCOMPARE(m_construction->mode(), Mode::ChaosGame);
        m_construction->setMode(Mode::Steps);
        bar.steps()->setValue(3);
        QCOMPARE(m_construction->step(), 3);
        QCOMPARE(bar.steps()->maximum(), 12);
        document::Fractal two = m_document->fractal();
        document::system2(two)->maps.pop_back();
        m_document->edit(QStringLiteral("fewer"), two);
        QCOMPARE(bar.steps()->maximum(), 19); // 2¹⁹ < 10⁶ < 2²⁰
    }

private:
    void dropJumps() {
        while (m_construction->jumps() < Construction::dropped)
            m_construction->jumpOnce();
    }
    static bool says(const QWidget& bar, const QString& text) {
        const auto labels = bar.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(text); });
    }
    std::uint32_t colourAt(int x, int y) const {
        return m_bridge->frame()->pixels[std::size_t(y) * 200 + std::size_t(x)];
    }
    bool lit(int x, int y) const {
        const auto& frame = *m_bridge->frame();
        const std::uint32_t pixel = frame.pixels[std::size_t(y) * 200 + std::size_t(x)];
        return pixel != frame.pixels[0]; // the corner shows the background
    }
    double litPixels() const {
        if (!QTest::qWaitFor([this] { return m_bridge->isCurrent(); }, 20'000)) return -1;
        double count = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 200; ++x)
                count += lit(x, y) ? 1 : 0;
        return count;
    }
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::RenderBridge> m_bridge;
    std::unique_ptr<Construction> m_construction;
};

BARYCAGE_TEST(ConstructionTest, QApplication);
#include "construction_test.moc"
