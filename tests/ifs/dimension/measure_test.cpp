// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/dimension/measure.h"
#include "ifs/existence/attractor_existence.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;
using support::near;

class MeasureTest : public QObject {
    Q_OBJECT

private slots:
    void ofTheGasket() {
        const auto even = activeMaps(canonical::system<2>(sierpinskiRight(), {1, 1, 1}));
        QVERIFY(near(entropy(even.probabilities), std::log(3), 1e-14));
        QVERIFY(near(*lyapunovExponent(even), -std::log(2), 1e-14));
        QVERIFY(near(*measureDimension(even), std::log2(3), 1e-14));
        const auto uneven = activeMaps(canonical::system<2>(sierpinskiRight(), {2, 1, 1}));
        QVERIFY(near(entropy(uneven.probabilities), 1.5 * std::log(2), 1e-14));
        QVERIFY(near(*measureDimension(uneven), 1.5, 1e-14));
        const auto leaning = activeMaps(
            *conjugate(affineMap(1, 7, 0, 2, 1, 1), canonical::system<2>(sierpinskiRight(), {2, 1, 1})));
        QVERIFY(near(*measureDimension(leaning), 1.5, 1e-9));
    }

    void ofDifferentRatios() {
        const Maps2 maps{affineMap(.5, 0, 0, .5, 0, 0), affineMap(0, -.25, .25, 0, 1, 0)};
        const auto active = activeMaps(canonical::system<2>(maps, {3, 1}));
        QVERIFY(near(*lyapunovExponent(active), -1.25 * std::log(2), 1e-14));
        QVERIFY(near(entropy(active.probabilities), 2 * std::log(2) - 0.75 * std::log(3), 1e-14));
    }

    void notOfOtherMaps() {
        const auto active = activeMaps(canonical::system<2>(fern(), fernWeights));
        QVERIFY(!lyapunovExponent(active) && !measureDimension(active));
        QVERIFY(entropy(active.probabilities) > 0);
        QCOMPARE(entropy(std::vector<double>{1}), 0.0);
        // Above the dimension of the plane, where much overlaps.
        const Maps2 many(9, affineMap(.5, 0, 0, .5, 0, 0));
        QVERIFY(near(*measureDimension(activeMaps(canonical::system<2>(many, std::vector<double>(9, 1)))),
                     std::log2(9), 1e-12));
    }

    void spectrumOfACantorSet() {
        const Maps2 maps{affineMap(1. / 3, 0, 0, 1. / 3, 0, 0), affineMap(1. / 3, 0, 0, 1. / 3, 2. / 3, 0)};
        const auto spectrum = dimensionSpectrum(activeMaps(canonical::system<2>(maps, {3, 7})));
        QVERIFY(spectrum && near(spectrum->capacity, std::log(2) / std::log(3), 1e-12));
        QVERIFY(near(spectrum->information, 0.556032649876389, 1e-12));
        QVERIFY(near(spectrum->correlation, 0.495832042896650, 1e-12));
        QVERIFY(near(spectrum->least, -std::log(.7) / std::log(3), 1e-12));
        const auto even = dimensionSpectrum(activeMaps(canonical::system<2>(maps, {1, 1})));
        QVERIFY(near(even->least, even->capacity, 1e-12) && near(even->correlation, even->capacity, 1e-12));
        QVERIFY(!dimensionSpectrum(activeMaps(canonical::system<2>(fern(), fernWeights))));
    }

    void jointSpectralRadii() {
        const auto radius = jointSpectralRadius<2>(eventual(), classify<2>(eventual()));
        QVERIFY(radius.least >= 0.727412389 && radius.least <= 0.814999439);
        QVERIFY(radius.most >= 0.727412389 && radius.most <= 0.9);
        const auto tree = jointSpectralRadius<2>(maple(), classify<2>(maple()));
        QVERIFY(tree.least >= 0.7 && tree.most <= 0.7233 && tree.least <= tree.most);
        const auto gasket = jointSpectralRadius<2>(sierpinskiRight(), classify<2>(sierpinskiRight()));
        QVERIFY(gasket.least <= 0.5 && gasket.most >= 0.5 && gasket.most - gasket.least < 1e-12);
        const auto inSpace = jointSpectralRadius<3>(fern3(), classify<3>(fern3()));
        QVERIFY(inSpace.least <= inSpace.most && inSpace.most < 0.86 && inSpace.least > 0.85);
        // An interval of a sheared system holds that of the system.
        const auto baked = mapsOf(*conjugate(affineMap(1, 40, 0, 1, 0, 0), canonical::system<2>(flower())));
        const auto sheared = jointSpectralRadius<2>(baked, classify<2>(baked));
        QVERIFY(sheared.least <= 0.560802995713 && sheared.most >= 0.560802995711);
        QVERIFY(sheared.least > 0.5608 && sheared.most < 0.5609);
    }
};

BARYCAGE_TEST(MeasureTest);
#include "measure_test.moc"
