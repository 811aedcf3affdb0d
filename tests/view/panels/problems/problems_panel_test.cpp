// SPDX-License-Identifier: MIT
#include "panels/problems/problems_model.h"
#include "panels/problems/problems_panel.h"

#include "document/edits/entries_edits.h"
#include "support/named_test.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTest>
#include <QTextDocument>
#include <QTreeView>

using namespace Qt::StringLiterals;
using document::Document;
using document::EntryId;
using document::Problem;

namespace {

document::FractalFile fileWithProblems() {
    document::FractalFile file;
    for (const QString& name : {u"first"_s, u"second"_s, u"third"_s}) {
        document::Fractal fractal = document::sierpinskiTriangle();
        fractal.name = name;
        file.entries.append(
            {document::freshId(file), std::make_shared<const document::Fractal>(fractal), nullptr, {}});
    }
    file.entries[2].problems = {{Problem::Severity::Warning, u"third"_s, 30, 2, u"Six numbers in a row."_s}};
    file.entries[1].problems = {{Problem::Severity::Error, u"second"_s, 20, 5, u"This is no number."_s},
                                {Problem::Severity::Warning, u"second"_s, 21, 1, u"The weights sum to 2."_s}};
    file.problems = {{Problem::Severity::Warning, {}, 0, 0, u"The file ends in Ctrl-Z."_s}};
    return file;
}

} // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void listsAllInOrder();
    void choosingShowsTheEntry();
    void followsTheFile();
    void remarksCallForNoAttention();
    void copies();
    void tipsAreNoMarkup();
    void longNamesLeaveRoomForTheProblems();
};

void ProblemsPanelTest::longNamesLeaveRoomForTheProblems() {
    document::FractalFile file = fileWithProblems();
    document::Fractal named = *file.entries[1].fractal;
    const QString name = named.name = QString(200, u'm');
    file.entries[1].fractal = std::make_shared<const document::Fractal>(named);
    Document document;
    view::ProblemsPanel panel(&document);
    panel.resize(640, 200);
    panel.show();
    document.setFile(file);
    auto* list = panel.findChild<QTreeView*>();
    QVERIFY(list->columnWidth(view::ProblemsModel::EntryName) < 300);
    QVERIFY(list->columnViewportPosition(view::ProblemsModel::Message) < 500);
    QCOMPARE(list->model()->index(1, view::ProblemsModel::EntryName).data(Qt::ToolTipRole).toString(), name);
    document.setFile(fileWithProblems()); // short ones are whole
    QVERIFY(list->columnWidth(view::ProblemsModel::EntryName) >
            panel.fontMetrics().horizontalAdvance(u"second"_s));
}

void ProblemsPanelTest::tipsAreNoMarkup() {
    document::FractalFile file = fileWithProblems();
    file.problems.first().message = u"“<img src=pipe>” is not a number."_s;
    Document document;
    document.setFile(file);
    const view::ProblemsModel model(&document);
    const QModelIndex index = model.index(0, view::ProblemsModel::Message);
    QCOMPARE(index.data().toString(), file.problems.first().message);
    const QString tip = index.data(Qt::ToolTipRole).toString();
    QTextDocument shown;
    shown.setHtml(tip);
    QVERIFY(!tip.contains(u"<img"_s));
    QCOMPARE(shown.toPlainText(), file.problems.first().message);
    QCOMPARE(model.index(1, view::ProblemsModel::Message).data(Qt::ToolTipRole).toString(),
             u"This is no number."_s);
}

void ProblemsPanelTest::listsAllInOrder() {
    Document document;
    document.setFile(fileWithProblems());
    view::ProblemsModel model(&document);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 4);
    QStringList places;
    for (int row = 0; row < 4; ++row)
        places.append(model.index(row, view::ProblemsModel::Place).data().toString());
    QCOMPARE(places, (QStringList{QString(), u"20:5"_s, u"21:1"_s, u"30:2"_s}));
    QCOMPARE(model.index(1, view::ProblemsModel::EntryName).data().toString(), u"second"_s);
    QCOMPARE(model.index(1, view::ProblemsModel::Place).data(Qt::AccessibleTextRole).toString(),
             u"Error 20:5"_s);
    QCOMPARE(model.entryAt(0), EntryId::None);
}

void ProblemsPanelTest::choosingShowsTheEntry() {
    Document document;
    document.setFile(fileWithProblems());
    view::ProblemsPanel panel(&document);
    panel.resize(500, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    auto* list = panel.findChild<QTreeView*>();
    const auto click = [list](int row) {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(list->model()->index(row, 2)).center());
    };
    click(3);
    QCOMPARE(document.fractal().name, u"third"_s);
    click(1);
    QCOMPARE(document.fractal().name, u"second"_s);
    click(0); // concerns the whole file
    QCOMPARE(document.fractal().name, u"second"_s);
}

void ProblemsPanelTest::followsTheFile() {
    Document document;
    view::ProblemsPanel panel(&document);
    QSignalSpy counts(&panel, &view::ProblemsPanel::countChanged);
    QCOMPARE(panel.count(), 0);
    document.setFile(fileWithProblems());
    QCOMPARE(panel.count(), 4);
    QCOMPARE(counts.last().front().toInt(), 4);
    const EntryId second = document.file().entries[1].id;
    document.editFile(u"remove"_s, document::removed(document.file(), {second}));
    QCOMPARE(panel.count(), 2);
    document.undoStack()->undo();
    QCOMPARE(panel.count(), 4);
}

// They are listed, but the panel does not open for them.
void ProblemsPanelTest::remarksCallForNoAttention() {
    document::FractalFile file = fileWithProblems();
    file.problems.clear();
    file.entries[1].problems = {{Problem::Severity::Remark, u"second"_s, 21, 1, u"The weights sum to 2."_s}};
    file.entries[2].problems.clear();
    Document document;
    view::ProblemsPanel panel(&document);
    QSignalSpy counts(&panel, &view::ProblemsPanel::countChanged);
    document.setFile(file);
    QCOMPARE(panel.count(), 1);
    QCOMPARE(counts.last().front().toInt(), 0);
}

void ProblemsPanelTest::copies() {
    Document document;
    document.setFile(fileWithProblems());
    view::ProblemsPanel panel(&document);
    panel.setFileName(u"all.ifs"_s);
    panel.copySelected();
    QCOMPARE(QGuiApplication::clipboard()->text().split(u'\n').size(), 4);
    auto* list = panel.findChild<QTreeView*>();
    list->setCurrentIndex(list->model()->index(1, 0));
    panel.copySelected();
    QCOMPARE(QGuiApplication::clipboard()->text(), u"all.ifs:20:5: error: “second”: This is no number."_s);
}

BARYCAGE_TEST(ProblemsPanelTest, QApplication);
#include "problems_panel_test.moc"
