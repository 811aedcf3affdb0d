// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_words.h"
#include "ifs/copies/pictured_systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

// Takagi's function: the first entry of the linear part is a half to the length of the word.
Maps2 takagi() {
    return {affineMap(.5, 0, .5, .5, 0, 0), affineMap(.5, 0, -.5, .5, .5, .5)};
}
// Its copies become thin in directions of their own long before they are small.
Maps2 turning() {
    return {affineMap(-.29162, .202607, -.407927, .241756, 1.195094, .507223),
            affineMap(.287476, -.190696, 0, 0, .402597, 1.694427)};
}
std::optional<CopyWords> written(const Maps2& maps, std::size_t firstProjection = 0,
                                 std::vector<MovedBranch<2>> moved = {}) {
    const CopyFrame frame = *CopyFrame::of(maps, pictured(maps).display);
    return copyWords(maps, pieces<2>(moved, maps.size()), frame, firstProjection);
}

} // namespace

class CopyWordsTest : public QObject {
    Q_OBJECT

private slots:
    // Every address begins with exactly one of the words: their shares sum to 1.
    void wordsAreACutSet() {
        const auto words = written(takagi());
        QVERIFY(words && words->words.size() > 100);
        double sum = 0;
        for (const auto& word : words->words)
            sum += word.map.linear(0, 0);
        QCOMPARE(sum, 1.);
        QVERIFY(std::ranges::is_sorted(words->words, {}, [](const auto& word) { return word.copy.first; }));
        QVERIFY(words->words.front().copy.first == 0u && words->words.back().copy.first == 1u);
    }

    // As dots and bars, none of them too thin to be seen, and where the attractor is.
    void wordsAreSeen() {
        for (const Maps2& maps : {takagi(), turning()}) {
            const CopyFrame frame = *CopyFrame::of(maps, pictured(maps).display);
            const auto words = copyWords(maps, pieces<2>({}, maps.size()), frame, 0);
            QVERIFY(words);
            for (const auto& word : words->words) {
                const auto sigma = singularValues<2>(word.copy.map.linear);
                QVERIFY(word.copy.level == 0);
                QVERIFY(sigma[1] > frame.thinness / 4 * (1 - 1e-9));
                if (word.copy.projection) QVERIFY(sigma[1] > frame.thinness * (1 - 1e-9));
                QVERIFY(singularValues<2>(word.map.linear)[1] < frame.thinness); // as large as it can be
                QVERIFY((word.copy.map(frame.centre) - word.map(frame.centre)).norm() <
                        1e-12 * frame.diameter);
            }
        }
    }

    void projectionsAreSharedAndNumbered() {
        const auto words = written(turning(), 2);
        QVERIFY(words && !words->projections.empty());
        std::vector<bool> used(words->projections.size());
        std::size_t flat = 0;
        for (const auto& word : words->words) {
            if (!word.copy.projection) continue;
            ++flat;
            QVERIFY(*word.copy.projection >= 2 && *word.copy.projection - 2 < used.size());
            used[*word.copy.projection - 2] = true;
        }
        QVERIFY(std::ranges::all_of(used, std::identity()));
        QVERIFY(used.size() <= flat);
    }

    void movedBranchesAreWrittenWhereTheyAre() {
        const AffineMap<2> aside = affineMap(1, 0, 0, 1, 0, 5);
        const auto words = written(takagi(), 0, {{{1}, aside}});
        QVERIFY(words);
        for (const auto& word : words->words) {
            const double height = word.map(Vector<2>(0, 0)).y();
            QVERIFY(word.copy.first == 1u ? height >= 5 : height < 2);
        }
    }

    void largePicturesAreNotWritten() { QVERIFY(!written(sierpinskiRight())); }
};

BARYCAGE_TEST(CopyWordsTest);
#include "copy_words_test.moc"
