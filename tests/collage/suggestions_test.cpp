// SPDX-License-Identifier: MIT
#include "collage/drawings.h"
#include "collage/suggestions.h"
#include "io/collection_reader.h"
#include "io/file/save_file.h"
#include "support/named_test.h"
#include "support/near.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace collage;

namespace {

SearchOptions options(int maps, std::size_t starts) {
    SearchOptions options;
    options.minMaps = options.maxMaps = maps;
    options.starts = starts;
    options.seed = 5;
    options.threads = 2;
    return options;
}

struct Entry {
    QString name;
    std::vector<ifs::AffineMap<2>> maps;
    std::vector<double> probabilities;
};

// The entries of the collection in the plane with 2 to 6 maps that are contractions, unlinked. Those of
// transformations are entries of other themes once more.
std::vector<Entry> collection() {
    std::vector<Entry> entries;
    const QDir folder(support::sourcePath(QStringLiteral("ifs_library")));
    for (const QString& file : folder.entryList({QStringLiteral("*.ifs")}, QDir::Files, QDir::Name)) {
        if (file == QStringLiteral("transformations.ifs")) continue;
        for (const document::Entry& entry :
             io::readCollection(io::loadFile(folder.filePath(file)).bytes, file).file.entries) {
            const document::System2* system = document::system2(*entry.fractal);
            if (system == nullptr) continue;
            const auto active = ifs::activeMaps(*system);
            if (active.maps.size() < 2 || active.maps.size() > 6 || contraction(active.maps) >= 1) continue;
            if (active.isLinked()) continue;
            entries.push_back({entry.fractal->name, active.maps, active.probabilities});
        }
    }
    return entries;
}

double between(std::mt19937& random, double least, double greatest) {
    return least + (greatest - least) * random() * 0x1p-32;
}

// Turned by `angle`, scaled by `scale`, and narrower or wider along x by `width`; mirrored if that is
// negative.
ifs::AffineMap<2> placed(double scale, double angle, double width, double x, double y) {
    const double a = scale * std::cos(angle), b = scale * std::sin(angle);
    return ifs::affineMap(width * a, -b, width * b, a, x, y);
}

// A stem, what is above the lowest leaves, and a leaf on either side.
Entry randomFern(unsigned seed) {
    std::mt19937 random(seed);
    const double scale = between(random, 0.76, 0.87), bend = between(random, -0.09, 0.09);
    std::vector<ifs::AffineMap<2>> maps{ifs::affineMap(0, 0, 0, between(random, 0.1, 0.2), 0, 0),
                                        placed(scale, bend, 1, 0, 1 - scale)};
    for (const double side : {1.0, -1.0}) {
        const double size = between(random, 0.22, 0.36), angle = between(random, 0.6, 1.2);
        const double width = between(random, 0.7, 1.1) * (side < 0 && seed % 2 == 1 ? -1 : 1);
        maps.push_back(placed(size, side * angle, width, 0, between(random, 0.05, 0.2)));
    }
    return {QStringLiteral("fern %1").arg(seed), maps, {0.02, 0.74, 0.12, 0.12}};
}

// What is inside its outermost turn, and one part, or two, of that.
Entry randomSpiral(unsigned seed) {
    std::mt19937 random(seed);
    const double scale = between(random, 0.82, 0.9), turn = between(random, 0.3, 0.8);
    std::vector<ifs::AffineMap<2>> maps{placed(scale, seed % 4 < 2 ? turn : -turn, 1, 0, 0)};
    std::vector<double> probabilities{scale * scale};
    for (unsigned part = 0; part <= seed % 2; ++part) {
        const double size = between(random, 0.2, 0.35), angle = between(random, 0, 6);
        maps.push_back(part == 0 ? placed(size, angle, 1, 1, 0) : placed(size, angle, 1, -0.6, 0.4));
        probabilities.push_back(size * size);
    }
    return {QStringLiteral("spiral %1").arg(seed), maps, probabilities};
}

} // namespace

class SuggestionsTest : public QObject {
    Q_OBJECT

private slots:
    void drawingsAreApproximated_data() {
        QTest::addColumn<int>("drawing");
        QTest::addColumn<int>("maps");
        QTest::addColumn<double>("mean"); // pixels of 256
        const auto row = [](const char* name, int drawing, int maps, double mean) {
            QTest::newRow(name) << drawing << maps << mean;
        };
        row("disc", 0, 4, 0.2);
        row("ring", 1, 6, 1);
        row("star", 2, 5, 0.6);
        row("L", 3, 4, 0.4);
        row("leaf", 4, 4, 0.4);
        row("hollow triangle", 5, 6, 1.2);
        row("T", 6, 4, 0.8);
        row("separate discs", 7, 6, 1.2);
    }
    void drawingsAreApproximated() {
        QFETCH(int, drawing);
        QFETCH(int, maps);
        QFETCH(double, mean);
        const Mask mask = drawings::all(256)[std::size_t(drawing)].mask;
        const Suggestions found = suggestions(mask, options(maps, 128));
        QCOMPARE(found.starts, 128U);
        const Suggestion& best = found.list.front();
        QVERIFY2(best.attractor.mean <= mean, qPrintable(QString::number(best.attractor.mean)));
        QCOMPARE(int(best.maps.size()), maps);
        QVERIFY(contraction(best.maps) <= 0.9 + 1e-9);
        QVERIFY(best.collage.bound.has_value());
        QVERIFY(support::near(std::accumulate(best.weights.begin(), best.weights.end(), 0.0), 1, 1e-9));
    }

    // One of their maps is near the identity, so that random starts hardly ever meet it.
    void fernsAndSpiralsAreFound_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("areFerns");
        QTest::addColumn<double>("mean"); // of all, pixels of 256
        QTest::newRow("ferns") << (support::isThorough() ? 8 : 3) << true << 0.55;
        QTest::newRow("spirals") << (support::isThorough() ? 4 : 3) << false << 0.45;
    }
    void fernsAndSpiralsAreFound() {
        QFETCH(int, count);
        QFETCH(bool, areFerns);
        QFETCH(double, mean);
        double sum = 0;
        for (int seed = 1; seed <= count; ++seed) {
            const Entry entry = areFerns ? randomFern(unsigned(seed)) : randomSpiral(unsigned(seed));
            const auto maps = drawings::fitted(entry.maps, entry.probabilities);
            const Mask mask = drawings::chaosGame(maps, entry.probabilities, 256, 400'000);
            const Suggestions found = suggestions(mask, options(int(maps.size()), 256));
            const double here = found.list.front().attractor.mean;
            qInfo("%s: %.2f", qPrintable(entry.name), here);
            QVERIFY2(here <= 1.5, qPrintable(entry.name));
            sum += here;
        }
        QVERIFY2(sum <= mean * count, qPrintable(QString::number(sum / count)));
    }

    // Two turns of a ring that shrink it by a tenth are a good collage, and their attractor is a point. Of
    // what is found, too, other systems have the better collages.
    void nearIdentitiesDoNotWin() {
        const Mask mask = drawings::all(256)[1].mask;
        const Target ring = target(mask, 1, 0.25);
        const std::vector near{placed(0.9, 1, 1, 0, 0), placed(0.9, 2, 1, 0, 0)};
        const Suggestions found = suggestions(mask, options(2, 128));
        QVERIFY(found.list.size() > 1);
        const Suggestion& best = found.list.front();
        QVERIFY(best.collage.images.mean > collageMeasure(ring, near).images.mean);
        QVERIFY(std::ranges::any_of(found.list, [&](const Suggestion& other) {
            return other.collage.images.mean < best.collage.images.mean;
        }));
        for (const Suggestion& one : found.list)
            QVERIFY(contraction(one.maps) <= 0.9 + 1e-9);
        const double apart = attractorAgreement(ring, near).mean;
        QVERIFY2(best.attractor.mean < apart / 8, qPrintable(QString::number(best.attractor.mean)));
    }

    void resultsAreDistinct() {
        const Mask mask = drawings::all(128)[4].mask;
        const Suggestions found = suggestions(mask, options(3, 96));
        QVERIFY(found.list.size() >= 2);
        const double size = target(mask, 1, 0).size;
        for (std::size_t i = 0; i < found.list.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY(!isAlike(found.list[i], found.list[k], size));
        QVERIFY(isAlike(found.list[0], found.list[0], size));
    }

    void theNumberOfThreadsChangesNothing_data() {
        QTest::addColumn<int>("minMaps");
        QTest::newRow("four maps") << 4;
        QTest::newRow("two to four maps") << 2;
    }
    void theNumberOfThreadsChangesNothing() {
        QFETCH(int, minMaps);
        const Mask mask = drawings::all(128)[6].mask;
        SearchOptions one = options(4, 75);
        one.minMaps = minMaps;
        one.threads = 1;
        const Suggestions expected = suggestions(mask, one);
        for (const int threads : {2, 5}) {
            one.threads = threads;
            const Suggestions found = suggestions(mask, one);
            QCOMPARE(found.starts, 75U);
            QCOMPARE(found.list.size(), expected.list.size());
            for (std::size_t i = 0; i < found.list.size(); ++i) {
                QCOMPARE(found.list[i].maps, expected.list[i].maps);
                QCOMPARE(found.list[i].weights, expected.list[i].weights);
            }
        }
        one.seed = 6;
        QVERIFY(suggestions(mask, one).list.front().maps != expected.list.front().maps);
    }

    void timeDecidesOnlyHowManyStarts() {
        const Mask mask = drawings::all(128)[3].mask;
        SearchOptions timed = options(3, 0);
        timed.time = std::chrono::duration<double>(0.2);
        const Suggestions found = suggestions(mask, timed);
        QVERIFY(found.starts > 0);
        QCOMPARE(suggestions(mask, options(3, found.starts)).list.front().maps, found.list.front().maps);
    }

    void moreMapsMustPayForThemselves() {
        SearchOptions range = options(2, 300);
        range.maxMaps = 8;
        const Suggestions disc = suggestions(drawings::all(128)[0].mask, range);
        QVERIFY2(disc.list.front().maps.size() <= 5,
                 qPrintable(QString::number(disc.list.front().maps.size())));
        const Suggestions ring = suggestions(drawings::all(128)[1].mask, range);
        QVERIFY(ring.list.front().maps.size() > disc.list.front().maps.size());
    }

    void aStopEndsTheSearch() {
        std::stop_source source;
        source.request_stop();
        QVERIFY(suggestions(drawings::all(64)[0].mask, options(3, 1'000'000), {}, source.get_token())
                    .list.empty());
    }

    void smallestShapesHaveSuggestions() {
        Mask pixel = emptyMask(16, 16);
        pixel.cells[pixel.index(3, 12)] = 1;
        Mask line = emptyMask(400, 20);
        for (int x = 10; x < 300; ++x)
            line.cells[line.index(x, 4)] = 1;
        for (const Mask& mask : {pixel, line}) {
            const Suggestions found = suggestions(mask, options(2, 32));
            QVERIFY(!found.list.empty());
            QVERIFY2(found.list.front().attractor.mean < 0.5,
                     qPrintable(QString::number(found.list.front().attractor.mean)));
        }
    }

    // Across a drawn line, the steps between its cells must not be taken for what the maps do.
    void obliqueLinesAreFound() {
        Mask line = emptyMask(200, 150);
        for (int x = 10; x < 190; ++x)
            line.cells[line.index(x, 137 - int(0.69 * (x - 10)))] = 1;
        const Suggestions found = suggestions(line, options(2, 64));
        QVERIFY(!found.list.empty());
        QVERIFY2(found.list.front().attractor.mean < 1.5,
                 qPrintable(QString::number(found.list.front().attractor.mean)));
    }

    // Every attractor is the collage that its maps make of it, to within a pixel of 256, and the bound holds.
    // A sample, or all.
    void attractorsAreCollagesOfThemselves() {
        const std::vector<Entry> entries = collection();
        const Grid picture{-0.5, 0.5, 1.0 / 256, 256, 256};
        for (std::size_t i = 0; i < entries.size(); i += support::isThorough() ? 1 : 12) {
            const auto maps = drawings::fitted(entries[i].maps, entries[i].probabilities);
            const Target own = target(attractorMask(picture, maps), 1, 0.25);
            const CollageMeasure measure = collageMeasure(own, maps);
            const Agreement attractor = attractorAgreement(own, maps);
            const QByteArray name = entries[i].name.toUtf8();
            QVERIFY2(measure.images.hausdorff <= 1.5, name.constData());
            QVERIFY2(measure.images.mean <= 0.15, name.constData());
            QVERIFY2(attractor.mean <= 0.01, name.constData());
            QVERIFY2(measure.bound && *measure.bound >= attractor.hausdorff, name.constData());
        }
    }

    // Pictures of fractals that are systems of so many maps: four in five to 1.5 pixels of 256. A sample of
    // them, or all.
    void attractorsOfTheCollection() {
        const std::vector<Entry> entries = collection();
        QVERIFY(entries.size() > 40);
        const std::size_t step = support::isThorough() ? 1 : entries.size() / 5;
        int good = 0, all = 0;
        for (std::size_t i = 0; i < entries.size(); i += step) {
            const auto maps = drawings::fitted(entries[i].maps, entries[i].probabilities);
            const Mask mask = drawings::chaosGame(maps, entries[i].probabilities, 256, 400'000);
            const double mean = suggestions(mask, options(int(maps.size()), 256)).list.front().attractor.mean;
            ++all;
            if (mean <= 1.5) ++good;
            if (support::isThorough() || mean > 1.5)
                qInfo("%s (%zu maps): %.2f", qPrintable(entries[i].name), maps.size(), mean);
        }
        QVERIFY2(good >= 0.8 * all, qPrintable(QStringLiteral("%1 of %2").arg(good).arg(all)));
    }
};

BARYCAGE_TEST(SuggestionsTest);
#include "suggestions_test.moc"
