// SPDX-License-Identifier: MIT
#include "menus/snapshot_commands.h"

#include "app/gui/window_fixture.h"
#include "dialogs/saved_views_dialog.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace Qt::StringLiterals;

// Snapshots in a window that shows how the attractor is built, and views that are saved.
class SnapshotCommandsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void aChaosGameIsNotCompared();
    void aViewIsNotReplacedUnsaid();

private:
    QString saveView(const QString& name);
    view::SnapshotLook* look() const { return m_window->findChild<SnapshotCommands*>()->look(); }
};

// A few points of the snapshot would be all that is seen, with the die of the fractal.
void SnapshotCommandsTest::aChaosGameIsNotCompared() {
    auto* canvas = m_window->findChild<view::CanvasView*>();
    auto* construction = m_window->findChild<view::Construction*>();
    QTest::keyClick(canvas, Qt::Key_S);
    document::Fractal changed = m_window->document().fractal();
    document::plane(changed)->system.maps[0].map.translation.x() += 0.1;
    m_window->document().edit(u"move"_s, changed);
    using Mode = view::Construction::Mode;
    for (const Mode mode : {Mode::ChaosGame, Mode::Steps}) {
        construction->setMode(mode);
        QTest::keyClick(canvas, Qt::Key_Q);
        QVERIFY(!look()->isOn());
        QVERIFY(canvas->options().overlaysVisible());
        QSignalSpy said(look(), &view::SnapshotLook::message);
        look()->toggle();
        QCOMPARE(said.size(), 1);
        QVERIFY2(said.first().first().toString().contains(u"Density"_s),
                 qPrintable(said.first().first().toString()));
    }
    construction->setMode(Mode::Density);
    QTest::keyClick(canvas, Qt::Key_Q);
    QVERIFY(look()->isOn());
    construction->setMode(Mode::ChaosGame);
    QVERIFY(!look()->isOn());
    QVERIFY(canvas->options().overlaysVisible());
    m_window->document().undoStack()->setClean();
}

// The button that was clicked.
QString SnapshotCommandsTest::saveView(const QString& name) {
    support::command(*m_window, "save-view")->trigger();
    auto* dialog = m_window->findChild<view::SaveViewDialog*>();
    if (!dialog) return {};
    dialog->findChild<QLineEdit*>()->setText(name);
    QString text;
    for (auto* button : dialog->findChildren<QPushButton*>())
        if (button->isDefault()) text = button->text();
    dialog->accept();
    delete dialog;
    return text;
}

void SnapshotCommandsTest::aViewIsNotReplacedUnsaid() {
    document::Document& document = m_window->document();
    QCOMPARE(saveView(u"tip"_s), u"&Save"_s);
    QCOMPARE(document.undoStack()->undoText(), u"Save the view “tip”"_s);
    m_window->findChild<view::CanvasView*>()->navigation().zoomBy(2);
    QCOMPARE(saveView(u"tip"_s), u"&Replace"_s);
    QCOMPARE(document.undoStack()->undoText(), u"Replace the view “tip”"_s);
    QCOMPARE(document::savedViews(document.fractal()).size(), std::size_t(1));
    document.undoStack()->setClean();
}

BARYCAGE_TEST(SnapshotCommandsTest, QApplication);
#include "snapshot_commands_test.moc"
