// SPDX-License-Identifier: MIT
#include "collection.h"

#include "attractor/samples/chaos_game.h"
#include "document/edits/coupled_entries.h"
#include "document/edits/maps/link_expansion.h"
#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "document/tops/kept_theft.h"
#include "document/tops/theft_starters.h"
#include "ifs/canonical_systems.h"
#include "ifs/dimension/dimension.h"
#include "ifs/dimension/moments.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/extent/extent.h"
#include "ifs/facts.h"
#include "ifs/links/linked_existence.h"
#include "ifs/system/links.h"
#include "io/fractint/fractint_strict.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QDir>
#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include <numbers>
#include <numeric>
#include <random>
#include <utility>

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
    void everyFrameHasAnAttractor();
    void weightsSumToOne_data();
    void weightsSumToOne();
    void boxIsOfReasonableShape_data();
    void boxIsOfReasonableShape();
    void paperSystemsAreAsPrinted();
    void samplesHaveTheExactMoments_data();
    void samplesHaveTheExactMoments();
    void geometryIsCertified_data() { entryRows(2); }
    void geometryIsCertified();
    void hullsTurnWithTheirSystems_data() { entryRows(2); }
    void hullsTurnWithTheirSystems();
    void thereAreManySolids();
    void solidsAreCertified_data() { entryRows(3); }
    void solidsAreCertified();
    void solidsHaveTheirDimension_data();
    void solidsHaveTheirDimension();
    void fern3IsFractints();
    void linkedMapsHaveTheirDimension_data();
    void linkedMapsHaveTheirDimension();
    void partsOfTilesHaveTheirAreas();
    void transformationsFindTheirPartners();

private:
    void entryRows(int dimension = 0); // 0: of the plane and of space
    const document::Fractal& named(const QString& name) const;
    const QList<golden::Theme> m_themes = golden::collection();
};

namespace {

// The system of an entry, whatever its dimension, handed to work().
template <class Work> void visitSystem(const document::Fractal& fractal, Work work) {
    if (const auto* plane = document::system2(fractal))
        work(*plane);
    else
        work(*document::system3(fractal));
}

} // namespace

// One row for every entry of the collection.
void CollectionTest::entryRows(int dimension) {
    QTest::addColumn<int>("theme");
    QTest::addColumn<int>("entry");
    for (int t = 0; t < m_themes.size(); ++t)
        for (int e = 0; e < m_themes[t].file.entries.size(); ++e) {
            const document::Fractal& fractal = *m_themes[t].file.entries[e].fractal;
            if (dimension == 0 || document::dimension(fractal) == dimension)
                QTest::addRow("%s", qPrintable(fractal.name)) << t << e;
        }
}

const document::Fractal& CollectionTest::named(const QString& name) const {
    for (const golden::Theme& theme : m_themes)
        for (const document::Entry& entry : theme.file.entries)
            if (entry.fractal->name == name) return *entry.fractal;
    throw std::runtime_error("no entry " + name.toStdString());
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
// decimals (thirteen in space) a line, comments after the header only, the closing brace alone on its line.
void CollectionTest::bytesAreStrict() {
    const QString number = QStringLiteral("-?(0|[1-9]\\d*)(\\.\\d+)?");
    const QRegularExpression header(QStringLiteral("^[a-z0-9_]{1,18}( \\(3D\\))? \\{ ; \\S[ -~]*$"));
    const QRegularExpression planeRow(QStringLiteral("^  %1( %1){6}$").arg(number));
    const QRegularExpression spaceRow(QStringLiteral("^  %1( %1){12}$").arg(number));
    const QRegularExpression comment(QStringLiteral("^(  )?; [ -~]*\\S$"));
    enum class Place { Outside, Comments, Rows } place = Place::Outside;
    bool inSpace = false;
    for (const golden::Theme& theme : m_themes) {
        QVERIFY(theme.bytes.endsWith('\n') && !theme.bytes.endsWith("\n\n"));
        for (const QByteArray& bytes : theme.bytes.chopped(1).split('\n')) {
            const QString line = QString::fromLatin1(bytes);
            const char* said = bytes.constData();
            QVERIFY2(bytes.size() < 200, said);
            if (place == Place::Outside && (line.isEmpty() || comment.match(line).hasMatch())) continue;
            if (place == Place::Outside) {
                QVERIFY2(header.match(line).hasMatch(), said);
                inSpace = line.contains(QStringLiteral("(3D)"));
                place = Place::Comments;
            } else if (place == Place::Comments && line.startsWith(QStringLiteral("  ;"))) {
                QVERIFY2(comment.match(line).hasMatch() && bytes.size() < 72, said);
            } else if (place == Place::Rows && line == u'}') {
                place = Place::Outside;
            } else {
                QVERIFY2((inSpace ? spaceRow : planeRow).match(line).hasMatch(), said);
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
    QVERIFY(document::dimension(*loaded.fractal) != 0);
    QVERIFY(!loaded.fractal->headerComment.isEmpty()); // its title
    const io::StrictText strict = io::writeStrict(file, {loaded.id});
    // Other programs have palettes of their own; what else is lost is named.
    const auto isExpected = [&](const QString& message) {
        return message.endsWith(QStringLiteral("is written without its palette.")) ||
               (document::isLinked(*loaded.fractal) &&
                message.contains(QStringLiteral("the links of its maps"))) ||
               (document::animationFacts(*loaded.fractal) &&
                message.contains(QStringLiteral("its animation"))) ||
               (document::keptTheft(*loaded.fractal) &&
                message.contains(QStringLiteral("its fractal transformation")));
    };
    for (const document::Problem& problem : strict.problems)
        QVERIFY2(isExpected(problem.message), qPrintable(problem.message));
    const document::FractalFile again = io::readFractint(strict.bytes);
    QCOMPARE(again.entries.size(), 1);
    const document::Fractal& written = *again.entries[0].fractal;
    QCOMPARE(document::dimension(written), document::dimension(*loaded.fractal));
    visitSystem(*loaded.fractal, [&](const auto& before) {
        visitSystem(written, [&](const auto& after) {
            if constexpr (std::is_same_v<decltype(before), decltype(after)>) {
                QVERIFY(ifs::mapsOf(after) == ifs::mapsOf(before));
                for (std::size_t i = 0; i < before.maps.size(); ++i)
                    QVERIFY(std::abs(*after.maps[i].weight - *before.maps[i].weight) <= 1e-15);
            }
        });
    });
}

void CollectionTest::entriesHaveAnAttractor_data() {
    entryRows();
}

void CollectionTest::entriesHaveAnAttractor() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    visitSystem(*m_themes[theme].file.entries[entry].fractal, [](const auto& system) {
        const auto maps = ifs::mapsOf(system);
        const ifs::Verdict verdict = ifs::classify(std::span(maps)).verdict;
        QVERIFY(verdict == ifs::Verdict::Hyperbolic || verdict == ifs::Verdict::EventuallyContractive);
    });
}

// Every frame that can be asked for, not only the moments that the program looks at.
void CollectionTest::everyFrameHasAnAttractor() {
    int animations = 0;
    for (const golden::Theme& theme : m_themes)
        for (const document::Entry& entry : theme.file.entries) {
            const auto facts = document::animationFacts(*entry.fractal);
            if (!facts) continue;
            ++animations;
            for (int frame = 0; frame <= facts->length; ++frame) {
                const document::AnimatedFrame shown =
                    document::frameAt(*entry.fractal, animation::moment(frame));
                visitSystem(shown.fractal, [&](const auto& system) {
                    const auto maps = ifs::activeMaps(system).maps;
                    const ifs::Verdict verdict = ifs::classify(std::span(maps)).verdict;
                    QVERIFY2(verdict == ifs::Verdict::Hyperbolic ||
                                 verdict == ifs::Verdict::EventuallyContractive,
                             qPrintable(QStringLiteral("%1: frame %2").arg(entry.fractal->name).arg(frame)));
                });
            }
        }
    QVERIFY(animations >= 12);
}

void CollectionTest::weightsSumToOne_data() {
    entryRows();
}

void CollectionTest::weightsSumToOne() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    visitSystem(*m_themes[theme].file.entries[entry].fractal, [](const auto& system) {
        double sum = 0;
        for (const auto& map : system.maps) {
            QVERIFY(map.weight && *map.weight > 0);
            sum += *map.weight;
        }
        QVERIFY2(std::abs(sum - 1) <= 1e-12, qPrintable(QString::number(sum, 'g', 17)));
    });
}

void CollectionTest::boxIsOfReasonableShape_data() {
    entryRows(2);
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
    QVERIFY(rows(QStringLiteral("maple")) == canonical::maple());
    QVERIFY(rows(QStringLiteral("flower")) == canonical::flower());
}

void CollectionTest::samplesHaveTheExactMoments_data() {
    entryRows(2);
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
    QVERIFY2(facts.hull->error <= 1e-6 * diagonal, qPrintable(QString::number(facts.hull->error)));
    QVERIFY(facts.simplex->error <= 1e-11 * facts.simplex->leg);
}

// Between the area of the polygon and that with a seam as wide as the error lies the area of the hull.
void CollectionTest::hullsTurnWithTheirSystems() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const auto maps = ifs::activeMaps(*document::system2(*m_themes[theme].file.entries[entry].fractal)).maps;
    double least = 0, most = std::numeric_limits<double>::infinity();
    for (const ifs::Vector<2>& turn : {ifs::Vector<2>(1, 0), {0, 1}, {-1, 0}, {0, -1}, {0.8, 0.6}}) {
        const ifs::AffineMap<2> rotation = ifs::affineMap(turn.x(), -turn.y(), turn.y(), turn.x(), 0, 0);
        std::vector<ifs::AffineMap<2>> turned;
        for (const auto& map : maps)
            turned.push_back(*ifs::conjugate(rotation, map));
        const auto support = *ifs::SupportFunction<2>::of(turned);
        const double size = support.radius() + support.centre().norm(), rounding = 1e-13 * size * size;
        for (const double tolerance : {1e-5, 1e-12}) {
            const auto hull = ifs::convexHull(support, tolerance * size);
            double seam = std::numbers::pi * hull.error * hull.error;
            for (std::size_t k = 0; k < hull.vertices.size(); ++k)
                seam +=
                    hull.error * (hull.vertices[(k + 1) % hull.vertices.size()] - hull.vertices[k]).norm();
            least = std::max(least, hull.area - rounding);
            most = std::min(most, hull.area + seam + rounding);
        }
    }
    QVERIFY2(least <= most,
             qPrintable(QStringLiteral("%1 > %2").arg(least, 0, 'g', 17).arg(most, 0, 'g', 17)));
}

void CollectionTest::thereAreManySolids() {
    qsizetype solids = 0;
    for (const golden::Theme& theme : m_themes)
        for (const document::Entry& entry : theme.file.entries)
            solids += document::dimension(*entry.fractal) == 3 ? 1 : 0;
    QVERIFY(solids >= 24);
}

void CollectionTest::solidsAreCertified() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const auto& system = *document::system3(*m_themes[theme].file.entries[entry].fractal);
    const auto support = ifs::SupportFunction<3>::of(ifs::activeMaps(system).maps);
    QVERIFY(support);
    const auto box = ifs::boundingBox(*support);
    const ifs::Vector<3> size = box.max - box.min;
    QVERIFY(box.error <= 1e-6 * size.norm());
    QVERIFY(size.maxCoeff() < 100);
    QVERIFY2(size.maxCoeff() / size.minCoeff() < 6,
             qPrintable(QString::number(size.maxCoeff() / size.minCoeff())));
    QVERIFY(ifs::minimalCanonicalSimplex(*support).error <= 1e-6 * size.norm());
}

void CollectionTest::solidsHaveTheirDimension_data() {
    QTest::addColumn<double>("dimension");
    const auto ratio = [](double copies, double scale) { return std::log(copies) / std::log(scale); };
    constexpr double phi = std::numbers::phi;
    QTest::newRow("tetrahedron") << 2.0;
    QTest::newRow("octahedron_flake") << ratio(6, 2);
    QTest::newRow("pyramid") << ratio(5, 2);
    QTest::newRow("icosahedron_flake") << ratio(12, 1 + phi);
    QTest::newRow("dodecahedron_flake") << ratio(20, 2 + phi);
    QTest::newRow("cuboctahedron") << ratio(12, 3);
    QTest::newRow("menger") << ratio(20, 3);
    QTest::newRow("mosely") << ratio(18, 3);
    QTest::newRow("cross_space") << ratio(7, 3);
    QTest::newRow("saltire_space") << 2.0;
    QTest::newRow("cantor_space") << ratio(8, 3);
    QTest::newRow("cube_corner") << ratio(7, 2);
    QTest::newRow("mirrored_corners") << ratio(7, 2);
    QTest::newRow("quadratic_koch") << ratio(13, 3);
    // 8 x + 12 x^2 = 1 where x is the ratio √2 − 1 to the power of the dimension
    QTest::newRow("jerusalem_cube") << ratio((std::sqrt(7.0) - 2) / 6, std::numbers::sqrt2 - 1);
    QTest::newRow("space_dragon") << 2.0;
    QTest::newRow("space_levy") << 2.0;
    QTest::newRow("space_terdragon") << 2.0;
    QTest::newRow("turned_tetra") << 2.0;
    QTest::newRow("turned_cubes") << ratio(8, 1 / 0.45);
    QTest::newRow("turned_octa") << ratio(6, 2);
}

void CollectionTest::solidsHaveTheirDimension() {
    QFETCH(double, dimension);
    const auto maps = ifs::mapsOf(*document::system3(named(QString::fromLatin1(QTest::currentDataTag()))));
    const std::optional<double> found = ifs::similarityDimension<3>(maps);
    QVERIFY(found);
    QVERIFY2(std::abs(*found - dimension) < 1e-8, qPrintable(QString::number(*found, 'g', 12)));
}

// Its extent is that of docs/mathematics.md.
void CollectionTest::fern3IsFractints() {
    const auto& system = *document::system3(named(QStringLiteral("fern3")));
    QCOMPARE(system.maps.size(), std::size_t(4));
    const auto box = ifs::boundingBox(*ifs::SupportFunction<3>::of(ifs::mapsOf(system)));
    const ifs::Vector<3> min(-1.623248571865150, 0, -4.998953181197701);
    const ifs::Vector<3> max(1.623248571865150, 7.997725100771707, 0);
    QVERIFY((box.min - min).norm() < 1e-9);
    QVERIFY((box.max - max).norm() < 1e-9);
}

void CollectionTest::linkedMapsHaveTheirDimension_data() {
    QTest::addColumn<double>("dimension");
    constexpr double boundary = 1.523627086202492; // of the dragon: 2 log2 λ, λ³ = λ² + 2
    constexpr double phi = std::numbers::phi;
    QTest::newRow("penrose_tiles") << 2.0;
    QTest::newRow("penrose_cracks") << 2 * std::log(phi) / std::log(phi / 0.93);
    QTest::newRow("rauzy_parts") << 2.0;
    QTest::newRow("dragon_boundary") << boundary;
    QTest::newRow("twin_boundary") << boundary;
    QTest::newRow("golden_mean") << 2 * 0.694241913630617;
    QTest::newRow("shift_dragon") << 2 * 0.694241913630617;
    QTest::newRow("pentagon_restless") << 2.0;
    for (const char* name : {"square_one_way", "square_neighbours", "hexagon_steps", "pentagon_steps"})
        QTest::newRow(name) << std::log2(3.0);
}

void CollectionTest::linkedMapsHaveTheirDimension() {
    QFETCH(double, dimension);
    const auto& system = *document::system2(named(QString::fromLatin1(QTest::currentDataTag())));
    for (const ifs::LinkState state : ifs::linkStates(system))
        QVERIFY(state == ifs::LinkState::TakesPart);
    const auto active = ifs::activeMaps(system);
    QVERIFY(active.isLinked());
    QCOMPARE(active.links.size(), active.maps.size() * active.maps.size());
    const ifs::Verdict verdict = ifs::classifyLinked<2>(active).verdict;
    QVERIFY(verdict == ifs::Verdict::Hyperbolic || verdict == ifs::Verdict::EventuallyContractive);
    const std::optional<double> found = ifs::factsOf<2>(system).similarityDimension;
    QVERIFY(found);
    QVERIFY2(std::abs(*found - dimension) < 1e-12, qPrintable(QString::number(*found, 'g', 17)));
}

// Counted on a grid by the chaos game, without the engine.
void CollectionTest::partsOfTilesHaveTheirAreas() {
    constexpr double tribonacci = 1.839286755214161, side = 300; // cells to the unit
    const auto areas = [&](const QString& name) {
        const auto& system = *document::system2(named(name));
        const std::vector<double> matrix = ifs::linkMatrix(system);
        const std::size_t n = system.maps.size();
        std::mt19937_64 random(1);
        std::vector<std::discrete_distribution<std::size_t>> next;
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<double> weights;
            for (std::size_t j = 0; j < n; ++j)
                weights.push_back(*system.maps[j].weight * matrix[i * n + j]);
            next.emplace_back(weights.begin(), weights.end());
        }
        std::vector<QSet<std::pair<int, int>>> cells(n);
        ifs::Vector<2> x(0, 0);
        std::size_t at = 0;
        for (int k = 0; k < 3'000'000; ++k) {
            at = next[at](random);
            x = system.maps[at].map(x);
            if (k > 100) cells[at].insert({int(std::floor(x.x() * side)), int(std::floor(x.y() * side))});
        }
        std::vector<double> counts;
        for (const auto& part : cells)
            counts.push_back(double(part.size()));
        return counts;
    };
    const std::vector<double> rauzy = areas(QStringLiteral("rauzy_parts"));
    QVERIFY2(std::abs(rauzy[0] / rauzy[1] - tribonacci) < 0.03,
             qPrintable(QString::number(rauzy[0] / rauzy[1])));
    QVERIFY2(std::abs(rauzy[1] / rauzy[2] - tribonacci) < 0.03,
             qPrintable(QString::number(rauzy[1] / rauzy[2])));
    const std::vector<double> penrose = areas(QStringLiteral("penrose_tiles")); // the kite, then the dart
    const double kite = std::reduce(penrose.begin(), penrose.begin() + 16, 0.0);
    const double dart = std::reduce(penrose.begin() + 16, penrose.end(), 0.0);
    QVERIFY2(std::abs(kite / dart - std::numbers::phi) < 0.03, qPrintable(QString::number(kite / dart)));
}

// Both entries of each, which together open as a picture.
void CollectionTest::transformationsFindTheirPartners() {
    int transformations = 0;
    QSet<int> patterns;
    for (const golden::Theme& theme : m_themes)
        for (const document::Entry& entry : theme.file.entries) {
            const auto kept = document::keptTheft(*entry.fractal);
            if (!kept) continue;
            const char* said = qPrintable(entry.fractal->name);
            ++transformations;
            patterns.insert(int(kept->pattern));
            QVERIFY2(kept->picture.isEmpty(), said); // no path that might break
            const document::EntryId id = document::entryNamed(theme.file, kept->partner);
            QVERIFY2(id != document::EntryId::None, said);
            const document::Fractal& partner = *theme.file.entries[document::indexOf(theme.file, id)].fractal;
            QVERIFY2(document::coupled(*entry.fractal, partner, kept->order).entries, said);
        }
    QCOMPARE(transformations, 12);
    QVERIFY(patterns.size() >= 6);
}

void CollectionTest::samplesHaveTheExactMoments() {
    QFETCH(int, theme);
    QFETCH(int, entry);
    const document::System2& system = *document::system2(*m_themes[theme].file.entries[entry].fractal);
    const auto exact = ifs::moments(ifs::activeMaps(system));
    QVERIFY(exact);
    const attractor::PreparedSystem drawable = attractor::prepared(system);
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

BARYCAGE_TEST(CollectionTest, QCoreApplication);
#include "collection_test.moc"
