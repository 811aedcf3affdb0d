// SPDX-License-Identifier: MIT
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

// barycage-cli as a black box: arguments in; status, text and files out.
class CliTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void helpAndVersion();
    void wrongUsage_data();
    void wrongUsage();
    void unknownCommandIsNamed();
    void messagesHoldNoControlCharacters();
    void aPointIsInTheMiddle();
    void thousandsOfMapsFitIntoMemory();
    void nothingLeftIsNotWritten();
    void anEntryNamedTwiceIsTakenOnce();
    void fullOutputIsSaid();
    void missingFiles();
    void factsOfTheMaple();
    void addressesOfTheHull();
    void howACageOfManyCornersDeforms();
    void factsOfTheFern();
    void factsInSpace();
    void unknownFactsAreNull();
    void brokenEntries();
    void standardInput();
    void sameBytesForAnyThreads();
    void pictureReopens_data();
    void pictureReopens();
    void viewShowsTheWholeAttractor();
    void cageMovesThePicture();
    void restCagesAroundTheAttractor_data();
    void restCagesAroundTheAttractor();
    void cageOfManyCornersBendsThePicture();
    void copyKeepsEveryByte();
    void bakedCodeDrawsTheSame();
    void convertsThereAndBack_data();
    void convertsThereAndBack();
    void convertsManyFilesIntoAFolder();
    void writesPoints();
    void parameterFilesBecomeCollections();
    void drawsShapes();
    void drawsAGallery();
    void instructionSetsGiveTheSameBytes();
    void pictureOptionsCount();
    void interruptLeavesNothing();

private:
    struct Result {
        int status = -1;
        QByteArray out;
        QByteArray err;
    };
    Result run(const QStringList& arguments, const QByteArray& input = {}) const;
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    void write(const char* name, const QByteArray& bytes) const;
    QByteArray read(const char* name) const;
    QJsonObject entryOf(const Result& result, int index = 0) const;

    QTemporaryDir m_folder;
};

namespace {

const QByteArray systems = "maple {\r\n"
                           " -0.04 0 -0.23 -0.65 -0.08 0.26 .25\r\n"
                           " 0.61 0 0 0.31 0.07 3.5 .25\r\n"
                           " 0.65 0.29 -0.3 0.48 0.74 0.39 .25\r\n"
                           " 0.64 -0.3 0.16 0.56 -0.56 0.60 .25\r\n"
                           "}\r\n"
                           "Fern { ; Barnsley\n"
                           " 0 0 0 0.16 0 0 .01\n"
                           " 0.85 0.04 -0.04 0.85 0 1.6 .85\n"
                           " 0.2 -0.26 0.23 0.22 0 1.6 .07\n"
                           " -0.15 0.28 0.26 0.24 0 0.44 .07\n"
                           "}\n"
                           "spin {\n 0 -1 1 0 0 0 1\n}\n";

void compare(double actual, double expected, double tolerance) {
    QVERIFY2(std::abs(actual - expected) <= tolerance,
             qPrintable(QStringLiteral("%1 is not %2").arg(actual, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

void compare(const QJsonValue& pair, double x, double y, double tolerance) {
    QCOMPARE(pair.toArray().size(), 2);
    compare(pair[0].toDouble(), x, tolerance);
    compare(pair[1].toDouble(), y, tolerance);
}

} // namespace

CliTest::Result CliTest::run(const QStringList& arguments, const QByteArray& input) const {
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(QStringLiteral(BARYCAGE_CLI), arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(120'000)) return {};
    if (process.exitStatus() != QProcess::NormalExit) return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

void CliTest::write(const char* name, const QByteArray& bytes) const {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QByteArray CliTest::read(const char* name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject CliTest::entryOf(const Result& result, int index) const {
    return QJsonDocument::fromJson(result.out)[QLatin1String("entries")][index].toObject();
}

void CliTest::initTestCase() {
    QVERIFY(m_folder.isValid());
    write("systems.ifs", systems);
    write("broken.ifs", "good {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\nbad {\n .5 0 0 oops 0 0 1\n}\n");
}

void CliTest::helpAndVersion() {
    const Result version = run({QStringLiteral("--version")});
    QCOMPARE(version.status, 0);
    QVERIFY(version.out.startsWith("barycage-cli "));
    for (const char* command : {"info", "render", "convert"}) {
        const Result help = run({QLatin1String(command), QStringLiteral("--help")});
        QCOMPARE(help.status, 0);
        QVERIFY(help.out.contains("--entry"));
        QVERIFY(help.err.isEmpty());
    }
}

void CliTest::wrongUsage_data() {
    QTest::addColumn<QString>("arguments");
    const auto row = [](const char* text) { QTest::newRow(text) << QString::fromLatin1(text); };
    row("");
    row("frobnicate");
    row("info");
    row("info systems.ifs --nonsense");
    row("info systems.ifs --hull-tolerance -1");
    row("render systems.ifs");
    row("render systems.ifs -o x.gif");
    row("render systems.ifs -o x.png --size 12by9");
    row("render systems.ifs -o x.png --size 0x9");
    row("render systems.ifs -o x.png --palette no-such-palette");
    row("render systems.ifs -o x.png --background colourless");
    row("render systems.ifs -o x.png --gamma -1");
    row("render systems.ifs -o x.png --gamma 2,2");
    row("render systems.ifs -o x.png --bits 12");
    row("render systems.ifs -o x.svg --bits 16");
    row("render systems.ifs -o x.png --simd mmx");
    row("render systems.ifs -o x.png --palette systems.ifs");
    row("render systems.ifs -o x.png --colour rainbow");
    row("render systems.ifs -o x.png --supersample 5");
    row("render systems.ifs -o x.png --depth 3");
    row("render systems.ifs -o x.svg --points 1000");
    row("render systems.ifs -o x.svg --svg spiral");
    row("render systems.ifs -o x.svg --depth 150");
    row("render systems.ifs -o x.png --algorithm deterministic");
    row("render systems.ifs -o x.png --rest-cage hull:2");
    row("render systems.ifs -o x.png --rest-cage hull:many");
    row("render systems.ifs -o x.png --rest-cage 0,0;1,0");
    row("render systems.ifs -o x.png --view 1,2");
    row("render systems.ifs -o x.png --view 1,2,0");
    row("render systems.ifs -o x.png --margin 50");
    row("render systems.ifs -o x.png --progress sometimes");
    row("render systems.ifs -o x.png --seed -1");
    row("render systems.ifs -o x.png --seed 99999999999999999999");
    row("render systems.ifs -o x.png --points 0");
    row("render systems.ifs -o x.png --points -5");
    row("render systems.ifs -o x.png --points 1e6");
    row("convert systems.ifs x.docx");
}

void CliTest::wrongUsage() {
    QFETCH(QString, arguments);
    const Result result = run(arguments.split(u' ', Qt::SkipEmptyParts));
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.startsWith("barycage-cli"), result.err.constData());
    QVERIFY(result.err.contains(": error: "));
    for (const char* name : {"x.png", "x.svg", "x.gif", "x.docx"})
        QVERIFY(!QFile::exists(path(name)));
}

void CliTest::unknownCommandIsNamed() {
    const Result result = run({QStringLiteral("galery"), QStringLiteral("systems.ifs")});
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains("galery"), result.err.constData());
}

// What a file says is printed, and does not command the terminal or the sentence it stands in.
void CliTest::messagesHoldNoControlCharacters() {
    write("%4.ifs", "a\x1b[31mb {\n 1/%2\x07 0 0\n}\nc\rd {\n .5 0 0 .5 0 0 1\n}\n");
    for (const QStringList& arguments :
         {QStringList{QStringLiteral("info"), QStringLiteral("%4.ifs")},
          QStringList{QStringLiteral("convert"), QStringLiteral("%4.ifs"), QStringLiteral("x.flame")}}) {
        const Result result = run(arguments);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.err.startsWith("%4.ifs:2:2: error: "), result.err.constData());
        QVERIFY2(result.err.contains("“1/%2"), result.err.constData());
        for (const QByteArray& text : {result.out, result.err})
            QVERIFY(
                std::none_of(text.begin(), text.end(), [](char c) { return c < ' ' && c > 0 && c != '\n'; }));
    }
}

// One map has one point: it is the middle of the picture, whatever rounding makes of its box.
void CliTest::aPointIsInTheMiddle() {
    write("point.ifs", "point {\n .5 .1 -.1 .5 1 2 1\n}\n");
    const Result result = run({QStringLiteral("render"), QStringLiteral("point.ifs"), QStringLiteral("-o"),
                               QStringLiteral("point.png"), QStringLiteral("--size"), QStringLiteral("81x61"),
                               QStringLiteral("--points"), QStringLiteral("1000"),
                               QStringLiteral("--background"), QStringLiteral("transparent")});
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.isEmpty(), result.err.constData());
    const QImage image(path("point.png"));
    int lit = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y).alpha() > 0) {
                ++lit;
                QVERIFY(std::abs(x - 40) <= 1 && std::abs(y - 30) <= 1);
            }
    QVERIFY(lit > 0);
}

// Every word has 8,000 children that overlap; all words of one level at once would fill any memory.
void CliTest::thousandsOfMapsFitIntoMemory() {
    QByteArray maps;
    for (int i = 0; i < 8'000; ++i)
        maps += " .9 0 0 .9 " + QByteArray::number(1 + 0.01 * (i % 100)) + " 1 1\n";
    write("many.ifs", "many {\n" + maps + "}\n");
    QCOMPARE(run({QStringLiteral("render"), QStringLiteral("many.ifs"), QStringLiteral("-o"),
                  QStringLiteral("many.png"), QStringLiteral("--size"), QStringLiteral("80x60"),
                  QStringLiteral("--points"), QStringLiteral("20000"), QStringLiteral("--view"),
                  QStringLiteral("15,10,0.05")})
                 .status,
             0);
}

void CliTest::nothingLeftIsNotWritten() {
    write("off.ifs", "off {\n .5 0 0 .5 0 0 0\n .5 0 0 .5 1 0 -1\n}\n");
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("off.ifs"), QStringLiteral("left.ifs"),
                  QStringLiteral("--strict")})
                 .status,
             1);
    QVERIFY(!QFile::exists(path("left.ifs")));
    write("space.ifs", "space (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n");
    QCOMPARE(
        run({QStringLiteral("convert"), QStringLiteral("space.ifs"), QStringLiteral("left.flame")}).status,
        1);
    QVERIFY(!QFile::exists(path("left.flame")));
}

void CliTest::anEntryNamedTwiceIsTakenOnce() {
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("once.ifs"),
                  QStringLiteral("--entry"), QStringLiteral("fern"), QStringLiteral("--entry"),
                  QStringLiteral("FERN")})
                 .status,
             0);
    QCOMPARE(read("once.ifs").count('{'), 1);
}

void CliTest::fullOutputIsSaid() {
    if (!QFile::exists(QStringLiteral("/dev/full"))) QSKIP("needs /dev/full");
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.setStandardOutputFile(QStringLiteral("/dev/full"));
    process.start(QStringLiteral(BARYCAGE_CLI), {QStringLiteral("info"), QStringLiteral("systems.ifs")});
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 3);
    QVERIFY(process.readAllStandardError().contains("systems.ifs: error: "));
}

void CliTest::missingFiles() {
    const Result absent = run({QStringLiteral("info"), QStringLiteral("absent.ifs")});
    QCOMPARE(absent.status, 3);
    QVERIFY(absent.err.startsWith("absent.ifs: error: "));
    const Result folder =
        run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
             QStringLiteral("no/such/folder.png"), QStringLiteral("--size"), QStringLiteral("9x9")});
    QCOMPARE(folder.status, 3);
    const Result entry = run({QStringLiteral("info"), QStringLiteral("systems.ifs"),
                              QStringLiteral("--entry"), QStringLiteral("oak"), QStringLiteral("--json")});
    QCOMPARE(entry.status, 1);
    QVERIFY(entry.err.contains("oak"));
    QVERIFY(QJsonDocument::fromJson(entry.out).isObject());
}

// The exact values of docs/mathematics.md for the maple with equal weights.
void CliTest::factsOfTheMaple() {
    const Result result = run({QStringLiteral("info"), QStringLiteral("systems.ifs"),
                               QStringLiteral("--entry"), QStringLiteral("MAPLE"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonObject maple = entryOf(result);
    QCOMPARE(maple[QLatin1String("name")].toString(), QStringLiteral("maple"));
    QCOMPARE(maple[QLatin1String("dimension")].toInt(), 2);
    compare(maple[QLatin1String("mean")], 5135.0 / 70583, 101021.0 / 70583, 1e-12);
    compare(maple[QLatin1String("covariance")][0], 1.070887446859971, -0.052426065183732, 1e-12);
    compare(maple[QLatin1String("covariance")][1], -0.052426065183732, 3.782835052470806, 1e-12);
    const QJsonValue box = maple[QLatin1String("bounding_box")];
    compare(box[QLatin1String("min")], -3.30009395647353114, -3.17305096113017084, 1e-11);
    compare(box[QLatin1String("max")], 3.34421444954055797, 5.07246376811594203, 1e-11);
    QVERIFY(box[QLatin1String("error")].toDouble(1) < 1e-10);
    const QJsonValue simplex = maple[QLatin1String("canonical_simplex")];
    QCOMPARE(simplex[QLatin1String("orientation")].toString(), QStringLiteral("--"));
    compare(simplex[QLatin1String("leg")].toDouble(), 11.704657475156326, 1e-10);
    compare(simplex[QLatin1String("vertices")][0], 3.34421444954056, 5.07246376811594, 1e-10);
    compare(maple[QLatin1String("hull")][QLatin1String("area")].toDouble(), 35.754947908201, 1e-3);
    compare(maple[QLatin1String("attractor")][QLatin1String("contractivity")].toDouble(), 0.723195530540,
            1e-11);
    QCOMPARE(maple[QLatin1String("attractor")][QLatin1String("verdict")].toString(),
             QStringLiteral("hyperbolic"));
    QVERIFY(maple[QLatin1String("similarity_dimension")].isNull());
    compare(maple[QLatin1String("affinity_dimension")].toDouble(), 2, 0);
    const QJsonValue map = maple[QLatin1String("maps")][2];
    compare(map[QLatin1String("linear")][0], 0.65, 0.29, 0);
    compare(map[QLatin1String("linear")][1], -0.3, 0.48, 0);
    compare(map[QLatin1String("determinant")].toDouble(), 0.399, 1e-14);
    compare(map[QLatin1String("norm")].toDouble(), 0.722524371029, 1e-11);
    QVERIFY(maple[QLatin1String("cage")].isNull());
}

// Lévy's curve is held by an octagon of exact corners; map 1 is off, so the maps of the addresses are 2
// and 3.
void CliTest::addressesOfTheHull() {
    const Result result = run({QStringLiteral("info"), QStringLiteral("-"), QStringLiteral("--json")},
                              "levy {\n .1 0 0 .1 0 0 0\n .5 -.5 .5 .5 0 0 1\n .5 .5 -.5 .5 .5 .5 1\n}\n");
    QCOMPARE(result.status, 0);
    const QJsonValue hull = entryOf(result)[QLatin1String("hull")];
    compare(hull[QLatin1String("area")].toDouble(), 35.0 / 16, 1e-14);
    const QJsonArray vertices = hull[QLatin1String("vertices")].toArray();
    const QJsonArray addresses = hull[QLatin1String("addresses")].toArray();
    QCOMPARE(vertices.size(), 8);
    QCOMPARE(addresses.size(), 8);
    int found = 0;
    for (int k = 0; k < 8; ++k) {
        const QJsonValue address = addresses[k];
        QCOMPARE(address[QLatin1String("period")].toArray().size(), 2);
        if (QPointF(vertices[k][0].toDouble(), vertices[k][1].toDouble()) != QPointF(1.5, 0)) continue;
        ++found; // 222(12) of the two maps
        QCOMPARE(address[QLatin1String("prefix")].toArray(), (QJsonArray{3, 3}));
        QCOMPARE(address[QLatin1String("period")].toArray(), (QJsonArray{3, 2}));
    }
    QCOMPARE(found, 1);
}

void CliTest::howACageOfManyCornersDeforms() {
    const auto deformation = [&](const QByteArray& lines) {
        const Result result = run({QStringLiteral("info"), QStringLiteral("-"), QStringLiteral("--json")},
                                  "square {\n" + lines + " .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 .5 1\n}\n");
        return entryOf(result)[QLatin1String("cage")][QLatin1String("deformation")].toString();
    };
    const auto vertices = [](const QByteArray& key, const QByteArrayList& places) {
        QByteArray lines;
        for (const QByteArray& place : places)
            lines += " ; barycage: " + key + ' ' + place + '\n';
        return lines;
    };
    const QByteArray four =
        vertices("rest", {"0 0", "1 0", "1 1", "0 1"}) + vertices("current", {"0 0", "1 0", "2 2", "0 1"});
    QCOMPARE(deformation(four), QStringLiteral("bend"));
    QCOMPARE(deformation(four + " ; barycage: deformation affine-fit\n"), QStringLiteral("affine_fit"));
    QCOMPARE(
        deformation(vertices("rest", {"0 0", "1 0", "0 1"}) + vertices("current", {"0 0", "1 0", "2 2"})),
        QStringLiteral("affine"));
}

void CliTest::factsOfTheFern() {
    const Result result = run({QStringLiteral("info"), QStringLiteral("systems.ifs"),
                               QStringLiteral("--entry"), QStringLiteral("fern"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonObject fern = entryOf(result);
    compare(fern[QLatin1String("mean")], 2659956.0 / 3338159, 20588360.0 / 3338159, 1e-11);
    compare(fern[QLatin1String("canonical_simplex")][QLatin1String("leg")].toDouble(), 10.793878466453615,
            1e-10);
    compare(fern[QLatin1String("affinity_dimension")].toDouble(), 1.834896, 3e-6);
    compare(fern[QLatin1String("maps")][0][QLatin1String("fixed_point")], 0, 0, 0);
    compare(fern[QLatin1String("maps")][1][QLatin1String("weight_in_file")].toDouble(), 0.85, 0);
}

void CliTest::factsInSpace() {
    const Result result = run({QStringLiteral("info"), QStringLiteral("-"), QStringLiteral("--json")},
                              "tetra (3D) {\n"
                              " .5 0 0 0 .5 0 0 0 .5 0 0 0 .25\n .5 0 0 0 .5 0 0 0 .5 .5 0 0 .25\n"
                              " .5 0 0 0 .5 0 0 0 .5 0 .5 0 .25\n .5 0 0 0 .5 0 0 0 .5 0 0 .5 .25\n}\n");
    QCOMPARE(result.status, 0);
    const QJsonObject tetra = entryOf(result);
    QCOMPARE(tetra[QLatin1String("dimension")].toInt(), 3);
    const QJsonValue hull = tetra[QLatin1String("hull")];
    QCOMPARE(hull[QLatin1String("vertices")].toArray().size(), 4);
    QCOMPARE(hull[QLatin1String("vertices")][0].toArray().size(), 3);
    compare(hull[QLatin1String("volume")].toDouble(), 1.0 / 6, 1e-11);
    QVERIFY(hull[QLatin1String("error")].toDouble(1) < 1e-10);
    const QJsonArray facets = hull[QLatin1String("facets")].toArray();
    QCOMPARE(facets.size(), 4);
    for (const QJsonValue& facet : facets) {
        QCOMPARE(facet.toArray().size(), 3);
        for (const QJsonValue& corner : facet.toArray())
            QVERIFY(corner.toInt(-1) >= 0 && corner.toInt() < 4);
    }
    QCOMPARE(tetra[QLatin1String("canonical_simplex")][QLatin1String("orientation")].toString(),
             QStringLiteral("+++"));
    compare(tetra[QLatin1String("similarity_dimension")].toDouble(), 2, 1e-12);
    compare(tetra[QLatin1String("affinity_dimension")].toDouble(), 2, 1e-12); // of similarities, the same
    QVERIFY(!hull.toObject().contains(QLatin1String("area")));
}

void CliTest::unknownFactsAreNull() {
    const Result result = run({QStringLiteral("info"), QStringLiteral("systems.ifs"),
                               QStringLiteral("--entry"), QStringLiteral("spin"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    const QJsonObject spin = entryOf(result);
    QCOMPARE(spin[QLatin1String("attractor")][QLatin1String("verdict")].toString(), QStringLiteral("none"));
    for (const char* key :
         {"mean", "covariance", "bounding_box", "canonical_simplex", "hull", "affinity_dimension"})
        QVERIFY2(spin.contains(QLatin1String(key)) && spin[QLatin1String(key)].isNull(), key);
    QVERIFY(!result.out.contains(": nan") && !result.out.contains(": inf"));
}

void CliTest::brokenEntries() {
    const Result result =
        run({QStringLiteral("info"), QStringLiteral("broken.ifs"), QStringLiteral("--json")});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.err.startsWith("broken.ifs:6:"), result.err.constData());
    const QJsonDocument json = QJsonDocument::fromJson(result.out);
    QCOMPARE(json[QLatin1String("problems")][0][QLatin1String("line")].toInt(), 6);
    QCOMPARE(json[QLatin1String("problems")][0][QLatin1String("severity")].toString(),
             QStringLiteral("error"));
    QCOMPARE(entryOf(result, 0)[QLatin1String("loaded")].toBool(), true);
    QCOMPARE(entryOf(result, 1)[QLatin1String("loaded")].toBool(true), false);
    // The first entry that can be read is drawn all the same; the broken one is not.
    const QStringList render{QStringLiteral("render"), QStringLiteral("broken.ifs"),
                             QStringLiteral("-o"),     QStringLiteral("broken.png"),
                             QStringLiteral("--size"), QStringLiteral("20x20")};
    QCOMPARE(run(render).status, 0);
    QFile::remove(path("broken.png"));
    QCOMPARE(run(render + QStringList{QStringLiteral("--entry"), QStringLiteral("bad")}).status, 1);
    QVERIFY(!QFile::exists(path("broken.png")));
}

void CliTest::standardInput() {
    const Result result =
        run({QStringLiteral("info"), QStringLiteral("-"), QStringLiteral("--json")}, systems);
    QCOMPARE(result.status, 0);
    const QJsonDocument json = QJsonDocument::fromJson(result.out);
    QCOMPARE(json[QLatin1String("file")].toString(), QStringLiteral("-"));
    QCOMPARE(json[QLatin1String("entries")].toArray().size(), 3);
}

void CliTest::sameBytesForAnyThreads() {
    for (const char* algorithm : {"density", "chaos-game"}) {
        QByteArray first;
        for (const char* threads : {"1", "2", "3"}) {
            const Result result =
                run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                     QStringLiteral("threads.png"), QStringLiteral("--size"), QStringLiteral("160x120"),
                     QStringLiteral("--seed"), QStringLiteral("7"), QStringLiteral("--points"),
                     QStringLiteral("5000000"), QStringLiteral("--threads"), QLatin1String(threads),
                     QStringLiteral("--algorithm"), QLatin1String(algorithm)});
            QCOMPARE(result.status, 0);
            QVERIFY(result.err.isEmpty());
            const QByteArray bytes = read("threads.png");
            QVERIFY(!bytes.isEmpty());
            if (first.isEmpty()) first = bytes;
            QVERIFY(bytes == first);
        }
    }
}

void CliTest::pictureReopens_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("png") << QStringLiteral("picture.png");
    QTest::newRow("svg") << QStringLiteral("picture.svg");
}

void CliTest::pictureReopens() {
    QFETCH(QString, file);
    QCOMPARE(run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("--entry"),
                  QStringLiteral("fern"), QStringLiteral("-o"), file, QStringLiteral("--size"),
                  QStringLiteral("90x90")})
                 .status,
             0);
    const Result result = run({QStringLiteral("info"), file, QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    QCOMPARE(entryOf(result)[QLatin1String("name")].toString(), QStringLiteral("Fern"));
    compare(entryOf(result)[QLatin1String("mean")], 2659956.0 / 3338159, 20588360.0 / 3338159, 1e-11);
}

void CliTest::viewShowsTheWholeAttractor() {
    QCOMPARE(run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                  QStringLiteral("fit.png"), QStringLiteral("--size"), QStringLiteral("200x200"),
                  QStringLiteral("--colour"), QStringLiteral("none"), QStringLiteral("--background"),
                  QStringLiteral("transparent"), QStringLiteral("--dpi"), QStringLiteral("254")})
                 .status,
             0);
    const QImage picture(path("fit.png"));
    QCOMPARE(picture.dotsPerMeterX(), 10000);
    QRect lit;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (qAlpha(picture.pixel(x, y)) > 0) lit |= QRect(x, y, 1, 1);
    // The maple is taller than wide: 5 % above and below, centred.
    QVERIFY(std::abs(lit.top() - 10) <= 2);
    QVERIFY(std::abs(picture.height() - 1 - lit.bottom() - 10) <= 2);
    QVERIFY(std::abs(lit.left() + lit.right() - picture.width()) <= 4);
}

void CliTest::cageMovesThePicture() {
    const QStringList common{QStringLiteral("render"),   QStringLiteral("systems.ifs"),
                             QStringLiteral("--size"),   QStringLiteral("120x120"),
                             QStringLiteral("--colour"), QStringLiteral("none"),
                             QStringLiteral("-o")};
    // Mirroring the cage and looking at it mirrored gives the same silhouette upside down.
    QCOMPARE(run(common +
                 QStringList{QStringLiteral("up.png"), QStringLiteral("--view"), QStringLiteral("0,1,10")})
                 .status,
             0);
    QCOMPARE(run(common + QStringList{QStringLiteral("down.png"), QStringLiteral("--view"),
                                      QStringLiteral("0,-1,10"), QStringLiteral("--rest-cage"),
                                      QStringLiteral("0,0 1,0 0,1"), QStringLiteral("--cage"),
                                      QStringLiteral("0,0 1,0 0,-1")})
                 .status,
             0);
    const QImage up = QImage(path("up.png")).mirrored();
    const QImage down(path("down.png"));
    int different = 0;
    for (int y = 0; y < up.height(); ++y)
        for (int x = 0; x < up.width(); ++x)
            different += std::abs(qGray(up.pixel(x, y)) - qGray(down.pixel(x, y))) > 60;
    QVERIFY2(different < 150, qPrintable(QString::number(different)));
    QVERIFY(QImage(path("up.png")) != down);
}

void CliTest::restCagesAroundTheAttractor_data() {
    QTest::addColumn<QString>("rest");
    for (const char* rest : {"canonical", "box", "hull", "hull:4"})
        QTest::newRow(rest) << QString::fromLatin1(rest);
}

// A cage at rest leaves the picture as it is, whatever holds it.
void CliTest::restCagesAroundTheAttractor() {
    QFETCH(QString, rest);
    const QStringList common{QStringLiteral("render"), QStringLiteral("systems.ifs"),
                             QStringLiteral("--size"), QStringLiteral("60x60"), QStringLiteral("-o")};
    QCOMPARE(run(common + QStringList{QStringLiteral("plain.png")}).status, 0);
    QCOMPARE(
        run(common + QStringList{QStringLiteral("held.png"), QStringLiteral("--rest-cage"), rest}).status, 0);
    QCOMPARE(QImage(path("held.png")), QImage(path("plain.png")));
}

void CliTest::cageOfManyCornersBendsThePicture() {
    const auto render = [this](const QString& file, const QString& rest, const QString& cage) {
        return run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("--size"),
                    QStringLiteral("150x150"), QStringLiteral("--colour"), QStringLiteral("none"),
                    QStringLiteral("--view"), QStringLiteral("0,1,14"), QStringLiteral("--rest-cage"), rest,
                    QStringLiteral("--cage"), cage, QStringLiteral("-o"), file});
    };
    const QString square = QStringLiteral("-6,-6 6,-6 6,7 -6,7");
    const auto difference = [this](const char* a, const char* b) {
        const QImage first(path(a));
        const QImage second(path(b));
        int different = 0;
        for (int y = 0; y < first.height(); ++y)
            for (int x = 0; x < first.width(); ++x)
                different += std::abs(qGray(first.pixel(x, y)) - qGray(second.pixel(x, y))) > 60;
        return different;
    };
    QCOMPARE(render(QStringLiteral("t.png"), QStringLiteral("0,0 1,0 0,1"), QStringLiteral("1,0 2,0.5 1,1"))
                 .status,
             0);
    // The same shear by (1, 0) + (x, y + x/2) of four corners, then one of them pulled away.
    QCOMPARE(render(QStringLiteral("q.png"), square, QStringLiteral("-5,-9 7,-3 7,10 -5,4")).status, 0);
    QCOMPARE(render(QStringLiteral("b.png"), square, QStringLiteral("-5,-9 7,-3 4,5 -5,4")).status, 0);
    QVERIFY(difference("t.png", "q.png") < 200);
    QVERIFY(difference("b.png", "q.png") > 800);
    QCOMPARE(render(QStringLiteral("x.png"), QStringLiteral("0,0 1,1 1,0 0,1"), square).status, 2);
    const auto svg =
        run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("--rest-cage"),
             QStringLiteral("box"), QStringLiteral("--cage"), QStringLiteral("-3,-3 3,-3 5,5 -3,5"),
             QStringLiteral("-o"), QStringLiteral("b.svg")});
    QCOMPARE(svg.status, 0);
    QVERIFY2(svg.err.contains("affine fit"), svg.err.constData());
}

void CliTest::copyKeepsEveryByte() {
    QCOMPARE(
        run({QStringLiteral("convert"), QStringLiteral("broken.ifs"), QStringLiteral("copy.ifs")}).status, 0);
    QCOMPARE(read("copy.ifs"), read("broken.ifs"));
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("one.ifs"),
                  QStringLiteral("--entry"), QStringLiteral("fern")})
                 .status,
             0);
    QVERIFY(read("one.ifs").contains("Fern { ; Barnsley\n 0 0 0 0.16 0 0 .01\n"));
    QVERIFY(!read("one.ifs").contains("maple"));
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("broken.ifs"), QStringLiteral("strict.ifs"),
                  QStringLiteral("--strict")})
                 .status,
             1);
    QVERIFY(!QFile::exists(path("strict.ifs")));
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("strict.ifs"),
                  QStringLiteral("--strict")})
                 .status,
             0);
    QVERIFY(read("strict.ifs").contains("maple {\n"));
}

// T∘w∘T⁻¹ for the stored cage, a translation by (1, 2): the mean moves along.
void CliTest::bakedCodeDrawsTheSame() {
    QCOMPARE(run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                  QStringLiteral("moved.svg"), QStringLiteral("--rest-cage"), QStringLiteral("0,0 1,0 0,1"),
                  QStringLiteral("--cage"), QStringLiteral("1,2 2,2 1,3"), QStringLiteral("--depth"),
                  QStringLiteral("1")})
                 .status,
             0);
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("moved.svg"), QStringLiteral("baked.ifs"),
                  QStringLiteral("--bake")})
                 .status,
             0);
    const Result result =
        run({QStringLiteral("info"), QStringLiteral("baked.ifs"), QStringLiteral("--json")});
    QCOMPARE(result.status, 0);
    compare(entryOf(result)[QLatin1String("mean")], 1 + 5135.0 / 70583, 2 + 101021.0 / 70583, 1e-11);
}

void CliTest::convertsThereAndBack_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("there");
    QTest::addColumn<QStringList>("back");
    QTest::newRow("flame") << QStringLiteral("fern.flame") << QStringList() << QStringList();
    QTest::newRow("flame, y down") << QStringLiteral("down.flame")
                                   << QStringList{QStringLiteral("--y-as-written")}
                                   << QStringList{QStringLiteral("--y-as-written")};
    QTest::newRow("csv") << QStringLiteral("fern.csv") << QStringList() << QStringList();
    QTest::newRow("tsv") << QStringLiteral("fern.tsv")
                         << QStringList{QStringLiteral("--columns"), QStringLiteral("abecdfp")}
                         << QStringList{QStringLiteral("--in-columns"), QStringLiteral("a b e c d f p")};
}

// .ifs → another form → .ifs: the same numbers, to the last digit.
void CliTest::convertsThereAndBack() {
    QFETCH(QString, file);
    QFETCH(QStringList, there);
    QFETCH(QStringList, back);
    const auto convert = [this](const QString& in, const QString& out, const QStringList& options) {
        return run(QStringList{QStringLiteral("convert"), in, out} + options).status;
    };
    const QStringList only{QStringLiteral("--entry"), QStringLiteral("fern")};
    QCOMPARE(convert(QStringLiteral("systems.ifs"), file, there + only), 0);
    QCOMPARE(convert(file, QStringLiteral("back.ifs"), back), 0);
    const auto maps = [this](const char* name, const QStringList& options) {
        const Result result =
            run(QStringList{QStringLiteral("info"), QLatin1String(name), QStringLiteral("--json")} + options);
        return entryOf(result)[QLatin1String("maps")].toArray();
    };
    const QJsonArray before = maps("systems.ifs", only);
    const QJsonArray after = maps("back.ifs", {});
    QCOMPARE(before.size(), 4);
    QCOMPARE(after.size(), 4);
    for (int i = 0; i < 4; ++i)
        for (const char* key : {"linear", "translation", "weight_in_file"})
            QVERIFY2(before[i][QLatin1String(key)] == after[i][QLatin1String(key)], key);
}

void CliTest::convertsManyFilesIntoAFolder() {
    const QStringList convert{QStringLiteral("convert"), QStringLiteral("systems.ifs"),
                              QStringLiteral("broken.ifs")};
    QCOMPARE(run(convert + QStringList{QStringLiteral("one.flame")}).status, 2);
    QCOMPARE(run(convert + QStringList{QStringLiteral("many/")}).status, 2);
    QVERIFY(!QFile::exists(path("many")));
    const Result result =
        run(convert + QStringList{QStringLiteral("many/"), QStringLiteral("--to"), QStringLiteral("aifs")});
    QCOMPARE(result.status, 1); // the second file has a broken entry
    QVERIFY2(result.err.contains("broken.ifs:6:"), result.err.constData());
    QVERIFY(read("many/systems.aifs").contains("@spin:\n$dim=2\n"));
    QVERIFY(!QFile::exists(path("many/broken.aifs")));
    // A table holds one system: one file for each, or none.
    QCOMPARE(
        run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("all.csv")}).status, 1);
    QVERIFY(!QFile::exists(path("all.csv")));
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("many"),
                  QStringLiteral("--to"), QStringLiteral("csv")})
                 .status,
             0);
    QVERIFY(read("many/systems-Fern.csv").startsWith("a,b,c,d,e,f,p\n0,0,0,0.16,0,0,0.01\n"));
    QVERIFY(QFile::exists(path("many/systems-maple.csv")));
}

void CliTest::writesPoints() {
    const QStringList points{QStringLiteral("convert"),  QStringLiteral("systems.ifs"),
                             QStringLiteral("--entry"),  QStringLiteral("fern"),
                             QStringLiteral("--points"), QStringLiteral("500")};
    QCOMPARE(run(points + QStringList{QStringLiteral("points.csv")}).status, 0);
    QCOMPARE(read("points.csv").count('\n'), 501);
    QCOMPARE(
        run(points + QStringList{QStringLiteral("points.ply"), QStringLiteral("--seed"), QStringLiteral("9")})
            .status,
        0);
    QVERIFY(read("points.ply").contains("element vertex 500\n"));
    QCOMPARE(run(points + QStringList{QStringLiteral("points.flame")}).status, 2);
    QCOMPARE(
        run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("none.ply")}).status,
        2);
    QVERIFY(!QFile::exists(path("none.ply")));
}

void CliTest::parameterFilesBecomeCollections() {
    write("old.par", "view { ; a picture\n type=ifs ifs=leaf\n}\nifs:leaf { ; by hand\n"
                     " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    QCOMPARE(run({QStringLiteral("convert"), QStringLiteral("old.par"), QStringLiteral("leaf.ifs")}).status,
             0);
    const QByteArray bytes = read("leaf.ifs");
    QVERIFY2(bytes.startsWith("leaf { ; by hand\n"), bytes.constData());
    QVERIFY(!bytes.contains("type=ifs"));
}

void CliTest::drawsShapes() {
    const QStringList render{QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o")};
    QCOMPARE(run(render + QStringList{QStringLiteral("outline.svg"), QStringLiteral("--svg"),
                                      QStringLiteral("outline")})
                 .status,
             0);
    QCOMPARE(read("outline.svg").count("<path"), 1);
    QCOMPARE(
        run(render + QStringList{QStringLiteral("points.svg"), QStringLiteral("--svg"),
                                 QStringLiteral("points"), QStringLiteral("--points"), QStringLiteral("700")})
            .status,
        0);
    QCOMPARE(read("points.svg").count("h0"), 700);
    QCOMPARE(
        run(render + QStringList{QStringLiteral("maple.pdf"), QStringLiteral("--depth"), QStringLiteral("3")})
            .status,
        0);
    QVERIFY(read("maple.pdf").startsWith("%PDF-1."));
    // A format may be named where the name of the file does not tell it.
    QCOMPARE(
        run(render + QStringList{QStringLiteral("thumbnail"), QStringLiteral("--to"), QStringLiteral("png"),
                                 QStringLiteral("--size"), QStringLiteral("64x64")})
            .status,
        0);
    QCOMPARE(QImage(path("thumbnail"), "PNG").size(), QSize(64, 64));
    QCOMPARE(
        run(render + QStringList{QStringLiteral("a.svg"), QStringLiteral("--points"), QStringLiteral("9")})
            .status,
        2);
    QCOMPARE(
        run({QStringLiteral("convert"), QStringLiteral("systems.ifs"), QStringLiteral("all.pdf")}).status, 0);
    QVERIFY(read("all.pdf").contains("/Count 2/")); // the third has no attractor
}

void CliTest::drawsAGallery() {
    const QStringList gallery{QStringLiteral("gallery"),  QStringLiteral("systems.ifs"),
                              QStringLiteral("-o"),       QStringLiteral("sheet.png"),
                              QStringLiteral("--tile"),   QStringLiteral("100x80"),
                              QStringLiteral("--columns")};
    const Result first = run(gallery + QStringList{QStringLiteral("3")});
    QCOMPARE(first.status, 0);
    QVERIFY2(first.err.isEmpty(), first.err.constData());
    const QImage wide(path("sheet.png"));
    QCOMPARE(
        run(gallery + QStringList{QStringLiteral("1"), QStringLiteral("--paper"), QStringLiteral("light"),
                                  QStringLiteral("--title"), QStringLiteral("Leaves")})
            .status,
        0);
    const QImage tall(path("sheet.png"));
    QVERIFY(wide.width() > 300 && wide.height() > 80 && wide.height() < 160);
    QVERIFY(tall.width() > 100 && tall.width() < 160 && tall.height() > 300);
    QVERIFY(qGray(wide.pixel(1, 1)) < 30 && qGray(tall.pixel(1, 1)) > 230);
    // The maple is drawn in the first place, and its name under it.
    const auto inkIn = [&tall](const QRect& part) {
        int pixels = 0;
        for (int y = part.top(); y <= part.bottom(); ++y)
            for (int x = part.left(); x <= part.right(); ++x)
                pixels += qGray(tall.pixel(x, y)) < 120;
        return pixels;
    };
    QVERIFY(inkIn(tall.rect()) > 3 * 1000);
    QCOMPARE(run({QStringLiteral("gallery"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                  QStringLiteral("sheet.jpg")})
                 .status,
             2);
    QCOMPARE(run({QStringLiteral("gallery"), QStringLiteral("absent.ifs"), QStringLiteral("-o"),
                  QStringLiteral("none.png")})
                 .status,
             3);
    QVERIFY(!QFile::exists(path("none.png")));
}

void CliTest::instructionSetsGiveTheSameBytes() {
    const auto drawn = [this](const char* set) {
        const Result result = run({QStringLiteral("render"), QStringLiteral("systems.ifs"),
                                   QStringLiteral("-o"), QStringLiteral("set.png"), QStringLiteral("--size"),
                                   QStringLiteral("100x80"), QStringLiteral("--simd"), QLatin1String(set)});
        if (result.status == 0) return read("set.png");
        if (result.status != 2 || !result.err.contains("scalar")) return QByteArray("wrong message");
        return QByteArray();
    };
    const QByteArray scalar = drawn("scalar");
    QVERIFY(scalar.size() > 100);
    int possible = 0;
    for (const char* set : {"sse4", "avx2", "avx3", "neon"}) {
        const QByteArray bytes = drawn(set);
        if (bytes.isEmpty()) continue; // not here, said with the list of what is
        QVERIFY2(bytes == scalar, set);
        ++possible;
    }
    QVERIFY(possible >= 1 && possible <= 3); // no machine has both families
}

void CliTest::pictureOptionsCount() {
    write("p.gpl", "GIMP Palette\n0 0 60\n255 0 0\n");
    write("bad.map", "0 60 0\nnonsense\n0 255 0\n");
    QList<QImage> pictures;
    const auto draw = [&](const QStringList& options) {
        const Result result =
            run(QStringList{QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                            QStringLiteral("o.png"), QStringLiteral("--size"), QStringLiteral("90x80"),
                            QStringLiteral("--background"), QStringLiteral("black")} +
                options);
        pictures << QImage(path("o.png"));
        return result;
    };
    QCOMPARE(run({QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                  QStringLiteral("paper.png"), QStringLiteral("--size"), QStringLiteral("90x80"),
                  QStringLiteral("--colour"), QStringLiteral("none"), QStringLiteral("--background"),
                  QStringLiteral("white")})
                 .status,
             0);
    const QImage paper(path("paper.png"));
    int dark = 0;
    for (int y = 0; y < paper.height(); ++y)
        for (int x = 0; x < paper.width(); ++x)
            dark += qGray(paper.pixel(x, y)) < 100;
    QVERIFY(dark > 100);
    for (const char* colour : {"density", "map", "address", "none"})
        QCOMPARE(draw({QStringLiteral("--colour"), QLatin1String(colour)}).status, 0);
    QCOMPARE(draw({QStringLiteral("--supersample"), QStringLiteral("3")}).status, 0);
    QCOMPARE(draw({QStringLiteral("--palette"), QStringLiteral("ink")}).status, 0);
    QCOMPARE(draw({QStringLiteral("--palette"), QStringLiteral("p.gpl")}).status, 0);
    const QImage red = pictures.back();
    const Result remarked = draw({QStringLiteral("--palette"), QStringLiteral("bad.map")});
    QCOMPARE(remarked.status, 0);
    QVERIFY(remarked.err.contains("bad.map:2:1: warning: "));
    for (qsizetype i = 0; i < pictures.size(); ++i)
        for (qsizetype k = 0; k < i; ++k)
            QVERIFY(pictures[i] != pictures[k]);
    for (int y = 0; y < red.height(); ++y)
        for (int x = 0; x < red.width(); ++x)
            QCOMPARE(qGreen(red.pixel(x, y)), 0);
    QCOMPARE(
        draw({QStringLiteral("--bits"), QStringLiteral("16"), QStringLiteral("--dpi"), QStringLiteral("254")})
            .status,
        0);
    QCOMPARE(pictures.back().depth(), 64);
    QCOMPARE(pictures.back().dotsPerMeterX(), 10000);
}

void CliTest::interruptLeavesNothing() {
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(QStringLiteral(BARYCAGE_CLI),
                  {QStringLiteral("render"), QStringLiteral("systems.ifs"), QStringLiteral("-o"),
                   QStringLiteral("never.png"), QStringLiteral("--points"), QStringLiteral("1000000000000"),
                   QStringLiteral("--progress"), QStringLiteral("always")});
    QVERIFY(process.waitForStarted());
    process.setReadChannel(QProcess::StandardError);
    QTRY_VERIFY_WITH_TIMEOUT(process.waitForReadyRead(100) || process.bytesAvailable() > 0, 30'000);
    process.terminate();
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(!QFile::exists(path("never.png")));
}

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
