// SPDX-License-Identifier: MIT
#include "app/gui/session_fixture.h"
#include "session/window_place.h"
#include "support/forget_settings.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QFileInfo>
#include <QScreen>
#include <QStatusBar>
#include <QTemporaryDir>

#include <algorithm>

// Where new windows go: on the screen, and not exactly where another one is; and none for what has one.
class WindowPlaceTest : public SessionFixture {
    Q_OBJECT

private slots:
    void aFreePlaceIsKept();
    void titleBarsOfOthersStayInSight();
    void allOfItIsOnTheScreen_data();
    void allOfItIsOnTheScreen();
    void aSizeThatWasChosenIsKept();
    void aWindowThatFillsTheScreenBecomesSmaller();
    void afterTheLastPlaceTheyCoverEachOther();
    void recoveredWindowsAreApart();
    void aFileThatIsOpenIsShownInItsWindow();

private:
    static constexpr QRect room{0, 24, 1920, 1056};
    static constexpr QSize least{800, 600};
};

void WindowPlaceTest::aFreePlaceIsKept() {
    const QRect wanted(100, 80, 1200, 800);
    QCOMPARE(placeBeside(wanted, {}, room, least), wanted);
    QCOMPARE(placeBeside(wanted, {QRect(400, 80, 1200, 800)}, room, least), wanted);
}

void WindowPlaceTest::titleBarsOfOthersStayInSight() {
    QList<QRect> places;
    for (int i = 0; i < 12; ++i) {
        const QRect place = placeBeside(QRect(300, 100, 1200, 800), places, room, least);
        QVERIFY(room.contains(place));
        QCOMPARE(place.size(), QSize(1200, 800)); // there is room enough
        for (const QRect& other : places)
            QVERIFY((place.topLeft() - other.topLeft()).manhattanLength() >= 32);
        places << place;
    }
}

void WindowPlaceTest::allOfItIsOnTheScreen_data() {
    QTest::addColumn<QRect>("wanted");
    QTest::newRow("beyond the right") << QRect(1500, 100, 1200, 800);
    QTest::newRow("below the bottom") << QRect(100, 700, 1200, 800);
    QTest::newRow("under the title bar") << QRect(0, 0, 1200, 800);
    QTest::newRow("on a screen that has gone") << QRect(-2000, -300, 1200, 800);
}

void WindowPlaceTest::allOfItIsOnTheScreen() {
    QFETCH(const QRect, wanted);
    QList<QRect> places;
    for (int i = 0; i < 3; ++i) {
        places << placeBeside(wanted, places, room, least);
        QVERIFY(room.contains(places.last()));
        QVERIFY(places.indexOf(places.last()) == i);
    }
}

// As it was left: the toolkit knows best whether the screen was another one.
void WindowPlaceTest::aSizeThatWasChosenIsKept() {
    const QRect place = placeBeside(QRect(50, 50, 4000, 800), {}, room, least);
    QCOMPARE(place, QRect(0, 50, 4000, 800));
    QVERIFY(room.contains(placeBeside(place, {place}, room, least)));
}

void WindowPlaceTest::aWindowThatFillsTheScreenBecomesSmaller() {
    const QRect place = placeBeside(room, {room}, room, least);
    QCOMPARE(place.topLeft(), room.topLeft() + QPoint(32, 32));
    QCOMPARE(place.bottomRight(), room.bottomRight());
}

void WindowPlaceTest::afterTheLastPlaceTheyCoverEachOther() {
    QCOMPARE(placeBeside(room, {room}, room, room.size()), room);
}

// As after a crash in the first session: nothing is stored, and no window is active yet.
void WindowPlaceTest::recoveredWindowsAreApart() {
    support::forgetSettings();
    const QRect available = QGuiApplication::primaryScreen()->availableGeometry();
    for (const char* name : {"first", "second", "third"}) {
        auto* window = new MainWindow;
        window->show();
        window->openRecovered({{}, {{}, QLatin1String(name), 0, {}, "a { .5 0 0 .5 0 0 1 }\n", {}}, {}});
        QVERIFY(available.contains(window->geometry().topLeft()));
    }
    const QList<SessionWindow*> shown = windows();
    QCOMPARE(shown.size(), 3);
    for (const SessionWindow* a : shown)
        for (const SessionWindow* b : shown)
            QVERIFY(a == b || (a->pos() - b->pos()).manhattanLength() >= 32);
}

// Under any of its names: as a recent file, once more on the command line, or dropped.
void WindowPlaceTest::aFileThatIsOpenIsShownInItsWindow() {
    const QTemporaryDir folder;
    const QString good = support::testData(QStringLiteral("shapes.ifs"));
    const QString link = folder.filePath(QStringLiteral("link.ifs"));
    QVERIFY(QFile::link(good, link));
    MainWindow* first = shown(good);
    MainWindow* second = shown({});
    document::Fractal renamed = second->document().fractal();
    renamed.name = QStringLiteral("mine");
    second->document().edit(QStringLiteral("rename"), renamed); // nothing is asked about it
    for (const QString& path : {good, link}) {
        second->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(second));
        second->openRecent(path);
        QTRY_VERIFY(first->isActiveWindow());
        QCOMPARE(first->statusBar()->currentMessage(),
                 QFileInfo(path).fileName() + QStringLiteral(" is already open in this window."));
        QVERIFY(second->path().isEmpty());
        QCOMPARE(second->document().fractal().name, QStringLiteral("mine"));
    }
    first->showMinimized();
    MainWindow::openEach({good, good});
    QCOMPARE(windows().size(), 2);
    QVERIFY(!first->isMinimized());
    first->openRecent(good); // reads it again
    QVERIFY(!first->statusBar()->currentMessage().contains(QStringLiteral("already")));
}

BARYCAGE_TEST(WindowPlaceTest, QApplication);
#include "window_place_test.moc"
