// SPDX-License-Identifier: MIT
#include "panels/lesson/lesson_card.h"
#include "panels/lesson/lesson_notebook.h"
#include "panels/lesson/lesson_panel.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>

using namespace Qt::StringLiterals;

class LessonPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void stepsAreWritten();
    void theFirstStepMovesNothing();
    void playingBeginsWhereTheUserChose();
    void aStepIsAddedAtTheEndOfAnOpenedLesson();
    void changesAreUndone();
    void typingIsOneStep();
    void aLongTextIsCutInSight();
    void panelsAreChosen();
    void theCardIsReadFromAfar();
    void theCardLeadsOnAndBack();

private:
    QAction* action(const QByteArray& name) const { return support::action(*m_panel, "lesson-" + name); }
    QLineEdit* field(const QString& name) const {
        for (auto* found : m_panel->findChildren<QLineEdit*>())
            if (found->accessibleName() == name) return found;
        return nullptr;
    }
    QListWidget* steps() const { return m_panel->findChild<QListWidget*>(); }
    QPlainTextEdit* text() const { return m_panel->findChild<QPlainTextEdit*>(); }

    std::unique_ptr<view::LessonNotebook> m_notebook;
    std::unique_ptr<view::LessonPanel> m_panel;
};

namespace {

document::LessonState stateOf(const QString& entry) {
    document::LessonState state;
    state.entry = entry;
    return state;
}

document::Lesson lessonOf(const QString& text) {
    return {u"The chaos game"_s, u"a.ifs"_s, {{u"One"_s, u"A."_s, {}, {}}, {u"Two"_s, text, {}, {}}}, {}};
}

} // namespace

void LessonPanelTest::init() {
    m_notebook = std::make_unique<view::LessonNotebook>();
    m_panel = std::make_unique<view::LessonPanel>(m_notebook.get());
    m_panel->resize(360, 600);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    QSignalSpy added(m_panel.get(), &view::LessonPanel::addRequested);
    action("add")->trigger();
    QCOMPARE(added.count(), 1);
}

void LessonPanelTest::cleanup() {
    m_panel.reset();
    m_notebook.reset();
}

void LessonPanelTest::stepsAreWritten() {
    QVERIFY(!text()->isEnabled() && !action("remove")->isEnabled());
    m_notebook->addStep(stateOf(u"a"_s));
    QTest::keyClicks(field(u"Title of the step"_s), u"First"_s);
    QTest::keyClicks(text(), u"Hello there."_s);
    m_notebook->addStep(stateOf(u"b"_s));
    QCOMPARE(steps()->count(), 2);
    QCOMPARE(steps()->item(0)->text(), u"1. First"_s);
    QVERIFY(text()->toPlainText().isEmpty()); // of the new step
    QTest::keyClicks(text(), u"Second."_s);
    QTest::keyClicks(field(u"Title of the lesson"_s), u"Both"_s);
    action("up")->trigger();
    QCOMPARE(m_notebook->lesson().steps[0].text, u"Second."_s);
    QCOMPARE(m_notebook->lesson().steps[0].state.entry, u"b"_s);
    QCOMPARE(m_notebook->lesson().steps[1].title, u"First"_s);
    QVERIFY(!action("up")->isEnabled() && action("down")->isEnabled());
    steps()->setCurrentRow(1);
    QCOMPARE(text()->toPlainText(), u"Hello there."_s);
    action("remove")->trigger();
    QCOMPARE(m_notebook->lesson().steps.size(), 1);
    QCOMPARE(m_notebook->lesson().title, u"Both"_s);
    QCOMPARE(m_notebook->current(), 0);
}

void LessonPanelTest::theFirstStepMovesNothing() {
    const QRect list = steps()->geometry();
    const int textTop = text()->mapTo(m_panel.get(), QPoint()).y();
    const auto* hint = m_panel->findChild<QLabel*>(); // in the empty list: it takes no room of its own
    QVERIFY(hint && hint->isVisible());
    QVERIFY(steps()->rect().contains(QRect(hint->mapTo(steps(), QPoint()), hint->size())));
    m_notebook->addStep(stateOf(u"a"_s));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCOMPARE(steps()->geometry(), list);
    QCOMPARE(text()->mapTo(m_panel.get(), QPoint()).y(), textTop);
}

// A step that was only added is not one that was chosen.
void LessonPanelTest::playingBeginsWhereTheUserChose() {
    for (const char* entry : {"a", "b", "c"}) {
        m_notebook->addStep(stateOf(QLatin1String(entry)));
        QTest::keyClicks(text(), u"Text."_s);
        QCOMPARE(m_notebook->firstToPlay(), 0);
    }
    QCOMPARE(m_notebook->current(), 2);
    const auto click = [this](int row) {
        QTest::mouseClick(steps()->viewport(), Qt::LeftButton, {},
                          steps()->visualItemRect(steps()->item(row)).center());
    };
    click(2); // where it is already
    QCOMPARE(m_notebook->firstToPlay(), 2);
    click(1);
    QCOMPARE(m_notebook->firstToPlay(), 1);
    m_notebook->addStep(stateOf(u"d"_s));
    QCOMPARE(m_notebook->firstToPlay(), 0);
    click(1);
    m_notebook->open(lessonOf(u"B."_s), u"/x/a.lesson"_s);
    QCOMPARE(m_notebook->firstToPlay(), 0);
}

void LessonPanelTest::aStepIsAddedAtTheEndOfAnOpenedLesson() {
    const auto open = [this] { m_notebook->open(lessonOf(u"B."_s), u"/x/a.lesson"_s); };
    open();
    const int before = int(m_notebook->lesson().steps.size());
    QVERIFY(before > 1);
    m_notebook->addStep(stateOf(u"a"_s));
    QCOMPARE(m_notebook->current(), before);
    QCOMPARE(m_notebook->lesson().steps.last().state.entry, u"a"_s);
    open();
    steps()->setCurrentRow(1);
    steps()->setCurrentRow(0); // behind the one that the user chose
    m_notebook->addStep(stateOf(u"b"_s));
    QCOMPARE(m_notebook->current(), 1);
    m_notebook->addStep(stateOf(u"c"_s));
    QCOMPARE(m_notebook->current(), 2);
}

void LessonPanelTest::changesAreUndone() {
    m_notebook->open(lessonOf(u"B."_s), u"/x/a.lesson"_s);
    QVERIFY(!m_notebook->isModified() && !action("undo")->isEnabled());
    const document::Lesson before = m_notebook->lesson();
    steps()->setCurrentRow(1);
    action("remove")->trigger();
    m_notebook->setState(stateOf(u"c"_s));
    QVERIFY(m_notebook->isModified());
    action("undo")->trigger();
    action("undo")->trigger();
    QVERIFY(m_notebook->lesson() == before);
    QVERIFY(!m_notebook->isModified() && m_notebook->current() == 1);
    QCOMPARE(text()->toPlainText(), u"B."_s);
    QVERIFY(!action("undo")->isEnabled() && action("redo")->isEnabled());
    action("redo")->trigger();
    QCOMPARE(m_notebook->lesson().steps.size(), 1);
    // The name of the file is no part of the history.
    m_notebook->setFile(u"b.ifs"_s);
    action("undo")->trigger();
    QCOMPARE(m_notebook->lesson().file, u"b.ifs"_s);
}

void LessonPanelTest::typingIsOneStep() {
    m_notebook->addStep({});
    const int before = m_notebook->history()->count();
    QTest::keyClicks(text(), u"some words "_s); // a blank at the end is not taken away while one types
    QCOMPARE(text()->toPlainText(), u"some words "_s);
    QTest::keyClicks(text(), u"more"_s);
    QCOMPARE(m_notebook->lesson().steps[0].text, u"some words more"_s);
    QCOMPARE(m_notebook->history()->count(), before + 1);
    action("undo")->trigger();
    QVERIFY(text()->toPlainText().isEmpty());
}

void LessonPanelTest::aLongTextIsCutInSight() {
    m_notebook->addStep({});
    text()->setPlainText(QString(document::maxLessonText + 100, u'x'));
    QCOMPARE(text()->toPlainText().size(), document::maxLessonText);
    QCOMPARE(m_notebook->lesson().steps[0].text, text()->toPlainText());
}

void LessonPanelTest::panelsAreChosen() {
    m_panel->setPanels({{u"maps"_s, u"Maps"_s}, {u"analysis"_s, u"R&D"_s}});
    const QList<QAction*> panels = m_panel->findChild<QMenu*>()->actions();
    QCOMPARE(panels.size(), 2);
    QVERIFY(!panels[0]->isEnabled()); // of no step
    m_notebook->addStep({});
    QVERIFY(panels[0]->isEnabled());
    QCOMPARE(panels[1]->text(), u"R&&D"_s);
    panels[1]->trigger();
    QCOMPARE(m_notebook->lesson().steps[0].state.panels, QStringList{u"analysis"_s});
    m_notebook->addStep({});
    QVERIFY(!panels[1]->isChecked());
    steps()->setCurrentRow(0);
    QVERIFY(panels[1]->isChecked());
    panels[1]->trigger();
    QVERIFY(m_notebook->lesson().steps[0].state.panels.isEmpty());
}

void LessonPanelTest::theCardIsReadFromAfar() {
    view::LessonCard card;
    card.resize(576, 1080);
    card.showStep(lessonOf(u"A text of <b>one</b> line."_s), 1);
    card.show();
    QVERIFY(QTest::qWaitForWindowExposed(&card));
    const QLabel* text = nullptr;
    for (const auto* label : card.findChildren<QLabel*>())
        if (label->text().startsWith(u"A text"_s)) text = label;
    QVERIFY(text);
    QCOMPARE(text->textFormat(), Qt::PlainText);
    QVERIFY(text->fontMetrics().lineSpacing() > 1.4 * card.fontMetrics().lineSpacing());
    QVERIFY(text->fontMetrics().horizontalAdvance(u'x') * 20 < text->width());
    // A long text is smaller, and scrolls where that is not enough.
    const int large = text->fontMetrics().lineSpacing();
    card.showStep(lessonOf(QString(document::maxLessonText / 8, u'x').replace(u'x', u"letters "_s)), 1);
    QVERIFY(text->fontMetrics().lineSpacing() < large);
    QVERIFY(text->fontMetrics().lineSpacing() >= card.fontMetrics().lineSpacing());
    card.resize(300, 300);
    QTRY_VERIFY(card.findChild<QScrollArea*>()->verticalScrollBar()->maximum() > 0);
    card.resize(4000, 3000);
    QCoreApplication::processEvents();
    QVERIFY(text->fontMetrics().lineSpacing() < 5 * card.fontMetrics().lineSpacing());
}

void LessonPanelTest::theCardLeadsOnAndBack() {
    view::LessonCard card;
    QSignalSpy next(&card, &view::LessonCard::nextRequested);
    QSignalSpy back(&card, &view::LessonCard::backRequested);
    QSignalSpy end(&card, &view::LessonCard::endRequested);
    card.resize(400, 600);
    card.showStep(lessonOf(u"B."_s), 0);
    card.show();
    QVERIFY(QTest::qWaitForWindowActive(&card));
    card.takeFocus();
    QWidget* button = card.focusWidget();
    QTest::keyClick(button, Qt::Key_Left); // there is none before the first
    QCOMPARE(back.count(), 0);
    QTest::keyClick(button, Qt::Key_Right);
    QTest::keyClick(button, Qt::Key_Space);
    QCOMPARE(next.count(), 2);
    card.showStep(lessonOf(u"B."_s), 1);
    QTest::keyClick(button, Qt::Key_Left);
    QCOMPARE(back.count(), 1);
    QTest::keyClick(button, Qt::Key_Right); // a press too many does not end the lesson
    QCOMPARE(next.count(), 2);
    QCOMPARE(end.count(), 0);
    QTest::keyClick(button, Qt::Key_Space);
    QCOMPARE(end.count(), 1);
    QCOMPARE(card.accessibleDescription(), u"Two. B."_s);
}

BARYCAGE_TEST(LessonPanelTest, QApplication);
#include "lesson_panel_test.moc"
