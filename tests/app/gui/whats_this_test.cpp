// SPDX-License-Identifier: MIT
#include "support/every_window.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "widgets/text/tooltip_text.h"
#include "widgets/tooltips.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QSet>
#include <QSpinBox>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <QTranslator>

using support::EveryWindow;

namespace {

// A language in which every translated text has brackets around it.
class Brackets : public QTranslator {
public:
    QString translate(const char* context, const char* text, const char*, int) const override {
        static const QRegularExpression keys(QStringLiteral("^((Ctrl|Shift|Alt)\\+)*(\\S|F\\d+)$"));
        if (qstrcmp(context, "QShortcut") == 0 || keys.match(QString::fromUtf8(text)).hasMatch()) return {};
        return QStringLiteral("⟦%1⟧").arg(QString::fromUtf8(text));
    }
    bool isEmpty() const override { return false; }
};

} // namespace

// Everything in the window and its dialogs explains itself, has a name for those who do not see it, and
// speaks the language of the user.
class WhatsThisTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void everyDialogIsLookedAt();
    void everythingExplainsItself();
    void tipsAreNameShortcutAndOneSentence();
    void whatsThisSaysMoreThanTheTip();
    void everyTipIsOneSentence();
    void iconsAreNamed();
    void labelsAreWords();
    void digitsStandInGroups();
    void everythingHasAName();
    void everyTextIsTranslated();

private:
    // Those that are pressed, typed in, chosen from or dragged.
    static bool isButtonOrField(const QWidget* control) {
        return qobject_cast<const QAbstractButton*>(control) || qobject_cast<const QLineEdit*>(control) ||
               qobject_cast<const QAbstractSpinBox*>(control) || qobject_cast<const QComboBox*>(control) ||
               qobject_cast<const QAbstractSlider*>(control);
    }
    static QList<QAction*> actionsOf(const QWidget* window) {
        QList<QAction*> found;
        for (QAction* action : window->findChildren<QAction*>())
            if (!action->isSeparator() && !action->menu() && !action->objectName().startsWith(u"_q_") &&
                !action->text().isEmpty() && !QByteArray(action->metaObject()->className()).contains("Whats"))
                found << action;
        return found;
    }
};

void WhatsThisTest::everyDialogIsLookedAt() {
    const EveryWindow windows;
    QSet<QByteArray> kinds;
    for (const QWidget* window : windows.all())
        kinds << window->metaObject()->className();
    for (const char* kind :
         {"MainWindow", "view::ExportDialog", "view::ExportDataDialog", "view::TransformDialog",
          "view::MutateDialog", "view::RandomDialog", "view::AifsDialog", "view::PreferencesDialog",
          "view::ShortcutsDialog", "view::VertexDialog", "view::CommandPalette"})
        QVERIFY2(kinds.contains(kind), kind);
    QVERIFY(EveryWindow::controls(windows.all().first()).size() > 60);
}

void WhatsThisTest::everythingExplainsItself() {
    const EveryWindow windows;
    QStringList silent;
    for (const QWidget* window : windows.all()) {
        for (const QWidget* control : EveryWindow::controls(window))
            if (control->whatsThis().isEmpty()) silent << EveryWindow::describe(control);
        for (const QAction* action : actionsOf(window))
            if (action->whatsThis().isEmpty())
                silent << EveryWindow::describe(window) + QStringLiteral(" › action ") + action->text();
    }
    for (const auto* dock : windows.main().findChildren<QDockWidget*>())
        if (dock->whatsThis().isEmpty()) silent << QStringLiteral("panel ") + dock->windowTitle();
    QVERIFY2(silent.isEmpty(), qPrintable(silent.join(u'\n')));
}

void WhatsThisTest::tipsAreNameShortcutAndOneSentence() {
    const view::Tooltips tooltips(qApp);
    const EveryWindow windows;
    MainWindow& window = windows.main();
    const auto* bar = window.findChild<QToolBar*>(QStringLiteral("tools"));
    int buttons = 0;
    for (auto* button : bar->findChildren<QToolButton*>()) {
        const QAction* action = button->defaultAction();
        if (!action || action->text().isEmpty()) continue;
        const QString name = QString(action->text()).remove(u'&').remove(u'…');
        const QString tip = view::composedTip(*button);
        QVERIFY2(tip.contains(QStringLiteral("<b>%1</b>").arg(name)), qPrintable(tip));
        if (!action->shortcut().isEmpty())
            QVERIFY2(tip.contains(action->shortcut().toString(QKeySequence::NativeText)), qPrintable(tip));
        const QString rest = tip.section(QStringLiteral("<br>"), 1).remove(QStringLiteral("</p>"));
        QVERIFY2(rest.endsWith(u'.') && rest.size() > 5, qPrintable(tip));
        ++buttons;
    }
    QCOMPARE(buttons, 10);
    // As it is shown.
    auto* shown = bar->findChildren<QToolButton*>().at(1);
    for (auto* button : bar->findChildren<QToolButton*>())
        if (button->isVisible() && button->defaultAction()) shown = button;
    QHelpEvent help(QEvent::ToolTip, shown->rect().center(), shown->mapToGlobal(shown->rect().center()));
    QApplication::sendEvent(shown, &help);
    QCOMPARE(QToolTip::text(), view::composedTip(*shown));
    QToolTip::hideText();
}

void WhatsThisTest::whatsThisSaysMoreThanTheTip() {
    const EveryWindow windows;
    QStringList meagre;
    for (const auto* button : windows.main().findChildren<QToolButton*>())
        if (button->defaultAction() && !button->defaultAction()->text().isEmpty() &&
            button->whatsThis().size() <= button->toolTip().size() + 10)
            meagre << button->defaultAction()->text();
    for (const QAction* action : actionsOf(&windows.main()))
        if (action->isEnabled() &&
            action->objectName() != QStringLiteral("clicking") && // else it says why not
            !action->statusTip().isEmpty() && action->whatsThis().size() <= action->statusTip().size() + 10)
            meagre << action->text();
    QVERIFY2(meagre.isEmpty(), qPrintable(meagre.join(u'\n')));
}

// After the name and the shortcut, if they are known; and the longer explanation is longer.
void WhatsThisTest::everyTipIsOneSentence() {
    static const QRegularExpression between(QStringLiteral("[.!?][\\s]+\\p{Lu}"));
    const EveryWindow windows;
    QStringList wrong;
    int tips = 0;
    for (const QWidget* window : windows.all())
        for (const QWidget* control : EveryWindow::controls(window)) {
            const QString tip = view::plainText(control->toolTip());
            // What is disabled says why.
            if (tip.isEmpty() || !control->isEnabledTo(window) || !isButtonOrField(control)) continue;
            ++tips;
            const QString where = EveryWindow::describe(control) + QStringLiteral(": ") + tip;
            const QString shown = view::composedTip(*control);
            if (tip.contains(between)) wrong << QStringLiteral("more than a sentence: ") + where;
            if (!shown.contains(QLatin1String("<b>"))) wrong << QStringLiteral("no name: ") + where;
            if (view::plainText(control->whatsThis()).size() <= tip.size() + 1)
                wrong << QStringLiteral("What's This says no more: ") + where;
        }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY2(tips > 60, qPrintable(QString::number(tips)));
}

void WhatsThisTest::iconsAreNamed() {
    const EveryWindow windows;
    QStringList wrong;
    int icons = 0;
    for (const QWidget* window : windows.all())
        for (QWidget* control : EveryWindow::controls(window)) {
            const auto* button = qobject_cast<const QAbstractButton*>(control);
            if (!button || button->icon().isNull()) continue;
            const auto* tool = qobject_cast<const QToolButton*>(button);
            const bool showsText =
                !button->text().isEmpty() && (!tool || tool->toolButtonStyle() != Qt::ToolButtonIconOnly);
            if (showsText) continue;
            ++icons;
            const QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(control);
            if (button->toolTip().isEmpty())
                wrong << QStringLiteral("no tip: ") + EveryWindow::describe(button);
            if (!seen || seen->text(QAccessible::Name).trimmed().isEmpty())
                wrong << QStringLiteral("no name: ") + EveryWindow::describe(button);
        }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY2(icons > 20, qPrintable(QString::number(icons)));
}

// In what is read, not typed: no five digits before a decimal point stand together.
void WhatsThisTest::digitsStandInGroups() {
    static const QRegularExpression run(QStringLiteral("(?<![\\d.,])\\d{5,}"));
    const EveryWindow windows;
    QStringList wrong;
    int labels = 0, boxes = 0;
    for (const QWidget* window : windows.all()) {
        for (const auto* label : window->findChildren<QLabel*>()) {
            if (label->text().contains(u'/')) continue; // a path, or a version
            ++labels;
            if (label->text().contains(run))
                wrong << EveryWindow::describe(label) + QStringLiteral(": ") + label->text();
        }
        for (auto* box : window->findChildren<QSpinBox*>())
            if (box->isGroupSeparatorShown()) {
                ++boxes;
                box->setValue(123'456);
                if (!box->text().contains(QStringLiteral("123\u202f456")))
                    wrong << EveryWindow::describe(box);
            }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY2(labels > 60 && boxes >= 2, qPrintable(QStringLiteral("%1 %2").arg(labels).arg(boxes)));
}

// A beginner meets them: formulas are for explanations.
void WhatsThisTest::labelsAreWords() {
    const EveryWindow windows;
    QStringList formulas;
    int labels = 0;
    for (const QWidget* window : windows.all()) {
        for (const auto* button : window->findChildren<QAbstractButton*>())
            if (++labels; button->text().contains(u'ⁿ')) formulas << EveryWindow::describe(button);
        for (const QAction* action : actionsOf(window))
            if (++labels; action->text().contains(u'ⁿ')) formulas << action->text();
    }
    QVERIFY2(formulas.isEmpty(), qPrintable(formulas.join(u'\n')));
    QVERIFY(labels > 300);
}

void WhatsThisTest::everythingHasAName() {
    const EveryWindow windows;
    QStringList nameless;
    for (const QWidget* window : windows.all())
        for (QWidget* control : EveryWindow::controls(window)) {
            const QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(control);
            if (!seen || seen->text(QAccessible::Name).trimmed().isEmpty())
                nameless << EveryWindow::describe(control);
        }
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(u'\n')));
}

void WhatsThisTest::everyTextIsTranslated() {
    Brackets brackets;
    QApplication::installTranslator(&brackets);
    QStringList plain;
    {
        const EveryWindow windows;
        const QRegularExpression words(QStringLiteral("\\p{L}{3,}"));
        const auto look = [&](const QObject* object, const QString& where) {
            for (const char* property : {"text", "title", "windowTitle", "toolTip", "statusTip", "whatsThis",
                                         "accessibleName", "placeholderText", "suffix", "prefix"}) {
                const QString text = object->property(property).toString();
                if (text.contains(words) && !text.contains(u'⟦'))
                    plain << where + u' ' + QLatin1String(property) + QStringLiteral(": ") + text;
            }
        };
        for (const QWidget* window : windows.all()) {
            look(window, EveryWindow::describe(window));
            for (const QWidget* widget : window->findChildren<QWidget*>())
                if (widget->window() == window && !widget->inherits("QLineEdit") &&
                    !widget->inherits("QTextEdit") && !widget->inherits("QComboBox"))
                    look(widget, EveryWindow::describe(widget));
            for (const QAction* action : actionsOf(window))
                look(action, QStringLiteral("action ") + action->text());
        }
    }
    QApplication::removeTranslator(&brackets);
    plain.removeDuplicates();
    QVERIFY2(plain.isEmpty(), qPrintable(plain.join(u'\n')));
}

BARYCAGE_TEST(WhatsThisTest, QApplication);
#include "whats_this_test.moc"
