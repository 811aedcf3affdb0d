// SPDX-License-Identifier: MIT
#include "app/gui/choose_file.h"
#include "app/gui/window_fixture.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAction>
#include <QDesktopServices>
#include <QFile>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
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

BARYCAGE_TEST(WebPageTest, QApplication);
#include "web_page_test.moc"
