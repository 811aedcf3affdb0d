// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/facts.h"

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
bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

} // namespace

class FactsTest : public QObject {
    Q_OBJECT

private slots:
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
        QVERIFY((image.moments->mean - direct.moments->mean).norm() < 1e-12);
        QVERIFY((image.moments->covariance - direct.moments->covariance).norm() < 1e-11);
        QVERIFY(image.existence.verdict == direct.existence.verdict);
        QVERIFY(near(image.existence.contractivity, direct.existence.contractivity, 1e-12));
        QVERIFY(image.affinityDimension == code.affinityDimension);
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

    void nothingIsSaidOfASystemWithoutAnAttractor() {
        const Facts<2> facts = factsOf(systemOf({affineMap(2, 0, 0, 2, 1, 0)}));
        QVERIFY(!facts.box && !facts.simplex && !facts.hull && !facts.support && !facts.similarityDimension &&
                !facts.affinityDimension);
        QVERIFY(!moved(affineMap(1, 1, 0, 1, 0, 0), facts).box);
    }
};

QTEST_APPLESS_MAIN(FactsTest)
#include "facts_test.moc"
