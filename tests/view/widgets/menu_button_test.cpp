// SPDX-License-Identifier: MIT
#include "widgets/menus/menu_button.h"

#include "desktop/theme.h"
#include "support/named_test.h"

#include <QMenu>
#include <QTest>

class MenuButtonTest : public QObject {
    Q_OBJECT

private slots:
    void theArrowKeepsItsDistance_data();
    void theArrowKeepsItsDistance();
    void plainToolButtonsHaveRoomForIt();
};

void MenuButtonTest::theArrowKeepsItsDistance_data() {
    QTest::addColumn<Qt::LayoutDirection>("direction");
    QTest::newRow("left to right") << Qt::LeftToRight;
    QTest::newRow("right to left") << Qt::RightToLeft;
}

void MenuButtonTest::theArrowKeepsItsDistance() {
    QFETCH(Qt::LayoutDirection, direction);
    view::MenuButton button(nullptr);
    button.setLayoutDirection(direction);
    button.setMenu(new QMenu(&button));
    for (const char* text : {"Panels", "A much longer text than that"}) {
        button.setText(QLatin1String(text));
        button.resize(button.sizeHint());
        QVERIFY(button.rect().contains(button.arrowRect()) && button.rect().contains(button.labelRect()));
        QVERIFY(!button.labelRect().intersects(button.arrowRect()));
        const int width = button.fontMetrics().horizontalAdvance(button.text());
        QVERIFY(button.labelRect().width() >= width + 4); // the text is in its middle
    }
}

void MenuButtonTest::plainToolButtonsHaveRoomForIt() {
    view::applyTheme(view::Preferences::Theme::Light);
    QToolButton button;
    button.setText(QStringLiteral("Fit"));
    button.setPopupMode(QToolButton::InstantPopup);
    const int without = button.sizeHint().width();
    button.setMenu(new QMenu(&button));
    QVERIFY(button.sizeHint().width() >= without + 12);
}

BARYCAGE_TEST(MenuButtonTest, QApplication);
#include "menu_button_test.moc"
