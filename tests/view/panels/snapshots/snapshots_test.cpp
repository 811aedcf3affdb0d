// SPDX-License-Identifier: MIT
#include "panels/snapshots/snapshots.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/dimension_edits.h"
#include "document/edits/entries_edits.h"
#include "document/saved_views.h"
#include "io/fractint/fractint_reader.h"
#include "panels/snapshots/snapshot_look.h"
#include "panels/snapshots/snapshots_panel.h"
#include "space/four_views.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QAction>
#include <QSignalSpy>
#include <QTimer>

using document::Fractal;

// Snapshots of an entry, and what the canvas shows during a look at one.
class SnapshotsTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() {
        open();
        m_solid = std::make_unique<view::SolidBridge>(m_document.get());
        m_space = std::make_unique<view::FourViews>(m_document.get(), m_solid.get());
        m_snapshots = std::make_unique<view::Snapshots>(m_document.get());
        m_look = std::make_unique<view::SnapshotLook>(
            m_document.get(), m_snapshots.get(),
            view::SnapshotLook::Canvases{m_canvas.get(), m_bridge.get(), m_space.get(),
                                         [this] { return m_obstacle; }});
        m_obstacle.clear();
    }
    void cleanup() {
        m_look.reset();
        m_snapshots.reset();
        m_space.reset();
        m_solid.reset();
        close();
    }

    void oneStepRestores();
    void nameAndCommentsStay();
    void theSameStateIsKeptOnce();
    void deletedOnesComeBack();
    void everyEntryHasItsOwn();
    void anotherEntryOfTheSameIdHasNone();
    void anEntryIsAdded();
    void whatIsLostIsNamed();
    void thoseOfDeletedEntriesAreLostToo();
    void whatDiscardingLosesIsNamed();
    void anUnreadableEntryHasNone();
    void aLookChangesNothing();
    void aHeldKeyEndsItsLook();
    void anEditEndsTheLook();
    void whatCannotBeLookedAtSaysSo();
    void aSolidIsLookedAt();
    void thePanelFollows();
    void theSelectedOneIsCompared();

private:
    void scale(double factor) {
        Fractal after = m_document->fractal();
        document::system2(after)->maps[0].map.linear *= factor;
        m_document->edit(QStringLiteral("Scale"), after);
    }
    quint64 key(int index) const { return m_snapshots->list().at(std::size_t(index)).key; }
    QStringList names() const {
        QStringList names;
        for (const view::Snapshot& snapshot : m_snapshots->list())
            names << snapshot.name;
        return names;
    }
    QImage picture() const { return m_canvas->picture(); }
    void awaitPicture() const { QTRY_VERIFY(m_bridge->isCurrent()); }
    QString said(const std::function<void()>& action) const {
        QSignalSpy spy(m_look.get(), &view::SnapshotLook::message);
        action();
        return spy.isEmpty() ? QString() : spy.last().first().toString();
    }

    std::unique_ptr<view::SolidBridge> m_solid;
    std::unique_ptr<view::FourViews> m_space;
    std::unique_ptr<view::Snapshots> m_snapshots;
    std::unique_ptr<view::SnapshotLook> m_look;
    QString m_obstacle;
};

void SnapshotsTest::oneStepRestores() {
    const Fractal first = m_document->fractal();
    m_snapshots->take();
    QCOMPARE(steps(), 0);
    QVERIFY(!m_document->isModified());
    QVERIFY(m_snapshots->present() == key(0));
    scale(0.8);
    Fractal second = m_document->fractal();
    second.appearance.gamma = 1.5;
    m_document->edit(QStringLiteral("Gamma"), second);
    QVERIFY(!m_snapshots->present());
    m_snapshots->take();
    QCOMPARE(names(), (QStringList{QStringLiteral("Snapshot 1"), QStringLiteral("Snapshot 2")}));
    m_snapshots->restore(key(0));
    QVERIFY(m_document->fractal() == first);
    QCOMPARE(steps(), 3);
    QCOMPARE(undoText(), QStringLiteral("Restore “Snapshot 1”"));
    QVERIFY(m_snapshots->present() == key(0));
    m_snapshots->restore(key(0)); // it is as it was: no step
    QCOMPARE(steps(), 3);
    m_document->undoStack()->undo();
    QVERIFY(m_document->fractal() == second);
    QVERIFY(m_snapshots->present() == key(1));
}

void SnapshotsTest::nameAndCommentsStay() {
    m_snapshots->take();
    Fractal after = m_document->fractal();
    after.name = QStringLiteral("renamed");
    after = document::withSavedView(after, {QStringLiteral("tip"), attractor::View{{0, 0}, 1}});
    m_document->edit(QStringLiteral("Name"), after);
    QVERIFY(m_snapshots->present() == key(0)); // nothing of the fractal has changed
    scale(0.8);
    m_snapshots->restore(key(0));
    QVERIFY(m_document->fractal() == after);
}

void SnapshotsTest::theSameStateIsKeptOnce() {
    m_snapshots->take();
    scale(0.8);
    m_snapshots->take();
    m_document->undoStack()->undo();
    m_snapshots->take();
    QCOMPARE(names().size(), 2);
    QCOMPARE(m_snapshots->marked()->key, key(0)); // it is the one to compare with now
}

void SnapshotsTest::deletedOnesComeBack() {
    for (const double factor : {0.9, 0.8, 0.7}) {
        scale(factor);
        m_snapshots->take();
    }
    const quint64 second = key(1), third = key(2);
    m_snapshots->rename(second, QStringLiteral("  the  second "));
    m_snapshots->rename(third, QStringLiteral("  "));
    QCOMPARE(names().at(2), QStringLiteral("Snapshot 3"));
    m_snapshots->remove(third);
    QCOMPARE(m_snapshots->marked()->key, second);
    m_snapshots->remove(second);
    QCOMPARE(names(), QStringList{QStringLiteral("Snapshot 1")});
    QCOMPARE(m_snapshots->removed(), QStringLiteral("the second"));
    m_snapshots->bringBack();
    m_snapshots->bringBack();
    m_snapshots->bringBack();
    QCOMPARE(names(), (QStringList{QStringLiteral("Snapshot 1"), QStringLiteral("the second"),
                                   QStringLiteral("Snapshot 3")}));
    QCOMPARE(steps(), 3);
}

void SnapshotsTest::everyEntryHasItsOwn() {
    m_document->setFile(io::readFractint("a { .5 0 0 .5 0 0 1 }\nb { .4 0 0 .4 0 0 1 }\n"));
    const auto a = m_document->file().entries[0].id, b = m_document->file().entries[1].id;
    m_snapshots->take();
    scale(0.8);
    m_document->setCurrent(b);
    QVERIFY(names().isEmpty());
    QVERIFY(!m_snapshots->marked());
    m_snapshots->take();
    QCOMPARE(names(), QStringList{QStringLiteral("Snapshot 1")});
    m_snapshots->restore(key(0));
    QVERIFY(document::system2(m_document->fractal())->maps[0].map.linear(0, 0) == .4);
    m_document->setCurrent(a);
    QVERIFY(document::system2(*m_snapshots->list()[0].fractal)->maps[0].map.linear(0, 0) == .5);
    m_document->setFile(io::readFractint("c { .5 0 0 .5 0 0 1 }\n"));
    QVERIFY(names().isEmpty());
}

void SnapshotsTest::anotherEntryOfTheSameIdHasNone() {
    m_document->setFile(io::readFractint("a { .5 0 0 .5 0 0 1 }\nb { .4 0 0 .4 0 0 1 }\n"));
    const auto b = m_document->file().entries[1].id;
    m_document->setCurrent(b);
    m_snapshots->take();
    m_document->editFile(QStringLiteral("Delete"), document::removed(m_document->file(), {b}));
    QVERIFY(names().isEmpty());
    document::Entry entry;
    entry.fractal = std::make_shared<const Fractal>(document::sierpinskiTriangle());
    const auto inserted = document::inserted(m_document->file(), {entry}, document::EntryId::None);
    QCOMPARE(inserted.ids.first(), b); // or this test shows nothing
    m_document->editFile(QStringLiteral("Add"), inserted.file, b);
    QCOMPARE(m_document->currentId(), b);
    QVERIFY(names().isEmpty());
    m_document->undoStack()->undo();
    m_document->undoStack()->undo();
    QCOMPARE(m_document->fractal().name, QStringLiteral("b"));
    QCOMPARE(names(), QStringList{QStringLiteral("Snapshot 1")});
}

void SnapshotsTest::anEntryIsAdded() {
    const auto current = m_document->currentId();
    const QString name = m_document->fractal().name;
    const Fractal first = m_document->fractal();
    m_snapshots->take();
    scale(0.8);
    m_snapshots->addAsEntry(key(0));
    QCOMPARE(m_document->file().entries.size(), 2);
    QCOMPARE(m_document->currentId(), current);
    QVERIFY(m_document->file().entries[1].fractal->shape == first.shape);
    QVERIFY(m_document->file().entries[1].fractal->name != name);
    QCOMPARE(steps(), 2);
    m_snapshots->rename(key(0), QStringLiteral("leaning to {the} left"));
    m_snapshots->addAsEntry(key(0));
    QVERIFY2(m_document->file().entries[1].fractal->name.startsWith(QStringLiteral("leaning")),
             qPrintable(m_document->file().entries[1].fractal->name));
    QCOMPARE(names().size(), 1);
}

// Those that are in the file already, as they are, are not lost with it.
void SnapshotsTest::whatIsLostIsNamed() {
    m_snapshots->take();
    QVERIFY(m_snapshots->unsaved().isEmpty()); // it is the entry
    scale(0.8);
    const QStringList lost = m_snapshots->unsaved();
    QCOMPARE(lost.size(), 1);
    QVERIFY(lost.first().contains(QStringLiteral("Snapshot 1")));
    QVERIFY(lost.first().contains(m_document->fractal().name));
    m_snapshots->addAsEntry(key(0));
    QVERIFY(m_snapshots->unsaved().isEmpty());
    m_document->undoStack()->undo();
    QCOMPARE(m_snapshots->unsaved().size(), 1);
    m_document->undoStack()->undo();
    QVERIFY(m_snapshots->unsaved().isEmpty());
}

void SnapshotsTest::thoseOfDeletedEntriesAreLostToo() {
    m_snapshots->take();
    scale(0.8);
    m_snapshots->addAsEntry(key(0));
    scale(0.8);
    m_snapshots->take();
    document::FractalFile file = m_document->file();
    file.entries.removeFirst();
    m_document->editFile(QStringLiteral("Delete"), file, file.entries.first().id);
    QVERIFY(names().isEmpty());
    const QStringList lost = m_snapshots->unsaved(); // the first one is an entry of its own
    QCOMPARE(lost.size(), 1);
    QVERIFY2(lost.first().contains(QStringLiteral("Snapshot 2")), qPrintable(lost.first()));
    m_document->undoStack()->undo();
    QVERIFY(m_snapshots->unsaved().isEmpty());
}

// The one that is like the fractal as it is now is saved with it, or is lost with it.
void SnapshotsTest::whatDiscardingLosesIsNamed() {
    m_snapshots->take(); // as in the file
    scale(0.8);
    m_snapshots->take();
    QCOMPARE(m_snapshots->unsaved().size(), 1);
    const QStringList discarded = m_snapshots->lostByDiscarding();
    QCOMPARE(discarded.size(), 1);
    QVERIFY2(discarded.first().contains(QStringLiteral("Snapshot 2")), qPrintable(discarded.first()));
    m_document->undoStack()->setClean(); // saved
    QVERIFY(m_snapshots->lostByDiscarding().isEmpty());
    QCOMPARE(m_snapshots->unsaved().size(), 1);
    scale(0.8);
    QCOMPARE(m_snapshots->unsaved().size(), 2);
    QVERIFY(m_snapshots->lostByDiscarding().isEmpty());
}

void SnapshotsTest::anUnreadableEntryHasNone() {
    m_document->setFile(io::readFractint("broken { .5 0 0 }\n"));
    QCOMPARE(document::dimension(m_document->fractal()), 0);
    QSignalSpy said(m_snapshots.get(), &view::Snapshots::message);
    m_snapshots->take();
    QCOMPARE(said.size(), 1);
    QVERIFY(names().isEmpty());
    m_document->setFile({});
    m_snapshots->take();
    QVERIFY(names().isEmpty());
}

void SnapshotsTest::aLookChangesNothing() {
    awaitPicture();
    m_snapshots->take();
    scale(0.5);
    awaitPicture();
    const auto now = m_document->sharedFractal();
    const auto camera = m_canvas->camera();
    const auto revision = m_document->revision();
    const auto before = picture();
    QCOMPARE(said([&] { m_look->toggle(); }),
             QStringLiteral("This is “Snapshot 1”. Esc returns to the fractal."));
    QVERIFY(m_look->isOn());
    QCOMPARE(m_look->shown()->name, QStringLiteral("Snapshot 1"));
    QVERIFY(!m_canvas->options().overlaysVisible());
    awaitPicture();
    QVERIFY(picture() != before);
    m_canvas->navigation().zoomBy(2); // one looks closer
    awaitPicture();
    m_look->toggle();
    QVERIFY(!m_look->isOn());
    QVERIFY(m_canvas->options().overlaysVisible());
    m_canvas->navigation().moveTo(camera);
    awaitPicture();
    QVERIFY(m_document->sharedFractal() == now); // the same object
    QCOMPARE(m_document->revision(), revision);
    QCOMPARE(steps(), 1);

    m_canvas->options().setOverlaysVisible(false);
    m_look->toggle();
    m_look->toggle();
    QVERIFY(!m_canvas->options().overlaysVisible()); // as it was
}

// The server repeats a held key as a release and a press; Qt does not tell where it reads them one by one.
void SnapshotsTest::aHeldKeyEndsItsLook() {
    m_snapshots->take();
    scale(0.8);
    const auto comesUp = [this] {
        QKeyEvent event(QEvent::KeyRelease, Qt::Key_Q, Qt::NoModifier);
        QCoreApplication::sendEvent(m_canvas.get(), &event);
    };
    m_look->toggle(Qt::Key_Q);
    QTest::qWait(450); // a key counts as held by the clock
    for (int i = 0; i < 3; ++i) {
        comesUp();
        m_look->toggle(Qt::Key_Q);
        QVERIFY(m_look->isOn());
    }
    comesUp();
    QVERIFY(!m_look->isOn());

    QTest::qWait(250);         // what comes sooner is a repetition, by the clock
    m_look->toggle(Qt::Key_Q); // pressed, not held: the look stays until it is pressed again
    comesUp();
    QVERIFY(m_look->isOn());
    m_look->toggle(Qt::Key_Q);
    QVERIFY(!m_look->isOn());
}

void SnapshotsTest::anEditEndsTheLook() {
    m_snapshots->take();
    scale(0.5);
    const auto looks = [this] {
        m_look->toggle();
        return m_look->isOn();
    };
    QVERIFY(looks());
    m_document->undoStack()->undo(); // what it undoes is the last edit, as always
    QVERIFY(!m_look->isOn());
    QVERIFY(m_snapshots->present());
    m_document->undoStack()->redo();
    QVERIFY(looks());
    {
        auto gesture = m_document->beginGesture(QStringLiteral("Drag"));
        QVERIFY(m_look->isOn());
        Fractal moved = gesture.before();
        document::system2(moved)->maps[1].map.translation.x() += 0.1;
        gesture.preview(moved);
        QVERIFY(!m_look->isOn());
        gesture.commit();
    }
    QVERIFY(looks());
    m_snapshots->remove(m_look->shown()->key);
    QVERIFY(!m_look->isOn());
    m_snapshots->bringBack();
    QVERIFY(looks());
    Fractal named = m_document->fractal();
    named.name = QStringLiteral("other");
    m_document->edit(QStringLiteral("Rename"), named);
    QVERIFY(m_look->isOn()); // the picture is the same
    m_document->setFile(io::readFractint("c { .5 0 0 .5 0 0 1 }\n"));
    QVERIFY(!m_look->isOn());
    awaitPicture();
}

void SnapshotsTest::whatCannotBeLookedAtSaysSo() {
    const auto toggle = [this] { m_look->toggle(); };
    QVERIFY(said(toggle).startsWith(QStringLiteral("There is no snapshot")));
    m_snapshots->take();
    QVERIFY(said(toggle).startsWith(QStringLiteral("Nothing has changed")));
    const Fractal plane = m_document->fractal();
    m_document->edit(QStringLiteral("Lift"), *document::lifted(plane));
    QVERIFY(said(toggle).contains(QStringLiteral("cannot be compared")));
    m_document->undoStack()->undo();
    scale(0.8);
    m_obstacle = QStringLiteral("Not now.");
    QCOMPARE(said(toggle), m_obstacle);
    QVERIFY(!m_look->isOn());
}

void SnapshotsTest::aSolidIsLookedAt() {
    m_document->edit(QStringLiteral("Lift"), *document::lifted(m_document->fractal()));
    m_space->resize(320, 240);
    m_space->show();
    m_space->showFour(true);
    const auto isDrawn = [this] {
        const auto* top = m_space->others()[0]->findChild<view::SolidBridge*>();
        return m_solid->isCurrent() && top->isCurrent();
    };
    m_snapshots->take();
    Fractal smaller = m_document->fractal();
    document::system3(smaller)->maps[0].map.linear *= 0.3;
    m_document->edit(QStringLiteral("Smaller"), smaller);
    QTRY_VERIFY(isDrawn());
    const QImage before = m_space->main()->picture(), top = m_space->others()[0]->picture();
    m_look->toggle();
    QVERIFY(m_look->isOn());
    QTRY_VERIFY(isDrawn() && m_space->main()->picture() != before);
    QTRY_VERIFY(m_space->others()[0]->picture() != top);
    m_look->end();
    QTRY_VERIFY(m_space->main()->picture() == before);
    QTRY_VERIFY(m_space->others()[0]->picture() == top);
}

void SnapshotsTest::thePanelFollows() {
    QAction take(QStringLiteral("Take")), compare(QStringLiteral("Compare"));
    view::SnapshotsPanel panel(m_snapshots.get(), m_look.get(), &take, &compare);
    panel.resize(500, 180);
    panel.show();
    QListWidget* list = panel.list();
    QCOMPARE(list->count(), 0);
    m_snapshots->take();
    scale(0.8);
    m_snapshots->take();
    QCOMPARE(list->count(), 2);
    QCOMPARE(list->currentRow(), 1);
    const auto text = [list](int row) { return list->item(row)->data(Qt::AccessibleTextRole).toString(); };
    QCOMPARE(text(0), QStringLiteral("Snapshot 1"));
    QCOMPARE(text(1), QStringLiteral("Snapshot 2, shown on the canvas, the one to compare with"));
    QTRY_VERIFY(!list->item(0)->data(Qt::DecorationRole).value<QPixmap>().isNull());

    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
    QCOMPARE(undoText(), QStringLiteral("Restore “Snapshot 1”"));
    QVERIFY(text(0).contains(QStringLiteral("shown")));
    QTest::mouseClick(list->viewport(), Qt::RightButton, {}, list->visualItemRect(list->item(1)).center());
    QCOMPARE(steps(), 2); // a menu restores nothing

    list->setCurrentRow(0);
    list->item(0)->setText(QStringLiteral("first"));
    QCOMPARE(names().first(), QStringLiteral("first"));
    list->item(0)->setText(QStringLiteral(" "));
    QCOMPARE(list->item(0)->text(), QStringLiteral("first"));
    m_snapshots->remove(key(0));
    QCOMPARE(list->count(), 1);
    QCOMPARE(list->item(0)->text(), QStringLiteral("Snapshot 2"));
    m_snapshots->bringBack();
    QCOMPARE(list->item(0)->text(), QStringLiteral("first"));
    m_document->setFile(io::readFractint("c { .5 0 0 .5 0 0 1 }\n"));
    QCOMPARE(list->count(), 0);
}

// By the keys or a right click; without that, the newest.
void SnapshotsTest::theSelectedOneIsCompared() {
    QAction take(QStringLiteral("Take")), compare(QStringLiteral("Compare"));
    view::SnapshotsPanel panel(m_snapshots.get(), m_look.get(), &take, &compare);
    panel.resize(500, 180);
    panel.show();
    QListWidget* list = panel.list();
    for (const double factor : {0.9, 0.8, 0.7}) {
        m_snapshots->take();
        scale(factor);
    }
    const int before = steps();
    const auto compared = [this] {
        m_look->toggle();
        const QString name = m_look->isOn() ? m_look->shown()->name : QString();
        m_look->end();
        return name;
    };
    QCOMPARE(compared(), QStringLiteral("Snapshot 3"));
    QTest::keyClick(list, Qt::Key_Left);
    QCOMPARE(compared(), QStringLiteral("Snapshot 2"));
    QTest::mouseClick(list->viewport(), Qt::RightButton, {}, list->visualItemRect(list->item(0)).center());
    QCOMPARE(compared(), QStringLiteral("Snapshot 1"));
    QCOMPARE(steps(), before); // nothing is restored
    m_snapshots->remove(key(0));
    QCOMPARE(list->currentRow(), 0);
    QCOMPARE(compared(), QStringLiteral("Snapshot 2"));
    m_snapshots->take();
    QCOMPARE(list->currentRow(), 2);
    scale(0.6);
    QCOMPARE(compared(), QStringLiteral("Snapshot 4"));
    m_snapshots->bringBack();
    QCOMPARE(list->currentRow(), 0);
}

BARYCAGE_TEST(SnapshotsTest, QApplication);
#include "snapshots_test.moc"
