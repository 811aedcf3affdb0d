// SPDX-License-Identifier: MIT
#include "desktop/theme.h"
#include "support/contrast.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTabBar>
#include <QTableWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <functional>

using Theme = view::Preferences::Theme;

// What has the keyboard is seen, in both themes.
class FocusTest : public QObject {
    Q_OBJECT

private slots:
    void whatHasTheFocusIsSeen_data();
    void whatHasTheFocusIsSeen();
    void theCurrentCellIsSeenInASelectedRow_data();
    void theCurrentCellIsSeenInASelectedRow();

private:
    static int changedPixels(const QImage& a, const QImage& b);
};

// That stand out from what they were, by 3 to 1.
int FocusTest::changedPixels(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += support::contrast(a.pixel(x, y), b.pixel(x, y)) >= 3;
    return count;
}

void FocusTest::whatHasTheFocusIsSeen_data() {
    using Make = std::function<QWidget*()>;
    QTest::addColumn<Theme>("theme");
    QTest::addColumn<Make>("make");
    const auto list = [](bool isFilled, bool isSelected) {
        auto* made = new QListWidget;
        if (isFilled) made->addItems({QStringLiteral("maple"), QStringLiteral("fern")});
        if (isSelected) made->setCurrentRow(0);
        return made;
    };
    const std::pair<const char*, Make> widgets[]{
        {"slider", [] { return new QSlider(Qt::Horizontal); }},
        {"upright slider", [] { return new QSlider(Qt::Vertical); }},
        {"empty list", [list] { return list(false, false); }},
        {"list", [list] { return list(true, false); }},
        {"list with a selected row", [list] { return list(true, true); }},
        {"table",
         [] {
             auto* table = new QTableWidget(2, 2);
             table->setCurrentCell(0, 0);
             return table;
         }},
        {"tree",
         [] {
             auto* tree = new QTreeWidget;
             tree->addTopLevelItem(new QTreeWidgetItem({QStringLiteral("maple")}));
             return tree;
         }},
        {"tab bar",
         [] {
             auto* bar = new QTabBar;
             bar->addTab(QStringLiteral("Maps"));
             bar->addTab(QStringLiteral("Cage"));
             return bar;
         }},
        {"upright tab bar",
         [] {
             auto* bar = new QTabBar;
             bar->setShape(QTabBar::RoundedEast);
             bar->addTab(QStringLiteral("Maps"));
             bar->addTab(QStringLiteral("Cage"));
             return bar;
         }},
        {"check box", [] { return new QCheckBox(QStringLiteral("Hull")); }},
        {"tool button",
         [] {
             auto* button = new QToolButton;
             button->setText(QStringLiteral("Fit"));
             button->setFocusPolicy(Qt::StrongFocus);
             return button;
         }},
    };
    for (const Theme theme : {Theme::Light, Theme::Dark})
        for (const auto& [name, make] : widgets)
            QTest::addRow("%s, %s", name, theme == Theme::Light ? "light" : "dark") << theme << make;
}

void FocusTest::whatHasTheFocusIsSeen() {
    QFETCH(Theme, theme);
    QFETCH(std::function<QWidget*()>, make);
    view::applyTheme(theme);
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* other = new QPushButton(QStringLiteral("Other"));
    QWidget* widget = make();
    layout->addWidget(other);
    layout->addWidget(widget);
    window.resize(240, 200);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    other->setFocus(Qt::ShortcutFocusReason); // as by keys
    QTRY_VERIFY(other->hasFocus());
    const QImage without = widget->grab().toImage();
    widget->setFocus(Qt::ShortcutFocusReason);
    QTRY_VERIFY(widget->hasFocus());
    const QImage with = widget->grab().toImage();
    const int changed = changedPixels(with, without);
    QVERIFY2(changed >= 30, qPrintable(QString::number(changed)));
}

void FocusTest::theCurrentCellIsSeenInASelectedRow_data() {
    QTest::addColumn<Theme>("theme");
    QTest::addRow("light") << Theme::Light;
    QTest::addRow("dark") << Theme::Dark;
}

// The frame is two pixels wide, also after a click.
void FocusTest::theCurrentCellIsSeenInASelectedRow() {
    QFETCH(Theme, theme);
    view::applyTheme(theme);
    QTableWidget table(2, 2);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.resize(320, 160);
    table.show();
    QVERIFY(QTest::qWaitForWindowActive(&table));
    table.setFocus();
    const auto cell = [&table](int column) { return table.visualRect(table.model()->index(0, column)); };
    const auto click = [&](int column) {
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell(column).center());
        QTest::mouseMove(table.viewport(), QPoint(10, 100)); // nothing is under the pointer
        QCOMPARE(table.currentColumn(), column);
        QVERIFY(table.selectionModel()->isRowSelected(0));
    };
    click(1);
    const QImage without = table.viewport()->grab(cell(0)).toImage();
    click(0);
    const QImage with = table.viewport()->grab(cell(0)).toImage();
    const int around = 2 * (cell(0).width() + cell(0).height());
    const int changed = changedPixels(with, without);
    QVERIFY2(changed >= around * 3 / 2, qPrintable(QStringLiteral("%1 of %2").arg(changed).arg(around)));
}

BARYCAGE_TEST(FocusTest, QApplication);
#include "focus_test.moc"
