// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/existence/attractor_existence.h"
#include "support/named_test.h"

#include <QtTest>

#include <Eigen/Dense>

using namespace ifs;
using namespace canonical;

namespace {

template <int Dim> using Maps = std::vector<AffineMap<Dim>>;
template <int Dim> using LongMatrix = Eigen::Matrix<long double, Dim, Dim>;

template <int Dim> std::vector<LongMatrix<Dim>> longLinear(const Maps<Dim>& maps) {
    std::vector<LongMatrix<Dim>> result;
    for (const auto& map : maps)
        result.push_back(map.linear.template cast<long double>());
    return result;
}

template <int Dim> long double radiusOf(const LongMatrix<Dim>& product) {
    return Eigen::EigenSolver<LongMatrix<Dim>>(product, false).eigenvalues().cwiseAbs().maxCoeff();
}

// Of all words up to a length: the largest ρ(A_σ)^(1/|σ|), below the joint spectral radius.
template <int Dim> double leastRadius(const Maps<Dim>& maps, int length) {
    const auto letters = longLinear<Dim>(maps);
    std::vector<LongMatrix<Dim>> words{LongMatrix<Dim>::Identity()};
    long double result = 0;
    for (int n = 1; n <= length; ++n) {
        std::vector<LongMatrix<Dim>> longer;
        for (const auto& word : words)
            for (const auto& letter : letters)
                longer.push_back(word * letter);
        words = std::move(longer);
        for (const auto& word : words)
            result = std::max(result, std::pow(radiusOf<Dim>(word), 1.0L / n));
    }
    return double(result);
}

// A proof that ‖A_σ‖ ≤ C·γⁿ for all words σ of length n is none that a few long words contradict: random
// ones, and greedy ones, which take the letter that leaves the product longest.
template <int Dim> QString contradiction(const Maps<Dim>& maps, const Existence& existence, Random& random) {
    const auto letters = longLinear<Dim>(maps);
    for (int trial = 0; trial < 6; ++trial) {
        LongMatrix<Dim> product = LongMatrix<Dim>::Identity();
        long double bound = existence.normEquivalence * (1 + 1e-9L);
        for (int n = 1; n <= 120; ++n) {
            std::size_t next = random() % letters.size();
            if (trial > 2)
                for (std::size_t i = 0; i < letters.size(); ++i)
                    if ((product * letters[i]).norm() > (product * letters[next]).norm()) next = i;
            product = product * letters[next];
            bound *= std::max<long double>(existence.contractivity, 1e-3L);
            const long double norm = Eigen::JacobiSVD<LongMatrix<Dim>>(product).singularValues()[0];
            if (norm > bound + 1e-15L * existence.normEquivalence)
                return QStringLiteral("a word of length %1 has norm %2, not %3")
                    .arg(n)
                    .arg(double(norm))
                    .arg(double(bound));
        }
    }
    return {};
}

template <int Dim> Matrix<Dim> rotation(Random& random) {
    return Eigen::HouseholderQR<Matrix<Dim>>(randomMatrix<Dim>(random)).householderQ();
}

template <int Dim> Maps<Dim> seenThrough(const Matrix<Dim>& basis, const std::vector<Matrix<Dim>>& linear) {
    Maps<Dim> result;
    for (const auto& m : linear)
        result.push_back({basis * m * basis.inverse(), Vector<Dim>::Zero()});
    return result;
}

// Triangular in common coordinates but for 1e-16 to 1e-3 below the diagonal, and large above it.
template <int Dim> Maps<Dim> nearlyTriangular(Random& random) {
    const double above = std::pow(10, uniform(random, 0, 3)), below = std::pow(10, uniform(random, -16, -8));
    std::vector<Matrix<Dim>> linear(2 + random() % 2);
    for (auto& m : linear)
        for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j)
                m(i, j) = uniform(random) * (i == j ? 0.97 : i < j ? above : below);
    const bool isTurned = random() % 2;
    return seenThrough<Dim>(isTurned ? rotation<Dim>(random) : Matrix<Dim>(Matrix<Dim>::Identity()), linear);
}

// Contractions seen through a shear.
template <int Dim> Maps<Dim> badlyConditioned(Random& random) {
    Matrix<Dim> basis = Matrix<Dim>::Identity();
    basis(0, 1) = std::pow(10, uniform(random, 1, Dim == 2 ? 4 : 3));
    if constexpr (Dim == 3) basis(1, 2) = uniform(random, -10, 10);
    std::vector<Matrix<Dim>> linear(2 + random() % 3);
    for (auto& m : linear) {
        m = randomMatrix<Dim>(random);
        m *= uniform(random, 0.3, 0.97) / spectralNorm<Dim>(m);
    }
    return seenThrough<Dim>(rotation<Dim>(random) * basis, linear);
}

// Scaled until the words up to length 7 leave room for a joint spectral radius just above 0.98 to 0.999.
template <int Dim> Maps<Dim> slow(Random& random) {
    Maps<Dim> maps(2 + random() % 2);
    for (auto& map : maps)
        map = {randomMatrix<Dim>(random), Vector<Dim>::Zero()};
    const double factor = uniform(random, 0.98, 0.999) / leastRadius<Dim>(maps, maps.size() == 2 ? 7 : 5);
    for (auto& map : maps)
        map.linear *= factor;
    return maps;
}

// The joint spectral radius is above 1, if hardly.
template <int Dim> Maps<Dim> expanding(Random& random) {
    Maps<Dim> maps = slow<Dim>(random);
    const double factor = (1 + std::pow(10, uniform(random, -12, -2))) / leastRadius<Dim>(maps, 5);
    for (auto& map : maps)
        map.linear *= factor;
    return maps;
}

struct Counts {
    int yes = 0, none = 0, undecided = 0;
};

template <int Dim> void check(Maps<Dim> (*make)(Random&), int count, int maxUndecided, bool canExist) {
    Random random{std::uint64_t(Dim)};
    Counts counts;
    for (int n = 0; n < count; ++n) {
        const Maps<Dim> maps = make(random);
        const Existence existence = classify<Dim>(maps);
        switch (existence.verdict) {
        case Verdict::Hyperbolic:
        case Verdict::EventuallyContractive: {
            ++counts.yes;
            QVERIFY(canExist && existence.contractivity < 1);
            const QString fault = contradiction<Dim>(maps, existence, random);
            QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("system %1: %2").arg(n).arg(fault)));
            break;
        }
        case Verdict::None: {
            ++counts.none;
            LongMatrix<Dim> product = LongMatrix<Dim>::Identity();
            for (const int symbol : existence.witness)
                product = product * longLinear<Dim>(maps)[std::size_t(symbol)];
            QVERIFY(radiusOf<Dim>(product) >= 1 - 1e-13L);
            break;
        }
        default:
            ++counts.undecided;
        }
    }
    qInfo("%d exist, %d do not, %d undecided", counts.yes, counts.none, counts.undecided);
    QVERIFY(counts.undecided <= maxUndecided);
}

} // namespace

// Systems that are hard to decide, and verdicts checked by long words in longer numbers.
class AdversarialExistenceTest : public QObject {
    Q_OBJECT

private slots:
    void nearlyTriangularInThePlane() { check<2>(nearlyTriangular<2>, 80, 0, true); }
    void nearlyTriangularInSpace() { check<3>(nearlyTriangular<3>, 60, 2, true); }
    void badlyConditionedInThePlane() { check<2>(badlyConditioned<2>, 80, 0, true); }
    void badlyConditionedInSpace() { check<3>(badlyConditioned<3>, 60, 2, true); }
    void slowInThePlane() { check<2>(slow<2>, 80, 0, true); }
    void slowInSpace() { check<3>(slow<3>, 40, 4, true); }
    void expandingInThePlane() { check<2>(expanding<2>, 60, 0, false); }
    void expandingInSpace() { check<3>(expanding<3>, 60, 0, false); }

    // (1 − δ)I + N with an integer N, N² = 0, and a third map coordinate: ρ = 1 − δ to the last bit.
    void withinRoundingOfOne() {
        for (const int p : {1, 2, 3, 5})
            for (const int q : {1, 2, 5})
                for (int ulps = -8; ulps <= 8; ++ulps) {
                    const double diagonal = 1 - ulps * 0x1p-46;
                    Matrix<3> linear;
                    linear << diagonal + p * q, p * p, 0, -q * q, diagonal - p * q, 0, 10, 2, 0.5;
                    const Verdict inSpace = classify<3>(Maps3{map3(linear, {1, 0, 0})}).verdict;
                    const Verdict inThePlane =
                        classify<2>(Maps2{{linear.topLeftCorner<2, 2>(), {1, 0}}}).verdict;
                    if (ulps <= 0) {
                        QCOMPARE(inSpace, Verdict::None);
                        QCOMPARE(inThePlane, Verdict::None);
                    } else {
                        QVERIFY(inSpace != Verdict::None);
                        QVERIFY(inThePlane != Verdict::None);
                    }
                }
        Matrix<3> reported;
        reported << 5.999999999999996, 1, 0, -25, -4.000000000000004, 0, 10, 2, .9999999999999956;
        QVERIFY(classify<3>(Maps3{map3(reported, {0, 0, 0})}).verdict != Verdict::None);
    }
};

BARYCAGE_TEST(AdversarialExistenceTest);
#include "adversarial_existence_test.moc"
