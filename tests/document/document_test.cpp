// SPDX-License-Identifier: MIT
#include "document/document.h"
#include "support/named_test.h"

#include <QRandomGenerator>
#include <QtTest>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

using document::Change;
using document::Document;
using document::EditGesture;
using document::Entry;
using document::EntryId;
using document::Fractal;
using document::FractalFile;

namespace {

Fractal moved(Fractal fractal, double a) {
    document::system2(fractal)->maps[0].map.linear(0, 0) = a;
    return fractal;
}

double firstNumber(const Document& document) {
    return document::system2(document.fractal())->maps[0].map.linear(0, 0);
}

FractalFile fileOf(const QStringList& names) {
    FractalFile file;
    for (const QString& name : names) {
        Fractal fractal = document::sierpinskiTriangle();
        fractal.name = name;
        file.entries.append({document::freshId(file), std::make_shared<const Fractal>(fractal), nullptr, {}});
    }
    return file;
}

struct Listener {
    explicit Listener(Document& document) {
        QObject::connect(&document, &Document::changed, &document,
                         [this](const Change& change) { changes.push_back(change); });
    }
    std::vector<Change> changes;
};

} // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void newDocument();
    void editIsOneStep();
    void editWithoutEffectLeavesNoStep();
    void gestureIsOneStep();
    void gestureThatReturnsLeavesNoStep();
    void cancelRestoresExactly();
    void destructionCancels();
    void movedGestureGoesOn();
    void secondGestureCommitsTheFirst();
    void editDuringAGestureCommitsIt();
    void undoDuringAGestureDropsIt();
    void redoDuringAGestureDropsIt();
    void currentEntryChangesDuringAGesture();
    void fileIsReplacedDuringAGesture();
    void documentGoesBeforeItsGesture();
    void cleanState();
    void undoShowsTheEntryItBelongsTo();
    void editFileRemovesTheCurrentEntry();
    void removingAllEntriesIsSafe();
    void partsAreTold();
    void partsInSpaceAreTold();
    void markSavedTakesTheProblems();
    void names_data();
    void names();
    void stepsOfOneKindBecomeOne();
    void randomEditsUndoExactly();
};

void DocumentTest::newDocument() {
    const Document document;
    QCOMPARE(document.file().entries.size(), 1);
    QCOMPARE(document.fractal().name, QStringLiteral("sierpinski"));
    QCOMPARE(document::system2(document.fractal())->maps.size(), std::size_t(3));
    QVERIFY(!document.isModified());
}

void DocumentTest::editIsOneStep() {
    Document document;
    const Fractal before = document.fractal();
    const auto revision = document.revision();
    document.edit(QStringLiteral("Move"), moved(before, 0.25));
    QCOMPARE(firstNumber(document), 0.25);
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document.undoStack()->undoText(), QStringLiteral("Move"));
    QVERIFY(document.revision() > revision);
    document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
    document.undoStack()->redo();
    QCOMPARE(firstNumber(document), 0.25);
}

// As of an arrow key that is pressed several times.
void DocumentTest::stepsOfOneKindBecomeOne() {
    Document document;
    const Fractal before = document.fractal();
    const double start = firstNumber(document);
    const auto nudge = [&](double to, int kind) {
        EditGesture gesture = document.beginGesture(QStringLiteral("Nudge"));
        gesture.describe(QStringLiteral("Nudge to %1").arg(to), kind);
        gesture.preview(moved(document.fractal(), to));
        gesture.commit();
    };
    nudge(0.25, 7);
    nudge(0.5, 7);
    nudge(0.75, 7);
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document.undoStack()->undoText(), QStringLiteral("Nudge to 0.75"));
    nudge(0.8, 8); // another handle
    QCOMPARE(document.undoStack()->count(), 2);
    nudge(0.9, -1);
    nudge(1, -1);
    QCOMPARE(document.undoStack()->count(), 4);
    nudge(1.1, 9);
    QTest::qWait(1100); // what comes sooner joins the step before, by the clock
    nudge(1.2, 9);      // too late
    QCOMPARE(document.undoStack()->count(), 6);
    document.markSaved(document.file());
    nudge(1.3, 9); // what was saved can be gone back to
    QCOMPARE(document.undoStack()->count(), 7);
    while (document.undoStack()->canUndo())
        document.undoStack()->undo();
    QVERIFY(document.fractal() == before);
    nudge(0.25, 7);
    nudge(start, 7); // and back: nothing has been done
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(document.fractal() == before);
}

void DocumentTest::editWithoutEffectLeavesNoStep() {
    Document document;
    Listener listener(document);
    document.edit(QStringLiteral("Nothing"), document.fractal());
    document.editFile(QStringLiteral("Nothing"), document.file());
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(listener.changes.empty());
}

void DocumentTest::gestureIsOneStep() {
    Document document;
    Listener listener(document);
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    for (const double a : {0.1, 0.2, 0.3}) {
        gesture.preview(moved(gesture.before(), a));
        QCOMPARE(firstNumber(document), a);
    }
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(document.isModified());
    gesture.commit();
    QVERIFY(!gesture.isOpen());
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(listener.changes.size(), std::size_t(4));
    QVERIFY(listener.changes[2].live);
    QVERIFY(!listener.changes[3].live); // tells that the drag is over
    QVERIFY(listener.changes[3].parts == Change::System);
    document.undoStack()->undo();
    QCOMPARE(firstNumber(document), 0.5);
    gesture.preview(moved(gesture.before(), 0.9)); // too late
    QCOMPARE(firstNumber(document), 0.5);
}

void DocumentTest::gestureThatReturnsLeavesNoStep() {
    Document document;
    Listener listener(document);
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    gesture.preview(gesture.before());
    gesture.commit();
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(!document.isModified());
    QVERIFY(!listener.changes.back().live);
}

void DocumentTest::cancelRestoresExactly() {
    Document document;
    const auto before = document.currentEntry().fractal;
    Listener listener(document);
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 1.0 / 3));
    gesture.cancel();
    QCOMPARE(document.currentEntry().fractal.get(), before.get());
    QCOMPARE(document.undoStack()->count(), 0);
    QVERIFY(!listener.changes.back().live);
    QVERIFY(listener.changes.back().parts == Change::System);
}

void DocumentTest::destructionCancels() {
    Document document;
    {
        EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
        gesture.preview(moved(gesture.before(), 0.1));
    }
    QCOMPARE(firstNumber(document), 0.5);
    QCOMPARE(document.undoStack()->count(), 0);
}

void DocumentTest::movedGestureGoesOn() {
    Document document;
    {
        EditGesture first = document.beginGesture(QStringLiteral("Drag"));
        first.preview(moved(first.before(), 0.1));
        std::optional<EditGesture> second;
        second.emplace(std::move(first));
        QVERIFY(!first.isOpen()); // NOLINT(bugprone-use-after-move): says so
        QVERIFY(second->isOpen());
        first.cancel();
        QCOMPARE(firstNumber(document), 0.1);
        second->preview(moved(second->before(), 0.2));
    }
    QCOMPARE(firstNumber(document), 0.5);
    QCOMPARE(document.undoStack()->count(), 0);
}

void DocumentTest::secondGestureCommitsTheFirst() {
    Document document;
    EditGesture first = document.beginGesture(QStringLiteral("First"));
    first.preview(moved(first.before(), 0.1));
    EditGesture second = document.beginGesture(QStringLiteral("Second"));
    QVERIFY(!first.isOpen());
    QVERIFY(second.isOpen());
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(document::system2(second.before())->maps[0].map.linear(0, 0), 0.1);
}

void DocumentTest::editDuringAGestureCommitsIt() {
    Document document;
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    document.edit(QStringLiteral("Edit"), moved(gesture.before(), 0.2));
    QCOMPARE(document.undoStack()->count(), 2);
    document.undoStack()->undo();
    QCOMPARE(firstNumber(document), 0.1);
    document.undoStack()->undo();
    QCOMPARE(firstNumber(document), 0.5);
}

void DocumentTest::undoDuringAGestureDropsIt() {
    Document document;
    document.edit(QStringLiteral("Edit"), moved(document.fractal(), 0.3));
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    Listener listener(document);
    document.undoStack()->undo();
    QCOMPARE(firstNumber(document), 0.5);
    QVERIFY(!gesture.isOpen());
    QVERIFY(!listener.changes.back().live);
    gesture.commit();
    QCOMPARE(firstNumber(document), 0.5);
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->redo();
    QCOMPARE(firstNumber(document), 0.3);
}

void DocumentTest::redoDuringAGestureDropsIt() {
    Document document;
    document.edit(QStringLiteral("Edit"), moved(document.fractal(), 0.3));
    document.undoStack()->undo();
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    document.undoStack()->redo();
    QCOMPARE(firstNumber(document), 0.3);
    QVERIFY(!gesture.isOpen());
}

void DocumentTest::currentEntryChangesDuringAGesture() {
    Document document;
    document.setFile(fileOf({QStringLiteral("a"), QStringLiteral("b")}));
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    document.setCurrent(document.file().entries[1].id);
    QVERIFY(!gesture.isOpen());
    QCOMPARE(document.undoStack()->count(), 1);
    QCOMPARE(firstNumber(document), 0.5);
    QCOMPARE(document::system2(*document.file().entries[0].fractal)->maps[0].map.linear(0, 0), 0.1);
}

void DocumentTest::fileIsReplacedDuringAGesture() {
    Document document;
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    document.setFile(fileOf({QStringLiteral("a")}));
    gesture.cancel();
    QVERIFY(!gesture.isOpen());
    QCOMPARE(document.fractal().name, QStringLiteral("a"));
    QVERIFY(!document.isModified());
}

void DocumentTest::documentGoesBeforeItsGesture() {
    auto document = std::make_unique<Document>();
    EditGesture gesture = document->beginGesture(QStringLiteral("Drag"));
    gesture.preview(moved(gesture.before(), 0.1));
    document.reset();
    QVERIFY(!gesture.isOpen());
    gesture.commit(); // nothing to do, nothing to crash on
}

void DocumentTest::cleanState() {
    Document document;
    document.edit(QStringLiteral("Edit"), moved(document.fractal(), 0.3));
    QVERIFY(document.isModified());
    document.markSaved(document.file());
    QVERIFY(!document.isModified());
    document.undoStack()->undo();
    QVERIFY(document.isModified());
    document.undoStack()->redo();
    QVERIFY(!document.isModified());
    document.undoStack()->undo();
    document.edit(QStringLiteral("Another"),
                  moved(document.fractal(), 0.4)); // the saved state is out of reach
    document.undoStack()->undo();
    QVERIFY(document.isModified());
}

void DocumentTest::undoShowsTheEntryItBelongsTo() {
    Document document;
    document.setFile(fileOf({QStringLiteral("a"), QStringLiteral("b")}));
    const EntryId a = document.file().entries[0].id;
    const EntryId b = document.file().entries[1].id;
    document.edit(QStringLiteral("Edit"), moved(document.fractal(), 0.3));
    document.setCurrent(b);
    QCOMPARE(document.undoStack()->count(), 1); // choosing an entry is not a step
    Listener listener(document);
    document.undoStack()->undo();
    QVERIFY(document.currentId() == a);
    QVERIFY(listener.changes.at(0).parts.testFlag(Change::Current));
    QCOMPARE(firstNumber(document), 0.5);
    document.setCurrent(b);
    document.undoStack()->redo();
    QVERIFY(document.currentId() == a);
    QCOMPARE(firstNumber(document), 0.3);
}

void DocumentTest::editFileRemovesTheCurrentEntry() {
    Document document;
    document.setFile(fileOf({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}),
                     static_cast<EntryId>(2));
    QCOMPARE(document.fractal().name, QStringLiteral("b"));
    FractalFile without = document.file();
    without.entries.removeAt(1);
    Listener listener(document);
    document.editFile(QStringLiteral("Remove"), without);
    QCOMPARE(document.fractal().name, QStringLiteral("c"));
    QVERIFY(listener.changes.at(0).parts.testFlag(Change::Entries));
    QVERIFY(listener.changes.at(0).parts.testFlag(Change::Current));
    document.undoStack()->undo();
    QCOMPARE(document.file().entries.size(), 3);
    QCOMPARE(document.fractal().name, QStringLiteral("b"));
}

void DocumentTest::removingAllEntriesIsSafe() {
    Document document;
    document.editFile(QStringLiteral("Remove"), FractalFile());
    QVERIFY(document.currentId() == EntryId::None);
    QCOMPARE(document::dimension(document.fractal()), 0);
    document.edit(QStringLiteral("Edit"), document::sierpinskiTriangle());
    EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
    gesture.preview(document::sierpinskiTriangle());
    gesture.commit();
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QCOMPARE(document.fractal().name, QStringLiteral("sierpinski"));
}

void DocumentTest::partsAreTold() {
    Document document;
    Listener listener(document);
    Fractal fractal = document.fractal();
    fractal.name = QStringLiteral("other");
    document.edit(QStringLiteral("Rename"), fractal);
    fractal.appearance.gamma = 3;
    document.edit(QStringLiteral("Gamma"), fractal);
    document::plane(fractal)->cage =
        ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)});
    document.edit(QStringLiteral("Cage"), fractal);
    document.setFile(fileOf({QStringLiteral("a")}));
    QVERIFY(listener.changes.at(0).parts == Change::Name);
    QVERIFY(listener.changes.at(1).parts == Change::Appearance);
    QVERIFY(listener.changes.at(2).parts == Change::Cage);
    QVERIFY(listener.changes.at(3).parts == Change::Everything);
}

void DocumentTest::partsInSpaceAreTold() {
    Fractal fractal;
    fractal.shape = document::Shape<3>();
    Fractal other = fractal;
    QVERIFY(document::difference(fractal, other) == Change::Parts());
    document::space(other)->cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    QVERIFY(document::difference(fractal, other) == Change::Cage);
    other = fractal;
    document::space(other)->moved = {{{ifs::MapId(1)}, {}}};
    QVERIFY(document::difference(fractal, other) == Change::Cage);
    other = fractal;
    ifs::append(*document::system3(other), {});
    QVERIFY(document::difference(fractal, other) == Change::System);
    QVERIFY(document::difference(fractal, document::sierpinskiTriangle()).testFlag(Change::System));
}

void DocumentTest::markSavedTakesTheProblems() {
    Document document;
    FractalFile saved = document.file();
    saved.entries[0].problems.append(
        {document::Problem::Severity::Warning, {}, 1, 1, QStringLiteral("Mind.")});
    document.markSaved(saved);
    QCOMPARE(document.currentEntry().problems.size(), 1);
}

void DocumentTest::names_data() {
    QTest::addColumn<QString>("wish");
    QTest::addColumn<QString>("name");
    QTest::newRow("free") << QStringLiteral("fern") << QStringLiteral("fern");
    QTest::newRow("taken, ignoring case") << QStringLiteral("A") << QStringLiteral("A_3");
    QTest::newRow("blanks and signs")
        << QStringLiteral(" my (new) {fern}; ") << QStringLiteral("my_new_fern");
    QTest::newRow("prefix") << QStringLiteral("par:x") << QStringLiteral("par_x");
    QTest::newRow("comment") << QStringLiteral("Comment") << QStringLiteral("Comment_");
    QTest::newRow("empty") << QStringLiteral(" ;") << QStringLiteral("fractal");
    QTest::newRow("too long") << QStringLiteral("abcdefghijklmnopqrstuvw")
                              << QStringLiteral("abcdefghijklmnopqr");
    QTest::newRow("bytes count") << QString::fromUtf8("éééééééééé") << QString::fromUtf8("ééééééééé");
}

void DocumentTest::names() {
    QFETCH(QString, wish);
    const FractalFile file = fileOf({QStringLiteral("a"), QStringLiteral("a_2")});
    QTEST(document::uniqueName(file, wish), "name");
    QCOMPARE(document::uniqueName(file, QStringLiteral("A"), file.entries[0].id), QStringLiteral("A"));
    const FractalFile full = fileOf({QStringLiteral("abcdefghijklmnopqr")});
    QCOMPARE(document::uniqueName(full, QStringLiteral("ABCDEFGHIJKLMNOPQRST")),
             QStringLiteral("ABCDEFGHIJKLMNOP_2"));
}

void DocumentTest::randomEditsUndoExactly() {
    Document document;
    document.setFile(fileOf({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}));
    std::vector<FractalFile> states{document.file()};
    QRandomGenerator random(7);
    for (int i = 0; i < 300; ++i) {
        document.setCurrent(document.file().entries.at(random.bounded(document.file().entries.size())).id);
        if (random.bounded(4) == 0) {
            FractalFile file = document.file();
            file.entries.move(0, random.bounded(file.entries.size()));
            document.editFile(QStringLiteral("Move"), file);
        } else {
            EditGesture gesture = document.beginGesture(QStringLiteral("Drag"));
            for (int step = random.bounded(4); step > 0; --step)
                gesture.preview(moved(gesture.before(), random.bounded(1.0)));
            gesture.commit();
        }
        if (document.undoStack()->count() == static_cast<int>(states.size()))
            states.push_back(document.file());
    }
    QVERIFY(states.size() > 100);
    for (auto state = states.rbegin(); state != states.rend(); ++state) {
        QVERIFY(document.file() == *state);
        document.undoStack()->undo();
    }
    for (const FractalFile& state : states) {
        QVERIFY(document.file() == state);
        document.undoStack()->redo();
    }
}

BARYCAGE_TEST(DocumentTest);
#include "document_test.moc"
