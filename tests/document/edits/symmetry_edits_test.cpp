// SPDX-License-Identifier: MIT
#include "document/edits/maps/symmetry_edits.h"

#include "attractor/render/renderer.h"
#include "document/analysis/analysis.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/dimension_edits.h"
#include "document/edits/entries_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/animated_fractal.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QTest>

#include <Eigen/LU>

using document::Fractal;
using enum ifs::SymmetryGroup;

namespace {

Fractal leaf(const ifs::Symmetry<2>& symmetry) {
    document::System2 system;
    ifs::append(system, ifs::affineMap(.5, .2, -.2, .5, .4, .1));
    ifs::append(system, ifs::affineMap(.3, 0, 0, .1, .5, .2));
    system.symmetry = symmetry;
    return support::fractalOf(system, QStringLiteral("leaf"));
}

attractor::Frame drawn(const Fractal& fractal, std::uint64_t samples = 400'000) {
    attractor::Camera camera;
    camera.width = camera.height = 200;
    camera.pixelsPerUnit = 60;
    attractor::RenderRequest request = document::renderRequest(fractal, camera);
    request.samples = samples;
    return attractor::render(request);
}

bool isDrawn(const attractor::Frame& frame, int x, int y) {
    if (x < 0 || y < 0 || x >= frame.camera.width || y >= frame.camera.height) return false;
    const std::uint32_t ground = frame.pixels.front(); // nothing reaches the corner
    return frame.pixels[std::size_t(y) * std::size_t(frame.camera.width) + std::size_t(x)] != ground;
}

// Whether something is drawn within a pixel.
bool isNearDrawn(const attractor::Frame& frame, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (isDrawn(frame, x + dx, y + dy)) return true;
    return false;
}

} // namespace

class SymmetryEditsTest : public QObject {
    Q_OBJECT

private slots:
    // Byte for byte, in every way of colouring.
    void thePictureIsThatOfTheListedSystem() {
        for (const attractor::ColourBy colourBy :
             {attractor::ColourBy::Density, attractor::ColourBy::Map, attractor::ColourBy::Plain}) {
            Fractal symmetric = leaf({Dihedral, 6, 10, {0.1, 0.2}});
            symmetric.appearance.colourBy = colourBy;
            const Fractal listed = document::expanded(symmetric);
            QVERIFY(!document::isSymmetric(listed));
            QCOMPARE(document::system2(listed)->maps.size(), 24);
            const attractor::Frame one = drawn(symmetric), other = drawn(listed);
            QVERIFY(one.pixels == other.pixels);
            QVERIFY(one.pixels != drawn(leaf({})).pixels);
        }
    }

    void thePictureIsInvariant() {
        const Fractal symmetric = leaf({Rotation, 6});
        const attractor::Frame frame = drawn(symmetric, 4'000'000);
        int points = 0, missed = 0;
        for (const auto& element : ifs::elements(document::system2(symmetric)->symmetry))
            for (int y = 0; y < 200; ++y)
                for (int x = 0; x < 200; ++x) {
                    if (!isDrawn(frame, x, y)) continue;
                    const ifs::Vector<2> image = toPixel(
                        frame.camera, element(toWorld(frame.camera, ifs::Vector<2>(x + 0.5, y + 0.5))));
                    ++points;
                    if (!isNearDrawn(frame, int(std::floor(image.x())), int(std::floor(image.y())))) ++missed;
                }
        QVERIFY(points > 6 * 1000);
        QVERIFY2(missed < points / 1000, qPrintable(QStringLiteral("%1 of %2").arg(missed).arg(points)));
    }

    void factsAndExtentsAreThoseOfTheListedSystem() {
        const Fractal symmetric = leaf({Rotation, 5, 0, {0.3, 0}});
        const Fractal listed = document::expanded(symmetric);
        const auto box = document::displayedBox(symmetric), other = document::displayedBox(listed);
        QCOMPARE(box->min, other->min);
        QCOMPARE(box->max, other->max);
        document::AnalysisRequest request;
        request.fractal = std::make_shared<const Fractal>(symmetric);
        const auto facts = document::Analyser().begun(request).facts;
        request.fractal = std::make_shared<const Fractal>(listed);
        const auto factsOfListed = document::Analyser().begun(request).facts;
        QCOMPARE(facts.moments->mean, factsOfListed.moments->mean);
        QVERIFY((facts.moments->mean - ifs::Vector<2>(0.3, 0)).norm() < 1e-9);
        QCOMPARE(facts.similarityDimension, factsOfListed.similarityDimension);
        const auto cage = document::effectiveCage(symmetric), cageOfListed = document::effectiveCage(listed);
        QCOMPARE(cage.rest, cageOfListed.rest);
    }

    void inSpaceToo() {
        document::System3 system;
        ifs::append<3>(system, {ifs::Matrix<3>::Identity() / 3, {1, 0, 0}}, 1.0);
        system.symmetry.group = Octahedral;
        Fractal fractal = support::fractalOf(system);
        const auto support = document::spaceSupport(fractal);
        QVERIFY(support != nullptr);
        // One map to each of the six corners, four times each: corners at ±3/2.
        for (const ifs::Vector<3>& u :
             {ifs::Vector<3>(1, 0, 0), ifs::Vector<3>(0, -1, 0), ifs::Vector<3>(0, 0, 1)})
            QVERIFY(std::abs((*support)(u, 1e-9).value - 1.5) < 1e-6);
        QCOMPARE(document::system3(document::expanded(fractal))->maps.size(), 24);
    }

    void coloursOfMapsGoToTheirCopies() {
        Fractal fractal = leaf({Rotation, 2});
        const ifs::MapId second = document::system2(fractal)->maps[1].id;
        fractal.appearance.mapColours[second] = {1, 2, 3, 255};
        const Fractal listed = document::expanded(fractal);
        const auto& maps = document::system2(listed)->maps;
        QCOMPARE(maps[2].id, second);
        QVERIFY(*listed.appearance.mapColours.find(maps[3].id) == (attractor::Rgba{1, 2, 3, 255}));
        QVERIFY(listed.appearance.mapColours.find(maps[1].id) == nullptr);
    }

    void bakingTakesTheSymmetryAlong() {
        Fractal fractal = leaf({Rotation, 4, 0, {0.2, 0.1}});
        ifs::ControlCage<2> cage;
        cage.rest = {{0, 0}, {1, 0}, {0, 1}};
        cage.current = {{0, 0}, {2, 0.5}, {-0.3, 1}};
        document::plane(fractal)->cage = cage;
        const auto baked = document::baked(fractal);
        QVERIFY(baked.has_value());
        QVERIFY(document::isSymmetric(*baked));
        const auto box = document::displayedBox(fractal), after = document::displayedBox(*baked);
        QVERIFY((box->min - after->min).norm() < 1e-6);
        QVERIFY((box->max - after->max).norm() < 1e-6);
    }

    void liftedAndTurnedOver() {
        const Fractal fractal = leaf({Dihedral, 3, 20, {0.2, 0.1}});
        const auto lifted = document::lifted(fractal, std::nullopt);
        QVERIFY(lifted && document::isSymmetric(*lifted));
        const auto flat = document::flattened(*lifted, {0, 0, 1});
        QVERIFY(flat.has_value());
        QCOMPARE(document::system2(*flat)->maps.size(), 12);
        const auto support = document::supportFunction(fractal), after = document::supportFunction(*flat);
        for (const ifs::Vector<2>& u :
             {ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1), ifs::Vector<2>(-0.6, 0.8)})
            QVERIFY(std::abs((*support)(u, 1e-9).value - (*after)(u, 1e-9).value) < 1e-7);
        document::FractalFile file;
        document::Entry entry;
        entry.id = static_cast<document::EntryId>(1);
        entry.fractal = std::make_shared<const Fractal>(fractal);
        file.entries << entry;
        const Fractal turned = *document::turnedOver(file, {entry.id}).entries[0].fractal;
        const auto support2 = document::supportFunction(turned);
        QVERIFY(std::abs((*support)(ifs::Vector<2>(0.6, 0.8), 1e-9).value -
                         (*support2)(ifs::Vector<2>(0.6, -0.8), 1e-9).value) < 1e-7);
    }

    void obstacles() {
        document::System3 system;
        system.maps.resize(ifs::maxSymmetricMaps / 60 + 1);
        Fractal crowd = support::fractalOf(system, QStringLiteral("crowd"));
        QVERIFY(document::symmetryObstacle(crowd, 60).contains(QStringLiteral("crowd")));
        QVERIFY(document::symmetryObstacle(crowd, 24).isEmpty());
        QVERIFY(document::symmetryObstacle(crowd, 1).isEmpty());
        Fractal moving = leaf({Rotation, 3});
        QVERIFY(document::expandObstacle(moving).isEmpty());
        animation::Animation<2> animation;
        animation.length = 10;
        animation.motions.push_back(animation::Turn<2>{{}, 1, {0, 0}});
        document::plane(moving)->animation = animation;
        QVERIFY(document::expandObstacle(moving).contains(QStringLiteral("leaf")));
        // At every moment the picture is symmetric.
        const Fractal frame = document::frameAt(moving, animation::moment(5)).fractal;
        QVERIFY(document::isSymmetric(frame));
        document::plane(moving)->system.symmetry = {};
        QVERIFY(document::expandObstacle(moving).isEmpty());
        QVERIFY(!document::isSymmetric(Fractal{}));
        QVERIFY(document::expanded(Fractal{}) == Fractal{});
    }
};

BARYCAGE_TEST(SymmetryEditsTest);
#include "symmetry_edits_test.moc"
