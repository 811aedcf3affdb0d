// SPDX-License-Identifier: MIT
#include "support/background_rest.h"
#include "support/every_window.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/own_settings.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScopeGuard>
#include <QSet>
#include <QTest>

using support::EveryWindow;

// With letters of twice the usual size every text in the window, its panels and its dialogs has its room.
class LargeFontsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void noTextIsCut_data();
    void noTextIsCut();
    void dialogsFitASmallScreen_data();
    void dialogsFitASmallScreen();

private:
    static QString cut(const QWidget* widget);
    static QStringList cutIn(const QWidget* part);
    static QStringList leftCutIn(const QWidget* part);
};

// What is missing to the text of the widget; empty when nothing is.
QString LargeFontsTest::cut(const QWidget* widget) {
    const QSize size = widget->size();
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        if (label->text().isEmpty()) return {};
        const int needed =
            label->wordWrap() ? label->heightForWidth(size.width()) : label->minimumSizeHint().height();
        if (size.height() < needed) return QStringLiteral("%1 of %2 high").arg(size.height()).arg(needed);
        if (!label->wordWrap() && size.width() < label->minimumSizeHint().width())
            return QStringLiteral("%1 of %2 wide").arg(size.width()).arg(label->minimumSizeHint().width());
        return {};
    }
    const bool isButton =
        qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget);
    if (!isButton && !qobject_cast<const QLineEdit*>(widget)) return {};
    const QSize needed = widget->minimumSizeHint();
    if (size.height() < needed.height())
        return QStringLiteral("%1 of %2 high").arg(size.height()).arg(needed.height());
    if (isButton && size.width() < needed.width())
        return QStringLiteral("%1 of %2 wide").arg(size.width()).arg(needed.width());
    return {};
}

QStringList LargeFontsTest::cutIn(const QWidget* part) {
    QStringList found;
    for (const auto* widget : part->findChildren<QWidget*>()) {
        const bool isOfQt =
            widget->objectName().startsWith(u"qt_") || qobject_cast<QLineEdit*>(widget->parentWidget());
        if (widget->window() != part->window() || !widget->isVisible() || isOfQt) continue;
        if (const QString missing = cut(widget); !missing.isEmpty())
            found << EveryWindow::describe(widget) + QStringLiteral(": ") + missing;
    }
    return found;
}

// When what is computed elsewhere has come, and been given its room.
QStringList LargeFontsTest::leftCutIn(const QWidget* part) {
    constexpr int patience = 5000; // milliseconds
    if (!support::backgroundRests()) return {QStringLiteral("the work in the background does not end")};
    QStringList found;
    (void)QTest::qWaitFor([&] { return (found = cutIn(part)).isEmpty(); }, patience);
    return found;
}

void LargeFontsTest::noTextIsCut_data() {
    QTest::addColumn<int>("points");
    QTest::newRow("usual") << 10;
    QTest::newRow("twice") << 20;
}

void LargeFontsTest::noTextIsCut() {
    QFETCH(int, points);
    const QFont before = QApplication::font();
    QFont font = before;
    font.setPointSize(points);
    QApplication::setFont(font);
    QStringList found;
    {
        const EveryWindow windows;
        for (auto* dock : windows.main().findChildren<QDockWidget*>()) {
            if (!dock->isVisible()) continue;
            dock->raise();
            found += leftCutIn(dock); // those behind others have any size
        }
        for (const auto& dialog : windows.dialogs()) {
            if (!dialog) continue; // the command palette goes when another window comes
            dialog->setWindowModality(Qt::NonModal);
            dialog->show();
            found += leftCutIn(dialog);
            dialog->hide();
        }
    }
    QApplication::setFont(before);
    found.removeDuplicates();
    for (const QString& text : found)
        qWarning("%s", qPrintable(text));
    QVERIFY(found.isEmpty());
}

void LargeFontsTest::dialogsFitASmallScreen_data() {
    support::addLanguages();
}

// 1366 by 768 pixels, of which the desktop keeps some, with letters of 175 %.
void LargeFontsTest::dialogsFitASmallScreen() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    const QFont before = QApplication::font();
    QFont large = before;
    large.setPointSizeF(1.75 * before.pointSizeF());
    QApplication::setFont(large);
    const auto back = qScopeGuard([&] { QApplication::setFont(before); });
    QStringList found;
    QSet<QString> seen;
    {
        const EveryWindow windows;
        for (const auto& dialog : windows.dialogs()) {
            if (!dialog) continue;
            dialog->setWindowModality(Qt::NonModal);
            dialog->show();
            support::handleEvents();
            const QSize needed = dialog->minimumSizeHint().expandedTo(dialog->minimumSize());
            seen << QString::fromLatin1(dialog->metaObject()->className());
            if (needed.width() > 1366 || needed.height() > 728)
                found << QStringLiteral("%1: %2 x %3")
                             .arg(EveryWindow::describe(dialog))
                             .arg(needed.width())
                             .arg(needed.height());
            dialog->hide();
        }
        for (const auto* dock : windows.main().findChildren<QDockWidget*>()) { // that float, the lesson too
            seen << dock->objectName();
            const QSize needed = dock->minimumSizeHint();
            if (needed.width() > 1366 || needed.height() > 728)
                found << QStringLiteral("%1: %2 x %3")
                             .arg(dock->objectName())
                             .arg(needed.width())
                             .arg(needed.height());
        }
    }
    for (const char* name : {"view::ExportDialog", "view::PreferencesDialog", "lesson", "maps"})
        QVERIFY2(seen.contains(QLatin1String(name)), name);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

BARYCAGE_TEST(LargeFontsTest, QApplication);
#include "large_fonts_test.moc"
