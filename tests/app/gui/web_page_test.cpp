// SPDX-License-Identifier: MIT
#include "app/gui/choose_file.h"
#include "app/gui/window_fixture.h"
#include "io/exchange/entry_link.h"
#include "panels/entries/entries_panel.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAction>
#include <QClipboard>
#include <QDesktopServices>
#include <QFile>
#include <QFrame>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUrl>

using namespace Qt::StringLiterals;

// A web page is written without a dialog of its own: a banner says so, and leads to its folder.
class WebPageTest : public WindowFixture {
    Q_OBJECT

public slots:
    void open(const QUrl& url) { m_opened = url; } // in place of the file manager

private slots:
    void theBannerLeadsToTheFolder();
    void longNamesAreShortened();
    void theNextEditClosesTheBanner();
    void aLinkIsCopiedAndPasted();
    void linesOfPythonAreCopiedAndTheirEntryIsPasted();
    void aLinkThatWasCutOffSaysSo();

private:
    void write(const QString& name);
    QList<QFrame*> banners() const;
    QString path(const QString& name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
    QUrl m_opened;
};

QList<QFrame*> WebPageTest::banners() const {
    return m_window->findChildren<QFrame*>(u"written"_s, Qt::FindDirectChildrenOnly);
}

void WebPageTest::write(const QString& name) {
    QTimer answering;
    support::chooseFile(answering, path(name));
    m_window->findChild<QAction*>(u"export-web-page"_s)->trigger(); // waits for both
    QVERIFY(QFile(path(name)).size() > 0);
}

void WebPageTest::theBannerLeadsToTheFolder() {
    write(u"a.html"_s);
    write(u"b.html"_s);
    QCOMPARE(banners().size(), 1); // the last one
    const QFrame* banner = banners().first();
    QTRY_VERIFY(banner->isVisible());
    QCOMPARE(banner->accessibleDescription(),
             u"b.html was written. Open it in a browser, or mail it: it needs no network."_s);
    QDesktopServices::setUrlHandler(u"file"_s, this, "open");
    support::button(*banner, "show-in-folder")->click();
    QDesktopServices::unsetUrlHandler(u"file"_s);
    QCOMPARE(m_opened, QUrl::fromLocalFile(m_folder.path()));
}

void WebPageTest::longNamesAreShortened() {
    write(QString(200, u'x') + u".html"_s);
    const QFrame* banner = banners().first();
    QTRY_VERIFY(banner->isVisible());
    for (const auto* label : banner->findChildren<QLabel*>())
        QTRY_VERIFY2(label->minimumSizeHint().width() <= banner->width(), qPrintable(label->text()));
}

void WebPageTest::theNextEditClosesTheBanner() {
    write(u"c.html"_s);
    document::Document& document = m_window->document();
    document::Fractal fractal = document.fractal();
    fractal.name = u"another"_s;
    document.edit(u"Rename"_s, fractal);
    QTRY_VERIFY(banners().isEmpty());
}

void WebPageTest::aLinkIsCopiedAndPasted() {
    document::Document& document = m_window->document();
    document::Fractal fractal = document.fractal();
    fractal.name = u"linked"_s;
    fractal.appearance.gamma = 3;
    document.edit(u"Change"_s, fractal);
    QGuiApplication::clipboard()->clear();
    m_window->findChild<QAction*>(u"copy-link"_s)->trigger();
    QTRY_VERIFY(QGuiApplication::clipboard()->text().startsWith(u"barycage:"));
    const auto count = document.file().entries.size();
    m_window->findChild<view::EntriesPanel*>()->paste();
    QTRY_COMPARE(document.file().entries.size(), count + 1);
    QVERIFY(document.fractal().name.startsWith(u"linked"));
    QCOMPARE(document.fractal().appearance.gamma, 3.0);
    QVERIFY(*document::system2(document.fractal()) == *document::system2(fractal));
}

// The text of the entry stands in the lines as it is.
void WebPageTest::linesOfPythonAreCopiedAndTheirEntryIsPasted() {
    document::Document& document = m_window->document();
    document::Fractal fractal = document.fractal();
    fractal.name = u"for a notebook"_s;
    fractal.appearance.gamma = 3;
    document.edit(u"Change"_s, fractal);
    QGuiApplication::clipboard()->clear();
    m_window->findChild<QAction*>(u"copy-as-python"_s)->trigger();
    QTRY_VERIFY(QGuiApplication::clipboard()->text().section(u'\n', 1).startsWith(u"import barycage"));
    const QStringList parts = QGuiApplication::clipboard()->text().split(u"\"\"\""_s);
    QCOMPARE(parts.size(), 3);
    QGuiApplication::clipboard()->setText(parts[1]);
    const auto count = document.file().entries.size();
    m_window->findChild<view::EntriesPanel*>()->paste();
    QTRY_COMPARE(document.file().entries.size(), count + 1);
    QCOMPARE(document.fractal().name, u"for_a_notebook"_s); // as .ifs files hold it
    QCOMPARE(document.fractal().appearance.gamma, 3.0);
    QVERIFY(*document::system2(document.fractal()) == *document::system2(fractal));
}

void WebPageTest::aLinkThatWasCutOffSaysSo() {
    const QString link = QString::fromLatin1(io::linkOf(m_window->document().fractal()).link);
    QGuiApplication::clipboard()->setText(link.chopped(5));
    const auto count = m_window->document().file().entries.size();
    auto* panel = m_window->findChild<view::EntriesPanel*>();
    QSignalSpy said(panel, &view::EntriesPanel::message);
    panel->paste();
    QTRY_COMPARE(said.size(), 1);
    QVERIFY2(said.first().first().toString().contains(u"cut off"),
             qPrintable(said.first().first().toString()));
    QCOMPARE(m_window->document().file().entries.size(), count);
}

BARYCAGE_TEST(WebPageTest, QApplication);
#include "web_page_test.moc"
