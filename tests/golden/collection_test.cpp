// SPDX-License-Identifier: MIT
#include "collection.h"

#include "attractor/chaos_game.h"
#include "document/fractal.h"
#include "ifs/attractor_existence.h"
#include "ifs/facts.h"
#include "ifs/moments.h"
#include "io/fractint_writer.h"
#include "support/paths.h"

#include <QDir>
#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include <numeric>

class CollectionTest : public QObject {
    Q_OBJECT

private slots:
    void indexNamesEveryFile();
    void themesAreDescribed();
    void namesAreUnique();
    void bytesAreStrict();
    void entriesLoadWithoutAProblem_data();
    void entriesLoadWithoutAProblem();
    void entriesHaveAnAttractor_data();
    void entriesHaveAnAttractor();
    void weightsSumToOne_data();
    void weightsSumToOne();
    void boxIsOfReasonableShape_data();
    void boxIsOfReasonableShape();
    void paperSystemsAreAsPrinted();
    void samplesHaveTheExactMoments_data();
    void samplesHaveTheExactMoments();
    void geometryIsCertified_data() { entryRows(); }
    void geometryIsCertified();

private:
    void entryRows();
    const QList<golden::Theme> m_themes = golden::collection();
};

// One row for every entry of the collection.
void CollectionTest::entryRows() {
    QTest::addColumn<int>("theme");
    QTest::addColumn<int>("entry");
    for (int t = 0; t < m_themes.size(); ++t)
        for (int e = 0; e < m_themes[t].file.entries.size(); ++e)
            QTest::addRow("%s", qPrintable(m_themes[t].file.entries[e].fractal->name)) << t << e;
}

void CollectionTest::indexNamesEveryFile() {
    QStringList indexed;
    for (const golden::Theme& theme : m_themes)
        indexed << theme.fileName;
    QCOMPARE(indexed.size(), QSet<QString>(indexed.begin(), indexed.end()).size());
    QStringList bundled = QDir(QStringLiteral(":/ifs_library")).entryList({QStringLiteral("*.ifs")});
    indexed.sort();
    bundled.sort();
    QCOMPARE(bundled, indexed);
    const QDir source(support::sourcePath(QStringLiteral("ifs_library")));
    QCOMPARE(source.entryList({QStringLiteral("*.ifs")}, QDir::Files, QDir::Name), indexed);
}

void CollectionTest::themesAreDescribed() {
    qsizetype entries = 0;
    for (const golden::Theme& theme : m_themes) {
        QVERIFY(!theme.title.isEmpty() && theme.title.size() < 30);
        QVERIFY(theme.description.endsWith(u'.'));
        QVERIFY(!theme.file.entries.isEmpty());
        entries += theme.file.entries.size();
    }
    QVERIFY(entries >= 120);
}

void CollectionTest::namesAreUnique() {
    QHash<QString, QString> seen;
    for (const golden::Theme& theme : m_themes)
        for (const document::Entry& entry : theme.file.entries) {
            const QString name = entry.fractal->name;
            QVERIFY2(name.size() <= 18, qPrintable(name));
            QVERIFY2(!seen.contains(name.toLower()), qPrintable(name));
            seen.insert(name.toLower(), theme.fileName);
        }
}

// The form that every reader takes, judged here without our own reader: ASCII, LF, one map of seven plain
// decimals a line, comments after the header only, the closing brace alone on its line.
void CollectionTest::bytesAreStrict() {
    const QString number = QStringLiteral("-?(0|[1-9]\\d*)(\\.\\d+)?");
    const QRegularExpression header(QStringLiteral("^[a-z0-9_]{1,18} \\{ ; \\S[ -~]*$"));
    const QRegularExpression row(QStringLiteral("^  %1( %1){6}$").arg(number));
    const QRegularExpression comment(QStringLiteral("^(  )?; [ -~]*\\S$"));
    enum class Place { Outside, Comments, Rows } place = Place::Outside;
    for (const golden::Theme& theme : m_themes) {
        QVERIFY(theme.bytes.endsWith('\n') && !theme.bytes.endsWith("\n\n"));
        for (const QByteArray& bytes : theme.bytes.chopped(1).split('\n')) {
            const QString line = QString::fromLatin1(bytes);
            const char* said = bytes.constData();
            QVERIFY2(bytes.size() < 200, said);
            if (place == Place::Outside && (line.isEmpty() || comment.match(line).hasMatch())) continue;
            if (place == Place::Outside) {
                QVERIFY2(header.match(line).hasMatch(), said);
                place = Place::Comments;
            } else if (place == Place::Comments && line.startsWith(QStringLiteral("  ;"))) {
                QVERIFY2(comment.match(line).hasMatch() && bytes.size() < 72, said);
            } else if (place == Place::Rows && line == u'}') {
                place = Place::Outside;
            } else {
                QVERIFY2(row.match(line).hasMatch(), said);
                place = Place::Rows;
            }
        }
        QVERIFY(place == Place::Outside);
    }
}

void CollectionTest::entriesLoadWithoutAProblem_data() {
    entryRows();
}

void CollectionTest::entriesLoadWithoutAProblem() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const document::FractalFile& file = m_themes[theme].file;
    QVERIFY(file.problems.isEmpty());
    const document::Entry& loaded = file.entries[entry];
    QVERIFY2(loaded.problems.isEmpty(), qPrintable(loaded.problems.value(0).message));
    QVERIFY(document::system2(*loaded.fractal));
    QVERIFY(!loaded.fractal->headerComment.isEmpty()); // its title
    const io::StrictText strict = io::writeStrict(file, {loaded.id});
    QVERIFY2(strict.problems.isEmpty(), qPrintable(strict.problems.value(0).message));
    const document::FractalFile again = io::readFractint(strict.bytes);
    QCOMPARE(again.entries.size(), 1);
    const document::System2& before = *document::system2(*loaded.fractal);
    const document::System2& after = *document::system2(*again.entries[0].fractal);
    QVERIFY(ifs::mapsOf(after) == ifs::mapsOf(before));
    for (std::size_t i = 0; i < before.maps.size(); ++i)
        QVERIFY(std::abs(*after.maps[i].weight - *before.maps[i].weight) <= 1e-15);
}

void CollectionTest::entriesHaveAnAttractor_data() {
    entryRows();
}

void CollectionTest::entriesHaveAnAttractor() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const document::System2& system = *document::system2(*m_themes[theme].file.entries[entry].fractal);
    const std::vector<ifs::AffineMap<2>> maps = ifs::mapsOf(system);
    const ifs::Verdict verdict = ifs::classify(std::span(maps)).verdict;
    QVERIFY(verdict == ifs::Verdict::Hyperbolic || verdict == ifs::Verdict::EventuallyContractive);
}

void CollectionTest::weightsSumToOne_data() {
    entryRows();
}

void CollectionTest::weightsSumToOne() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const document::System2& system = *document::system2(*m_themes[theme].file.entries[entry].fractal);
    double sum = 0;
    for (const ifs::WeightedMap<2>& map : system.maps) {
        QVERIFY(map.weight && *map.weight > 0);
        sum += *map.weight;
    }
    QVERIFY2(std::abs(sum - 1) <= 1e-12, qPrintable(QString::number(sum, 'g', 17)));
}

void CollectionTest::boxIsOfReasonableShape_data() {
    entryRows();
}

void CollectionTest::boxIsOfReasonableShape() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const std::optional<document::Box> box =
        document::displayedBox(*m_themes[theme].file.entries[entry].fractal);
    QVERIFY(box);
    const ifs::Vector<2> size = box->max - box->min;
    QVERIFY(size.minCoeff() > 0 && size.maxCoeff() < 100);
    QVERIFY2(size.maxCoeff() / size.minCoeff() < 6, qPrintable(QString::number(size.x() / size.y())));
}

void CollectionTest::paperSystemsAreAsPrinted() {
    const auto rows = [&](const QString& name) {
        for (const document::Entry& entry : m_themes[0].file.entries)
            if (entry.fractal->name == name) return ifs::mapsOf(*document::system2(*entry.fractal));
        return std::vector<ifs::AffineMap<2>>();
    };
    const std::vector<ifs::AffineMap<2>> maple = {ifs::affineMap(-0.04, 0, -0.23, -0.65, -0.08, 0.26),
                                                  ifs::affineMap(0.61, 0, 0, 0.31, 0.07, 3.5),
                                                  ifs::affineMap(0.65, 0.29, -0.3, 0.48, 0.74, 0.39),
                                                  ifs::affineMap(0.64, -0.3, 0.16, 0.56, -0.56, 0.60)};
    const std::vector<ifs::AffineMap<2>> flower = {ifs::affineMap(0.47, 0.30, -0.30, 0.47, 0.37, 1.74),
                                                   ifs::affineMap(0.48, -0.29, 0.29, 0.48, -0.34, 1.75)};
    QVERIFY(rows(QStringLiteral("maple")) == maple);
    QVERIFY(rows(QStringLiteral("flower")) == flower);
}

void CollectionTest::samplesHaveTheExactMoments_data() {
    entryRows();
}

// Within five standard errors. Those of the mean are the exact long-run ones, which vanish along y for the
// twindragon: then, as for the covariance, those between sample sets, whose streams have nothing in common.
// To the accuracy that the window and `info` promise, the search for periodic corners included.
void CollectionTest::geometryIsCertified() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const document::System2& system = *document::system2(*m_themes[theme].file.entries[entry].fractal);
    const ifs::Facts<2> facts = ifs::factsOf<2>(system);
    QVERIFY(facts.box && facts.simplex && facts.hull);
    const double diagonal = (facts.box->max - facts.box->min).norm();
    QVERIFY(facts.hull->error <= 1e-6 * diagonal);
    QVERIFY(facts.simplex->error <= 1e-11 * facts.simplex->leg);
}

void CollectionTest::samplesHaveTheExactMoments() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const document::System2& system = *document::system2(*m_themes[theme].file.entries[entry].fractal);
    const auto exact = ifs::moments(ifs::activeMaps(system));
    QVERIFY(exact);
    const attractor::DrawableSystem drawable = attractor::drawable(system);
    constexpr int sets = 32;
    attractor::SampleSet samples;
    using Moments = Eigen::Vector<double, 5>; // x, y, xx, xy, yy about the exact mean
    Moments sum = Moments::Zero();
    Moments squares = Moments::Zero();
    for (std::uint64_t pass = 0; pass < sets; ++pass) {
        attractor::drawSamples(drawable, 7, pass, samples);
        Moments ofSet = Moments::Zero();
        for (std::size_t k = 0; k < attractor::SampleSet::size; ++k) {
            const ifs::Vector<2> v =
                drawable.centre +
                drawable.halfExtent.cwiseProduct(ifs::Vector<2>(samples.x[k], samples.y[k])) - exact->mean;
            ofSet += Moments{{v.x(), v.y(), v.x() * v.x(), v.x() * v.y(), v.y() * v.y()}};
        }
        ofSet /= attractor::SampleSet::size;
        sum += ofSet;
        squares += ofSet.cwiseProduct(ofSet);
    }
    const Moments mean = sum / sets;
    Moments error = ((squares / sets - mean.cwiseProduct(mean)).cwiseMax(0) / (sets - 1)).cwiseSqrt();
    for (int axis = 0; axis < 2; ++axis) {
        const double longRun =
            exact->longRunCovariance(axis, axis) / (sets * double(attractor::SampleSet::size));
        if (longRun > 1e-6 * error[axis] * error[axis]) error[axis] = std::sqrt(longRun);
    }
    const Moments expected{{0, 0, exact->covariance(0, 0), exact->covariance(0, 1), exact->covariance(1, 1)}};
    const double size = drawable.halfExtent.maxCoeff();
    for (int k = 0; k < 5; ++k) {
        const double rounding = 1e-5 * (k < 2 ? size : size * size); // samples are single precision
        QVERIFY(std::abs(mean[k] - expected[k]) <= 5 * error[k] + rounding);
    }
}

QTEST_GUILESS_MAIN(CollectionTest)
#include "collection_test.moc"
