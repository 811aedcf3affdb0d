// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QAbstractButton>
#include <QAction>
#include <QMessageBox>
#include <QSet>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>

using namespace Qt::StringLiterals;

// Who closes a window is told what would be lost.
class SaveQuestionTest : public WindowFixture {
    Q_OBJECT

private slots:
    void snapshotsAreNamed();
    void snapshotsOfAFileWithoutChangesAreAskedFor();
    void revertingSaysWhatIsLost();

private:
    struct Question {
        QString text;
        QStringList buttons;
    };
    // What is asked when the window is closed; it stays open, unless another button is to be pressed.
    Question asked(QMessageBox::StandardButton press = QMessageBox::Cancel) {
        return askedBy([this] { m_window->close(); }, press);
    }
    template <typename Command>
    Question askedBy(Command command, QMessageBox::StandardButton press = QMessageBox::Cancel) {
        Question question;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            for (QWidget* widget : QApplication::topLevelWidgets())
                if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible()) {
                    question.text = box->text() + u'\n' + box->informativeText();
                    for (const QAbstractButton* button : box->buttons())
                        question.buttons << button->text();
                    box->button(press)->click();
                }
        });
        look.start(20);
        command();
        return question;
    }
    void rename(const QString& name) {
        document::Fractal changed = m_window->document().fractal();
        changed.name = name;
        m_window->document().edit(u"rename"_s, changed);
    }
    void takeSnapshot() { support::command(*m_window, "snapshot")->trigger(); }
};

void SaveQuestionTest::snapshotsAreNamed() {
    rename(u"one"_s);
    Question question = asked();
    QVERIFY(m_window->isVisible());
    QVERIFY2(!question.text.contains(u"napshot"_s), qPrintable(question.text));
    QCOMPARE(question.buttons.size(), 3);
    QSet<QChar> letters;
    for (const QString& button : std::as_const(question.buttons)) {
        QVERIFY2(button.contains(u'&'), qPrintable(button));
        letters << button[button.indexOf(u'&') + 1].toLower();
    }
    QCOMPARE(letters.size(), 3);

    takeSnapshot();
    document::Fractal changed = m_window->document().fractal();
    document::plane(changed)->system.maps[0].map.translation.x() += 0.1;
    m_window->document().edit(u"move"_s, changed);
    question = asked();
    QVERIFY2(question.text.contains(u"Snapshot 1 of “one”"_s), qPrintable(question.text));
    m_window->document().undoStack()->undo(); // it is as the entry again
    question = asked();
    QVERIFY2(!question.text.contains(u"napshot"_s), qPrintable(question.text));
    m_window->document().undoStack()->setClean();
}

void SaveQuestionTest::snapshotsOfAFileWithoutChangesAreAskedFor() {
    QUndoStack* history = m_window->document().undoStack();
    takeSnapshot();
    rename(u"two"_s);
    document::Fractal changed = m_window->document().fractal();
    document::plane(changed)->system.maps[0].map.translation.x() += 0.1;
    m_window->document().edit(u"move"_s, changed);
    takeSnapshot();
    Question question = asked();
    QVERIFY2(question.text.contains(u"Snapshot 1 of “two”"_s), qPrintable(question.text));
    QVERIFY2(question.text.contains(u"Snapshot 2 of “two”"_s), qPrintable(question.text)); // by Discard
    history->setIndex(0);
    QVERIFY(!m_window->document().isModified());
    question = asked();
    QVERIFY(m_window->isVisible());
    QVERIFY2(question.text.contains(u"Snapshot 2"_s), qPrintable(question.text));
    QVERIFY2(!question.text.contains(u"Snapshot 1"_s), qPrintable(question.text)); // it is in the file
    QCOMPARE(question.buttons.size(), 2);
    asked(QMessageBox::Discard);
    QVERIFY(!m_window->isVisible());
}

void SaveQuestionTest::revertingSaysWhatIsLost() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"one.ifs"_s);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("one {\n.5 0 0 .5 0 0 .5\n.5 0 0 .5 1 0 .5\n}\n");
    file.close();
    QVERIFY(m_window->openPath(path));
    const auto question = [this] {
        return askedBy([this] { support::command(*m_window, "revert")->trigger(); }).text;
    };
    document::Fractal changed = m_window->document().fractal();
    document::plane(changed)->system.maps[0].map.translation.x() += 0.1;
    m_window->document().edit(u"move"_s, changed);
    takeSnapshot();
    QString text = question();
    QVERIFY2(text.contains(u"Your changes"_s), qPrintable(text));
    m_window->document().undoStack()->undo();
    QVERIFY(!m_window->document().isModified());
    text = question();
    QVERIFY2(text.contains(u"Snapshot 1 of “one”"_s), qPrintable(text));
    QVERIFY2(!text.contains(u"changes"_s), qPrintable(text));
}

BARYCAGE_TEST(SaveQuestionTest, QApplication);
#include "save_question_test.moc"
