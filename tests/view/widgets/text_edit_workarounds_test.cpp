// SPDX-License-Identifier: MIT
#include "support/named_test.h"
#include "widgets/text_edit_workarounds.h"

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
        QVERIFY(!scrollsOn(plain));
        view::TextEditWithWorkarounds<QTextBrowser> rich;
        QVERIFY(!scrollsOn(rich));
        QPlainTextEdit other; // without this there would be nothing to mend
        QVERIFY(scrollsOn(other));
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
    // After text was dragged out below, of which drag the release is not told.
    template <class Text> static bool scrollsOn(Text& text) {
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
        QTest::qWait(300);
        return text.verticalScrollBar()->value() > text.verticalScrollBar()->maximum() / 2;
    }
};

BARYCAGE_TEST(TextEditWorkaroundsTest, QApplication);
#include "text_edit_workarounds_test.moc"
