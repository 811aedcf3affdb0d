// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QDir>
#include <QFile>

// Which pictures barycage-cli encode takes for the frames of one animation.
class CliEncodeTest : public CommandLineTest {
    Q_OBJECT

private slots:
    void init();
    void brokenSequencesAreRefused();
    void strangersAmongFramesAreRefused();
    void onlyTheNameOfTheFileHasNumbers();
    void bracketsInNamesAreLetters();

private:
    QStringList files(const QByteArray& folder) const {
        return QDir(path(folder)).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
};

namespace {

constexpr const char* smallFrames = " --size 64x48 --points 60000 ";

} // namespace

void CliEncodeTest::init() {
    write("wind.ifs", "wind {\n; barycage: animation 6 24/1 cycle\n; barycage: motion sway\n"
                      "; barycage: strength 9\n; barycage: pivot 0 0\n; barycage: wave 1\n"
                      "; barycage: value 1 0 25\n -0.04 0 -0.23 -0.65 -0.08 0.26 .25\n"
                      " 0.61 0 0 0.31 0.07 3.5 .25\n 0.65 0.29 -0.3 0.48 0.74 0.39 .25\n"
                      " 0.64 -0.3 0.16 0.56 -0.56 0.60 .25\n}\n");
    for (const char* folder : {"a", "b"}) {
        QDir(path(folder)).removeRecursively();
        QDir().mkpath(path(folder));
    }
}

void CliEncodeTest::brokenSequencesAreRefused() {
    QCOMPARE(run(QByteArray("animate wind.ifs --entry wind -o a/f.#.png") + smallFrames).status, 0);
    const auto refused = [this](int status, const char* sentence) {
        const Result result = run("encode a/f.#.png -o b/v.mp4");
        QCOMPARE(result.status, status);
        QVERIFY2(result.err.contains(sentence), result.err.constData());
        QCOMPARE(result.err.count('\n'), 1); // nothing of a library's own
        QVERIFY(files("b").isEmpty());
    };
    const QByteArray third = read("a/f.3.png");
    QVERIFY(QFile::remove(path("a/f.3.png")) && QFile::remove(path("a/f.4.png")));
    refused(1, "3-4");
    write("a/f.4.png", third);
    write("a/f.3.png", third.first(third.size() - 20));
    refused(1, "f.3.png");
    write("a/f.3.png", third.first(100)); // within what comes before the pixels
    refused(1, "f.3.png");
    write("a/f.3.png", "no picture");
    refused(1, "not a PNG");
    QCOMPARE(run("animate wind.ifs --entry wind -o a/f.#.png --frames 3 --size 66x48 --points 1000").status,
             0);
    refused(1, "66x48");
    QCOMPARE(run(QByteArray("animate wind.ifs --entry wind -o a/f.#.png") + smallFrames).status, 0);
    QCOMPARE(run("encode a/f.#.png -o b/v.mp4").status, 0);
    QCOMPARE(run("encode a/g.#.png -o b/w.mp4").status, 3);
    QCOMPARE(run("encode a/f.#.png -o missing/w.mp4").status, 3);
    QCOMPARE(files("b"), QStringList{QStringLiteral("v.mp4")});
}

// Frames that are left over from a longer animation, that were drawn with other options or moved, and those
// that are missing at an end.
void CliEncodeTest::strangersAmongFramesAreRefused() {
    const QByteArray draw = QByteArray("animate wind.ifs --entry wind -o a/f.#.png") + smallFrames;
    QCOMPARE(run(draw).status, 0);
    const auto refused = [this](const char* arguments, const char* sentence) {
        const Result result = run(QByteArray("encode a/f.#.png -o b/v.mkv ") + arguments);
        QCOMPARE(result.status, 1);
        QVERIFY2(result.err.contains(sentence), result.err.constData());
        QVERIFY(files("b").isEmpty());
    };
    QCOMPARE(run(draw + "--seed 9 --frames 3").status, 0);
    refused("", "other options than the newest one, “f.3.png”");
    QCOMPARE(run(draw).status, 0);
    const QByteArray unmarked = read("a/f.1.png");
    QCOMPARE(run(draw + "--seed 9 --frames 1").status, 0);
    makeOld("a/f.1.png");
    QCOMPARE(run("animate wind.ifs --entry wind -o a/f.#.png --existing replace --frames 2" +
                 QByteArray(smallFrames))
                 .status,
             0);
    refused("", "f.1.png: error: The picture was drawn from another entry");
    write("a/f.1.png", unmarked);

    const QByteArray second = read("a/f.2.png"), third = read("a/f.3.png");
    write("a/f.3.png", second);
    refused("", "f.3.png: error: The picture is frame 2 of its animation. Here, frame 3 should be.");
    write("a/f.3.png", third);

    write("wind.ifs", read("wind.ifs").replace("animation 6 24/1", "animation 4 24/1"));
    QCOMPARE(run(draw).status, 0);
    refused("", "f.5.png");
    QCOMPARE(run("encode a/f.#.png -o b/v.mkv --frames all").status, 0);
    QCOMPARE(run("info b/v.mkv --list").status, 0);
    QVERIFY(QFile::remove(path("b/v.mkv")));

    for (const char* file : {"a/f.1.png", "a/f.5.png", "a/f.6.png"})
        QVERIFY(QFile::remove(path(file)));
    refused("--frames all", "Pictures are missing: 1.");
    refused("--frames 2-5", "Pictures are missing: 5.");
    QCOMPARE(run("encode a/f.#.png -o b/v.mkv --frames 2-4").err, QByteArray());
    const Result part = run("encode a/f.#.png -o b/v.mkv");
    QCOMPARE(part.status, 0);
    QVERIFY2(part.err.contains("The pictures are 3 of 4 frames of the animation: 2-4."),
             part.err.constData());
}

void CliEncodeTest::onlyTheNameOfTheFileHasNumbers() {
    const QByteArray folder = "a/take # 2 %n ###";
    const Result drawn =
        run("animate wind.ifs --entry wind -o \"" + folder + "/f.##.png\" --frames 1-2" + smallFrames);
    QVERIFY2(drawn.status == 0, drawn.err.constData());
    QCOMPARE(files(folder), (QStringList{QStringLiteral("f.01.png"), QStringLiteral("f.02.png")}));
    const Result encoded = run("encode \"" + folder + "/f.##.png\" -o b/v.gif --frames 1-2");
    QVERIFY2(encoded.status == 0, encoded.err.constData());
    QCOMPARE(files("b"), QStringList{QStringLiteral("v.gif")});
    QCOMPARE(run("animate wind.ifs --entry wind -o a/#/f.png").status, 2);
}

void CliEncodeTest::bracketsInNamesAreLetters() {
    write("[x,y]", read("wind.ifs"));
    const Result drawn = run(QByteArray("render [x,y] -o b/p.png") + smallFrames);
    QVERIFY2(drawn.status == 0, drawn.err.constData());
}

BARYCAGE_TEST(CliEncodeTest, QGuiApplication);
#include "cli_encode_test.moc"
