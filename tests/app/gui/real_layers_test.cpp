// SPDX-License-Identifier: MIT
#include "document/edits/maps/map_locks.h"
#include "panels/entries/entries_list.h"
#include "panels/maps/maps_panel.h"
#include "support/window_on_x.h"

#include <QClipboard>
#include <QTableView>

// Cut, Copy, Paste, Duplicate, Delete and Select All of maps and entries, and maps as layers, with real keys
// and a real pointer.
class RealLayersTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void keysActOnTheMapsThatHaveTheFocus();
    void keysActOnTheEntriesThatHaveTheFocus();
    void theMenuActsWhereTheFocusIs();
    void theCanvasOfMapsCutsAndPastes();
    void aMapIsNamedLockedAndShownAlone();

private:
    view::MapsPanel& panel() const { return *window().findChild<view::MapsPanel*>(); }
    view::EntriesList& list() const { return *window().findChild<view::EntriesList*>(); }
    QPoint cell(int row, int column) const {
        const QTableView* table = panel().table();
        return table->viewport()->mapToGlobal(table->visualRect(table->model()->index(row, column)).center());
    }
    qsizetype entries() const { return document().file().entries.size(); }
};

void RealLayersTest::keysActOnTheMapsThatHaveTheFocus() {
    const auto before = code().maps;
    hand().clickAt(cell(2, view::MapsModel::A));
    QTRY_VERIFY(panel().table()->hasFocus());
    hand().key("Control+x");
    QTRY_COMPARE(code().maps.size(), before.size() - 1);
    QCOMPARE(document().undoStack()->undoText(), QStringLiteral("Cut a map"));
    hand().key("Control+v");
    QTRY_COMPARE(code().maps.size(), before.size());
    QVERIFY(code().maps.back().map == before[2].map);
    hand().key("Control+c");
    hand().key("Control+v");
    QTRY_COMPARE(code().maps.size(), before.size() + 1);
    hand().key("Insert");
    QTRY_COMPARE(code().maps.size(), before.size() + 2);
    hand().key("Delete");
    QTRY_COMPARE(code().maps.size(), before.size() + 1);
    hand().key("Control+a");
    QTRY_COMPARE(panel().selectedMaps().size(), before.size() + 1);
    QCOMPARE(entries(), 2);
}

void RealLayersTest::keysActOnTheEntriesThatHaveTheFocus() {
    window().openPath(copyOfCollection(QStringLiteral("ferns")));
    QTRY_VERIFY(entries() > 3);
    const qsizetype before = entries();
    clickOn(&list(), list().model()->index(1, 0));
    QTRY_VERIFY(list().hasFocus());
    const QString name = fractal().name;
    hand().key("Control+x");
    QTRY_COMPARE(entries(), before - 1);
    QVERIFY(QGuiApplication::clipboard()->text().startsWith(name));
    hand().key("Control+v");
    QTRY_COMPARE(entries(), before);
    QTRY_COMPARE(fractal().name, name);
    hand().key("Insert");
    QTRY_COMPARE(entries(), before + 1);
    hand().key("Delete");
    QTRY_COMPARE(entries(), before);
    hand().key("Control+a");
    QTRY_COMPARE(list().selectedIds().size(), before);
}

void RealLayersTest::theMenuActsWhereTheFocusIs() {
    const auto before = code().maps.size();
    hand().clickAt(cell(1, view::MapsModel::A));
    QTRY_VERIFY(panel().table()->hasFocus());
    choose({QStringLiteral("Edit"), QStringLiteral("Duplicate")});
    QTRY_COMPARE(code().maps.size(), before + 1);
    choose({QStringLiteral("Edit"), QStringLiteral("Delete")});
    QTRY_COMPARE(code().maps.size(), before);
    choose({QStringLiteral("Edit"), QStringLiteral("Select All")});
    QTRY_COMPARE(panel().selectedMaps().size(), before);
    choose({QStringLiteral("Edit"), QStringLiteral("Copy")});
    choose({QStringLiteral("Edit"), QStringLiteral("Paste")});
    QTRY_COMPARE(code().maps.size(), 2 * before);
    QCOMPARE(entries(), 2);
    showPanel(QStringLiteral("Entries"));
    clickOn(&list(), list().model()->index(0, 0));
    QTRY_VERIFY(list().hasFocus());
    choose({QStringLiteral("Edit"), QStringLiteral("Duplicate")});
    QTRY_COMPARE(entries(), 3);
    choose({QStringLiteral("Edit"), QStringLiteral("Cut")});
    QTRY_COMPARE(entries(), 2);
    choose({QStringLiteral("Edit"), QStringLiteral("Paste")});
    QTRY_COMPARE(entries(), 3);
    QCOMPARE(code().maps.size(), 2 * before);
}

void RealLayersTest::theCanvasOfMapsCutsAndPastes() {
    hand().clickAt(onCanvas({10, 200}));
    hand().key("m");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Maps);
    const auto before = code().maps;
    hand().key("Alt+2");
    hand().key("Control+x");
    QTRY_COMPARE(code().maps.size(), before.size() - 1);
    hand().key("Control+v");
    QTRY_COMPARE(code().maps.size(), before.size());
    QVERIFY(code().maps.back().map == before[1].map);
    QCOMPARE(entries(), 2);
}

void RealLayersTest::aMapIsNamedLockedAndShownAlone() {
    hand().clickAt(cell(1, view::MapsModel::A));
    QTRY_VERIFY(panel().table()->hasFocus());
    hand().key("Shift+F2");
    QTRY_VERIFY(!panel().table()->isColumnHidden(view::MapsModel::Name));
    hand().type(QStringLiteral("stem"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(fractal().mapLabels.of(code().maps[1].id).name, QStringLiteral("stem"));
    hand().clickAt(cell(1, view::MapsModel::Lock));
    QTRY_VERIFY(document::isLocked(fractal(), 1));
    const auto locked = code().maps;
    hand().clickAt(cell(1, view::MapsModel::B));
    hand().type(QStringLiteral("5"));
    hand().key("Delete");
    hand().clickAt(cell(0, view::MapsModel::Enabled)); // what comes after these keys
    QTRY_VERIFY(!code().maps[0].enabled);
    QCOMPARE(code().maps.size(), locked.size());
    QVERIFY(code().maps[1] == locked[1]);
    hand().key("Control+z");
    QTRY_VERIFY(code().maps[0].enabled);
    const int stepsBefore = steps();
    hand().clickAt(cell(1, view::MapsModel::A));
    hand().key("Control+Shift+l");
    QTRY_COMPARE(panel().model()->solo(), code().maps[1].id);
    photograph(QStringLiteral("solo"));
    hand().key("Control+Shift+l");
    QTRY_COMPARE(panel().model()->solo(), ifs::MapId::None);
    QCOMPARE(steps(), stepsBefore);
}

BARYCAGE_TEST_ON_X(RealLayersTest);

#include "real_layers_test.moc"
