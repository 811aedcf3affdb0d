// SPDX-License-Identifier: MIT
#include "ifs/tops/families.h"

#include "ifs/tops/fractal_transformation.h"
#include "support/named_test.h"
#include "top_systems.h"

#include <QTest>

using ifs::Vector;

// Systems of the triangle and the square family.
class FamiliesTest : public QObject {
    Q_OBJECT

private slots:
    void areThoseOfTheOracles() {
        QVERIFY(ifs::triangleFamily({.65, .3, .4}) == tops::triangle(.65, .3, .4));
        const auto square = ifs::squareFamily({.3, .6}), expected = tops::square(.3, .6);
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY((square[i].linear - expected[i].linear).norm() < 1e-15);
            QVERIFY((square[i].translation - expected[i].translation).norm() < 1e-15);
        }
    }

    // docs/mathematics.md, "Fractal tops".
    void transformTheTriangle() {
        const auto half = ifs::triangleFamily({.5, .5, .5}), moved = ifs::triangleFamily({.65, .3, .4});
        const ifs::FractalTransformation transformation(tops::attractorOf(half), moved);
        const std::pair<Vector<2>, Vector<2>> known[] = {{{.5, 0}, {.65, 0}},
                                                         {{.25, 0}, {.2275, 0}},
                                                         {{.5, .25}, {.6825, .195}},
                                                         {{.375, .375}, {.557375, .32175}},
                                                         {{0, 0}, {0, 0}},
                                                         {{1, 0}, {1, 0}},
                                                         {{0, 1}, {0, 1}}};
        for (const auto& [x, y] : known) {
            const auto answer = transformation.at(x);
            QVERIFY(answer.image);
            QVERIFY((*answer.image - y).norm() < 1e-9);
        }
    }

    void parametersAreFoundAgain() {
        using Values = std::vector<double>;
        QCOMPARE(ifs::familyParameters(ifs::triangleFamily({.5, .5, .5})).value_or(Values()).size(),
                 std::size_t(3));
        const auto triangle = ifs::familyParameters(ifs::triangleFamily({.1, .75, .9}));
        QVERIFY(triangle);
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs((*triangle)[k] - Values{.1, .75, .9}[k]) < 1e-12);
        const auto square = ifs::familyParameters(ifs::squareFamily({.2, .8}));
        QVERIFY(square && square->size() == 2);
        QVERIFY(std::abs((*square)[1] - .8) < 1e-12);
        auto bent = ifs::squareFamily({.2, .8});
        bent[3].linear(0, 1) = .01;
        QVERIFY(!ifs::familyParameters(bent));
        QVERIFY(!ifs::familyParameters(tops::interval(.5)));
        QVERIFY(!ifs::familyParameters(tops::reversed(ifs::triangleFamily({.5, .5, .5}))));
    }
};

BARYCAGE_TEST(FamiliesTest);
#include "families_test.moc"
