// SPDX-License-Identifier: MIT
#include "document/edits/entries_edits.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace Qt::StringLiterals;
using document::Entry;
using document::EntryId;
using document::FractalFile;

namespace {

EntryId id(int number) {
    return static_cast<EntryId>(number);
}

Entry readEntry(int number, const QByteArray& before = "\n") {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.name = u"e%1"_s.arg(number);
    auto source = std::make_shared<document::EntrySource>();
    source->before = before;
    source->text = "e" + QByteArray::number(number) + " { }\n";
    source->fractal = fractal;
    return {id(number), std::make_shared<const document::Fractal>(fractal), source, {}};
}

FractalFile fileOfEntries(int count) {
    FractalFile file;
    for (int number = 1; number <= count; ++number)
        file.entries.append(
            readEntry(number, number == 1 ? "; head\n" : "\n; above " + QByteArray::number(number)));
    file.tail = "\x1a";
    return file;
}

QStringList names(const FractalFile& file) {
    QStringList result;
    for (const Entry& entry : file.entries)
        result.append(entry.fractal->name);
    return result;
}

QByteArray bytes(const FractalFile& file) {
    QByteArray result;
    for (const Entry& entry : file.entries)
        result += entry.source ? entry.source->before + entry.source->text : QByteArray("new;");
    return result + file.tail;
}

QByteArray sorted(QByteArray text) {
    std::sort(text.begin(), text.end());
    return text;
}

} // namespace

class EntriesEditsTest : public QObject {
    Q_OBJECT

private slots:
    void insertedBehind();
    void insertedAtEnd();
    void insertedNamesAreUnique();
    void aHundredThousandAreInserted();
    void unreadableKeepsItsSource();
    void removedKeepsTheHeadOfTheFile();
    void removedLastKeepsTheHeadOfTheFile();
    void movedAgainstNaiveOrder();
    void movedKeepsEveryByte();
    void replacedTouchesOneEntry();
    void nameProblems_data();
    void nameProblems();
    void everyUniqueNameIsPossible();
    void savedFilesReadBack();
};

void EntriesEditsTest::insertedBehind() {
    const FractalFile before = fileOfEntries(3);
    const auto result = document::inserted(before, {readEntry(1), readEntry(77)}, id(2));
    QCOMPARE(names(result.file), (QStringList{u"e1"_s, u"e2"_s, u"e1_2"_s, u"e77"_s, u"e3"_s}));
    QCOMPARE(result.ids.size(), 2);
    QCOMPARE(result.file.entries[2].id, result.ids[0]);
    QCOMPARE(result.file.entries[3].id, result.ids[1]);
    QVERIFY(result.ids[0] != result.ids[1]);
    for (const Entry& entry : before.entries)
        QVERIFY(!result.ids.contains(entry.id));
}

void EntriesEditsTest::insertedAtEnd() {
    const auto result = document::inserted(fileOfEntries(2), {readEntry(9)}, EntryId::None);
    QCOMPARE(names(result.file), (QStringList{u"e1"_s, u"e2"_s, u"e9"_s}));
    QCOMPARE(document::inserted(FractalFile(), {readEntry(9)}, id(4)).file.entries.size(), 1);
}

void EntriesEditsTest::aHundredThousandAreInserted() {
    constexpr int count = 100'000;
    const QList<Entry> many(count, readEntry(1));
    auto result = document::inserted(fileOfEntries(3), many, id(1));
    QCOMPARE(result.file.entries.size(), count + 3);
    QCOMPARE(result.file.entries[count].fractal->name, u"e1_%1"_s.arg(count + 1));
    QCOMPARE(document::removed(std::move(result.file), result.ids).entries.size(), 3);
}

void EntriesEditsTest::insertedNamesAreUnique() {
    QList<Entry> many(50, readEntry(1));
    const auto result = document::inserted(fileOfEntries(1), many, EntryId::None);
    QStringList lower;
    for (const QString& name : names(result.file))
        lower.append(name.toLower());
    lower.removeDuplicates();
    QCOMPARE(lower.size(), 51);
}

void EntriesEditsTest::unreadableKeepsItsSource() {
    Entry broken = readEntry(1);
    document::Fractal fractal = *broken.fractal;
    fractal.shape = std::monostate();
    broken.fractal = std::make_shared<const document::Fractal>(fractal);
    const auto result = document::inserted(fileOfEntries(2), {broken}, id(1));
    QCOMPARE(result.file.entries[1].source->text, QByteArray("e1 { }\n"));
    QCOMPARE(result.file.entries[1].fractal->name, u"e1"_s);
}

void EntriesEditsTest::removedKeepsTheHeadOfTheFile() {
    const FractalFile after = document::removed(fileOfEntries(4), {id(1), id(3)});
    QCOMPARE(names(after), (QStringList{u"e2"_s, u"e4"_s}));
    QCOMPARE(bytes(after), QByteArray("; head\n\n; above 2e2 { }\n\n; above 4e4 { }\n\x1a"));
}

void EntriesEditsTest::removedLastKeepsTheHeadOfTheFile() {
    const FractalFile after = document::removed(fileOfEntries(2), {id(2), id(1)});
    QVERIFY(after.entries.isEmpty());
    QCOMPARE(after.tail, QByteArray("; head\n\x1a"));
}

void EntriesEditsTest::movedAgainstNaiveOrder() {
    std::mt19937 random(20);
    for (int round = 0; round < 500; ++round) {
        const int count = 1 + static_cast<int>(random() % 9);
        const FractalFile before = fileOfEntries(count);
        QList<EntryId> ids;
        for (int number = count; number >= 1; --number)
            if (random() % 2) ids.append(id(number));
        const int place = static_cast<int>(random() % (count + 1)); // in front of this one, or at the end

        QStringList expected;
        for (int number = 1; number <= place; ++number)
            if (!ids.contains(id(number))) expected.append(u"e%1"_s.arg(number));
        for (int number = 1; number <= count; ++number)
            if (ids.contains(id(number))) expected.append(u"e%1"_s.arg(number));
        for (int number = place + 1; number <= count; ++number)
            if (!ids.contains(id(number))) expected.append(u"e%1"_s.arg(number));

        QCOMPARE(names(document::moved(before, ids, place == count ? EntryId::None : id(place + 1))),
                 expected);
    }
}

void EntriesEditsTest::movedKeepsEveryByte() {
    std::mt19937 random(21);
    FractalFile file = fileOfEntries(8);
    const QByteArray original = sorted(bytes(file));
    for (int round = 0; round < 200; ++round) {
        const QList<EntryId> ids{id(1 + static_cast<int>(random() % 8)),
                                 id(1 + static_cast<int>(random() % 8))};
        file = document::moved(file, ids, id(static_cast<int>(random() % 9)));
        QCOMPARE(sorted(bytes(file)), original);
        QVERIFY(bytes(file).startsWith("; head\n"));
        for (const Entry& entry : file.entries)
            QCOMPARE(entry.source->text, readEntry(static_cast<int>(entry.id)).source->text);
    }
}

void EntriesEditsTest::replacedTouchesOneEntry() {
    const FractalFile before = fileOfEntries(3);
    document::Fractal other = *before.entries[1].fractal;
    other.comments = QStringList{u"new"_s};
    const FractalFile after = document::replaced(before, id(2), other);
    QCOMPARE(after.entries[0].fractal, before.entries[0].fractal);
    QCOMPARE(after.entries[2].fractal, before.entries[2].fractal);
    QCOMPARE(*after.entries[1].fractal, other);
    QCOMPARE(after.entries[1].source, before.entries[1].source);
}

void EntriesEditsTest::nameProblems_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("says"); // part of the sentence; empty: the name is possible
    QTest::newRow("plain") << u"fern"_s << u""_s;
    QTest::newRow("its own") << u"E2"_s << u""_s;
    QTest::newRow("odd but legal") << u"!?&'^_9"_s << u""_s;
    QTest::newRow("not ASCII") << u"fougère"_s << u""_s;
    QTest::newRow("18 bytes") << u"abcdefghijklmnopqr"_s << u""_s;
    QTest::newRow("19 bytes") << u"abcdefghijklmnopqrs"_s << u"18"_s;
    QTest::newRow("18 letters, 19 bytes") << u"abcdefghijklmnopqé"_s << u"18"_s;
    QTest::newRow("empty") << u""_s << u"needs a name"_s;
    QTest::newRow("blank") << u"my fern"_s << u"spaces"_s;
    QTest::newRow("tab") << u"my\tfern"_s << u"spaces"_s;
    QTest::newRow("parenthesis") << u"fern(3D)"_s << u"“(”"_s;
    QTest::newRow("semicolon") << u"a;b"_s << u"“;”"_s;
    QTest::newRow("brace") << u"a{"_s << u"“{”"_s;
    QTest::newRow("closing brace") << u"a}"_s << u"“}”"_s;
    QTest::newRow("prefix") << u"ifs:fern"_s << u"“:”"_s;
    QTest::newRow("comment") << u"Comment"_s << u"not list"_s;
    QTest::newRow("taken") << u"e3"_s << u"Another entry"_s;
    QTest::newRow("taken in other case") << u"E3"_s << u"Another entry"_s;
}

void EntriesEditsTest::nameProblems() {
    QFETCH(QString, name);
    QFETCH(QString, says);
    const auto problem = document::nameProblem(fileOfEntries(3), id(2), name);
    QCOMPARE(problem.has_value(), !says.isEmpty());
    if (problem)
        QVERIFY2(problem->contains(says) && problem->endsWith(QLatin1Char('.')), qPrintable(*problem));
}

// The two statements of the rules agree.
void EntriesEditsTest::everyUniqueNameIsPossible() {
    std::mt19937 random(22);
    const QString letters = u"aB9_ (){};:é.e1"_s;
    const FractalFile file = fileOfEntries(5);
    for (int round = 0; round < 2000; ++round) {
        QString name;
        for (auto length = random() % 24; length > 0; --length)
            name += letters[static_cast<qsizetype>(random() % letters.size())];
        const QString unique = document::uniqueName(file, name);
        QVERIFY2(!document::nameProblem(file, EntryId::None, unique), qPrintable(unique));
        if (!document::nameProblem(file, EntryId::None, name)) QCOMPARE(unique, name);
    }
}

// After any edits of the list, the saved file contains exactly these entries in this order, each unchanged.
void EntriesEditsTest::savedFilesReadBack() {
    const QByteArray text = "; The head of the file.\n\n"
                            "one { ; first\n  .5 0 0 .5 0 0 .5 ; left\n  .5 0 0 .5 .5 0 .5\n}\n"
                            "; about two\ntwo {\n  0.50 0 0 .5 0 0 .5\n  .5 0 0 .5 0 .5 .5 }\n\n"
                            "bad {\n  one two\n}\n"
                            "last {\n  .25 0 0 .25 0 0 1\n}";
    Entry made = readEntry(1);
    made.source.reset();
    std::mt19937 random(23);
    for (int round = 0; round < 300; ++round) {
        FractalFile file = io::readFractint(text);
        QCOMPARE(file.entries.size(), 4);
        for (auto edits = random() % 5; edits > 0 && !file.entries.isEmpty(); --edits) {
            const auto any = [&] {
                return file.entries[static_cast<qsizetype>(random() % file.entries.size())].id;
            };
            switch (random() % 4) {
            case 0:
                file = document::removed(file, {any()});
                break;
            case 1:
                file = document::inserted(file, {made}, any()).file;
                break;
            default:
                file = document::moved(file, {any(), any()}, random() % 4 ? any() : EntryId::None);
                break;
            }
        }
        const QByteArray written = io::writeFractint(file);
        const FractalFile back = io::readFractint(written);
        QVERIFY2(names(back) == names(file), written.constData());
        QVERIFY2(written.contains("; The head of the file."), written.constData());
        for (qsizetype i = 0; i < file.entries.size(); ++i)
            QVERIFY2(document::isSameSystem(*back.entries[i].fractal, *file.entries[i].fractal),
                     written.constData());
    }
}

BARYCAGE_TEST(EntriesEditsTest);
#include "entries_edits_test.moc"
