// SPDX-License-Identifier: MIT
#include "document/fractal/recurring_branches.h"
#include "io/fractint/metadata_comments.h"
#include "io/text/number.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

using document::Fractal;

namespace {

Fractal ofMaps(std::size_t maps) {
    document::System2 system;
    for (std::size_t i = 0; i < maps; ++i)
        ifs::append(system, ifs::affineMap(.5, 0, 0, .5, double(i), 0), 1.0);
    return support::fractalOf(system);
}

ifs::WeightedMap<2>& map(Fractal& fractal, std::size_t i) {
    return document::system2(fractal)->maps[i];
}

QByteArray written(const Fractal& fractal) {
    QByteArrayList values;
    for (QByteArray line : io::metadataComments(fractal))
        values << line.replace("; barycage: ", "");
    return values.join("; ");
}

// The comments, read into a fractal as its rows say it: what is off has weight 0.
Fractal reread(const Fractal& fractal) {
    io::MetadataComments comments;
    for (const QByteArray& line : io::metadataComments(fractal))
        if (!comments.read(QByteArrayView(line).sliced(1))) qFatal("%s", line.constData());
    Fractal back = fractal;
    document::plane(back)->cage.reset();
    document::plane(back)->moved.clear();
    back.appearance = {};
    for (auto& weighted : document::system2(back)->maps) {
        if (!weighted.enabled) weighted.weight = 0;
        weighted.enabled = true;
    }
    const QStringList sentences = comments.applyTo(back).sentences;
    if (!sentences.isEmpty()) qFatal("%s", qPrintable(sentences.join(u' ')));
    return back;
}

// A tetrahedron of four maps, held by its corners, with a branch shown elsewhere.
Fractal spaceFractal() {
    const std::vector<ifs::Vector<3>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    document::Shape<3> shape;
    for (const auto& corner : corners)
        ifs::append(shape.system, {ifs::Matrix<3>::Identity() / 2, corner / 2}, 0.25);
    shape.cage = ifs::ControlCage<3>{corners, corners};
    shape.cage->current[3] = {0.5, -2, 3};
    ifs::Matrix<3> turn;
    turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    shape.moved = {{{shape.system.maps[3].id, shape.system.maps[0].id}, {turn, {1, 2, 3}}}};
    Fractal fractal;
    fractal.shape = std::move(shape);
    return fractal;
}

constexpr const char* planeCage =
    "rest 0 0; rest 1 0; rest 0 1; current 0 0; current 2 0; current 0 1; deformation affine-fit";
constexpr const char* spaceCage = "rest 0 0 0; rest 1 0 0; rest 0 1 0; rest 0 0 1; current 0 0 0; "
                                  "current 1 0 0; current 0 1 0; current 0 0 2; deformation affine-fit";
constexpr const char* planeBranch = "branch 1; by 1 0; by 0 1; by 0 0";
constexpr const char* spaceBranch = "branch 1; by 1 0 0; by 0 1 0; by 0 0 1; by 0 0 0";

} // namespace

class MetadataCommentsTest : public QObject {
    Q_OBJECT

private slots:
    void howSpaceIsShownSurvives() {
        attractor::SpaceAppearance shown;
        for (const attractor::LookInSpace look :
             {attractor::LookInSpace::Stone, attractor::LookInSpace::Ink, attractor::LookInSpace::Cloud,
              attractor::LookInSpace::XRay, attractor::LookInSpace::Depth, attractor::LookInSpace::Normals})
            for (const auto colour :
                 {attractor::SolidColour::Plain, attractor::SolidColour::Map, attractor::SolidColour::Address,
                  attractor::SolidColour::Height, attractor::SolidColour::Depth}) {
                shown.look = look;
                shown.colourBy = colour;
                shown.fog += 1.0 / 3;
                shown.lightAzimuth = -1234567.8901234567;
                shown.clip = attractor::SpaceClip{
                    {-1.2345678901234567e-100, 0.1, 1e100 / 3}, -HUGE_VAL, 0.1234567890123456789 * int(look)};
                if (colour == attractor::SolidColour::Map)
                    shown.clip->lowest = -9.87654321098765432e-12 - shown.fog;
                Fractal fractal = spaceFractal();
                fractal.inSpace = shown;
                io::MetadataComments comments;
                for (const QByteArray& line : io::metadataComments(fractal)) {
                    QVERIFY(line.size() < 70);
                    QVERIFY2(comments.read(QByteArrayView(line).sliced(1)), line.constData());
                }
                Fractal back = spaceFractal();
                document::space(back)->moved.clear();
                QVERIFY(comments.applyTo(back).sentences.isEmpty());
                QVERIFY(back.inSpace == shown);
            }
        QVERIFY(!written(ofMaps(2)).contains("space-look"));
    }

    void whatIsNoLookIsKeptAsItIs() {
        for (const char* line :
             {" barycage: space-look marble", " barycage: fog -1", " barycage: fog 1e9", " barycage: light 1",
              " barycage: clip-normal x 0 0", " barycage: clip-range", " barycage: solid-colour"}) {
            io::MetadataComments comments;
            QVERIFY2(!comments.read(line), line);
        }
        io::MetadataComments broken;
        QVERIFY(broken.read(" barycage: clip-normal 0 0 1"));
        QVERIFY(!broken.read(" barycage: clip-range - 1.5 x")); // all of the line, or nothing
        Fractal whole = spaceFractal();
        broken.applyTo(whole);
        QVERIFY(!whole.inSpace.clip);
        io::MetadataComments flat; // understood, but it cuts nothing
        QVERIFY(flat.read(" barycage: clip-normal 0 0 0") && flat.read(" barycage: clip-range 0 1"));
        Fractal fractal = spaceFractal();
        flat.applyTo(fractal);
        QVERIFY(!fractal.inSpace.clip);
    }

    void newEntriesNeedNone();
    void lines();
    void everythingComesBack();
    void longWordsAreBroken();
    void spaceComesBack();
    void longPointsAreBroken();
    void otherDimensionIsKept_data();
    void otherDimensionIsKept();
    void unreadableEntriesKeepTheirPlacement();
    void ownComments_data();
    void ownComments();
    void understood_data();
    void understood();
    void whatDoesNotFitIsSaid_data();
    void whatDoesNotFitIsSaid();
    void otherProgramsHaveTheLastWord();
    void hostileLinesAreLimited();
    void storedFormKeepsWhatCanBeStored();
};

void MetadataCommentsTest::newEntriesNeedNone() {
    QVERIFY(io::metadataComments(ofMaps(2)).isEmpty());
    QVERIFY(io::metadataComments(Fractal()).isEmpty());
}

void MetadataCommentsTest::lines() {
    Fractal fractal = ofMaps(3);
    fractal.appearance.gamma = 1.5;
    fractal.appearance.colourBy = attractor::ColourBy::Map;
    fractal.appearance.mapColours[map(fractal, 1).id] = {1, 2, 255, 255};
    map(fractal, 2).enabled = false;
    QCOMPARE(written(fractal),
             QByteArray("version 1; colour-by map; gamma 1.5; map-colour 2 #0102ffff; off 3 1"));
    map(fractal, 0).weight.reset();
    map(fractal, 1).weight = 5;
    QCOMPARE(
        written(fractal),
        QByteArray("version 1; colour-by map; gamma 1.5; unweighted 1; weight 2 5; map-colour 2 #0102ffff; "
                   "off 3 1"));
    Fractal bare = ofMaps(2);
    map(bare, 0).weight.reset();
    map(bare, 1).weight.reset();
    QCOMPARE(written(bare), QByteArray("version 1; unweighted all"));
    document::plane(bare)->cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, .5}, {0, 1}}};
    QCOMPARE(written(bare), QByteArray("version 1; rest 0 0; rest 1 0; rest 0 1; current 0 0; current 1 0.5; "
                                       "current 0 1; unweighted all"));
    Fractal moved = ofMaps(2);
    document::plane(moved)->moved = {
        {{map(moved, 1).id, map(moved, 0).id}, ifs::affineMap(1, 2, 3, 4, 5, 6)}};
    QCOMPARE(written(moved), QByteArray("version 1; branch 2 1; by 1 2; by 3 4; by 5 6"));
    document::plane(moved)->moved[0].word = document::recurringWord({map(moved, 1).id});
    QCOMPARE(written(moved), QByteArray("version 1; branch 0 2; by 1 2; by 3 4; by 5 6"));
}

void MetadataCommentsTest::everythingComesBack() {
    Fractal fractal = ofMaps(4);
    document::plane(fractal)->cage =
        ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1. / 3}}, {{0, .1}, {1, .5}, {-7e-5, 1}}};
    document::plane(fractal)->cage->deformation = ifs::Deformation::AffineFit;
    attractor::Appearance& appearance = fractal.appearance;
    appearance.colourBy = attractor::ColourBy::Address;
    appearance.palette = {"my own", {{0, {1, 2, 3, 255}}, {1. / 3, {40, 50, 60, 255}}, {1, {7, 8, 9, 255}}}};
    appearance.plain = {9, 8, 7, 255};
    appearance.background = {1, 1, 1, 128};
    appearance.brightness = 1. / 7;
    appearance.gamma = .3;
    appearance.contrast = 1. / 3;
    appearance.vibrancy = 0;
    appearance.shadow = 2. / 3;
    appearance.shadowLean = -1.25;
    appearance.shadowLength = 0;
    appearance.supersample = 3;
    appearance.mapColours[map(fractal, 0).id] = {1, 2, 3, 4};
    appearance.mapColours[map(fractal, 3).id] = {5, 6, 7, 255};
    map(fractal, 1).enabled = false;
    map(fractal, 1).weight = -2.5;
    map(fractal, 2).enabled = false;
    map(fractal, 2).weight.reset();
    document::plane(fractal)->moved = {
        {{map(fractal, 3).id}, ifs::affineMap(.1, .2, .3, .4, .5, .6)},
        {{map(fractal, 0).id, map(fractal, 3).id}, ifs::affineMap(1, 0, 0, 1, 2, 0)},
        {document::recurringWord({map(fractal, 3).id}), ifs::affineMap(0, -1, 1, 0, 0, 1)}};
    const Fractal back = reread(fractal);
    QVERIFY(document::plane(back)->cage == document::plane(fractal)->cage);
    QVERIFY(back.appearance == fractal.appearance);
    QVERIFY(document::isSameSystem(back, fractal));
    QVERIFY(back == fractal);
}

// Readers of old take 70 bytes a line and no more.
void MetadataCommentsTest::longWordsAreBroken() {
    Fractal fractal = ofMaps(12);
    std::vector<ifs::MapId> word;
    for (std::size_t i = 0; i < 60; ++i)
        word.push_back(map(fractal, (i * 5) % 12).id);
    document::plane(fractal)->moved = {
        {word, ifs::affineMap(-1.2345678901234567e-5, -1.2345678901234567e-5, 0, 1, 0, 0)}};
    fractal.appearance.palette = {std::string(49, 'n'), {{0, {}}, {.123456789012345678, {}}, {1, {}}}};
    for (const QByteArray& line : io::metadataComments(fractal))
        QVERIFY2(line.size() < 70, line.constData());
    QVERIFY(reread(fractal) == fractal);
}

void MetadataCommentsTest::spaceComesBack() {
    const Fractal fractal = spaceFractal();
    QCOMPARE(written(fractal),
             QByteArray("version 1; rest 0 0 0; rest 1 0 0; rest 0 1 0; rest 0 0 1; current 0 0 0; "
                        "current 1 0 0; current 0 1 0; current 0.5 -2 3; branch 4 1; by 0 -1 0; by 1 0 0; "
                        "by 0 0 1; by 1 2 3"));
    io::MetadataComments comments;
    for (const QByteArray& line : io::metadataComments(fractal))
        QVERIFY2(comments.read(QByteArrayView(line).sliced(1)), line.constData());
    Fractal back = fractal;
    back.shape = document::Shape<3>{*document::system3(fractal)};
    const auto outcome = comments.applyTo(back);
    QVERIFY(outcome.sentences.isEmpty() && outcome.kept.empty());
    QVERIFY(back == fractal);
}

void MetadataCommentsTest::longPointsAreBroken() {
    const double longest = -1.2345678901234567e-300;
    Fractal fractal = spaceFractal();
    document::Shape<3>& shape = *document::space(fractal);
    shape.cage->current = {
        {longest, longest, longest}, {1, longest, longest}, {1, 2, longest}, {longest, 2, 3}};
    shape.moved[0].change.linear(1, 1) = shape.moved[0].change.linear(1, 0) = longest;
    shape.moved[0].change.translation = {longest, longest, 0};
    io::MetadataComments comments;
    for (const QByteArray& line : io::metadataComments(fractal)) {
        QVERIFY2(line.size() < 70, line.constData());
        QVERIFY2(comments.read(QByteArrayView(line).sliced(1)), line.constData());
    }
    const QByteArray number = io::formatNumber(longest);
    QVERIFY(written(fractal).contains("current " + number + " \\; current " + number + ' ' + number + "; "));
    Fractal back = fractal;
    back.shape = document::Shape<3>{shape.system};
    QVERIFY(comments.applyTo(back).sentences.isEmpty());
    QVERIFY(back == fractal);
}

void MetadataCommentsTest::otherDimensionIsKept_data() {
    QTest::addColumn<bool>("isInSpace");
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QString>("kept");
    QTest::addColumn<bool>("isHeld");
    const QByteArray gamma = "gamma 2; ";
    const auto row = [](const char* name, bool isInSpace, const QByteArray& lines, const char* kept,
                        bool isHeld) {
        QTest::newRow(name) << isInSpace << lines << QString::fromLatin1(kept) << isHeld;
    };
    row("a cage of the plane in space", true, gamma + planeCage, "1 2 3 4 5 6 7", false);
    row("a cage of space in the plane", false, gamma + spaceCage, "1 2 3 4 5 6 7 8 9", false);
    row("a branch of the plane in space", true, gamma + planeBranch, "1 2 3 4", false);
    row("a branch of space in the plane", false, gamma + spaceBranch, "1 2 3 4 5", false);
    row("both in the plane", false, QByteArray(spaceCage) + "; " + planeCage, "0 1 2 3 4 5 6 7", true);
    row("both in space", true, QByteArray(planeCage) + "; " + spaceCage, "0 1 2 3 4 5", true);
    row("a point that goes on, and does not", false, "rest 0 \\", "0", false);
}

void MetadataCommentsTest::otherDimensionIsKept() {
    QFETCH(bool, isInSpace);
    QFETCH(QByteArray, lines);
    QFETCH(QString, kept);
    QFETCH(bool, isHeld);
    io::MetadataComments comments;
    for (const QByteArray& line : lines.split(';'))
        QVERIFY2(comments.read("barycage: " + line), line.constData());
    Fractal fractal = ofMaps(2);
    if (isInSpace) fractal.shape = document::Shape<3>{*document::system3(spaceFractal())};
    const auto outcome = comments.applyTo(fractal);
    QStringList found;
    for (const std::size_t line : outcome.kept)
        found << QString::number(line);
    QCOMPARE(found.join(u' '), kept);
    QCOMPARE(outcome.sentences.size(), 1);
    const auto* plane = document::plane(fractal);
    const auto* space = document::space(fractal);
    QCOMPARE(plane ? plane->cage.has_value() : space->cage.has_value(), isHeld);
    QVERIFY(plane ? plane->moved.empty() : space->moved.empty());
}

void MetadataCommentsTest::unreadableEntriesKeepTheirPlacement() {
    io::MetadataComments comments;
    const QByteArray lines = QByteArray("gamma 2; ") + planeCage + "; " + spaceBranch;
    for (const QByteArray& line : lines.split(';'))
        QVERIFY2(comments.read("barycage: " + line), line.constData());
    Fractal fractal;
    const auto outcome = comments.applyTo(fractal);
    QCOMPARE(document::dimension(fractal), 0);
    QVERIFY(outcome.sentences.isEmpty());
    QVERIFY((outcome.kept == std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

void MetadataCommentsTest::ownComments_data() {
    QTest::addColumn<QByteArray>("comment");
    QTest::addColumn<bool>("isOwn");
    QTest::newRow("ours") << QByteArray(" barycage: gamma 2") << true;
    QTest::newRow("whatever the key") << QByteArray("barycage:") << true;
    QTest::newRow("a mention") << QByteArray(" see barycage: it is ours") << false;
    QTest::newRow("without a colon") << QByteArray(" barycage gamma 2") << false;
    QTest::newRow("shouted") << QByteArray(" Barycage: gamma 2") << false;
    QTest::newRow("nothing") << QByteArray() << false;
}

void MetadataCommentsTest::ownComments() {
    QFETCH(QByteArray, comment);
    QFETCH(bool, isOwn);
    QCOMPARE(io::isOwnComment(comment), isOwn);
    if (!isOwn) QVERIFY(!io::MetadataComments().read(comment));
}

void MetadataCommentsTest::understood_data() {
    QTest::addColumn<bool>("expected");
    for (const char* line : {"version 1",
                             "version 7 or so",
                             "gamma 2",
                             "  gamma \t 2 ",
                             "brightness 1e3",
                             "contrast 0.25",
                             "vibrancy 0",
                             "vibrancy 1",
                             "shadow 0.5",
                             "shadow-lean -10",
                             "shadow-length 0.25",
                             "supersample 4",
                             "deformation bend",
                             "deformation affine-fit",
                             "colour-by plain",
                             "plain #102030ff",
                             "background #10203040",
                             "rest 1 -2.5e3",
                             "rest 1 2 3",
                             "current 1 \\",
                             "current 1 2 \\",
                             "off 1",
                             "off 2 -3",
                             "weight 1 0.5",
                             "unweighted all",
                             "unweighted 250000",
                             "map-colour 1 #fff000ff",
                             "palette",
                             "palette of two words",
                             "stop 0 #000000ff",
                             "stop 1 #ffffffff",
                             "branch 1 2 3"})
        QTest::newRow(line) << true;
    for (const char* line : {"",
                             "tea 5",
                             "Gamma 2",
                             "gamma",
                             "gamma 0",
                             "gamma -1",
                             "gamma nan",
                             "gamma 1,5",
                             "gamma 1 2",
                             "contrast 0",
                             "contrast inf",
                             "vibrancy -0.1",
                             "vibrancy 1.01",
                             "vibrancy nan",
                             "shadow -0.1",
                             "shadow 1.1",
                             "shadow-lean 11",
                             "shadow-length inf",
                             "supersample 5",
                             "supersample 1.5",
                             "supersample 0",
                             "deformation twist",
                             "colour-by sound",
                             "plain red",
                             "plain #102030",
                             "background #12",
                             "rest 1",
                             "rest 1 2 3 4",
                             "rest \\",
                             "rest 1 2 3 \\",
                             "rest 1 \\ 2",
                             "rest 1 inf",
                             "off 0",
                             "off -1",
                             "off x",
                             "off 1 x",
                             "off 1 2 3",
                             "weight 1",
                             "weight 1 0",
                             "weight 0 1",
                             "unweighted some",
                             "map-colour 1",
                             "map-colour 0 #ffffffff",
                             "stop 1.5 #ffffffff",
                             "stop -0.1 #ffffffff",
                             "stop 0",
                             "branch",
                             "branch 0",
                             "branch 0 0 1",
                             "branch 1 0",
                             "branch 1 x",
                             "by 1 2"})
        QTest::newRow(line) << false;
}

void MetadataCommentsTest::understood() {
    QFETCH(bool, expected);
    io::MetadataComments comments;
    QCOMPARE(comments.read("barycage: " + QByteArray(QTest::currentDataTag())), expected);
}

void MetadataCommentsTest::whatDoesNotFitIsSaid_data() {
    QTest::addColumn<QByteArrayList>("lines");
    QTest::addColumn<int>("sentences");
    const auto row = [](const char* name, const QByteArrayList& lines, int sentences) {
        QTest::newRow(name) << lines << sentences;
    };
    row("nothing", {}, 0);
    row("a cage of two corners", {"rest 0 0", "rest 1 0", "current 0 0", "current 1 0"}, 1);
    row("lists that do not match", {"rest 0 0", "rest 1 0", "rest 0 1", "current 0 0"}, 1);
    row("a flat cage", {"rest 0 0", "rest 1 0", "rest 2 0", "current 0 0", "current 1 0", "current 0 1"}, 1);
    row("a palette nobody knows", {"palette does not exist"}, 1);
    row("one that everybody knows", {"palette Fire"}, attractor::findPalette("Fire") ? 0 : 1);
    row("stops that are no gradient", {"palette x", "stop 0.5 #000000ff"}, 1);
    row("a map that is not there", {"off 3"}, 1);
    row("a colour of a map that is not there", {"map-colour 3 #ffffffff"}, 0);
    row("a branch of a map that is not there", {"branch 3", "by 1 0", "by 0 1", "by 0 0"}, 1);
    row("one that changes inside itself, of a map that is not there",
        {"branch 0 3", "by 1 0", "by 0 1", "by 0 0"}, 1);
    row("a branch that is moved in both ways",
        {"branch 1", "by 1 0", "by 0 1", "by 0 0", "branch 0 1", "by 1 0", "by 0 1", "by 5 0"}, 0);
    row("an unfinished branch", {"branch 1", "by 1 0", "by 0 1"}, 1);
    row("the same branch twice",
        {"branch 1", "by 1 0", "by 0 1", "by 0 0", "branch 1", "by 1 0", "by 0 1", "by 5 0"}, 1);
    row("a branch that leaves the plane half way", {"branch 1", "by 1 0", "by 0 1 0", "by 0 0"}, 1);
}

void MetadataCommentsTest::whatDoesNotFitIsSaid() {
    QFETCH(QByteArrayList, lines);
    QFETCH(int, sentences);
    io::MetadataComments comments;
    for (const QByteArray& line : lines)
        QVERIFY(comments.read("barycage: " + line));
    Fractal fractal = ofMaps(2);
    QCOMPARE(comments.applyTo(fractal).sentences.size(), sentences);
    QVERIFY(!document::plane(fractal)->cage);
}

// Rows and comments may disagree when another program has edited the rows.
void MetadataCommentsTest::otherProgramsHaveTheLastWord() {
    io::MetadataComments comments;
    QVERIFY(comments.read("barycage: off 1 0.5") && comments.read("barycage: off 2 0.25"));
    Fractal fractal = ofMaps(2);
    map(fractal, 1).weight = 0;
    QCOMPARE(comments.applyTo(fractal).sentences.size(), 1);
    QVERIFY(map(fractal, 0).enabled && map(fractal, 0).weight == 1.);
    QVERIFY(!map(fractal, 1).enabled && map(fractal, 1).weight == .25);
}

void MetadataCommentsTest::hostileLinesAreLimited() {
    io::MetadataComments comments;
    int corners = 0, stops = 0, branches = 0;
    for (int i = 0; i < 10'000; ++i) {
        corners += comments.read("barycage: rest 1 2");
        stops += comments.read("barycage: stop 0.5 #000000ff");
        branches += comments.read("barycage: branch 1");
        for (int k = 0; k < 3; ++k)
            comments.read("barycage: by 1 2");
    }
    QCOMPARE(corners, 4096);
    QCOMPARE(stops, 4096);
    QCOMPARE(branches, 1024);
    QVERIFY(!io::MetadataComments().read("barycage: branch" + QByteArray(" 1").repeated(65)));
    QVERIFY(io::MetadataComments().read("barycage: branch" + QByteArray(" 1").repeated(64)));
    Fractal fractal = ofMaps(2);
    QVERIFY(!comments.applyTo(fractal).sentences.isEmpty());
}

void MetadataCommentsTest::storedFormKeepsWhatCanBeStored() {
    Fractal fractal = ofMaps(3);
    const ifs::MapId gone = map(fractal, 0).id, kept = map(fractal, 2).id;
    fractal.appearance.mapColours[gone] = {1, 1, 1, 255};
    fractal.appearance.mapColours[kept] = {2, 2, 2, 255};
    document::plane(fractal)->moved = {{{gone}, {}}, {{kept, kept}, {}}};
    fractal.appearance.palette.name = "two\nlines \x07 of it " + std::string(100, 'x');
    document::system2(fractal)->maps.erase(document::system2(fractal)->maps.begin());
    const Fractal stored = io::asStored(fractal);
    const auto& maps = document::system2(stored)->maps;
    QVERIFY(maps[0].id == ifs::MapId(1) && maps[1].id == ifs::MapId(2));
    QVERIFY(*stored.appearance.mapColours.find(ifs::MapId(2)) == (attractor::Rgba{2, 2, 2, 255}));
    QVERIFY(stored.appearance.mapColours.find(ifs::MapId(3)) == nullptr);
    QCOMPARE(document::plane(stored)->moved.size(), 1u);
    QVERIFY(document::plane(stored)->moved[0].word ==
            (std::vector<ifs::MapId>{ifs::MapId(2), ifs::MapId(2)}));
    QVERIFY(stored.appearance.palette.name.starts_with("two lines of it x"));
    QVERIFY(stored.appearance.palette.name.size() < 70);
    QVERIFY(io::asStored(stored) == stored);
}

BARYCAGE_TEST(MetadataCommentsTest);
#include "metadata_comments_test.moc"
