// SPDX-License-Identifier: MIT
#include "animation/morph.h"
#include "ifs/canonical_systems.h"
#include "ifs/dimension/moments.h"
#include "support/named_test.h"

#include <QtTest>

#include <Eigen/QR>

#include <bit>
#include <cmath>
#include <numeric>
#include <set>

using namespace animation;
using namespace canonical;

namespace {

ifs::ActiveMaps<2> active(const Maps2& maps) {
    return ifs::activeMaps(
        canonical::system<2>(maps, std::vector<double>(maps.size(), 1.0 / double(maps.size()))));
}

bool isNear(double a, double b) {
    return std::abs(a - b) < 1e-12;
}

// The least cost of all ways to pair as many as there are, each of weight 1/n: the vertices are permutations.
double leastOfAll(const Eigen::MatrixXd& cost) {
    std::vector<int> order(std::size_t(cost.rows()));
    std::iota(order.begin(), order.end(), 0);
    double least = HUGE_VAL;
    do {
        double sum = 0;
        for (std::size_t i = 0; i < order.size(); ++i)
            sum += cost(Eigen::Index(i), order[i]);
        least = std::min(least, sum / double(cost.rows()));
    } while (std::ranges::next_permutation(order).found);
    return least;
}

// The least cost of all vertices for any weights: the ways of a vertex are a tree of the places.
double leastOfVertices(const std::vector<double>& supply, const std::vector<double>& demand,
                       const Eigen::MatrixXd& cost) {
    const auto rows = Eigen::Index(supply.size()), columns = Eigen::Index(demand.size());
    const Eigen::Index ways = rows + columns - 1;
    Eigen::VectorXd masses(rows + columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        masses(i) = supply[std::size_t(i)];
    for (Eigen::Index k = 0; k < columns; ++k)
        masses(rows + k) = demand[std::size_t(k)];
    double least = HUGE_VAL;
    for (unsigned chosen = 0; chosen < 1U << unsigned(rows * columns); ++chosen) {
        if (std::popcount(chosen) != ways) continue;
        Eigen::MatrixXd places = Eigen::MatrixXd::Zero(rows + columns, ways);
        Eigen::VectorXd prices(ways);
        Eigen::Index way = 0;
        for (Eigen::Index cell = 0; cell < rows * columns; ++cell) {
            if (!(chosen >> unsigned(cell) & 1U)) continue;
            places(cell / columns, way) = places(rows + cell % columns, way) = 1;
            prices(way++) = cost(cell / columns, cell % columns);
        }
        const auto solver = places.colPivHouseholderQr();
        if (solver.rank() < ways) continue; // a cycle
        const Eigen::VectorXd amounts = solver.solve(masses);
        if (amounts.minCoeff() > -1e-12) least = std::min(least, amounts.dot(prices));
    }
    return least;
}

// Without the penalty for mirroring.
template <int Dim>
double plainCost(const ifs::AffineMap<Dim>& a, const ifs::AffineMap<Dim>& b, const ifs::Vector<Dim>& mean,
                 const ifs::Matrix<Dim>& covariance) {
    const ifs::Matrix<Dim> difference = a.linear - b.linear;
    return (difference * covariance * difference.transpose()).trace() +
           (difference * mean + a.translation - b.translation).squaredNorm();
}

} // namespace

class MorphTest : public QObject {
    Q_OBJECT

private slots:
    void mapleToFlower() {
        const auto maple = active(canonical::maple()), flower = active(canonical::flower());
        const auto found = correspondence<2>(maple, flower);
        QVERIFY(found.has_value());
        QVERIFY(isNear(found->reference.x(), 0.0664862620850559) &&
                isNear(found->reference.y(), 2.3772364855375603));
        const double rows[4][2] = {{22.919660600075, 23.404467277477},
                                   {3.501877686256, 3.478103896851},
                                   {1.943113641592, 9.669755950749},
                                   {7.792196495011, 1.085072933365}};
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 2; ++k)
                QVERIFY(isNear(found->cost(i, k), rows[i][k]));
        QVERIFY(isNear(found->total, 7.356487767970908));
        QCOMPARE(found->pairs,
                 (std::vector<Shipment>{{0, 0, 0.25}, {1, 1, 0.25}, {2, 0, 0.25}, {3, 1, 0.25}}));

        Morph<2> half = morph<2>(maple, flower, *found, 2);
        half.animation.maps[0].keys[0].ease = half.animation.maps[1].keys[0].ease = {};
        half.animation.maps[2].keys[0].ease = half.animation.maps[3].keys[0].ease = {};
        const auto system = half.animation.at(moment(1), {half.system}).system;
        ifs::Matrix<2> linear;
        linear << 0.06094193908194505, 0.5700382987176388, -0.3442276923014477, -0.1741316026660621;
        QVERIFY((system.maps[0].map.linear - linear).cwiseAbs().maxCoeff() < 1e-12);
        QVERIFY((system.maps[0].map.translation - ifs::Vector<2>(-0.8432876244201822, 1.2052682685592602))
                    .norm() < 1e-12);
        const double norms[4] = {0.623603062778761, 0.585401497856199, 0.640054222703378, 0.641999263126039};
        for (std::size_t j = 0; j < 4; ++j)
            QVERIFY(isNear(ifs::spectralNorm<2>(system.maps[j].map.linear), norms[j]));
        const auto moments = ifs::moments<2>(ifs::activeMaps(system));
        QVERIFY((moments->mean - ifs::Vector<2>(0.020071032080778133, 2.1765225432379367)).norm() < 1e-12);
        ifs::Matrix<2> covariance;
        covariance << 1.1841215865325907, -0.42486463807864294, -0.42486463807864294, 1.1597203705847106;
        QVERIFY((moments->covariance - covariance).cwiseAbs().maxCoeff() < 1e-12);
    }

    // At the ends the measures are those of the two codes, whatever the weights.
    void endsAreExact() { endsAreExactIn<2>(); }
    void endsAreExactInSpace() { endsAreExactIn<3>(); }

    // Against all permutations, and with the marginals exact.
    void transportIsOptimal() {
        Random random(6);
        for (int n = 0; n < 200; ++n) {
            const int size = 1 + n % 6;
            Eigen::MatrixXd cost(size, size);
            for (int i = 0; i < size; ++i)
                for (int k = 0; k < size; ++k)
                    cost(i, k) = n % 3 == 0 ? std::round(uniform(random, 0, 3)) : uniform(random, 0, 1);
            const std::vector<double> even(std::size_t(size), 1.0 / size);
            double total = 0;
            for (const Shipment& way : transport(even, even, cost))
                total += way.amount * cost(Eigen::Index(way.from), Eigen::Index(way.to));
            QVERIFY2(isNear(total, leastOfAll(cost)), qPrintable(QString::number(total - leastOfAll(cost))));
        }
    }

    // Whatever the weights, against all vertices.
    void transportOfUnequalWeightsIsOptimal() {
        Random random(7);
        const auto masses = [&](int count) {
            std::vector<double> result;
            for (int i = 0; i < count; ++i)
                result.push_back(uniform(random, 0.05, 1));
            return ifs::shares(result);
        };
        for (int n = 0; n < 60; ++n) {
            const int rows = 1 + n % 3, columns = 1 + n % 4;
            const auto supply = masses(rows), demand = masses(columns);
            Eigen::MatrixXd cost(rows, columns);
            for (int i = 0; i < rows; ++i)
                for (int k = 0; k < columns; ++k)
                    cost(i, k) = n % 5 == 0 ? std::round(uniform(random, 0, 3)) : uniform(random, 0, 1);
            double total = 0;
            for (const Shipment& way : transport(supply, demand, cost))
                total += way.amount * cost(Eigen::Index(way.from), Eigen::Index(way.to));
            const double least = leastOfVertices(supply, demand, cost);
            QVERIFY2(isNear(total, least), qPrintable(QString::number(total - least)));
        }
    }

    void transportOfManyIsAVertex() {
        Random random(8);
        const auto masses = [&](std::size_t count) {
            std::vector<double> result;
            for (std::size_t i = 0; i < count; ++i)
                result.push_back(uniform(random, 0.001, 1));
            return ifs::shares(result);
        };
        const auto supply = masses(256), demand = masses(200);
        Eigen::MatrixXd cost(256, 200);
        for (int i = 0; i < 256; ++i)
            for (int k = 0; k < 200; ++k)
                cost(i, k) = uniform(random, 0, 1);
        const auto ways = transport(supply, demand, cost);
        QVERIFY(ways.size() <= 455);
        std::vector<double> out(256), in(200);
        for (const Shipment& way : ways) {
            out[way.from] += way.amount;
            in[way.to] += way.amount;
        }
        for (std::size_t i = 0; i < out.size(); ++i)
            QVERIFY(std::abs(out[i] - supply[i]) < 1e-13);
        for (std::size_t k = 0; k < in.size(); ++k)
            QVERIFY(std::abs(in[k] - demand[k]) < 1e-13);
    }

    // Between maps of opposite orientation, a unit of weight pays tr C more.
    void mirroringCostsMore() {
        Random random(10);
        const auto regular = [&] {
            Maps2 maps;
            for (int i = 0; i < 4; ++i)
                maps.push_back({0.6 * randomWellConditioned<2>(random) / 4, randomVector<2>(random)});
            return active(maps);
        };
        int mirrored = 0, others = 0;
        for (int n = 0; n < 20; ++n) {
            const auto from = regular(), to = regular();
            const auto found = correspondence<2>(from, to);
            QVERIFY(found);
            const auto first = *ifs::moments<2>(from), last = *ifs::moments<2>(to);
            const ifs::Vector<2> apart = first.mean - last.mean;
            const ifs::Matrix<2> covariance =
                (first.covariance + last.covariance) / 2 + apart * apart.transpose() / 4;
            for (int i = 0; i < 4; ++i)
                for (int k = 0; k < 4; ++k) {
                    const auto &a = from.maps[std::size_t(i)], &b = to.maps[std::size_t(k)];
                    const bool mirrors = a.linear.determinant() * b.linear.determinant() < 0;
                    const double more = found->cost(i, k) - plainCost<2>(a, b, found->reference, covariance);
                    QVERIFY(std::abs(more - (mirrors ? covariance.trace() : 0)) < 1e-9);
                    ++(mirrors ? mirrored : others);
                }
        }
        QVERIFY(mirrored > 50 && others > 50);
    }

    void pinsBelongTogether() {
        const auto maple = active(canonical::maple()), flower = active(canonical::flower());
        const Pin pins[] = {{0, 1}, {3, 0}};
        const auto found = correspondence<2>(maple, flower, pins);
        QCOMPARE(found->pairs[0], (Shipment{0, 1, 0.25}));
        QCOMPARE(found->pairs[3], (Shipment{3, 0, 0.25}));
        QVERIFY(found->total > 7.4);
    }

private:
    template <int Dim> void endsAreExactIn() {
        Random random(4);
        for (int n = 0; n < 50; ++n) {
            const auto weighted = [&](int count) {
                std::vector<double> weights;
                for (int i = 0; i < count; ++i)
                    weights.push_back(uniform(random, 0.1, 1));
                return ifs::activeMaps(canonical::system<Dim>(
                    randomContractions<Dim>(random, std::size_t(count), 0.9), weights));
            };
            const auto from = weighted(1 + n % 7), to = weighted(1 + n % 5);
            const auto found = correspondence<Dim>(from, to);
            QVERIFY(found.has_value());
            QVERIFY(found->pairs.size() <= from.maps.size() + to.maps.size() - 1);
            const Morph<Dim> between = morph<Dim>(from, to, *found, 10);
            QVERIFY(isValid(between.animation));
            const auto momentsAt = [&](int frame) {
                return *ifs::moments<Dim>(
                    ifs::activeMaps(between.animation.at(moment(frame), {between.system}).system));
            };
            const auto check = [&](const ifs::Moments<Dim>& a, const ifs::Moments<Dim>& b) {
                QVERIFY((a.mean - b.mean).norm() < 1e-12 * (1 + b.mean.norm()));
                QVERIFY((a.covariance - b.covariance).norm() < 1e-12 * (1 + b.covariance.norm()));
            };
            check(momentsAt(0), *ifs::moments<Dim>(from));
            check(momentsAt(10), *ifs::moments<Dim>(to));
        }
    }
};

BARYCAGE_TEST(MorphTest);
#include "morph_test.moc"
