// SPDX-License-Identifier: MIT
#include "dialogs/command_palette.h"
#include "messages/tour.h"
#include "support/window_on_x.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTextBrowser>

// What is done or read in dialogs, with a real pointer and real keys.
class RealDialogsTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void transformsAsPlacement();
    void transformsAsCode();
    void aCommandIsFoundByTyping();
    void thePaletteIsLeftUndone();
    void theColoursOfTheProgramAreChosen();
    void theTourIsWalked();
    void theGuideIsRead();
    void whatIsThisIsAsked();
};

void RealDialogsTest::transformsAsPlacement() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const document::Fractal before = fractal();
    const std::vector<ifs::Vector<2>> held = cage().current;
    QDialog* dialog = openDialog("Control+t", "view::TransformDialog");
    QVERIFY(dialog);
    type(named<QLineEdit>(*dialog, QStringLiteral("Rotation in degrees, counter-clockwise")),
         QStringLiteral("90"));
    type(named<QLineEdit>(*dialog, QStringLiteral("Translation in x")), QStringLiteral("0.5"));
    photograph(QStringLiteral("transform.png"));
    click(named<QPushButton>(*dialog, QStringLiteral("OK")));
    QTRY_COMPARE(steps(), 1);
    QVERIFY(document::isSameSystem(fractal(), before));
    for (std::size_t i = 0; i < 3; ++i) { // (x, y) → (−y, x), and the shift goes with both ends of an edge
        const ifs::Vector<2> edge = held[(i + 1) % 3] - held[i];
        const ifs::Vector<2> turned = cage().current[(i + 1) % 3] - cage().current[i];
        QVERIFY((turned - ifs::Vector<2>(-edge.y(), edge.x())).norm() < 1e-12);
    }
    QTRY_VERIFY(support::isInPlace(&window())); // the window manager gives the keyboard back
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(document::plane(savedEntry(path))->cage, document::plane(fractal())->cage);
    QVERIFY(document::isSameSystem(savedEntry(path), before));
}

void RealDialogsTest::transformsAsCode() {
    const QString path = copyOfCollection(QStringLiteral("paper"));
    window().openPath(path);
    const document::Fractal before = fractal();
    QDialog* dialog = openDialog("Control+t", "view::TransformDialog");
    QVERIFY(dialog);
    click(named<QRadioButton>(*dialog, QStringLiteral("Rewrite the code")));
    type(named<QLineEdit>(*dialog, QStringLiteral("Scale in x")), QStringLiteral("2"));
    QTRY_VERIFY(fractal() != before); // live, before it is applied
    click(named<QPushButton>(*dialog, QStringLiteral("Cancel")));
    QTRY_VERIFY(fractal() == before);
    QCOMPARE(steps(), 0);

    dialog = openDialog("Control+t", "view::TransformDialog");
    QVERIFY(dialog);
    click(named<QRadioButton>(*dialog, QStringLiteral("Rewrite the code")));
    type(named<QLineEdit>(*dialog, QStringLiteral("x of the fixed point")), QStringLiteral("0"));
    type(named<QLineEdit>(*dialog, QStringLiteral("y of the fixed point")), QStringLiteral("0"));
    type(named<QLineEdit>(*dialog, QStringLiteral("Scale in x")), QStringLiteral("2"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 1);
    const auto& maps = document::system2(fractal())->maps;
    const auto& old = document::system2(before)->maps;
    for (std::size_t i = 0; i < maps.size(); ++i) { // conjugation by a scaling about the origin
        QVERIFY((maps[i].map.linear - old[i].map.linear).norm() < 1e-12);
        QVERIFY((maps[i].map.translation - 2 * old[i].map.translation).norm() < 1e-12);
    }
    QTRY_VERIFY(support::isInPlace(&window())); // the window manager gives the keyboard back
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());
    QVERIFY(document::isSameSystem(savedEntry(path), fractal()));
}

void RealDialogsTest::aCommandIsFoundByTyping() {
    const std::vector<ifs::Vector<2>> held = cage().current;
    dragBy(vertex(1), {-50, 20});
    QTRY_COMPARE(steps(), 1);
    hand().key("Control+k");
    QTRY_VERIFY(visible<view::CommandPalette>());
    hand().type(QStringLiteral("cage res"));
    hand().key("Return");
    QTRY_COMPARE(steps(), 2);
    QVERIFY(!visible<view::CommandPalette>());
    QCOMPARE(cage().current, held);

    hand().key("Control+k"); // what a panel has brings the panel to the front
    hand().type(QStringLiteral("maps dupl"));
    hand().key("Return");
    QTRY_COMPARE(code().maps.size(), std::size_t{5});
}

void RealDialogsTest::thePaletteIsLeftUndone() {
    hand().key("Control+k");
    QTRY_VERIFY(visible<view::CommandPalette>());
    hand().type(QStringLiteral("new"));
    hand().key("Down");
    hand().key("Escape");
    QTRY_VERIFY(!visible<view::CommandPalette>());
    QCOMPARE(fractal().name, QStringLiteral("maple"));
}

void RealDialogsTest::theColoursOfTheProgramAreChosen() {
    const auto lightness = [this] { return window().palette().color(QPalette::Window).lightness(); };
    QDialog* dialog = openDialog("Control+comma", "view::PreferencesDialog");
    QVERIFY(dialog);
    auto* theme = named<QComboBox>(*dialog, QStringLiteral("Theme"));
    pick(theme, view::Preferences::Theme::Dark);
    QTRY_VERIFY(lightness() < 100);
    photograph(QStringLiteral("dark.png"));
    pick(theme, view::Preferences::Theme::Light);
    QTRY_VERIFY(lightness() > 200);
    click(named<QPushButton>(*dialog, QStringLiteral("Restore Defaults")));
    QTRY_COMPARE(view::chosenValue<view::Preferences::Theme>(theme), view::Preferences::Theme::Desktop);
    hand().key("Escape");
    QTRY_VERIFY(!visible<QDialog>());
}

void RealDialogsTest::theTourIsWalked() {
    choose({QStringLiteral("Help"), QStringLiteral("Tour")});
    QStringList titles;
    for (int step = 1; step <= 6; ++step) {
        auto* tour = window().findChild<Tour*>();
        QVERIFY(tour);
        const QString place = QStringLiteral("%1 of 6").arg(step);
        const auto isThere = [&] {
            for (const auto* label : tour->findChildren<QLabel*>())
                if (label->text() == place) return true;
            return false;
        };
        QTRY_VERIFY(isThere());
        support::handleEvents(); // the banner is laid out
        click(named<QPushButton>(*tour, QStringLiteral("Skip")));
    }
    auto* asking = window().findChild<Tour*>();
    QTRY_COMPARE(asking->step(), Tour::rest);
    support::handleEvents();
    click(named<QPushButton>(*asking, QStringLiteral("Close")));
    QTRY_VERIFY(!window().findChild<Tour*>());
    QVERIFY(!window().isWindowModified());
}

void RealDialogsTest::theGuideIsRead() {
    const auto* guide = openDialog("F1", "QDialog");
    QVERIFY(guide);
    QVERIFY(
        guide->findChild<QTextBrowser*>()->toPlainText().contains(QStringLiteral("Drag the control cage")));
    hand().key("Escape");
    QTRY_VERIFY(!visible<QDialog>());
}

void RealDialogsTest::whatIsThisIsAsked() {
    const auto isExplained = [] {
        for (const QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("QWhatsThat") && widget->isVisible()) return true;
        return false;
    };
    hand().key("Shift+F1");
    hand().clickAt(onCanvas({40, 200}));
    QTRY_VERIFY(isExplained());
    hand().key("Escape");
    QTRY_VERIFY(!isExplained());
    dragBy(vertex(1), {-50, 20});
    QTRY_COMPARE(steps(), 1);
}

BARYCAGE_TEST_ON_X(RealDialogsTest);

#include "real_dialogs_test.moc"
