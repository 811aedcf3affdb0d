// SPDX-License-Identifier: MIT
#include "bars/zoom_box.h"
#include "bridges/solid_bridge.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/saved_views_dialog.h"
#include "document/saved_views.h"
#include "panels/snapshots/snapshots_panel.h"
#include "space/space_view.h"
#include "support/window_on_x.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>

// Variants of a fractal that are kept and compared, and views that have names, with a real pointer and real
// keys.
class RealSnapshotsTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void snapshotsAreTakenAndRestored();
    void aKeyShowsTheSnapshot();
    void aKeyThatIsHeldShowsItAsLong();
    void escAndAnEditComeBack();
    void aSnapshotIsNamedAddedAndDeleted();
    void aViewIsSavedAndFoundAgain();
    void aSavedViewIsExported();
    void viewsAreRenamedAndDeleted();
    void aViewOfASolidIsSaved();

private:
    QListWidget& strip() const { return *window().findChild<view::SnapshotsPanel*>()->list(); }
    QWidget* banner() const { return window().findChild<QWidget*>(QStringLiteral("snapshot")); }
    void changeTheCage() {
        const int before = steps();
        dragBy(vertex(1), {-60, 90});
        QTRY_COMPARE(steps(), before + 1);
    }
    void saveView(const char* name);
    void letTheCameraRest() const;
    std::vector<document::SavedView> views() const { return document::savedViews(fractal()); }
};

void RealSnapshotsTest::snapshotsAreTakenAndRestored() {
    const document::Fractal first = fractal();
    QVERIFY(!strip().isVisible());
    hand().key("s");
    QTRY_COMPARE(strip().count(), 1);
    QVERIFY(strip().isVisible()); // so that one sees what the key did
    changeTheCage();
    const document::Fractal second = fractal();
    hand().key("s");
    QTRY_COMPARE(strip().count(), 2);
    QCOMPARE(steps(), 1);
    clickOn(&strip(), strip().model()->index(0, 0));
    QTRY_VERIFY(fractal() == first);
    QCOMPARE(steps(), 2);
    photograph(QStringLiteral("snapshots.png"));
    clickOn(&strip(), strip().model()->index(1, 0));
    QTRY_VERIFY(fractal() == second);
    hand().key("Control+z");
    QTRY_VERIFY(fractal() == first);
    hand().key("Control+z");
    QTRY_VERIFY(fractal() == second);
    hand().key("Control+z");
    QTRY_VERIFY(fractal() == first);
    QVERIFY(!window().isWindowModified());
}

void RealSnapshotsTest::aKeyShowsTheSnapshot() {
    hand().key("s");
    changeTheCage();
    const auto now = document().sharedFractal();
    const QImage picture = canvas().picture();
    hand().key("q");
    QTRY_VERIFY(banner() && banner()->isVisible());
    QVERIFY(!canvas().options().overlaysVisible());
    QTRY_VERIFY(canvas().picture() != picture);
    QVERIFY(document().sharedFractal() == now);
    photograph(QStringLiteral("look.png"));
    hand().wheel(2); // a closer look
    QVERIFY(banner());
    hand().key("q");
    QTRY_VERIFY(!banner());
    QVERIFY(canvas().options().overlaysVisible());
    QVERIFY(document().sharedFractal() == now);
    QCOMPARE(steps(), 1);

    hand().key("q");
    QTRY_VERIFY(banner() && banner()->isVisible());
    click(named<QPushButton>(*banner(), QStringLiteral("Restore")));
    QTRY_COMPARE(steps(), 2);
    QTRY_VERIFY(!banner());
    QVERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Restore")));
}

void RealSnapshotsTest::aKeyThatIsHeldShowsItAsLong() {
    hand().key("s");
    changeTheCage();
    const support::KeyPresses presses;
    hand().hold("q");
    QTRY_VERIFY(banner());
    QTRY_VERIFY(presses.count() > 5); // the server repeats the key
    QVERIFY(banner());
    hand().letUp("q");
    QTRY_VERIFY(!banner());
    QVERIFY(canvas().options().overlaysVisible());
}

void RealSnapshotsTest::escAndAnEditComeBack() {
    hand().key("s");
    changeTheCage();
    const document::Fractal now = fractal();
    hand().key("q");
    QTRY_VERIFY(banner());
    hand().key("Escape");
    QTRY_VERIFY(!banner());
    QVERIFY(fractal() == now);
    hand().key("q");
    QTRY_VERIFY(banner());
    hand().key("Control+z");
    QTRY_VERIFY(!banner());
    QVERIFY(document().undoStack()->canRedo());
    hand().key("Control+y");
    QTRY_VERIFY(fractal() == now);
    hand().key("q");
    QTRY_VERIFY(banner());
    hand().key("s"); // keeps the fractal, not what is looked at
    QTRY_COMPARE(strip().count(), 2);
    QVERIFY(!banner());
    QVERIFY(window().findChild<view::SnapshotsPanel*>() && fractal() == now);
}

void RealSnapshotsTest::aSnapshotIsNamedAddedAndDeleted() {
    hand().key("s");
    QTRY_COMPARE(strip().count(), 1);
    changeTheCage();
    hand().clickAt(strip().viewport()->mapToGlobal(strip().visualItemRect(strip().item(0)).center()),
                   support::XInput::Right);
    QTRY_VERIFY(visible<QMenu>());
    chooseFrom(visible<QMenu>(), QStringLiteral("Rename"));
    QTRY_VERIFY(strip().findChild<QLineEdit*>());
    QTRY_VERIFY(strip().findChild<QLineEdit*>()->hasFocus() && !visible<QMenu>());
    (void)QCursor::pos(); // the server answers: so it has given the keys back to the window
    hand().key("Control+a");
    hand().type(QStringLiteral("upright"));
    hand().key("Return");
    QTRY_COMPARE(strip().item(0)->text(), QStringLiteral("upright"));
    QCOMPARE(steps(), 1); // nothing was restored on the way
    click(
        named<QAbstractButton>(*window().findChild<view::SnapshotsPanel*>(), QStringLiteral("Add as Entry")));
    QTRY_COMPARE(document().file().entries.size(), 3);
    QCOMPARE(document().file().entries[1].fractal->name, QStringLiteral("upright"));
    QCOMPARE(fractal().name, QStringLiteral("maple"));
    strip().setFocus();
    hand().key("Delete");
    QTRY_COMPARE(strip().count(), 0);
    QCOMPARE(document().file().entries.size(), 3);
}

void RealSnapshotsTest::saveView(const char* name) {
    QVERIFY(answer<view::SaveViewDialog>(
        [this] {
            choose({QStringLiteral("View"), QStringLiteral("Saved Views"), QStringLiteral("Save View…")});
        },
        [this, name](view::SaveViewDialog&) {
            hand().key("Control+a");
            hand().type(QLatin1String(name));
            hand().key("Return");
        }));
}

void RealSnapshotsTest::aViewIsSavedAndFoundAgain() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    hand().moveTo(onScreen({0.2, 0.3}));
    hand().wheel(8);
    const attractor::Camera close = canvas().camera();
    saveView("the tip");
    QTRY_COMPARE(views().size(), std::size_t{1});
    QCOMPARE(steps(), 1);
    QCOMPARE(canvas().camera(), close);
    hand().clickAt(onCanvas({12, 300}));
    hand().key("f");
    QTRY_VERIFY(canvas().camera() != close);
    choose({QStringLiteral("View"), QStringLiteral("Saved Views"), QStringLiteral("the tip")});
    QTRY_VERIFY(std::abs(canvas().camera().pixelsPerUnit / close.pixelsPerUnit - 1) < 1e-12);
    QVERIFY((canvas().camera().centre - close.centre).norm() < 1e-12);

    hand().clickAt(onCanvas({12, 300}));
    hand().key("y"); // upside down now
    hand().key("f");
    auto* zoom = window().findChild<view::ZoomBox*>();
    click(zoom);
    hand().key("Alt+Down");
    QTRY_VERIFY(zoom->view()->isVisible());
    hand().key("End");
    hand().key("Return");
    QTRY_VERIFY((canvas().camera().centre - close.centre).norm() < 1e-12);
    QVERIFY(canvas().camera().yAxis == attractor::YAxis::Up);

    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QVERIFY(document::savedView(savedEntry(path), QStringLiteral("the tip")) ==
            document::savedView(fractal(), QStringLiteral("the tip")));
    hand().key("Control+z");
    QTRY_VERIFY(views().empty());
    QCOMPARE(window().findChild<view::ZoomBox*>()->findText(QStringLiteral("the tip")), -1);
}

void RealSnapshotsTest::aSavedViewIsExported() {
    hand().moveTo(onScreen({0.2, 0.3}));
    hand().wheel(8);
    saveView("leaf");
    QTRY_COMPARE(views().size(), std::size_t{1});
    hand().clickAt(onCanvas({12, 300}));
    hand().key("f");
    auto* dialog = qobject_cast<view::ExportDialog*>(openDialog("Control+e", "view::ExportDialog"));
    QVERIFY(dialog);
    auto* section = named<QComboBox>(*dialog, QStringLiteral("Section"));
    QCOMPARE(section->itemText(2), QStringLiteral("The view “leaf”"));
    pick(section, 0); // the first of the saved views
    photograph(QStringLiteral("export.png"));
    const QString path = folder() + QStringLiteral("/leaf.png");
    dialog->exportTo(path);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), 60'000);
    const QImage leaf(path);
    pick(section, view::ExportDialog::Section::Attractor);
    const QString whole = folder() + QStringLiteral("/whole.png");
    QTRY_VERIFY(section->isEnabled());
    dialog->exportTo(whole);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(whole), 60'000);
    QCOMPARE(QImage(whole).size(), leaf.size());
    QVERIFY(QImage(whole) != leaf);
    dialog->close();
}

void RealSnapshotsTest::viewsAreRenamedAndDeleted() {
    saveView("one");
    QTRY_COMPARE(views().size(), std::size_t{1});
    hand().wheel(3);
    saveView("two");
    QTRY_COMPARE(views().size(), std::size_t{2});
    choose({QStringLiteral("View"), QStringLiteral("Saved Views"), QStringLiteral("Edit Views…")});
    auto* dialog = visible<view::SavedViewsDialog>();
    QTRY_VERIFY((dialog = visible<view::SavedViewsDialog>()) && support::isInPlace(dialog));
    auto* list = named<QListWidget>(*dialog, QStringLiteral("Saved views"));
    clickOn(list, list->model()->index(1, 0));
    hand().key("F2");
    hand().key("Control+a");
    hand().type(QStringLiteral("second"));
    hand().key("Return");
    QTRY_COMPARE(views().back().name, QStringLiteral("second"));
    photograph(QStringLiteral("views.png"));
    QCOMPARE(steps(), 3);
    clickOn(list, list->model()->index(0, 0));
    click(named<QPushButton>(*dialog, QStringLiteral("Delete")));
    QTRY_COMPARE(views().size(), std::size_t{1});
    QCOMPARE(list->count(), 1);
    QCOMPARE(steps(), 4);
    hand().key("Escape");
    QTRY_VERIFY(!visible<view::SavedViewsDialog>());
    hand().key("Control+z");
    QTRY_COMPARE(views().size(), std::size_t{2});
}

// A camera that glides arrives: what is drawn on the way is not exact.
void RealSnapshotsTest::letTheCameraRest() const {
    const auto* drawn = window().findChild<view::SolidBridge*>();
    QVERIFY(drawn);
    QTRY_VERIFY(drawn->isCurrent());
}

void RealSnapshotsTest::aViewOfASolidIsSaved() {
    window().openPath(copyOfCollection(QStringLiteral("space_sponges")));
    QVERIFY(document::space(fractal()));
    const auto chooseView = [this](const QStringList& view) {
        choose(QStringList(QStringLiteral("View")) + view);
        letTheCameraRest();
    };
    const auto look = [chooseView](const char* view) {
        chooseView({QStringLiteral("Navigate"), QStringLiteral("Camera"), QLatin1String(view)});
    };
    look("Isometric");
    saveView("corner");
    QTRY_COMPARE(views().size(), std::size_t{1});
    const auto saved = std::get<attractor::OrbitCamera>(views().front().camera);
    look("Top");
    look("Perspective");
    chooseView({QStringLiteral("Saved Views"), QStringLiteral("corner")});
    saveView("again");
    QTRY_COMPARE(views().size(), std::size_t{2});
    const auto found = std::get<attractor::OrbitCamera>(views().back().camera);
    QVERIFY(found.orientation.angularDistance(saved.orientation) < 1e-9);
    QVERIFY((found.target - saved.target).norm() < 1e-9);
    QCOMPARE(found.height, saved.height);
    QVERIFY(found.projection == saved.projection);
}

BARYCAGE_TEST_ON_X(RealSnapshotsTest);

#include "real_snapshots_test.moc"
