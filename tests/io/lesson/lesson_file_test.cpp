// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_reader.h"
#include "io/lesson/lesson_reader.h"
#include "io/lesson/lesson_writer.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "support/processor_timer.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <utility>

using document::Lesson;
using document::LessonState;
using document::LessonStep;
using namespace Qt::StringLiterals;

class LessonFileTest : public QObject {
    Q_OBJECT

private slots:
    void everythingReadsBack();
    void whatIsWrittenIsReadable();
    void settingsAreReadLeniently_data();
    void settingsAreReadLeniently();
    void aLaterVersionsSettingsAreKept();
    void onlyFilesOfFractalsAreNamed_data();
    void onlyFilesOfFractalsAreNamed();
    void hostileFiles_data();
    void hostileFiles();
    void textsArePlain();
    void areasFitWindowsOfAnyShape();
    void ourLessonsAreWhole();
    void everyLanguageSaysTheSame_data() { support::addLanguages(); }
    void everyLanguageSaysTheSame();
};

namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

LessonState firstState(const QByteArray& settings) {
    return io::readLesson("lesson: a\nfile: a.ifs\n\n## one\n" + settings + "\n").lesson.steps.value(0).state;
}

LessonStep fullStep() {
    LessonStep step;
    step.title = u"Wie weit? — «Ähren» ∞"_s;
    step.text = u"First.\n\n## looks like a title\n\\## and this, too\nkey: value"_s;
    step.state.entry = u"a b: c"_s;
    step.state.view = document::LessonArea{{{-1.0 / 3, 1e-12}, 1e-3, attractor::YAxis::Down}, 17.25};
    step.state.tool = document::LessonTool::Branch;
    step.state.cage = std::vector<ifs::Vector<2>>{{0.1, 0}, {1, -0.0}, {1.0 / 3, 1e300 / 1e270}};
    step.state.colourBy = attractor::ColourBy::Address;
    step.state.outlines = {document::Outline::Cylinders, document::Outline::Box};
    step.state.cylinderDepth = 3;
    step.state.construction = {document::LessonConstruction::Mode::ChaosGame, 0, 12345, 0.5};
    step.state.moment = animation::moment(49, 4);
    step.state.showsGrid = step.state.showsCage = false;
    step.state.showsMapNumbers = true;
    step.state.panels = {u"maps"_s, u"lesson"_s};
    return step;
}

} // namespace

void LessonFileTest::everythingReadsBack() {
    LessonStep inSpace;
    attractor::OrbitCamera camera;
    camera.target = {1, 2, -3};
    camera.orientation = attractor::orbit(30, 20);
    camera.height = 0.7;
    camera.projection = attractor::OrbitCamera::Projection::Perspective;
    inSpace.state.view = document::LessonOrbit{camera};
    inSpace.state.cage = std::vector<ifs::Vector<3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}};
    inSpace.state.construction = {document::LessonConstruction::Mode::Steps, 4, 0, 0};
    LessonStep atRest;
    atRest.state.cage = document::LessonAtRest{};
    LessonStep turned;
    turned.state.view = document::LessonFit{attractor::YAxis::Down, attractor::rotationOf(-12.5)};
    LessonStep fitted = inSpace;
    fitted.state.view = document::LessonOrbit{camera, true};
    const Lesson lesson{u"Größe"_s, u"größe & more.ifs"_s, {fullStep(), inSpace, atRest, turned, fitted}, {}};
    const QByteArray bytes = io::writeLesson(lesson);
    const io::LessonFile back = io::readLesson(bytes);
    QVERIFY2(back.problems.isEmpty(), qPrintable(back.problems.value(0).message));
    QCOMPARE(back.lesson.steps.size(), 5);
    for (int i = 0; i < 5; ++i)
        QVERIFY2(back.lesson.steps[i] == lesson.steps[i], bytes.constData());
    QVERIFY(back.lesson == lesson);
    QCOMPARE(io::writeLesson(back.lesson), bytes);
    // Another program's line ends and mark change nothing.
    QVERIFY(io::readLesson("\xef\xbb\xbf" + QByteArray(bytes).replace("\n", "\r\n")).lesson == lesson);
}

void LessonFileTest::whatIsWrittenIsReadable() {
    Lesson lesson{u"The chaos game"_s, u"a.ifs"_s, {}, {}};
    LessonStep step{u"One"_s, u"A text."_s, {}, {}};
    step.state.entry = u"maple"_s;
    step.state.outlines = {document::Outline::Hull};
    step.state.showsAxes = false;
    lesson.steps << step;
    QCOMPARE(io::writeLesson(lesson), QByteArray("lesson: The chaos game\nfile: a.ifs\n\n"
                                                 "## One\nentry: maple\nview: fit\ntool: cage\n"
                                                 "outlines: hull\nhide: axes\n\nA text.\n"));
}

void LessonFileTest::settingsAreReadLeniently_data() {
    QTest::addColumn<QByteArray>("setting");
    QTest::addColumn<bool>("isUnderstood");
    const auto row = [](const char* setting, bool isUnderstood = false) {
        QTest::newRow(setting) << QByteArray(setting) << isUnderstood;
    };
    row("view: fit", true);
    row("view: fit down rotation 30", true);
    row("view: fit rotation");
    row("view: fit rotation x");
    row("view: fit rotation 30 down");
    row("view: fit 30");
    row("view: orbit 0 0 0 0 0 0 1 1 perspective 40 fit", true);
    row("view: orbit 0 0 0 0 0 0 1 1 fit perspective 40");
    row("view: orbit fit");
    row("view:   area  0 0 1 1 ", true);
    row("view: area 0 0 1 1 rotation 30", true);
    row("view: area 0 0 1 1 down rotation -12.5", true);
    row("view: area 0 0 1 1 rotation");
    row("view: area 0 0 1 1 rotation x");
    row("view: area 0 0 1 1 30");
    row("view: area 0 0 1 0");
    row("view: area 0 0 -1 1");
    row("view: area 0 0 1 nan");
    row("view: area 0 0 1 1e39");
    row("view: area 0 0 1");
    row("view: orbit 0 0 0 0 0 0 0 1");
    row("view: orbit 0 0 0 0 0 0 1 1", true);
    row("view: orbit 0 0 0 1e200 0 0 1 1");
    row("view: orbit 0 0 0 0 0 0 1 1 perspective 180");
    row("view:");
    row("tool: hammer");
    row("cage: 0 0, 1 0");
    row("cage: 0 0, 1 0, 0 1 2");
    row("cage: 0 0, 1 0, 0 1", true);
    row("colour: red");
    row("outlines: hull, nothing");
    row("outlines: cylinders 99");
    row("outlines: hull 2");
    row("construction: steps -1");
    row("construction: steps 1000");
    row("construction: chaos-game 99999999999999999999");
    row("construction: chaos-game 10 speed 0");
    row("construction: chaos-game 10 speed 1e9");
    row("frame: -1");
    row("frame: 1/0");
    row("hide: everything");
    row("show: everything");
    row("panels: ../x");
}

void LessonFileTest::settingsAreReadLeniently() {
    QFETCH(QByteArray, setting);
    QFETCH(bool, isUnderstood);
    const io::LessonFile file = io::readLesson("lesson: a\nfile: a.ifs\n\n## one\nentry: maple\n" + setting +
                                               "\ntool: maps\n\nText.\n");
    QCOMPARE(file.problems.size(), isUnderstood ? 0 : 1);
    if (!isUnderstood) QCOMPARE(file.problems.first().line, 6);
    QCOMPARE(file.lesson.steps.size(), 1);
    QCOMPARE(file.lesson.steps.first().text, u"Text."_s);
    QCOMPARE(file.lesson.steps.first().state.entry, u"maple"_s);
    QCOMPARE(file.lesson.steps.first().state.tool, document::LessonTool::Maps);
}

void LessonFileTest::aLaterVersionsSettingsAreKept() {
    const QByteArray bytes =
        "lesson: a\nfile: a.ifs\nlicence: CC\n\n## one\nview: fit\ntool: cage\nsound: a: b\n\nText.\n";
    const io::LessonFile file = io::readLesson(bytes);
    QCOMPARE(file.problems.size(), 2);
    QCOMPARE(io::writeLesson(file.lesson), bytes);
}

void LessonFileTest::onlyFilesOfFractalsAreNamed_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isAllowed");
    QTest::newRow("plain") << u"maple.ifs"_s << true;
    QTest::newRow("letters") << u"Größe (2).ifs"_s << true;
    for (const char* path : {"../a.ifs", "a/b.ifs", "../../Größe 2/.c/b.PAR", "/home/me/a.ifs", "C:/a.ifs"})
        QTest::newRow(path) << QString::fromUtf8(path) << true;
    for (const char* name : {"", "..", "/etc/passwd", "../a", "../a.txt", "a/", "/", "C:\\a.ifs",
                             "a/c:/b.ifs", "\\\\host\\a.ifs", "//host/a.ifs", "a//b.ifs", ".hidden",
                             "../.ifs", "a|b", "con:", "self.lesson", "../self.lesson", "SELF.LESSON"})
        QTest::newRow(name) << QString::fromUtf8(name) << false;
}

void LessonFileTest::onlyFilesOfFractalsAreNamed() {
    QFETCH(QString, name);
    QFETCH(bool, isAllowed);
    QCOMPARE(document::isLessonFile(name), isAllowed);
    const Lesson lesson = io::readLesson("lesson: a\nfile: " + name.toUtf8() + "\n\n## one\n").lesson;
    QCOMPARE(lesson.file, isAllowed ? name : QString());
}

void LessonFileTest::hostileFiles_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    const auto many = [](const QByteArray& piece, qsizetype bytes) {
        return piece.repeated(bytes / piece.size());
    };
    const QByteArray head = "lesson: a\nfile: a.ifs\n";
    constexpr qsizetype maxBytes = 4'000'000;
    QTest::newRow("nothing") << QByteArray() << u"not a lesson"_s;
    QTest::newRow("a collection") << QByteArray("a { .5 0 0 .5 0 0 1 }\n") << u"not a lesson"_s;
    QTest::newRow("zeros") << QByteArray(maxBytes, '\0') << u"not a lesson"_s;
    QTest::newRow("too large") << head + QByteArray(5'000'000, 'a') << u"4 MB"_s;
    QTest::newRow("no steps") << head << u"no steps"_s;
    QTest::newRow("steps") << head + many("## a\n", maxBytes) << u"more than 500 steps"_s;
    QTest::newRow("a text") << head + "## a\n\n" + many("letters ", maxBytes) << u"was cut"_s;
    QTest::newRow("lines") << head + "## a\n\n" + many("a\n", maxBytes) << u"was cut"_s;
    QTest::newRow("slashes") << head + "## a\n\n" + many("\\", maxBytes) << u"was cut"_s;
    QTest::newRow("settings") << head + "## a\n" + many("b: c\n", maxBytes) << u"unknown"_s;
    QTest::newRow("a cage") << head + "## a\ncage: " + many("0 0,", maxBytes) + "\n" << u"not understood"_s;
    QTest::newRow("outlines") << head + "## a\noutlines: " + many("x,", maxBytes) + "\n"
                              << u"not understood"_s;
    QTest::newRow("panels") << head + "## a\npanels: " + many("x,", maxBytes) + "\n" << u"not understood"_s;
    QTest::newRow("spaces") << head + "## a\nview: area" + many(" ", maxBytes) + "\n" << u"not understood"_s;
    QTest::newRow("surrogates") << head + "## a\n\n" + many("\xf0\x9f\x8c\xbf", maxBytes) << u"was cut"_s;
}

void LessonFileTest::hostileFiles() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    const support::ProcessorTimer timer;
    const io::LessonFile file = io::readLesson(bytes);
    QVERIFY2(timer.elapsed() < 5000, qPrintable(QString::number(timer.elapsed())));
    QVERIFY(!file.problems.isEmpty() && file.problems.size() < 50);
    const auto saysIt = [&](const document::Problem& problem) { return problem.message.contains(says); };
    QVERIFY2(std::ranges::any_of(file.problems, saysIt), qPrintable(file.problems.first().message));
    QVERIFY(file.lesson.steps.size() <= document::maxLessonSteps);
    for (const LessonStep& step : file.lesson.steps) {
        QVERIFY(step.text.size() <= document::maxLessonText);
        QVERIFY(step.text.isEmpty() || !step.text.back().isHighSurrogate());
        QVERIFY(step.state.panels.size() <= 20 && step.unknown.size() <= 50);
    }
}

void LessonFileTest::textsArePlain() {
    QCOMPARE(document::lessonLine(u" a\tb\u0007\u202ec\nd "_s), u"a bc d"_s);
    QCOMPARE(document::lessonText(u"\r\n\na \u2066b\r\n\r\nc\t\n\n"_s), u"a b\n\nc"_s);
    QCOMPARE(document::lessonText(u"abc"_s, 2), u"ab"_s);
    // Markup stays what it is: text.
    QCOMPARE(firstState("").entry, QString());
    const auto file = io::readLesson("lesson: <b>a</b>\nfile: a.ifs\n\n## <img src=x>\n\n<h1>*b*</h1>\n");
    QCOMPARE(file.lesson.title, u"<b>a</b>"_s);
    QCOMPARE(file.lesson.steps.first().title, u"<img src=x>"_s);
    QCOMPARE(file.lesson.steps.first().text, u"<h1>*b*</h1>"_s);
}

void LessonFileTest::areasFitWindowsOfAnyShape() {
    const document::LessonArea area{{{3, -2}, 2, attractor::YAxis::Up, attractor::rotationOf(20)}, 4};
    for (const attractor::RasterSize size :
         {attractor::RasterSize{800, 400}, {400, 800}, {1000, 100}, {1, 1}}) {
        const attractor::Camera camera = document::cameraOf(area, size);
        const document::LessonArea seen = document::areaOf(camera);
        QCOMPARE(seen.view.centre, area.view.centre);
        QCOMPARE(seen.view.rotation, area.view.rotation);
        QVERIFY(seen.width >= area.width * (1 - 1e-12) && seen.view.height >= area.view.height * (1 - 1e-12));
        QVERIFY(std::min(seen.width / area.width, seen.view.height / area.view.height) < 1 + 1e-12);
    }
}

void LessonFileTest::ourLessonsAreWhole() {
    int lessons = 0;
    for (QDirIterator it(u":/lessons"_s, {u"*.lesson"_s}, QDir::Files); it.hasNext();) {
        const QString path = it.next();
        const io::LessonFile file = io::readLesson(contents(path));
        QVERIFY2(file.problems.isEmpty(), qPrintable(path + u": "_s + file.problems.value(0).message));
        QVERIFY(file.lesson.steps.size() >= 5);
        const document::FractalFile fractals = io::readFractint(contents(u":/lessons/"_s + file.lesson.file));
        QVERIFY(fractals.problems.isEmpty() && !fractals.entries.isEmpty());
        for (const LessonStep& step : file.lesson.steps) {
            const auto isIt = [&](const document::Entry& entry) {
                return entry.fractal->name == step.state.entry && entry.problems.isEmpty();
            };
            QVERIFY2(std::ranges::any_of(fractals.entries, isIt), qPrintable(step.state.entry));
            QVERIFY(!step.title.isEmpty() && !step.text.isEmpty() && step.text.size() < 700);
        }
        // A translation shows the same.
        const QString english = path.section(u'.', 0, 0) + u".lesson"_s;
        const Lesson original = io::readLesson(contents(english)).lesson;
        QCOMPARE(file.lesson.steps.size(), original.steps.size());
        for (qsizetype i = 0; i < original.steps.size(); ++i)
            QVERIFY2(file.lesson.steps[i].state == original.steps[i].state, qPrintable(path));
        QCOMPARE(io::readLesson(io::writeLesson(file.lesson)).lesson, file.lesson);
        ++lessons;
    }
    QVERIFY(lessons >= 2);
}

// As many paragraphs as in English, as long, and lessons, panels and entries by the names that the window has
// for them.
void LessonFileTest::everyLanguageSaysTheSame() {
    QFETCH(const QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    for (const auto& [name, menu] : {std::pair("chaos_game", "The Chaos Game"),
                                     std::pair("maple_triangle", "Why the Maple Fits Its Triangle")}) {
        const QString path = u":/lessons/"_s + QLatin1String(name);
        const Lesson english = io::readLesson(contents(path + u".lesson"_s)).lesson;
        const QString suffix = language == u"en"_s ? QString() : u'.' + language;
        const Lesson lesson = io::readLesson(contents(path + suffix + u".lesson"_s)).lesson;
        QCOMPARE(lesson.title.toLower(), QCoreApplication::translate("MainWindow", menu).toLower());
        QCOMPARE(lesson.steps.size(), english.steps.size());
        for (qsizetype i = 0; i < english.steps.size(); ++i) {
            const QString &text = lesson.steps[i].text, &original = english.steps[i].text;
            QCOMPARE(text.count(u"\n\n"_s), original.count(u"\n\n"_s));
            const double share = double(text.size()) / double(original.size());
            QVERIFY2(share > 0.7 && share < 1.5, qPrintable(text));
            static const QRegularExpression quoted(u"“(.+?)”"_s);
            for (auto it = quoted.globalMatch(original); it.hasNext();) {
                const QByteArray called = it.next().captured(1).toUtf8();
                QVERIFY2(text.contains(QCoreApplication::translate("MainWindow", called)), qPrintable(text));
            }
        }
    }
}

BARYCAGE_TEST(LessonFileTest, QCoreApplication);
#include "lesson_file_test.moc"
