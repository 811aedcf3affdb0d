// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "canvas/canvas_view.h"
#include "dialogs/command_palette.h"
#include "document/edits/dimension_edits.h"
#include "document/edits/shadow_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"

#include <QAction>
#include <QTest>
#include <QUndoStack>

#include <algorithm>

// The command Shadow of the window.
class ShadowCommandTest : public WindowFixture {
    Q_OBJECT

private:
    static QAction* shadowOf(const MainWindow& window) {
        for (const view::NamedAction& action : view::actionsOf(window))
            if (action.path == QString::fromUtf8("Edit › Fractal › Shadow")) return action.action;
        return nullptr;
    }

private slots:
    void itIsOneStepAndFollowsTheEntry();
    void theShadowIsInSight();
    void solidsSayWhyTheyHaveNone();
};

void ShadowCommandTest::itIsOneStepAndFollowsTheEntry() {
    document::Document* document = &m_window->document();
    QAction* shadow = shadowOf(*m_window);
    QVERIFY(shadow && shadow->isCheckable() && !shadow->isChecked());
    const int before = document->undoStack()->count();
    shadow->trigger();
    QVERIFY(document::hasShadow(document->fractal()));
    QCOMPARE(document->undoStack()->count(), before + 1);
    document->undoStack()->undo();
    QVERIFY(!shadow->isChecked() && !document::hasShadow(document->fractal()));
    document->undoStack()->redo();
    QVERIFY(shadow->isChecked());
    shadow->trigger();
    QVERIFY(!document::hasShadow(document->fractal()));
    QCOMPARE(document->undoStack()->count(), before + 2);
}

// While the view is fitted, it takes in the shadow.
void ShadowCommandTest::theShadowIsInSight() {
    document::Document* document = &m_window->document();
    auto* canvas = m_window->findChild<view::CanvasView*>();
    QTRY_VERIFY(canvas->navigation().isFitted());
    QAction* shadow = shadowOf(*m_window);
    shadow->trigger();
    const auto box = document::boxWithShadow(document->fractal(), canvas->camera().yAxis);
    QVERIFY(box);
    const auto isInSight = [&] {
        const auto low = toPixel(canvas->camera(), box->min), high = toPixel(canvas->camera(), box->max);
        return std::min(low.x(), high.x()) >= 0 && std::max(low.x(), high.x()) <= canvas->camera().width &&
               std::min(low.y(), high.y()) >= 0 && std::max(low.y(), high.y()) <= canvas->camera().height;
    };
    QTRY_VERIFY(isInSight());
}

void ShadowCommandTest::solidsSayWhyTheyHaveNone() {
    document::Document* document = &m_window->document();
    QAction* shadow = shadowOf(*m_window);
    QVERIFY(shadow->isEnabled());
    const auto solid = document::lifted(document->fractal());
    QVERIFY(solid);
    document->edit(QStringLiteral("lift"), *solid);
    QVERIFY(!shadow->isEnabled());
    QVERIFY2(shadow->statusTip().contains(QLatin1String("light")), qPrintable(shadow->statusTip()));
}

BARYCAGE_TEST(ShadowCommandTest, QApplication);
#include "shadow_command_test.moc"
