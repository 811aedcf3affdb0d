// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/polygon.h"
#include "ifs/facts.h"
#include "ifs/separation/hull_cover.h"
#include "support/named_test.h"
#include "support/near.h"

#include <Eigen/Geometry>

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

IteratedFunctionSystem<2> systemOf(const Maps2& maps) {
    IteratedFunctionSystem<2> system;
    for (const auto& map : maps)
        append(system, map, 1);
    return system;
}
// Every corner turns left, and none is there twice.
bool isStrictlyConvex(const Polygon& polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()],
              &c = polygon[(k + 2) % polygon.size()];
        if (!(cross(b - a, c - b) > 0)) return false;
    }
    return polygon.size() > 2;
}
using support::near;

constexpr LongFact allLongFacts[] = {LongFact::Existence,    LongFact::Extents, LongFact::JointSpectralRadius,
                                     LongFact::Contacts,     LongFact::Hull,    LongFact::AffinityDimension,
                                     LongFact::ExtremePoints};

} // namespace

class FactsTest : public QObject {
    Q_OBJECT

private slots:
    // Cramer's rule knows the point, however far its map stretches before it contracts.
    void commonFixedPointIsTheWholeAttractor() {
        const auto isPoint = [](const auto& facts, const auto& point, double error) {
            QVERIFY(facts.isPoint && facts.box && facts.simplex && facts.hull && facts.mean && facts.moments);
            QCOMPARE(facts.similarityDimension, std::optional(0.0));
            QCOMPARE(facts.affinityDimension, std::optional(0.0));
            QCOMPARE(facts.invariants.measureDimension, std::optional(0.0));
            QVERIFY(facts.invariants.openSet->dimension && facts.invariants.openSet->dimension->value == 0);
            QVERIFY(facts.box->min == facts.box->max && facts.box->error <= error);
            QVERIFY((facts.box->min - point).norm() <= error + facts.box->error);
            QVERIFY(facts.hull->vertices.size() == 1 && facts.hull->error == facts.box->error);
            QVERIFY(facts.simplex->leg == 1 && facts.simplex->error == facts.box->error);
            QCOMPARE(facts.invariants.contacts->connectedness, Connectedness::Connected);
        };
        // A² = I/4, so that the point is 4/3 (I + A) b.
        const auto steep = factsOf(
            systemOf({affineMap(1629810176.25, -1629810175.75, 1629810176.75, -1629810176.25, 1, 0)}));
        isPoint(steep, Vector<2>(4 * 1629810177.25 / 3, 4 * 1629810176.75 / 3), 1e-5);
        QCOMPARE(steep.invariants.contacts->separation, Separation::Strong);
        QCOMPARE(steep.invariants.openSet->condition, OpenSetCondition::Holds);
        QVERIFY(steep.isHullExact && steep.extremePoints.size() == 1 && steep.extremePoints[0]);
        const auto image = moved(affineMap(0, -2, 2, 0, 1, 1), steep);
        QVERIFY((image.box->min - Vector<2>(1 - 8 * 1629810176.75 / 3, 1 + 8 * 1629810177.25 / 3)).norm() <=
                image.box->error + 1e-5);
        QVERIFY(image.box->error < 1e-4);
        const auto slow = factsOf(systemOf({affineMap(-0.9616878261478827, -0.4770864654484555,
                                                      -0.062416917643708686, -0.2227466199707716, 1, 0)}));
        isPoint(slow, Vector<2>(0.5161731930279738, -0.026348827429093467), 1e-15);
        const auto twice =
            factsOf(systemOf({affineMap(.5, 0, 0, .5, 1, 1), affineMap(.25, -.25, .25, .25, 2, 1)}));
        isPoint(twice, Vector<2>(2, 2), 0);
        // Both pieces are the whole point, whose maps have the sum 2.
        QCOMPARE(twice.invariants.openSet->condition, OpenSetCondition::Fails);
        IteratedFunctionSystem<3> solid;
        AffineMap<3> map;
        map.linear << -116337.67798311505, 2908.4169495908177, 58168.33899181635, 34901.003395089814,
            -0.9999994823501344, -17450.501697544907, -232673.3559672654, 5816.833899181635,
            116335.67798415036;
        map.translation = Vector<3>(1, 0, 0);
        append(solid, map, 1);
        const auto space = factsOf(solid);
        QVERIFY(space.isPoint && space.box);
        const Vector<3> point = space.box->min;
        isPoint(space, point, 1e-14 * point.norm());
    }

    // The facts of an image are those of the system that has it.
    void anImageIsTheAttractorOfTheConjugatedSystem() {
        const AffineMap<2> leaning = affineMap(1.2, 0.7, -0.3, -0.8, 2, -5); // turns over
        const Facts<2> code = factsOf(systemOf(maple()), 1e-9);
        const Facts<2> image = moved(leaning, code);
        const Facts<2> direct = factsOf(*conjugate(leaning, systemOf(maple())), 1e-9);
        QVERIFY((image.box->min - direct.box->min).norm() < 1e-10);
        QVERIFY((image.box->max - direct.box->max).norm() < 1e-10);
        QVERIFY(image.simplex->orientation == direct.simplex->orientation);
        QVERIFY(near(image.simplex->leg, direct.simplex->leg, 1e-10));
        QVERIFY(near(image.hull->area, direct.hull->area, 1e-7));
        QVERIFY(near(image.hull->area, code.hull->area * (1.2 * 0.8 - 0.7 * 0.3), 1e-10));
        QVERIFY(image.hull->error < 1e-8);
        QVERIFY((image.mean->point - direct.mean->point).norm() < 1e-12);
        QVERIFY((image.moments->mean - direct.moments->mean).norm() < 1e-12);
        QVERIFY((image.moments->covariance - direct.moments->covariance).norm() < 1e-11);
        QVERIFY(image.existence.verdict == direct.existence.verdict);
        QVERIFY(near(image.existence.contractivity, direct.existence.contractivity, 1e-12));
        QVERIFY(image.affinityDimension == code.affinityDimension);
    }

    void anImageInSpaceIsTheAttractorOfTheConjugatedSystem() {
        AffineMap<3> leaning; // turns over
        leaning.linear << 1.2, 0.7, 0, -0.3, -0.8, 0.1, 0.2, 0, 0.9;
        leaning.translation = {2, -5, 1};
        const double volume = determinant<3>(leaning.linear);
        QVERIFY(volume < 0);
        const Facts<3> code = factsOf(canonical::system(fern3()), 1e-2);
        const Facts<3> image = moved(leaning, code);
        const Facts<3> direct = factsOf(*conjugate(leaning, canonical::system(fern3())), 1e-2);
        QVERIFY((image.box->min - direct.box->min).norm() < 1e-9);
        QVERIFY((image.box->max - direct.box->max).norm() < 1e-9);
        QVERIFY(image.simplex->orientation == direct.simplex->orientation);
        QVERIFY(near(image.simplex->leg, direct.simplex->leg, 1e-9));
        QVERIFY(near(image.hull->volume, -volume * code.hull->volume, 1e-12));
        QVERIFY(near(image.hull->volume, direct.hull->volume, 0.03 * direct.hull->volume));
        const auto& [a, b, c] = image.hull->facets.front(); // seen from outside, as before
        const auto& corners = image.hull->vertices;
        const Vector<3> normal = (corners[std::size_t(b)] - corners[std::size_t(a)])
                                     .cross(corners[std::size_t(c)] - corners[std::size_t(a)]);
        QVERIFY(normal.dot(image.mean->point - corners[std::size_t(a)]) < 0);
        QVERIFY((image.moments->mean - direct.moments->mean).norm() < 1e-11);
        QVERIFY((image.moments->covariance - direct.moments->covariance).norm() < 1e-10);
        QVERIFY(image.existence.verdict == direct.existence.verdict);
        QCOMPARE(image.active.maps.size(), std::size_t(4));

        leaning.linear.row(1).setZero();
        const Facts<3> flat = moved(leaning, code);
        QVERIFY(flat.box && near(flat.box->min.y(), -5, 1e-9) && near(flat.box->max.y(), -5, 1e-9));
        QVERIFY(flat.active.maps.empty() && !flat.hull && !flat.similarityDimension);
    }

    // Hardly any word that can be tried contracts when a system leans so far; its attractor is there all the
    // same, and its extents stay sharp.
    void aFarLeaningImageKeepsItsFacts() {
        const Facts<2> code = factsOf(systemOf(maple()));
        const Facts<2> image = moved(affineMap(1, 300, 0, 1, 0, 0), code);
        QVERIFY(image.existence.verdict == Verdict::Hyperbolic ||
                image.existence.verdict == Verdict::EventuallyContractive);
        QCOMPARE(image.active.maps.size(), std::size_t(4));
        QVERIFY(near(image.box->max.y(), 5.07246376811594, 1e-8));
        QVERIFY(near(image.box->max.x(), (*code.support)({1, 300}).value, 1e-8));
        QVERIFY(image.box->error < 1e-7);
        QVERIFY(near(image.hull->area, code.hull->area, 1e-6));
    }

    void aFlatImageHasExtentsAndNoMaps() {
        const Facts<2> image = moved(affineMap(1, 0, 0, 0, 0, 3), factsOf(systemOf(maple())));
        QVERIFY(near(image.box->min.x(), -3.30009395647353, 1e-10));
        QVERIFY(near(image.box->max.x(), 3.34421444954056, 1e-10));
        QVERIFY(near(image.box->min.y(), 3, 1e-10) && near(image.box->max.y(), 3, 1e-10));
        QVERIFY(near(image.hull->area, 0, 1e-12));
        QVERIFY(image.active.maps.empty() && !image.affinityDimension);
    }

    // Far from the origin the points of several vertices, once they are known exactly, round to one.
    void noVertexIsThereTwice() {
        const Maps2 far{affineMap(-0.29175310664220233, 0.0887450621542083, -0.42621068652474703,
                                  -0.2156406490196141, 146924.32284086608, -200507.06028090726),
                        affineMap(0.2549841142478987, -0.30764087203317614, 0.07155274132933087,
                                  -0.10821902953575225, 12973.41409502367, -228799.0795529225),
                        affineMap(-0.3782705198663304, -0.37822990027846004, -0.41948928224637017,
                                  0.3500708739048479, 62181.07221292422, -88036.89607505628)};
        const Maps2 farther{affineMap(-0.35137642228175703, 0.47777080513460213, -0.0044941992071382275,
                                      0.4091648010223574, 230691.8025476347, -117717.62032433819),
                            affineMap(-0.25242302920952797, 0.35965390973393463, -0.239285832269863,
                                      -0.42094393526855545, 197173.08419371684, -260260.20428304616),
                            affineMap(0.3783503813610679, 0.16964004955898226, -0.07348934113770156,
                                      -0.45856000147294773, 96092.97243874912, -284363.0669289023)};
        for (const Maps2& maps : {far, farther, maple(), levy()}) {
            const Facts<2> facts = factsOf(systemOf(maps));
            const Polygon& corners = facts.hull->vertices;
            QVERIFY(isStrictlyConvex(corners));
            QCOMPARE(facts.extremePoints.size(), corners.size());
            std::size_t addressed = 0;
            for (std::size_t k = 0; k < corners.size(); ++k)
                if (facts.extremePoints[k]) {
                    ++addressed;
                    QCOMPARE(facts.extremePoints[k]->point, corners[k]);
                }
            QVERIFY(addressed > 0);
            QVERIFY(near(facts.hull->area, area(corners), 0));
            Random random(3);
            for (const auto& x : orbit<2>(maps, 2000, random))
                QVERIFY(distanceToConvex(corners, x) <= facts.hull->error);
        }
    }

    // Maps that hardly contract have an attractor, and its properties are correct within error bounds that
    // include rounding.
    void slowContractionsKeepTheirPromises() {
        struct Known {
            AffineMap<2> slow, fast;
            double low, high, sharp;
        };
        const double s = 0.999999999999, far = 1 / (1 - s);
        const Known systems[] = {{affineMap(s, 0, 0, .5, 1, 0), affineMap(.5, 0, 0, .5, 0, 0), 0, far, 0.5},
                                 {affineMap(s, 0, 0, .5, 0, 0), affineMap(s, 0, 0, .5, 1 - s, 0), 0, 1, 1e-2},
                                 {affineMap(-s, 0, 0, .5, 1, 0), affineMap(-.5, 0, 0, .5, 0, 0),
                                  1 - s / (1 - s / 2), 1 / (1 - s / 2), 1e-2}};
        for (const auto& [slow, fast, low, high, sharp] : systems) {
            const Facts<2> facts = factsOf(systemOf({slow, fast}));
            QCOMPARE(facts.existence.verdict, Verdict::Hyperbolic);
            const auto& box = *facts.box;
            QVERIFY(near(box.min.x(), low, box.error) && near(box.max.x(), high, box.error));
            QVERIFY(near(box.min.y(), 0, box.error) && near(box.max.y(), 0, box.error));
            QVERIFY(box.error <= sharp * (high - low));
            for (const double end : {low, high})
                QVERIFY(distanceToConvex(facts.hull->vertices, {end, 0}) <= facts.hull->error);
            QVERIFY(facts.hull->error <= sharp * (high - low));
        }
    }

    // Nothing is begun when the time is over, and everything that is left out is named.
    void whatTakesTooLongIsNamed() {
        FactLimits none;
        none.together = std::chrono::duration<double>(0);
        const Facts<2> facts = factsOf(systemOf(maple()), {}, none);
        for (const auto fact : allLongFacts)
            QVERIFY2(facts.isLate(fact) || fact == LongFact::ExtremePoints,
                     qPrintable(QString::number(int(fact))));
        QVERIFY(!facts.support && !facts.box && !facts.simplex && !facts.hull && !facts.affinityDimension);
        QVERIFY(!facts.invariants.jointSpectralRadius && !facts.invariants.contacts);
        QVERIFY(facts.mean && facts.moments && facts.invariants.entropy); // solved at once
        QCOMPARE(facts.probabilities.size(), maple().size());
        none.withAffinityDimension = false;
        QVERIFY(!factsOf(systemOf(maple()), {}, none).isLate(LongFact::AffinityDimension));
        const Facts<3> space = factsOf(canonical::system(fern3()), {}, none);
        QVERIFY(!space.hull && space.isLate(LongFact::Hull) && space.isLate(LongFact::AffinityDimension));
    }

    // Each by itself: what is quick is there all the same.
    void oneFactThatTakesTooLongIsLeftOut() {
        std::vector<AffineMap<2>> maps; // an attractor that is round has no end of corners
        for (int i = 0; i < 29; ++i) {
            const double c = 0.97 * std::cos(i), s = 0.97 * std::sin(i);
            maps.push_back(affineMap(c, -s, s, c, 7 * std::sin(5 * i), 7 * std::cos(3 * i)));
        }
        FactLimits limits;
        limits.withAffinityDimension = false;
        limits.perFact = std::chrono::duration<double>(1e-3);
        const Facts<2> cut = factsOf(systemOf(maps), 1e-13, limits);
        QVERIFY(cut.isLate(LongFact::Hull) && !cut.hull);
        QVERIFY(!cut.isLate(LongFact::Existence) && cut.existence.verdict == Verdict::Hyperbolic);
        QVERIFY(cut.invariants.jointSpectralRadius && cut.invariants.contacts);
        QCOMPARE(cut.isLate(LongFact::Extents), !cut.box);
    }

    void withoutLimitsNothingIsLate() {
        for (const auto& maps : {maple(), fern(), sierpinskiRight()}) {
            const Facts<2> facts = factsOf(systemOf(maps));
            QVERIFY(facts.late.empty() && facts.hull && facts.affinityDimension);
            QCOMPARE(facts.extremePoints.size(), facts.hull->vertices.size());
            FactLimits wide;
            wide.perFact = wide.together = std::chrono::duration<double>(1e6);
            const Facts<2> limited = factsOf(systemOf(maps), {}, wide);
            QVERIFY(limited.late.empty());
            QVERIFY(limited.hull->vertices == facts.hull->vertices);
            QVERIFY(limited.affinityDimension == facts.affinityDimension);
        }
    }

    // Pieces that must meet: W(hull) = hull, or two of them that cannot be disjoint.
    void whatCoversItsHullIsConnected() {
        const auto connectednessOf = [](const Maps2& maps) {
            return factsOf(systemOf(maps)).invariants.contacts->connectedness;
        };
        QCOMPARE(connectednessOf({affineMap(.9, 0, 0, .9, 0, 0), affineMap(.9, 0, 0, .9, 1, 0)}),
                 Connectedness::Connected);
        const auto four = [](double ratio) {
            Maps2 maps;
            for (const double x : {0.0, 1 - ratio})
                for (const double y : {0.0, 1 - ratio})
                    maps.push_back(affineMap(ratio, 0, 0, ratio, x, y));
            return maps;
        };
        QCOMPARE(connectednessOf(four(.6)), Connectedness::Connected);
        QCOMPARE(connectednessOf({affineMap(.6, 0, 0, .6, 0, 0), affineMap(.6, 0, 0, .6, .4, 0)}),
                 Connectedness::Connected);
        // Of a triangle, three pieces of .7 cover all; of .6, a hole is left.
        Maps2 triangle{affineMap(.7, 0, 0, .7, 0, 0), affineMap(.7, 0, 0, .7, .3, 0),
                       affineMap(.7, 0, 0, .7, 0, .3)};
        QCOMPARE(connectednessOf(triangle), Connectedness::Connected);
        QCOMPARE(connectednessOf(four(.4)), Connectedness::Disconnected);
        const Maps2 turning{affineMap(.5, -.5, .5, .5, 0, 0), affineMap(.3, .7, -.7, .3, 1, 0)};
        QCOMPARE(connectednessOf(turning), Connectedness::Connected); // ½ + .58 > 1
        // The analysis of the window has no addresses of the hull.
        const auto facts = geometricFacts(systemOf(four(.6)));
        QCOMPARE(invariantsOf(facts).contacts->connectedness, Connectedness::Connected);
    }

    // Of pieces with sides in multiples of 1/32, a gap holds a point with coordinates in multiples of 1/64.
    void coversOfHulls() {
        Random random(4);
        int covered = 0, exact = 0;
        constexpr int trials = 80;
        for (int n = 0; n < trials; ++n) {
            Maps2 maps; // in the corners of the unit square
            for (int k = 0; k < 4; ++k) {
                const double w = double(15 + random() % 5) / 32;
                maps.push_back(affineMap(w, 0, 0, w, k % 2 == 0 ? 0 : 1 - w, k / 2 == 0 ? 0 : 1 - w));
            }
            const auto facts = factsOf(systemOf(maps));
            if (!facts.isHullExact) continue;
            ++exact;
            bool isHeld = true;
            for (int x = 0; x <= 64; ++x)
                for (int y = 0; y <= 64; ++y)
                    isHeld = isHeld && std::ranges::any_of(maps, [&](const AffineMap<2>& map) {
                                 const Vector<2> low = map.translation, high = map(Vector<2>(1, 1));
                                 return low.x() <= x / 64. && x / 64. <= high.x() && low.y() <= y / 64. &&
                                        y / 64. <= high.y();
                             });
            QCOMPARE(imagesCoverHull(facts.active.maps, facts.extremePoints), isHeld);
            covered += isHeld ? 1 : 0;
        }
        QVERIFY2(covered > 2 && covered < exact - 2,
                 qPrintable(QStringLiteral("%1 of %2").arg(covered).arg(exact)));
        QVERIFY(exact > trials / 2);
    }

    // No measure has a larger dimension than the line or plane that holds the attractor.
    void measuresAreCapped() {
        const auto onALine =
            factsOf(systemOf({affineMap(.9, 0, 0, .9, 0, 0), affineMap(.9, 0, 0, .9, 1, 0)}));
        QVERIFY(near(onALine.invariants.measureDimension, 1) && onALine.invariants.isMeasureDimensionCapped);
        const auto slanted =
            factsOf(systemOf({affineMap(.9, 0, 0, .9, 0, 0), affineMap(.9, 0, 0, .9, 1, 2)}));
        QVERIFY(near(slanted.invariants.measureDimension, 1) && slanted.invariants.isMeasureDimensionCapped);
        const auto plain = factsOf(systemOf(sierpinskiRight()));
        QVERIFY(near(plain.invariants.measureDimension, std::log2(3.0)));
        QVERIFY(!plain.invariants.isMeasureDimensionCapped);
        const auto full = factsOf(systemOf(square()));
        QVERIFY(near(full.invariants.measureDimension, 2) && !full.invariants.isMeasureDimensionCapped);
    }

    // Where maps are no similarities, too, an area and determinants of sum 1 leave no room for overlaps.
    void anAreaProvesTheOpenSetCondition() {
        Maps2 boxes;
        for (int k = 0; k < 8; ++k)
            boxes.push_back(affineMap(.5, 0, 0, .25, .5 * (k % 2), .25 * (k / 2)));
        const OpenSetFacts found = *factsOf(systemOf(boxes)).invariants.openSet;
        QCOMPARE(found.condition, OpenSetCondition::Holds);
        QCOMPARE(found.certainty, Certainty::Exact);
        QVERIFY(found.dimension && found.dimension->value == 2); // the unit square
        QCOMPARE(found.dimension->proof, HausdorffDimension::Proof::Convex);
    }

    // What needs a factor below 1 is unavailable; the affinity dimension is 2, since Σ|det A_i| is 1 but for
    // rounding.
    void withoutAFactorTheAffinityDimensionIsKnown() {
        const double slow = .9999999999999999;
        const Facts<2> facts =
            factsOf(systemOf({affineMap(slow, 1, 0, .5, 1, 0), affineMap(.5, 1, 0, slow, 0, 1)}));
        QVERIFY(facts.existence.exists() && !facts.existence.hasFactor());
        QVERIFY(!facts.support && !facts.box && !facts.simplex && !facts.hull && !facts.similarityDimension);
        QVERIFY(near(facts.affinityDimension, 2, 1e-6));
        QVERIFY(facts.affinityDimensionError > 0 && facts.affinityDimensionError <= 1e-6);
    }

    void nothingIsSaidOfASystemWithoutAnAttractor() {
        const Facts<2> facts = factsOf(systemOf({affineMap(2, 0, 0, 2, 1, 0)}));
        QVERIFY(!facts.box && !facts.simplex && !facts.hull && !facts.support && !facts.similarityDimension &&
                !facts.affinityDimension);
        QVERIFY(!moved(affineMap(1, 1, 0, 1, 0, 0), facts).box);
    }
};

BARYCAGE_TEST(FactsTest);
#include "facts_test.moc"
