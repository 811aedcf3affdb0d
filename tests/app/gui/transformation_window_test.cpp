// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "bars/construction_bar.h"
#include "bridges/construction.h"
#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "canvas/scene/handle_text.h"
#include "dialogs/export/export_preview.h"
#include "dialogs/export/export_size_editor.h"
#include "document/edits/coupled_entries.h"
#include "document/edits/entries_edits.h"
#include "document/tops/kept_theft.h"
#include "document/tops/theft_starters.h"
#include "files/open_file.h"
#include "io/collection_source.h"
#include "io/fractint/fractint_reader.h"
#include "panels/collection/collection_panel.h"
#include "panels/entries/entries_panel.h"
#include "stage/stage.h"
#include "support/background_rest.h"
#include "support/choose.h"
#include "support/commands.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "transformation/theft_export_dialog.h"
#include "transformation/theft_sentences.h"
#include "transformation/transformation_view.h"
#include "window_fixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QButtonGroup>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>

using document::KeptTheft;
using document::TheftMode;
using Kind = view::CanvasPart::Kind;

constexpr std::uint64_t pointsAtRest = 16'000'000; // of more than a gesture draws

// The window of fractal transformations, under mouse, drops and undo.
class TransformationWindowTest : public WindowFixture {
    Q_OBJECT

private slots:
    void showsAndHides();
    void aStarterIsOneStep();
    void draggingThePartnerIsLive();
    void draggingTheCageIsLive();
    void theCanvasesCanBeStacked();
    void correspondingMapsLookAlike();
    void slidersMoveTheFamily();
    void aDroppedPictureIsKept();
    void aMissingPictureIsSaid();
    void aDamagedPictureIsNotTaken();
    void otherNumbersAreDivided();
    void theOrderIsKept();
    void exportsThePicture();
    void savingMakesPathsRelative();
    void theShortcutSaysNothingStale();
    void everyModeIsKept();
    void theCollectionShowsItWithItsPartner();
    void aRenamedPartnerStays();
    void aConstructionEndsIt();

private:
    document::Document& document() { return m_window->document(); }
    view::TransformationView* view() const { return m_window->findChild<view::TransformationView*>(); }
    view::CanvasView* canvas() const { return m_window->findChild<Stage*>()->plane(); }
    int steps() { return document().undoStack()->count(); }
    void toggle() { support::command(*m_window, "fractal-transformation")->trigger(); }
    void choose(const char* name) { support::action(*view()->bar(), name)->trigger(); }
    void click(const char* name) {
        auto* button = support::button(*view()->bar(), name);
        QVERIFY(button->isVisible());
        button->click();
    }
    void openFamily() {
        toggle();
        choose("triangle-family");
        QTRY_VERIFY_WITH_TIMEOUT(isPainted(), 60'000);
    }
    bool isPainted() const { return !view()->partnerCanvas()->picture().isNull() && isStolen(); }
    const view::RenderBridge& render() const { // the partner's is made later
        return *m_window->findChild<view::RenderBridge*>();
    }
    // Of the picture.
    std::uint64_t points() const {
        return render().frame() && render().isCurrent() ? render().frame()->samples : 0;
    }
    bool isStolen() const { // the purple hills of the sunset; the density's palette is golden
        const QImage picture = canvas()->picture();
        int purple = 0;
        for (int y = 0; y < picture.height(); y += 3)
            for (int x = 0; x < picture.width(); x += 3) {
                const QColor colour = picture.pixelColor(x, y);
                purple += colour.red() > 40 && colour.blue() > colour.red() + 15 ? 1 : 0;
            }
        return purple > 200;
    }
    KeptTheft kept() { return document::keptTheft(document().entryFractal()).value_or(KeptTheft()); }
};

namespace {

void drop(QWidget* target, const QPoint& at, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(target, &enter);
    QVERIFY(enter.isAccepted());
    QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(target, &move);
    QVERIFY(move.isAccepted());
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(target, &drop);
    QVERIFY(drop.isAccepted());
}

QRect coloured(const QImage& picture) { // what is not background
    QRect seen;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixel(x, y) != picture.pixel(0, 0)) seen |= QRect(x, y, 1, 1);
    return seen;
}

} // namespace

void TransformationWindowTest::showsAndHides() {
    QVERIFY(!view()->partnerCanvas()); // not before it is asked for
    toggle();
    QVERIFY(view()->partnerCanvas()->isVisible() && view()->bar()->isVisible());
    QCOMPARE(steps(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(view()->bar()->problem().contains(QStringLiteral("they have 4 and")), 60'000);
    QVERIFY(view()->bar()->problem().startsWith(QStringLiteral("“maple” and “")));
    toggle();
    QVERIFY(!view()->partnerCanvas()->isVisible() && !view()->bar()->isVisible());
    QVERIFY(canvas()->isVisible());
    QCOMPARE(steps(), 0);
}

void TransformationWindowTest::aStarterIsOneStep() {
    const auto before = document().file().entries.size();
    openFamily();
    QCOMPARE(steps(), 1);
    QCOMPARE(document().file().entries.size(), before + 2);
    QCOMPARE(kept().mode, TheftMode::TransformPicture);
    // To 1/256 of the size, there and back.
    const document::Fractal& partner = view()->partnerCanvas()->canvas().document().fractal();
    const auto entries = document::coupled(document().fractal(), partner, {}).entries;
    QVERIFY(entries);
    const auto &f = entries->fromAttractor, &g = entries->toAttractor;
    const ifs::Tear there = ifs::tear(f, g, f.radius() / 128, 1U << 17);
    const ifs::Tear back = ifs::tear(g, f, g.radius() / 128, 1U << 17);
    QVERIFY(there.size > 0 && there.size < 0.5 && back.size > 0 && back.size < 0.5 && back.place);
    const QString expected =
        view::sentenceOf(there) + QStringLiteral(". ") + view::sentenceOf(back, ifs::Homeomorphism::Unknown);
    QVERIFY(expected.contains(
        QStringLiteral(". Not known whether it is a homeomorphism; no jump back exceeds ")));
    QTRY_COMPARE_WITH_TIMEOUT(view()->bar()->continuity(), expected, 60000);
    QVERIFY(view()->bar()->problem().isEmpty());
    document().undoStack()->undo();
    QCOMPARE(document().file().entries.size(), before);
}

void TransformationWindowTest::draggingThePartnerIsLive() {
    openFamily();
    view::CanvasView* partner = view()->partnerCanvas();
    const QImage before = canvas()->picture();
    canvas()->setTool(view::CanvasView::Tool::Maps);
    QCOMPARE(partner->tool(), view::CanvasView::Tool::Maps); // the tool of the window
    canvas()->setTool(view::CanvasView::Tool::Cage);
    // A corner of the cage, pulled with the mouse.
    QWidget* target = partner->viewport();
    const QPoint corner = partner->canvas().positionOf({Kind::Vertex, 0}).toPoint();
    const int stepsBefore = steps();
    choose("grid");
    QComboBox* mode = nullptr;
    for (auto* box : view()->bar()->findChildren<QComboBox*>())
        if (box->accessibleName() == QStringLiteral("Mode")) mode = box;
    QVERIFY(mode);
    support::choose(mode, TheftMode::StealColours); // the picture stays where it is
    QCOMPARE(steps(), stepsBefore + 2);
    QTRY_VERIFY_WITH_TIMEOUT(canvas()->picture() != before, 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(points() >= pointsAtRest, 60'000);
    const QImage still = canvas()->picture();
    bool isLive = false;
    const auto watch = connect(&render(), &view::RenderBridge::frameChanged, this,
                               [&] { isLive = isLive || render().frame()->samples < pointsAtRest; });
    QTest::mousePress(target, Qt::LeftButton, {}, corner);
    for (int k = 1; k <= 12; ++k) {
        QMouseEvent move(QEvent::MouseMove, corner + QPoint(4 * k, -3 * k),
                         target->mapToGlobal(corner + QPoint(4 * k, -3 * k)), Qt::NoButton, Qt::LeftButton,
                         {});
        QCoreApplication::sendEvent(target, &move);
        support::handleEvents();
    }
    QTRY_VERIFY(isLive && canvas()->picture() != still); // while the button is down
    disconnect(watch);
    QCOMPARE(steps(), stepsBefore + 2);
    QTest::mouseRelease(target, Qt::LeftButton, {}, corner + QPoint(48, -36));
    QCOMPARE(steps(), stepsBefore + 3);
    document().undoStack()->undo();
    QVERIFY(!document::plane(partner->canvas().document().fractal())->cage ||
            (partner->canvas().positionOf({Kind::Vertex, 0}).toPoint() - corner).manhattanLength() < 3);
}

// The cage of F: the picture follows while the button is down.
void TransformationWindowTest::draggingTheCageIsLive() {
    openFamily();
    canvas()->setTool(view::CanvasView::Tool::Cage);
    const auto corner = [this](int vertex) { return canvas()->canvas().positionOf({Kind::Vertex, vertex}); };
    int left = 0, right = 0;
    for (int vertex = 1; vertex < 3; ++vertex) {
        if (corner(vertex).x() < corner(left).x()) left = vertex;
        if (corner(vertex).x() > corner(right).x()) right = vertex;
    }
    const auto width = [this] { return coloured(canvas()->picture()).width(); };
    const int before = int(corner(right).x() - corner(left).x()), stepsBefore = steps();
    QVERIFY(before > 100);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(width() - before) < 8, 60'000); // the cage is the triangle
    QWidget* target = canvas()->viewport();
    const QPoint from = corner(right).toPoint();
    QTest::mousePress(target, Qt::LeftButton, {}, from);
    for (int k = 1; k <= 12; ++k) {
        const QPoint to = from - QPoint(5 * k, 0);
        QMouseEvent move(QEvent::MouseMove, to, target->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(target, &move);
        QCoreApplication::processEvents();
    }
    QTRY_VERIFY_WITH_TIMEOUT(width() < before - 40, 60'000);
    QVERIFY(isStolen());
    QCOMPARE(steps(), stepsBefore);
    QTest::mouseRelease(target, Qt::LeftButton, {}, from - QPoint(60, 0));
    QCOMPARE(steps(), stepsBefore + 1);
    document().undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(width() - before) < 8, 60'000);
}

void TransformationWindowTest::theCanvasesCanBeStacked() {
    openFamily();
    const auto corner = [this](view::CanvasView* of) { return of->mapTo(view(), QPoint()); };
    view::CanvasView* partner = view()->partnerCanvas();
    QVERIFY(corner(partner).x() > corner(canvas()).x() && corner(partner).y() == corner(canvas()).y());
    click("stack");
    QTRY_COMPARE(corner(partner).x(), corner(canvas()).x());
    QVERIFY(corner(partner).y() >= corner(canvas()).y() + canvas()->height());
    QVERIFY(std::abs(partner->height() - canvas()->height()) < 4);
    QTRY_VERIFY_WITH_TIMEOUT(isPainted(), 60'000);
    click("stack");
    QTRY_COMPARE(corner(partner).y(), corner(canvas()).y());
}

// Also where others take part in the partner, which keeps its own colours.
void TransformationWindowTest::correspondingMapsLookAlike() {
    openFamily();
    const document::EntryId partner = document::entryNamed(document().file(), kept().partner);
    const auto ofPartner = [&] {
        const document::FractalFile& file = document().file();
        return *file.entries[document::indexOf(file, partner)].fractal;
    };
    document::Fractal from = document().entryFractal();
    const attractor::Rgba teal{10, 130, 120, 255};
    from.appearance.mapColours[document::system2(from)->maps[1].id] = teal;
    document::system2(from)->maps[0].enabled = false;
    document().editEntry(QStringLiteral("colour"), from);
    document::Fractal to = ofPartner();
    const auto ownColours = to.appearance.mapColours;
    document::system2(to)->maps[3].enabled = false;
    document().editFile(QStringLiteral("off"), document::replaced(document().file(), partner, to),
                        document().currentId());
    canvas()->setTool(view::CanvasView::Tool::Maps);
    const view::CanvasScene& shown = view()->partnerCanvas()->canvas();
    QTRY_COMPARE(shown.frames().size(), std::size_t{4});
    QCOMPARE(shown.frames()[0].colour, QColor(10, 130, 120));
    QCOMPARE(view::mapName(shown.handles(), 0), QStringLiteral("Map 2"));
    QCOMPARE(view::mapName(shown.handles(), 2), QStringLiteral("Map 4"));
    QCOMPARE(view::mapName(shown.handles(), 3), QStringLiteral("Map that takes no part"));
    QCOMPARE(shown.frames()[2].colour, canvas()->canvas().frames()[3].colour);
    QVERIFY(ofPartner().appearance.mapColours == ownColours);
    canvas()->options().setMapNumbersVisible(true);
    QVERIFY(view()->partnerCanvas()->options().areMapNumbersVisible());
    document().undoStack()->undo();
    document().undoStack()->undo();
    QCOMPARE(view::mapName(shown.handles(), 0), QStringLiteral("Map 1"));
}

void TransformationWindowTest::slidersMoveTheFamily() {
    openFamily();
    const int before = steps();
    QList<QSlider*> sliders;
    for (auto* slider : view()->bar()->findChildren<QSlider*>())
        if (slider->isVisible()) sliders << slider;
    QCOMPARE(sliders.size(), 3);
    QTest::keyClick(sliders.first(), Qt::Key_PageUp);
    QTRY_COMPARE_WITH_TIMEOUT(steps(), before + 1, 60'000); // once the run of steps has ended
    document().undoStack()->undo();
    choose("square-family");
    sliders.clear();
    for (auto* slider : view()->bar()->findChildren<QSlider*>())
        if (slider->isVisible()) sliders << slider;
    QCOMPARE(sliders.size(), 2);
}

void TransformationWindowTest::aDroppedPictureIsKept() {
    openFamily();
    const QTemporaryDir folder;
    QImage blue(40, 40, QImage::Format_RGB32);
    blue.fill(QColor(20, 60, 250));
    const QString path = folder.filePath(QStringLiteral("blue.png"));
    QVERIFY(blue.save(path));
    const int before = steps();
    const QPoint middle = view()->partnerCanvas()->mapTo(view(), view()->partnerCanvas()->rect().center());
    drop(view(), middle, path);
    QTRY_COMPARE(steps(), before + 1);
    QCOMPARE(kept().picture, path); // the file has no folder yet
    const auto isBlue = [this] {
        const QImage picture = canvas()->picture();
        int count = 0;
        for (int y = 0; y < picture.height(); y += 3)
            for (int x = 0; x < picture.width(); x += 3)
                count += picture.pixelColor(x, y).blue() > 240 && picture.pixelColor(x, y).red() < 40 ? 1 : 0;
        return count > 500;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isBlue(), 60'000);
    document().undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(isStolen(), 60'000);
}

void TransformationWindowTest::aMissingPictureIsSaid() {
    openFamily();
    QTRY_VERIFY_WITH_TIMEOUT(view()->isPainted(), 60'000);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("gone.png"));
    QImage green(9, 9, QImage::Format_RGB32);
    green.fill(Qt::green);
    document::KeptTheft theft = kept();
    theft.picture = path; // as an opened file may have it
    document().editEntry(QStringLiteral("theft"), document::withTheft(document().entryFractal(), theft));
    QTRY_COMPARE_WITH_TIMEOUT(view()->bar()->problem().count(QStringLiteral("gone.png")), 1, 60'000);
    click("open-foreign-picture"); // it is in no folder of the file
    QTRY_COMPARE_WITH_TIMEOUT(view()->bar()->problem().count(QStringLiteral("gone.png")), 1, 60'000);
    QTRY_VERIFY(!view()->isPainted()); // nor is another picture shown in its place
    QVERIFY(support::button(*view()->bar(), "find-picture")->isVisible());
    QVERIFY(green.save(path));
    view()->usePicture(path); // found again, at the same place
    QTRY_VERIFY_WITH_TIMEOUT(view()->bar()->problem().isEmpty(), 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(view()->isPainted(), 60'000);
}

// The entry keeps the picture it has.
void TransformationWindowTest::aDamagedPictureIsNotTaken() {
    openFamily();
    QTRY_VERIFY_WITH_TIMEOUT(view()->isPainted(), 60'000);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("damaged.png"));
    QFile damaged(path);
    QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("no picture") > 0);
    damaged.close();
    const document::KeptTheft before = kept();
    const int count = steps();
    for (const QString& wrong : {path, folder.filePath(QStringLiteral("missing.png"))}) {
        view()->usePicture(wrong);
        QTRY_VERIFY_WITH_TIMEOUT(view()->bar()->problem().contains(QFileInfo(wrong).fileName()), 60'000);
        QVERIFY(kept() == before);
        QCOMPARE(steps(), count);
        QTRY_VERIFY_WITH_TIMEOUT(view()->isPainted(), 60'000);
        QVERIFY(support::backgroundRests()); // the picture before is there again
        QCOMPARE(view()->bar()->problem().count(QFileInfo(wrong).fileName()), 1);
    }
}

void TransformationWindowTest::otherNumbersAreDivided() {
    document::FractalFile file =
        io::readFractint("two {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n"
                         "three {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 1 0 .3\n .5 0 0 .5 0 1 .4\n}\n");
    document().setFile(std::move(file));
    toggle();
    QTRY_VERIFY_WITH_TIMEOUT(
        view()->bar()->problem() ==
            QStringLiteral("“two” and “three” must have the same number of active maps; they have 2 and 3."),
        60'000);
    QVERIFY(!canvas()->picture().isNull()); // the density
    click("divide-words");
    QCOMPARE(steps(), 1);
    for (const document::Entry& entry : document().file().entries)
        QCOMPARE(document::system2(*entry.fractal)->maps.size(), std::size_t(3));
    QTRY_VERIFY_WITH_TIMEOUT(view()->bar()->problem().isEmpty(), 60'000);
}

void TransformationWindowTest::theOrderIsKept() {
    openFamily();
    auto* list = view()->findChild<QListWidget*>();
    QCOMPARE(list->count(), 4);
    list->setCurrentRow(2);
    QTest::mouseClick(support::button(*view(), "up"), Qt::LeftButton);
    QCOMPARE(kept().order, (std::vector<std::size_t>{0, 2, 1, 3}));
    QCOMPARE(list->item(1)->text(), QStringLiteral("3"));
    document().undoStack()->undo();
    QVERIFY(kept().order.empty());
    QCOMPARE(list->item(1)->text(), QStringLiteral("2"));
}

void TransformationWindowTest::exportsThePicture() {
    toggle();
    QAbstractButton* button = support::button(*view()->bar(), "export");
    QTRY_VERIFY_WITH_TIMEOUT(!view()->bar()->problem().isEmpty(), 60'000);
    QVERIFY(!button->isEnabled()); // the flower and the maple: there is no transformation
    choose("triangle-family");
    QTRY_VERIFY_WITH_TIMEOUT(isPainted() && button->isEnabled(), 60'000);
    button->click();
    auto* dialog = m_window->findChild<view::TheftExportDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!dialog->preview().picture().isNull(), 60'000);
    const auto dialogs = [this] { return m_window->findChildren<view::TheftExportDialog*>().size(); };
    button->click(); // it is open already
    QCOMPARE(dialogs(), 1);
    canvas()->navigation().zoomBy(2); // another picture
    button->click();
    QCOMPARE(dialogs(), 2);
    delete m_window->findChildren<view::TheftExportDialog*>().last();
    QCOMPARE(m_window->findChild<view::TheftExportDialog*>(), dialog);
    dialog->sizeEditor().setPixels({600, 400});
    dialog->setSection(view::TheftExportDialog::Section::Attractor);

    const QTemporaryDir folder;
    QFile other(folder.filePath(QStringLiteral("stolen.jpg.png")));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("mine") == 4);
    other.close();
    dialog->exportTo(folder.filePath(QStringLiteral("stolen.jpg"))); // nobody was asked about the other
    QVERIFY2(dialog->message().contains(QStringLiteral(".png")), qPrintable(dialog->message()));
    QVERIFY(other.open(QIODevice::ReadOnly));
    QCOMPARE(other.readAll(), QByteArray("mine"));

    const QString path = folder.filePath(QStringLiteral("stolen.png"));
    QSignalSpy exported(dialog, &view::TheftExportDialog::exported);
    dialog->exportTo(path);
    QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, 60000);
    const QImage written(path);
    QCOMPARE(written.size(), QSize(600, 400));
    const QRect seen = coloured(written);
    QVERIFY(seen.height() > 330 && seen.height() < 370); // the whole triangle, with a margin of a twentieth
    dialog->exportTo(folder.filePath(QStringLiteral("absent/stolen.png")));
    QTRY_VERIFY_WITH_TIMEOUT(dialog->message().contains(QStringLiteral("absent")), 60'000);
    delete dialog;
}

// Once the file has a folder, it may move with its pictures.
void TransformationWindowTest::savingMakesPathsRelative() {
    openFamily();
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("sub")));
    QImage blue(40, 40, QImage::Format_RGB32);
    blue.fill(QColor(20, 60, 250));
    const QString path = folder.filePath(QStringLiteral("blue.png"));
    QVERIFY(blue.save(path));
    view()->usePicture(path);
    QTRY_COMPARE(kept().picture, path); // the file has no folder yet
    OpenFile file(&document(), m_window.get());
    const QString first = folder.filePath(QStringLiteral("a.ifs"));
    QVERIFY(!file.saveAs(first));
    QCOMPARE(kept().picture, QStringLiteral("blue.png"));
    QVERIFY(!document().isModified());
    QFile written(first);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(!written.readAll().contains(folder.path().toUtf8()));
    QVERIFY(!file.saveAs(folder.filePath(QStringLiteral("sub/b.ifs"))));
    QCOMPARE(kept().picture, QStringLiteral("../blue.png"));
    QVERIFY(file.saveAs(folder.filePath(QStringLiteral("absent/c.ifs"))));
    QCOMPARE(kept().picture, QStringLiteral("../blue.png")); // it was not saved
}

// What the shortcut says of an entry in space is not true of the next one.
void TransformationWindowTest::theShortcutSaysNothingStale() {
    document::Fractal solid;
    solid.name = QStringLiteral("solid");
    solid.shape = document::Shape<3>{systems::menger()};
    document::FractalFile file = document::fileOf(solid);
    document::FractalFile both = document().file();
    file.entries[0].id = document::freshId(both);
    const document::EntryId plane = document().currentId();
    both.entries << file.entries[0];
    document().editFile(QStringLiteral("add"), both, both.entries.last().id);
    QTest::keyClick(m_window.get(), Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("not a system in the plane")));
    document().setCurrent(plane);
    QVERIFY(m_window->statusBar()->currentMessage().isEmpty());
}

void TransformationWindowTest::everyModeIsKept() {
    openFamily();
    QComboBox* mode = nullptr;
    for (auto* box : view()->bar()->findChildren<QComboBox*>())
        if (box->accessibleName() == QStringLiteral("Mode")) mode = box;
    QVERIFY(mode);
    QImage before = canvas()->picture();
    for (const TheftMode wanted : {TheftMode::DeformationGrid, TheftMode::Reduce, TheftMode::StealColours}) {
        support::choose(mode, wanted);
        QCOMPARE(kept().mode, wanted);
        QTRY_VERIFY_WITH_TIMEOUT(canvas()->picture() != before, 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(points() >= pointsAtRest, 60'000);
        before = canvas()->picture();
    }
}

// One double click there.
void TransformationWindowTest::theCollectionShowsItWithItsPartner() {
    auto* panel = m_window->findChild<view::CollectionPanel*>();
    const io::CollectionTheme theme = io::readTheme(QStringLiteral(":/ifs_library/transformations.ifs"));
    const document::Fractal triangle = *theme.entries[0].fractal, moved = *theme.entries[1].fractal;
    emit panel->chosen({triangle, moved});
    QVERIFY(view()->isTransformationShown());
    QCOMPARE(document().file().entries.size(), 2);
    QCOMPARE(document().fractal().name, QStringLiteral("sunset_triangle"));
    QTRY_VERIFY_WITH_TIMEOUT(isPainted(), 60'000);
    QVERIFY2(view()->bar()->problem().isEmpty(), qPrintable(view()->bar()->problem()));
    // A second time, as entries of this file: the copies are partners of one another.
    emit panel->addRequested({triangle, moved});
    QCOMPARE(steps(), 1);
    QCOMPARE(document().file().entries.size(), 4);
    QCOMPARE(kept().partner, document().file().entries[3].fractal->name);
    QVERIFY(kept().partner != moved.name);
}

void TransformationWindowTest::aRenamedPartnerStays() {
    openFamily();
    auto* entries = m_window->findChild<view::EntriesPanel*>()->findChild<QListView*>();
    const int before = steps();
    QAbstractItemModel* model = entries->model();
    QVERIFY(model->setData(model->index(model->rowCount() - 1, 0), QStringLiteral("new-name")));
    QCOMPARE(steps(), before + 1);
    QCOMPARE(kept().partner, QStringLiteral("new-name"));
    QVERIFY(view()->bar()->problem().isEmpty());
    document().undoStack()->undo();
    QCOMPARE(kept().partner, QStringLiteral("triangle-moved"));
}

// Both draw on the same canvas. Steps from a letter are pictures from elsewhere, too.
void TransformationWindowTest::aConstructionEndsIt() {
    using Mode = view::Construction::Mode;
    auto* construction = m_window->findChild<view::Construction*>();
    const auto* render = m_window->findChild<view::RenderBridge*>();
    openFamily();
    const auto* bar = m_window->findChild<view::ConstructionBar*>();
    const auto press = [bar](Mode mode) { bar->findChild<QButtonGroup*>()->button(int(mode))->click(); };
    construction->steps().setStart(view::StepsBridge::Start::Letter);
    for (const Mode mode : {Mode::Steps, Mode::ChaosGame}) {
        press(mode);
        QVERIFY(construction->mode() == mode);
        QVERIFY(!view()->isTransformationShown());
        QVERIFY(m_window->statusBar()->currentMessage().startsWith(QStringLiteral("The fractal trans")));
        if (mode == Mode::ChaosGame) construction->setPoints(1000);
        QTRY_VERIFY_WITH_TIMEOUT(render->isCurrent(), 60'000);
        QCOMPARE(render->isSubstituted(), mode == Mode::Steps); // by the letter
        toggle();
        QVERIFY(view()->isTransformationShown() && construction->mode() == Mode::Density);
        QTRY_VERIFY_WITH_TIMEOUT(isStolen(), 60'000);
    }
    QVERIFY(construction->trail().empty());
    press(Mode::Density);
    QVERIFY(view()->isTransformationShown());
}

BARYCAGE_TEST(TransformationWindowTest, QApplication);
#include "transformation_window_test.moc"
