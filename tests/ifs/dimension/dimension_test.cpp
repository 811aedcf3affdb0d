// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/dimension/common_eigendirections.h"
#include "ifs/dimension/dimension.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <numeric>
#include <utility>

using namespace ifs;
using namespace canonical;
using support::near;

namespace {

double moran(std::vector<double> ratios) {
    return moranDimension(ratios).value_or(-1);
}

} // namespace

class DimensionTest : public QObject {
    Q_OBJECT

private slots:
    void moranOracles() {
        QVERIFY(near(moran({.5, .5, .5}), 1.584962500721156, 1e-12));
        QVERIFY(near(moran({1. / 3, 1. / 3, 1. / 3, 1. / 3}), 1.261859507142915, 1e-12));
        QVERIFY(near(moran({.5, 1. / 3, .25}), 1.082131498140418, 1e-12));
        QVERIFY(near(moran({.5, .25}), 0.694241913630617, 1e-12));
        QCOMPARE(moran({.5}), 0.0);
        QVERIFY(near(moran(std::vector<double>(1000, .999)), std::log(1000) / -std::log(.999), 1e-8));
        QVERIFY(near(moran({.995, .995}), std::log(2) / -std::log(.995), 1e-9));
        const std::vector<double> none, one{1.0, .5}, zero{.5, 0}, bad{quietNaN, .5};
        for (const auto& ratios : {none, one, zero, bad})
            QVERIFY(!moranDimension(ratios));
    }

    // However many ratios there are.
    void veryManyRatios() {
        std::vector<double> ratios;
        for (int i = 0; i < 4000; ++i) // 4000 copies of 1/8000 have dimension ln 4000/ln 8000
            ratios.push_back(1.0 / 8000);
        QVERIFY(std::abs(moran(ratios) - std::log(4000) / std::log(8000)) < 1e-14);
        ratios.assign(1000,
                      0.5e-3); // 1/2 and a thousandth of it, a thousand times: at dimension 1 their sum is 1
        ratios.push_back(0.5);
        QVERIFY(std::abs(moran(ratios) - 1) < 1e-14);
    }

    void similaritySystems() {
        QVERIFY(near(similarityDimension<2>(koch()), 1.261859507142915, 1e-12));
        QVERIFY(near(similarityDimension<2>(flower()), 1.192493117800738, 1e-12));
        for (const auto& maps : {levy(), twin(), heighway()}) {
            QVERIFY(near(similarityDimension<2>(maps), 2, 1e-12));
            QVERIFY(near(affinityDimension(maps), 2, 2e-6));
        }
        QVERIFY(near(similarityDimension<3>(tetrahedron()), 2, 1e-12));
        QVERIFY(near(similarityDimension<3>(cube()), 3, 1e-12));
        QVERIFY(!similarityDimension<2>(maple()) && !similarityDimension<2>(fern()));
        QVERIFY(!similarityDimension<3>(fern3()) && !similarityDimension<2>({}));
    }

    // Not the norms but the common form of the maps tells, so a change of coordinates hides nothing.
    void similaritySystemsInAnyCoordinates() {
        Random random(1);
        for (int n = 0; n < 200; ++n) {
            const AffineMap<2> t{randomWellConditioned<2>(random), {1, 2}};
            for (const auto& maps : {koch(), flower(), twin(), sierpinskiRight()}) {
                const auto there = mapsOf(*conjugate(t, canonical::system<2>(maps)));
                QVERIFY(near(similarityDimension<2>(there), *similarityDimension<2>(maps), 1e-9));
            }
        }
    }

    void affinityOracles() {
        QVERIFY(near(affinityDimension(fern()), 1.834896, 2e-6));
        QVERIFY(near(affinityDimension(maple()), 2.036330, 2e-6));
        // Boxes of 1/3 × 1/2: three of them, one norm and one determinant, φ^t = (1/2)(1/3)^(t−1).
        const Maps2 carpet{affineMap(1. / 3, 0, 0, .5, 0, 0), affineMap(1. / 3, 0, 0, .5, 1. / 3, 0),
                           affineMap(1. / 3, 0, 0, .5, 2. / 3, .5)};
        QVERIFY(near(affinityDimension(carpet), 1 + std::log(1.5) / std::log(3), 2e-6));
        QCOMPARE(affinityDimension(Maps2{maple()[0]}).value_or(-1), 0.0);
        QVERIFY(!affinityDimension({}));
        QVERIFY(!affinityDimension(Maps2{affineMap(1, 0, 0, 1, 0, 0), maple()[0]}));
        const Maps2 points(3, affineMap(0, 0, 0, 0, 1, 2));
        QVERIFY(near(affinityDimension(points), 0, 1e-6));
    }

    // Words of flat maps are products of numbers along a graph.
    void flatMaps() {
        const AffineMap<2> none = affineMap(0, 0, 0, 0, 0, 0), alongX = affineMap(.5, 0, 0, 0, 0, 0),
                           alongY = affineMap(0, 0, 0, .5, 0, .5), aside = affineMap(0, .5, 0, 0, 1, 1),
                           back = affineMap(0, 0, .5, 0, 1, 1), far = affineMap(0, 5, 0, 0, 1, 1);
        const double golden = 0.694241913630617; // log₂((1 + √5)/2)
        const struct {
            Maps2 maps;
            double dimension;
        } systems[] = {
            {{alongX, alongY}, 0},             // no word mixes the two, and each has one alone
            {{aside, aside, aside, aside}, 0}, // two in a row are a point
            {{far, far}, 0},
            {{alongX, none}, 0},
            {{aside, back}, 0}, // only to and fro
            {{alongX, alongX}, 1},
            {{alongX, alongX, alongX}, 1}, // a line has no more
            {{alongX, affineMap(.25, 0, 0, 0, 1, 1)}, golden},
            {{alongX, back, aside}, golden}, // words of the graph that the golden mean counts
        };
        Random random(1);
        for (const auto& [maps, dimension] : systems) {
            QVERIFY(near(affinityDimension(maps), dimension, 1e-8));
            // Turned, rounding leaves determinants of 1e-17, and products that should vanish likewise.
            const AffineMap<2> turn = similarity(1, uniform(random, 0, 6), 1, 2);
            QVERIFY(near(affinityDimension(mapsOf(*conjugate(turn, canonical::system<2>(maps)))), dimension,
                         1e-8));
        }
        // Too many to look at every pair.
        Maps2 many;
        for (int n = 0; n < 2000; ++n)
            many.push_back({1e-3 * randomVector<2>(random) * randomVector<2>(random).transpose(),
                            randomVector<2>(random)});
        QVERIFY(!affinityDimension(many));
    }

    // Triangular maps, and such as exchange two lines, grow like numbers: Falconer and Miao.
    void mapsThatKeepOrExchangeLines() {
        const double golden = 0.694241913630617;
        const Maps2 exchange{affineMap(0, .5, .25, 0, 0, 0), affineMap(0, .6, .2, 0, 1, 0)};
        Maps2 squares; // all products of two: half the pressure, the same zero
        for (const auto& a : exchange)
            for (const auto& b : exchange)
                squares.push_back(a * b);
        const struct {
            Maps2 maps;
            double dimension;
        } systems[] = {
            {{affineMap(.5, .3, 0, .5, 0, 0), affineMap(.25, -.2, 0, .25, 1, 0)}, golden},
            {{affineMap(.6, .01, 0, .6, 0, 0), affineMap(.6, 0, 0, .6, 1, 0)}, std::log(2) / -std::log(.6)},
            {{affineMap(.5, 0, 0, .25, 0, 0), affineMap(.25, 0, 0, .5, 1, 1)}, golden},
            {exchange, 0.662353312063},
            {squares, 0.662353312063},
            // Above 1: |a||d|^(t−1) of a single shape, thrice.
            {{affineMap(.5, .1, 0, 1. / 3, 0, 0), affineMap(.5, .2, 0, 1. / 3, 1, 0),
              affineMap(.5, -.3, 0, 1. / 3, 0, 1)},
             1 + std::log(1.5) / std::log(3)},
            // One that keeps the axes and one that exchanges them: 2⁻ᵗ = x with (1 − x)(1 − x²) = x⁴.
            {{affineMap(.5, 0, 0, .25, 0, 0), affineMap(0, .25, .25, 0, 1, 1)}, 0.597294123103},
        };
        Random random(5);
        for (const auto& [maps, dimension] : systems) {
            QVERIFY(near(commonEigendirectionsDimension(maps), dimension, 1e-11));
            const AffineMap<2> there{randomWellConditioned<2>(random), {1, 2}};
            QVERIFY(near(affinityDimension(mapsOf(*conjugate(there, canonical::system<2>(maps)))), dimension,
                         1e-6));
        }
        QVERIFY(!commonEigendirectionsDimension(fern()));
        QVERIFY(!commonEigendirectionsDimension(maple()));
        QVERIFY(!commonEigendirectionsDimension(flower()));
    }

    // A line that is all but kept, and no number from directions that have not settled: within 1e-6 or none.
    void nearlyCommonLines() {
        int said = 0;
        for (const double slight : {1e-2, .1}) {
            const Maps2 maps{affineMap(.5, .3, slight, .5, 0, 0), affineMap(.25, -.2, 0, .25, 1, 0)};
            const auto found = affinityDimension(maps);
            Maps2 squares;
            for (const auto& a : maps)
                for (const auto& b : maps)
                    squares.push_back(a * b);
            const auto same = affinityDimension(squares);
            said += found ? 1 : 0;
            QVERIFY(!found || !same || near(found, *same, 2e-6));
        }
        QVERIFY(said > 0);
    }

    // The sums over all words of one length neither grow nor fall at the dimension.
    void flatMapsByTheirWords() {
        Random random(2);
        for (int n = 0; n < 10; ++n) {
            Maps2 maps;
            for (int k = 0; k < 5; ++k)
                maps.push_back({0.2 * randomVector<2>(random) * randomVector<2>(random).transpose(),
                                randomVector<2>(random)});
            const double dimension = *affinityDimension(maps);
            QVERIFY(dimension > 0 && dimension < 1);
            std::vector<Matrix<2>> words{Matrix<2>::Identity()};
            double before = 0, sum = 0;
            for (int length = 1; length <= 7; ++length) {
                std::vector<Matrix<2>> longer;
                for (const auto& word : words)
                    for (const auto& map : maps)
                        longer.push_back(word * map.linear);
                words = std::move(longer);
                before = std::exchange(sum, 0);
                for (const auto& word : words)
                    sum += singularValueFunction<2>(word, dimension);
            }
            QVERIFY(std::abs(sum / before - 1) < 1e-3);
        }
    }

    // A number is given only where finer directions leave it.
    void onlyWhatSettlesIsSaid() {
        QVERIFY(near(affinityDimension(eventual()), 1.2462647, 3e-7));
        // Other functions that come back turned or with other signs look settled long before they are.
        QVERIFY(near(affinityDimension({{affineMap(.69697, -.481061, -.393939, -.662879, 0, 0),
                                         affineMap(.090909, -.443182, .515152, -.094697, 0, 0)}}),
                     1.6206657, 3e-7));
        // Words with both flat maps vanish; 0.4^t + 0.3^t is the most that the others grow by.
        const Maps2 cross{affineMap(.4, 0, 0, 0, 0, 0), affineMap(0, 0, 0, .4, 0, 0),
                          affineMap(.2, 0, 0, .3, 1, 0)};
        QVERIFY(near(affinityDimension(cross), moran({.4, .3}), 1e-9));
        Random random(3);
        for (int n = 0; n < 20; ++n) {
            // Diagonal maps: the pressure is the larger of two sums.
            Maps2 maps;
            std::vector<double> wide, high;
            for (int k = 0; k < 3; ++k) {
                wide.push_back(uniform(random, .01, .3));
                high.push_back(uniform(random, .01, .3));
                maps.push_back(affineMap(wide.back(), 0, 0, high.back(), 0, 0));
            }
            const double dimension = std::max(moran(wide), moran(high)); // below 1
            const auto diagonal = affinityDimension(maps);
            QVERIFY(dimension < 1 && (!diagonal || near(diagonal, dimension, 2e-6)));
        }
        // Where no value is known, the weights use the bound from the single maps, whose terms they are.
        const Maps2 nearlyKept{affineMap(.3, .2, 1e-6, .3, 0, 0), affineMap(.15, -.1, 0, .15, 1, 0)};
        QVERIFY(!affinityDimension(nearlyKept));
        const std::vector<double> weights = dimensionWeights<2>(nearlyKept);
        const auto exponent = [](double weight, const AffineMap<2>& map) { // below 1: φ^t is a power
            return std::log(weight) / std::log(spectralNorm<2>(map.linear));
        };
        const double bound = exponent(weights[0], nearlyKept[0]);
        QVERIFY(bound > 0 && bound <= 1 && near(exponent(weights[1], nearlyKept[1]), bound, 1e-9));
    }

    void singularValueFunctionJoinsItsPieces() {
        const Matrix<2> m = maple()[2].linear;
        QVERIFY(near(singularValueFunction<2>(m, 0), 1, 0));
        QVERIFY(near(singularValueFunction<2>(m, 1), spectralNorm<2>(m), 1e-15));
        QVERIFY(near(singularValueFunction<2>(m, 2), 0.399, 1e-15));
        QVERIFY(near(singularValueFunction<2>(m, 4), 0.399 * 0.399, 1e-15));
        const Vector<3> sigma = singularValues<3>(fern3()[2].linear);
        QVERIFY(near(singularValueFunction<3>(fern3()[2].linear, 2.5),
                     sigma[0] * sigma[1] * std::sqrt(sigma[2]), 1e-14));
    }

    void dimensionRule() {
        for (const double p : dimensionWeights<2>(sierpinskiRight()))
            QVERIFY(near(p, 1. / 3, 1e-12));
        const double d = *similarityDimension<2>(flower());
        const auto p = dimensionWeights<2>(flower());
        QVERIFY(near(p[0], std::pow(std::sqrt(0.3109), d), 1e-10));
        const auto capped = dimensionWeights<2>(maple()), determinants = determinantWeights<2>(maple());
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(near(capped[i], determinants[i], 1e-12));
        const auto inSpace = dimensionWeights<3>(fern3());
        QVERIFY(near(std::accumulate(inSpace.begin(), inSpace.end(), 0.0), 1, 1e-14));
        QVERIFY(dimensionWeights<2>({}).empty());
    }

    // Eigenvalues ±½ of differences of numbers above 10⁹: what rounding leaves of them is no dimension.
    void nothingOfWhatCancels() {
        const double far = 1629810176;
        for (const double scale : {1., .5, 1.5}) {
            const Matrix<2> linear =
                scale * affineMap(far + .25, .25 - far, far + .75, -far - .25, 0, 0).linear;
            const auto found = affinityDimension(Maps2{{linear, {1, 0}}, {linear, {0, 1}}});
            QVERIFY(!found || near(found, -std::log(2) / std::log(scale / 2), 1e-6));
        }
    }
};

BARYCAGE_TEST(DimensionTest);
#include "dimension_test.moc"
