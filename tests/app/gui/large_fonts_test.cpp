// SPDX-License-Identifier: MIT
#include "support/every_window.h"
#include "support/own_settings.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
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
    QTest::qWait(50);
    QStringList found = cutIn(part);
    for (int patience = 100; patience > 0 && !found.isEmpty(); --patience) {
        QTest::qWait(50);
        found = cutIn(part);
    }
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

QTEST_MAIN(LargeFontsTest)
#include "large_fonts_test.moc"
