// SPDX-License-Identifier: MIT
#include "dialogs/variations/mutate_dialog.h"
#include "dialogs/variations/picture_tiles.h"
#include "dialogs/variations/random_dialog.h"
#include "io/file/save_file.h"
#include "io/fractint/fractint_reader.h"
#include "panels/collection/collection_panel.h"
#include "panels/entries/entries_panel.h"
#include "support/window_on_x.h"

#include <QClipboard>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>

// Fractals chosen, brought in, made by chance and kept in order, with a real pointer and real keys.
class RealEntriesTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void anEntryIsChosenAndRenamed();
    void entriesAreFoundCopiedAndRemoved();
    void entriesOfAnIfsFileArePasted();
    void aFlameIsPasted();
    void aDoubleClickOpensFromTheCollection();
    void aSearchAddsFromTheCollection();
    void shiftEnterAddsFromTheCollection();
    void aVariationIsPicked();
    void aFractalByChanceIsAdded();

private:
    QListView& entries() const {
        return *named<QListView>(*window().findChild<view::EntriesPanel*>(), QStringLiteral("Entries"));
    }
    QListView& collection() const {
        return *named<QListView>(*window().findChild<view::CollectionPanel*>(),
                                 QStringLiteral("Fractals of the collection"));
    }
    static QModelIndex find(const QListView& list, const QString& name) {
        const QAbstractItemModel* model = list.model();
        support::waitFor([&] { return !model->match(model->index(0, 0), Qt::DisplayRole, name).isEmpty(); });
        return model->match(model->index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly).value(0);
    }
    QStringList names() const {
        QStringList all;
        for (const document::Entry& entry : document().file().entries)
            all << entry.fractal->name;
        return all;
    }
};

void RealEntriesTest::anEntryIsChosenAndRenamed() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    QCOMPARE(fractal().name, QStringLiteral("maple"));
    clickOn(&entries(), find(entries(), QStringLiteral("flower")));
    QTRY_COMPARE(fractal().name, QStringLiteral("flower"));
    QCOMPARE(code().maps.size(), std::size_t{2});
    QCOMPARE(steps(), 0);
    hand().key("F2");
    hand().key("Control+a");
    hand().type(QStringLiteral("arch"));
    hand().key("Return");
    QTRY_COMPARE(names(), (QStringList{QStringLiteral("maple"), QStringLiteral("arch")}));
    const QByteArray before = io::loadFile(path).bytes;
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(io::loadFile(path).bytes, QByteArray(before).replace("\nflower {", "\narch {"));
}

void RealEntriesTest::entriesAreFoundCopiedAndRemoved() {
    window().openPath(copyOfCollection(QStringLiteral("ferns")));
    const QStringList before = names();
    const QString third = before[2];
    type(named<QLineEdit>(window(), QStringLiteral("Filter entries by name")), third);
    QTRY_COMPARE(entries().model()->rowCount(), 2); // and the entry that is shown
    clickOn(&entries(), find(entries(), third));
    QTRY_COMPARE(fractal().name, third);
    hand().key("Control+c");
    QTRY_VERIFY(QGuiApplication::clipboard()->text().startsWith(third));
    hand().key("Insert");
    QTRY_COMPARE(names().size(), before.size() + 1);
    QCOMPARE(names()[2], third); // its copy is behind it
    QVERIFY(names()[3] != before[3]);
    hand().key("Alt+Up");
    QTRY_COMPARE(names()[3], third);
    hand().key("Delete");
    QTRY_COMPARE(names(), before);
    QCOMPARE(steps(), 3);
}

void RealEntriesTest::entriesOfAnIfsFileArePasted() {
    QGuiApplication::clipboard()->setText(
        QStringLiteral("guest { ; of another\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n"));
    hand().clickAt(onCanvas({10, 200}));
    hand().key("Control+v");
    QTRY_COMPARE(fractal().name, QStringLiteral("guest"));
    QCOMPARE(code().maps[1].map.translation, ifs::Vector<2>(0.5, 0));
    QCOMPARE(names(),
             (QStringList{QStringLiteral("maple"), QStringLiteral("guest"), QStringLiteral("flower")}));
    hand().key("Control+z");
    QTRY_COMPARE(names().size(), 2);
}

// Its y grows downwards.
void RealEntriesTest::aFlameIsPasted() {
    QGuiApplication::clipboard()->setText(QStringLiteral(
        "<flame name=\"ember\"><xform weight=\"1\" linear=\"1\" coefs=\"0.5 0 0 0.5 0.25 0.125\"/>"
        "<xform weight=\"3\" linear=\"1\" coefs=\"0.25 0 0 0.5 0 0\"/></flame>"));
    showPanel(QStringLiteral("Entries"));
    click(&entries());
    hand().key("Control+v");
    QTRY_COMPARE(fractal().name, QStringLiteral("ember"));
    QCOMPARE(code().maps.size(), std::size_t{2});
    QCOMPARE(code().maps[0].map.translation, ifs::Vector<2>(0.25, -0.125));
    QCOMPARE(*code().maps[1].weight, 3 * *code().maps[0].weight);
    QCOMPARE(steps(), 1);
}

void RealEntriesTest::aDoubleClickOpensFromTheCollection() {
    const QModelIndex dragon = find(collection(), QStringLiteral("Twindragon"));
    QVERIFY(dragon.isValid());
    collection().scrollTo(dragon);
    support::handleEvents();
    hand().doubleClickAt(collection().viewport()->mapToGlobal(collection().visualRect(dragon).center()));
    QTRY_COMPARE(names(), QStringList{QStringLiteral("twindragon")}); // a document of its own
    QVERIFY(!window().isWindowModified());
    QVERIFY(window().path().isEmpty());
}

// To a file that has been worked on it is added, and nothing is asked.
void RealEntriesTest::aSearchAddsFromTheCollection() {
    dragBy(vertex(1), {-20, 10});
    QTRY_COMPARE(steps(), 1);
    click(named<QLineEdit>(window(), QStringLiteral("Search the collection")));
    QVERIFY(find(collection(), QStringLiteral("Twindragon")).isValid());
    hand().type(QStringLiteral("twindr"));
    QTRY_VERIFY(collection().model()->rowCount() < 6); // three entries of two themes
    const QStringList before = names();
    hand().key("Return");
    QTRY_COMPARE(fractal().name, QStringLiteral("twindragon"));
    QCOMPARE(names(), before + QStringList{QStringLiteral("twindragon")});
    QCOMPARE(steps(), 2);
    click(&entries()); // in the search, Ctrl+Z is about its text
    hand().key("Control+z");
    QTRY_COMPARE(fractal().name, QStringLiteral("maple"));
    QCOMPARE(names(), before);
}

void RealEntriesTest::shiftEnterAddsFromTheCollection() {
    clickOn(&collection(), find(collection(), QStringLiteral("Twindragon")));
    hand().key("Shift+Return");
    QTRY_COMPARE(fractal().name, QStringLiteral("twindragon"));
    QCOMPARE(names().size(), 3);
    QCOMPARE(steps(), 1);
}

void RealEntriesTest::aVariationIsPicked() {
    const document::Fractal before = fractal();
    auto* dialog = static_cast<view::MutateDialog*>(openDialog("Control+m", "view::MutateDialog"));
    QVERIFY(dialog);
    const auto* ring = dialog->findChild<view::VariationRing*>();
    const auto* line = dialog->findChild<QListWidget*>();
    const auto clickOnChild = [&](int child) {
        const auto isThere = [&] { return !ring->childPicture(child).isNull(); };
        if (!support::waitFor(isThere)) return false;
        hand().clickAt(ring->viewport()->mapToGlobal(ring->visualItemRect(ring->childItem(child)).center()));
        return true;
    };
    QVERIFY(clickOnChild(5));
    QTRY_COMPARE(line->count(), 2);
    photograph(QStringLiteral("mutate.png"));
    QVERIFY(clickOnChild(7));
    QTRY_COMPARE(line->count(), 3);
    QCOMPARE(steps(), 0);
    click(named<QPushButton>(*dialog, QStringLiteral("Use This One")));
    QTRY_VERIFY(!visible<view::MutateDialog>());
    QCOMPARE(steps(), 1);
    QVERIFY(!document::isSameSystem(fractal(), before));
    QCOMPARE(names().size(), 2);
    QTRY_VERIFY(window().isActiveWindow());
    hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);
}

void RealEntriesTest::aFractalByChanceIsAdded() {
    auto* dialog = static_cast<view::RandomDialog*>(openDialog("Control+Shift+m", "view::RandomDialog"));
    QVERIFY(dialog);
    auto* sheet = dialog->findChild<QListWidget*>();
    const QModelIndex last = sheet->model()->index(view::RandomDialog::count - 1, 0);
    QVERIFY(support::waitFor([&] { return !view::PictureTiles::shown(last).pixmap.isNull(); }));
    hand().doubleClickAt(sheet->viewport()->mapToGlobal(sheet->visualItemRect(sheet->item(6)).center()));
    QTRY_VERIFY(!visible<view::RandomDialog>());
    QCOMPARE(names().size(), 3);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Add Random Fractal"));
    QVERIFY(code().maps.size() >= 2);
    QVERIFY(!QStringList({QStringLiteral("maple"), QStringLiteral("flower")}).contains(fractal().name));
}

BARYCAGE_TEST_ON_X(RealEntriesTest);

#include "real_entries_test.moc"
