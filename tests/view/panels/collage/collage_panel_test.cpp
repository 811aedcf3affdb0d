// SPDX-License-Identifier: MIT
#include "document/edits/entries_edits.h"
#include "document/edits/maps/maps_edits.h"
#include "panels/collage/suggestion_list.h"
#include "panels/collage/target_preview.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/collage_panel_fixture.h"
#include "widgets/layout/vertical_scroll_area.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QProgressBar>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace {

QImage plain(int width, int height) {
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Qt::black);
    return image;
}

QByteArray withFourComponents(QByteArray jpeg) {
    for (qsizetype i = 2; i + 9 < jpeg.size(); ++i)
        if (jpeg.at(i) == '\xff' && jpeg.at(i + 1) == '\xc0') {
            jpeg[i + 9] = 4;
            break;
        }
    return jpeg;
}

// Two frames of 16 × 16 pixels.
QByteArray animatedGif() {
    const QByteArray frame = QByteArray::fromHex("21f904000a000000") +
                             QByteArray::fromHex("2c00000000100010000002") +
                             QByteArray::fromHex("0e848fa9cbed0fa39cb4da8bb3de05") + QByteArray(1, '\0');
    return QByteArray("GIF89a") + QByteArray::fromHex("10001000800000000000ffffff") + frame + frame + ';';
}

} // namespace

class CollagePanelTest : public CollagePanelFixture {
    Q_OBJECT

private slots:
    void init() { openPanel(); }
    void cleanup() {
        m_panel.reset();
        close();
    }

    // A picture, Suggest, and a choice; all else is behind More.
    void threeStepsAreEnough() {
        m_panel->showMore(false);
        traceLeaf();
        QStringList seen;
        for (const auto* button : m_panel->findChildren<QAbstractButton*>())
            if (button->isVisible() && !button->text().isEmpty()) seen << button->text();
        QVERIFY2(seen.contains(QStringLiteral("Suggest")), qPrintable(seen.join(u'|')));
        QVERIFY2(seen.size() <= 6, qPrintable(seen.join(u'|')));
        for (const char* hidden : {"Refine Maps", "Fit Weights", "Fit Cage"})
            QVERIFY(!named<QPushButton>(QString::fromLatin1(hidden))->isVisible());
        auto* more = named<QToolButton>(QStringLiteral("More ways to trace"));
        QVERIFY(more->isVisible());
        more->click();
        QVERIFY(named<QPushButton>(QStringLiteral("Refine Maps"))->isVisible());
    }

    void aPictureIsTracedAndMeasured() {
        QVERIFY(!named<QPushButton>(QStringLiteral("Suggest"))->isEnabled());
        const auto* note = named<QLabel>(
            QStringLiteral("The target is not saved with the file. It is kept while the file is open."));
        QVERIFY(note && !note->isVisible());
        traceLeaf();
        QVERIFY(note->isVisible());
        const collage::Mask& mask = m_panel->target()->traced()->mask;
        QCOMPARE(mask.width, 160);
        QVERIFY(mask(80, 80));
        QVERIFY(!mask(5, 5));
        QVERIFY(number("Coverage").endsWith(QStringLiteral("%")));
        QVERIFY(number("Overlap of the maps").toDouble() >= 1 &&
                number("Overlap of the maps").toDouble() <= 3);
        QVERIFY2(number("Guaranteed within").contains(QStringLiteral("s = 0.5")),
                 qPrintable(number("Guaranteed within")));
        QCOMPARE(steps(), 0); // a target is no step of the history
        QVERIFY(layer()->mark().has_value());
    }

    void thresholdInvertAndCropChooseTheShape() {
        traceLeaf();
        const std::size_t automatic = collage::area(m_panel->target()->traced()->mask);
        QTest::mouseClick(named<QCheckBox>(QStringLiteral("Invert")), Qt::LeftButton, {}, {8, 8});
        settle();
        QCOMPARE(collage::area(m_panel->target()->traced()->mask), 160U * 160U - automatic);
        QTest::mouseClick(named<QCheckBox>(QStringLiteral("Invert")), Qt::LeftButton, {}, {8, 8});
        auto* slider = named<QSlider>(QStringLiteral("Threshold"));
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Home); // nothing is as dark as this
        settle();
        QVERIFY(!m_panel->target()->traced());
        QVERIFY2(sentence().contains(QStringLiteral("empty")), qPrintable(sentence()));
        QVERIFY(!named<QPushButton>(QStringLiteral("Suggest"))->isEnabled());
        QTest::mouseClick(named<QCheckBox>(QStringLiteral("Automatic threshold")), Qt::LeftButton, {},
                          {8, 8});
        settle();
        QCOMPARE(collage::area(m_panel->target()->traced()->mask), automatic);
        auto* preview = m_panel->findChild<view::TargetPreview*>();
        const QPoint middle = preview->rect().center();
        QTest::mousePress(preview, Qt::LeftButton, {}, middle - QPoint(40, 40));
        QTest::mouseMove(preview, middle);
        QTest::mouseRelease(preview, Qt::LeftButton, {}, middle + QPoint(40, 60));
        settle();
        const collage::Mask& cropped = m_panel->target()->traced()->mask;
        QVERIFY2(cropped.width > 80 && cropped.width < 105, qPrintable(QString::number(cropped.width)));
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Whole Picture")), Qt::LeftButton);
        settle();
        QCOMPARE(m_panel->target()->traced()->mask.width, 160);
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Crop to Shape")), Qt::LeftButton);
        settle();
        QVERIFY(m_panel->target()->traced()->mask.width < 90);
        QCOMPARE(collage::area(m_panel->target()->traced()->mask), automatic);
    }

    void uselessPicturesEndInASentence_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("part");
        const QByteArray jpeg = encoded(leaf(), "JPEG"), png = encoded(leaf(), "PNG");
        QTest::newRow("1 × 1") << encoded(plain(1, 1), "PNG") << "8 pixels";
        QTest::newRow("black") << encoded(plain(40, 40), "PNG") << "empty or fills";
        QTest::newRow("long and thin") << encoded(plain(30000, 1), "PNG") << "8 pixels";
        QTest::newRow("CMYK") << withFourComponents(jpeg) << "CMYK";
        QTest::newRow("animated") << animatedGif() << "animated";
        QTest::newRow("truncated") << png.left(png.size() / 2) << "incomplete";
        QTest::newRow("no picture") << QByteArray("maple { 0 0 0 0 0 0 }") << "picture";
        QTest::newRow("empty") << QByteArray() << "picture";
    }
    void uselessPicturesEndInASentence() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, part);
        m_panel->target()->read(write(QStringLiteral("useless"), bytes));
        settle();
        QVERIFY(!m_panel->target()->traced());
        QVERIFY2(sentence().contains(part), qPrintable(sentence()));
        QVERIFY(!named<QPushButton>(QStringLiteral("Suggest"))->isEnabled());
    }

    void aMissingFileLeavesTheTarget() {
        traceLeaf();
        m_panel->target()->read(m_folder.filePath(QStringLiteral("none.png")));
        settle();
        QVERIFY2(sentence().startsWith(QStringLiteral("none.png: ")), qPrintable(sentence()));
        QVERIFY(m_panel->target()->traced());
    }

    // The numbers follow while the button is down.
    void numbersAreLive() {
        traceLeaf();
        takeRoughMaps();
        m_canvas->setTool(CanvasView::Tool::Maps);
        const QString before = number("Coverage");
        const QPointF corner = at({Kind::Vertex, 1, 0});
        press(corner);
        move(corner + QPointF(-12, 18));
        QTRY_VERIFY_WITH_TIMEOUT(number("Coverage") != before, 60'000);
        key(Qt::Key_Escape);
        release(corner);
        settle();
        QTRY_COMPARE_WITH_TIMEOUT(number("Coverage"), before, 60'000);
    }

    // On cells twice as large: about the same, and the guarantee still is one.
    void liveNumbersAreCoarse() {
        m_panel->target()->read(write(QStringLiteral("large.png"), encoded(leaf(512), "PNG")));
        settle();
        takeRoughMaps();
        using document::Compared;
        const auto& traced = *m_panel->target()->traced();
        QCOMPARE(traced.coarseFactor, 2);
        const auto full = document::measured(m_document->fractal(), traced, Compared::Collage);
        const auto live =
            document::measured(m_document->fractal(), traced, Compared::Collage, document::Detail::Live);
        const auto attractor = document::measured(m_document->fractal(), traced, Compared::Attractor);
        QVERIFY(full && live && attractor);
        QVERIFY(std::abs(live->agreement.coverage - full->agreement.coverage) < 0.02);
        QVERIFY(std::abs(live->agreement.mean - full->agreement.mean) < 1);
        QVERIFY(std::abs(live->agreement.hausdorff - full->agreement.hausdorff) < 4);
        QVERIFY(*live->bound > *full->bound && *live->bound < *full->bound + 25);
        QVERIFY(*live->bound > attractor->agreement.hausdorff);
        QCOMPARE(live->picture.size().width() / 100, full->picture.size().width() / 100);
    }

    void mapsCarryTheTarget() {
        traceLeaf();
        takeRoughMaps();
        support::choose(named<QComboBox>(QStringLiteral("Agreement")), view::CollagePanel::Agreement::Hidden);
        settle();
        QTRY_VERIFY_WITH_TIMEOUT(m_bridge->isCurrent(), 60'000);
        const QPointF there = view::pixelOf(m_canvas->camera(), placed(ifs::Vector<2>(0.0, 0.24)));
        const QImage without = m_canvas->grab().toImage();
        m_canvas->setTool(CanvasView::Tool::Maps);
        const QImage with = m_canvas->grab().toImage();
        QVERIFY(with.pixel(there.toPoint()) != without.pixel(there.toPoint()));
        key(Qt::Key_H); // nothing but the picture
        const QImage hidden = m_canvas->grab().toImage();
        QVERIFY(hidden.pixel(there.toPoint()) != with.pixel(there.toPoint()));
    }

    void aClickOnTheMarkAddsAMap() {
        traceLeaf();
        takeRoughMaps();
        const int before = steps();
        const double distance = meanDistance();
        QVERIFY(layer()->mark().has_value());
        click(*layer()->mark());
        settle();
        QCOMPARE(system().maps.size(), std::size_t{4});
        QCOMPARE(steps(), before + 1);
        QCOMPARE(undoText(), QStringLiteral("Add Map"));
        QVERIFY(meanDistance() < distance);
        m_document->undoStack()->undo();
        settle();
        QCOMPARE(system().maps.size(), std::size_t{3});
    }

    void refiningLeavesLockedMapsAlone() {
        traceLeaf();
        takeRoughMaps();
        const document::System2 before = system();
        const double distance = meanDistance();
        m_canvas->selectMaps({before.maps[1].id});
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Lock Selected Maps")), Qt::LeftButton);
        QVERIFY(named<QToolButton>(QStringLiteral("Locked: 2")));
        push("Refine Maps");
        settle();
        QVERIFY(meanDistance() < distance);
        QVERIFY(system().maps[1].map == before.maps[1].map);
        QVERIFY(!(system().maps[0].map == before.maps[0].map));
        QCOMPARE(undoText(), QStringLiteral("Refine Maps"));
        m_document->undoStack()->undo();
        QVERIFY(system() == before);
        m_canvas->selectMaps({before.maps[2].id});
        QTest::mouseClick(named<QCheckBox>(QStringLiteral("Refine selected maps only")), Qt::LeftButton, {},
                          {8, 8});
        push("Refine Attractor");
        settle();
        QVERIFY(system().maps[0].map == before.maps[0].map);
        QVERIFY(system().maps[1].map == before.maps[1].map);
    }

    // What the last run has found is not said of the next one, nor what was measured of another entry.
    void textsOfWhatWasBeforeDisappear() {
        traceLeaf();
        takeRoughMaps();
        push("Refine Maps");
        settle();
        const auto* refined = named<QLabel>(QStringLiteral("Result of refining"));
        QVERIFY(refined->isVisible());
        push("Refine Attractor");
        QVERIFY(!refined->isVisible());
        settle();
        const auto first = m_document->currentId();
        const document::Inserted added =
            document::inserted(m_document->file(),
                               {{document::EntryId::None,
                                 std::make_shared<const document::Fractal>(m_document->fractal()),
                                 nullptr,
                                 {}}},
                               first);
        m_document->editFile(QStringLiteral("Add"), added.file, added.ids.front());
        traceLeaf();
        QVERIFY(named<QLabel>(QStringLiteral("Coverage"))->isVisible());
        m_document->setCurrent(first); // with a target of its own, which is traced anew
        QVERIFY(!m_panel->target()->traced());
        QVERIFY(!named<QLabel>(QStringLiteral("Coverage"))->isVisible());
        settle();
        QVERIFY(named<QLabel>(QStringLiteral("Coverage"))->isVisible());
        // A file that is no picture, until the target is changed.
        m_panel->target()->read(write(QStringLiteral("text.png"), "maple"));
        settle();
        QVERIFY(sentence().startsWith(QStringLiteral("text.png: ")));
        QTest::mouseClick(named<QCheckBox>(QStringLiteral("Invert")), Qt::LeftButton, {}, {8, 8});
        QVERIFY2(sentence().startsWith(QStringLiteral("leaf.png, ")), qPrintable(sentence()));
    }

    void fieldsAreInOneColumn() {
        const int left =
            named<QComboBox>(QStringLiteral("Number of maps"))->mapTo(m_panel.get(), QPoint()).x();
        QCOMPARE(named<QComboBox>(QStringLiteral("Angles"))->mapTo(m_panel.get(), QPoint()).x(), left);
        QCOMPARE(named<QWidget>(QStringLiteral("Seconds to search"))->mapTo(m_panel.get(), QPoint()).x(),
                 left);
    }

    void weightsAndCageAreFitted() {
        traceLeaf();
        takeRoughMaps();
        push("Fit Weights");
        settle();
        QCOMPARE(undoText(), QStringLiteral("Fit Weights"));
        double sum = 0;
        for (const auto& map : system().maps)
            sum += map.weight.value_or(0);
        QVERIFY(std::abs(sum - 1) < 1e-9);
        const int before = steps();
        push("Fit Cage");
        settle();
        QCOMPARE(steps(), before + 1);
        QCOMPARE(vertices().size(), std::size_t{8});
        QVERIFY(!document::collageObstacle(m_document->fractal()).isEmpty()); // it bends
        m_document->undoStack()->undo();
        QVERIFY(document::collageObstacle(m_document->fractal()).isEmpty());
    }

    void suggestionsAreUsedAsOneStep() {
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.5);
        support::choose(named<QComboBox>(QStringLiteral("Number of maps")), 4);
        const document::Fractal before = m_document->fractal();
        push("Suggest");
        settle();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        QVERIFY(list->count() > 0);
        QCOMPARE(steps(), 0);
        QVERIFY(list->item(0)->text().contains(QStringLiteral("Mean distance")));
        QVERIFY(list->item(0)->text().contains(QStringLiteral("Guaranteed within")));
        // Each has a picture: more than one colour.
        const auto isDrawn = [&](int row) {
            const QImage picture = list->item(row)->icon().pixmap(list->iconSize()).toImage();
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    if (picture.pixel(x, y) != picture.pixel(0, 0)) return true;
            return false;
        };
        for (int row = 0; row < list->count(); ++row)
            QTRY_VERIFY_WITH_TIMEOUT(isDrawn(row), 60'000);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        settle();
        QCOMPARE(steps(), 1);
        QCOMPARE(system().maps.size(), std::size_t{4});
        QVERIFY(meanDistance() < 8);
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == before);
        m_document->undoStack()->redo();
        QCOMPARE(system().maps.size(), std::size_t{4});
    }

    // A look at another entry costs no second search.
    void suggestionsWaitWhileAnotherEntryIsShown() {
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.5);
        push("Suggest");
        settle();
        const auto* list = m_panel->findChild<view::SuggestionList*>();
        const int count = list->count();
        QVERIFY(count > 0 && !list->isHidden());
        const document::EntryId own = m_document->currentId();
        document::Entry other;
        other.fractal = std::make_shared<const document::Fractal>(document::sierpinskiTriangle());
        document::Inserted added = document::inserted(m_document->file(), {other}, own);
        m_document->editFile(QStringLiteral("Add"), std::move(added.file), added.ids.front());
        settle();
        QVERIFY(list->isHidden());
        m_document->setCurrent(own);
        settle();
        QCOMPARE(list->count(), count);
        QTRY_VERIFY(!list->isHidden());
    }

    // It marks the suggestion that is on the canvas, or none.
    void theHighlightFollowsTheHistory() {
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.5);
        support::choose(named<QComboBox>(QStringLiteral("Number of maps")), 4);
        push("Suggest");
        settle();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        QVERIFY(list->count() > 0);
        const auto highlighted = [&] {
            const QList<QListWidgetItem*> items = list->selectedItems();
            return items.isEmpty() ? -1 : list->row(items.front());
        };
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        settle();
        QCOMPARE(highlighted(), 0);
        m_document->undoStack()->undo();
        QCOMPARE(highlighted(), -1);
        m_document->undoStack()->redo();
        QCOMPARE(highlighted(), 0);
        takeRoughMaps();
        QCOMPARE(highlighted(), -1);
    }

    void cancellingAndLeavingStopASearch() {
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(60);
        push("Suggest");
        QVERIFY(!m_panel->isSettled());
        push("Cancel");
        settle();
        QCOMPARE(m_panel->findChild<view::SuggestionList*>()->count(), 0);
        push("Suggest");
        const document::EntryId first = m_document->currentId();
        document::Entry entry;
        entry.fractal = m_document->sharedFractal();
        const document::Inserted added = document::inserted(m_document->file(), {entry}, first);
        m_document->editFile(QStringLiteral("Add"), added.file, added.ids.front());
        settle();
        QVERIFY(!m_panel->target()->traced()); // each entry has a target of its own
        m_document->setCurrent(first);
        settle();
        QVERIFY(m_panel->target()->traced());
        push("Suggest");
        m_panel.reset(); // the window is closed meanwhile
        QCOMPARE(layer(), nullptr);
    }

    // What was found, or is being sought, is of the old one.
    void anotherTargetEndsASearch() {
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(60);
        const QSignalSpy said(m_panel.get(), &CollagePanel::message);
        push("Suggest");
        QTest::mouseClick(named<QToolButton>(QStringLiteral("Remove")), Qt::LeftButton);
        QVERIFY(m_panel->isSettled());
        QVERIFY2(said.last().first().toString().contains(QStringLiteral("Another picture is shown")),
                 qPrintable(said.last().first().toString()));
        QVERIFY(!named<QPushButton>(QStringLiteral("Suggest"))->isEnabled());
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.3);
        push("Suggest");
        settle();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        QVERIFY(list->count() > 0);
        QTest::mouseClick(named<QCheckBox>(QStringLiteral("Invert")), Qt::LeftButton, {}, {8, 8});
        settle();
        QCOMPARE(list->count(), 0);
    }

    // In a dock that is lower than the panel.
    void suggestionsScrollIntoView() {
        QScrollArea area;
        area.setWidgetResizable(true);
        area.resize(360, 400);
        area.setWidget(m_panel.get());
        area.show();
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.3);
        push("Suggest");
        settle();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        const auto isSeen = [&] {
            const QRect first = list->visualItemRect(list->item(0));
            return list->viewport()->visibleRegion().contains(first.center());
        };
        QVERIFY(list->count() > 0);
        QTRY_VERIFY(isSeen());
        area.takeWidget();
    }

    // However low the panel is.
    void progressScrollsIntoView() {
        view::VerticalScrollArea area(m_panel.get());
        area.resize(600, 300);
        area.show();
        QVERIFY(QTest::qWaitForWindowExposed(&area));
        traceLeaf();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(60);
        auto* bar = m_panel->findChild<QProgressBar*>();
        auto* cancel = named<QPushButton>(QStringLiteral("Cancel"));
        const auto isWhole = [](const QWidget* widget) {
            return widget->visibleRegion().boundingRect() == widget->rect();
        };
        QVERIFY(!isWhole(bar));
        push("Suggest");
        QTRY_VERIFY(isWhole(bar) && isWhole(cancel));
        push("Cancel");
        settle();
        area.takeWidget();
    }

    // Their attractors are not those of the listed maps alone, and a guarantee would be false.
    void symmetricAndLinkedMapsAreNotMeasured() {
        traceLeaf();
        takeRoughMaps();
        const document::Fractal plain = m_document->fractal();
        document::Fractal fractal = plain;
        document::system2(fractal)->symmetry.group = ifs::SymmetryGroup::Mirror;
        m_document->edit(QStringLiteral("Mirror"), fractal);
        settle();
        const auto says = [this](const char* part) {
            const QList<QLabel*> labels = m_panel->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [&](const QLabel* label) {
                return label->isVisible() && label->text().contains(QLatin1String(part));
            });
        };
        QVERIFY(says("A symmetry repeats the maps"));
        QVERIFY(!named<QLabel>(QStringLiteral("Guaranteed within"))->isVisible());
        const QSignalSpy said(m_panel.get(), &CollagePanel::message);
        const int before = steps();
        push("Refine Maps");
        QVERIFY(m_panel->isSettled());
        QVERIFY(said.last().first().toString().contains(QStringLiteral("symmetry")));
        QCOMPARE(steps(), before);
        m_panel->target()->take(m_document->sharedFractal()); // its attractor is a shape all the same
        settle();
        QVERIFY(m_panel->target()->traced());
        fractal = plain;
        const auto& maps = document::system2(fractal)->maps;
        document::system2(fractal)->links = {{maps[0].id, maps[1].id, 0}};
        m_document->edit(QStringLiteral("Link"), fractal);
        settle();
        QVERIFY(says("The maps are linked"));
        QVERIFY(!named<QLabel>(QStringLiteral("Guaranteed within"))->isVisible());
    }

    // They follow the shape within a pixel, with few corners.
    void outlinesAreLight() {
        traceLeaf();
        const auto& traced = *m_panel->target()->traced();
        QCOMPARE(traced.outlines.size(), std::size_t{1});
        const auto& outline = traced.outlines.front();
        QVERIFY2(outline.size() > 8 && outline.size() < 120, qPrintable(QString::number(outline.size())));
        double area = 0; // twice, positive: the shape is on the left
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const auto& a = outline[k];
            const auto& b = outline[(k + 1) % outline.size()];
            area += a.x() * b.y() - a.y() * b.x();
        }
        const double pixels = area / 2 * std::pow(traced.mask.height / traced.place.height, 2);
        QVERIFY(std::abs(pixels / double(collage::area(traced.mask)) - 1) < 0.02);
    }

    void stepsBackDuringASearchDoNoHarm() {
        traceLeaf();
        const document::Fractal first = m_document->fractal();
        takeRoughMaps();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.5);
        push("Suggest");
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == first);
        settle();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        QVERIFY(list->count() > 0);
        QVERIFY(m_document->fractal() == first); // nothing is used unasked
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        settle();
        QVERIFY(!(m_document->fractal() == first));
        m_document->undoStack()->undo();
        QVERIFY(m_document->fractal() == first);
    }

    void solidsHaveNoCollage() {
        traceLeaf();
        document::Fractal solid = m_document->fractal();
        document::Shape<3> shape;
        for (const double x : {-0.5, 0.5}) {
            ifs::AffineMap<3> map;
            map.linear = 0.5 * ifs::Matrix<3>::Identity();
            map.translation = {x, 0, 0};
            ifs::append<3>(shape.system, map);
        }
        solid.shape = std::move(shape);
        m_document->edit(QStringLiteral("Lift"), solid);
        settle();
        QVERIFY(!named<QPushButton>(QStringLiteral("Suggest"))->isEnabled());
        QVERIFY(!named<QPushButton>(QStringLiteral("Fit Cage"))->isEnabled());
        QVERIFY(!layer()->mark());
        QVERIFY(!document::collageObstacle(m_document->fractal()).isEmpty());
        m_document->undoStack()->undo();
        settle();
        QVERIFY(named<QPushButton>(QStringLiteral("Suggest"))->isEnabled());
        QVERIFY(layer()->mark());
    }

    void theCanvasMayGoFirst() {
        traceLeaf();
        push("Refine Maps");
        m_canvas->disconnect(m_panel.get());
        m_canvas.reset();
        m_panel.reset();
        QVERIFY(!m_canvas);
    }
};

BARYCAGE_TEST(CollagePanelTest, QApplication);
#include "collage_panel_test.moc"
