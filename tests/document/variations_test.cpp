// SPDX-License-Identifier: MIT
#include "document/fractal_geometry.h"
#include "document/variations.h"

#include <QTest>

#include <set>

class VariationsTest : public QObject {
    Q_OBJECT

private slots:
    void randomSystemsFillTheirView();
    void variationsFillTheirView();
    void sameSeedSameSystem();
    void strengthIsDistance();
    void onlyTheSystemChanges();
    void linesAndDustDoNotFillAView();
};

namespace {

double distance(const document::System2& a, const document::System2& b) {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.maps.size(), b.maps.size()); ++i)
        sum += (a.maps[i].map.linear - b.maps[i].map.linear).norm() +
               (a.maps[i].map.translation - b.maps[i].map.translation).norm();
    return sum;
}

const document::System2& systemOf(const document::Fractal& fractal) {
    return *document::system2(fractal);
}

} // namespace

void VariationsTest::randomSystemsFillTheirView() {
    std::set<std::size_t> counts;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const document::Fractal fractal = document::randomFractal(seed);
        QVERIFY(document::shareOfView(fractal) >= 0.12);
        QVERIFY(document::displayedBox(fractal));
        QVERIFY(!(systemOf(fractal) == systemOf(document::sierpinskiTriangle())));
        counts.insert(systemOf(fractal).maps.size());
    }
    QVERIFY(counts.size() >= 3 && *counts.begin() >= 2 && *counts.rbegin() <= 5);
}

void VariationsTest::variationsFillTheirView() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    for (const double strength : {0.1, 0.5, 1.0})
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            const document::Fractal varied = document::variation(fractal, strength, seed);
            QVERIFY(document::shareOfView(varied) >= 0.12);
            QVERIFY(!(systemOf(varied) == systemOf(fractal)));
        }
}

void VariationsTest::sameSeedSameSystem() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    QVERIFY(document::variation(fractal, 0.4, 7) == document::variation(fractal, 0.4, 7));
    QVERIFY(!(document::variation(fractal, 0.4, 7) == document::variation(fractal, 0.4, 8)));
    QVERIFY(document::randomFractal(5) == document::randomFractal(5));
}

void VariationsTest::strengthIsDistance() {
    const document::Fractal fractal = document::sierpinskiTriangle();
    double near = 0;
    double far = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        near += distance(systemOf(document::variation(fractal, 0.05, seed)), systemOf(fractal));
        far += distance(systemOf(document::variation(fractal, 0.9, seed)), systemOf(fractal));
    }
    QVERIFY(near > 0);
    QVERIFY(far > 4 * near);
}

void VariationsTest::onlyTheSystemChanges() {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.name = QStringLiteral("mine");
    fractal.comments << QStringLiteral(" kept");
    fractal.appearance.gamma = 3;
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[0] += ifs::Vector<2>(0.1, 0.2);
    document::Fractal varied = document::variation(fractal, 0.5, 3);
    *document::system2(varied) = *document::system2(fractal);
    QVERIFY(varied == fractal);
}

void VariationsTest::linesAndDustDoNotFillAView() {
    document::Fractal fractal;
    document::System2 line;
    ifs::append(line, ifs::affineMap(0.5, 0, 0, 0.5, 0, 0));
    ifs::append(line, ifs::affineMap(0.5, 0, 0, 0.5, 0.5, 0.5));
    fractal.shape = document::Shape<2>{line};
    QVERIFY(document::shareOfView(fractal) < 0.12);
    document::System2 dust;
    for (const double x : {0.0, 0.9})
        for (const double y : {0.0, 0.9})
            ifs::append(dust, ifs::affineMap(0.1, 0, 0, 0.1, x, y));
    fractal.shape = document::Shape<2>{dust};
    QVERIFY(document::shareOfView(fractal) < 0.12);
}

QTEST_APPLESS_MAIN(VariationsTest)
#include "variations_test.moc"
