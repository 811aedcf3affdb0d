// SPDX-License-Identifier: MIT
#include "desktop/clipboard.h"
#include "dialogs/paste_table_dialog.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/entries/entries_list.h"
#include "panels/entries/entries_model.h"
#include "panels/entries/entries_panel.h"
#include "support/events.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QAction>
#include <QClipboard>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QToolTip>

using namespace Qt::StringLiterals;
using document::Document;
using document::Entry;
using document::EntryId;
using document::FractalFile;
using view::EntriesList;
using view::EntriesPanel;

namespace {

FractalFile fileOfNames(const QStringList& names) {
    FractalFile file;
    for (const QString& name : names) {
        document::Fractal fractal = document::sierpinskiTriangle();
        fractal.name = name;
        file.entries.append(
            {document::freshId(file), std::make_shared<const document::Fractal>(fractal), nullptr, {}});
    }
    return file;
}

} // namespace

class EntriesPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();

    void add();
    void theNameOfANewEntryIsTyped();
    void removeSeveral();
    void removeAll();
    void manyAtOnce();
    void duplicate();
    void renameByKeyboard();
    void renamingTwiceIsRenaming();
    void tabGivesTheNextName();
    void badNameKeepsTheEditorOpen();
    void moveByKeyboard();
    void moveSeveralWithGap();
    void dropMoves();
    void dropFromElsewhere();
    void copyAndPasteBetweenDocuments();
    void pasteNonsense();
    void pasteNothing();
    void aBareTableIsAskedAbout();
    void comment();
    void whatIsTypedIsInTheDocument();
    void filterHidesAndKeepsCurrent();
    void anotherFileClearsTheFilter();
    void theNameEditorCoversTheNameAndShowsRefusals();
    void currentFollowsBothWays();
    void selectionSurvivesUndo();
    void emptyFile();
    void everythingIsNamed();

private:
    QStringList names() const;
    QString currentName() const { return m_document->fractal().name; }
    QModelIndex row(const QString& name) const;
    void select(const QStringList& names);
    void key(Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void drop(const QMimeData& mimeData, const QPoint& position); // as if from another window
    void checkOneStep();                                          // exactly one, undone and redone exactly

    std::unique_ptr<Document> m_document;
    std::unique_ptr<EntriesPanel> m_panel;
    EntriesList* m_list = nullptr;
    FractalFile m_before;
};

void EntriesPanelTest::init() {
    m_document = std::make_unique<Document>();
    m_document->setFile(fileOfNames({u"maple"_s, u"flower"_s, u"fern"_s, u"tree"_s, u"dragon"_s}));
    m_before = m_document->file();
    m_panel = std::make_unique<EntriesPanel>(m_document.get());
    m_list = m_panel->findChild<EntriesList*>();
    m_panel->resize(240, 500);
    m_panel->show();
    m_panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    m_list->setFocus();
}

void EntriesPanelTest::cleanup() {
    m_panel.reset();
    m_document.reset();
}

QStringList EntriesPanelTest::names() const {
    QStringList result;
    for (const Entry& entry : m_document->file().entries)
        result.append(entry.fractal->name);
    return result;
}

QModelIndex EntriesPanelTest::row(const QString& name) const {
    for (int i = 0; i < m_list->model()->rowCount(); ++i)
        if (m_list->model()->index(i, 0).data().toString() == name) return m_list->model()->index(i, 0);
    return {};
}

void EntriesPanelTest::select(const QStringList& wanted) {
    m_list->setCurrentIndex(row(wanted.front()));
    for (const QString& name : wanted)
        m_list->selectionModel()->select(row(name), QItemSelectionModel::Select);
}

void EntriesPanelTest::key(Qt::Key code, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(m_list, code, modifiers);
}

void EntriesPanelTest::drop(const QMimeData& mimeData, const QPoint& position) {
    QDragEnterEvent enter(position, Qt::CopyAction | Qt::MoveAction, &mimeData, Qt::LeftButton,
                          Qt::NoModifier);
    QCoreApplication::sendEvent(m_list->viewport(), &enter);
    QDropEvent event(position, Qt::CopyAction | Qt::MoveAction, &mimeData, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_list->viewport(), &event);
}

void EntriesPanelTest::checkOneStep() {
    const FractalFile after = m_document->file();
    QVERIFY(after != m_before);
    QCOMPARE(m_document->undoStack()->count(), 1);
    m_document->undoStack()->undo();
    QVERIFY(m_document->file() == m_before);
    m_document->undoStack()->redo();
    QVERIFY(m_document->file() == after);
}

void EntriesPanelTest::add() {
    select({u"flower"_s});
    m_panel->addEntry();
    QCOMPARE(names().size(), 6);
    QCOMPARE(m_document->currentEntry().id, m_document->file().entries[2].id);
    QCOMPARE(document::system2(m_document->fractal())->maps.size(), std::size_t{3});
    QCOMPARE(m_list->currentIndex().row(), 2);
    checkOneStep();
}

// As in a file manager: letters are the name, and no keys of the window.
void EntriesPanelTest::theNameOfANewEntryIsTyped() {
    m_list->clearFocus(); // which the button has
    m_panel->addEntry();
    QCOMPARE(names().size(), 6);
    auto* editor = m_list->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTRY_VERIFY(editor->hasFocus());
    QCOMPARE(editor->selectedText(), currentName());
    QTest::keyClicks(editor, u"My"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    QCOMPARE(currentName(), u"My"_s);
    QCOMPARE(names().count(u"My"_s), 1);
}

void EntriesPanelTest::removeSeveral() {
    select({u"fern"_s, u"maple"_s});
    key(Qt::Key_Delete);
    QCOMPARE(names(), (QStringList{u"flower"_s, u"tree"_s, u"dragon"_s}));
    QVERIFY(m_list->currentIndex().isValid());
    QCOMPARE(m_list->currentIndex().data().toString(), currentName());
    checkOneStep();
}

// Neighbours are selected as one range: of a hundred thousand entries, one by one would take minutes.
void EntriesPanelTest::manyAtOnce() {
    QStringList wanted;
    for (int i = 0; i < 20'000; ++i)
        wanted << QStringLiteral("n%1").arg(i);
    m_document->setFile(fileOfNames(wanted));
    m_list->selectAll();
    m_panel->copySelected();
    QCOMPARE(view::entriesIn(*QGuiApplication::clipboard()->mimeData()).entries.size(), wanted.size());
    m_panel->duplicateSelected();
    QCOMPARE(names().size(), 2 * wanted.size());
    QCOMPARE(names()[1], wanted[1]);
    QCOMPARE(m_list->selectionModel()->selection().size(), 1);
    QCOMPARE(m_list->selectedIds().size(), wanted.size());
    m_panel->moveUp();
    QCOMPARE(names().last(), wanted.last());
    QCOMPARE(m_list->selectionModel()->selection().size(), 1);
    m_panel->removeSelected();
    QCOMPARE(names(), wanted);
    m_document->undoStack()->undo();
    m_document->undoStack()->undo();
    m_document->undoStack()->undo();
    QCOMPARE(names(), wanted);
}

void EntriesPanelTest::removeAll() {
    m_list->selectAll();
    m_panel->removeSelected();
    QVERIFY(names().isEmpty());
    QVERIFY(!m_list->currentIndex().isValid());
    m_panel->addEntry();
    QCOMPARE(names().size(), 1);
    m_document->undoStack()->undo();
    m_document->undoStack()->undo();
    QVERIFY(m_document->file() == m_before);
}

void EntriesPanelTest::duplicate() {
    select({u"maple"_s, u"fern"_s});
    key(Qt::Key_Insert);
    QCOMPARE(names(), (QStringList{u"maple"_s, u"flower"_s, u"fern"_s, u"maple_2"_s, u"fern_2"_s, u"tree"_s,
                                   u"dragon"_s}));
    QCOMPARE(m_list->selectedIds().size(), 2);
    QCOMPARE(currentName(), u"maple_2"_s);
    checkOneStep();
}

void EntriesPanelTest::renameByKeyboard() {
    select({u"tree"_s});
    key(Qt::Key_F2);
    auto* editor = m_list->findChild<QLineEdit*>();
    QVERIFY(editor);
    QVERIFY(!editor->accessibleName().isEmpty());
    editor->selectAll();
    QTest::keyClicks(editor, u"oak"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(m_document->undoStack()->count(), 1);
    QCOMPARE(currentName(), u"oak"_s);
    checkOneStep();
}

// A double click on the button: the second one finds the name being edited.
void EntriesPanelTest::renamingTwiceIsRenaming() {
    QTest::failOnWarning(QRegularExpression(u"^edit: "_s));
    select({u"tree"_s});
    for (QAction* action : m_list->findChildren<QAction*>() + m_panel->findChildren<QAction*>())
        if (action->shortcuts().contains(QKeySequence(Qt::Key_F2))) {
            action->trigger();
            action->trigger();
            break;
        }
    QVERIFY(m_list->isEditing());
}

// If there is one: a new name may take its entry, and the next one's place, out of the filter.
void EntriesPanelTest::tabGivesTheNextName() {
    QTest::failOnWarning(QRegularExpression(u"^edit: "_s));
    const auto editor = [this] { return m_list->findChild<QLineEdit*>(); };
    const auto name = [this](int row) { return m_document->file().entries[row].fractal->name; };
    const QString second = name(1);
    select({name(0)});
    key(Qt::Key_F2);
    QVERIFY(editor());
    editor()->setText(u"oak"_s);
    QTest::keyClick(editor(), Qt::Key_Tab);
    QTRY_COMPARE(name(0), u"oak"_s);
    QTRY_COMPARE(currentName(), second);
    QTRY_VERIFY(editor() && editor()->text() == second);
    QTest::keyClick(editor(), Qt::Key_Escape);
    QTRY_VERIFY(!editor());

    auto* filter = m_panel->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
    QVERIFY(filter);
    filter->setText(second);
    select({second});
    key(Qt::Key_F2);
    QVERIFY(editor());
    editor()->setText(u"zzz"_s);
    QTest::keyClick(editor(), Qt::Key_Tab);
    QTRY_COMPARE(name(1), u"zzz"_s);
    QTRY_VERIFY(!editor());
}

// The row without its editor must not show through, and a refusal is read where the name is typed.
void EntriesPanelTest::theNameEditorCoversTheNameAndShowsRefusals() {
    select({u"tree"_s});
    const QRect cell = m_list->visualRect(row(u"tree"_s));
    key(Qt::Key_F2);
    auto* editor = m_list->findChild<QLineEdit*>();
    QVERIFY(editor);
    const QFontMetrics metrics(m_list->font());
    const int bothLines = metrics.height() + QFontMetrics(m_list->font()).height() * 8 / 10;
    QVERIFY2(editor->height() >= bothLines, qPrintable(QString::number(editor->height())));
    QVERIFY(cell.contains(editor->geometry()));
    QVERIFY(qAbs(editor->geometry().center().y() - cell.center().y()) <= 2);

    editor->selectAll();
    QTest::keyClicks(editor, u"fer"_s);
    const QImage accepted = editor->grab().toImage();
    const auto cursor = [editor] {
        return editor->inputMethodQuery(Qt::ImCursorRectangle).toRectF().center().y();
    };
    const double typed = cursor();
    QTest::keyClicks(editor, u"n"_s);
    QVERIFY(!editor->accessibleDescription().isEmpty());
    const QImage refused = editor->grab().toImage();
    int red = 0, below = 0;
    for (int y = 0; y < refused.height(); ++y)
        for (int x = 0; x < refused.width(); ++x) {
            const QColor colour = refused.pixelColor(x, y);
            if (colour.red() > 150 && colour.green() < 100) ++red;
            if (y > refused.height() / 2 && x > 8 && x < refused.width() - 8 && y < refused.height() - 4 &&
                refused.pixel(x, y) != accepted.pixel(x, y))
                ++below;
        }
    QVERIFY(red > refused.width());
    QVERIFY2(below > 40, qPrintable(QString::number(below))); // the sentence
    QVERIFY(cursor() < typed);                                // makes room for it
    QTest::keyClick(editor, Qt::Key_Escape);
}

void EntriesPanelTest::badNameKeepsTheEditorOpen() {
    QSignalSpy messages(m_panel.get(), &EntriesPanel::message);
    select({u"tree"_s});
    key(Qt::Key_F2);
    QPointer<QLineEdit> editor = m_list->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, u"FERN"_s);
    QVERIFY(editor->accessibleDescription().contains(u"Another entry"_s));
    QCOMPARE(QToolTip::text(), editor->accessibleDescription());
    QTest::keyClick(editor, Qt::Key_Return);
    support::handleEvents();
    QVERIFY(editor && editor->isVisible());
    QCOMPARE(m_document->undoStack()->count(), 0);
    QTest::keyClick(editor, Qt::Key_Escape);
    QTRY_VERIFY(!editor || !editor->isVisible());
    QVERIFY(m_document->file() == m_before);
}

void EntriesPanelTest::moveByKeyboard() {
    select({u"fern"_s});
    key(Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(names(), (QStringList{u"maple"_s, u"fern"_s, u"flower"_s, u"tree"_s, u"dragon"_s}));
    QCOMPARE(currentName(), u"fern"_s);
    checkOneStep();
    key(Qt::Key_Down, Qt::AltModifier);
    key(Qt::Key_Down, Qt::AltModifier);
    key(Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(names().last(), u"fern"_s);
    const int steps = m_document->undoStack()->count();
    key(Qt::Key_Down, Qt::AltModifier); // nowhere to go
    QCOMPARE(m_document->undoStack()->count(), steps);
    QCOMPARE(m_list->currentIndex().data().toString(), u"fern"_s);
}

void EntriesPanelTest::moveSeveralWithGap() {
    select({u"flower"_s, u"tree"_s});
    m_panel->moveUp();
    QCOMPARE(names(), (QStringList{u"flower"_s, u"tree"_s, u"maple"_s, u"fern"_s, u"dragon"_s}));
    QCOMPARE(m_list->selectedIds().size(), 2);
    checkOneStep();
}

void EntriesPanelTest::dropMoves() {
    select({u"dragon"_s});
    emit m_list->entriesDropped(m_list->selectedIds(), m_before.entries[1].id);
    QCOMPARE(names(), (QStringList{u"maple"_s, u"dragon"_s, u"flower"_s, u"fern"_s, u"tree"_s}));
    QCOMPARE(currentName(), u"dragon"_s);
    checkOneStep();
}

void EntriesPanelTest::dropFromElsewhere() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.name = u"guest"_s;
    Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(fractal);
    const auto mimeData = view::entriesMimeData({entry});
    const QRect second = m_list->visualRect(row(u"flower"_s));
    drop(*mimeData, second.center() + QPoint(0, second.height() / 4)); // lower half: behind it
    QCOMPARE(names().size(), 5);                                       // not while the other window waits
    QTRY_COMPARE(names(),
                 (QStringList{u"maple"_s, u"flower"_s, u"guest"_s, u"fern"_s, u"tree"_s, u"dragon"_s}));
    checkOneStep();
}

void EntriesPanelTest::copyAndPasteBetweenDocuments() {
    document::Fractal rich = *m_before.entries[0].fractal;
    rich.comments = QStringList{u"a remark"_s};
    document::plane(rich)->cage = document::effectiveCage(rich);
    document::plane(rich)->cage->current[0] = {-1, -2};
    rich.appearance.gamma = 1.5;
    m_document->edit(u"enrich"_s, rich);
    select({u"maple"_s, u"tree"_s});
    key(Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QGuiApplication::clipboard()->text().contains(u"maple"_s));

    init();
    select({u"dragon"_s});
    key(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(names().mid(5), (QStringList{u"maple_2"_s, u"tree_2"_s}));
    const document::Fractal& pasted = m_document->fractal();
    QCOMPARE(pasted.name, u"maple_2"_s);
    QCOMPARE(pasted.comments, rich.comments);
    QVERIFY(document::plane(pasted)->cage == document::plane(rich)->cage);
    QVERIFY(pasted.appearance == rich.appearance);
    QCOMPARE(m_list->selectedIds().size(), 2);
    checkOneStep();
}

void EntriesPanelTest::pasteNonsense() {
    QSignalSpy messages(m_panel.get(), &EntriesPanel::message);
    QGuiApplication::clipboard()->setText(u"once upon a time"_s);
    m_panel->paste();
    QCOMPARE(messages.count(), 1);
    QVERIFY(m_document->file() == m_before);
    QCOMPARE(m_document->undoStack()->count(), 0);
}

void EntriesPanelTest::pasteNothing() {
    QSignalSpy messages(m_panel.get(), &EntriesPanel::message);
    for (const QString& text : {QString(), u" \n"_s}) {
        QGuiApplication::clipboard()->setText(text);
        m_panel->paste();
        QVERIFY(messages.takeLast().front().toString().contains(u"clipboard"_s));
    }
    QGuiApplication::clipboard()->clear();
    m_panel->paste();
    const QString said = messages.takeLast().front().toString();
    QVERIFY2(said.contains(u"clipboard"_s) && !said.contains(u"file"_s), qPrintable(said));
    QVERIFY(m_document->file() == m_before);
}

void EntriesPanelTest::aBareTableIsAskedAbout() {
    QGuiApplication::clipboard()->setText(u"0.5 0.1 3 0.2 0.4 5 0.25\n0.3 0 2 0 0.3 1 0.75\n"_s);
    m_panel->paste();
    QCOMPARE(names().size(), m_before.entries.size() + 1);
    const auto shift = [&] { return document::system2(m_document->fractal())->maps[0].map.translation.x(); };
    auto* dialog = m_panel->findChild<view::PasteTableDialog*>();
    QVERIFY(dialog);
    QCOMPARE(shift(), 3.0); // the first order in which every map contracts
    dialog->accept();
    QCOMPARE(shift(), 3.0);
    QCOMPARE(m_document->undoStack()->count(), 2);
    m_document->undoStack()->undo();
    QCOMPARE(shift(), 0.4); // Fractint's
}

void EntriesPanelTest::comment() {
    select({u"fern"_s});
    m_panel->editComment();
    auto* dialog = m_panel->findChild<QDialog*>();
    QVERIFY(dialog);
    dialog->findChild<QLineEdit*>()->setText(u"Barnsley's"_s);
    auto* lines = dialog->findChild<QPlainTextEdit*>();
    const auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    lines->setPlainText(u"fine\nbarycage: mine"_s);
    QVERIFY(!ok->isEnabled());
    lines->setPlainText(QString(199, u'x'));
    QVERIFY(!ok->isEnabled());
    lines->setPlainText(u"one\n two\tor\tthree "_s);
    dialog->findChild<QLineEdit*>()->setText(u"Barnsley's\nown"_s); // as pasted from elsewhere
    QVERIFY(ok->isEnabled());
    QSignalSpy accepted(dialog, &QDialog::accepted);
    dialog->accept();
    QCOMPARE(accepted.count(), 1);
    QCOMPARE(m_document->fractal().headerComment, u"Barnsley's own"_s); // as it will be read again
    QCOMPARE(m_document->fractal().comments, (QStringList{u"one"_s, u"two or three"_s}));
    checkOneStep();
}

// So that it is kept for recovery; it is no step of the history yet.
void EntriesPanelTest::whatIsTypedIsInTheDocument() {
    select({u"tree"_s});
    key(Qt::Key_F2);
    auto* editor = m_list->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, u"oa"_s);
    QCOMPARE(currentName(), u"oa"_s);
    QVERIFY(m_document->isModified());
    QCOMPARE(m_document->undoStack()->count(), 0);
    QTest::keyClick(editor, Qt::Key_Backspace);
    QTest::keyClick(editor, Qt::Key_Backspace); // which is no name: the last one stays
    QCOMPARE(currentName(), u"o"_s);
    QTest::keyClick(editor, Qt::Key_Escape);
    QCOMPARE(currentName(), u"tree"_s);
    QVERIFY(!m_document->isModified());
    QTRY_VERIFY(!m_list->findChild<QLineEdit*>());

    m_panel->editComment();
    auto* dialog = m_panel->findChild<QDialog*>();
    QVERIFY(dialog);
    dialog->findChild<QPlainTextEdit*>()->setPlainText(u"half a"_s);
    QCOMPARE(m_document->fractal().comments, QStringList{u"half a"_s});
    QVERIFY(m_document->isModified());
    QCOMPARE(m_document->undoStack()->count(), 0);
    dialog->reject();
    QVERIFY(m_document->fractal().comments.isEmpty());
    QVERIFY(!m_document->isModified());

    key(Qt::Key_F2);
    editor = m_list->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, u"oak"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(m_document->undoStack()->count(), 1);
    QCOMPARE(currentName(), u"oak"_s);
    checkOneStep();
}

void EntriesPanelTest::filterHidesAndKeepsCurrent() {
    auto* filter = m_panel->findChild<QLineEdit*>();
    select({u"tree"_s});
    filter->setText(u"F"_s);
    QCOMPARE(m_list->model()->rowCount(), 3); // flower, fern and tree, which is shown
    QCOMPARE(currentName(), u"tree"_s);
    QCOMPARE(m_list->currentIndex().data().toString(), u"tree"_s);
    m_document->setCurrent(m_before.entries[4].id);
    QCOMPARE(m_list->currentIndex().data().toString(), u"dragon"_s);
    QCOMPARE(m_list->model()->rowCount(), 4); // no row goes from under a double click
    m_document->setCurrent(m_before.entries[3].id);
    filter->setText(u"re"_s);
    QCOMPARE(m_list->currentIndex().data().toString(), u"tree"_s);
    filter->setText(u"zzz"_s);
    QCOMPARE(m_list->model()->rowCount(), 1);
    QCOMPARE(m_list->currentIndex().data().toString(), u"tree"_s);
    QCOMPARE(currentName(), u"tree"_s);
    m_panel->addEntry(); // would be hidden
    QVERIFY(filter->text().isEmpty());
    QCOMPARE(m_list->model()->rowCount(), 6);
    QCOMPARE(m_list->currentIndex().data().toString(), currentName());
}

void EntriesPanelTest::anotherFileClearsTheFilter() {
    auto* filter = m_panel->findChild<QLineEdit*>();
    filter->setText(u"tree"_s);
    m_document->setFile(fileOfNames({u"oak"_s, u"ash"_s, u"elm"_s}));
    QVERIFY(filter->text().isEmpty());
    QCOMPARE(m_list->model()->rowCount(), 3);
    QCOMPARE(m_list->currentIndex().data().toString(), u"oak"_s);
}

void EntriesPanelTest::currentFollowsBothWays() {
    m_document->setCurrent(m_before.entries[3].id);
    QCOMPARE(m_list->currentIndex().row(), 3);
    QTest::mouseClick(m_list->viewport(), Qt::LeftButton, {}, m_list->visualRect(row(u"flower"_s)).center());
    QCOMPARE(currentName(), u"flower"_s);
    key(Qt::Key_Down);
    QCOMPARE(currentName(), u"fern"_s);
    QCOMPARE(m_document->undoStack()->count(), 0);
}

void EntriesPanelTest::selectionSurvivesUndo() {
    select({u"flower"_s, u"tree"_s});
    const auto ids = m_list->selectedIds();
    m_panel->moveDown();
    QCOMPARE(m_list->selectedIds(), ids);
    m_document->undoStack()->undo();
    QCOMPARE(m_list->selectedIds(), ids);
}

void EntriesPanelTest::emptyFile() {
    m_document->setFile(FractalFile());
    QVERIFY(m_list->selectedIds().isEmpty());
    m_panel->removeSelected();
    m_panel->duplicateSelected();
    m_panel->moveUp();
    m_panel->moveDown();
    m_panel->copySelected();
    m_panel->renameCurrent();
    m_panel->editComment();
    QVERIFY(m_document->file() == FractalFile());
    m_panel->grab(); // says so instead of showing rows
}

void EntriesPanelTest::everythingIsNamed() {
    for (const QWidget* widget : m_panel->findChildren<QWidget*>())
        if (widget->focusPolicy() != Qt::NoFocus && widget->isVisible())
            QVERIFY2(!widget->accessibleName().isEmpty() ||
                         !widget->parentWidget()->accessibleName().isEmpty(),
                     widget->metaObject()->className());
    for (const QAction* action : m_list->actions())
        QVERIFY2(!action->statusTip().isEmpty(), qPrintable(action->text()));
}

BARYCAGE_TEST(EntriesPanelTest, QApplication);
#include "entries_panel_test.moc"
