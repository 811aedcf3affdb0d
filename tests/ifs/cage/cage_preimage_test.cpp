// SPDX-License-Identifier: MIT
#include "ifs/cage/cage_preimage.h"
#include "support/named_test.h"

#include <QtTest>

#include <random>

using namespace ifs;

namespace {

std::vector<Vector<3>> unitCube() {
    std::vector<Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    return corners;
}

CageDeformation bent() {
    const auto rest = unitCube();
    auto current = rest;
    current[7] += Vector<3>(0.5, 0.3, -0.2);
    current[2] += Vector<3>(-0.2, 0.1, 0.3);
    return CageDeformation(rest, current);
}

} // namespace

class CagePreimageTest : public QObject {
    Q_OBJECT

private slots:
    void leadsBack() {
        const CageDeformation bend = bent();
        std::mt19937 random(7);
        const auto share = [&] { return random() * 0x1p-32; };
        for (int n = 0; n < 200; ++n) {
            const Vector<3> x(share(), share(), share());
            const auto found = preimage(bend, bend(x), Vector<3>::Constant(0.5));
            QVERIFY(found);
            QVERIFY((*found - x).norm() < 1e-8);
        }
    }

    // To first order, what the derivative says is what the bend does.
    void theDerivativeIsThatOfTheBend() {
        const CageDeformation bend = bent();
        const Vector<3> x(0.3, 0.6, 0.4), by(2e-4, -1e-4, 3e-4);
        const Vector<3> way = bend(x + by) - bend(x);
        QVERIFY((way - by).norm() > 1e-5); // it is no shift
        QVERIFY((way - derivative(bend, x) * by).norm() < 1e-6);
    }

    // All of the cage lies in a plane: nothing is displayed in front of it.
    void aFlatCageHasNone() {
        auto flat = unitCube();
        for (Vector<3>& vertex : flat)
            vertex.z() = 0;
        flat[7] += Vector<3>(0.5, 0, 0);
        QVERIFY(!preimage(CageDeformation(unitCube(), flat), {0.5, 0.5, 1}, Vector<3>::Constant(0.5)));
    }
};

BARYCAGE_TEST(CagePreimageTest);
#include "cage_preimage_test.moc"
