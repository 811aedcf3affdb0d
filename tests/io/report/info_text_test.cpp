// SPDX-License-Identifier: MIT
#include "io/report/figure_error.h"
#include "io/report/info_json.h"
#include "io/report/info_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <memory>

namespace {

io::InfoSubject subjectOf(const std::vector<std::array<double, 6>>& rows) {
    document::System2 system;
    for (const auto& [a, b, c, d, e, f] : rows)
        ifs::append(system, ifs::affineMap(a, b, c, d, e, f));
    document::Fractal fractal;
    fractal.name = QStringLiteral("test");
    fractal.shape = document::Shape<2>{.system = system};
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

const std::vector<std::array<double, 6>> Gasket{
    {.5, 0, 0, .5, 0, 0}, {.5, 0, 0, .5, .5, 0}, {.5, 0, 0, .5, 0, .5}};

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
        QVERIFY(lineOf(subjectOf(Gasket), QStringLiteral("similarity dimension"))
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

QTEST_APPLESS_MAIN(InfoTextTest)
#include "info_text_test.moc"
