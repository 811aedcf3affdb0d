// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "widgets/text/text_edit_workarounds.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTest>
#include <QTextBrowser>

class TextEditWorkaroundsTest : public QObject {
    Q_OBJECT

private slots:
    void nothingScrollsWithoutTheButton() {
        view::TextEditWithWorkarounds<QPlainTextEdit> plain;
        view::TextEditWithWorkarounds<QTextBrowser> rich;
        QPlainTextEdit other; // which shows that there is something to mend
        dragOutOf(plain);
        dragOutOf(rich);
        dragOutOf(other);
        QTRY_VERIFY(isScrolled(other));
        QVERIFY(!isScrolled(plain) && !isScrolled(rich));
    }

    void anEmptyClipboardIsPasted() {
        view::TextEditWithWorkarounds<QPlainTextEdit> plain;
        QGuiApplication::clipboard()->setMimeData(new QMimeData);
        QTest::keyClick(&plain, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(plain.toPlainText(), QString());
        QGuiApplication::clipboard()->setText(QStringLiteral("a word"));
        QTest::keyClick(&plain, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(plain.toPlainText(), QStringLiteral("a word"));
    }

private:
    // Below, and without telling it of the release.
    template <class Text> static void dragOutOf(Text& text) {
        text.setPlainText(QStringLiteral("a line\n").repeated(200));
        text.setReadOnly(true);
        text.resize(200, 100);
        text.show();
        const QPoint inside(10, 10), below(10, 300);
        QTest::mousePress(text.viewport(), Qt::LeftButton, {}, inside);
        QCursor::setPos(text.viewport()->mapToGlobal(below));
        QMouseEvent out(QEvent::MouseMove, below, text.viewport()->mapToGlobal(below), Qt::NoButton,
                        Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(text.viewport(), &out);
        QWidget elsewhere;
        QTest::mouseRelease(&elsewhere, Qt::LeftButton);
    }
    template <class Text> static bool isScrolled(const Text& text) {
        return text.verticalScrollBar()->value() > text.verticalScrollBar()->maximum() / 2;
    }
};

BARYCAGE_TEST(TextEditWorkaroundsTest, QApplication);
#include "text_edit_workarounds_test.moc"
