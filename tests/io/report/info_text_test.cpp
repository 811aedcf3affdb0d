// SPDX-License-Identifier: MIT
#include "io/report/figure_error.h"
#include "io/report/info_json.h"
#include "io/report/info_text.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <cmath>
#include <memory>

namespace {

using Rows = std::vector<std::array<double, 6>>;

io::InfoSubject subjectOf(const Rows& rows) {
    document::System2 system;
    for (const auto& [a, b, c, d, e, f] : rows)
        ifs::append(system, ifs::affineMap(a, b, c, d, e, f));
    document::Fractal fractal = support::fractalOf(system, QStringLiteral("test"));
    io::InfoSubject subject;
    document::Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(fractal);
    subject.entries.push_back(entry);
    return subject;
}

QString lineOf(const io::InfoSubject& subject, const QString& name) {
    for (const QString& line : io::infoText(subject).split(u'\n'))
        if (line.trimmed().startsWith(name)) return line.trimmed().mid(name.size()).trimmed();
    return {};
}

QJsonObject entryOf(const io::InfoSubject& subject) {
    return QJsonDocument::fromJson(io::infoJson(subject))[QStringLiteral("entries")][0].toObject();
}

const Rows Gasket{{.5, 0, 0, .5, 0, 0}, {.5, 0, 0, .5, .5, 0}, {.5, 0, 0, .5, 0, .5}};

} // namespace

class InfoTextTest : public QObject {
    Q_OBJECT

private slots:
    void notesOfErrors() {
        QCOMPARE(io::errorNote({1.5, -2}, 1e-9, 1, 6), QString());
        QCOMPARE(io::errorNote({1.5, -2}, 1e-5, 1, 6), QStringLiteral(" ± 1e-05"));
        QCOMPARE(io::errorNote({1.5, 1e-7}, 1e-9, 1, 6), QStringLiteral(" ± 1e-09"));
        QCOMPARE(io::errorNote({1.5, 1e-12}, 1e-9, 1, 6), QString());
        QCOMPARE(io::errorNote({0, 0}, 1e-17, 1, 6), QString());
        QCOMPARE(io::errorNote({0, 0}, 1e-3, 1, 6), QStringLiteral(" ± 0.001"));
        for (const double error : {1.2345e-4, 9.96e-3, 1.0001e5})
            QVERIFY(io::errorNote({1}, error, 1e9, 6).mid(3).toDouble() >= error || error > 1);
        QCOMPARE(io::withoutNoise(1e-17, 1e-16), 0.0);
        QCOMPARE(io::withoutNoise(1e-15, 1e-16), 1e-15);
        QVERIFY(io::isWorthless(2, 1) && io::isWorthless(1, 1) && !io::isWorthless(0.5, 1));
        QVERIFY(!io::isWorthless(0, 0));
    }

    void exactFiguresCarryNoError() {
        const auto subject = subjectOf(Gasket);
        QCOMPARE(lineOf(subject, QStringLiteral("mean")), QStringLiteral("(0.333333, 0.333333)"));
        QCOMPARE(lineOf(subject, QStringLiteral("bounding box")), QStringLiteral("(0, 0) (1, 1)"));
        QVERIFY(!lineOf(subject, QStringLiteral("convex hull")).contains(u'±'));
    }

    void figuresEndWhereTheirErrorsBegin() {
        QCOMPARE(io::figure(1234.5678, 0, 0, 6), QStringLiteral("1234.57"));
        QCOMPARE(io::figure(1234.5678, 3, 1000, 6), QStringLiteral("1234.6"));
        QCOMPARE(io::figure(1234.5678, 200, 1000, 6), QStringLiteral("1.23e+03"));
        QCOMPARE(io::figure(1e9 + 1, 0, 1, 6), QStringLiteral("1000000001"));
        QCOMPARE(io::figure(1e9 + 1, 0, 0, 6), QStringLiteral("1e+09"));
        QCOMPARE(io::figure(-0.0, 0, 1, 6), QStringLiteral("0"));
        QCOMPARE(io::errorNote({1e9 + 1}, 1e-2, 1, 6), QStringLiteral(" ± 0.01"));
        QCOMPARE(io::errorNote({1e9 + 1}, 1e-2, 1e9, 6), QString());
        for (const double bound : {1., 1.001e-7, 1.2499, 9.49e3, 9.51, 9.96})
            QVERIFY(io::boundText(bound).toDouble() >= bound);
    }

    // At 10⁹ the digits reach as far down as the attractor is small, and no farther than its errors.
    void aFigureFarAwayIsToldFromItsNeighbours() {
        auto rows = Gasket;
        for (auto& row : rows) {
            row[4] += 5e8;
            row[5] += 5e8;
        }
        const auto subject = subjectOf(rows);
        QVERIFY(lineOf(subject, QStringLiteral("bounding box"))
                    .startsWith(QStringLiteral("(1000000000, 1000000000) (1000000001, 1000000001)")));
        QVERIFY(lineOf(subject, QStringLiteral("mean")).startsWith(QStringLiteral("(1000000000.3333")));
        QVERIFY(lineOf(subject, QStringLiteral("map 2")).contains(QStringLiteral("500000000.5")));
        // What is exact has no error but the rounding of its vertices.
        QVERIFY(lineOf(subject, QStringLiteral("convex hull")).endsWith(QStringLiteral("area 0.5; exact")));
        const QJsonObject hull = entryOf(subject)[QStringLiteral("hull")].toObject();
        QVERIFY(hull[QStringLiteral("exact")].toBool());
        QVERIFY(hull[QStringLiteral("error")].toDouble() <= 1e-6);
    }

    // Also of maps that flatten the plane, or take it to one point.
    void allIsKnownOfAPoint_data() {
        QTest::addColumn<Rows>("rows");
        QTest::newRow("similarity") << Rows{{.5, 0, 0, .5, 1, 2}};
        QTest::newRow("affine map") << Rows{{.3, .1, -.2, .3, .5, 1.6}};
        QTest::newRow("flat map") << Rows{{.5, 0, 0, 0, .5, 1}};
        QTest::newRow("constant") << Rows{{0, 0, 0, 0, 3, 4}};
        QTest::newRow("two maps") << Rows{{.5, 0, 0, .25, 0, 0}, {.25, 0, .5, 0, 0, 0}};
    }
    void allIsKnownOfAPoint() {
        QFETCH(Rows, rows);
        const auto subject = subjectOf(rows);
        QCOMPARE(lineOf(subject, QStringLiteral("similarity dimension")), QStringLiteral("0"));
        QCOMPARE(lineOf(subject, QStringLiteral("affinity dimension")), QStringLiteral("0"));
        QCOMPARE(lineOf(subject, QStringLiteral("dimension of measure")), QStringLiteral("0"));
        QCOMPARE(lineOf(subject, QStringLiteral("covariance")), QStringLiteral("(0, 0) (0, 0)"));
        QCOMPARE(lineOf(subject, QStringLiteral("convex hull")), QStringLiteral("a point; exact"));
        QCOMPARE(lineOf(subject, QStringLiteral("connectedness")), QStringLiteral("connected"));
        const QJsonObject entry = entryOf(subject);
        QCOMPARE(entry[QStringLiteral("affinity_dimension_error")].toDouble(), 0.0);
        QCOMPARE(entry[QStringLiteral("covariance_error")].toDouble(), 0.0);
        QVERIFY(entry[QStringLiteral("hull")][QStringLiteral("exact")].toBool());
        QVERIFY(entry[QStringLiteral("hull")][QStringLiteral("area_error")].toDouble() < 1e-28);
    }

    // The plane's dimension stands for a larger one, and says so.
    void aDimensionAboveThatOfThePlane() {
        const Rows many{
            {.6, .1, 0, .7, 0, 0}, {.6, 0, .2, .7, 1, 0}, {.7, .1, 0, .6, 0, 1}, {.6, 0, 0, .7, 1, 1}};
        const auto subject = subjectOf(many);
        QCOMPARE(lineOf(subject, QStringLiteral("affinity dimension")), QStringLiteral("at least 2"));
        const QJsonObject entry = entryOf(subject);
        QCOMPARE(entry[QStringLiteral("affinity_dimension")].toDouble(), 2.0);
        QVERIFY(entry[QStringLiteral("capped")].toBool());
        const auto plain = subjectOf(Gasket);
        QVERIFY(!entryOf(plain).contains(QStringLiteral("capped")));
        const Rows twin{{.5, -.5, .5, .5, 0, 0}, {.5, -.5, .5, .5, .5, -.5}};
        QVERIFY(!entryOf(subjectOf(twin)).contains(QStringLiteral("capped"))); // exactly 2
        QCOMPARE(lineOf(subjectOf(twin), QStringLiteral("affinity dimension")), QStringLiteral("2"));
        const QJsonObject tile = entryOf(subjectOf(twin))[QStringLiteral("tile")].toObject();
        QVERIFY(tile[QStringLiteral("boundary_dimension_error")].toDouble() > 0);
    }

    // The squares of such lengths are below the least number.
    void figuresOfATinySystemAreKnown() {
        auto rows = Gasket;
        for (auto& row : rows) {
            row[4] *= 1e-201;
            row[5] *= 1e-201;
        }
        const auto subject = subjectOf(rows);
        const QString mean = lineOf(subject, QStringLiteral("mean"));
        QVERIFY2(mean.startsWith(QStringLiteral("(3.33333e-202, 3.33333e-202)")), qPrintable(mean));
        const QString box = lineOf(subject, QStringLiteral("bounding box"));
        QVERIFY2(box.startsWith(QStringLiteral("(0, 0) (1e-201, 1e-201)")), qPrintable(box));
    }

    // 1 − 10⁻¹¹ of a turn of 1 radian is left by each step: rounding shows in what is summed up.
    void figuresCarryTheirErrors() {
        const double r = 1 - 1e-11;
        const auto subject = subjectOf({{r, 0, 0, .5, 1, 0}, {r, 0, 0, .25, 3, 1}});
        const QString mean = lineOf(subject, QStringLiteral("mean"));
        QVERIFY2(mean.contains(QStringLiteral(" ± ")), qPrintable(mean));
        const double error = mean.section(QStringLiteral(" ± "), 1).toDouble();
        const QJsonObject entry = entryOf(subject);
        QVERIFY(error >= entry[QStringLiteral("mean_error")].toDouble());
        QVERIFY(entry[QStringLiteral("mean_error")].toDouble() > 0);
        QVERIFY(std::abs(entry[QStringLiteral("mean")][0].toDouble() - 2 / 1e-11) < 1e11);
        QVERIFY(entry[QStringLiteral("covariance_error")].toDouble() > 0);
        QVERIFY(lineOf(subject, QStringLiteral("attractor")).contains(QStringLiteral("s = 0.9999999999")));
        QVERIFY(entry[QStringLiteral("hull")].toObject().contains(QStringLiteral("area_error")));
    }

    void namesTheNormAndTheWord() {
        const auto turned = subjectOf({{.999, 1000, 0, -.999, 0, 0}, {-.998, 500, 0, .997, 1, 0}});
        const QString verdict = lineOf(turned, QStringLiteral("attractor"));
        QVERIFY2(verdict.contains(QStringLiteral("norm")) || verdict.contains(QStringLiteral("words")),
                 qPrintable(verdict));
        QCOMPARE(entryOf(subjectOf(Gasket))[QStringLiteral("attractor")][QStringLiteral("norm")].toString(),
                 QStringLiteral("euclidean"));
        const auto none = subjectOf({{2, 0, 0, .25, 0, 0}, {.5, 0, 0, 3.9, 0, 0}});
        QCOMPARE(lineOf(none, QStringLiteral("attractor")), QStringLiteral("none: ρ(A) ≥ 1 for the word 1"));
        QCOMPARE(entryOf(none)[QStringLiteral("attractor")][QStringLiteral("witness")].toArray().size(), 1);
        QVERIFY(entryOf(none)[QStringLiteral("attractor")][QStringLiteral("norm")].isNull());
    }

    void saysWhatTheSimilarityDimensionIs() {
        QCOMPARE(lineOf(subjectOf(Gasket), QStringLiteral("similarity dimension")),
                 QStringLiteral("1.58496 (the open set condition holds)"));
        // Two ratios, and squares that touch.
        const auto touching =
            subjectOf({{.5, 0, 0, .5, 0, 0}, {.5, 0, 0, .5, .5, 0}, {.25, 0, 0, .25, 0, .5}});
        QVERIFY(lineOf(touching, QStringLiteral("similarity dimension"))
                    .contains(QStringLiteral("the open set condition holds")));
        QCOMPARE(entryOf(touching)[QStringLiteral("open_set_condition")], QJsonValue(true));
        // Two ratios, and pieces that meet.
        QVERIFY(lineOf(subjectOf({{.6, 0, 0, .6, 0, 0}, {.6, 0, 0, .6, .3, 0}, {.25, 0, 0, .25, 0, .5}}),
                       QStringLiteral("similarity dimension"))
                    .contains(QStringLiteral("if the open set condition holds")));
        auto rows = Gasket;
        rows.push_back(rows[1]);
        const auto twice = subjectOf(rows);
        QVERIFY(
            lineOf(twice, QStringLiteral("similarity dimension")).contains(QStringLiteral("upper bound")));
        QCOMPARE(lineOf(twice, QStringLiteral("overlap")),
                 QStringLiteral("the words 2 and 4 are the same map"));
        const QJsonObject entry = entryOf(twice);
        QCOMPARE(entry[QStringLiteral("separation")].toString(), QStringLiteral("overlapping"));
        QCOMPARE(entry[QStringLiteral("connectedness")].toString(), QStringLiteral("connected"));
        QVERIFY(entry[QStringLiteral("overlaps")][0][QStringLiteral("exact")].toBool());
        const auto dust = subjectOf({{.25, 0, 0, .25, 0, 0}, {.25, 0, 0, .25, 1, 0}});
        QVERIFY(lineOf(dust, QStringLiteral("similarity dimension")).contains(QStringLiteral("disjoint")));
        QCOMPARE(lineOf(dust, QStringLiteral("connectedness")), QStringLiteral("not connected"));
    }

    void saysWhatIsProvedOfNeighbours() {
        const QJsonObject gasket = entryOf(subjectOf(Gasket));
        QCOMPARE(gasket[QStringLiteral("open_set_condition")], QJsonValue(true));
        QVERIFY(!gasket.contains(QStringLiteral("open_set_condition_to_rounding")));
        QCOMPARE(gasket[QStringLiteral("neighbours")].toInt(), 6);
        const QJsonObject dimension = gasket[QStringLiteral("hausdorff_dimension")].toObject();
        QVERIFY(std::abs(dimension[QStringLiteral("value")].toDouble() - std::log2(3)) < 1e-12);
        QCOMPARE(dimension[QStringLiteral("by")].toString(), QStringLiteral("open set condition"));
        QVERIFY(!dimension[QStringLiteral("to_rounding")].toBool());
        QVERIFY(std::abs(gasket[QStringLiteral("spectrum")][QStringLiteral("D2")].toDouble() - std::log2(3)) <
                1e-12);
        QCOMPARE(lineOf(subjectOf(Gasket), QStringLiteral("joint spectral radius")), QStringLiteral("0.5"));
        const double third = 1. / 3;
        const auto digits = subjectOf(
            {{third, 0, 0, third, 0, 0}, {third, 0, 0, third, third, 0}, {third, 0, 0, third, 1, 0}});
        const QJsonObject overlapping = entryOf(digits);
        QCOMPARE(overlapping[QStringLiteral("open_set_condition")], QJsonValue(false));
        QVERIFY(!overlapping.contains(QStringLiteral("open_set_condition_to_rounding"))); // 03 = 10 as stored
        QCOMPARE(overlapping[QStringLiteral("hausdorff_dimension")][QStringLiteral("by")].toString(),
                 QStringLiteral("finite type"));
        QCOMPARE(lineOf(digits, QStringLiteral("Hausdorff dimension")),
                 QStringLiteral("0.876036 (finite type) (within rounding error)"));
        QVERIFY(overlapping[QStringLiteral("spectrum")].isNull());
        const auto segment = subjectOf({{.9, 0, 0, .9, 0, 0}, {.9, 0, 0, .9, 1, 0}});
        QVERIFY(entryOf(segment)[QStringLiteral("measure_dimension_capped")].toBool());
        QVERIFY(
            lineOf(segment, QStringLiteral("dimension of measure")).startsWith(QStringLiteral("at most 1 ")));
        QCOMPARE(lineOf(segment, QStringLiteral("connectedness")), QStringLiteral("connected"));
        QCOMPARE(lineOf(segment, QStringLiteral("Hausdorff dimension")), QStringLiteral("1"));
        QCOMPARE(entryOf(segment)[QStringLiteral("hausdorff_dimension")][QStringLiteral("by")].toString(),
                 QStringLiteral("convex hull"));
        // One map, whose powers grow for long before they shrink.
        const auto point = subjectOf({{1629810176.25, -1629810175.75, 1629810176.75, -1629810176.25, 1, 0}});
        QCOMPARE(lineOf(point, QStringLiteral("open set condition")), QStringLiteral("holds"));
        QCOMPARE(entryOf(point)[QStringLiteral("similarity_dimension")].toDouble(-1), 0.0);
        QVERIFY(entryOf(point)[QStringLiteral("bounding_box")][QStringLiteral("error")].toDouble(1) < 1e-6);
    }

    // The numbers of a Koch curve are rounded, so what is known of it holds within rounding error.
    void saysWhatHoldsWithinRounding() {
        const double third = 1. / 3, half = 1. / 6, high = std::sqrt(3) / 6;
        const auto koch = subjectOf({{third, 0, 0, third, 0, 0},
                                     {half, -high, high, half, third, 0},
                                     {half, high, -high, half, .5, high},
                                     {third, 0, 0, third, 2 * third, 0}});
        const QString spectrum = lineOf(koch, QStringLiteral("spectrum"));
        QVERIFY2(spectrum.startsWith(QStringLiteral("D0 1.26186, D1 1.26186")) &&
                     spectrum.endsWith(QStringLiteral(" (within rounding error)")),
                 qPrintable(spectrum));
        const QString exact = lineOf(subjectOf(Gasket), QStringLiteral("spectrum"));
        QVERIFY2(exact.endsWith(QStringLiteral("D∞ 1.58496")), qPrintable(exact));
    }

    void saysWhereNoFactorIsKnown() {
        const auto slow = subjectOf({{.28, -.96, .96, .28, 1, 0}, {.14, -.48, .48, .14, 0, 1}});
        QCOMPARE(lineOf(slow, QStringLiteral("attractor")), QStringLiteral("hyperbolic, s < 1"));
        const QJsonObject attractor = entryOf(slow)[QStringLiteral("attractor")].toObject();
        QCOMPARE(attractor[QStringLiteral("verdict")].toString(), QStringLiteral("hyperbolic"));
        QVERIFY(attractor[QStringLiteral("contractivity")].isNull());
    }

    // Three copies of nine tenths have no room in the plane without overlapping.
    void aDimensionAboveThatOfTheSpaceIsABound() {
        const auto subject = subjectOf({{.9, 0, 0, .9, 1, 0}, {.9, 0, 0, .9, 0, 1}, {.9, 0, 0, .9, 1, 1}});
        for (const char* name : {"similarity dimension", "dimension of measure"})
            QVERIFY(lineOf(subject, QLatin1String(name))
                        .endsWith(QStringLiteral("(upper bound: the open set condition fails)")));
    }

    void invariants() {
        const auto subject = subjectOf(Gasket);
        QCOMPARE(lineOf(subject, QStringLiteral("entropy")), QStringLiteral("1.09861"));
        QCOMPARE(lineOf(subject, QStringLiteral("Lyapunov exponent")), QStringLiteral("-0.693147"));
        QVERIFY(
            lineOf(subject, QStringLiteral("dimension of measure")).startsWith(QStringLiteral("1.58496")));
        const QJsonObject radius = entryOf(subject)[QStringLiteral("joint_spectral_radius")].toObject();
        QVERIFY(radius[QStringLiteral("least")].toDouble() <= 0.5);
        QVERIFY(radius[QStringLiteral("most")].toDouble() >= 0.5);
    }
};

BARYCAGE_TEST(InfoTextTest);
#include "info_text_test.moc"
