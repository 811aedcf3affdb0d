// SPDX-License-Identifier: MIT
#include "document/fractal/recurring_branches.h"
#include "io/fractint/entry_writer.h"
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "io/fractint/metadata_comments.h"
#include "support/named_test.h"

#include <QTest>

using document::Fractal;
using document::FractalFile;

namespace {

constexpr const char* rows = "  .5 0 0 .5 0 0 .3\n  .5 0 0 .5 .5 0 .3\n  .5 0 0 .5 .25 .4 .4\n";

// An entry with these own lines before its rows.
QByteArray entryWith(const QByteArrayList& lines) {
    QByteArray text = "moving {\n";
    for (const QByteArray& line : lines)
        text += "; barycage: " + line + '\n';
    return text + rows + "}\n";
}

FractalFile fileOf(const QByteArray& text) {
    return io::readFractint(text);
}

const animation::Animation<2>* animationOf(const FractalFile& file) {
    const auto& animation = document::plane(*file.entries.first().fractal)->animation;
    return animation ? &*animation : nullptr;
}

// What the file is after one edit that has nothing to do with its animation.
QByteArray brightened(FractalFile file) {
    Fractal changed = *file.entries.first().fractal;
    changed.appearance.brightness = 7;
    file.entries.first().fractal = std::make_shared<const Fractal>(changed);
    return io::writeFractint(file);
}

const QByteArrayList everything{
    "version 1",
    "rest 0 0",
    "rest 1 0",
    "rest 0 1",
    "current 0 0",
    "current 1 0",
    "current 0 1",
    "animation 48 30000/1001 there-and-back",
    "reference 0.5 -0.25",
    "track cage",
    "key 0 hold",
    "value 0 0 1 0 0 1",
    "key 24 cubic",
    "handles 0.1 0 0.9 1",
    "value 0 0 0.123456789012345 -1.2345678901234566e-07",
    "value 0.1234567890123456 1",
    "track map 2",
    "key 0 linear",
    "value 0.5 0 0 0.5 0.5 0 0.3",
    "key 48 both",
    "value 0 -0.5 0.5 0 0.5 0",
    "track branch",
    "word 3 1 2",
    "key 12 in",
    "value 1 0 0 1 0.5 0.5",
    "track branch",
    "word 0 3 1",
    "key 12 in",
    "value 0 -1 1 0 0.5 0.5",
    "track look",
    "key 0 out",
    "look colour-by map",
    "look palette Fern",
    "look plain #ebebebff",
    "look background #00000000",
    "look brightness 4",
    "look gamma 2",
    "look contrast 1.5",
    "look vibrancy 0",
    "look shadow 0.5",
    "look shadow-lean -2",
    "key 10 smooth",
    "look colour-by density",
    "look palette Two Colours",
    "look stop 0 #ff0000ff",
    "look stop 1 #0000ffff",
    "look plain #ebebebff",
    "look background #00000000",
    "look brightness 8",
    "look gamma 2.2",
    "track camera",
    "key 0 linear",
    "value 0 1.5 10 1",
    "motion sway",
    "of 1 3",
    "strength 4.5",
    "pivot 0 -1",
    "wave 2",
    "value 0.75 90 25",
    "wave 5",
    "value 0.25 0 -10",
    "motion turn",
    "count -3",
    "pivot 0 0",
    "motion orbit",
    "count 1",
    "pivot 1 2",
    "motion breathe",
    "of 2",
    "count 2",
    "strength 0.125",
    "pivot 0 0",
    "motion palette",
    "count 1",
};

} // namespace

class AnimationCommentsTest : public QObject {
    Q_OBJECT

private slots:
    void everythingIsReadAndWrittenBack() {
        const FractalFile file = fileOf(entryWith(everything));
        QVERIFY2(file.entries.first().problems.isEmpty(),
                 file.entries.first().problems.isEmpty()
                     ? ""
                     : qPrintable(file.entries.first().problems.first().message));
        const auto* animation = animationOf(file);
        QVERIFY(animation != nullptr);
        QCOMPARE(animation->rate.frames, 30000);
        QCOMPARE(animation->rate.seconds, 1001);
        QCOMPARE(animation->loop, animation::Loop::ThereAndBack);
        QCOMPARE(animation->length, 48);
        QCOMPARE(trackCount(*animation), 6);
        QCOMPARE(animation->motions.size(), 5u);
        QCOMPARE(animation->cage[1].ease.x2, 0.9);
        QCOMPARE(animation->cage[1].value[1].y(), -1.2345678901234567e-7);
        QVERIFY(animation->maps[0].keys[0].value.weight && !animation->maps[0].keys[1].value.weight);
        QCOMPARE(animation->branches[0].word.size(), 3u);
        QVERIFY(document::recurs(animation->branches[1].word) &&
                !document::recurs(animation->branches[0].word));
        QCOMPARE(animation->branches[1].word.size(), 3u);
        QCOMPARE(animation->look[0].value.contrast, 1.5);
        QCOMPARE(animation->look[0].value.vibrancy, 0.0);
        QCOMPARE(animation->look[0].value.shadow, 0.5);
        QCOMPARE(animation->look[0].value.shadowLean, -2.0);
        QCOMPARE(animation->look[1].value.shadow, 0.0);
        QCOMPARE(animation->look[1].value.contrast, 1.0); // as in files that do not know it
        QCOMPARE(animation->look[1].value.vibrancy, 1.0);
        QCOMPARE(animation->look[1].value.palette.name, std::string("Two Colours"));
        QVERIFY(animation->look[1].ease.kind == animation::Ease::Kind::Smooth);
        const auto& sway = std::get<animation::Sway<2>>(animation->motions[0]);
        QCOMPARE(sway.maps, (animation::MapIds{ifs::MapId(1), ifs::MapId(3)}));
        QCOMPARE(sway.waves[1], (animation::Wave{0.25, 5, 0, -10}));

        QByteArrayList written;
        for (const QByteArray& line : io::metadataComments(*file.entries.first().fractal)) {
            QVERIFY2(line.size() < 70, line.constData());
            written << line.mid(qsizetype(strlen("; barycage: ")));
        }
        QCOMPARE(written, everything);
        QCOMPARE(io::writeFractint(file), entryWith(everything));
        // A new file with the same entry holds the same.
        const FractalFile again = fileOf(io::writeEntry(*file.entries.first().fractal, "\n"));
        QCOMPARE(*again.entries.first().fractal, *file.entries.first().fractal);
    }

    void anEditLeavesTheOtherLinesAlone() {
        const FractalFile file = fileOf(entryWith(everything));
        QByteArrayList expected = everything;
        expected << "brightness 7";
        QCOMPARE(brightened(file), entryWith(expected));
    }

    void longNumbersAreWrapped() {
        Fractal fractal = *fileOf(entryWith(everything)).entries.first().fractal;
        auto& animation = *document::plane(fractal)->animation;
        const double third = -1.0 / 3 * 1e-100;
        animation.reference = ifs::Vector<2>(third, third);
        animation.maps[0].keys[0].value.map.linear.fill(third);
        animation.cage[1].ease = animation::cubicEase(1.0 / 3, 1.0 / 7, 0.912345678901234, 0.987654321098765);
        animation.branches[0].word.assign(64, ifs::MapId(3));
        for (const QByteArray& line : io::metadataComments(fractal))
            QVERIFY2(line.size() < 70, line.constData());
        QCOMPARE(*fileOf(io::writeEntry(fractal, "\n")).entries.first().fractal, fractal);
    }

    void space() {
        const QByteArrayList lines{"version 1",
                                   "animation 10 24/1 cycle",
                                   "track map 1",
                                   "key 0 linear",
                                   "value 0.5 0 0 0 0.5 0 0 0 0.5 0 0 0 1",
                                   "track look",
                                   "key 0 linear",
                                   "look colour-by map",
                                   "look palette Fern",
                                   "look plain #ebebebff",
                                   "look background #00000000",
                                   "look brightness 4",
                                   "look gamma 2",
                                   "look space-look stone",
                                   "look solid-colour height",
                                   "look light 10.5 -20",
                                   "look fog 0.5",
                                   "look clip-normal 0 0 1",
                                   "look clip-range 0.25 -",
                                   "key 5 linear",
                                   "look colour-by map",
                                   "look palette Fern",
                                   "look plain #ebebebff",
                                   "look background #00000000",
                                   "look brightness 4",
                                   "look gamma 2",
                                   "track camera",
                                   "key 0 linear",
                                   "value 0 0 0 1 0 0 0 2 40 1",
                                   "motion turn",
                                   "count 1",
                                   "pivot 0 0 0",
                                   "axis 0 1 0"};
        QByteArray text = "solid (3D) {\n";
        for (const QByteArray& line : lines)
            text += "; barycage: " + line + '\n';
        text += ".5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n";
        const FractalFile file = fileOf(text);
        QVERIFY(file.entries.first().problems.isEmpty());
        const auto& animation = document::space(*file.entries.first().fractal)->animation;
        QVERIFY(animation.has_value());
        QCOMPARE(animation->camera[0].value.projection, attractor::OrbitCamera::Projection::Perspective);
        const auto& inSpace = animation->look[0].value.inSpace;
        QVERIFY(inSpace && inSpace->clip);
        QCOMPARE(inSpace->lightAzimuth, 10.5);
        QCOMPARE(inSpace->fog, 0.5);
        QCOMPARE(inSpace->clip->lowest, 0.25);
        QVERIFY(!animation->look[1].value.inSpace); // as in files that do not know it
        QCOMPARE(io::writeFractint(file), text);
        QCOMPARE(*fileOf(io::writeEntry(*file.entries.first().fractal, "\n")).entries.first().fractal,
                 *file.entries.first().fractal);
    }

    // The last number, where there is one; what is not turned is written as before.
    // Before axes were stored, a camera in space went about its target: such entries still look as they did.
    void orbitsInSpace() {
        const QByteArray head = "turning (3D) {\n; barycage: version 1\n; barycage: animation 48 24/1 "
                                "cycle\n; barycage: motion orbit\n"
                                "; barycage: count 1\n; barycage: pivot 1 2 3\n";
        const QByteArray row = "  .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n}\n";
        const auto orbitOf = [](const FractalFile& file) {
            const auto& motions = document::space(*file.entries.first().fractal)->animation->motions;
            return std::get<animation::Orbit<3>>(motions.at(0));
        };
        const FractalFile old = fileOf(head + row);
        QVERIFY(orbitOf(old).pivot == animation::OrbitPivot::Target);
        QVERIFY(brightened(old).contains("pivot 1 2 3\n"));
        QVERIFY(!brightened(old).contains("axis"));
        const FractalFile tilted = fileOf(head + "; barycage: axis 0 0.6 0.8\n" + row);
        const animation::Orbit<3> orbit = orbitOf(tilted);
        QVERIFY(orbit.pivot == animation::OrbitPivot::Centre);
        QVERIFY(orbit.centre == ifs::Vector<3>(1, 2, 3) && orbit.axis == ifs::Vector<3>(0, 0.6, 0.8));
        QVERIFY(orbitOf(fileOf(brightened(tilted))) == orbit);
        const FractalFile crooked = fileOf(head + "; barycage: axis 0 0.6 0.9\n" + row);
        QVERIFY(!document::space(*crooked.entries.first().fractal)->animation); // its length is not 1
        QVERIFY(brightened(crooked).contains("axis 0 0.6 0.9"));
    }

    void aTurnedCamera() {
        for (const QByteArray value : {"value 0.5 -1 2 1", "value 0.5 -1 2 -1 30"}) {
            const QByteArray text = "plane {\n; barycage: version 1\n; barycage: animation 10 24/1 cycle\n"
                                    "; barycage: track camera\n; barycage: key 0 linear\n; barycage: " +
                                    value + "\n.5 0 0 .5 0 0 1\n}\n";
            const FractalFile file = fileOf(text);
            QVERIFY(file.entries.first().problems.isEmpty());
            const auto& animation = document::plane(*file.entries.first().fractal)->animation;
            QVERIFY(animation.has_value());
            QCOMPARE(attractor::degreesOf(animation->camera[0].value.rotation),
                     value.endsWith(" 30") ? 30.0 : 0.0);
            QCOMPARE(*fileOf(io::writeEntry(*file.entries.first().fractal, "\n")).entries.first().fractal,
                     *file.entries.first().fractal);
            QVERIFY(io::writeEntry(*file.entries.first().fractal, "\n").contains(value));
        }
    }

    // One line of an animation that is not understood, or does not fit: all of it is kept as it is, with one
    // warning, and the rest of the entry is read.
    void hostileLinesAreKept_data() {
        QTest::addColumn<qsizetype>("line");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* line, const char* text) {
            const qsizetype index = everything.indexOf(line);
            if (index < 0) qFatal("%s", line);
            QTest::newRow(text) << index << QByteArray(text);
        };
        row("animation 48 30000/1001 there-and-back", "animation 0 24/1 off");
        row("animation 48 30000/1001 there-and-back", "animation 48 24 off");
        row("animation 48 30000/1001 there-and-back", "animation 48 24/0 off");
        row("animation 48 30000/1001 there-and-back", "animation 48 24/1 sometimes");
        row("animation 48 30000/1001 there-and-back", "animation 99999999999 24/1 off");
        row("animation 48 30000/1001 there-and-back", "animation 47 24/1 off");
        row("reference 0.5 -0.25", "reference 0.5");
        row("reference 0.5 -0.25", "reference 0.5 nan");
        row("track cage", "track cages");
        row("track map 2", "track map 0");
        row("track map 2", "track map 9");
        row("track map 2", "track map 2 3");
        row("word 3 1 2", "word 3 -1");
        row("word 3 1 2", "word 7");
        row("key 24 cubic", "key 24 wobbly");
        row("key 24 cubic", "key 0 cubic");
        row("key 24 cubic", "key 49 cubic");
        row("key 24 cubic", "key 24");
        row("handles 0.1 0 0.9 1", "handles 0.1 0 0.9");
        row("handles 0.1 0 0.9 1", "handles 1 0 0 1");
        row("handles 0.1 0 0.9 1", "handles 2 0 0.5 1");
        row("value 0 0 1 0 0 1", "value 0 0 1 0 0");
        row("value 0 -0.5 0.5 0 0.5 0", "value 0 -0.5 0.5 0 0.5 0 1 2");
        row("value 0 -0.5 0.5 0 0.5 0", "value 0 -0.5 0.5 0 0.5 1/2");
        row("look colour-by map", "look colour-by taste");
        row("look stop 0 #ff0000ff", "look stop 0.5 #ff0000ff");
        row("look brightness 4", "look brightness -4");
        row("look gamma 2", "look glow 2");
        row("look gamma 2", "look fog 1"); // in the plane
        row("look gamma 2", "look light 10");
        row("look contrast 1.5", "look contrast 0");
        row("look vibrancy 0", "look vibrancy 1.5");
        row("look shadow 0.5", "look shadow 2");
        row("value 0 1.5 10 1", "value 0 1.5 0 1");
        row("motion turn", "motion fly");
        row("of 1 3", "of 1 4");
        row("strength 4.5", "strength 1e9");
        row("wave 2", "wave 0");
        row("wave 2", "wave 2000");
        row("value 0.75 90 25", "value 0.75 90");
        row("count -3", "count 0");
        row("count -3", "count 1e3");
        row("pivot 1 2", "pivot 1");
        row("strength 0.125", "strength 1");
    }

    void hostileLinesAreKept() {
        QFETCH(qsizetype, line);
        QFETCH(QByteArray, text);
        QByteArrayList lines = everything;
        lines[line] = text;
        const FractalFile file = fileOf(entryWith(lines));
        const auto& entry = file.entries.first();
        QVERIFY(document::plane(*entry.fractal) && document::plane(*entry.fractal)->cage);
        QVERIFY(animationOf(file) == nullptr);
        QVERIFY(!entry.problems.isEmpty());
        for (const document::Problem& problem : entry.problems)
            QCOMPARE(problem.severity, document::Problem::Severity::Warning);
        QCOMPARE(io::writeFractint(file), entryWith(lines));
        const QByteArray edited = brightened(file);
        for (const QByteArray& kept : lines.mid(7))
            QVERIFY2(edited.contains("; barycage: " + kept + '\n'), kept.constData());
        QCOMPARE(fileOf(edited).entries.first().fractal->appearance.brightness, 7.0);
    }

    void linesWithoutABeginningAreKept() {
        const QByteArrayList lines{"key 0 linear", "value 1 2", "motion turn"};
        const FractalFile file = fileOf(entryWith(lines));
        QCOMPARE(file.entries.first().problems.size(), 3);
        QCOMPARE(io::writeFractint(file), entryWith(lines));
    }

    void theLastValidOneCounts() {
        const QByteArrayList lines{"animation 10 24/1 off",  "motion palette", "count 1",
                                   "animation 20 24/1 off",  "motion palette", "count 2",
                                   "animation 30 24/1 dull", "motion palette", "count 3"};
        const FractalFile file = fileOf(entryWith(lines));
        QCOMPARE(animationOf(file)->length, 20);
        QCOMPARE(io::writeFractint(file), entryWith(lines));
        const QByteArray edited = brightened(file);
        QCOMPARE(animationOf(fileOf(edited))->length, 20);
        for (const QByteArray& kept : lines)
            QVERIFY2(edited.contains("; barycage: " + kept + '\n'), kept.constData());
    }

    void tracksOfMapsThatAreGoneAreDropped() {
        Fractal fractal = *fileOf(entryWith(everything)).entries.first().fractal;
        auto& shape = *document::plane(fractal);
        shape.system.maps.erase(shape.system.maps.begin()); // map 1, of the branch and of the wind
        const Fractal kept = io::asStored(fractal);
        const auto& stored = *document::plane(kept)->animation;
        QCOMPARE(stored.maps.size(), 1u);
        QCOMPARE(stored.maps[0].map, ifs::MapId(1)); // it was the second
        QVERIFY(stored.branches.empty());
        QCOMPARE(std::get<animation::Sway<2>>(stored.motions[0]).maps, animation::MapIds{ifs::MapId(2)});
        QVERIFY(isValid(stored));
        shape.system.maps.erase(shape.system.maps.begin()); // map 2 breathed
        QCOMPARE(document::plane(io::asStored(fractal))->animation->motions.size(), 4u);
        shape.cage.reset();
        QVERIFY(document::plane(io::asStored(fractal))->animation->cage.empty());
    }
};

BARYCAGE_TEST(AnimationCommentsTest);
#include "animation_comments_test.moc"
