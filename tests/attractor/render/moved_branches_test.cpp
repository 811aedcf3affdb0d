// SPDX-License-Identifier: MIT
#include "attractor/cut/address_cut.h"
#include "attractor/render/renderer.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace attractor;
using ifs::Vector;

namespace {

using Moved = std::vector<ifs::MovedBranch<2>>;

ifs::AffineMap<2> turned(double angle, double x, double y) {
    return ifs::affineMap(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), x, y);
}

// One branch outside the maple, one inside another, one of an overlapping part.
const Moved mapleMoved{{{2}, turned(0.4, 3, 1)}, {{2, 3}, turned(-0.5, 0, 2)}, {{1, 0, 3}, turned(1, -4, 0)}};

// A chaos game that follows the definition literally: the last maps are kept, and the words of the address
// that they form move the point, the longest word first; the orbit itself is not moved.
std::vector<Vector<2>> pointsOf(const RenderRequest& request, int count) {
    const PreparedSystem d = prepared(request.system);
    std::mt19937_64 random(5);
    std::discrete_distribution<int> choice(d.probabilities.begin(), d.probabilities.end());
    ifs::Word address;
    Vector<2> x = d.centre;
    std::vector<Vector<2>> result;
    for (int n = -100; n < count; ++n) {
        address.insert(address.begin(), choice(random));
        x = d.maps[std::size_t(address.front())](x);
        address.resize(std::min<std::size_t>(address.size(), 8));
        if (n < 0) continue;
        Vector<2> shown = x;
        for (std::size_t length = 8; length > 0; --length)
            for (const auto& [word, change] : request.moved)
                if (word.size() == length && std::equal(word.begin(), word.end(), address.begin()))
                    shown = change(shown);
        result.push_back(shown);
    }
    return result;
}

RenderRequest movedMaple(std::uint64_t samples) {
    RenderRequest request = systems::request(systems::maple(), samples, 300, 300);
    request.moved = mapleMoved;
    request.camera = fitted(request.camera, {-8, -5}, {9, 9});
    return request;
}

// Pixels with something within a pixel of them in `other` or nothing in themselves, as a share of all with
// something.
double covered(const std::vector<bool>& pixels, const std::vector<bool>& other, int width) {
    const int height = int(pixels.size()) / width;
    int lit = 0;
    int found = 0;
    for (int y = 1; y + 1 < height; ++y)
        for (int x = 1; x + 1 < width; ++x) {
            if (!pixels[std::size_t(y * width + x)]) continue;
            ++lit;
            bool near = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    near = near || other[std::size_t((y + dy) * width + x + dx)];
            found += near ? 1 : 0;
        }
    return lit > 0 ? double(found) / lit : 0;
}

std::vector<bool> lit(const RenderRequest& request) {
    std::vector<bool> result;
    for (const std::uint32_t pixel : render(request).pixels)
        result.push_back(systems::grey(pixel) > 0);
    return result;
}

std::vector<bool> occupied(const RenderRequest& request, const ifs::Placement& placement, int count) {
    const Camera& camera = request.camera;
    std::vector<bool> result(std::size_t(camera.width) * std::size_t(camera.height));
    for (const Vector<2>& point : pointsOf(request, count)) {
        const Vector<2> pixel = toPixel(camera, placement(point));
        if (pixel.minCoeff() >= 0 && pixel.x() < camera.width && pixel.y() < camera.height)
            result[std::size_t(int(pixel.y()) * camera.width + int(pixel.x()))] = true;
    }
    return result;
}

void compare(const RenderRequest& request, const ifs::Placement& placement, int points) {
    const std::vector<bool> drawn = lit(request);
    const std::vector<bool> expected = occupied(request, placement, points);
    const double missed = covered(expected, drawn, request.camera.width);
    const double added = covered(drawn, expected, request.camera.width);
    QVERIFY2(missed > 0.999 && added > 0.99, qPrintable(QStringLiteral("%1 %2").arg(missed).arg(added)));
}

} // namespace

class TestMovedBranches : public QObject {
    Q_OBJECT

private slots:
    void densityIsWhatTheDefinitionSays() { compare(movedMaple(3'000'000), {}, 3'000'000); }

    // As many points in each piece as its probability says: the orbit is not moved with them.
    void theChaosGameMovesPointsNotItsOrbit() {
        RenderRequest request = movedMaple(1'000'000);
        request.algorithm = Algorithm::ChaosGame;
        compare(request, {}, 2'000'000);
        const PreparedSystem system = prepared(request.system, request.moved);
        Orbit orbit(system, 3);
        const PreparedSystem plain = prepared(request.system);
        Orbit same(plain, 3);
        int moved = 0;
        for (int n = 0; n < 20'000; ++n) {
            const Orbit::Point a = orbit.next();
            const Orbit::Point b = same.next();
            QCOMPARE(a.lastMap, b.lastMap);
            if (a.lastMap == 2)
                ++moved;
            else if (a.lastMap != 1)
                QVERIFY(a.x == b.x);
            QVERIFY(a.lastMap != 2 || a.x != b.x);
        }
        QVERIFY(moved > 1000);
    }

    // Weights and positions of the words of a cut, against the chaos game, in a coarse grid.
    void wordsOfTheCutHaveTheirMeasure() {
        const RenderRequest request = movedMaple(1);
        const PreparedSystem system = prepared(request.system, request.moved);
        const AddressCut cut = addressCut(system, projection(request.camera, {}, 1), {});
        QVERIFY(std::abs(cut.probability - 1) < 1e-9);
        constexpr int side = 20;
        std::vector<double> shares(side * side);
        const auto cell = [&](const Vector<2>& pixel) {
            return std::size_t(int(pixel.y() * side / 300) * side + int(pixel.x() * side / 300));
        };
        SampleSet samples;
        drawSamples(system, 1, 0, samples);
        for (const Word& word : cut.words)
            for (std::size_t k = 0; k < 64; ++k) {
                const double x = samples.x[word.offset + k];
                const double y = samples.y[word.offset + k];
                shares[cell({word.xx * x + word.xy * y + word.x, word.yx * x + word.yy * y + word.y})] +=
                    word.probability / 64;
            }
        const std::vector<Vector<2>> points = pointsOf(request, 1'000'000);
        for (const Vector<2>& point : points)
            shares[cell(toPixel(request.camera, point))] -= 1 / double(points.size());
        double difference = 0;
        for (const double share : shares)
            difference += std::abs(share) / 2;
        QVERIFY2(difference < 0.02, qPrintable(QString::number(difference)));
    }

    // Wⁿ moves what the n maps tell of, and no branch that is longer.
    void imagesOfTheDeterministicAlgorithmMove() {
        RenderRequest request = systems::request(systems::sierpinski(), 1, 400, 200);
        request.cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {0, 1}});
        request.moved = {{{1, 1}, turned(0, 1, 0)}};
        request.camera = fitted(request.camera, {-0.1, -0.1}, {2.1, 1.1});
        request.algorithm = Algorithm::Deterministic;
        const auto isLit = [&](double x, double y) {
            const Vector<2> pixel = toPixel(request.camera, Vector<2>(x, y));
            const Frame frame = render(request);
            return systems::grey(
                       frame.pixels[std::size_t(int(pixel.y()) * request.camera.width + int(pixel.x()))]) > 0;
        };
        request.iterations = 1;
        QVERIFY(isLit(0.85, 0.05) && !isLit(1.85, 0.05));
        request.iterations = 2;
        QVERIFY(!isLit(0.85, 0.05) && isLit(1.85, 0.05) && isLit(0.1, 0.1));
    }

    // Far inside a moved branch there is what is far inside it where it comes from.
    void movedBranchesAreAsDeep() {
        RenderRequest plain = systems::request(systems::maple(), 200'000, 200, 200);
        const std::vector<ifs::AffineMap<2>> maps = ifs::activeMaps(plain.system).maps;
        const Vector<2> inside = *ifs::addressPoint<2>(maps, {2}, {3, 2});
        for (const double zoom : {1e3, 1e8, 1e10}) {
            plain.camera.centre = inside;
            plain.camera.pixelsPerUnit = 20 * zoom;
            RenderRequest moved = plain;
            moved.moved = {{{2, 3}, turned(0, 4, 0)}};
            moved.camera.centre += Vector<2>(4, 0);
            plain.moved = {{{2, 3}, turned(0, 0, 0)}}; // without what overlaps the branch
            plain.moved.push_back({{0}, turned(0, 1e3, 0)});
            plain.moved.push_back({{1}, turned(0, 1e3, 0)});
            plain.moved.push_back({{3}, turned(0, 1e3, 0)});
            for (const int symbol : {0, 1, 2})
                plain.moved.push_back({{2, symbol}, turned(0, 1e3, 0)});
            const Frame there = render(moved);
            const Frame here = render(plain);
            QVERIFY(here.measure > 0);
            QVERIFY(std::abs(there.measure / here.measure - 1) < 0.05);
            QVERIFY(std::abs(systems::meanGrey(there) / systems::meanGrey(here) - 1) < 0.05);
        }
    }

    void cagesTakeMovedBranchesAlong() {
        RenderRequest request = movedMaple(2'000'000);
        request.cage = ifs::polygonAtRest<2>({{-3, -3}, {5, -3}, {0, 8}});
        request.cage->current = {{-3, -2}, {4, -4}, {1, 6}};
        compare(request, ifs::displayMap(*request.cage), 3'000'000);
        request.cage = ifs::polygonAtRest<2>({{-9, -6}, {10, -6}, {10, 10}, {-9, 10}});
        request.cage->current[2] -= Vector<2>(5, 3);
        const PreparedSystem system = prepared(request.system, request.moved);
        const auto support = ifs::SupportFunction<2>::of(system.maps);
        const ifs::Coordinates kind =
            ifs::suitableCoordinates(request.cage->rest, &*support, shownPieces(system));
        QCOMPARE(kind, ifs::Coordinates::Wachspress);
        compare(request, {*request.cage, kind}, 3'000'000);
        // Wachspress coordinates have poles outside, where a branch may be.
        request.cage = ifs::polygonAtRest<2>({{-4, -4}, {4.5, -4}, {4.5, 7.5}, {-4, 7.5}});
        QCOMPARE(ifs::suitableCoordinates(request.cage->rest, &*support), ifs::Coordinates::Wachspress);
        QCOMPARE(ifs::suitableCoordinates(request.cage->rest, &*support, shownPieces(system)),
                 ifs::Coordinates::MeanValue);
        request.cage->current[2] -= Vector<2>(1, 1);
        compare(request, {*request.cage, ifs::Coordinates::MeanValue}, 3'000'000);
    }

    // Branches of maps that take no part are nowhere to be moved.
    void namesOfMapsThatAreOffCountForNothing() {
        RenderRequest request = movedMaple(100'000);
        request.system.maps[2].enabled = false;
        const Frame frame = render(request);
        request.moved = {mapleMoved[2]};
        QCOMPARE(frame.pixels, render(request).pixels);
    }
};

BARYCAGE_TEST(TestMovedBranches);
#include "moved_branches_test.moc"
