// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/space_cage_edits.h"
#include "document/fractal/space_geometry.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using document::Fractal;
using ifs::Vector;

namespace {

Fractal menger() {
    return support::fractalOf(systems::menger(), QStringLiteral("menger"));
}

// Its tetrahedron pulled by a corner and turned.
Fractal moved() {
    Fractal fractal = menger();
    auto cage = *document::spaceCage(fractal);
    cage.current[0] += Vector<3>(0.3, -0.2, 0.1);
    cage.current[2] = cage.current[2] * 1.5 + Vector<3>(0, 0, 1);
    document::space(fractal)->cage = cage;
    return fractal;
}

ifs::AffineMap<3> placed(const Fractal& fractal) {
    return ifs::displayMap(*document::spaceCage(fractal));
}

// Whether the maps that act on what is displayed are the same.
bool isSamePicture(const Fractal& a, const Fractal& b) {
    const auto p = ifs::conjugate(placed(a), *document::system3(a));
    const auto q = ifs::conjugate(placed(b), *document::system3(b));
    if (!p || !q || p->maps.size() != q->maps.size()) return false;
    for (std::size_t k = 0; k < p->maps.size(); ++k) {
        const ifs::AffineMap<3>&x = p->maps[k].map, &y = q->maps[k].map;
        if ((x.linear - y.linear).norm() > 1e-9 || (x.translation - y.translation).norm() > 1e-9)
            return false;
    }
    return true;
}

bool holds(const Fractal& fractal) { // the corners of what is displayed are in its cage
    const auto cage = *document::spaceCage(fractal);
    ifs::Simplex<3> simplex;
    std::ranges::copy(cage.rest, simplex.begin());
    for (int k = 0; k < 8; ++k)
        for (const double weight : ifs::barycentric<3>(simplex, Vector<3>(k & 1, k >> 1 & 1, k >> 2)))
            if (weight < -1e-5) return false;
    return true;
}

} // namespace

class SpaceCageEditsTest : public QObject {
    Q_OBJECT

private slots:
    void bakingKeepsThePicture() {
        QVERIFY(!document::bakeObstacle(menger()).isEmpty()); // at rest
        const auto baked = document::baked(moved());
        QVERIFY(baked);
        QVERIFY(document::isAtRest(*baked));
        QVERIFY(isSamePicture(*baked, moved()));
        QVERIFY(!document::isSameSystem(*baked, moved()));
    }

    void aFlatCageIsNotBaked() {
        Fractal flat = moved();
        auto& cage = *document::space(flat)->cage;
        cage.current[3] = (cage.current[0] + cage.current[1]) / 2;
        QVERIFY(document::bakeObstacle(flat).contains(u"flat"));
        QVERIFY(!document::baked(flat));
        QVERIFY(document::fitObstacle(flat).contains(u"flat"));
    }

    void unbakingKeepsThePictureAndGivesTheCodeOfTheUnitTetrahedron() {
        const auto unbaked = document::unbaked(menger());
        QVERIFY(unbaked);
        QVERIFY(isSamePicture(*unbaked, menger()));
        const auto& cage = document::space(*unbaked)->cage;
        QCOMPARE(cage->rest[0], Vector<3>(0, 0, 0));
        QCOMPARE(cage->rest[3], Vector<3>(0, 0, 1));
        QVERIFY(!document::unbakeObstacle(*unbaked).isEmpty());
        const auto back = document::baked(*unbaked);
        QVERIFY(back && isSamePicture(*back, menger()));
    }

    void rewritingKeepsTheCageAtRest() {
        auto cage = *document::spaceCage(menger());
        cage.current[1].x() += 0.5;
        const Fractal rewritten = document::withCageMoved(menger(), cage, document::CageMode::Rewrite);
        const Fractal there = document::withCageMoved(menger(), cage, document::CageMode::Place);
        QVERIFY(document::isAtRest(rewritten));
        QVERIFY(!document::isAtRest(there));
        QVERIFY(isSamePicture(rewritten, there));
        QVERIFY(document::isSameSystem(there, menger()));
    }

    void everyOrientationHoldsThePicture() {
        for (int k = 0; k < 8; ++k) {
            const ifs::Orientation<3> orientation{(k & 1) != 0 ? -1 : 1, (k & 2) != 0 ? -1 : 1,
                                                  (k & 4) != 0 ? -1 : 1};
            const auto fitted = document::withTetrahedronFitted(menger(), orientation);
            QVERIFY(fitted);
            QVERIFY(isSamePicture(*fitted, menger()));
            QVERIFY(holds(*fitted));
            const auto& corners = document::space(*fitted)->cage->current;
            for (int axis = 0; axis < 3; ++axis)
                QCOMPARE(corners[std::size_t(axis + 1)][axis] > corners[0][axis],
                         orientation[std::size_t(axis)] > 0);
            const auto ofMoved = document::withTetrahedronFitted(moved(), orientation);
            QVERIFY(ofMoved && isSamePicture(*ofMoved, moved()));
        }
        const auto minimal = document::withTetrahedronFitted(menger());
        QVERIFY(minimal && !document::space(*minimal)->cage); // it follows the code
    }

    void aPolyhedronHoldsThePictureAndBendsIt() {
        using document::SpacePolyhedron;
        for (const auto& [choice, corners] : {std::pair{SpacePolyhedron::Box, std::size_t(8)},
                                              {SpacePolyhedron::Octahedron, std::size_t(6)},
                                              {SpacePolyhedron::Hull, std::size_t(8)}}) { // of a cube its box
            for (const Fractal& before : {menger(), moved()}) {
                const auto fitted = document::withPolyhedronFitted(before, choice);
                QVERIFY(fitted && isSamePicture(*fitted, before));
                const auto& cage = *document::space(*fitted)->cage;
                QVERIFY(before == menger() ? cage.rest.size() == corners : cage.rest.size() >= 6);
                QVERIFY(ifs::isValid(cage) && !ifs::bends(cage));
            }
            Fractal bent = *document::withPolyhedronFitted(menger(), choice);
            document::space(bent)->cage->current[3] += Vector<3>(0.5, 0.5, 0.5);
            QVERIFY(ifs::bends(*document::space(bent)->cage));
            QVERIFY(document::bakeObstacle(bent).contains(u"bends"));
            QVERIFY(!document::baked(bent));
            QVERIFY(document::fitObstacle(bent).contains(u"bends"));
            QVERIFY(!document::withPolyhedronFitted(bent, choice) || !document::fitObstacle(bent).isEmpty());
            // The affine fit can be baked.
            document::space(bent)->cage->deformation = ifs::Deformation::AffineFit;
            QVERIFY(document::baked(bent));
            QVERIFY(document::isAtRest(document::withCageAtRest(bent)));
        }
    }

    void threeEdgesOfTheBoxHoldThePicture() {
        const auto fitted = document::withBoxFitted(menger());
        QVERIFY(fitted && isSamePicture(*fitted, menger()));
        QVERIFY(document::space(*fitted)->cage->current[0].norm() < 1e-4);
        QVERIFY((document::space(*fitted)->cage->current[1] - Vector<3>(1, 0, 0)).norm() < 1e-4);
        const auto ofMoved = document::withBoxFitted(moved());
        QVERIFY(ofMoved && isSamePicture(*ofMoved, moved()));
    }

    void actionsAreOneStepEach() {
        document::Document document;
        document.setFile(document::fileOf(moved()));
        QVERIFY(!document::bakeCage(document));
        QCOMPARE(document.undoStack()->count(), 1);
        QVERIFY(!document::unbakeCage(document));
        QCOMPARE(document.undoStack()->count(), 2);
        QVERIFY(document::unbakeCage(document)); // says why not
        QVERIFY(!document::resetCage(document));
        QVERIFY(!document::fitMinimalCanonicalSimplex(document));
        QCOMPARE(document.undoStack()->count(), 4);
        document.undoStack()->setIndex(0);
        QVERIFY(document.fractal() == moved());
    }

    void systemsWithoutAnAttractorSayWhy() {
        Fractal none = menger();
        for (auto& map : document::system3(none)->maps)
            map.map.linear *= 9;
        QVERIFY(!document::fitObstacle(none).isEmpty());
        QVERIFY(!document::withTetrahedronFitted(none));
        QVERIFY(!document::withBoxFitted(none));
        document::system3(none)->maps.clear();
        QVERIFY(document::fitObstacle(none).contains(u"No map"));
    }
};

BARYCAGE_TEST(SpaceCageEditsTest, QCoreApplication);
#include "space_cage_edits_test.moc"
