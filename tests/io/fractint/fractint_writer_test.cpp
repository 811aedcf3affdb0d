// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "ifs/system/branch.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_rows.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"
#include "support/fractint_bytes.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QDir>
#include <QRandomGenerator>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>

using document::Entry;
using document::EntryId;
using document::Fractal;
using document::FractalFile;

namespace {

using Edit = std::function<void(Fractal&)>;

FractalFile edited(FractalFile file, qsizetype index, const Edit& edit) {
    Fractal fractal = *file.entries[index].fractal;
    edit(fractal);
    file.entries[index].fractal = std::make_shared<const Fractal>(std::move(fractal));
    return file;
}

QByteArray afterEdit(const QByteArray& bytes, const Edit& edit) {
    return io::writeFractint(edited(io::readFractint(bytes), 0, edit));
}

std::vector<ifs::WeightedMap<2>>& maps(Fractal& fractal) {
    return document::system2(fractal)->maps;
}

ifs::WeightedMap<2> newMap(Fractal& fractal, double a, std::optional<double> weight) {
    ifs::WeightedMap<2> map;
    map.id = ifs::freshId(*document::system2(fractal));
    map.map = ifs::affineMap(a, 0, 0, a, 0, 0);
    map.weight = weight;
    return map;
}

QByteArray contents(const QString& name) {
    QFile file(support::testData(name));
    if (!file.open(QIODevice::ReadOnly)) qFatal("%s is missing", qPrintable(name));
    return file.readAll();
}

} // namespace

class FractintWriterTest : public QObject {
    Q_OBJECT

private slots:
    void editsTouchOnlyWhatChanged_data();
    void editsTouchOnlyWhatChanged();
    void entriesMoveWithTheirBytes();
    void newEntriesGoBeforeTheTail();
    void bareFileGetsBracesWhenItMust();
    void bareFileIsCalledAsItsFile();
    void newEntryReadsBack();
    void ownLinesAreShort();
    void branchesThatDoNotFitAreTold();
    void cagesInSpaceComeBack();
    void cagesOfTheOtherDimensionStay_data();
    void cagesOfTheOtherDimensionStay();
    void unreadableEntriesKeepTheirCage();
    void ownLinesGoWhenEverythingIsStandard();
    void oneMissingWeightIsTheSameForAllPrograms();
    void dataFilesKeepTheirBytes();
    void randomEditsKeepTheRest();
    void aShorterTextIsStillACollection_data();
    void aShorterTextIsStillACollection();
    void namesAreNoFormats();
    void bareRowsEndInAComment();

private:
    void editAtRandom(Fractal& fractal, QRandomGenerator& random);
};

void FractintWriterTest::editsTouchOnlyWhatChanged_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char* name, const QByteArray& before, const Edit& edit,
                        const QByteArray& after) { QTest::newRow(name) << before << edit << after; };
    const QByteArray head = "; title\n\nfern { ; a fern\n ; of Barnsley\n";
    const QByteArray text =
        head + "  .50  0.0 0  +.5e0 0 0\t.25 ; stem\n; leaf\n  .5 0 0 .5 .5 0 .75\r\n} ; end\n\x1a";
    const Edit number = [](Fractal& f) { maps(f)[0].map.linear(0, 1) = -0.125; };
    row("a number", text, number, QByteArray(text).replace("0.0 ", "-0.125 "));
    row(
        "a weight", text, [](Fractal& f) { maps(f)[1].weight = 0.5; },
        QByteArray(text).replace(".75", "0.5"));
    row(
        "the name", text, [](Fractal& f) { f.name = QStringLiteral("tree"); },
        QByteArray(text).replace("fern {", "tree {"));
    row(
        "the header comment", text, [](Fractal& f) { f.headerComment = QStringLiteral("X"); },
        QByteArray(text).replace("; a fern", "; X"));
    row(
        "no header comment", text, [](Fractal& f) { f.headerComment.clear(); },
        QByteArray(text).replace(" ; a fern", ""));
    row(
        "a comment", text, [](Fractal& f) { f.comments[1] = QStringLiteral("leaves"); },
        QByteArray(text).replace("; leaf", "; leaves"));
    row(
        "a comment less", text, [](Fractal& f) { f.comments.removeFirst(); },
        QByteArray(text).replace(" ; of Barnsley\n", ""));
    row(
        "a comment more", text, [](Fractal& f) { f.comments.insert(1, QStringLiteral("new")); },
        QByteArray(text).replace("Barnsley\n", "Barnsley\n  ; new\n"));
    row(
        "a map less", text, [](Fractal& f) { maps(f).erase(maps(f).begin()); },
        QByteArray(text).replace("  .50  0.0 0  +.5e0 0 0\t.25 ; stem\n", ""));
    row(
        "a map between", text, [](Fractal& f) { maps(f).insert(maps(f).begin() + 1, newMap(f, 0.1, 0.2)); },
        QByteArray(text).replace("stem\n", "stem\n  0.1 0 0 0.1 0 0 0.2\n"));
    row(
        "a map in front", text, [](Fractal& f) { maps(f).insert(maps(f).begin(), newMap(f, 0.1, 0.2)); },
        QByteArray(text).replace("  .50 ", "  0.1 0 0 0.1 0 0 0.2\n  .50 "));
    row(
        "maps change places", text, [](Fractal& f) { std::swap(maps(f)[0], maps(f)[1]); },
        head + "  .5 0 0 .5 .5 0 .75\r\n; leaf\n  .50  0.0 0  +.5e0 0 0\t.25 ; stem\n} ; end\n\x1a");
    row(
        "a map off", text, [](Fractal& f) { maps(f)[0].enabled = false; },
        QByteArray(text)
            .replace(".25 ;", "0 ;")
            .replace("a fern\n", "a fern\n; barycage: version 1\n; barycage: off 1 0.25\n"));
    row(
        "all maps exchanged", "a {\n\t.5 0 0 .5 0 0 1 ; x\n}\n",
        [](Fractal& f) { maps(f) = {newMap(f, 0.1, 1)}; }, "a {\n\t0.1 0 0 0.1 0 0 1\n}\n");
    row("commas stay", "a {\n.5,0,0,.5,0,0,1\n}\n", number, "a {\n.5,-0.125,0,.5,0,0,1\n}\n");
    row("decimal commas stay", "a {\n0,5 0,0 0 0,5 0 0 1\n}\n", number, "a {\n0,5 -0,125 0 0,5 0 0 1\n}\n");
    row(
        "decimal commas, a whole number", "a {\n0,5 0,3 0 0,5 0 0 1\n}\n",
        [](Fractal& f) { maps(f)[0].map.linear(0, 1) = 2; }, "a {\n0,5 2,0 0 0,5 0 0 1\n}\n");
    row("a glued brace stays", "a {\n.5 0 0 .5 0 0 1}\n", number, "a {\n.5 -0.125 0 .5 0 0 1}\n");
    row(
        "a map after a glued brace", "a {\n.5 0 0 .5 0 0 1}\n",
        [](Fractal& f) { maps(f).push_back(newMap(f, 0.1, 1)); },
        "a {\n.5 0 0 .5 0 0 1\n0.1 0 0 0.1 0 0 1}\n");
    row(
        "two maps on a line", "a {\n.5 0 0 .5 0 0 1  .2 0 0 .2 0 0 1\n}\n",
        [](Fractal& f) { maps(f).erase(maps(f).begin()); }, "a {\n.2 0 0 .2 0 0 1\n}\n");
    row("on one line", "a { .5 0 0 .5 0 0 1 }\n", number, "a { .5 -0.125 0 .5 0 0 1 }\n");
    row(
        "a comment in one line", "a { .5 0 0 .5 0 0 1 }\n",
        [](Fractal& f) { f.headerComment = QStringLiteral("c"); }, "a { .5 0 0 .5 0 0 1 ; c\n }\n");
    row("six numbers stay six", "a {\n.5 0 0 .5 0 0\n}\n", number, "a {\n.5 -0.125 0 .5 0 0\n}\n");
    row(
        "six numbers get weights", "a {\n.5 0 0 .5 0 0\n}\n", [](Fractal& f) { maps(f)[0].weight = 1; },
        "a {\n.5 0 0 .5 0 0 1\n}\n");
    row(
        "Latin-1 stays Latin-1", "a { ; \xe9t\xe9\n.5 0 0 .5 0 0 1\n}\n",
        [](Fractal& f) { f.headerComment = QString::fromUtf8("à"); }, "a { ; \xe0\n.5 0 0 .5 0 0 1\n}\n");
    row(
        "a prefix stays", "IFS:a {\n.5 0 0 .5 0 0 1\n}\n", [](Fractal& f) { f.name = QStringLiteral("b"); },
        "IFS:b {\n.5 0 0 .5 0 0 1\n}\n");
    row(
        "unknown lines of ours stay", "a {\n; barycage: sparkle 7\n; barycage: gamma 3\n.5 0 0 .5 0 0 1\n}\n",
        [](Fractal& f) { f.appearance.gamma = 4; },
        "a {\n; barycage: sparkle 7\n; barycage: version 1\n; barycage: gamma 4\n.5 0 0 .5 0 0 1\n}\n");
    row(
        "a broken entry is renamed", "a {\nc .5 0 0\n}\n", [](Fractal& f) { f.name = QStringLiteral("b"); },
        "b {\nc .5 0 0\n}\n");
    row(
        "CR-only line ends", "a {\r.5 0 0 .5 0 0 1\r}\r",
        [](Fractal& f) { maps(f).push_back(newMap(f, 0.1, 1)); },
        "a {\r.5 0 0 .5 0 0 1\r0.1 0 0 0.1 0 0 1\r}\r");
    row(
        "CRLF", "a {\r\n.5 0 0 .5 0 0 1\r\n}\r\n", [](Fractal& f) { maps(f).push_back(newMap(f, 0.1, 1)); },
        "a {\r\n.5 0 0 .5 0 0 1\r\n0.1 0 0 0.1 0 0 1\r\n}\r\n");
    row("a bare file stays bare", ".5 0 0 .5 0 0 1\n", number, ".5 -0.125 0 .5 0 0 1\n");
    row(
        "3D", "a (3D) {\n1 0 0 0 1 0 0 0 1 0 0 0 1\n}\n",
        [](Fractal& f) { document::system3(f)->maps[0].map.translation[2] = 7; },
        "a (3D) {\n1 0 0 0 1 0 0 0 1 0 0 7 1\n}\n");
}

void FractintWriterTest::editsTouchOnlyWhatChanged() {
    QFETCH(QByteArray, before);
    QFETCH(Edit, edit);
    QTEST(afterEdit(before, edit), "after");
}

void FractintWriterTest::entriesMoveWithTheirBytes() {
    const QByteArray a = "; of a\na { .5 0 0 .5 0 0 1 }\n";
    const QByteArray b = "\n; of b\nb {\n.5,0,0,.5,0,0,1\n} ; end";
    FractalFile file = io::readFractint("; title\n\n" + a + b);
    FractalFile swapped = file;
    swapped.entries.swapItemsAt(0, 1);
    QCOMPARE(io::writeFractint(swapped), "; title\n\n" + b + "\n" + a);
    FractalFile twice = file;
    twice.entries.append(file.entries[0]);
    QCOMPARE(io::writeFractint(twice), "; title\n\n" + a + b + "\n" + a);
    file.entries.removeFirst();
    QCOMPARE(io::writeFractint(file), "; title\n\n" + b);
}

void FractintWriterTest::newEntriesGoBeforeTheTail() {
    FractalFile file = io::readFractint("a {\r\n.5 0 0 .5 0 0 1\r\n}\r\n\x1a");
    Fractal fractal = document::sierpinskiTriangle();
    maps(fractal).resize(1);
    maps(fractal)[0].weight = 1;
    file.entries.append({document::freshId(file), std::make_shared<const Fractal>(fractal), nullptr, {}});
    const QByteArray bytes = io::writeFractint(file);
    QCOMPARE(
        bytes,
        QByteArray("a {\r\n.5 0 0 .5 0 0 1\r\n}\r\n\r\nsierpinski {\r\n  0.5 0 0 0.5 0 0 1\r\n}\r\n\x1a"));
    FractalFile open = io::readFractint("a {\n.5 0 0 .5 0 0 1\n} ; no line end");
    open.entries.append(file.entries.last());
    QVERIFY(io::writeFractint(open).contains("no line end\n\nsierpinski {"));
    QCOMPARE(io::readFractint(io::writeFractint(open)).entries.size(), 2);
}

void FractintWriterTest::bareFileIsCalledAsItsFile() {
    const QByteArray bare = ".5 0 0 .5 0 0 .5 ; first\n.5 0 0 .5 1 0 .5\n";
    const FractalFile file = io::readFractint(bare, QStringLiteral("old fern"));
    QCOMPARE(file.entries.first().fractal->name, QStringLiteral("old_fern"));
    QCOMPARE(io::writeFractint(file), bare); // the name is not in the file
    QCOMPARE(io::writeFractint(edited(file, 0, [](Fractal& f) { maps(f)[0].map.linear(0, 0) = 0.25; })),
             "0.25 0 0 .5 0 0 .5 ; first\n.5 0 0 .5 1 0 .5\n");
    QVERIFY(io::writeFractint(edited(file, 0, [](Fractal& f) {
                f.appearance.gamma = 3;
            })).startsWith("old_fern {\n"));
}

void FractintWriterTest::bareFileGetsBracesWhenItMust() {
    const QByteArray bare = ".5 0 0 .5 0 0 .5 ; first\n.5 0 0 .5 1 0 .5\n";
    QCOMPARE(afterEdit(bare, [](Fractal& f) { f.name = QStringLiteral("pair"); }), "pair {\n" + bare + "}\n");
    FractalFile file = io::readFractint(bare);
    file.entries.append({document::freshId(file),
                         std::make_shared<const Fractal>(document::sierpinskiTriangle()),
                         nullptr,
                         {}});
    const FractalFile reread = io::readFractint(io::writeFractint(file));
    QCOMPARE(reread.entries.size(), 2);
    QVERIFY(document::isSameSystem(*reread.entries[0].fractal, *file.entries[0].fractal));
}

void FractintWriterTest::newEntryReadsBack() {
    Fractal fractal = document::sierpinskiTriangle();
    fractal.name = QStringLiteral("my");
    fractal.headerComment = QStringLiteral("header; }");
    fractal.comments = QStringList{QStringLiteral("one"), QString(), QStringLiteral("{ } ;")};
    document::plane(fractal)->cage =
        ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0.1), ifs::Vector<2>(0, 1.0 / 3)});
    document::plane(fractal)->cage->current[2] = {1e-17, -1.7976931348623157e+300};
    fractal.appearance.colourBy = attractor::ColourBy::Address;
    fractal.appearance.palette = {"Dusk & dawn",
                                  {{0, {1, 2, 3, 255}}, {0.1, {4, 5, 6, 7}}, {1, {8, 9, 10, 255}}}};
    fractal.appearance.plain = {1, 2, 3, 4};
    fractal.appearance.background = {0, 0, 0, 0};
    fractal.appearance.brightness = 0.1;
    fractal.appearance.gamma = 1;
    fractal.appearance.supersample = 4;
    fractal.appearance.mapColours[maps(fractal)[2].id] = {200, 100, 50, 255};
    maps(fractal)[0].weight.reset();
    maps(fractal)[1].enabled = false;
    const FractalFile file = io::readFractint(io::writeEntry(fractal));
    QCOMPARE(file.entries.size(), 1);
    QCOMPARE(*file.entries[0].fractal, fractal);

    for (const auto& palette : attractor::builtInPalettes()) {
        fractal.appearance.palette = palette;
        QCOMPARE(*io::readFractint(io::writeEntry(fractal, "\r\n")).entries.value(0).fractal, fractal);
    }
    const auto id = [&](std::size_t place) { return maps(fractal)[place].id; };
    document::plane(fractal)->moved = {
        {{id(2), id(0)}, ifs::affineMap(1.0 / 3, -1e-17, 0.1, 2, -1e300, 5)},
        {std::vector<ifs::MapId>(40, id(1)), ifs::affineMap(0, 0, 0, 0, 0, 0)}};
    QCOMPARE(*io::readFractint(io::writeEntry(fractal)).entries.value(0).fractal, fractal);
    for (auto& map : maps(fractal))
        map.weight.reset();
    QCOMPARE(*io::readFractint(io::writeEntry(fractal)).entries.value(0).fractal, fractal);
    std::vector<ifs::Vector<2>> corners;
    for (int j = 0; j < 64; ++j)
        corners.emplace_back(std::cos(0.09 * j), std::sin(0.09 * j));
    for (const auto deformation : {ifs::Deformation::Bend, ifs::Deformation::AffineFit}) {
        document::plane(fractal)->cage = ifs::polygonAtRest<2>(corners);
        document::plane(fractal)->cage->current[7] = {2, 1};
        document::plane(fractal)->cage->deformation = deformation;
        QCOMPARE(*io::readFractint(io::writeEntry(fractal)).entries.value(0).fractal, fractal);
    }
}

void FractintWriterTest::ownLinesAreShort() {
    Fractal fractal = document::sierpinskiTriangle();
    const double longest = -1.2345678901234567e-300; // 23 bytes
    document::plane(fractal)->cage = ifs::ControlCage<2>{{{longest, longest}}, {{longest, longest}}};
    fractal.appearance.palette = {std::string(200, 'p'), {{longest, {}}}};
    maps(fractal)[0].enabled = false;
    maps(fractal)[0].weight = longest;
    document::plane(fractal)->moved = {
        {std::vector<ifs::MapId>(40, maps(fractal)[1].id),
         ifs::affineMap(longest, longest, longest, longest, longest, longest)}};
    QVERIFY(io::metadataComments(io::asStored(fractal)).size() > 5);
    for (const QByteArray& line : io::metadataComments(io::asStored(fractal)))
        QVERIFY2(line.size() < 70 && line.startsWith("; barycage: "), line.constData());
}

// Branches that do not fit the maps in the file are reported, and the rest are applied.
void FractintWriterTest::branchesThatDoNotFitAreTold() {
    const auto read = [](const QByteArray& lines) {
        return io::readFractint("a {\n.5 0 0 .5 0 0 1\n.5 0 0 .5 1 0 1\n" + lines + "}\n").entries.value(0);
    };
    const QByteArray by = "; barycage: by 1 0\n; barycage: by 0 1\n; barycage: by 2 3\n";
    const document::Entry good = read("; barycage: branch 2\n; barycage: branch 1\n" + by);
    QCOMPARE(document::plane(*good.fractal)->moved.size(), 1U);
    QCOMPARE(document::movedBranches(*good.fractal).front().word, (ifs::Word{1, 0}));
    QCOMPARE(document::plane(*good.fractal)->moved.front().change, ifs::affineMap(1, 0, 0, 1, 2, 3));
    const auto complaints = [](const document::Entry& entry) {
        return std::ranges::count_if(entry.problems, [](const document::Problem& problem) {
            return problem.message.contains(QStringLiteral("branch"));
        });
    };
    QCOMPARE(complaints(good), 0);
    const QByteArray branch = "; barycage: branch 2 1\n";
    for (const QByteArray& lines : {branch, "; barycage: branch 3\n" + by, branch + by + branch + by,
                                    branch + "; barycage: by 1 0\n"}) {
        const document::Entry bad = read(lines);
        QCOMPARE(complaints(bad), 1);
        QCOMPARE(document::plane(*bad.fractal)->moved.size(), lines.count("by") == 6 ? 1U : 0U);
    }
    for (const QByteArray& line : {QByteArray("; barycage: branch 0\n"), QByteArray("; barycage: branch x\n"),
                                   QByteArray("; barycage: by 1 0\n"), branch + "; barycage: by 1 nan\n"})
        QVERIFY(document::plane(*read(line).fractal)->moved.empty());
    // A map that is deleted takes the places of its branches with it, in the file.
    Fractal fractal = *good.fractal;
    maps(fractal).erase(maps(fractal).begin());
    QVERIFY(document::movedBranches(fractal).empty());
    QVERIFY(!io::writeEntry(fractal).contains("branch"));
}

void FractintWriterTest::cagesInSpaceComeBack() {
    Fractal fractal;
    fractal.name = QStringLiteral("solid");
    document::Shape<3> shape;
    const std::vector<ifs::Vector<3>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1. / 3}};
    for (const auto& corner : corners)
        ifs::append(shape.system, {ifs::Matrix<3>::Identity() / 2, corner / 2}, 0.25);
    shape.cage = ifs::ControlCage<3>{corners, corners};
    shape.cage->current[1] = {-1.2345678901234567e-300, 1e-17, 1. / 7};
    shape.moved = {{{shape.system.maps[2].id}, {ifs::Matrix<3>::Identity() * 2, {0, 0, -1. / 3}}}};
    fractal.shape = shape;
    const QByteArray bytes = io::writeEntry(fractal);
    const FractalFile file = io::readFractint(bytes);
    QCOMPARE(file.entries.size(), 1);
    QVERIFY(file.entries[0].problems.isEmpty());
    QCOMPARE(*file.entries[0].fractal, fractal);
    QCOMPARE(io::writeFractint(file), bytes);
    const FractalFile placed = edited(file, 0, [](Fractal& f) {
        document::space(f)->cage->current[0] = {1, 2, 3};
    });
    const QByteArray changed = io::writeFractint(placed);
    QCOMPARE(QByteArray(changed).replace("current 1 2 3", "current 0 0 0"), bytes);
    QCOMPARE(*io::readFractint(changed).entries[0].fractal, *placed.entries[0].fractal);
}

void FractintWriterTest::cagesOfTheOtherDimensionStay_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QByteArray>("rows");
    const QByteArray inThePlane = ".5 0 0 .5 0 0 .5\n.5 0 0 .5 1 0 .5\n";
    const QByteArray inSpace = ".5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n.5 0 0 0 .5 0 0 0 .5 1 0 0 .5\n";
    QByteArray flat, solid;
    for (const char* key : {"rest", "current"})
        for (const char* vertex : {"0 0", "1  0", "0 1"}) {
            flat += QByteArray(";  barycage: ") + key + ' ' + vertex + '\n';
            solid += QByteArray(";  barycage: ") + key + ' ' + vertex + " .5\n";
        }
    for (QByteArray* lines : {&flat, &solid})
        *lines += "; barycage: deformation affine-fit\n; barycage: branch 1\n";
    flat += "; barycage: by 1 0\n; barycage: by 0 1\n; barycage: by 2 3\n";
    solid += "; barycage: by 1 0 0\n; barycage: by 0 1 0\n; barycage: by 0 0 1\n; barycage: by 2 3 4\n";
    QTest::newRow("of the plane, in space") << QByteArray("a (3D)") << flat << inSpace;
    QTest::newRow("of space, in the plane") << QByteArray("a") << solid << inThePlane;
}

// They are no cage of the entry, and no edit takes their lines away.
void FractintWriterTest::cagesOfTheOtherDimensionStay() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, lines);
    QFETCH(QByteArray, rows);
    const QByteArray bytes = name + " {\n; barycage: gamma 3\n" + lines + rows + "}\n";
    const FractalFile file = io::readFractint(bytes);
    const Fractal& fractal = *file.entries[0].fractal;
    const auto* plane = document::plane(fractal);
    const auto* space = document::space(fractal);
    QVERIFY(plane ? !plane->cage && plane->moved.empty() : !space->cage && space->moved.empty());
    QCOMPARE(file.entries[0].problems.size(), 1);
    QVERIFY(file.entries[0].problems[0].severity == document::Problem::Severity::Warning);
    QCOMPARE(io::writeFractint(file), bytes);
    QCOMPARE(afterEdit(bytes, [](Fractal& f) { f.appearance.gamma = 4; }),
             name + " {\n; barycage: version 1\n; barycage: gamma 4\n" + lines + rows + "}\n");
    QCOMPARE(afterEdit(bytes, [](Fractal& f) { f.appearance = {}; }), name + " {\n" + lines + rows + "}\n");
}

void FractintWriterTest::unreadableEntriesKeepTheirCage() {
    const QByteArray body = " {\n; barycage: rest 0 0\n; barycage: rest 1 0\n; barycage: rest 0 1\n"
                            "; barycage: current 0 0\n; barycage: current 2 0\n; barycage: current 0 1\n"
                            "; barycage: branch 1\n; barycage: by 1 0\n; barycage: by 0 1\n"
                            "; barycage: by 2 3\n.5 0 0 .5 x 0 1\n}\n";
    const FractalFile file = io::readFractint("a" + body);
    QCOMPARE(document::dimension(*file.entries[0].fractal), 0);
    QCOMPARE(io::writeFractint(file), "a" + body);
    QCOMPARE(afterEdit("a" + body, [](Fractal& f) { f.name = QStringLiteral("b"); }), "b" + body);
}

void FractintWriterTest::ownLinesGoWhenEverythingIsStandard() {
    const QByteArray plain = "a {\n.5 0 0 .5 0 0 1\n}\n";
    QVERIFY(io::metadataComments(*io::readFractint(plain).entries[0].fractal).isEmpty());
    const QByteArray coloured = afterEdit(plain, [](Fractal& f) { f.appearance.gamma = 3; });
    QVERIFY(coloured.contains("; barycage: gamma 3\n"));
    QCOMPARE(afterEdit(coloured, [](Fractal& f) { f.appearance = {}; }), plain);
}

// Where a weight is missing, the determinant rule serves for all maps: its probabilities are in the rows,
// which is all that others read, and the weights that are given come back.
void FractintWriterTest::oneMissingWeightIsTheSameForAllPrograms() {
    Fractal fractal = document::sierpinskiTriangle();
    maps(fractal)[0].map.linear *= 0.5;
    maps(fractal)[0].weight = 0.25;
    maps(fractal)[1].weight.reset();
    maps(fractal)[2].weight = 7;
    const std::vector<double> probabilities = ifs::probabilities(*document::system2(fractal));
    const auto numbers = [](const QByteArray& text) {
        std::vector<double> weights;
        for (const QByteArray& line : text.split('\n'))
            if (line.startsWith(' ') && !line.contains(';'))
                weights.push_back(line.simplified().split(' ').last().toDouble());
        return weights;
    };
    const QByteArray written = io::writeEntry(fractal);
    QCOMPARE(numbers(written), probabilities);
    QVERIFY(
        written.contains("; barycage: weight 1 0.25\n; barycage: unweighted 2\n; barycage: weight 3 7\n"));
    QCOMPARE(*io::readFractint(written).entries.value(0).fractal, fractal);
    // A map that another program has switched off stays off.
    const QByteArray off =
        QByteArray(written).replace(io::fractint::numberText(probabilities[0]) + '\n', "0\n");
    QVERIFY(off != written);
    QCOMPARE(document::system2(*io::readFractint(off).entries.value(0).fractal)->maps[0].weight,
             std::optional(0.0));
    // Edits do the same, there and back.
    const QByteArray plain = "a {\n .25 0 0 .25 0 0 0.25\n .5 0 0 .5 1 0 0.5\n .5 0 0 .5 0 1 7 ; kept\n}\n";
    const QByteArray ruled = afterEdit(plain, [](Fractal& f) { maps(f)[1].weight.reset(); });
    QCOMPARE(numbers(QByteArray(ruled).replace(" ; kept", "")), probabilities);
    QCOMPARE(afterEdit(ruled, [](Fractal& f) { maps(f)[1].weight = 0.5; }), plain);
}

void FractintWriterTest::dataFilesKeepTheirBytes() {
    const QStringList names = QDir(support::testData()).entryList({QStringLiteral("*.ifs")});
    QVERIFY(names.size() >= 3);
    for (const QString& name : names)
        QCOMPARE(io::writeFractint(io::readFractint(contents(name))), contents(name));
}

void FractintWriterTest::editAtRandom(Fractal& fractal, QRandomGenerator& random) {
    const auto number = [&] {
        return std::round(random.bounded(2.0) * 1e4 - 1e4) / (random.bounded(2) ? 1e4 : 3);
    };
    if (document::system2(fractal) == nullptr || maps(fractal).empty()) {
        fractal.comments << QStringLiteral("seen");
        return;
    }
    auto& all = maps(fractal);
    const auto place = random.bounded(static_cast<int>(all.size()));
    auto& map = all[static_cast<std::size_t>(place)];
    switch (random.bounded(12)) {
    case 0:
        map.map.linear(random.bounded(2), random.bounded(2)) = number();
        break;
    case 1:
        map.map.translation[random.bounded(2)] = number();
        break;
    case 2:
        map.weight = random.bounded(1.0);
        break;
    case 3:
        map.enabled = !map.enabled;
        break;
    case 4:
        all.insert(all.begin() + place, newMap(fractal, number(), random.bounded(1.0)));
        break;
    case 5:
        all.push_back(newMap(fractal, number(), std::nullopt));
        break;
    case 6:
        if (all.size() > 1) all.erase(all.begin() + place);
        break;
    case 7:
        std::swap(map, all[static_cast<std::size_t>(random.bounded(static_cast<int>(all.size())))]);
        break;
    case 8:
        fractal.name = QStringLiteral("n%1").arg(random.bounded(1000));
        break;
    case 9:
        fractal.comments.insert(random.bounded(fractal.comments.size() + 1),
                                QStringLiteral("c%1").arg(place));
        break;
    case 10:
        fractal.headerComment = random.bounded(2) ? QStringLiteral("h") : QString();
        break;
    default:
        fractal.appearance.gamma = 1 + random.bounded(3);
        fractal.appearance.mapColours[map.id] = {1, 2, 3, 255};
        document::plane(fractal)->cage = ifs::cageAtRest<2>(
            {ifs::Vector<2>(0, 0), ifs::Vector<2>(number() + 3e4, 0), ifs::Vector<2>(0, 1)});
    }
}

// Entries of every shape: whatever is edited, the others keep their bytes and the edited one reads back as
// its value.
void FractintWriterTest::randomEditsKeepTheRest() {
    const QByteArray bytes = contents(QStringLiteral("shapes.ifs"));
    const FractalFile original = io::readFractint(bytes);
    QVERIFY(original.entries.size() > 10);
    QRandomGenerator random(99);
    int keptRows = 0;
    for (int round = 0; round < 3000; ++round) {
        const qsizetype index = random.bounded(original.entries.size());
        const FractalFile changed = edited(original, index, [&](Fractal& fractal) {
            for (int i = random.bounded(1, 4); i > 0; --i)
                editAtRandom(fractal, random);
        });
        const QByteArray written = io::writeFractint(changed);
        const FractalFile reread = io::readFractint(written);
        QCOMPARE(reread.entries.size(), original.entries.size());
        for (qsizetype i = 0; i < reread.entries.size(); ++i) {
            const Entry& entry = reread.entries[i];
            if (i != index) {
                QCOMPARE(entry.source->text, original.entries[i].source->text);
                QCOMPARE(entry.source->before, original.entries[i].source->before);
            } else {
                if (!(*entry.fractal == io::asStored(*changed.entries[i].fractal)))
                    QFAIL(entry.source->text.constData());
                keptRows += entry.source->text.contains("; kept") ? 1 : 0;
            }
        }
        QCOMPARE(reread.tail, original.tail);
    }
    QVERIFY(keptRows > 1500); // written afresh only in rare cases
}

void FractintWriterTest::aShorterTextIsStillACollection_data() {
    QTest::addColumn<QByteArray>("odd");
    QTest::newRow("NUL") << QByteArray(8, '\0');
    QTest::newRow("a word of IFStile") << QByteArray("; $dim\n");
    QTest::newRow("a word of XaoS") << QByteArray("; (formula 'mandel)\n");
    QTest::newRow("words of a script") << QByteArray("scale\n").repeated(30);
}

// Names that begin as other formats do are read back from a text that begins with them.
void FractintWriterTest::namesAreNoFormats() {
    for (const char* name : {"<barnsley_fern", "<flames>", "@maple"}) {
        Fractal fractal = document::sierpinskiTriangle();
        fractal.name = QString::fromLatin1(name);
        const FractalFile file = io::readFractint(io::writeEntry(fractal));
        QCOMPARE(file.entries.size(), 1);
        QCOMPARE(file.entries[0].fractal->name, fractal.name);
    }
    QVERIFY(io::readFractint("<svg>\na {\n.5 0 0 .5 0 0 1\n}\n</svg>").entries.isEmpty());
}

// Bare rows end at ^Z, where DOS ended its texts.
void FractintWriterTest::bareRowsEndInAComment() {
    for (const QByteArray& untouched :
         {QByteArray(".5 0 0 .5 0 0 1 ; rows up to\x1a"), QByteArray(".5 0 0 .5 0 0 1 ;\n\x1a")})
        QCOMPARE(io::writeFractint(io::readFractint(untouched)), untouched);
}

// What stood too far down, or was too little, to make the text something else comes to the fore.
void FractintWriterTest::aShorterTextIsStillACollection() {
    QFETCH(QByteArray, odd);
    const QByteArray rows = QByteArray(".5 0 0 .5 0 0 1\n").repeated(300);
    const QByteArray before = "a {\n" + rows + "}\n" + odd + "\nb {\n.5 0 0 .5 0 0 1\n}\n";
    QCOMPARE(io::readFractint(before).entries.size(), 2);
    const QByteArray after = afterEdit(before, [](Fractal& f) { maps(f).resize(1); });
    QVERIFY(after.size() < 512 && after.contains(odd));
    QCOMPARE(io::readFractint(after).entries.size(), 2);
}

BARYCAGE_TEST(FractintWriterTest);
#include "fractint_writer_test.moc"
