// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRandomGenerator>
#include <QTest>

// barycage-cli animate, and --frame of info and render.
class CliAnimateTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void infoSaysWhatMoves();
    void factsAreThoseOfTheFrame();
    void frameLIsFrame0();
    void framesOutsideAreRefused();
    void aMorphReplacesNothingElse();
    void aFrameAloneIsTheFrameOfTheSequence();
    void picturesCarryTheAnimation();
    void renderDrawsTheSamePixels();
    void chunksShareTheFrames();
    void listsNameFiles();
    void completeFramesAreSkipped();
    void staleAndDamagedFramesAreDrawnAgain();
    void existingFilesCanBeReplacedOrRefused();
    void replacedFilesAreSaid();
    void keysMoveTheCamera();
    void keysMoveTheCameraInSpace();
    void spaceMoves();
    void aShutterBlursWhatMoves();
    void aShutterBlursSolids();
    void exposureIsAFunctionOfTheAnimation();
    void aMomentWithoutAttractorIsNamed();
    void framesWithoutAttractorAreOneWarning();
    void framesWithoutAttractorDoNotSetTheView();
    void theFolderIsMade();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
    void killedAtAnyTimeLeavesWholeFiles();

private:
    QStringList files(const QByteArray& folder) const {
        return QDir(path(folder)).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    QByteArray text(const QByteArray& file, const QString& key) const {
        return QImage(path(file)).text(key).toUtf8();
    }
};

namespace {

constexpr const char* smallAnimation = " --size 48x36 --points 20000 ";

QByteArray animated(const QByteArray& name, const QByteArray& header) {
    return name + " {\n; barycage: animation " + header +
           "\n; barycage: track map 2\n; barycage: key 0 both\n; barycage: value 0.61 0 0 0.31 0.07 3.5 .25\n"
           "; barycage: key 4 linear\n; barycage: value 0.5 0.2 -0.2 0.4 0 3 .3\n"
           "; barycage: motion sway\n; barycage: strength 4\n; barycage: pivot 0 0\n"
           "; barycage: wave 1\n; barycage: value 1 0 25\n"
           " -0.04 0 -0.23 -0.65 -0.08 0.26 .25\n 0.61 0 0 0.31 0.07 3.5 .25\n"
           " 0.65 0.29 -0.3 0.48 0.74 0.39 .25\n 0.64 -0.3 0.16 0.56 -0.56 0.60 .25\n}\n";
}

} // namespace

void CliAnimateTest::init() {
    write("wind.ifs", "still {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n" +
                          animated("wind", "6 24/1 cycle") + animated("once", "6 30/1 off") +
                          animated("back", "6 30/1 there-and-back"));
    for (const char* folder : {"a", "b", "c", "d"}) {
        QDir(path(folder)).removeRecursively();
        QDir().mkpath(path(folder));
    }
}

void CliAnimateTest::infoSaysWhatMoves() {
    const Result result = run("info --json wind.ifs");
    QCOMPARE(result.status, 0);
    QVERIFY(result.entry(0)[QLatin1String("animation")].isNull());
    const QJsonObject animation = result.entry(1)[QLatin1String("animation")].toObject();
    QCOMPARE(animation, (QJsonObject{{QStringLiteral("fps"), QStringLiteral("24/1")},
                                     {QStringLiteral("frames"), 6},
                                     {QStringLiteral("loop"), QStringLiteral("cycle")},
                                     {QStringLiteral("tracks"), 1}}));
    // As many as animate draws.
    QVERIFY(run("info wind.ifs --entry wind").out.contains("frames: 6,"));
    QVERIFY(run("info wind.ifs --entry once").out.contains("frames: 7,"));
    QVERIFY(run("info wind.ifs --entry back").out.contains("frames: 12,"));
    // What there is none of is left out.
    QVERIFY(run("info wind.ifs --entry wind").out.contains("; tracks: 1, motions: 1\n"));
    write("swaying.ifs", "sway {\n; barycage: animation 6 24/1 cycle\n; barycage: motion sway\n"
                         "; barycage: strength 4\n; barycage: pivot 0 0\n; barycage: wave 1\n"
                         "; barycage: value 1 0 25\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    QVERIFY(run("info swaying.ifs").out.contains("in a cycle; motions: 1\n"));
    QCOMPARE(run(QByteArray("animate wind.ifs --entry once -o a/#.png") + smallAnimation).status, 0);
    QCOMPARE(files("a").size(), 7);
    QCOMPARE(run(QByteArray("animate wind.ifs --entry back -o b/##.png") + smallAnimation).status, 0);
    QCOMPARE(files("b").size(), 12);
}

void CliAnimateTest::factsAreThoseOfTheFrame() {
    const Result key = run("info --json wind.ifs --entry once --frame 4");
    QCOMPARE(key.status, 0);
    const QJsonObject map = key.entry()[QLatin1String("maps")][1].toObject();
    QCOMPARE(map[QLatin1String("weight_in_file")].toDouble(), 0.3);
    QVERIFY(!key.entry()[QLatin1String("animation")].isNull());
    const Result still = run("info --json wind.ifs --entry still --frame 4");
    QCOMPARE(still.out, run("info --json wind.ifs --entry still").out);
    QVERIFY2(still.err.contains("“still” has no animation"), still.err.constData());
    QCOMPARE(key.err, QByteArray());
    QCOMPARE(run("info --json wind.ifs --entry once --frame 2.5").out,
             run("info --json wind.ifs --entry once --frame 5/2").out);
    QVERIFY(run("info --json wind.ifs --entry once --frame 2.5").out != key.out);
}

void CliAnimateTest::frameLIsFrame0() {
    QCOMPARE(run("info --json wind.ifs --entry wind --frame 6").out,
             run("info --json wind.ifs --entry wind --frame 0").out);
    QCOMPARE(run("info --json wind.ifs --entry back --frame 12").out,
             run("info --json wind.ifs --entry back --frame 0").out);
    QVERIFY(run("info --json wind.ifs --entry once --frame 6").out !=
            run("info --json wind.ifs --entry once --frame 0").out);
}

void CliAnimateTest::framesOutsideAreRefused() {
    const Result result = run("info wind.ifs --entry once --entry still --frame 6.5");
    QCOMPARE(result.status, 1);
    QVERIFY(result.err.contains("frames 0 to 6"));
    QVERIFY(result.out.startsWith("still"));
    QVERIFY(!result.out.contains("once"));
    QCOMPARE(run("render wind.ifs --entry wind --frame 7 -o x.png").status, 2);
    QCOMPARE(run("render wind.ifs --entry wind --frame -1 -o x.png").status, 2);
    const Result still =
        run(QByteArray("render wind.ifs --entry still --frame 3 -o still.png") + smallAnimation);
    QCOMPARE(still.status, 0);
    QVERIFY(still.err.contains("no animation"));
}

void CliAnimateTest::aMorphReplacesNothingElse() {
    const QByteArray before = read("wind.ifs");
    QVERIFY(!before.isEmpty());
    const QByteArray morph = "morph wind.ifs --from still --to wind -o ";
    for (const char* output : {"wind.ifs", "./wind.ifs", "morph.png", "morph"}) {
        QCOMPARE(run(morph + output).status, 2);
        QCOMPARE(read("wind.ifs"), before);
        QVERIFY(!QFile::exists(path("morph.png")) && !QFile::exists(path("morph")));
    }
    QCOMPARE(run(morph + "morph.IFS").status, 0);
    QVERIFY(read("morph.IFS").contains("animation"));
}

void CliAnimateTest::aFrameAloneIsTheFrameOfTheSequence() {
    QCOMPARE(run(QByteArray("animate wind.ifs -o a/f.####.png") + smallAnimation).status, 0);
    QCOMPARE(files("a").size(), 6);
    QCOMPARE(files("a").first(), QStringLiteral("f.0001.png"));
    for (int number = 1; number <= 6; ++number) {
        const QByteArray name = "f.000" + QByteArray::number(number) + ".png";
        QCOMPARE(run("animate wind.ifs -o b/f.####.png --threads 1 --frames " + QByteArray::number(number) +
                     smallAnimation)
                     .status,
                 0);
        QVERIFY(!read("a/" + name).isEmpty());
        QCOMPARE(read("b/" + name), read("a/" + name));
    }
    QVERIFY(read("a/f.0001.png") != read("a/f.0002.png"));
    QCOMPARE(run(QByteArray("animate wind.ifs --entry once -o c/f.#.png") + smallAnimation).status, 0);
    QCOMPARE(files("c").size(), 7);
    QCOMPARE(run(QByteArray("animate wind.ifs --entry back -o d/f.###.png") + smallAnimation).status, 0);
    QCOMPARE(files("d").size(), 12);
    QCOMPARE(QImage(path("d/f.002.png")), QImage(path("d/f.012.png")));
}

void CliAnimateTest::picturesCarryTheAnimation() {
    QCOMPARE(run(QByteArray("animate wind.ifs -o a/f.#.png --frames 3") + smallAnimation).status, 0);
    QCOMPARE(text("a/f.3.png", QStringLiteral("barycage:request")).size(), 64);
    const QJsonObject entry = run("info --json a/f.3.png").entry();
    QCOMPARE(entry[QLatin1String("animation")][QLatin1String("frames")].toInt(), 6);
    QCOMPARE(entry[QLatin1String("maps")],
             run("info --json wind.ifs --entry wind").entry()[QLatin1String("maps")]);
}

void CliAnimateTest::renderDrawsTheSamePixels() {
    QCOMPARE(
        run(QByteArray("animate wind.ifs -o a/f.#.png --frames 4 --exposure each") + smallAnimation).status,
        0);
    QCOMPARE(run(QByteArray("render wind.ifs --entry wind --frame 3 -o a/r.png") + smallAnimation).status, 0);
    QVERIFY(!QImage(path("a/r.png")).isNull());
    QCOMPARE(QImage(path("a/r.png")).convertToFormat(QImage::Format_RGB32),
             QImage(path("a/f.4.png")).convertToFormat(QImage::Format_RGB32));
}

void CliAnimateTest::chunksShareTheFrames() {
    QCOMPARE(run(QByteArray("animate wind.ifs --entry back -o a/f.##.png") + smallAnimation).status, 0);
    for (const char* chunk : {"4/5", "0/5", "2/5", "1/5", "3/5"}) {
        const int before = int(files("b").size());
        QCOMPARE(
            run(QByteArray("animate wind.ifs --entry back -o b/f.##.png --chunk ") + chunk + smallAnimation)
                .status,
            0);
        QVERIFY(files("b").size() - before == 2 || files("b").size() - before == 3);
    }
    QCOMPARE(files("b"), files("a"));
    for (const QString& file : files("a"))
        QCOMPARE(read("b/" + file.toUtf8()), read("a/" + file.toUtf8()));
}

void CliAnimateTest::listsNameFiles() {
    const Result result =
        run(QByteArray("animate wind.ifs -o a/f.#.png --frames 1-5x2,4,90-95") + smallAnimation);
    QCOMPARE(result.status, 0);
    QCOMPARE(files("a"), (QStringList{QStringLiteral("f.1.png"), QStringLiteral("f.3.png"),
                                      QStringLiteral("f.4.png"), QStringLiteral("f.5.png")}));
    QVERIFY(result.err.contains("has the number 6;"));
    const Result none = run(QByteArray("animate wind.ifs -o b/f.#.png --frames 7") + smallAnimation);
    QCOMPARE(none.status, 0);
    QVERIFY(files("b").isEmpty() && !none.err.isEmpty());
    const Result few =
        run(QByteArray("animate wind.ifs -o b/f.#.png --frames 2 --chunk 3/4") + smallAnimation);
    QCOMPARE(few.status, 0);
    QVERIFY(files("b").isEmpty());
}

void CliAnimateTest::completeFramesAreSkipped() {
    const QByteArray command = QByteArray("animate wind.ifs -o a/f.#.png --frames 1-2") + smallAnimation;
    QCOMPARE(run(command).status, 0);
    const auto stamp = [this] { return QFileInfo(path("a/f.1.png")).lastModified(); };
    makeOld("a/f.1.png");
    const QDateTime before = stamp();
    QCOMPARE(run(command + "--threads 1 --simd scalar").status, 0);
    QCOMPARE(stamp(), before); // neither threads nor instructions are part of the request
    QCOMPARE(run(command + "--existing replace").status, 0);
    QVERIFY(stamp() != before);
}

void CliAnimateTest::staleAndDamagedFramesAreDrawnAgain() {
    const QByteArray command = QByteArray("animate wind.ifs -o a/f.#.png --frames 1") + smallAnimation;
    QCOMPARE(run(command).status, 0);
    const QByteArray whole = read("a/f.1.png");
    QByteArray flipped = whole;
    flipped[whole.size() / 2] = char(flipped[whole.size() / 2] ^ 1);
    for (const QByteArray& damaged :
         {whole.first(whole.size() - 1), whole.first(whole.size() / 2), whole.first(8), QByteArray(), flipped,
          whole + '\n', whole.first(whole.size() - 12)}) {
        write("a/f.1.png", damaged);
        QCOMPARE(run(command).status, 0);
        QCOMPARE(read("a/f.1.png"), whole);
    }
    const QByteArray more =
        QByteArray("animate wind.ifs -o a/f.#.png --frames 1 --size 48x36 --points 20001");
    QCOMPARE(run(more).status, 0);
    QVERIFY(read("a/f.1.png") != whole);
    QCOMPARE(run(command).status, 0);
    // Another request by its options, by its frame or by its entry.
    for (const char* option :
         {"--seed 2", "--gamma 3", "--contrast 2", "--vibrancy 0.5", "--margin 6", "--background black",
          "--palette Fern", "--bits 16", "--supersample 2", "--shutter 180", "--exposure each"}) {
        QCOMPARE(run(command + option).status, 0);
        QVERIFY2(read("a/f.1.png") != whole, option);
        QCOMPARE(run(command).status, 0);
        QCOMPARE(read("a/f.1.png"), whole);
    }
    QCOMPARE(run(QByteArray("animate wind.ifs -o b/f.#.png --frames 2") + smallAnimation).status, 0);
    write("a/f.1.png", read("b/f.2.png"));
    QCOMPARE(run(command).status, 0);
    QCOMPARE(read("a/f.1.png"), whole);
    write("wind.ifs", read("wind.ifs").replace("strength 4", "strength 5"));
    QCOMPARE(run(command).status, 0);
    QVERIFY(read("a/f.1.png") != whole);
}

void CliAnimateTest::existingFilesCanBeReplacedOrRefused() {
    write("a/f.2.png", "mine");
    const Result result = run(QByteArray("animate wind.ifs -o a/f.#.png --existing fail") + smallAnimation);
    QCOMPARE(result.status, 3);
    QVERIFY(result.err.contains("f.2.png"));
    QCOMPARE(files("a").size(), 1);
    QCOMPARE(read("a/f.2.png"), QByteArray("mine"));
    QCOMPARE(
        run(QByteArray("animate wind.ifs -o a/f.#.png --existing fail --frames 1") + smallAnimation).status,
        0);
    QCOMPARE(run(QByteArray("animate wind.ifs -o a/f.#.png --existing replace --frames 2") + smallAnimation)
                 .status,
             0);
    QVERIFY(read("a/f.2.png") != "mine");
}

void CliAnimateTest::replacedFilesAreSaid() {
    const QByteArray command = QByteArray("animate wind.ifs -o a/f.#.png") + smallAnimation;
    write("a/f.2.png", "mine");
    const Result one = run(command);
    QCOMPARE(one.status, 0);
    QVERIFY2(one.err.contains("1 existing file ") && one.err.contains("number 2."), one.err.constData());
    QCOMPARE(run(command).err, QByteArray()); // all are its own now
    const Result all = run(command + "--seed 2");
    QCOMPARE(all.status, 0);
    QVERIFY2(all.err.contains("6 existing files ") && all.err.contains("numbers 1–6."), all.err.constData());
    QCOMPARE(run(command + "--existing replace").err, QByteArray()); // as it was told
}

void CliAnimateTest::keysMoveTheCamera() {
    write("zoom.ifs", "zoom {\n; barycage: animation 2 24/1 off\n; barycage: track camera\n"
                      "; barycage: key 0 linear\n; barycage: value 0 0 1 1\n"
                      "; barycage: key 2 linear\n; barycage: value 3 0 4 1\n"
                      " .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n .5 0 0 .5 0 .5 .5\n}\n");
    QCOMPARE(run(QByteArray("animate zoom.ifs -o a/f.#.png --exposure each") + smallAnimation).status, 0);
    // Half way, a third of the way, at twice the height.
    QCOMPARE(run(QByteArray("render zoom.ifs --view 1,0,2 -o a/half.png") + smallAnimation).status, 0);
    QCOMPARE(QImage(path("a/f.2.png")), QImage(path("a/half.png")));
    QCOMPARE(run(QByteArray("render zoom.ifs --view 3,0,4 -o a/end.png") + smallAnimation).status, 0);
    QCOMPARE(QImage(path("a/f.3.png")), QImage(path("a/end.png")));
}

void CliAnimateTest::keysMoveTheCameraInSpace() {
    QByteArray maps;
    for (int k = 0; k < 4; ++k)
        maps += ".5 0 0 0 .5 0 0 0 .5 " + QByteArray(k & 1 ? ".5 " : "0 ") + (k & 2 ? ".5 " : "0 ") +
                (k == 3 ? ".5 1\n" : "0 1\n");
    write("flight.ifs", "flight (3D) {\n; barycage: animation 4 24/1 off\n; barycage: track camera\n"
                        "; barycage: key 0 linear\n; barycage: value .5 .5 .25 1 0 0 0 3 40 1\n"
                        "; barycage: key 4 linear\n; barycage: value .5 .5 .5 1 0 0 0 1 60 1\n" +
                            maps + "}\n");
    const QByteArray draw = "render flight.ifs --size 48x36 -o ";
    for (const QByteArray frame : {"0", "2", "4"})
        QCOMPARE(run(draw + "a/" + frame + ".png --frame " + frame).status, 0);
    const QImage first(path("a/0.png")), middle(path("a/2.png")), last(path("a/4.png"));
    QVERIFY(!first.isNull());
    QVERIFY(first != middle && middle != last && first != last);
    QCOMPARE(run(draw + "a/from.png --orbit 0,0 --perspective 40 --view .5,.5,.25,3").status, 0);
    QCOMPARE(QImage(path("a/from.png")), first);
    QCOMPARE(run(draw + "a/to.png --orbit 0,0 --perspective 60 --view .5,.5,.5,1").status, 0);
    QCOMPARE(QImage(path("a/to.png")), last);
}

void CliAnimateTest::spaceMoves() {
    QByteArray cube = "cube (3D) {\n; barycage: animation 4 24/1 cycle\n; barycage: motion orbit\n"
                      "; barycage: count 1\n; barycage: pivot 0 0 0\n";
    for (int k = 0; k < 4; ++k)
        cube += ".5 0 0 0 .5 0 0 0 .5 " + QByteArray(k & 1 ? ".5 " : "0 ") + (k & 2 ? ".5 " : "0 ") +
                (k == 3 ? ".5 1\n" : "0 1\n");
    write("cube.ifs", cube + "}\n");
    QCOMPARE(run("animate cube.ifs -o a/f.#.png --size 48x36").status, 0);
    QCOMPARE(files("a").size(), 4);
    QCOMPARE(text("a/f.1.png", QStringLiteral("barycage:request")).size(), 64);
    QVERIFY(read("a/f.1.png") != read("a/f.2.png"));
    QCOMPARE(run("render cube.ifs -o a/turned.png --size 48x36 --orbit 120,20 --view 0.5,0.5,0.5,2").status,
             0);
    QCOMPARE(run("render cube.ifs -o a/frame.png --size 48x36 --orbit 30,20 --view 0.5,0.5,0.5,2 --frame 1")
                 .status,
             0);
    const QImage turned(path("a/turned.png")), frame(path("a/frame.png"));
    int different = 0;
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 48; ++x)
            different += turned.pixel(x, y) != frame.pixel(x, y);
    QVERIFY2(different < 48 * 36 / 50, qPrintable(QString::number(different))); // but for rounding
}

void CliAnimateTest::aShutterBlursWhatMoves() {
    const QByteArray command = QByteArray("animate wind.ifs --entry once --size 120x90 --points 400000 ");
    QCOMPARE(run(command + "-o a/f.#.png").status, 0);
    QCOMPARE(run(command + "-o b/f.#.png --shutter 180").status, 0);
    QCOMPARE(run(command + "-o c/f.#.png --shutter 0 --frames 3").status, 0);
    QCOMPARE(read("c/f.3.png"), read("a/f.3.png"));
    QVERIFY(read("b/f.3.png") != read("a/f.3.png"));
    // A frame that is drawn alone, by another number of threads, is that of the sequence.
    for (const QByteArray number : {"1", "3", "7"}) {
        QCOMPARE(run(command + "-o d/f.#.png --shutter 180 --threads 1 --frames " + number).status, 0);
        QCOMPARE(read("d/f." + number + ".png"), read("b/f." + number + ".png"));
    }
    // Blurred pixels are between those of the moments before and after: the difference of neighbours shrinks.
    const auto roughness = [this](const QByteArray& file) {
        const QImage picture = QImage(path(file)).convertToFormat(QImage::Format_Grayscale8);
        int sum = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 1; x < picture.width(); ++x)
                sum += std::abs(picture.constScanLine(y)[x] - picture.constScanLine(y)[x - 1]);
        return sum;
    };
    QVERIFY(roughness("b/f.3.png") < 0.9 * roughness("a/f.3.png"));
}

void CliAnimateTest::aShutterBlursSolids() {
    write("cube.ifs", "cube (3D) {\n; barycage: animation 8 24/1 cycle\n; barycage: motion orbit\n"
                      "; barycage: count 1\n; barycage: pivot 0 0 0\n"
                      ".5 0 0 0 .5 0 0 0 .5 0 0 0 1\n.5 0 0 0 .5 0 0 0 .5 .5 0 0 1\n"
                      ".5 0 0 0 .5 0 0 0 .5 0 .5 0 1\n.5 0 0 0 .5 0 0 0 .5 0 0 .5 1\n}\n");
    for (const QByteArray look : {"stone", "cloud --points 100000"}) {
        const QByteArray command = "animate cube.ifs --size 64x48 --existing replace --look " + look;
        QCOMPARE(run(command + " -o a/f.#.png --shutter 90").status, 0);
        QCOMPARE(run(command + " -o b/f.#.png --shutter 90 --frames 2 --threads 1").status, 0);
        QCOMPARE(run(command + " -o c/f.#.png --frames 2").status, 0);
        QVERIFY(!read("a/f.2.png").isEmpty());
        QCOMPARE(read("b/f.2.png"), read("a/f.2.png"));
        QVERIFY(read("c/f.2.png") != read("a/f.2.png"));
    }
    QCOMPARE(run("animate cube.ifs --size 64x48 -o d/f.#.png --look normals --shutter 90").status, 2);
    QCOMPARE(run("animate cube.ifs --size 64x48 -o d/f.#.png --look depth --shutter 90").status, 2);
    QVERIFY(files("d").isEmpty());
}

void CliAnimateTest::exposureIsAFunctionOfTheAnimation() {
    const auto drawn = [this](const QByteArray& folder, const QByteArray& options) {
        return run("animate wind.ifs --entry wind -o " + folder + "/f.#.png " + options + smallAnimation)
            .status;
    };
    QCOMPARE(drawn("a", {}), 0);
    QCOMPARE(drawn("b", "--exposure each"), 0);
    QCOMPARE(drawn("c", "--exposure fixed"), 0);
    QCOMPARE(drawn("d", "--exposure smooth --chunk 1/2"), 0);
    for (const QString& file : files("d"))
        QCOMPARE(read("d/" + file.toUtf8()), read("a/" + file.toUtf8()));
    const auto image = [this](const char* file) { return QImage(path(file)); };
    // Frame 0 is a pilot. Later, what is fixed is that of frame 0.
    QVERIFY(!image("a/f.1.png").isNull());
    QCOMPARE(image("a/f.1.png"), image("b/f.1.png"));
    QCOMPARE(image("c/f.1.png"), image("b/f.1.png"));
    QVERIFY(image("c/f.4.png") != image("b/f.4.png"));
}

void CliAnimateTest::aMomentWithoutAttractorIsNamed() {
    write("lost.ifs", "lost {\n; barycage: animation 32 24/1 off\n; barycage: track map 1\n"
                      "; barycage: key 0 linear\n; barycage: value .5 0 0 .5 0 0 1\n"
                      "; barycage: key 32 linear\n; barycage: value 1.5 0 0 .5 0 0 1\n"
                      " .5 0 0 .5 0 0 1\n .5 0 0 .5 1 0 1\n}\n");
    const Result result = run(QByteArray("animate lost.ifs -o a/f.##.png --frames 1") + smallAnimation);
    QCOMPARE(result.status, 0);
    QVERIFY2(result.err.contains("At frame 16 "), result.err.constData()); // where the map is 1 wide
}

// From frame 16 on, the first map is at least 1 wide.
void CliAnimateTest::framesWithoutAttractorAreOneWarning() {
    write("lost.ifs", "lost {\n; barycage: animation 32 24/1 off\n; barycage: track map 1\n"
                      "; barycage: key 0 linear\n; barycage: value .5 0 0 .5 0 0 .5\n"
                      "; barycage: key 32 linear\n; barycage: value 1.5 0 0 .5 0 0 .5\n"
                      " .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\n");
    const Result result =
        run(QByteArray("animate lost.ifs -o a/f.##.png --frames 14-22,30 --view 0,0,4") + smallAnimation);
    QCOMPARE(result.status, 0);
    QCOMPARE(files("a").size(), 10);
    QVERIFY2(result.err.contains("At the frames 16–21, 29 of “lost” there is no attractor."),
             result.err.constData());
    QCOMPARE(result.err.count("attractor"), 1);
    QCOMPARE(result.err.count("warning"), 1);
    const Result one =
        run(QByteArray("animate lost.ifs -o b/f.##.png --frames 1,20 --view 0,0,4") + smallAnimation);
    QVERIFY2(one.err.contains("At frame 19 of “lost”"), one.err.constData());
    QCOMPARE(one.err.count("warning"), 1);
    const Result fine = run(QByteArray("animate wind.ifs -o c/f.##.png --view 0,0,4") + smallAnimation);
    QVERIFY2(!fine.err.contains("attractor"), fine.err.constData());
}

// Their points escape; what the other frames show would be a dot.
void CliAnimateTest::framesWithoutAttractorDoNotSetTheView() {
    write("lost.ifs", "lost {\n; barycage: animation 32 24/1 off\n; barycage: track map 1\n"
                      "; barycage: key 0 linear\n; barycage: value .5 0 0 .5 0 0 1\n"
                      "; barycage: key 32 linear\n; barycage: value 1.5 0 0 1.5 0 0 1\n"
                      " .5 0 0 .5 0 0 1\n .5 0 0 .5 1 1 1\n}\n"
                      "space (3D) {\n; barycage: animation 32 24/1 off\n; barycage: track map 1\n"
                      "; barycage: key 0 linear\n; barycage: value .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n"
                      "; barycage: key 32 linear\n; barycage: value 1.5 0 0 0 1.5 0 0 0 1.5 0 0 0 1\n"
                      " .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n .5 0 0 0 .5 0 0 0 .5 1 0 0 1\n"
                      " .5 0 0 0 .5 0 0 0 .5 0 1 0 1\n .5 0 0 0 .5 0 0 0 .5 0 0 1 1\n}\n");
    for (const char* entry : {"lost", "space"}) {
        const Result result = run(
            QByteArray("animate lost.ifs --size 48x36 --existing replace --frames 1 -o a/f.#.png --entry ") +
            entry);
        QCOMPARE(result.status, 0);
        const QImage picture(path("a/f.1.png"));
        const QRgb ground = picture.pixel(0, 0);
        int rows = 0; // that it reaches
        for (int y = 0; y < picture.height(); ++y) {
            bool isReached = false;
            for (int x = 0; x < picture.width(); ++x)
                isReached = isReached || picture.pixel(x, y) != ground;
            rows += isReached;
        }
        QVERIFY2(rows > picture.height() / 3, qPrintable(QStringLiteral("%1 rows").arg(rows)));
    }
}

void CliAnimateTest::theFolderIsMade() {
    QVERIFY(!QDir(path("a/deep")).exists());
    QCOMPARE(run(QByteArray("animate wind.ifs -o a/deep/down/f.#.png --frames 1-2") + smallAnimation).status,
             0);
    QCOMPARE(files("a/deep/down").size(), 2);
    write("b/file", "no folder");
    QCOMPARE(run(QByteArray("animate wind.ifs -o b/file/f.#.png --frames 1") + smallAnimation).status, 3);
    QCOMPARE(read("b/file"), QByteArray("no folder"));
}

void CliAnimateTest::wrongUsageIsRefused_data() {
    QTest::addColumn<QByteArray>("arguments");
    QTest::addColumn<int>("status");
    const auto row = [](const char* arguments, int status = 2) {
        QTest::newRow(arguments) << QByteArray(arguments) << status;
    };
    row("wind.ifs -o a/f.png");
    row("wind.ifs -o a/#-#.png");
    row("wind.ifs -o a/f.#.mp4");
    row("wind.ifs -o -");
    row("wind.ifs -o a/f.#.png --frames 0");
    row("wind.ifs -o a/f.#.png --frames 5-2");
    row("wind.ifs -o a/f.#.png --frames 1-5x0");
    row("wind.ifs -o a/f.#.png --frames 1,,2");
    row("wind.ifs -o a/f.#.png --frames one");
    row("wind.ifs -o a/f.#.png --chunk 2/2");
    row("wind.ifs -o a/f.#.png --chunk -1/2");
    row("wind.ifs -o a/f.#.png --chunk 1");
    row("wind.ifs -o a/f.#.png --existing keep");
    row("wind.ifs -o a/f.#.png --entry wind --entry once");
    row("wind.ifs -o a/f.#.png --cage \"0,0 1,0 0,1\"");
    row("wind.ifs -o a/f.#.png --orbit 0,0");
    row("wind.ifs -o a/f.#.png --entry still", 1);
    row("systems.ifs -o a/f.#.png", 1);
    row("missing.ifs -o a/f.#.png", 3);
    row("wind.ifs -o wind.ifs/f.#.png --size 8x8 --points 100", 3); // no folder can be made there
}

void CliAnimateTest::wrongUsageIsRefused() {
    QFETCH(QByteArray, arguments);
    QFETCH(int, status);
    const Result result = run("animate " + arguments);
    QCOMPARE(result.status, status);
    QVERIFY(!result.err.isEmpty());
    QVERIFY(files("a").isEmpty());
}

// kill −9 at any time leaves only whole files, and the same command finishes the work.
void CliAnimateTest::killedAtAnyTimeLeavesWholeFiles() {
    const QByteArray command = "animate wind.ifs --entry back -o a/f.##.png --size 320x240 --points 400000";
    QCOMPARE(run(QByteArray(command).replace("a/", "b/")).status, 0);
    QRandomGenerator random(3);
    for (int n = 0; n < 12; ++n) {
        QProcess process;
        start(process, command + " --existing replace");
        QVERIFY(process.waitForStarted());
        process.waitForFinished(50 + random.bounded(400));
        process.kill();
        process.waitForFinished();
        for (const QString& file : files("a"))
            QVERIFY2(read("a/" + file.toUtf8()) == read("b/" + file.toUtf8()), qPrintable(file));
    }
    QCOMPARE(run(command).status, 0);
    QCOMPARE(files("a"), files("b"));
    for (const QString& file : files("b"))
        QCOMPARE(read("a/" + file.toUtf8()), read("b/" + file.toUtf8()));
}

BARYCAGE_TEST(CliAnimateTest, QGuiApplication);
#include "cli_animate_test.moc"
