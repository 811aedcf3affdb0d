// SPDX-License-Identifier: MIT
#include "menus/clipboard_commands.h"

#include "app/gui/window_fixture.h"
#include "bridges/render_bridge.h"
#include "canvas/canvas_view.h"
#include "document/fractal/fractal.h"
#include "panels/entries/entries_list.h"
#include "support/named_test.h"

#include <QAction>
#include <QClipboard>
#include <QMimeData>
#include <QTest>

// Copy takes what the focus is on.
class CanvasCopyTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theCanvasGivesItsPicture();
    void aMapGivesItsRow();
    void theEntryGivesItsText();

private:
    view::CanvasView& canvas() const { return *m_window->findChild<view::CanvasView*>(); }
    void copy() const {
        for (QAction* action : m_window->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(QKeySequence::Copy) &&
                action->shortcutContext() == Qt::WindowShortcut)
                action->trigger();
    }
    static const QMimeData& copied() { return *QGuiApplication::clipboard()->mimeData(); }
};

void CanvasCopyTest::theCanvasGivesItsPicture() {
    QTRY_VERIFY(m_window->findChild<view::RenderBridge*>()->isCurrent());
    for (const auto tool : {view::CanvasView::Tool::Cage, view::CanvasView::Tool::Maps}) {
        canvas().setTool(tool);
        canvas().selectMaps({});
        canvas().setFocus();
        QGuiApplication::clipboard()->clear();
        copy();
        QVERIFY(copied().hasImage());
        QCOMPARE(qvariant_cast<QImage>(copied().imageData()).size(), canvas().picture().size());
    }
}

void CanvasCopyTest::aMapGivesItsRow() {
    canvas().setTool(view::CanvasView::Tool::Maps);
    canvas().selectMaps({document::system2(m_window->document().fractal())->maps[1].id});
    canvas().setFocus();
    copy();
    QVERIFY(!copied().hasImage());
    const QString row = copied().text().trimmed();
    QCOMPARE(row.count(u'\n'), 0);
    QVERIFY2(row.count(u'\t') >= 5, qPrintable(row));
}

void CanvasCopyTest::theEntryGivesItsText() {
    m_window->findChild<view::EntriesList*>()->setFocus();
    copy();
    QVERIFY(!copied().hasImage());
    QVERIFY2(copied().text().contains(QStringLiteral("maple")), qPrintable(copied().text()));
}

BARYCAGE_TEST(CanvasCopyTest, QApplication);
#include "canvas_copy_test.moc"
