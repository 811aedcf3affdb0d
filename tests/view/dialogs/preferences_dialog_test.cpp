// SPDX-License-Identifier: MIT
#include "desktop/settings.h"
#include "desktop/theme.h"
#include "dialogs/preferences_dialog.h"
#include "support/choose.h"
#include "support/contrast.h"
#include "support/events.h"
#include "support/forget_settings.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QProxyStyle>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStyle>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

using view::Preferences;
using view::PreferencesDialog;

// Choices are stored and reported at once, and restored later.
class PreferencesDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init() { support::forgetSettings(); }
    void cleanup() { view::applyTheme(Preferences::Theme::Desktop); }
    void choicesAreStoredAndTold();
    void aLanguageThatIsNotSpokenYetIsSaid();
    void unsavedWorkIsNamedWithTheLanguage();
    void defaultsComeBack();
    void spoiltSettingsAreTakenAsDefaults();
    void everyLanguageHasItsCatalogue();
    void themesAreWornAndTakenOff();
    void whatIsNotCheckedIsSeen();
    void aButtonThatIsOnIsSeen();
    void theTabThatIsChosenIsSeen();
    void theArrowOfAMenuIsBesideItsText();
    void theButtonsOfPanelsAreSeen();
    void theFocusIsSeen();

private:
    static QComboBox* box(const PreferencesDialog& dialog, const QString& name) {
        for (auto* found : dialog.findChildren<QComboBox*>())
            if (found->accessibleName() == name) return found;
        return nullptr;
    }
    static QCheckBox* reopening(const PreferencesDialog& dialog) {
        for (auto* found : dialog.findChildren<QCheckBox*>())
            if (found->text().startsWith(QStringLiteral("Re&open"))) return found;
        return nullptr;
    }
};

void PreferencesDialogTest::choicesAreStoredAndTold() {
    PreferencesDialog dialog;
    dialog.show();
    QSignalSpy told(&dialog, &PreferencesDialog::changed);
    support::choose(box(dialog, QStringLiteral("Theme")), Preferences::Theme::Dark);
    support::choose(box(dialog, QStringLiteral("Picture at rest")), quint64(1'000'000'000));
    QLabel* restart = nullptr;
    for (auto* label : dialog.findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("Restart"))) restart = label;
    QVERIFY(restart && !restart->isVisible());
    support::choose(box(dialog, QStringLiteral("Language")), QStringLiteral("mk"));
    QVERIFY(restart->isVisible());
    QTRY_VERIFY(restart->height() >= restart->heightForWidth(restart->width())); // seen whole
    support::handleEvents();
    QVERIFY(restart->height() >= restart->heightForWidth(restart->width()));
    reopening(dialog)->click();
    Preferences chosen;
    chosen.language = QStringLiteral("mk");
    chosen.theme = Preferences::Theme::Dark;
    chosen.quality = 1'000'000'000;
    chosen.reopen = true;
    QCOMPARE(told.size(), 4);
    QVERIFY(told.last().first().value<Preferences>() == chosen);
    QVERIFY(Preferences::stored() == chosen);

    const PreferencesDialog again;
    QCOMPARE(box(again, QStringLiteral("Language"))->currentText(), QStringLiteral("Македонски"));
    QVERIFY(reopening(again)->isChecked());
}

// Also once the dialog has been closed in between.
void PreferencesDialogTest::aLanguageThatIsNotSpokenYetIsSaid() {
    const auto isOffered = [] {
        PreferencesDialog dialog;
        dialog.show();
        return support::button(dialog, "restart")->isVisible();
    };
    const view::Preferences before = view::Preferences::stored();
    view::Preferences::setSpokenLanguage(before.language);
    QVERIFY(!isOffered());
    view::Preferences chosen = before;
    chosen.language = QStringLiteral("mk");
    chosen.store();
    QVERIFY(isOffered());
    before.store();
    QVERIFY(!isOffered());
}

void PreferencesDialogTest::unsavedWorkIsNamedWithTheLanguage() {
    const QStringList names{QStringLiteral("leaves.ifs"), QStringLiteral("Untitled")};
    for (const QStringList& unsaved : {names, QStringList()}) {
        PreferencesDialog dialog;
        dialog.setUnsaved(unsaved);
        dialog.show();
        QString said;
        const auto read = [&] {
            const auto* note = dialog.findChild<QLabel*>(QStringLiteral("restart-note"));
            said = note->isVisible() ? note->text() : QString();
        };
        read();
        QVERIFY(said.isEmpty());
        QAbstractButton* restart = support::button(dialog, "restart");
        QVERIFY(!restart->isVisible());
        support::choose(box(dialog, QStringLiteral("Language")), QStringLiteral("mk"));
        QVERIFY(restart->isVisible());
        QSignalSpy wanted(&dialog, &PreferencesDialog::restartRequested);
        restart->click();
        QCOMPARE(wanted.size(), 1);
        read();
        QVERIFY(!said.isEmpty());
        for (const QString& name : names)
            QCOMPARE(said.contains(name), unsaved.contains(name));
        QCOMPARE(said.contains(QStringLiteral("Not saved")), !unsaved.isEmpty());
        support::choose(box(dialog, QStringLiteral("Language")), QString());
        read();
        QVERIFY(said.isEmpty());
    }
}

void PreferencesDialogTest::defaultsComeBack() {
    Preferences before;
    before.language = QStringLiteral("fr");
    before.theme = Preferences::Theme::Light;
    before.quality = 50'000'000;
    before.trackball = before.reopen = true;
    before.store();
    PreferencesDialog dialog;
    QSignalSpy told(&dialog, &PreferencesDialog::changed);
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
    QCOMPARE(told.size(), 1);
    QVERIFY(Preferences::stored() == Preferences{});
}

void PreferencesDialogTest::spoiltSettingsAreTakenAsDefaults() {
    view::finishStoring();
    QSettings().setValue(QStringLiteral("preferences/theme"), QStringLiteral("purple"));
    view::finishStoring();
    QSettings().setValue(QStringLiteral("preferences/quality"), QStringLiteral("many"));
    QCOMPARE(Preferences::stored().theme, Preferences::Theme::Desktop);
    QCOMPARE(Preferences::stored().quality, std::uint64_t(1'000'000)); // the least that is a picture
    const PreferencesDialog dialog;
    QCOMPARE(view::chosenValue<Preferences::Theme>(box(dialog, QStringLiteral("Theme"))),
             Preferences::Theme::Desktop);
}

void PreferencesDialogTest::everyLanguageHasItsCatalogue() {
    const PreferencesDialog dialog;
    const QComboBox* languages = box(dialog, QStringLiteral("Language"));
    QStringList offered;
    for (int i = 1; i < languages->count(); ++i)
        offered << QStringLiteral("barycage_%1.qm").arg(languages->itemData(i).toString());
    QStringList carried = QDir(QStringLiteral(":/translations")).entryList({QStringLiteral("barycage_*.qm")});
    offered.sort();
    carried.sort();
    QCOMPARE(offered, carried);
}

void PreferencesDialogTest::themesAreWornAndTakenOff() {
    const auto styleName = [] {
        const auto* proxy = qobject_cast<QProxyStyle*>(QApplication::style());
        return (proxy ? proxy->baseStyle() : QApplication::style())->name();
    };
    const QString style = styleName();
    view::applyTheme(Preferences::Theme::Desktop);
    const QPalette desktop = QApplication::palette();
    for (const auto theme : {Preferences::Theme::Dark, Preferences::Theme::Light}) {
        view::applyTheme(theme);
        const QPalette worn = QApplication::palette();
        const bool dark = theme == Preferences::Theme::Dark;
        QCOMPARE(worn.color(QPalette::Window).lightness() < 128, dark);
        QCOMPARE(worn.color(QPalette::Text).lightness() > 128, dark);
        QCOMPARE(worn.color(QPalette::PlaceholderText).rgb(), worn.color(QPalette::Text).rgb());
        QVERIFY(worn.color(QPalette::PlaceholderText).alpha() < 255);
    }
    view::applyTheme(Preferences::Theme::Desktop);
    QCOMPARE(styleName(), style);
    for (const auto role : {QPalette::Window, QPalette::Base, QPalette::Text, QPalette::Highlight})
        QCOMPARE(QApplication::palette().color(role), desktop.color(role));
}

// The frame of a box or circle without its mark has a contrast of 3 to 1 to the window and to its inside.
void PreferencesDialogTest::whatIsNotCheckedIsSeen() {
    for (const auto theme : {Preferences::Theme::Dark, Preferences::Theme::Light}) {
        view::applyTheme(theme);
        QWidget window;
        QAbstractButton* buttons[] = {new QCheckBox(&window), new QRadioButton(&window)};
        window.resize(60, 60);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (QAbstractButton* button : buttons) {
            const QImage seen = button->grab().toImage();
            const QRgb around = window.palette().color(QPalette::Window).rgb();
            const QRgb inside = window.palette().color(QPalette::Base).rgb();
            double best = 0; // of the smaller of both contrasts
            for (int x = 0; x < seen.width(); ++x) {
                const QRgb pixel = seen.pixel(x, seen.height() / 2);
                best = std::max(best,
                                std::min(support::contrast(pixel, around), support::contrast(pixel, inside)));
            }
            QVERIFY2(best >= 3, qPrintable(QStringLiteral("%1 in theme %2: %3")
                                               .arg(QLatin1String(button->metaObject()->className()))
                                               .arg(int(theme))
                                               .arg(best)));
        }
    }
}

// So does the frame of a button that is on, to the window and to a button that is off; its text is readable.
void PreferencesDialogTest::aButtonThatIsOnIsSeen() {
    for (const auto theme : {Preferences::Theme::Dark, Preferences::Theme::Light}) {
        view::applyTheme(theme);
        QWidget window;
        window.resize(120, 60);
        std::array<QAbstractButton*, 6> buttons{new QToolButton(&window), new QToolButton(&window),
                                                new QToolButton(&window), new QToolButton(&window),
                                                new QPushButton(&window), new QPushButton(&window)};
        static_cast<QToolButton*>(buttons[2])->setAutoRaise(true);
        static_cast<QToolButton*>(buttons[3])->setAutoRaise(true);
        for (std::size_t i = 0; i < buttons.size(); ++i) {
            buttons[i]->setCheckable(true);
            buttons[i]->setChecked(i % 2 == 0);
            buttons[i]->setFixedSize(40, 24);
            buttons[i]->setFocusPolicy(Qt::NoFocus);
        }
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (std::size_t i = 0; i < buttons.size(); i += 2) {
            const QImage on = buttons[i]->grab().toImage();
            const QImage off = buttons[i + 1]->grab().toImage();
            const QRgb around = window.palette().color(QPalette::Window).rgb();
            double best = 0; // of the smaller of both contrasts
            for (int x = 0; x < 20; ++x)
                best = std::max(best, std::min(support::contrast(on.pixel(x, 12), around),
                                               support::contrast(on.pixel(x, 12), off.pixel(20, 12))));
            const QRgb text = window.palette().color(QPalette::ButtonText).rgb();
            const QString which =
                QStringLiteral("button %1 in theme %2: %3").arg(i).arg(int(theme)).arg(best);
            QVERIFY2(best >= 3, qPrintable(which));
            QVERIFY2(support::contrast(on.pixel(20, 12), text) >= 4.5, qPrintable(which));
        }
    }
}

// A bar on the edge of its tab stands out from the window by 3 to 1, and the other tab has none.
void PreferencesDialogTest::theTabThatIsChosenIsSeen() {
    for (const auto theme : {Preferences::Theme::Dark, Preferences::Theme::Light})
        for (const auto shape : {QTabBar::RoundedNorth, QTabBar::RoundedEast}) {
            view::applyTheme(theme);
            QTabBar tabs;
            tabs.setShape(shape);
            tabs.addTab(QStringLiteral("one"));
            tabs.addTab(QStringLiteral("two"));
            tabs.show();
            QVERIFY(QTest::qWaitForWindowExposed(&tabs));
            const QImage seen = tabs.grab().toImage();
            const QRgb around = tabs.palette().color(QPalette::Window).rgb();
            const auto barOf = [&](int tab) {
                const QRect area = tabs.tabRect(tab);
                double best = 0;
                for (int depth = 1; depth < 5; ++depth) {
                    const QPoint at = shape == QTabBar::RoundedEast
                                          ? QPoint(area.right() - depth, area.center().y())
                                          : QPoint(area.center().x(), area.top() + depth);
                    const QColor here = seen.pixelColor(at); // coloured, not grey
                    if (here.saturation() > 60) best = std::max(best, support::contrast(here.rgb(), around));
                }
                return best;
            };
            QVERIFY2(barOf(0) >= 3, qPrintable(QString::number(barOf(0))));
            QCOMPARE(barOf(1), 0.0);
        }
}

// Level with it, not in the corner below.
void PreferencesDialogTest::theArrowOfAMenuIsBesideItsText() {
    view::applyTheme(Preferences::Theme::Light);
    for (const auto direction : {Qt::LeftToRight, Qt::RightToLeft}) {
        QWidget window;
        window.resize(120, 60);
        QMenu menu;
        QToolButton with(&window), without(&window);
        for (QToolButton* button : {&with, &without}) {
            button->setLayoutDirection(direction);
            button->setText(QStringLiteral("Fit"));
            button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
            button->setFixedSize(80, 30);
            button->setFocusPolicy(Qt::NoFocus);
        }
        with.setMenu(&menu);
        with.setPopupMode(QToolButton::InstantPopup);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const QImage arrow = with.grab().toImage(), plain = without.grab().toImage();
        QRect seen;
        for (int y = 0; y < plain.height(); ++y)
            for (int x = direction == Qt::LeftToRight ? 55 : 0; x < (direction == Qt::LeftToRight ? 80 : 25);
                 ++x)
                if (std::abs(qGray(arrow.pixel(x, y)) - qGray(plain.pixel(x, y))) > 40)
                    seen |= QRect(x, y, 1, 1);

        QVERIFY(!seen.isEmpty() && seen.width() < 20);
        QVERIFY2(std::abs(seen.center().y() - 15) <= 2, qPrintable(QString::number(seen.center().y())));
    }
}

// Fusion has them in dark grey, which is not seen in a dark theme.
void PreferencesDialogTest::theButtonsOfPanelsAreSeen() {
    for (const auto theme : {Preferences::Theme::Dark, Preferences::Theme::Light}) {
        view::applyTheme(theme);
        QMainWindow window;
        window.resize(400, 300);
        auto* panel = new QDockWidget(QStringLiteral("Maps"), &window);
        panel->setWidget(new QWidget(panel));
        window.addDockWidget(Qt::LeftDockWidgetArea, panel);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        for (const char* name : {"qt_dockwidget_closebutton", "qt_dockwidget_floatbutton"}) {
            const auto* button = panel->findChild<QAbstractButton*>(QLatin1String(name));
            QVERIFY(button && button->isVisible());
            const QImage image = panel->grab(button->geometry()).toImage();
            double best = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    best = std::max(best, support::contrast(image.pixel(x, y), image.pixel(0, 0)));
            QVERIFY2(
                best >= 3,
                qPrintable(
                    QStringLiteral("%1 in theme %2: %3").arg(QLatin1String(name)).arg(int(theme)).arg(best)));
        }
    }
}

// That the keys have brought to a control, in either theme, also to a button that is on.
void PreferencesDialogTest::theFocusIsSeen() {
    for (const auto theme : {Preferences::Theme::Dark, Preferences::Theme::Light}) {
        view::applyTheme(theme);
        QWidget window;
        auto* elsewhere = new QPushButton(QStringLiteral("elsewhere"), &window);
        auto* tabs = new QTabBar(&window);
        tabs->addTab(QStringLiteral("one"));
        tabs->addTab(QStringLiteral("two"));
        auto* on = new QPushButton(QStringLiteral("on"), &window);
        auto* toolOn = new QToolButton(&window);
        for (QAbstractButton* button :
             {static_cast<QAbstractButton*>(on), static_cast<QAbstractButton*>(toolOn)}) {
            button->setCheckable(true);
            button->setChecked(true);
        }
        auto* list = new QComboBox(&window);
        list->addItem(QStringLiteral("one"));
        const QList<QWidget*> controls{new QPushButton(QStringLiteral("off"), &window),
                                       on,
                                       new QToolButton(&window),
                                       toolOn,
                                       new QCheckBox(QStringLiteral("box"), &window),
                                       new QRadioButton(QStringLiteral("radio"), &window),
                                       new QLineEdit(&window),
                                       list,
                                       new QSpinBox(&window),
                                       tabs};
        QVBoxLayout layout(&window);
        layout.addWidget(elsewhere);
        for (QWidget* control : controls) {
            control->setFocusPolicy(Qt::StrongFocus);
            control->setMinimumSize(80, 24);
            layout.addWidget(control);
        }
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        window.setAttribute(Qt::WA_KeyboardFocusChange); // as the Tab key does
        for (QWidget* control : controls) {
            elsewhere->setFocus(Qt::TabFocusReason);
            QTRY_VERIFY(elsewhere->hasFocus());
            const QImage without = control->grab().toImage();
            control->setFocus(Qt::TabFocusReason);
            QTRY_VERIFY(control->hasFocus());
            const QImage with = control->grab().toImage();
            QCOMPARE(with.size(), without.size());
            int different = 0;
            for (int y = 0; y < with.height(); ++y)
                for (int x = 0; x < with.width(); ++x)
                    different += support::contrast(with.pixel(x, y), without.pixel(x, y)) > 1.5;
            QVERIFY2(different >= 10, qPrintable(QStringLiteral("%1 in theme %2: %3 pixels")
                                                     .arg(QLatin1String(control->metaObject()->className()))
                                                     .arg(int(theme))
                                                     .arg(different)));
        }
    }
}

BARYCAGE_TEST(PreferencesDialogTest, QApplication);
#include "preferences_dialog_test.moc"
