// SPDX-License-Identifier: MIT
#include "document/document.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/lesson/shown_step.h"
#include "document/moments/animated_fractal.h"
#include "io/fractint/fractint_reader.h"
#include "io/lesson/lesson_picture.h"
#include "io/lesson/lesson_reader.h"
#include "support/named_test.h"

#include <QFile>
#include <QGuiApplication>

#include <memory>

using document::LessonState;

namespace {

constexpr QSize size(120, 90);

document::Fractal triangle() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.appearance.background = {255, 255, 255, 255};
    return fractal;
}

// Without marks.
LessonState plain() {
    LessonState state;
    state.showsCage = false;
    return state;
}

int inked(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixel(x, y) != qRgb(255, 255, 255);
    return count;
}

} // namespace

class LessonPictureTest : public QObject {
    Q_OBJECT

private slots:
    void stepsOfTheConstructionAreDrawn() {
        LessonState state = plain();
        const int attractor = inked(io::lessonPicture(triangle(), state, size));
        state.construction.mode = document::LessonConstruction::Mode::Steps;
        int before = 0;
        for (const int iterations : {0, 1, 2}) {
            state.construction.iterations = iterations;
            const int area = inked(io::lessonPicture(triangle(), state, size));
            QVERIFY(area > attractor);
            if (before > 0) QVERIFY(std::abs(area - 0.75 * before) < 0.08 * before); // three of four quarters
            before = area;
        }
    }

    void soManyPointsAreDrawn() {
        LessonState state = plain();
        state.construction.mode = document::LessonConstruction::Mode::ChaosGame;
        state.construction.points = 7;
        const int few = inked(io::lessonPicture(triangle(), state, size));
        QVERIFY2(few >= 5 && few <= 7, qPrintable(QString::number(few)));
        state.construction.points = 200;
        const int more = inked(io::lessonPicture(triangle(), state, size));
        QVERIFY(more > 100 && more <= 200);
    }

    // As in the window, where the cage stays while the maps move.
    void theCageOfWhatMovesStays() {
        document::Fractal entry = document::sierpinskiTriangle();
        const ifs::WeightedMap<2> first = document::system2(entry)->maps.front();
        ifs::AffineMap<2> turned = first.map;
        turned.linear *= -1;
        animation::Animation<2> animation;
        animation.length = 10;
        animation.maps = {{first.id, {{0, {first.map, 1}, {}}, {10, {turned, 1}, {}}}}};
        document::plane(entry)->animation = animation;
        document::Document document;
        document.setFile(document::fileOf(entry));
        LessonState state;
        state.moment = animation::moment(5);
        document.setMoment(*state.moment);
        const auto cage = document::effectiveCage(document::shownIn(state, document.entryFractal()).fractal);
        QVERIFY(cage.current == document::effectiveCage(document.fractal()).current);
        const auto atTheMoment = document::frameAt(document.entryFractal(), *state.moment).fractal;
        QVERIFY(cage.current != document::effectiveCage(atTheMoment).current);
    }

    // As on the canvas, which does not show where the cage was before.
    void theCageAtRestIsNotDrawn() {
        document::Fractal dragged = triangle();
        document::plane(dragged)->cage = document::effectiveCage(dragged);
        for (auto& corner : document::plane(dragged)->cage->current)
            corner *= 0.25;
        const auto baked = document::baked(dragged);
        QVERIFY(baked);
        const LessonState state;
        QVERIFY(io::lessonPicture(dragged, state, size) == io::lessonPicture(*baked, state, size));
    }

    // A picture stands still: a game that has just begun would show nothing.
    void aGameThatRunsHasBeenPlayed() {
        LessonState state = plain();
        state.construction.mode = document::LessonConstruction::Mode::ChaosGame;
        state.construction.speed = 10;
        const int points = inked(io::lessonPicture(triangle(), state, size));
        QVERIFY2(points > 100 && points <= 200, qPrintable(QString::number(points)));
        // They are as large as can be seen, however fine the picture is.
        const int fine = inked(io::lessonPicture(triangle(), state, 10 * size));
        QVERIFY2(fine > 10 * points, qPrintable(QString::number(fine)));
    }

    void cornersHaveTheirNumbers() {
        LessonState state = plain();
        state.construction.mode = document::LessonConstruction::Mode::ChaosGame;
        state.view = document::LessonArea{{}, 100}; // all of the cage is one spot
        const int bare = inked(io::lessonPicture(triangle(), state, size));
        state.showsCage = true;
        const int numbered = inked(io::lessonPicture(triangle(), state, size));
        QVERIFY2(numbered > bare + 60, qPrintable(QString::number(numbered))); // a disc
    }

    void marksAreThoseOfTheStep() {
        LessonState state = plain();
        state.view = document::LessonArea{{{0.5, 0.5}, 1.5}, 1.5};
        const QImage bare = io::lessonPicture(triangle(), state, size);
        state.showsCage = true;
        const QImage withCage = io::lessonPicture(triangle(), state, size);
        QVERIFY(withCage != bare);
        state.tool = document::LessonTool::Maps;
        QVERIFY(io::lessonPicture(triangle(), state, size) != withCage);
    }

    void theViewIsThatOfTheStep() {
        LessonState state = plain();
        state.view = document::LessonArea{{{100, 100}, 1}, 1}; // beside the attractor
        QCOMPARE(inked(io::lessonPicture(triangle(), state, size)), 0);
        state.view = document::LessonFit{};
        QVERIFY(inked(io::lessonPicture(triangle(), state, size)) > 300);
        QVERIFY(io::lessonPicture({}, state, size).isNull());
    }

    void theCageIsWhereTheStepHasIt() {
        document::FractalFile file = document::fileOf(triangle());
        LessonState state = plain();
        QCOMPARE(document::entryOf(file, state), &file.entries.front());
        state.entry = QStringLiteral("nobody");
        QVERIFY(!document::entryOf(file, state));
        state.entry = file.entries.front().fractal->name;
        QCOMPARE(document::entryOf(file, state), &file.entries.front());
        std::vector<ifs::Vector<2>> corners = document::effectiveCage(triangle()).current;
        corners[1] += ifs::Vector<2>(1, 0);
        state.cage = corners;
        const document::ShownStep moved = document::shownIn(state, triangle());
        QVERIFY(moved.fits);
        QVERIFY(document::effectiveCage(moved.fractal).current == corners);
        corners.pop_back();
        state.cage = corners;
        QVERIFY(!document::shownIn(state, triangle()).fits);
        state.cage = document::LessonAtRest{};
        QVERIFY(document::isAtRest(document::shownIn(state, moved.fractal).fractal));
    }

    void solidsAreDrawn() {
        const auto read =
            io::readFractint("s (3D) { .5 0 0 0 .5 0 0 0 .5 0 0 0 .5\n .5 0 0 0 .5 0 0 0 .5 1 1 1 .5 }");
        LessonState state = plain();
        state.view = document::LessonOrbit{{}, true};
        const QImage picture = io::lessonPicture(*read.entries.front().fractal, state, size);
        QCOMPARE(picture.size(), size);
        state.showsCage = true;
        QVERIFY(io::lessonPicture(*read.entries.front().fractal, state, size) != picture);
    }

    void nothingIsDrawnOnceStopped() {
        std::stop_source source;
        source.request_stop();
        QVERIFY(io::lessonPicture(triangle(), plain(), size, source.get_token()).isNull());
    }

    // Every step of the lessons that come with the program shows something.
    void ourLessonsHavePictures() {
        for (const char* name : {"chaos_game", "maple_triangle"}) {
            const auto contents = [&](const char* suffix) {
                QFile file(QStringLiteral(":/lessons/") + QLatin1String(name) + QLatin1String(suffix));
                return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
            };
            const document::FractalFile file = io::readFractint(contents(".ifs"));
            const document::Lesson lesson = io::readLesson(contents(".lesson")).lesson;
            QVERIFY(lesson.steps.size() > 3);
            for (const document::LessonStep& step : lesson.steps) {
                const document::Entry* entry = document::entryOf(file, step.state);
                QVERIFY2(entry, qPrintable(step.title));
                const document::ShownStep shown = document::shownIn(step.state, *entry->fractal);
                QVERIFY2(shown.fits, qPrintable(step.title));
                QCOMPARE(io::lessonPicture(shown.fractal, step.state, size).size(), size);
            }
        }
    }
};

BARYCAGE_TEST(LessonPictureTest, QGuiApplication);
#include "lesson_picture_test.moc"
