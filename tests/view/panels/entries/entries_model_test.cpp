// SPDX-License-Identifier: MIT
#include "document/edit_gesture.h"
#include "document/edits/entries_edits.h"
#include "panels/entries/entries_model.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QAbstractItemModelTester>
#include <QListView>
#include <QRegularExpression>
#include <QSignalSpy>

#include <random>

using namespace Qt::StringLiterals;
using document::Document;
using document::Entry;
using document::EntryId;
using document::FractalFile;
using view::EntriesModel;
using view::Thumbnails;

namespace {

EntryId id(int number) {
    return static_cast<EntryId>(number);
}

Entry entry(int number, const document::Fractal& like = document::sierpinskiTriangle()) {
    document::Fractal fractal = like;
    fractal.name = u"e%1"_s.arg(number);
    return {id(number), std::make_shared<const document::Fractal>(fractal), nullptr, {}};
}

FractalFile fileOfEntries(int count) {
    FractalFile file;
    for (int number = 1; number <= count; ++number)
        file.entries.append(entry(number));
    return file;
}

QList<EntryId> idsOf(const FractalFile& file) {
    QList<EntryId> ids;
    for (const Entry& e : file.entries)
        ids.append(e.id);
    return ids;
}

QList<EntryId> idsOf(const EntriesModel& model) {
    QList<EntryId> ids;
    for (int row = 0; row < model.rowCount(); ++row)
        ids.append(model.idAt(model.index(row)));
    return ids;
}

} // namespace

class EntriesModelTest : public QObject {
    Q_OBJECT

private slots:
    void followsRandomEdits();
    void renameIsOneStep();
    void refusesBadNames();
    void nothingIsCurrent();
    void saysWhatIsWrong();
    void modifiedMark();
    void liveEditsWait();
    void longFileAsksOnlyForWhatIsSeen();
    void pictureArrives();
};

// After any edit, undo or redo the rows are those of the file, and a persistent index follows its entry.
void EntriesModelTest::followsRandomEdits() {
    std::mt19937 random(30);
    Document document;
    document.setFile(fileOfEntries(12));
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);

    for (int round = 0; round < 400; ++round) {
        QHash<EntryId, QPersistentModelIndex> held;
        for (int row = 0; row < model.rowCount(); ++row)
            held.insert(model.idAt(model.index(row)), model.index(row));

        const FractalFile& file = document.file();
        QList<EntryId> some;
        for (const Entry& e : file.entries)
            if (random() % 4 == 0) some.append(e.id);
        const EntryId place = file.entries.isEmpty()
                                  ? EntryId::None
                                  : file.entries[static_cast<qsizetype>(random() % file.entries.size())].id;
        switch (random() % 6) {
        case 0:
            document.editFile(u"insert"_s, document::inserted(file, {entry(500), entry(501)}, place).file);
            break;
        case 1:
            document.editFile(u"remove"_s, document::removed(file, some));
            break;
        case 2:
            document.editFile(u"move"_s, document::moved(file, some, place));
            break;
        case 3: { // everything at once
            const FractalFile moved = document::moved(document::removed(file, some.mid(0, 2)), some, place);
            document.editFile(u"all"_s, document::inserted(moved, {entry(7)}, place).file);
            break;
        }
        case 4:
            document.undoStack()->undo();
            break;
        default:
            document.undoStack()->redo();
            break;
        }

        QCOMPARE(idsOf(model), idsOf(document.file()));
        for (auto index = held.begin(); index != held.end(); ++index) {
            const bool remains = document::indexOf(document.file(), index.key()) >= 0;
            QCOMPARE(index->isValid(), remains);
            if (remains) QCOMPARE(model.idAt(*index), index.key());
        }
    }
    QCOMPARE(resets.count(), 0);
}

void EntriesModelTest::renameIsOneStep() {
    Document document;
    document.setFile(fileOfEntries(3));
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);
    const FractalFile before = document.file();
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    QVERIFY(model.setData(model.index(1), u" fern "_s, Qt::EditRole));
    QCOMPARE(model.index(1).data().toString(), u"fern"_s);
    QVERIFY(changes.count() > 0);
    QCOMPARE(changes.front().front().toModelIndex().row(), 1);
    QCOMPARE(document.undoStack()->count(), 1);
    QVERIFY(model.setData(model.index(1), u"fern"_s, Qt::EditRole));
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QVERIFY(document.file() == before);
    QCOMPARE(model.index(1).data().toString(), u"e2"_s);
}

void EntriesModelTest::refusesBadNames() {
    Document document;
    document.setFile(fileOfEntries(3));
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);
    QSignalSpy refused(&model, &EntriesModel::refused);
    QVERIFY(!model.setData(model.index(1), u"E3"_s, Qt::EditRole));
    QCOMPARE(refused.count(), 1);
    QVERIFY(refused.front().front().toString().contains(u"E3"_s));
    QCOMPARE(document.undoStack()->count(), 0);
}

void EntriesModelTest::saysWhatIsWrong() {
    FractalFile file = fileOfEntries(3);
    document::Fractal unreadable = *file.entries[1].fractal;
    unreadable.shape = std::monostate();
    file.entries[1].fractal = std::make_shared<const document::Fractal>(unreadable);
    file.entries[1].problems = {
        {document::Problem::Severity::Error, u"e2"_s, 12, 4, u"“<1/3>” is no number."_s}};
    file.entries[0].problems = {
        {document::Problem::Severity::Remark, u"e1"_s, 3, 7, u"The weights sum to 2."_s}};
    document::Fractal space = *file.entries[2].fractal;
    space.shape = document::Shape<3>();
    file.entries[2].fractal = std::make_shared<const document::Fractal>(space);
    Document document;
    document.setFile(file);
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);

    QVERIFY(!model.index(0).data(EntriesModel::SeverityRole).isValid()); // a remark is no problem
    QCOMPARE(model.index(1).data(EntriesModel::SeverityRole).toInt(),
             static_cast<int>(document::Problem::Severity::Error));
    const QString toolTip = model.index(1).data(Qt::ToolTipRole).toString();
    QVERIFY2(toolTip.contains(u"12"_s) && toolTip.contains(u"“&lt;1/3&gt;” is no number."_s),
             qPrintable(toolTip));
    QVERIFY(!(model.index(1).flags() & Qt::ItemIsEditable));
    QCOMPARE(model.index(1).data(EntriesModel::ThumbnailStateRole).toInt(),
             static_cast<int>(view::Thumbnail::State::Unreadable));
    QCOMPARE(model.index(2).data(EntriesModel::SubtitleRole).toString(), u"0 maps in space"_s);
    QVERIFY(model.index(2).flags() & Qt::ItemIsEditable);
}

// Views ask for the data of the current entry when a key copies it, and there may be none.
void EntriesModelTest::nothingIsCurrent() {
    Document document;
    Thumbnails thumbnails;
    const EntriesModel model(&document, &thumbnails);
    QTest::failOnWarning(QRegularExpression(QStringLiteral("checkindex")));
    QVERIFY(!model.data({}, Qt::DisplayRole).isValid());
}

void EntriesModelTest::modifiedMark() {
    Document document;
    document.setFile(fileOfEntries(3));
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);
    const auto marks = [&model] {
        QList<bool> result;
        for (int row = 0; row < model.rowCount(); ++row)
            result.append(model.index(row).data(EntriesModel::ModifiedRole).toBool());
        return result;
    };
    QCOMPARE(marks(), (QList<bool>{false, false, false}));
    model.setData(model.index(1), u"fern"_s, Qt::EditRole);
    QCOMPARE(marks(), (QList<bool>{false, true, false}));
    document.editFile(u"move"_s, document::moved(document.file(), {id(2)}, id(1)));
    QCOMPARE(marks(), (QList<bool>{true, false, false}));
    document.markSaved(document.file());
    QCOMPARE(marks(), (QList<bool>{false, false, false}));
    document.undoStack()->undo();
    document.undoStack()->undo();
    QCOMPARE(marks(), (QList<bool>{false, true, false}));
    document.undoStack()->redo();
    document.undoStack()->redo();
    QCOMPARE(marks(), (QList<bool>{false, false, false}));
}

void EntriesModelTest::liveEditsWait() {
    Document document;
    document.setFile(fileOfEntries(2));
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    document::EditGesture gesture = document.beginGesture(u"drag"_s);
    document::Fractal moved = document.fractal();
    document::system2(moved)->maps[0].map.translation.x() += 0.1;
    gesture.preview(moved);
    QCOMPARE(changes.count(), 0);
    gesture.commit();
    QVERIFY(changes.count() > 0);
    QVERIFY(model.index(0).data(EntriesModel::ModifiedRole).toBool());
}

void EntriesModelTest::longFileAsksOnlyForWhatIsSeen() {
    Document document;
    document.setFile(fileOfEntries(2000));
    Thumbnails thumbnails;
    EntriesModel model(&document, &thumbnails);
    QListView list;
    list.setUniformItemSizes(true);
    list.setGridSize({180, 50});
    list.setModel(&model);
    list.resize(200, 400);
    list.show();
    QVERIFY(QTest::qWaitForWindowExposed(&list));
    QTRY_COMPARE(thumbnails.pending(), 0);
    const std::uint64_t seen = 400 / 50 + 2;
    QVERIFY(thumbnails.drawn() > 0);
    QVERIFY2(thumbnails.drawn() <= 2 * seen, qPrintable(QString::number(thumbnails.drawn())));

    // Everything scrolled past in one go is not drawn.
    for (int row = 0; row < 2000; row += 7)
        list.scrollTo(model.index(row));
    list.scrollTo(model.index(1999));
    QTRY_COMPARE(thumbnails.pending(), 0);
    QVERIFY2(thumbnails.drawn() <= 5 * seen, qPrintable(QString::number(thumbnails.drawn())));
    QVERIFY(!model.index(1999).data(Qt::DecorationRole).value<QPixmap>().isNull());
}

void EntriesModelTest::pictureArrives() {
    Document document;
    document.setFile(fileOfEntries(2));
    Thumbnails thumbnails;
    thumbnails.setSize(40, 2);
    EntriesModel model(&document, &thumbnails);
    QVERIFY(model.index(1).data(Qt::DecorationRole).value<QPixmap>().isNull());
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    QVERIFY(changes.wait());
    QCOMPARE(changes.front().front().toModelIndex().row(), 1);
    const auto pixmap = model.index(1).data(Qt::DecorationRole).value<QPixmap>();
    QCOMPARE(pixmap.size(), QSize(80, 80));
    QCOMPARE(pixmap.devicePixelRatio(), 2.0);
    QCOMPARE(model.index(1).data(EntriesModel::ThumbnailStateRole).toInt(),
             static_cast<int>(view::Thumbnail::State::Ready));
}

BARYCAGE_TEST(EntriesModelTest, QApplication);
#include "entries_model_test.moc"
