// SPDX-License-Identifier: MIT
#include "panels/appearance/appearance_panel.h"
#include "panels/appearance/controls/appearance_colour_button.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/number_rows.h"
#include "panels/appearance/palettes/gradient_editor.h"
#include "panels/appearance/palettes/gradient_preview.h"
#include "panels/appearance/palettes/gradient_strip.h"
#include "panels/appearance/palettes/picture_palette_dialog.h"
#include "support/choose.h"
#include "support/events.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>

#include <memory>

using namespace maps_support;
using attractor::Appearance;

class AppearancePanelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(maple()));
        m_panel = std::make_unique<view::AppearancePanel>(m_document.get());
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }

    void aSliderDragIsLiveAndOneStep() {
        QSlider* slider = m_panel->numbers()->slider(&attractor::Appearance::brightness)->slider();
        const double before = appearance().brightness;
        slider->setSliderDown(true);
        for (const int position : {300, 320, 350})
            slider->setSliderPosition(position);
        const double during = appearance().brightness;
        QVERIFY(during > before);
        QCOMPARE(m_document->undoStack()->count(), 0);
        slider->setSliderDown(false);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(appearance().brightness, during);
        m_document->undoStack()->undo();
        QCOMPARE(appearance().brightness, before);
        QCOMPARE(m_panel->numbers()->slider(&attractor::Appearance::brightness)->field()->value(), before);
    }

    void aRunOfArrowKeysIsOneStep() {
        QSlider* slider = m_panel->numbers()->slider(&attractor::Appearance::gamma)->slider();
        slider->setFocus();
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(appearance().gamma > Appearance{}.gamma);
    }

    void undoDuringARunOfStepsMovesTheSliderBack() {
        QSlider* slider = m_panel->numbers()->slider(&attractor::Appearance::gamma)->slider();
        const int start = slider->value();
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QVERIFY(slider->value() > start);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QTest::keyClick(slider, Qt::Key_Right);
        m_document->undoStack()->undo();
        QCOMPARE(appearance().gamma, Appearance{}.gamma);
        QCOMPARE(slider->value(), start);
    }

    // One that maps have by their place is not written down for that.
    void theSameColourChosenAgainChangesNothing() {
        const document::Fractal before = m_document->fractal();
        const auto choose = [](QWidget* button, const QList<QColor>& tried) {
            QTimer::singleShot(0, button, [&tried] {
                auto* dialog = qobject_cast<QColorDialog*>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                const QColor shown = dialog->currentColor();
                for (const QColor& colour : tried)
                    dialog->setCurrentColor(colour);
                if (!tried.isEmpty()) dialog->setCurrentColor(shown);
                dialog->accept();
            });
            QTest::mouseClick(button, Qt::LeftButton);
        };
        document::Fractal byMap = before;
        byMap.appearance.colourBy = attractor::ColourBy::Map;
        m_document->edit(QStringLiteral("x"), byMap);
        const auto buttons = m_panel->findChildren<view::ColourButton*>();
        QVERIFY(buttons.size() >= 4);
        for (auto* button : buttons) {
            if (!button->isVisible() || !button->isEnabled()) continue;
            choose(button, {});
            choose(button, {Qt::red, Qt::green});
            QCOMPARE(m_document->undoStack()->count(), 1);
            QVERIFY(m_document->fractal() == byMap);
        }
    }

    void noFieldIsCutHoweverNarrow() {
        for (const int points : {9, 15, 20}) {
            QFont font = m_panel->font();
            font.setPointSize(points);
            m_panel->setFont(font);
            support::handleEvents();
            const int narrowest = m_panel->minimumSizeHint().width();
            for (int width = narrowest; width < 2 * narrowest; width += 7) {
                m_panel->resize(width, 600);
                support::handleEvents();
                const auto* box = m_panel->transparent();
                QVERIFY2(box->width() >= box->minimumSizeHint().width(), qPrintable(QString::number(width)));
                QVERIFY(box->geometry().right() <= m_panel->contentsRect().right());
            }
        }
    }

    void stopsAreEditedByMouse() {
        openEditor();
        view::GradientStrip* strip = m_panel->gradientEditor()->strip();
        const auto stops = [this] { return appearance().palette.stops; };
        const QPoint handle = strip->handleOf(3);
        QTest::mousePress(strip, Qt::LeftButton, {}, handle);
        QCOMPARE(strip->selected(), std::size_t{3});
        const double before = stops()[3].position;
        QTest::mouseMove(strip, handle + QPoint(6, 0));
        QTest::mouseMove(strip, handle + QPoint(9, 2));
        const double during = stops()[3].position;
        QVERIFY(during > before);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::mouseRelease(strip, Qt::LeftButton, {}, handle + QPoint(9, 2));
        QCOMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(stops()[3].position, during);
        const QPoint between((strip->handleOf(5).x() + strip->handleOf(6).x()) / 2, 10);
        QTest::mouseDClick(strip, Qt::LeftButton, {}, between);
        QCOMPARE(stops().size(), std::size_t{10});
        QCOMPARE(strip->selected(), std::size_t{6});
        QTest::keyClick(strip, Qt::Key_Delete);
        QCOMPARE(stops().size(), std::size_t{9});
        QCOMPARE(m_document->undoStack()->count(), 3);
        for (int i = 0; i < 3; ++i)
            m_document->undoStack()->undo();
        QVERIFY(appearance().palette == Appearance{}.palette);
        QVERIFY(strip->gradient() == Appearance{}.palette);
    }

    void stopsAreEditedByKeys() {
        openEditor();
        view::GradientStrip* strip = m_panel->gradientEditor()->strip();
        strip->setFocus();
        QTest::keyClick(strip, Qt::Key_PageDown);
        QCOMPARE(strip->selected(), std::size_t{1});
        QVERIFY(strip->accessibleDescription().startsWith(QStringLiteral("Stop 2 of 9 at 8.4 %, #9c283d")));
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(strip, Qt::Key_Right);
        QVERIFY(std::abs(appearance().palette.stops[1].position - 0.114) < 1e-9);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::keyClick(strip, Qt::Key_End); // ends the run
        QCOMPARE(m_document->undoStack()->count(), 1);
        QTest::keyClick(strip, Qt::Key_Right); // the last stop stays
        QTest::keyClick(strip, Qt::Key_Delete);
        QVERIFY(appearance().palette.stops.back() == Appearance{}.palette.stops.back());
        QTest::keyClick(strip, Qt::Key_Insert);
        QCOMPARE(appearance().palette.stops.size(), std::size_t{10});
        QCOMPARE(strip->selected(), std::size_t{8});
        QTest::keyClick(strip, Qt::Key_Left);
        QTest::keyClick(strip, Qt::Key_Escape);
        QCOMPARE(m_document->undoStack()->count(), 2);
        m_panel->gradientEditor()->reverse();
        m_panel->gradientEditor()->distribute();
        QCOMPARE(m_document->undoStack()->count(), 4);
        QCOMPARE(appearance().palette.stops[3].position, 1.0 / 3);
        QCOMPARE(appearance().palette.stops.front().colour, Appearance{}.palette.stops.back().colour);
    }

    void palettesAreSavedAndLoaded() {
        openEditor();
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("mine.gpl"));
        QSignalSpy messages(m_panel.get(), &view::AppearancePanel::message);
        m_panel->gradientEditor()->reverse();
        const attractor::Palette reversed = appearance().palette;
        m_panel->gradientEditor()->save(path);
        QCOMPARE(messages.size(), 1);
        m_document->undoStack()->undo();
        m_panel->gradientEditor()->load(path);
        QVERIFY(appearance().palette == reversed);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Load the palette mine.gpl"));
        const QString bad = folder.filePath(QStringLiteral("bad.map"));
        QVERIFY(QFile(bad).open(QIODevice::WriteOnly));
        m_panel->gradientEditor()->load(bad);
        QCOMPARE(messages.size(), 2);
        QVERIFY(messages.back().front().toString().startsWith(QStringLiteral("bad.map: ")));
        QVERIFY(appearance().palette == reversed);
    }

    // The left half is red, the right half blue, with a green stripe below that the line does not meet.
    void aPaletteIsTakenFromAPicture() {
        openEditor();
        QTemporaryDir folder;
        QImage picture(120, 90, QImage::Format_RGB32);
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x)
                picture.setPixel(x, y,
                                 y > 60   ? qRgb(20, 200, 40)
                                 : x < 60 ? qRgb(220, 20, 20)
                                          : qRgb(20, 20, 220));
        const QString path = folder.filePath(QStringLiteral("picture.png"));
        QVERIFY(picture.save(path));
        const auto greens = [this] {
            int count = 0;
            for (const auto& stop : appearance().palette.stops)
                count += stop.colour.green > 150 ? 1 : 0;
            return count;
        };
        int whole = -1, along = -1;
        bool wasRejected = false;
        const auto answer = [&](bool accepts) {
            QTimer::singleShot(200, m_panel.get(), [&, accepts] {
                auto* dialog = m_panel->findChild<view::PicturePaletteDialog*>();
                auto* canvas = dialog->findChild<view::LinePicture*>();
                whole = greens();
                const QPoint middle(canvas->width() / 2, canvas->height() / 4);
                QTest::mousePress(canvas, Qt::LeftButton, {}, middle - QPoint(canvas->width() / 3, 0));
                QMouseEvent move(QEvent::MouseMove, middle + QPoint(canvas->width() / 3, 0),
                                 canvas->mapToGlobal(middle), Qt::NoButton, Qt::LeftButton, {});
                QCoreApplication::sendEvent(canvas, &move);
                QTest::mouseRelease(canvas, Qt::LeftButton, {}, middle + QPoint(canvas->width() / 3, 0));
                along = greens();
                wasRejected = !accepts;
                accepts ? dialog->accept() : dialog->reject();
            });
            m_panel->gradientEditor()->load(path);
        };
        const attractor::Palette before = appearance().palette;
        answer(false);
        QVERIFY(wasRejected && appearance().palette == before);
        QCOMPARE(m_document->undoStack()->count(), 0);
        answer(true);
        QVERIFY(whole >= 1);
        QCOMPARE(along, 0);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(appearance().palette.stops.front().colour.red > 200); // in the order of the line
        QVERIFY(appearance().palette.stops.back().colour.blue > 200);
    }

    void aTypedGammaMustBePositive() {
        view::NumberField* field = m_panel->numbers()->slider(&attractor::Appearance::gamma)->field();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("-1"));
        QVERIFY(!field->problem().isEmpty());
        QCOMPARE(appearance().gamma, Appearance{}.gamma);
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("1.5"));
        QCOMPARE(appearance().gamma, 1.5);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void contrastAndVibrancyAreSlidersLikeTheOthers() {
        QCOMPARE(m_panel->numbers()->slider(&attractor::Appearance::contrast)->slider()->value(),
                 200); // in the middle
        QCOMPARE(m_panel->numbers()->slider(&attractor::Appearance::vibrancy)->slider()->value(), 400);
        const auto drag = [](const view::AppearanceSlider* of, int position) {
            of->slider()->setSliderDown(true);
            of->slider()->setSliderPosition((of->slider()->value() + position) / 2);
            of->slider()->setSliderPosition(position);
            of->slider()->setSliderDown(false);
        };
        drag(m_panel->numbers()->slider(&attractor::Appearance::contrast), 400);
        drag(m_panel->numbers()->slider(&attractor::Appearance::vibrancy), 100);
        QCOMPARE(appearance().contrast, 5.0);
        QCOMPARE(appearance().vibrancy, 0.25);
        QCOMPARE(m_document->undoStack()->count(), 2);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Vibrancy: 0.25"));
        drag(m_panel->numbers()->slider(&attractor::Appearance::contrast), 200);
        QCOMPARE(appearance().contrast, 1.0); // exactly as it was
        m_document->undoStack()->undo();
        m_document->undoStack()->undo();
        QCOMPARE(appearance().vibrancy, 1.0);
        QCOMPARE(m_panel->numbers()->slider(&attractor::Appearance::vibrancy)->field()->value(), 1.0);
        m_panel->resetToDefault();
        QVERIFY(appearance() == Appearance{});
        for (const view::AppearanceSlider* slider :
             {m_panel->numbers()->slider(&attractor::Appearance::contrast),
              m_panel->numbers()->slider(&attractor::Appearance::vibrancy)}) {
            QVERIFY(!slider->toolTip().isEmpty());
            QVERIFY(slider->whatsThis().size() > slider->toolTip().size());
        }
    }

    void whereAShadowFallsIsAskedWhileThereIsOne() {
        const auto* shadow = m_panel->numbers()->slider(&attractor::Appearance::shadow);
        const auto* lean = m_panel->numbers()->slider(&attractor::Appearance::shadowLean);
        const auto* length = m_panel->numbers()->slider(&attractor::Appearance::shadowLength);
        QVERIFY(shadow->isEnabled() && !lean->isEnabled() && !length->isEnabled());
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
        const auto places = [&] { // what the hand holds stays under it
            QList<QRect> all;
            for (const QWidget* widget : m_panel->findChildren<QWidget*>())
                if (widget->isVisibleTo(m_panel.get()))
                    all << QRect(widget->mapTo(m_panel.get(), QPoint()), widget->size());
            return all;
        };
        const QList<QRect> before = places();
        shadow->slider()->setValue(200);
        QTRY_COMPARE(m_document->undoStack()->count(), 1);
        QCOMPARE(appearance().shadow, 0.5);
        QVERIFY(lean->isEnabled() && length->isEnabled());
        QCoreApplication::processEvents();
        QCOMPARE(places(), before);
        length->slider()->setValue(0);
        QTRY_COMPARE(m_document->undoStack()->count(), 2);
        QCOMPARE(appearance().shadowLength, -3.0);
        m_document->undoStack()->setIndex(0);
        QVERIFY(!lean->isEnabled());
    }

    void aTypedContrastIsWithinReason() {
        view::NumberField* field = m_panel->numbers()->slider(&attractor::Appearance::contrast)->field();
        field->setFocus();
        for (const char* wrong : {"1e9", "0"}) {
            field->selectAll();
            QTest::keyClicks(field, QLatin1String(wrong));
            QVERIFY(!field->problem().isEmpty());
        }
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("20")); // more than the slider has
        QCOMPARE(appearance().contrast, 20.0);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void aTypedVibrancyIsBetweenZeroAndOne() {
        view::NumberField* field = m_panel->numbers()->slider(&attractor::Appearance::vibrancy)->field();
        field->setFocus();
        for (const char* wrong : {"1.5", "-1"}) {
            field->selectAll();
            QTest::keyClicks(field, QLatin1String(wrong));
            QVERIFY(!field->problem().isEmpty());
            QCOMPARE(appearance().vibrancy, 1.0);
        }
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("0"));
        QCOMPARE(appearance().vibrancy, 0.0);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
    }

    void stepsSayWhatWasChosen() {
        support::choose(m_panel->colourBy(), attractor::ColourBy::Address);
        QCOMPARE(appearance().colourBy, attractor::ColourBy::Address);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Colour by: Address"));
    }

    void choicesAreSteps() {
        support::choose(m_panel->colourBy(), attractor::ColourBy::Map);
        QCOMPARE(appearance().colourBy, attractor::ColourBy::Map);
        QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Colour by: Map"));
        support::choose(m_panel->gradient(), attractor::builtInPalettes()[1]);
        QVERIFY(appearance().palette == attractor::builtInPalettes()[1]);
        support::choose(m_panel->supersampling(), 3);
        QCOMPARE(appearance().supersample, 3);
        m_panel->transparent()->click();
        QCOMPARE(int(appearance().background.alpha), 0);
        QCOMPARE(m_document->undoStack()->count(), 4);
        m_panel->resetToDefault();
        QVERIFY(appearance() == Appearance{});
        for (int i = 0; i < 5; ++i)
            m_document->undoStack()->undo();
        QVERIFY(appearance() == Appearance{});
        QCOMPARE(view::chosenValue<attractor::ColourBy>(m_panel->colourBy()), Appearance().colourBy);
    }

    void aPaletteOfTheFileIsOffered() {
        document::Fractal fractal = m_document->fractal();
        fractal.appearance.palette = {"mine", {{0, {0, 0, 0, 255}}, {1, {255, 0, 0, 255}}}};
        const int builtIn = m_panel->gradient()->count();
        m_document->edit(QStringLiteral("palette"), fractal);
        QCOMPARE(m_panel->gradient()->count(), builtIn + 1);
        QCOMPARE(m_panel->gradient()->currentIndex(), builtIn);
        m_document->undoStack()->undo();
        QCOMPARE(m_panel->gradient()->currentIndex(), 0);
    }

    void aGradientIsPaintedFromEndToEnd() {
        const attractor::Palette palette{"p", {{0, {0, 0, 0, 255}}, {1, {255, 255, 255, 255}}}};
        const QImage image = view::gradientPixmap(palette, {100, 12}, 2).toImage();
        QCOMPARE(image.size(), QSize(200, 24));
        QVERIFY(image.pixelColor(4, 12).lightness() < 60);
        QVERIFY(image.pixelColor(195, 12).lightness() > 240);
        for (int x = 8; x < 192; x += 8)
            QVERIFY(image.pixelColor(x, 12).lightness() >= image.pixelColor(x - 4, 12).lightness());
    }

private:
    const Appearance& appearance() const { return m_document->fractal().appearance; }
    void openEditor() {
        m_panel->resize(400, 600);
        m_panel->editGradient()->click();
        QVERIFY(m_panel->gradientEditor()->isVisible());
        QCoreApplication::processEvents();
    }
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::AppearancePanel> m_panel;
};

BARYCAGE_TEST(AppearancePanelTest, QApplication);
#include "appearance_panel_test.moc"
