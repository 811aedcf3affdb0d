// SPDX-License-Identifier: MIT
#include "widgets/document_undo.h"

#include "panels/maps/symmetry_row.h"
#include "panels/timeline/timeline_panel.h"
#include "panels/timeline/transport_bar.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"
#include "view/panels/maps_support.h"

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>
#include <QUndoStack>
#include <QVBoxLayout>

#include <memory>

// Ctrl+Z in a spin box that edits the document.
class DocumentUndoTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init();
    void cleanup() {
        m_window.reset();
        m_document.reset();
    }

    void theOrderOfASymmetry();
    void theTimingOfAnAnimation();

private:
    QUndoStack& history() { return *m_document->undoStack(); }
    void show(QWidget* panel);
    void type(QSpinBox* box, const QString& text);
    void takeBack(QSpinBox* box, const QString& text);

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<QWidget> m_window; // with the keys of the main window
};

void DocumentUndoTest::init() {
    m_document = std::make_unique<document::Document>();
    m_window = std::make_unique<QWidget>();
    new QVBoxLayout(m_window.get());
    auto* undo = new QAction(m_window.get());
    undo->setShortcut(QKeySequence::Undo);
    connect(undo, &QAction::triggered, &history(), &QUndoStack::undo);
    auto* redo = new QAction(m_window.get());
    redo->setShortcut(QKeySequence::Redo);
    connect(redo, &QAction::triggered, &history(), &QUndoStack::redo);
    m_window->addActions({undo, redo});
}

void DocumentUndoTest::show(QWidget* panel) {
    m_window->layout()->addWidget(panel);
    m_window->resize(1600, 400);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void DocumentUndoTest::type(QSpinBox* box, const QString& text) {
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
}

// First what is only typed, then what Enter has made a step of.
void DocumentUndoTest::takeBack(QSpinBox* box, const QString& text) {
    QTRY_VERIFY(box->isVisible() && box->isEnabled());
    const int before = box->value();
    const int index = history().index();
    type(box, text);
    QCOMPARE(box->text(), text);
    QTest::keySequence(box, QKeySequence(QKeySequence::Undo));
    QCOMPARE(history().index(), index);
    QVERIFY(box->text() != text);

    type(box, text);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(box->value(), text.toInt());
    QCOMPARE(history().index(), index + 1);
    QTest::keySequence(box, QKeySequence(QKeySequence::Undo));
    QCOMPARE(history().index(), index);
    QCOMPARE(box->value(), before);
    QTest::keySequence(box, QKeySequence(QKeySequence::Redo));
    QCOMPARE(history().index(), index + 1);
    QCOMPARE(box->value(), text.toInt());
    QCOMPARE(history().count(), index + 1);
}

void DocumentUndoTest::theOrderOfASymmetry() {
    document::Fractal fractal = maps_support::maple();
    document::system2(fractal)->symmetry = {.group = ifs::SymmetryGroup::Rotation, .order = 6};
    m_document->edit(QStringLiteral("maple"), fractal);
    auto* row = new view::SymmetryRow(m_document.get());
    show(row);
    takeBack(row->order(), QStringLiteral("24"));
    QCOMPARE(maps_support::systemOf(*m_document).symmetry.order, 24);
}

void DocumentUndoTest::theTimingOfAnAnimation() {
    auto* panel = new view::TimelinePanel(m_document.get());
    panel->showTracks();
    show(panel);
    takeBack(panel->transport()->length(), QStringLiteral("30"));
    QCOMPARE(panel->timeline().timing().length, 30);

    QLineEdit* rate = panel->transport()->rate()->lineEdit();
    const animation::FrameRate before = panel->timeline().timing().rate;
    const int index = history().index();
    rate->setFocus();
    rate->selectAll();
    QTest::keyClicks(rate, QStringLiteral("12"));
    QTest::keyClick(rate, Qt::Key_Return);
    QCOMPARE(panel->timeline().timing().rate, (animation::FrameRate{12, 1}));
    QTest::keySequence(rate, QKeySequence(QKeySequence::Undo));
    QCOMPARE(history().index(), index);
    QCOMPARE(panel->timeline().timing().rate, before);
}

BARYCAGE_TEST(DocumentUndoTest, QApplication);
#include "document_undo_test.moc"
