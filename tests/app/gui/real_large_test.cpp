// SPDX-License-Identifier: MIT
#include "bridges/analysis_bridge.h"
#include "io/file/save_file.h"
#include "panels/analysis/analysis_panel.h"
#include "panels/entries/entries_panel.h"
#include "panels/maps/maps_panel.h"
#include "support/background_rest.h"
#include "support/window_on_x.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QListView>
#include <QTableView>

#include <algorithm>

// Ten thousand maps and two thousand entries with a real pointer and real keys. Besides the results, the
// tests check that no event blocks the window (support/watchdog.h).
class RealLargeTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void manyMapsAreDrawnAndHeldByTheirCage();
    void manyMapsAreSelectedAndDeleted();
    void factsOfManyMapsAreOutlined();
    void oneOfManyMapsIsTyped();
    void oneOfManyEntriesIsFoundAndSaved();

private:
    static constexpr int side = 100;
    void openMaps() {
        QByteArray text = "square {\n";
        for (int i = 0; i < side * side; ++i)
            text += " .0066 0 0 .0066 " + QByteArray::number(double(i % side) / side) + ' ' +
                    QByteArray::number(double(i / side) / side) + " 1\n";
        m_path = folder() + QStringLiteral("/maps.ifs");
        QVERIFY(!io::saveFile(m_path, text + "}\n"));
        QVERIFY(window().openPath(m_path));
        QCOMPARE(code().maps.size(), std::size_t(side * side));
    }

    QString m_path;
};

void RealLargeTest::manyMapsAreDrawnAndHeldByTheirCage() {
    openMaps();
    const std::vector<ifs::Vector<2>> held = vertices();
    QTRY_VERIFY(!canvas().picture().isNull());
    QVERIFY(support::backgroundRests()); // until the extent is found, and the view fitted
    dragBy(vertex(1), {-60, -45});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(offsetInPixels(vertices()[1], held[1], {-60, -45}) < 1e-6);
    dragBy(insideTheCage(), {30, 20});
    QTRY_COMPARE(steps(), 2);
    hand().key("Control+b");
    QTRY_COMPARE(steps(), 3);
    hand().key("Control+z");
    QTRY_VERIFY(cage().rest != cage().current);
}

void RealLargeTest::manyMapsAreSelectedAndDeleted() {
    openMaps();
    const document::System2 before = code();
    hand().key("m");
    hand().key("Control+a");
    QTRY_COMPARE(canvas().selectedMaps().size(), before.maps.size());
    QTRY_COMPARE(window().findChild<view::MapsPanel*>()->selectedMaps().size(), before.maps.size());
    photograph(QStringLiteral("many-selected.png"));
    hand().key("Alt+2");
    QTRY_COMPARE(canvas().selectedMaps(), std::vector{before.maps[1].id});
    hand().key("Delete");
    QTRY_COMPARE(code().maps.size(), before.maps.size() - 1);
    hand().key("Control+z");
    QTRY_VERIFY(code() == before);
    photograph(QStringLiteral("many.png"));
}

void RealLargeTest::factsOfManyMapsAreOutlined() {
    openMaps();
    showPanel(QStringLiteral("Analysis"));
    auto* panel = window().findChild<view::AnalysisPanel*>();
    QTRY_VERIFY(!panel->facts().isEmpty());
    for (const auto kind : {document::Outline::FixedPoints, document::Outline::Cylinders}) {
        auto* box = panel->outlineBox(kind);
        panel->ensureWidgetVisible(box);
        support::handleEvents();
        hand().clickAt(box->mapToGlobal(QPoint(8, box->height() / 2)));
        QTRY_VERIFY(box->isChecked());
    }
    const auto isOutlined = [this](document::Outline kind) { // they are worked out elsewhere
        const auto known = window().findChild<view::AnalysisBridge*>()->analysis();
        return known &&
               std::ranges::any_of(known->shapes, [kind](const auto& shape) { return shape.kind == kind; });
    };
    QTRY_VERIFY(isOutlined(document::Outline::FixedPoints) && isOutlined(document::Outline::Cylinders));
    photograph(QStringLiteral("many-outlined.png"));
    dragBy(vertex(1), {-60, -45});
    QTRY_COMPARE(steps(), 1);
}

void RealLargeTest::oneOfManyMapsIsTyped() {
    openMaps();
    auto* table = window().findChild<view::MapsPanel*>()->table();
    click(table->viewport());
    hand().key("Control+End");
    QTRY_COMPARE(table->currentIndex().row(), side * side - 1);
    hand().key("Home");
    while (table->currentIndex().column() < view::MapsModel::E)
        hand().key("Right");
    hand().type(QStringLiteral("1.25"));
    QTRY_COMPARE(code().maps.back().map.translation.x(), 1.25);
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(document::system2(savedEntry(m_path))->maps.back().map.translation.x(), 1.25);
}

void RealLargeTest::oneOfManyEntriesIsFoundAndSaved() {
    QByteArray text;
    for (int i = 0; i < 2000; ++i)
        text += "entry" + QByteArray::number(i) + " {\n .5 0 0 .5 0 0 .3\n .5 0 0 .5 .5 0 .3\n .4 .1 0 .5 ." +
                QByteArray::number(i) + " .4 .4\n}\n";
    const QString path = folder() + QStringLiteral("/entries.ifs");
    QVERIFY(!io::saveFile(path, text));
    QVERIFY(window().openPath(path));
    auto* entries = named<QListView>(*window().findChild<view::EntriesPanel*>(), QStringLiteral("Entries"));
    click(entries);
    hand().key("End");
    QTRY_COMPARE(fractal().name, QStringLiteral("entry1999"));
    type(named<QLineEdit>(window(), QStringLiteral("Filter entries by name")), QStringLiteral("1234"));
    QTRY_COMPARE(entries->model()->rowCount(), 2); // and the entry that is shown
    clickOn(entries, entries->model()->index(0, 0));
    QTRY_COMPARE(fractal().name, QStringLiteral("entry1234"));
    hand().key("F2");
    hand().key("Control+a");
    hand().type(QStringLiteral("mine"));
    hand().key("Return");
    QTRY_COMPARE(fractal().name, QStringLiteral("mine"));
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(io::loadFile(path).bytes, QByteArray(text).replace("\nentry1234 {", "\nmine {"));
}

BARYCAGE_TEST_ON_X(RealLargeTest);

#include "real_large_test.moc"
