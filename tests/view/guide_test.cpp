// SPDX-License-Identifier: MIT
#include "dialogs/guide.h"
#include "support/paths.h"

#include <QApplication>
#include <QFile>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

class GuideTest : public QObject {
    Q_OBJECT

private slots:
    void showsTextAndPictures();
    void nothingIsBesideANarrowWindow();
};

void GuideTest::showsTextAndPictures() {
    QWidget window;
    view::showGuide(&window);
    auto* browser = window.findChild<QTextBrowser*>();
    QVERIFY(browser);
    QVERIFY(browser->toPlainText().startsWith(QStringLiteral("User guide")));
    qsizetype pictures = 0;
    for (QTextBlock block = browser->document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextImageFormat format = part.fragment().charFormat().toImageFormat();
            if (!format.isValid()) continue;
            ++pictures;
            const QVariant image =
                browser->document()->resource(QTextDocument::ImageResource, QUrl(format.name()));
            QVERIFY2(!image.isNull(), qPrintable(format.name()));
        }
    QFile source(support::sourcePath(QStringLiteral("docs/guide.md")));
    QVERIFY(source.open(QIODevice::ReadOnly));
    QCOMPARE(pictures, source.readAll().count("!["));
    QVERIFY(pictures > 3);
}

void GuideTest::nothingIsBesideANarrowWindow() {
    QWidget window;
    view::showGuide(&window);
    auto* browser = window.findChild<QTextBrowser*>();
    for (const int width : {browser->window()->width(), 360, 900}) {
        browser->window()->resize(width, 600);
        QTRY_COMPARE(browser->window()->width(), width);
        QTRY_COMPARE(browser->horizontalScrollBar()->maximum(), 0);
    }
}

QTEST_MAIN(GuideTest)
#include "guide_test.moc"
