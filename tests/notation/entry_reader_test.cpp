// SPDX-License-Identifier: MIT
#include "document/moments/animated_fractal.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "notation/entry_reader.h"
#include "notation/entry_writer.h"
#include "notation/moments/entry_moment.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QDirIterator>
#include <QFile>
#include <QTest>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <string_view>

// The reader and the writer without Qt, against those of the window.
class EntryReaderTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theWindowReadsTheSame();
    void theWindowReadsTheSameOfDamagedFiles();
    void theWindowWritesTheSame();
    void whatIsWrittenIsReadAgain();
    void spacesOfAnyKindEndAComment();
    void flawsSayWhere_data();
    void flawsSayWhere();
    void everythingThatIsStoredIsRead();
    void momentsAreThoseOfTheWindow();

private:
    QList<QPair<QString, QByteArray>> m_files;
};

namespace {

std::string_view viewOf(const QByteArray& bytes) {
    return {bytes.constData(), std::size_t(bytes.size())};
}

template <int Dim> QByteArray difference(const document::Shape<Dim>& shape, const notation::Entry& ours) {
    const auto& figure = std::get<notation::Figure<Dim>>(ours.figure);
    if (!(shape.system.maps == figure.system.maps)) return "maps";
    if (!(shape.system.symmetry == figure.system.symmetry)) return "symmetry";
    if (!(shape.system.links == figure.system.links)) return "links";
    if (!(shape.cage == figure.cage)) return "cage";
    if (!(shape.moved == figure.moved)) return "moved branches";
    if (!(shape.animation == notation::animationOf<Dim>(ours))) return "animation";
    return {};
}

// What the two readers do not agree on; empty where there is nothing.
QByteArray difference(const document::Entry& window, const notation::Entry& ours) {
    const document::Fractal& fractal = *window.fractal;
    if (fractal.name != QString::fromStdString(ours.name)) return "name";
    if (fractal.headerComment != QString::fromStdString(ours.headerComment)) return "header comment";
    QStringList comments;
    for (const std::string& comment : ours.comments)
        comments << QString::fromStdString(comment);
    if (fractal.comments != comments) return "comments";
    if (fractal.shape.index() != ours.figure.index()) return "dimension";
    if (const auto* plane = document::plane(fractal))
        if (const QByteArray what = difference<2>(*plane, ours); !what.isEmpty()) return what;
    if (const auto* space = document::space(fractal))
        if (const QByteArray what = difference<3>(*space, ours); !what.isEmpty()) return what;
    if (document::dimension(fractal) != 0)
        return fractal.appearance == ours.appearance ? QByteArray() : QByteArray("appearance");
    const auto error =
        std::ranges::find(window.problems, document::Problem::Severity::Error, &document::Problem::severity);
    const bool isSamePlace = error != window.problems.end() && ours.flaw && error->line == ours.flaw->line &&
                             error->column == ours.flaw->column;
    return isSamePlace ? QByteArray() : QByteArray("place of the error");
}

// Files that are no collections have no entries for the window, which says what they are instead.
QByteArray difference(const QByteArray& bytes, int& entries) {
    const document::FractalFile window = io::readFractint(bytes);
    const notation::File ours = notation::readFile(viewOf(bytes));
    if (window.entries.isEmpty()) return {};
    if (std::size_t(window.entries.size()) != ours.entries.size()) return "number of entries";
    for (qsizetype i = 0; i < window.entries.size(); ++i, ++entries)
        if (const QByteArray what = difference(window.entries[i], ours.entries[std::size_t(i)]);
            !what.isEmpty())
            return what + " of “" + window.entries[i].fractal->name.toUtf8() + "”";
    return {};
}

} // namespace

void EntryReaderTest::initTestCase() {
    for (const QString& folder : {support::sourcePath(QStringLiteral("ifs_library")), support::testData(),
                                  qEnvironmentVariable("BARYCAGE_CORPUS")}) {
        if (folder.isEmpty()) continue;
        QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (file.size() < 20'000'000 && file.open(QIODevice::ReadOnly))
                m_files.append({file.fileName(), file.readAll()});
        }
    }
    QVERIFY(m_files.size() > 20);
}

void EntryReaderTest::theWindowReadsTheSame() {
    int entries = 0;
    for (const auto& [name, bytes] : m_files) {
        const QByteArray what = difference(bytes, entries);
        QVERIFY2(what.isEmpty(), name.toUtf8() + ": " + what);
    }
    QVERIFY2(entries > 200, QByteArray::number(entries));
}

// Bytes are changed, left out and put elsewhere: both readers take it in the same way.
void EntryReaderTest::theWindowReadsTheSameOfDamagedFiles() {
    constexpr std::string_view usual = "0123456789.-+eE{};:,'()#\n\r\t ^abcdxyz/*\\\0\x1a\xe2\x88\x92";
    std::mt19937 random(1);
    const auto below = [&](qsizetype n) { return qsizetype(random() % std::uint32_t(n)); };
    int entries = 0;
    for (const auto& [name, whole] : m_files) {
        if (whole.isEmpty() || whole.size() > 100'000) continue;
        for (int round = 0; round < 20; ++round) {
            const qsizetype begin = below(whole.size());
            QByteArray bytes = whole.mid(round % 2 == 0 ? 0 : begin, 1 + below(3000));
            for (int i = 0; i < 4; ++i)
                bytes[below(bytes.size())] = usual[std::size_t(below(qsizetype(usual.size())))];
            const QByteArray what = difference(bytes, entries);
            QVERIFY2(what.isEmpty(), name.toUtf8() + ": " + what + " in:\n" + bytes);
        }
    }
    QVERIFY2(entries > 500, QByteArray::number(entries));
}

void EntryReaderTest::theWindowWritesTheSame() {
    int written = 0;
    for (const auto& [name, bytes] : m_files) {
        const document::FractalFile window = io::readFractint(bytes);
        const notation::File ours = notation::readFile(viewOf(bytes));
        for (qsizetype i = 0; i < window.entries.size(); ++i) {
            const notation::Entry& each = ours.entries[std::size_t(i)];
            if (!each.otherLines.empty() || each.flaw) continue;
            ++written;
            const QByteArray text = QByteArray::fromStdString(notation::written(each));
            const QByteArray expected = io::writeEntry(*window.entries[i].fractal);
            QVERIFY2(text == expected, name.toUtf8() + ":\n" + text + "instead of\n" + expected);
        }
    }
    QVERIFY2(written > 200, QByteArray::number(written));
}

void EntryReaderTest::whatIsWrittenIsReadAgain() {
    int read = 0;
    for (const auto& [name, bytes] : m_files)
        for (const notation::Entry& each : notation::readFile(viewOf(bytes)).entries) {
            if (each.flaw) continue;
            const std::string text = notation::written(each);
            const notation::File again = notation::readFile(text);
            QCOMPARE(again.entries.size(), 1U);
            // What is spelt differently is so once.
            QCOMPARE(notation::written(again.entries[0]), text);
            QVERIFY2(again.entries[0].figure.index() == each.figure.index(),
                     name.toUtf8() + ": " + text.c_str());
            ++read;
        }
    QVERIFY(read > 200);
}

void EntryReaderTest::spacesOfAnyKindEndAComment() {
    const QByteArray text = "a { ; of a file\xc2\x85\n; \xe3\x80\x80two \xc2\xa0\n .5 0 0 .5 0 0 1\n}\n";
    const std::string written = notation::written(notation::readFile(viewOf(text)).entries[0]);
    QCOMPARE(QByteArray::fromStdString(written), io::writeEntry(*io::readFractint(text).entries[0].fractal));
    QVERIFY(written.starts_with("a { ; of a file\n  ; two\n"));
}

void EntryReaderTest::flawsSayWhere_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    QTest::addColumn<QByteArray>("sentence");
    QTest::newRow("a word") << QByteArray("a {\n1 0 0 1 0 0 .5\n1 0 x 1 0 0 .5\n}\n") << 3 << 5
                            << QByteArray("“x” is not a number.");
    QTest::newRow("an expression") << QByteArray("a {\n\t1/3 0 0 1 0 0 1\n}") << 2 << 2
                                   << QByteArray(
                                          "“1/3” is not a plain number. Write it as one decimal number.");
    QTest::newRow("infinite") << QByteArray("a { }\n\nb {\ninf 0 0 1 0 0 1\n}") << 1 << 3
                              << QByteArray("The entry contains no numbers.");
    QTest::newRow("unclosed") << QByteArray("one { .5 0 0 .5 0 0 1") << 1 << 5
                              << QByteArray("The entry that starts here has no closing “}” before the next "
                                            "entry or the end of the file.");
    QTest::newRow("too few") << QByteArray("a {\n.5 0 0 .5 0 0 1\n.5 0 0\n}") << 3 << 1
                             << QByteArray("Numbers are missing or left over: this line has 3, the entry has "
                                           "10, and each map has 7.");
}

void EntryReaderTest::flawsSayWhere() {
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(int, column);
    QFETCH(QByteArray, sentence);
    const notation::File file = notation::readFile(viewOf(text));
    QVERIFY(!file.entries.empty());
    QVERIFY(file.entries[0].flaw.has_value());
    QCOMPARE(QByteArray::fromStdString(file.entries[0].flaw->sentence), sentence);
    QCOMPARE(file.entries[0].flaw->line, line);
    QCOMPARE(file.entries[0].flaw->column, column);
}

// Each kind of line that the reader knows, in one entry: against the window, and not left to chance.
void EntryReaderTest::everythingThatIsStoredIsRead() {
    const QByteArray text = "maple { ; of a tree\n  ; the first comment\n"
                            "; barycage: version 1\n"
                            "; barycage: rest 0 0\n; barycage: rest 1 \\\n; barycage: rest 0\n"
                            "; barycage: rest 1 1\n; barycage: rest 0 1\n"
                            "; barycage: current 0 0.25\n; barycage: current 2 0\n"
                            "; barycage: current 1 1\n; barycage: current 0 1\n"
                            "; barycage: deformation affine-fit\n"
                            "; barycage: branch 1 2\n; barycage: by 1 0\n; barycage: by 0 1\n"
                            "; barycage: by 0.5 0\n"
                            "; barycage: branch 0 2\n; barycage: by 0.5 0\n; barycage: by 0 0.5\n"
                            "; barycage: by 0 0.125\n"
                            "; barycage: symmetry d3:30\n; barycage: symmetry-centre 0.5 0.25\n"
                            "; barycage: colour-by map\n; barycage: palette two colours\n"
                            "; barycage: stop 0 #000000ff\n; barycage: stop 1 #ff8040ff\n"
                            "; barycage: plain #010203ff\n; barycage: gamma 1.5\n; barycage: supersample 2\n"
                            "; barycage: off 3 0.25\n; barycage: map-colour 2 #AABBCCff\n"
                            "; barycage: map-blend 1 0.5 0.25\n"
                            "; barycage: links 1 1 0 2\n"
                            "; barycage: exact 1 a 1/3\n; barycage: exact 2 e sqrt(3)/6\n"
                            "; barycage: exact 2 d cos(36°)\n"
                            "; barycage: map-name 1 stem\n"
                            "  0.3333333333333333 0 0 .5 0 0 .5\n"
                            "  .5 0 0 0.8090169943749475 0.28867513459481287 0 .5\n  .5 0 0 .5 0 .5 0\n}\n";
    int entries = 0;
    QCOMPARE(difference(text, entries), QByteArray());
    QCOMPARE(entries, 1);
    const notation::Entry read = notation::readFile(viewOf(text)).entries[0];
    const auto& figure = std::get<notation::Figure<2>>(read.figure);
    QVERIFY(figure.cage.has_value());
    QCOMPARE(figure.cage->deformation, ifs::Deformation::AffineFit);
    QCOMPARE(figure.moved.size(), 2U);
    QCOMPARE(figure.system.symmetry.group, ifs::SymmetryGroup::Dihedral);
    QCOMPARE(figure.system.links.size(), 2U);
    QVERIFY(!figure.system.maps[2].enabled);
    QVERIFY(figure.system.maps[0].typed.of(0, figure.system.maps[0].map) != nullptr);
    QVERIFY(figure.system.maps[1].typed.of(3, figure.system.maps[1].map) != nullptr);
    QVERIFY(figure.system.maps[1].typed.of(4, figure.system.maps[1].map) != nullptr);
    QCOMPARE(read.appearance.palette.stops.size(), 2U);
    QCOMPARE(read.otherLines, std::vector<std::string>{"barycage: map-name 1 stem"});
    QCOMPARE(notation::readFile(notation::written(read)).entries[0], read);
}

// Maps, cages, branches and colours, to the last bit.
void EntryReaderTest::momentsAreThoseOfTheWindow() {
    int moments = 0;
    for (const auto& [name, text] : m_files) {
        const document::FractalFile window = io::readFractint(text);
        const notation::File ours = notation::readFile(viewOf(text));
        for (qsizetype i = 0; i < window.entries.size(); ++i) {
            const notation::Entry& entry = ours.entries[std::size_t(i)];
            const document::Fractal& fractal = *window.entries[i].fractal;
            const auto facts = document::animationFacts(fractal);
            for (int k = 0; facts && k <= 8; ++k, ++moments) {
                const animation::Moment moment = animation::moment(std::int64_t(k) * facts->length, 8);
                document::Entry shown = window.entries[i];
                shown.fractal =
                    std::make_shared<document::Fractal>(document::frameAt(fractal, moment).fractal);
                const QByteArray said = difference(shown, notation::atMoment(entry, moment));
                QVERIFY2(said.isEmpty(), name.toUtf8() + ", " + fractal.name.toUtf8() + ": " + said);
            }
        }
    }
    QVERIFY(moments >= 9 * 15);
}

BARYCAGE_TEST(EntryReaderTest);
#include "entry_reader_test.moc"
