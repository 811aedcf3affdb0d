// SPDX-License-Identifier: MIT
#include "canvas/canvas_view.h"
#include "main_window.h"
#include "panels/maps/maps_model.h"
#include "panels/maps/maps_table.h"
#include "support/every_window.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "widgets/wheel_needs_focus.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest/qtestspontaneevent.h>

using support::EveryWindow;

// In the window and its dialogs, the wheel changes only what has the focus.
class WheelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void nothingChangesWithoutTheFocus();
    void aTableKeepsItsNumbers();
    void whatHasTheFocusChanges();
    void theAreaBehindScrolls();

private:
    static QList<QWidget*> valueWidgets(const QWidget* window);
    static QString value(const QWidget* widget);
    static void turn(QWidget* widget, int notches);
    static QTabBar* twoTabs();
};

QList<QWidget*> WheelTest::valueWidgets(const QWidget* window) {
    QList<QWidget*> found;
    for (auto* widget : window->findChildren<QWidget*>()) {
        const bool isSlider = qobject_cast<QAbstractSlider*>(widget) && !qobject_cast<QScrollBar*>(widget);
        if (isSlider || qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
            qobject_cast<QTabBar*>(widget))
            found << widget;
    }
    return found;
}

QString WheelTest::value(const QWidget* widget) {
    if (const auto* slider = qobject_cast<const QAbstractSlider*>(widget))
        return QString::number(slider->value());
    if (const auto* list = qobject_cast<const QComboBox*>(widget))
        return QString::number(list->currentIndex()) + list->currentText();
    if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) return QString::number(tabs->currentIndex());
    return static_cast<const QAbstractSpinBox*>(widget)->text();
}

QTabBar* WheelTest::twoTabs() {
    auto* tabs = new QTabBar;
    tabs->addTab(QStringLiteral("a"));
    tabs->addTab(QStringLiteral("b"));
    return tabs;
}

// As the window system sends it, which may give the focus.
void WheelTest::turn(QWidget* widget, int notches) {
    const QPointF middle = QRectF(widget->rect()).center();
    QWheelEvent event(middle, widget->mapToGlobal(middle), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(widget, &event);
}

void WheelTest::nothingChangesWithoutTheFocus() {
    const view::WheelNeedsFocus filter(qApp);
    const EveryWindow windows;
    QStringList changed;
    int tried = 0;
    for (QWidget* window : windows.all()) {
        if (!window) continue;
        window->setWindowModality(Qt::NonModal);
        window->show();
        for (QWidget* widget : valueWidgets(window)) {
            widget->ensurePolished();
            if (widget->hasFocus()) widget->clearFocus();
            const QString before = value(widget);
            turn(widget, -1);
            turn(widget, 1);
            turn(widget, 1);
            if (value(widget) != before || widget->hasFocus()) changed << EveryWindow::describe(widget);
            ++tried;
        }
        if (window != windows.all().first()) window->hide();
    }
    QVERIFY2(changed.isEmpty(), qPrintable(changed.join(u'\n')));
    QVERIFY(tried > 50);
}

// The current cell of the maps follows the wheel, too, but only in the table that has the focus.
void WheelTest::aTableKeepsItsNumbers() {
    const view::WheelNeedsFocus filter(qApp);
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.resize(1400, 900);
    window.openFirstPicture();
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    auto* table = window.findChild<view::MapsTable*>();
    QVERIFY(table && table->isVisible());
    const QModelIndex cell = table->model()->index(1, view::MapsModel::A);
    table->setCurrentIndex(cell);
    window.findChild<view::CanvasView*>()->setFocus();
    QVERIFY(!table->hasFocus());
    const QPointF middle = QRectF(table->visualRect(cell)).center();
    const auto turnThere = [&] {
        QWheelEvent event(middle, table->viewport()->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event);
        qApp->notify(table->viewport(), &event);
    };
    const QVariant before = cell.data(Qt::EditRole);
    turnThere();
    QCOMPARE(cell.data(Qt::EditRole), before);
    QVERIFY(!table->hasFocus());
    table->setFocus();
    turnThere();
    QVERIFY(cell.data(Qt::EditRole) != before);
    window.document().undoStack()->setClean();
}

void WheelTest::whatHasTheFocusChanges() {
    const view::WheelNeedsFocus filter(qApp);
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* list = new QComboBox;
    auto* written = new QComboBox; // its field has the focus
    written->setEditable(true);
    auto* slider = new QSlider(Qt::Horizontal);
    auto* box = new QSpinBox;
    auto* tabs = twoTabs();
    for (QWidget* widget : QList<QWidget*>{list, written, slider, box, tabs})
        layout->addWidget(widget);
    for (QComboBox* both : {list, written})
        both->addItems({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    for (QWidget* widget : QList<QWidget*>{list, written, slider, box, tabs}) {
        widget->setFocus();
        const QString before = value(widget);
        turn(widget, widget == slider || widget == box ? 1 : -1);
        QVERIFY2(value(widget) != before, widget->metaObject()->className());
    }
}

void WheelTest::theAreaBehindScrolls() {
    const view::WheelNeedsFocus filter(qApp);
    QScrollArea area;
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    auto* list = new QComboBox;
    list->addItems({QStringLiteral("a"), QStringLiteral("b")});
    auto* slider = new QSlider(Qt::Horizontal);
    auto* box = new QSpinBox;
    auto* tabs = twoTabs();
    for (QWidget* widget : QList<QWidget*>{list, slider, box, tabs})
        layout->addWidget(widget);
    content->setMinimumHeight(2000);
    area.setWidget(content);
    area.resize(200, 200);
    area.show();
    QVERIFY(QTest::qWaitForWindowExposed(&area));
    area.setFocus();
    for (QWidget* widget : QList<QWidget*>{list, slider, box, tabs}) {
        const QString before = value(widget);
        const int place = area.verticalScrollBar()->value();
        turn(widget, -1);
        QCOMPARE(value(widget), before);
        QVERIFY(area.verticalScrollBar()->value() > place);
    }
}

BARYCAGE_TEST(WheelTest, QApplication);
#include "wheel_test.moc"
