// SPDX-License-Identifier: MIT
#include "application.h"
#include "dialogs/command_palette.h"
#include "files/recent_files.h"
#include "panels/entries/entries_panel.h"
#include "support/events.h"
#include "support/every_window.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "welcome.h"
#include "widgets/text/tooltip_text.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QCommandLinkButton>
#include <QDir>
#include <QFile>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>
#include <QWindow>

using support::EveryWindow;

namespace {

// As a name in a file, as a name of a file, and as a path: the folders are called `<img src="` and so on.
const QString markup = QStringLiteral("<img src=pipe><b>bold[*] & c");
const QString markupPath = QStringLiteral("<img src=\"/tmp/x.png\"><b>bold</b>.ifs");

bool isMarkup(const QString& text) {
    return text.contains(QStringLiteral("<img")) || text.contains(QStringLiteral("<b>bold"));
}

} // namespace

// What a file has put into a name is shown as it is written, wherever it is shown.
class LiteralNamesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
        QVERIFY(m_folder.isValid());
        put(m_folder.filePath(markupPath));
        m_path = m_folder.filePath(markup + QStringLiteral(".ifs"));
        put(m_path);
    }
    void tipsKeepTheirText();
    void everyTextIsShownAsWritten();
    void theCommandPaletteShowsPathsAsWritten();
    void theWelcomeShowsPathsAsWritten();
    void messagesShowNamesAsWritten();
    void titlesShowNamesAsWritten();

private:
    static void put(const QString& path) {
        QFile file(path);
        if (!QDir().mkpath(QFileInfo(path).path()) || !file.open(QIODevice::WriteOnly))
            qFatal("no test file");
        const QByteArray name = markup.toUtf8();
        file.write(name + " { ; " + name + "\n; " + name + "\n.5 0 0 .5 0 0 .5\n.5 0 0 .5 1 1 .5 }\n\n" +
                   "broken" + name + " { .5 " + name + " }\n");
    }
    // Everything that Qt would take for markup, in one string each; where it stands.
    QStringList takenForMarkup(QObject* object);
    QStringList takenForMarkup(const QAbstractItemModel& model, const QModelIndex& parent = {});
    void note(const QString& text) {
        if (text.contains(QStringLiteral("&lt;img"))) ++m_escaped;
    }

    QTemporaryDir m_folder;
    QString m_path;
    int m_escaped = 0; // texts that would have been markup
};

QStringList LiteralNamesTest::takenForMarkup(const QAbstractItemModel& model, const QModelIndex& parent) {
    QStringList found;
    const auto check = [&](const QString& text) {
        note(text);
        if (isMarkup(text)) found << QStringLiteral("tip of a cell: ") + text;
    };
    for (int row = 0; row < model.rowCount(parent); ++row)
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex index = model.index(row, column, parent);
            for (const int role : {Qt::ToolTipRole, Qt::WhatsThisRole})
                check(index.data(role).toString());
            if (column == 0) found += takenForMarkup(model, index);
        }
    return found;
}

QStringList LiteralNamesTest::takenForMarkup(QObject* object) {
    QStringList found;
    for (const char* property : {"toolTip", "whatsThis"}) {
        const QString text = object->property(property).toString();
        note(text);
        if (isMarkup(text)) found << QLatin1String(property) + QStringLiteral(": ") + text;
    }
    if (const auto* label = qobject_cast<const QLabel*>(object);
        label && isMarkup(label->text()) && label->textFormat() != Qt::PlainText && label->isVisible())
        found << QStringLiteral("label: ") + label->text();
    if (const auto* view = qobject_cast<const QAbstractItemView*>(object); view && view->model())
        found += takenForMarkup(*view->model());
    if (auto* widget = qobject_cast<QWidget*>(object))
        if (const QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(widget);
            seen && seen->text(QAccessible::Name).contains(QStringLiteral("&lt;")))
            found << QStringLiteral("accessible name: ") + seen->text(QAccessible::Name);
    return found;
}

void LiteralNamesTest::tipsKeepTheirText() {
    for (const QString& text : {markup, markupPath, QStringLiteral("plain"), QStringLiteral("a < b & c")}) {
        QVERIFY(!isMarkup(view::tooltipText(text)));
        QCOMPARE(view::plainText(view::tooltipText(text)), text);
    }
}

void LiteralNamesTest::everyTextIsShownAsWritten() {
    recent_files::add(m_folder.filePath(markupPath));
    const EveryWindow windows(m_path);
    MainWindow& main = windows.main();
    QCOMPARE(main.document().fractal().name, markup);
    document::Fractal renamed = main.document().fractal();
    renamed.name += QStringLiteral(" again");
    main.document().edit(QStringLiteral("Rename “%1”").arg(markup), renamed);
    main.findChild<view::EntriesPanel*>()->editComment();
    for (auto* menu : main.findChildren<QMenu*>())
        emit menu->aboutToShow();
    support::handleEvents(); // labels are polished
    QStringList found;
    for (QWidget* window : windows.all()) {
        const QObjectList objects = window->findChildren<QObject*>() << window;
        for (const QPointer<QObject>& object : QList<QPointer<QObject>>(objects.begin(), objects.end()))
            for (const QString& text : object ? takenForMarkup(object) : QStringList()) // some are replaced
                found << EveryWindow::describe(window) + u' ' + text;
    }
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    QVERIFY2(m_escaped >= 5,
             qPrintable(QString::number(m_escaped))); // recent files, history, entries, problems
}

void LiteralNamesTest::theCommandPaletteShowsPathsAsWritten() {
    recent_files::add(m_folder.filePath(markupPath));
    MainWindow window;
    for (auto* menu : window.findChildren<QMenu*>())
        emit menu->aboutToShow();
    view::CommandPalette palette(view::actionsOf(window), &window);
    palette.show();
    palette.findChild<QLineEdit*>()->setText(QStringLiteral("ifs"));
    auto* list = palette.findChild<QAbstractItemView*>();
    const QModelIndex file = list->model()->index(0, 0);
    QVERIFY(file.data().toString().contains(QStringLiteral("b>.ifs")));
    const QPoint middle = list->visualRect(file).center();
    QHelpEvent help(QEvent::ToolTip, middle, list->viewport()->mapToGlobal(middle));
    QApplication::sendEvent(list->viewport(), &help);
    QVERIFY2(QToolTip::text().contains(QStringLiteral("&lt;img")), qPrintable(QToolTip::text()));
    QVERIFY2(!isMarkup(QToolTip::text()), qPrintable(QToolTip::text()));
    QToolTip::hideText();
}

void LiteralNamesTest::theWelcomeShowsPathsAsWritten() {
    recent_files::add(m_folder.filePath(markupPath));
    MainWindow window;
    window.openFirstPicture();
    window.show();
    Welcome::offer(&window);
    auto* welcome = window.findChild<Welcome*>();
    QVERIFY(welcome);
    QStringList found;
    for (QObject* object : welcome->findChildren<QObject*>())
        found += takenForMarkup(object);
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
    auto* button = welcome->findChild<QCommandLinkButton*>();
    QVERIFY(button);
    const QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(button);
    QVERIFY(heard->text(QAccessible::Description).endsWith(markupPath));
}

void LiteralNamesTest::messagesShowNamesAsWritten() {
    MainWindow window;
    window.show();
    QVERIFY(!window.openPath(m_folder.filePath(QStringLiteral("<img src=gone>.ifs"))));
    auto* box = window.findChild<QMessageBox*>();
    QVERIFY(box);
    QVERIFY(box->text().contains(QStringLiteral("<img src=gone>")));
    const auto labels = box->findChildren<QLabel*>();
    QVERIFY(labels.size() >= 2);
    for (const QLabel* label : labels)
        QCOMPARE(label->textFormat(), Qt::PlainText);
    box->close();
}

void LiteralNamesTest::titlesShowNamesAsWritten() {
    const EveryWindow windows(m_path);
    int titles = 0;
    for (QWidget* window : windows.all())
        if (window->windowTitle().contains(QStringLiteral("bold")) && window->windowHandle()) {
            const QString title = window->windowHandle()->title();
            QVERIFY2(title.contains(markup), qPrintable(title));
            ++titles;
        }
    QVERIFY(titles >= 3); // the main window and the exports
}

BARYCAGE_TEST(LiteralNamesTest, Application);

#include "literal_names_test.moc"
