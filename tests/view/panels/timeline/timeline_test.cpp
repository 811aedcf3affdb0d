// SPDX-License-Identifier: MIT
#include "document/edits/entries_edits.h"
#include "document/moments/animated_fractal.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "panels/timeline/ease_dialog.h"
#include "panels/timeline/motion_dialog.h"
#include "panels/timeline/motion_page.h"
#include "panels/timeline/space_tap.h"
#include "panels/timeline/timeline_panel.h"
#include "panels/timeline/track_view.h"
#include "panels/timeline/transport_bar.h"
#include "support/choose.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include <memory>

using view::TimelinePanel;
using view::TrackView;

// The timeline of one document, driven by the pointer and keys.
class TimelineTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init();
    void cleanup() { m_panel.reset(); }

    void motionsAreOfferedFirst();
    void aFirstKeyIsMade();
    void motionsAreSeenWhole();
    void oneClickMakesALoop();
    void motionsAreChanged();
    void slowMotionsLeaveTheWindowAtHand();
    void motionsAreShownMoving();
    void morphsAreEntriesOfTheirOwn();
    void diamondsMakeAndDeleteKeys();
    void theCameraIsKeyedInSpace();
    void theRulerIsScrubbed();
    void editsBecomeKeys();
    void keysAreDragged_data();
    void keysAreDragged();
    void bandsSelectAndKeysAreCopied();
    void aCustomEaseIsDrawn();
    void keysLeadOnSmoothly();
    void timingIsEdited();
    void playingEndsWhereTheLoopDoes();
    void theWheelZooms();
    void spaceTapsButDragsDoNot();
    void unreadableEntriesHaveNoRows();

private:
    view::Timeline& timeline() { return m_panel->timeline(); }
    TrackView& tracks() { return *m_panel->trackView(); }
    int steps() { return m_document->undoStack()->count(); }
    std::vector<int> framesOf(int row);
    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(tracks().viewport(), Qt::LeftButton, modifiers, at);
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void keyCageAt(const std::vector<int>& frames);

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<TimelinePanel> m_panel;
};

void TimelineTest::init() {
    m_document = std::make_unique<document::Document>();
    m_panel = std::make_unique<TimelinePanel>(m_document.get());
    m_panel->resize(900, 300);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
}

std::vector<int> TimelineTest::framesOf(int row) {
    std::vector<int> frames;
    for (const auto& key : timeline().tracks()[std::size_t(row)].keys)
        frames.push_back(key.frame);
    return frames;
}

void TimelineTest::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QWidget* viewport = tracks().viewport();
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton button) {
        QMouseEvent event(type, at, viewport->mapToGlobal(at), button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
        QApplication::sendEvent(viewport, &event);
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton);
    send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton);
    send(QEvent::MouseMove, to, Qt::NoButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton);
}

void TimelineTest::keyCageAt(const std::vector<int>& frames) {
    m_panel->showTracks();
    timeline().setRow(0);
    for (const int frame : frames) {
        timeline().setFrame(frame);
        timeline().keys().set();
    }
}

void TimelineTest::motionsAreOfferedFirst() {
    QVERIFY(!m_panel->showsTracks());
    QCOMPARE(m_panel->motions().size(), 7);
    const auto* page = m_panel->findChild<view::MotionPage*>();
    QCOMPARE(page->findChildren<QToolButton*>().size(), 7);
    m_panel->showTracks();
    QVERIFY(m_panel->showsTracks());
    QCOMPARE(timeline().rowCount(), 6);
    QCOMPARE(timeline().rowName(0), QStringLiteral("Cage"));
    QCOMPARE(timeline().rowName(2), QStringLiteral("Map 2"));
    QCOMPARE(timeline().rowName(5), QStringLiteral("Camera"));
    m_document->setFile(document::fileOf(document::sierpinskiTriangle())); // offered again
    QVERIFY(!m_panel->showsTracks());
}

void TimelineTest::aFirstKeyIsMade() {
    auto* keys = m_panel->findChild<view::MotionPage*>()->findChild<QPushButton*>();
    QVERIFY(keys);
    keys->click();
    QVERIFY(m_panel->showsTracks());
    QCOMPARE(framesOf(0), (std::vector<int>{0})); // of the cage
    QCOMPARE(steps(), 1);
    QCOMPARE(tracks().verticalScrollBar()->value(), 0);
}

void TimelineTest::motionsAreSeenWhole() {
    const auto* page = m_panel->findChild<view::MotionPage*>();
    const auto* keys = page->findChild<QPushButton*>();
    QVERIFY(keys);
    for (const int width : {1000, 700}) { // with and without a scroll bar
        m_panel->resize(width, m_panel->minimumSizeHint().height());
        QTRY_COMPARE(keys->visibleRegion().boundingRect(), keys->rect());
        QCOMPARE(m_panel->height(), m_panel->minimumSizeHint().height());
    }
}

void TimelineTest::oneClickMakesALoop() {
    for (QAction* action : m_panel->motions()) {
        if (action->property("isChoice").toBool()) continue;
        action->trigger();
        QCOMPARE(m_document->undoStack()->index(), 1);
        QVERIFY(timeline().timing().loop == animation::Loop::Cycle);
        QVERIFY(timeline().playback().isPlaying());
        QVERIFY(m_panel->showsTracks());
        QVERIFY(!timeline().isEmpty());
        timeline().playback().setPlaying(false);
        m_document->undoStack()->undo();
        QVERIFY(timeline().isEmpty());
    }
    QAction* breeze = m_panel->motions().front()->menu()->actions().front();
    tracks().setFixedHeight(90); // not all rows fit
    breeze->trigger();
    timeline().playback().setPlaying(false);
    QCOMPARE(timeline().motions().size(), std::size_t(1));
    QCOMPARE(timeline().rowName(6), QStringLiteral("Wind"));
    QCOMPARE(timeline().row(), 6);
    QVERIFY(tracks().keyPosition(0, 0).y() < 0);
    QVERIFY(tracks().viewport()->rect().contains(tracks().keyPosition(6, 0)));
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QVERIFY(timeline().motions().empty());
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Delete the motion “Wind”"));
}

// By a double click, live, and as one step of the history or none.
void TimelineTest::motionsAreChanged() {
    const auto strength = [this] { return document::motionNumbers(m_document->entryFractal(), 0)[0].value; };
    m_panel->motions().front()->menu()->actions().front()->trigger(); // Breeze
    timeline().playback().setPlaying(false);
    const document::Fractal start = m_document->entryFractal();
    const double before = strength();
    const auto doubleClicked = [this] {
        timeline().setRow(6);
        tracks().reveal();
        QTest::mouseDClick(tracks().viewport(), Qt::LeftButton, {}, tracks().keyPosition(6, 12));
        return m_panel->findChild<view::MotionDialog*>();
    };
    QPointer dialog = doubleClicked();
    QVERIFY(dialog);
    QCOMPARE(dialog->findChildren<QSpinBox*>().size(), 3); // cycles of its waves
    auto* field = dialog->findChild<QDoubleSpinBox*>();
    field->setValue(1.5);
    QCOMPARE(strength(), 1.5); // seen at once
    QCOMPARE(steps(), 1);
    dialog->reject();
    QTRY_VERIFY(!dialog);
    QTest::mouseRelease(tracks().viewport(), Qt::LeftButton); // the dialog came before it
    QCOMPARE(m_document->entryFractal(), start);
    QCOMPARE(steps(), 1);
    dialog = doubleClicked();
    dialog->findChildren<QSpinBox*>()[0]->setValue(3);
    QCOMPARE(strength(), before); // exactly, though the field is rounded
    dialog->findChild<QDoubleSpinBox*>()->setValue(2);
    dialog->accept();
    QTRY_VERIFY(!dialog);
    QTest::mouseRelease(tracks().viewport(), Qt::LeftButton);
    QCOMPARE(strength(), 2.0);
    QCOMPARE(document::motionNumbers(m_document->entryFractal(), 0)[1].value, 3.0);
    QCOMPARE(steps(), 2);
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Change the motion “Wind”"));
    m_document->undoStack()->undo();
    QCOMPARE(m_document->entryFractal(), start);
    m_panel->motions()[1]->trigger(); // Turn
    timeline().playback().setPlaying(false);
    timeline().setRow(7);
    QTest::keyClick(&tracks(), Qt::Key_Return);
    dialog = m_panel->findChild<view::MotionDialog*>();
    QVERIFY(dialog);
    auto* turns = dialog->findChild<QSpinBox*>();
    QCOMPARE(turns->value(), 1);
    turns->stepDown(); // never 0
    QCOMPARE(turns->value(), -1);
    QCOMPARE(document::motionNumbers(m_document->entryFractal(), 1)[0].value, -1.0);
    dialog->accept();
}

// A search that would take minutes runs beside the window, which says so and can end it.
void TimelineTest::slowMotionsLeaveTheWindowAtHand() {
    document::Fractal grid;
    document::Shape<2> shape;
    for (int i = 0; i < 1600; ++i)
        ifs::append(shape.system, ifs::affineMap(0.02, 0, 0, 0.02, i % 40 / 40.0, i / 40 / 40.0), 1);
    grid.shape = std::move(shape);
    m_document->setFile(document::fileOf(grid));
    bool wasShown = false;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] {
        if (auto* progress = m_panel->findChild<QProgressDialog*>()) {
            wasShown = progress->isVisible();
            progress->findChild<QPushButton*>()->click();
        }
    });
    timer.start(50);
    support::action(*m_panel, "zoom-in")->trigger();
    QVERIFY(wasShown);
    QCOMPARE(steps(), 0);
    QVERIFY(!timeline().playback().isPlaying());
    QVERIFY(m_panel->isVisible());
}

// Small pictures of the fractal as it would move, which differ from one moment to the next.
void TimelineTest::motionsAreShownMoving() {
    const auto* page = m_panel->findChild<view::MotionPage*>();
    QTRY_VERIFY(page->isMoving());
    for (auto* button : page->findChildren<QToolButton*>()) {
        if (button->defaultAction()->property("isChoice").toBool()) continue; // there is no other entry
        for (int change = 0; change < 2; ++change) { // the first may take the place of the icon
            const QImage before = button->icon().pixmap(button->iconSize()).toImage();
            QTRY_VERIFY2_WITH_TIMEOUT(button->icon().pixmap(button->iconSize()).toImage() != before,
                                      qPrintable(button->accessibleName()), 60'000);
        }
    }
    QVERIFY(m_document->undoStack()->count() == 0);
    m_panel->showTracks();
    QVERIFY(!page->isMoving()); // nobody looks
}

void TimelineTest::morphsAreEntriesOfTheirOwn() {
    document::Entry other;
    document::Fractal flat = document::sierpinskiTriangle();
    flat.name = QStringLiteral("other");
    document::plane(flat)->system.maps[0].map.linear *= 0.5;
    other.fractal = std::make_shared<const document::Fractal>(flat);
    document::Inserted added = document::inserted(m_document->file(), {other}, document::EntryId::None);
    m_document->editFile(QStringLiteral("Add"), added.file, m_document->currentId());
    const document::Fractal before = m_document->fractal();
    QMenu* entries = m_panel->motions().back()->menu();
    emit entries->aboutToShow();
    QCOMPARE(entries->actions().size(), 3); // then a line, and the dialog
    QCOMPARE(entries->actions().front()->text(), QStringLiteral("other"));
    entries->actions().front()->trigger();
    timeline().playback().setPlaying(false);
    QCOMPARE(m_document->file().entries.size(), 3);
    QVERIFY(document::animationFacts(m_document->entryFractal()));
    QVERIFY(timeline().timing().loop == animation::Loop::ThereAndBack);
    m_document->undoStack()->undo();
    QCOMPARE(m_document->fractal(), before);
}

void TimelineTest::diamondsMakeAndDeleteKeys() {
    m_panel->showTracks();
    timeline().setFrame(12);
    click(tracks().toggleOf(0));
    QCOMPARE(framesOf(0), (std::vector<int>{0, 12}));
    QCOMPARE(steps(), 1);
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Key of Cage (frame 12)"));
    click(tracks().toggleOf(0));
    QCOMPARE(framesOf(0), std::vector<int>{0});
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Delete keys"));
    QTest::keyClick(&tracks(), Qt::Key_Down);
    QTest::keyClick(&tracks(), Qt::Key_Return); // the same by keys, in the next row
    QCOMPARE(framesOf(1), (std::vector<int>{0, 12}));
    timeline().setFrame(6);
    timeline().keys().setInAll();
    QCOMPARE(framesOf(0), (std::vector<int>{0, 6}));
    QCOMPARE(framesOf(1), (std::vector<int>{0, 6, 12}));
    QVERIFY(framesOf(2).empty());
}

void TimelineTest::theCameraIsKeyedInSpace() {
    document::Fractal solid;
    solid.name = QStringLiteral("solid");
    ifs::append<3>(solid.shape.emplace<document::Shape<3>>().system,
                   {0.5 * ifs::Matrix<3>::Identity(), ifs::Vector<3>(1, 0, 0)}, 1);
    m_document->setFile(document::fileOf(solid));
    const document::Fractal before = m_document->entryFractal();
    attractor::OrbitCamera seen;
    seen.target = {0.1, 1. / 3, -2};
    seen.orientation = attractor::orbit(33.3, -12.7, 5);
    seen.height = 2. / 7;
    seen.fieldOfView = 35.5;
    seen.projection = attractor::OrbitCamera::Projection::Perspective;
    timeline().setCameraSource([&seen] { return document::SeenCamera(seen); });
    m_panel->showTracks();
    const int row = timeline().rowCount() - 1;
    QCOMPARE(timeline().rowName(row), QStringLiteral("Camera"));
    timeline().setFrame(12);
    click(tracks().toggleOf(row));
    QCOMPARE(framesOf(row), (std::vector<int>{0, 12}));
    QCOMPARE(steps(), 1);
    const attractor::OrbitCamera first = seen;
    seen.height = 5;
    timeline().setFrame(24);
    timeline().setRow(row);
    timeline().keys().set();
    QCOMPARE(framesOf(row), (std::vector<int>{0, 12, 24}));
    QCOMPARE(steps(), 2);

    const document::FractalFile read = io::readFractint(io::writeFractint(m_document->file()));
    QCOMPARE(read.entries.size(), 1);
    QVERIFY(read.entries.front().problems.isEmpty());
    const document::Fractal& again = *read.entries.front().fractal;
    QVERIFY(document::frameAt(again, animation::moment(12)).camera == first);
    QVERIFY(document::frameAt(again, animation::moment(24)).camera == seen);
    m_document->undoStack()->undo();
    QCOMPARE(framesOf(row), (std::vector<int>{0, 12}));
    m_document->undoStack()->undo();
    QVERIFY(framesOf(row).empty());
    QCOMPARE(m_document->entryFractal(), before);
}

void TimelineTest::theRulerIsScrubbed() {
    m_panel->showTracks();
    QSignalSpy changes(m_document.get(), &document::Document::changed);
    drag(tracks().rulerPosition(3), tracks().rulerPosition(20));
    QCOMPARE(timeline().frame(), 20);
    QCOMPARE(m_document->moment(), animation::moment(20));
    QCOMPARE(m_panel->transport()->frame()->value(), 20);
    QVERIFY(changes.size() >= 2);
    QCOMPARE(steps(), 0);
    QTest::keyClick(&tracks(), Qt::Key_Period);
    QCOMPARE(timeline().frame(), 21);
    QTest::keyClick(&tracks(), Qt::Key_Comma);
    QTest::keyClick(&tracks(), Qt::Key_Left);
    QCOMPARE(timeline().frame(), 19);
    QTest::keyClick(&tracks(), Qt::Key_Home);
    QCOMPARE(timeline().frame(), 0);
    QTest::keyClick(&tracks(), Qt::Key_End);
    QCOMPARE(timeline().frame(), 48);
    drag(tracks().rulerPosition(3), {5000, 4}); // beyond the end
    QCOMPARE(timeline().frame(), 48);
}

void TimelineTest::editsBecomeKeys() {
    keyCageAt({0});
    const document::Fractal start = m_document->fractal();
    timeline().setFrame(24);
    document::Fractal after = m_document->fractal();
    document::plane(after)->cage->current[0].x() -= 0.5;
    m_document->edit(QStringLiteral("Move"), after);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 24}));
    timeline().setFrame(0);
    QCOMPARE(m_document->fractal(), start);
    timeline().setFrame(24);
    QCOMPARE(m_document->fractal(), after);
    QTest::keyClick(&tracks(), Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(timeline().frame(), 0);
    QTest::keyClick(&tracks(), Qt::Key_Period, Qt::ControlModifier);
    QCOMPARE(timeline().frame(), 24);
}

void TimelineTest::keysAreDragged_data() {
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<std::vector<int>>("frames");
    QTest::newRow("plain") << Qt::KeyboardModifiers() << std::vector<int>{0, 18, 20};
    QTest::newRow("with later ones") << Qt::KeyboardModifiers(Qt::AltModifier) << std::vector<int>{0, 18, 28};
    QTest::newRow("copied") << Qt::KeyboardModifiers(Qt::ControlModifier) << std::vector<int>{0, 10, 18, 20};
}

void TimelineTest::keysAreDragged() {
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(std::vector<int>, frames);
    keyCageAt({10, 20});
    timeline().select({});
    const int before = steps();
    const document::Fractal stored = m_document->entryFractal();
    drag(tracks().keyPosition(0, 10), tracks().keyPosition(0, 18), modifiers);
    QCOMPARE(framesOf(0), frames);
    QCOMPARE(steps(), before + 1);
    m_document->undoStack()->undo();
    QCOMPARE(m_document->entryFractal(), stored);
}

void TimelineTest::bandsSelectAndKeysAreCopied() {
    keyCageAt({10, 20});
    timeline().select({});
    drag(tracks().keyPosition(0, 4) + QPoint(0, -8), tracks().keyPosition(1, 24));
    QCOMPARE(timeline().selected().size(), std::size_t(2));
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    timeline().setFrame(30);
    QSignalSpy told(&timeline(), &view::Timeline::message);
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 10, 20, 30, 40}));
    QCOMPARE(told.size(), 0);
    QCOMPARE(timeline().selected().size(), std::size_t(2));
    timeline().keys().setEase({animation::Ease::Kind::Hold});
    QVERIFY(timeline().tracks()[0].keys[3].ease.kind == animation::Ease::Kind::Hold);
    QVERIFY(timeline().tracks()[0].keys[0].ease.kind == animation::Ease::Kind::Both);
    QTest::keyClick(&tracks(), Qt::Key_Delete);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 10, 20}));
    QTest::keyClick(&tracks(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(timeline().selected().size(), std::size_t(3));
    QTest::keyClick(&tracks(), Qt::Key_Escape);
    QVERIFY(timeline().selected().empty());
}

void TimelineTest::aCustomEaseIsDrawn() {
    keyCageAt({0, 24});
    timeline().select({{timeline().tracks()[0].track, 0}});
    view::EaseDialog dialog(timeline().keys().ease());
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    view::EaseCurve* curve = dialog.curve();
    const QPoint start = curve->handle(0).toPoint();
    QTest::mousePress(curve, Qt::LeftButton, {}, start);
    QTest::mouseMove(curve, start + QPoint(40, -10));
    QTest::mouseRelease(curve, Qt::LeftButton, {}, start + QPoint(40, -10));
    const animation::Ease drawn = dialog.ease();
    QVERIFY(animation::isValid(drawn) && drawn.kind == animation::Ease::Kind::Cubic);
    QVERIFY((curve->handle(0) - start - QPointF(40, -10)).manhattanLength() < 3);
    for (auto* number : dialog.findChildren<QDoubleSpinBox*>())
        if (number->accessibleName() == QStringLiteral("Time of the first handle"))
            QVERIFY(std::abs(number->value() - drawn.x1) < 1e-3);
    timeline().keys().setEase(drawn);
    QVERIFY(timeline().keys().ease() == drawn);
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Ease of keys (frame 0)"));
    timeline().selectAll();
    timeline().keys().setEase({animation::Ease::Kind::Hold});
    QCOMPARE(m_document->undoStack()->undoText(), QStringLiteral("Ease of keys (frames 0–24)"));
}

void TimelineTest::keysLeadOnSmoothly() {
    keyCageAt({0, 24});
    timeline().setFrame(0);
    const auto lookOfKey = [this] {
        const QPoint at = tracks().keyPosition(0, 24);
        return tracks().viewport()->grab(QRect(at - QPoint(7, 7), QSize(15, 15))).toImage();
    };
    timeline().select({});
    const QImage diamond = lookOfKey();
    QTest::keyClick(&tracks(), Qt::Key_A, Qt::ControlModifier);
    const auto chosen = [this] {
        const QPoint at = tracks().keyPosition(0, 24);
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, tracks().viewport()->mapToGlobal(at));
        QApplication::sendEvent(tracks().viewport(), &event);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        for (QAction* action : menu->actions())
            if (action->objectName() == QStringLiteral("smooth")) return std::pair(menu, action);
        return std::pair(menu, static_cast<QAction*>(nullptr));
    };
    const auto [menu, action] = chosen();
    QVERIFY(action && !action->isChecked());
    action->trigger();
    menu->close();
    for (const auto& key : timeline().tracks()[0].keys)
        QVERIFY(key.ease.kind == animation::Ease::Kind::Smooth);
    const auto [again, ticked] = chosen();
    QVERIFY(ticked->isChecked());
    again->close();
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    timeline().select({});
    QVERIFY(lookOfKey() != diamond);
    timeline().setFrame(30);
    QSignalSpy told(&timeline(), &view::Timeline::message);
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(framesOf(0), (std::vector<int>{0, 24, 30}));
    QCOMPARE(told.size(), 1); // the second one would be at frame 54 of 48
    QVERIFY(timeline().tracks()[0].keys[2].ease.kind == animation::Ease::Kind::Smooth);
}

void TimelineTest::timingIsEdited() {
    keyCageAt({40});
    const view::TransportBar& bar = *m_panel->transport();
    const int before = steps();
    QSignalSpy told(&timeline(), &view::Timeline::message);
    bar.length()->setValue(30);
    QCOMPARE(told.size(), 1); // a key is gone
    bar.rate()->setCurrentText(QStringLiteral("12"));
    QTest::keyClick(bar.rate()->lineEdit(), Qt::Key_Return);
    QCOMPARE(told.size(), 1);
    support::choose(bar.loop(), animation::Loop::Cycle);
    QCOMPARE(steps(), before + 3);
    QCOMPARE(timeline().timing(), (document::Timing{{12, 1}, 30, animation::Loop::Cycle}));
    QCOMPARE(framesOf(0), std::vector<int>{0});
    QCOMPARE(timeline().lastFrame(), 29);
    QCOMPARE(timeline().frame(), 29); // the playhead came along
    m_document->undoStack()->undo();
    QCOMPARE(view::chosenValue<animation::Loop>(bar.loop()), animation::Loop::Off);
}

void TimelineTest::playingEndsWhereTheLoopDoes() {
    timeline().setTiming(QStringLiteral("fast"), {{240, 1}, 12, animation::Loop::Off});
    QTest::keyClick(&tracks(), Qt::Key_Space);
    QTRY_VERIFY(!timeline().playback().isPlaying());
    QCOMPARE(timeline().frame(), 12);
    timeline().playback().setPlaying(true); // from the beginning
    QVERIFY(timeline().playback().isPlaying());
    timeline().setTiming(QStringLiteral("back"), {{240, 1}, 12, animation::Loop::ThereAndBack});
    QTRY_VERIFY(timeline().playback().position() > 12); // on its way back
    m_document->setFile(document::fileOf(document::sierpinskiTriangle()));
    QVERIFY(!timeline().playback().isPlaying());
}

void TimelineTest::theWheelZooms() {
    m_panel->showTracks();
    const double before = tracks().pixelsPerFrame();
    const QPoint at = tracks().rulerPosition(24);
    QWheelEvent turn(at, tracks().viewport()->mapToGlobal(at), {}, {0, 480}, Qt::NoButton,
                     Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(tracks().viewport(), &turn);
    QVERIFY(qFuzzyCompare(tracks().pixelsPerFrame(), 2 * before));
    QVERIFY((tracks().rulerPosition(24) - at).manhattanLength() <= 2); // what is under the pointer stays
    tracks().fitLength();
    QCOMPARE(tracks().pixelsPerFrame(), before);
}

void TimelineTest::spaceTapsButDragsDoNot() {
    view::SpaceTap tap(&tracks());
    QSignalSpy tapped(&tap, &view::SpaceTap::tapped);
    QTest::keyPress(&tracks(), Qt::Key_Space);
    QTest::keyRelease(&tracks(), Qt::Key_Space);
    QTRY_COMPARE(tapped.size(), 1);
    QTest::keyPress(&tracks(), Qt::Key_Space);
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, {}, {4, 200});
    QTest::keyRelease(&tracks(), Qt::Key_Space);
    QCoreApplication::processEvents();
    QCOMPARE(tapped.size(), 1);
}

void TimelineTest::unreadableEntriesHaveNoRows() {
    document::Fractal unread;
    unread.name = QStringLiteral("unread");
    m_document->setFile(document::fileOf(unread));
    m_panel->showTracks();
    QCOMPARE(timeline().rowCount(), 0);
    QVERIFY(!m_panel->transport()->isEnabled());
    const auto before = m_document->file();
    timeline().keys().set();
    timeline().keys().setInAll();
    timeline().keys().paste();
    timeline().keys().remove();
    timeline().stepToKey(1);
    QTest::keyClick(&tracks(), Qt::Key_Return);
    click({5, 60});
    QVERIFY(m_document->file() == before);
    for (const QAction* action : m_panel->motions())
        QVERIFY(!action->isEnabled());
}

BARYCAGE_TEST(TimelineTest, QApplication);
#include "timeline_test.moc"
