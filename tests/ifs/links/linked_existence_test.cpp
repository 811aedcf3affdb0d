// SPDX-License-Identifier: MIT
#include "ifs/links/linked_existence.h"

#include "ifs/facts.h"
#include "ifs/links/linked_extent.h"
#include "ifs/links/linked_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace ifs;
using namespace linked_systems;

namespace {

bool exists(const Existence& existence) {
    return existence.exists();
}

Matrix<2> matrix(double a, double b, double c, double d) {
    Matrix<2> result;
    result << a, b, c, d;
    return result;
}

// Of maps that follow one another in a circle only.
System circle(const std::vector<AffineMap<2>>& maps) {
    const std::size_t n = maps.size();
    std::vector<double> links(n * n, 0);
    for (std::size_t i = 0; i < n; ++i)
        links[i * n + (i + 1) % n] = 1;
    return system(maps, links);
}

Existence existenceOf(const System& system) {
    return classifyLinked<2>(activeMaps(system));
}

// Its square is I/4 without rounding.
Matrix<2> cancelling() {
    return matrix(1629810176.25, -1629810175.75, 1629810176.75, -1629810176.25);
}

// A product of shears by whole numbers, and its inverse: exact, and of norms that grow with their number.
std::pair<Matrix<2>, Matrix<2>> sheared(std::mt19937& random, int shears) {
    Matrix<2> forth = Matrix<2>::Identity(), back = forth;
    for (int k = 0; k < shears; ++k) {
        const double by = double(int(random() % 19) - 9);
        const Matrix<2> shear = k % 2 == 0 ? matrix(1, by, 0, 1) : matrix(1, 0, by, 1);
        const Matrix<2> unshear = k % 2 == 0 ? matrix(1, -by, 0, 1) : matrix(1, 0, -by, 1);
        forth = forth * shear;
        back = unshear * back;
    }
    return {forth, back};
}

bool holds(const BoundingBox<2>& box, const Vector<2>& point) {
    return ((point - box.min).array() >= -box.error).all() && ((box.max - point).array() >= -box.error).all();
}

} // namespace

class LinkedExistenceTest : public QObject {
    Q_OBJECT

private slots:
    // A₁A₂ = I/2 without rounding, of factors with norms above 10⁹.
    void productsThatCancelDoNotExpand() {
        for (const double scale : {1.0, .5, 0x1p-20, 0x1p20}) {
            const System cancels =
                circle({{cancelling() * scale, {1, 0}}, {2 * cancelling() / scale, {0, 1}}});
            const Existence existence = existenceOf(cancels);
            QVERIFY(exists(existence));
            QVERIFY(existence.contractivity >= std::sqrt(.5) * (1 - 1e-12));
        }
        const System expands = circle({{2 * cancelling(), {1, 0}}, {2 * cancelling(), {0, 1}}}); // (2A)² = I
        QCOMPARE(existenceOf(expands).verdict, Verdict::None);
        const System barely = circle({{2 * cancelling(), {1, 0}}, {(2 - 0x1p-10) * cancelling(), {0, 1}}});
        QVERIFY(existenceOf(barely).verdict != Verdict::None);
    }

    // A² = 9·I without rounding, which rounding makes nearly nothing.
    void productsThatSeemToVanish() {
        const Matrix<2> linear = matrix(536870915, -288230379372937216, 1, -536870915);
        QCOMPARE(existenceOf(circle({{linear, {1, 0}}, {linear, {0, 1}}})).verdict, Verdict::None);
        QCOMPARE(existenceOf(circle({{linear / 4, {1, 0}}, {linear * 4, {0, 1}}})).verdict, Verdict::None);
        const System contracts = circle({{linear / 4, {1, 0}}, {linear, {0, 1}}}); // 9/4·I
        QCOMPARE(existenceOf(contracts).verdict, Verdict::None);
        const System slow = circle({{linear / 4, {1, 0}}, {linear / 4, {0, 1}}}); // 9/16·I
        QVERIFY(existenceOf(slow).verdict != Verdict::None);
    }

    // A circle of maps Mᵢ⁻¹ Mᵢ₊₁, with one factor that decides.
    void longCircles() {
        std::mt19937 random(3);
        for (int n = 0; n < 40; ++n) {
            const std::size_t count = 2 + std::size_t(n) % 9;
            std::vector<std::pair<Matrix<2>, Matrix<2>>> frames;
            for (std::size_t k = 0; k < count; ++k)
                frames.push_back(sheared(random, 4 + n % 5));
            const double factor = n % 2 == 0 ? .5 : 2;
            std::vector<AffineMap<2>> maps;
            bool isExact = true;
            for (std::size_t k = 0; k < count; ++k) {
                const Matrix<2>& back = frames[k].second;
                const Matrix<2>& forth = frames[(k + 1) % count].first;
                maps.push_back({back * forth * (k == 0 ? factor : 1.0), {double(k), 1}});
                isExact = isExact && (back.cwiseAbs() * forth.cwiseAbs()).maxCoeff() < 0x1p52;
            }
            if (!isExact) continue;
            // w_i comes after w_{i−1}: the words run backwards.
            std::ranges::reverse(maps);
            const Existence existence = existenceOf(circle(maps));
            if (factor < 1)
                QVERIFY(existence.verdict != Verdict::None);
            else
                QVERIFY(!exists(existence));
        }
    }

    // The radius of the word decides, however near to 1 it is.
    void slowCircles() {
        for (const double slow : {1 - 1e-9, 1 - 1e-12, 1 - 0x1p-50, 1 - 0x1p-53}) {
            for (const double lean : {0.0, 3.0, 1000.0}) {
                const AffineMap<2> first{matrix(2, lean, 0, 1), {1, 0}};
                const System exact = circle({first, {matrix(slow / 2, 0, 0, .25), {0, 1}}});
                const Existence existence = existenceOf(exact);
                QVERIFY(exists(existence));
                QVERIFY(existence.contractivity >= slow && existence.contractivity <= 1);
                const auto extent = LinkedExtent::of(activeMaps(exact), existence);
                QCOMPARE(extent.has_value(), existence.hasFactor());
                if (!extent) continue;
                // One point after each map, far away where the circle is slow.
                const BoundingBox<2> box = boundingBox(*extent);
                QVERIFY(((box.max - box.min).array() >= 0).all());
                const Vector<2> x = extent->pointOf(0);
                QVERIFY(holds(box, x) && box.error <= 1e-3 * (1 + x.norm()));
                const System turned = circle({first, {matrix(.5, 0, 0, .25), {0, 1}}});
                QCOMPARE(existenceOf(turned).verdict, Verdict::None);
            }
        }
    }

    // One part is a circle, the other is not.
    void circlesBesideOtherParts() {
        const auto parts = [](double slow, double other) {
            const std::vector<AffineMap<2>> maps{{matrix(2, 1, 0, 1), {1, 0}},
                                                 {matrix(slow / 2, 0, 0, .25), {0, 1}},
                                                 {matrix(other, 0, 0, .5), {2, 0}},
                                                 {matrix(.5, 0, 1, other), {0, 2}}};
            return system(maps, {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1});
        };
        QVERIFY(exists(existenceOf(parts(1 - 1e-12, .5))));
        QCOMPARE(existenceOf(parts(1, .5)).verdict, Verdict::None);
        QCOMPARE(existenceOf(parts(1 - 1e-12, 1)).verdict, Verdict::None);
    }

    // Of maps that stretch before they contract, words are many and the ball about the attractor is wide.
    void boxesOfMapsThatStretch() {
        std::mt19937 random(9);
        for (const double slow : {.45, .4, .3}) {
            const System maps =
                system({affineMap(2, 0, 0, .5, 1, 0), affineMap(slow, .1, 0, .9, 0, 1)}, {0, 1, 1, 1});
            const auto active = activeMaps(maps);
            const auto extent = LinkedExtent::of(active, classifyLinked<2>(active));
            QVERIFY(extent);
            const BoundingBox<2> box = boundingBox(*extent);
            const double size = (box.max - box.min).norm();
            QVERIFY2(box.error <= 1e-3 * size, qPrintable(QString::number(box.error / size)));
            Vector<2> x = extent->pointOf(0);
            std::size_t last = 0;
            for (int k = 0; k < 200'000; ++k) {
                last = last == 0 ? 1 : random() % 2;
                x = active.maps[last](x);
                QVERIFY(holds(box, x));
            }
        }
    }

    void hugeMapsInACircle() {
        for (const int exponent : {100, 300, 500, 700, 1000}) {
            const double huge = std::ldexp(1, exponent);
            // Products of the two are nilpotent in one order and vanish in the other.
            const System vanishes =
                circle({{matrix(0, huge, 0, 0), {1, 0}}, {matrix(huge, 0, 0, 0) * .5, {0, 1}}});
            QVERIFY(existenceOf(vanishes).verdict != Verdict::None);
            const System expands =
                circle({{matrix(0, huge, 0, 0), {1, 0}}, {matrix(0, 0, 2 / huge, 0), {0, 1}}});
            QVERIFY(!exists(existenceOf(expands)));
            const System contracts =
                circle({{matrix(0, huge, 0, 0), {1, 0}}, {matrix(0, 0, .5 / huge, 0), {0, 1}}});
            QVERIFY(existenceOf(contracts).verdict != Verdict::None);
        }
    }

    // The attractor of two maps in a circle is two points.
    void boxesOfProductsThatCancel() {
        const System cancels = circle({{cancelling(), {1, 0}}, {cancelling(), {1, 0}}});
        const auto active = activeMaps(cancels);
        const Existence existence = classifyLinked<2>(active);
        QVERIFY(exists(existence));
        const auto extent = LinkedExtent::of(active, existence);
        if (!extent) return;
        const BoundingBox<2> box = boundingBox(*extent);
        // (I − A²)⁻¹(A b + b) = 4/3 (A b + b), for both.
        const Vector<2> b(1, 0), point = (cancelling() * b + b) * 4 / 3;
        QVERIFY(box.min.allFinite() && box.max.allFinite() && std::isfinite(box.error));
        QVERIFY(holds(box, point));
        QVERIFY2(box.error <= 1e-6 * point.norm(), qPrintable(QString::number(box.error)));
        QVERIFY(((point - box.max).array() >= -box.error - 1e-6 * point.norm()).all());
    }

    void boxesHoldTheirPoints() {
        std::mt19937 random(7);
        int boxes = 0;
        for (int n = 0; n < 60; ++n) {
            const auto [forth, back] = sheared(random, 3 + n % 8);
            const double growth = forth.cwiseAbs().maxCoeff() * back.cwiseAbs().maxCoeff();
            if (growth > 0x1p48) continue;
            // x ↦ x/2 + b and x ↦ x/4 + c in turn, seen from elsewhere half of the time.
            const System seen = circle({{.5 * forth, {1, 0}}, {.25 * back, {0, 0}}});
            const auto active = activeMaps(seen);
            const Existence existence = classifyLinked<2>(active);
            QVERIFY(existence.verdict != Verdict::None);
            if (!exists(existence)) continue;
            const auto extent = LinkedExtent::of(active, existence);
            if (!extent) continue;
            const BoundingBox<2> box = boundingBox(*extent);
            const Vector<2> b(1, 0), one = b * 8 / 7, other = .25 * (back * one);
            QVERIFY(holds(box, one) && holds(box, other));
            ++boxes;
        }
        QVERIFY(boxes > 40);
    }
};

BARYCAGE_TEST(LinkedExistenceTest);
#include "linked_existence_test.moc"
