// SPDX-License-Identifier: MIT
#include "attractor/cut/bend_table.h"
#include "attractor/kernels/kernels.h"
#include "attractor/render/banded_rendering.h"
#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <span>

using namespace attractor;
using ifs::Vector;

namespace {

std::vector<Vector<2>> around(const ifs::IteratedFunctionSystem<2>& system, int corners, double size = 1) {
    const PreparedSystem d = prepared(system);
    std::vector<Vector<2>> result;
    for (int j = 0; j < corners; ++j) {
        const double angle = 2 * std::numbers::pi * (j + 0.3) / corners;
        result.push_back(d.centre +
                         size * 1.5 * d.halfExtent.cwiseProduct(Vector<2>(std::cos(angle), std::sin(angle))));
    }
    return result;
}

// Corners `first` and `second` moved by `amount` of the size.
ifs::ControlCage<2> bentCage(const ifs::IteratedFunctionSystem<2>& system, int corners, double amount) {
    ifs::ControlCage<2> cage = ifs::polygonAtRest<2>(around(system, corners));
    const Vector<2> size = 2 * prepared(system).halfExtent;
    cage.current[1] += amount * Vector<2>(size.x(), 0.3 * size.y());
    cage.current[std::size_t(corners) - 2] += amount * Vector<2>(-0.2 * size.x(), -size.y());
    return cage;
}

ifs::Placement placementOf(const RenderRequest& request) {
    const PreparedSystem d = prepared(request.system);
    const auto support = ifs::SupportFunction<2>::of(d.maps);
    return {*request.cage, ifs::suitableCoordinates(request.cage->rest, support ? &*support : nullptr)};
}

// How much of the measure falls into each pixel, every point of a chaos game taken through the cage. Zoomed
// in, the orbit is helped: words whose image can reach the view are looked for, and points of them taken.
class Reference {
public:
    Reference(const RenderRequest& request, int points)
        : m_request(request), m_placement(placementOf(request)) {
        const Camera& camera = request.camera;
        shares.assign(std::size_t(camera.width) * std::size_t(camera.height), 0.0);
        const PreparedSystem d = prepared(request.system);
        std::mt19937_64 random(99);
        std::discrete_distribution<std::size_t> choice(d.probabilities.begin(), d.probabilities.end());
        std::vector<Vector<2>> orbit;
        Vector<2> x = d.centre;
        for (int n = -100; n < 30'000; ++n) {
            x = d.maps[choice(random)](x);
            if (n >= 0) orbit.push_back(x);
        }
        // Words small beside the view, kept when any of some points comes within a picture's size of it.
        struct Node {
            ifs::AffineMap<2> map;
            double probability;
        };
        std::vector<Node> open{{{}, 1}};
        std::vector<Node> kept;
        while (!open.empty()) {
            const Node node = open.back();
            open.pop_back();
            double nearest = 1e300;
            Vector<2> low = Vector<2>::Constant(1e300);
            Vector<2> high = -low;
            for (std::size_t k = 0; k < 24; ++k) {
                const Vector<2> pixel = toPixel(camera, m_placement(node.map(orbit[k * 1111])));
                low = low.cwiseMin(pixel);
                high = high.cwiseMax(pixel);
                const Vector<2> middle(camera.width / 2.0, camera.height / 2.0);
                nearest = std::min(nearest, (pixel - middle).norm());
            }
            const double size = (high - low).norm();
            if (nearest > 3 * size + camera.width) continue;
            if (size < camera.width) {
                kept.push_back(node);
                continue;
            }
            for (std::size_t i = 0; i < d.maps.size(); ++i)
                open.push_back({node.map * d.maps[i], node.probability * d.probabilities[i]});
        }
        // Most points where most of them are seen; how many says nothing about their shares.
        std::vector<double> wanted;
        double total = 0;
        for (const Node& node : kept) {
            double seen = 0.3;
            for (std::size_t k = 0; k < 60; ++k)
                seen += isInView(node.map(orbit[k * 499])) ? 1 : 0;
            wanted.push_back(node.probability * seen);
            total += wanted.back();
        }
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const int count = 1 + int(points * wanted[k] / total);
            for (int n = 0; n < count; ++n) {
                x = d.maps[choice(random)](x);
                plot(kept[k].map(x), kept[k].probability / count);
            }
        }
    }

    std::vector<double> shares;
    double inView() const { return std::accumulate(shares.begin(), shares.end(), 0.0); }

private:
    bool isInView(const Vector<2>& x) const {
        const Vector<2> at = toPixel(m_request.camera, m_placement(x));
        const Camera& camera = m_request.camera;
        return at.x() >= 0 && at.x() < camera.width && at.y() >= 0 && at.y() < camera.height;
    }
    void plot(const Vector<2>& x, double share) {
        const Vector<2> at = toPixel(m_request.camera, m_placement(x));
        const Camera& camera = m_request.camera;
        if (at.x() >= 0 && at.x() < camera.width && at.y() >= 0 && at.y() < camera.height)
            shares[std::size_t(at.y()) * std::size_t(camera.width) + std::size_t(at.x())] += share;
    }

    const RenderRequest& m_request;
    ifs::Placement m_placement;
};

// Mean grey over squares of 4 × 4 pixels, so that grain counts less than position.
std::vector<double> blocks(const std::vector<double>& pixels, int width, int height) {
    std::vector<double> result;
    for (int y = 0; y + 4 <= height; y += 4)
        for (int x = 0; x + 4 <= width; x += 4) {
            double sum = 0;
            for (int k = 0; k < 16; ++k)
                sum += pixels[std::size_t((y + k / 4) * width + x + k % 4)];
            result.push_back(sum / 16);
        }
    return result;
}

// The engine's picture against the reference with the same tones: decibels, peak 255.
double likeness(const RenderRequest& request, int points, double* measureRatio = nullptr) {
    const Frame frame = render(request);
    const Reference reference(request, points);
    const double inView = reference.inView();
    std::vector<double> mine, theirs;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        const double density = reference.shares[i] / inView;
        mine.push_back(systems::grey(frame.pixels[i]));
        theirs.push_back(density);
    }
    // Tones: the engine's, with the mean density of the occupied pixels measured alike in both.
    const double mean = frame.exposure.meanDensity;
    for (double& density : theirs) {
        const double samplesInView = frame.measure > 0 ? inView / 1.0 : 1;
        const double v = std::pow(std::log1p(request.appearance.brightness * density * samplesInView / mean) /
                                      std::log1p(request.appearance.brightness * frame.exposure.whitePoint),
                                  1 / request.appearance.gamma);
        density = 255 * std::min(1.0, v);
    }
    if (measureRatio != nullptr) *measureRatio = frame.measure / inView;
    const auto a = blocks(mine, request.camera.width, request.camera.height);
    const auto b = blocks(theirs, request.camera.width, request.camera.height);
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (a[i] - b[i]) * (a[i] - b[i]);
    return 10 * std::log10(255.0 * 255.0 * double(a.size()) / squares);
}

RenderRequest bentRequest(const ifs::IteratedFunctionSystem<2>& system, int corners, double amount) {
    RenderRequest request = systems::request(system, 4'000'000);
    request.cage = bentCage(system, corners, amount);
    return request;
}

} // namespace

class TestBentCage : public QObject {
    Q_OBJECT

private slots:
    void agreesWithEverySampleMapped_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<int>("corners");
        QTest::addColumn<double>("amount");
        QTest::addColumn<double>("zoom");
        QTest::addRow("maple") << 0 << 8 << 0.2 << 1.0;
        QTest::addRow("maple ×150") << 0 << 8 << 0.2 << 150.0;
        QTest::addRow("fern ×150") << 1 << 7 << 0.2 << 150.0;
        QTest::addRow("sierpinski ×10000") << 2 << 6 << 0.2 << 1e4;
        QTest::addRow("hardly bent") << 0 << 5 << 1e-4 << 1.0;
        QTest::addRow("bent over") << 0 << 6 << 0.8 << 1.0;
    }
    void agreesWithEverySampleMapped() {
        QFETCH(int, which);
        QFETCH(int, corners);
        QFETCH(double, amount);
        QFETCH(double, zoom);
        const auto system = which == 0   ? systems::maple()
                            : which == 1 ? systems::fern()
                                         : systems::sierpinski();
        RenderRequest request = bentRequest(system, corners, amount);
        request.camera.pixelsPerUnit *= zoom * 0.8;
        if (zoom > 1) { // onto a point of the attractor, off its symmetries
            const PreparedSystem d = prepared(system);
            Vector<2> x = d.centre;
            for (const std::size_t i :
                 {0, 2, 1, 0, 1, 2, 2, 0, 1, 2, 1, 2, 0, 2, 1, 1, 2, 0, 1, 2, 0, 1, 2, 1})
                x = d.maps[i](x);
            request.camera.centre = placementOf(request)(x);
        }
        double ratio = 0;
        const double decibels = likeness(request, 3'000'000, &ratio);
        QVERIFY2(decibels > 32, qPrintable(QString::number(decibels)));
        // Words that only seem to reach the view cost a little; words that do must not be missing.
        QVERIFY2(ratio > 0.98, qPrintable(QString::number(ratio)));
    }

    void meanValueCagesThroughTheAttractor() {
        RenderRequest request = systems::request(systems::maple(), 4'000'000);
        const Vector<2> c = prepared(request.system).centre;
        // A star whose notches and tips lie in the leaf.
        std::vector<Vector<2>> star;
        for (int j = 0; j < 10; ++j) {
            const double angle = 2 * std::numbers::pi * j / 10;
            star.push_back(c + (j % 2 == 0 ? 3.0 : 1.2) * Vector<2>(std::cos(angle), std::sin(angle)));
        }
        request.cage = ifs::polygonAtRest<2>(star);
        for (const std::size_t j : {1, 4, 7})
            request.cage->current[j] += Vector<2>(0.5, -0.3);
        const double decibels = likeness(request, 3'000'000);
        QVERIFY2(decibels > 32, qPrintable(QString::number(decibels)));
    }

    void anAffineImageOfTheCageIsNoBend() {
        RenderRequest request = systems::request(systems::maple(), 300'000);
        const ifs::AffineMap<2> map = ifs::affineMap(0.7, 0.2, -0.3, 0.9, 0.5, 0.25);
        RenderRequest triangle = request;
        triangle.cage =
            ifs::cageAtRest<2>(ifs::Simplex<2>{Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)});
        request.cage = ifs::polygonAtRest<2>(around(request.system, 8));
        for (RenderRequest* r : {&request, &triangle})
            for (Vector<2>& vertex : r->cage->current)
                vertex = map(vertex);
        const Frame bent = render(request);
        const Frame affine = render(triangle);
        std::size_t different = 0;
        for (std::size_t i = 0; i < bent.pixels.size(); ++i)
            different += bent.pixels[i] != affine.pixels[i] ? 1 : 0;
        QVERIFY(different * 1000 <= bent.pixels.size()); // rounding moves a few samples
    }

    void samePixelsForAnyThreadsAndInstructionSet() {
        for (const ColourBy colourBy : {ColourBy::Plain, ColourBy::Map}) {
            RenderRequest request = bentRequest(systems::maple(), 8, 0.4);
            request.samples = 1'000'000;
            request.appearance.colourBy = colourBy;
            const std::string best = simdName();
            const Frame reference = render(request);
            for (const char* set : {"scalar", "sse4", "avx2", "avx512"}) {
                if (!selectSimd(set)) continue;
                for (const int threads : {1, 3}) {
                    request.threads = threads;
                    QCOMPARE(render(request).pixels, reference.pixels);
                }
            }
            QVERIFY(selectSimd(best));
        }
    }

    // What is kept of a cage from one picture to the next shows in none of them.
    void aDragShowsWhatEachPlacementShowsAlone() {
        RenderRequest request = bentRequest(systems::maple(), 8, 0.1);
        request.samples = 300'000;
        Rendering drag(request);
        for (const double amount : {0.1, 0.4, -0.2, 0.4}) {
            request.cage = bentCage(request.system, 8, amount);
            request.camera.pixelsPerUnit *= 1.3;
            request.system.maps[0].map.translation.x() += 0.01; // the cage keeps its rest
            drag.restart(request);
            QVERIFY(drag.refine());
            QVERIFY(drag.frame().pixels == render(request).pixels);
        }
        for (const double amount : {0.35, 0.45, 0.4}) { // the same words
            request.cage = bentCage(request.system, 8, amount);
            drag.restart(request);
            QVERIFY(drag.refine());
            QVERIFY(drag.frame().pixels == render(request).pixels);
        }
        request.cage = bentCage(request.system, 5, 0.3); // another rest
        drag.restart(request);
        QVERIFY(drag.refine());
        QVERIFY(drag.frame().pixels == render(request).pixels);
    }

    void piecesMissNoMoreThanTheySay() {
        std::mt19937 random(8);
        std::uniform_real_distribution<double> u(-1, 1);
        const auto system = systems::maple();
        const PreparedSystem d = prepared(system);
        BendTable table;
        int good = 0;
        for (int n = 0; n < 40; ++n) {
            ifs::ControlCage<2> cage = ifs::polygonAtRest<2>(around(system, 4 + n % 7, n % 2 == 0 ? 1 : 0.7));
            for (Vector<2>& corner : cage.current)
                corner += 0.3 * d.halfExtent.cwiseProduct(Vector<2>(u(random), u(random)));
            const ifs::Placement placement(cage, ifs::Coordinates::MeanValue);
            const double tolerance = 1e-3 * d.halfExtent.maxCoeff();
            table.follow(*placement.bend(), d.centre, d.halfExtent.maxCoeff(), tolerance / 2);
            for (int k = 0; k < 100; ++k) {
                const Vector<2> x = d.centre + d.halfExtent.cwiseProduct(Vector<2>(u(random), u(random)));
                const double size = std::pow(10, -1 + u(random)) * d.halfExtent.maxCoeff();
                ifs::Matrix<2> spread;
                spread << size * u(random), size * u(random), size * u(random), size * u(random);
                const BendTable::Piece piece = table.piece(x, spread);
                if (!(piece.miss.maxCoeff() <= tolerance)) continue;
                ++good;
                for (int i = 0; i < 81; ++i) {
                    const double a = -1 + i % 9 / 4.0;
                    const double b = -1 + i / 9 / 4.0;
                    const Vector<2> expected = placement(x + spread * Vector<2>(a, b));
                    const Vector<2> curved = piece.value + piece.linear * Vector<2>(a, b) +
                                             piece.aa * (a * a) + piece.ab * (a * b) + piece.bb * (b * b);
                    const Vector<2> affine = piece.middle() + piece.linear * Vector<2>(a, b);
                    QVERIFY((curved - expected).cwiseAbs().maxCoeff() <= tolerance);
                    QVERIFY(((affine - expected).cwiseAbs() - piece.curvature()).maxCoeff() <= tolerance);
                }
            }
        }
        QVERIFY2(good > 1000, qPrintable(QString::number(good)));
    }

    void bandsShowNoSeams() {
        RenderRequest request = bentRequest(systems::fern(), 6, 0.3);
        request.samples = 500'000;
        BandedRendering whole(request);
        BandedRendering parts(request);
        const auto width = std::size_t(request.camera.width);
        std::vector<std::uint32_t> all(width * std::size_t(request.camera.height));
        std::vector<std::uint32_t> joined(all.size());
        QVERIFY(whole.band(0, request.camera.height, all));
        for (int row = 0; row < request.camera.height; row += 50)
            QVERIFY(parts.band(row, 50, std::span(joined).subspan(std::size_t(row) * width, 50 * width)));
        QVERIFY(all == joined);
    }

    void paperModeAndDeterministicAlgorithmBend() {
        // A square that fills its cage: the corner that is moved out must be reached, and no point left over.
        const auto square = systems::system({{{0.5, 0, 0, 0.5, 0, 0}},
                                             {{0.5, 0, 0, 0.5, 0.5, 0}},
                                             {{0.5, 0, 0, 0.5, 0, 0.5}},
                                             {{0.5, 0, 0, 0.5, 0.5, 0.5}}});
        RenderRequest request = systems::request(square, 400'000, 300, 300);
        request.cage = ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        request.cage->current[2] = {1.5, 1.6};
        request.camera = fitted(request.camera, {0, 0}, {1.5, 1.6});
        const auto covered = [&](Algorithm algorithm, int iterations) {
            request.algorithm = algorithm;
            request.iterations = iterations;
            const Frame frame = render(request);
            std::vector<bool> result;
            for (const std::uint32_t pixel : frame.pixels)
                result.push_back(systems::grey(pixel) > 0);
            return result;
        };
        // Bilinear, the moved quadrilateral: Wachspress of a square reach exactly its straight edges.
        const auto expected = covered(Algorithm::Deterministic, 0);
        const auto difference = [&](const std::vector<bool>& other) {
            int count = 0;
            for (std::size_t i = 0; i < other.size(); ++i)
                count += other[i] != expected[i] ? 1 : 0;
            return count;
        };
        const auto occupied = std::count(expected.begin(), expected.end(), true);
        const ifs::Matrix<2> pixels = worldToPixel(request.camera).linear;
        QVERIFY(std::abs(double(occupied) - 1.55 * std::abs(ifs::determinant<2>(pixels))) < 600);
        QVERIFY2(difference(covered(Algorithm::Deterministic, 3)) < 600, "deterministic");
        QVERIFY2(difference(covered(Algorithm::Density, 0)) < 1200, "density");
        request.samples = 1'500'000;
        QVERIFY2(difference(covered(Algorithm::ChaosGame, 0)) < 1200, "chaos game");
    }

    void neverNaN() {
        RenderRequest request = systems::request(systems::maple(), 100'000);
        const auto rest = around(request.system, 5);
        std::vector<std::vector<Vector<2>>> placements(4, rest);
        placements[0] = std::vector<Vector<2>>(5, rest[0]); // all in one point
        std::swap(placements[1][0], placements[1][2]);      // crossing
        placements[2][1] = Vector<2>(1e12, 1e12);           // far away
        for (Vector<2>& vertex : placements[3])             // on one line, unevenly
            vertex = {std::pow(vertex.x(), 3), 0};
        for (const auto& current : placements)
            for (const Algorithm algorithm :
                 {Algorithm::Density, Algorithm::ChaosGame, Algorithm::Deterministic}) {
                request.cage = {rest, current};
                request.algorithm = algorithm;
                request.iterations = 3;
                const Frame frame = render(request);
                QVERIFY(std::isfinite(frame.measure) && std::isfinite(frame.exposure.meanDensity));
            }
    }
};

BARYCAGE_TEST(TestBentCage);
#include "bent_cage_test.moc"
