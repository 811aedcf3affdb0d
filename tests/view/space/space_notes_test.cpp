// SPDX-License-Identifier: MIT
#include "space/space_view.h"

#include "canvas/items/note_item.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QtTest>

using view::SpaceView;
using namespace space_window;

// What the window into space says about its picture.
class SpaceNotesTest : public QObject {
    Q_OBJECT

private slots:
    void notesLeaveTheBallFree();
    void whatIsProvedWaitsForNoPicture();
    void anEmptyViewSaysSo();
};

// Also in a view that is hardly wider than the ball.
void SpaceNotesTest::notesLeaveTheBallFree() {
    Window window;
    QVERIFY(window.rests());
    window.view->setTarget(SpaceView::Target::Definition);
    QVERIFY(!window.view->note().isEmpty());
    const auto isFree = [&] {
        for (const QGraphicsItem* item : window.view->scene()->items())
            if (const auto* note = dynamic_cast<const view::NoteItem*>(item))
                if (note->boundingRect().intersects(window.view->ball().boundingRect())) return false;
        return true;
    };
    for (const int width : {600, 330, 260}) {
        window.view->resize(width, 500);
        QTRY_COMPARE(window.camera().size.width, window.view->viewport()->width());
        QVERIFY2(isFree(), qPrintable(QString::number(width)));
    }
}

void SpaceNotesTest::whatIsProvedWaitsForNoPicture() {
    Window window;
    QVERIFY(window.rests());
    QVERIFY(window.view->note().isEmpty());
    document::Fractal fractal = window.document.fractal();
    document::system3(fractal)->maps[0].map.linear *= 3;
    window.document.edit(QStringLiteral("Expand"), fractal);
    QVERIFY(!window.bridge->isCurrent());
    QVERIFY2(window.view->note().contains(QStringLiteral("no attractor")), qPrintable(window.view->note()));
    QVERIFY(window.rests());
    QVERIFY(window.view->note().contains(QStringLiteral("no attractor")));
    window.document.undoStack()->undo();
    QVERIFY(!window.view->note().contains(QStringLiteral("attractor")));
}

void SpaceNotesTest::anEmptyViewSaysSo() {
    Window window;
    QVERIFY(window.rests());
    QVERIFY(window.view->note().isEmpty());
    attractor::OrbitCamera away = window.camera();
    away.target += ifs::Vector<3>(100, 100, 100);
    window.view->navigation().moveTo(away);
    QTRY_VERIFY2(window.view->note().startsWith(QStringLiteral("Nothing here.")),
                 qPrintable(window.view->note()));
    window.view->navigation().fit();
    QTRY_VERIFY2(window.view->note().isEmpty(), qPrintable(window.view->note()));
    document::Fractal cut = window.document.fractal();
    cut.inSpace.clip = attractor::SpaceClip{{0, 0, 1}, 50, HUGE_VAL}; // beyond all of it
    window.document.edit(QStringLiteral("Cut"), cut);
    QVERIFY(window.rests());
    QVERIFY2(window.view->note().isEmpty(), qPrintable(window.view->note()));
}

BARYCAGE_TEST(SpaceNotesTest, QApplication);
#include "space_notes_test.moc"
