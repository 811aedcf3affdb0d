// SPDX-License-Identifier: MIT
#include "dialogs/guide.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>

class GuideTest : public QObject {
    Q_OBJECT

private slots:
    void showsTextAndPictures();
    void picturesAreDecodedInTheBackground();
    void nothingIsBesideANarrowWindow();
    void sectionsAreOpened();
    void wordsAreFound();
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

// The window waits for no picture, and no text moves when one arrives.
void GuideTest::picturesAreDecodedInTheBackground() {
    QWidget window;
    view::showGuide(&window);
    auto* browser = window.findChild<QTextBrowser*>();
    const QUrl name(QStringLiteral("qrc:/guide/images/guide-maple.png"));
    const auto picture = [&] {
        return browser->document()->resource(QTextDocument::ImageResource, name).value<QImage>();
    };
    const QImage source(QStringLiteral(":/guide/images/guide-maple.png"));
    const auto isBlank = [](QImage image) {
        const QImage whole = image.convertToFormat(QImage::Format_ARGB32);
        QImage blank(whole.size(), whole.format());
        blank.fill(Qt::transparent);
        blank.setDevicePixelRatio(whole.devicePixelRatio());
        return whole == blank;
    };
    for (const int width : {900, 360, 500}) {
        browser->window()->resize(width, 600);
        const QSize place = picture().size();
        const QSizeF page = browser->document()->size();
        QCOMPARE(isBlank(picture()), width == 900); // later the last picture is stretched
        const QImage wanted = source.scaled(place, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QTRY_COMPARE(picture().convertToFormat(wanted.format()), wanted);
        QCOMPARE(browser->document()->size(), page);
        QCOMPARE(place.width(), std::min(source.width(), browser->viewport()->width() - 32));
    }
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

void GuideTest::sectionsAreOpened() {
    QWidget window;
    view::showGuide(&window, QStringLiteral("How pieces meet"));
    auto* browser = window.findChild<QTextBrowser*>();
    QVERIFY(QTest::qWaitForWindowActive(browser->window()));
    QCOMPARE(browser->textCursor().block().text(), QStringLiteral("How pieces meet"));
    QTRY_VERIFY(browser->viewport()->rect().contains(browser->cursorRect()));
    QVERIFY(browser->cursorRect().top() < browser->viewport()->height() / 2);
}

void GuideTest::wordsAreFound() {
    QWidget window;
    view::showGuide(&window);
    auto* browser = window.findChild<QTextBrowser*>();
    auto* field = browser->window()->findChild<QLineEdit*>();
    auto* count = browser->window()->findChild<QLabel*>();
    QVERIFY(QTest::qWaitForWindowActive(browser->window()));
    QTest::keyClick(browser, Qt::Key_F, Qt::ControlModifier);
    QVERIFY(field->hasFocus());
    const auto isShown = [&](qsizetype place) {
        const QTextCursor found = browser->extraSelections().at(place).cursor;
        return browser->textCursor().position() == found.selectionStart() &&
               browser->viewport()->rect().contains(browser->cursorRect());
    };
    QTest::keyClicks(field, QStringLiteral("Corner"));
    const qsizetype places = browser->toPlainText().count(QLatin1String("corner"), Qt::CaseInsensitive);
    QVERIFY(places > 3);
    QCOMPARE(browser->extraSelections().size(), places);
    const auto numbered = [&](qsizetype place) { return QStringLiteral("%1 of %2").arg(place).arg(places); };
    QCOMPARE(count->text(), numbered(1));
    QVERIFY(isShown(0));
    QTest::keyClick(field, Qt::Key_Return, Qt::ShiftModifier); // round the corner
    QCOMPARE(count->text(), numbered(places));
    QVERIFY(isShown(places - 1));
    QTest::keyClick(field, Qt::Key_Return);
    QTest::keyClick(field, Qt::Key_F3);
    QCOMPARE(count->text(), numbered(2));
    QVERIFY(isShown(1));
    QTest::keyClicks(field, QStringLiteral("zz"));
    QCOMPARE(count->text(), QStringLiteral("Not found"));
    QVERIFY(browser->extraSelections().isEmpty());
    QTest::keyClick(field, Qt::Key_Escape); // what was typed first, then the window
    QCOMPARE(field->text(), QString());
    QCOMPARE(count->text(), QString());
    QVERIFY(browser->isVisible());
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(!window.findChild<QTextBrowser*>());
}

BARYCAGE_TEST(GuideTest, QApplication);
#include "guide_test.moc"
