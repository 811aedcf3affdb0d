// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_writer.h"
#include "support/fractint_bytes.h"
#include "support/named_test.h"

#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <cmath>

using document::FractalFile;
using document::Problem;

namespace {

QString corpus() {
    return qEnvironmentVariable("BARYCAGE_CORPUS");
}

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList filesIn(const QString& folder) {
    QStringList paths;
    QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext())
        paths << it.next();
    paths.sort();
    return paths;
}

struct Sum {
    int dimension = 0;
    std::size_t maps = 0;
    double coefficients = 0; // weights included, as the reference programs add them
};

template <int Dim> Sum sumOf(const ifs::IteratedFunctionSystem<Dim>& system) {
    Sum sum{Dim, system.maps.size(), 0};
    for (const auto& map : system.maps)
        sum.coefficients += map.map.linear.sum() + map.map.translation.sum() + map.weight.value_or(0);
    return sum;
}

Sum sumOf(const document::Fractal& fractal) {
    if (const auto* plane = document::system2(fractal)) return sumOf(*plane);
    if (const auto* space = document::system3(fractal)) return sumOf(*space);
    return {};
}

// What the reference programs made of the file: "name:ok 2D 2 maps sum=3.5; …"
QMap<QString, Sum> accepted(const QString& cell) {
    static const QRegularExpression good(QStringLiteral("([^;:]+):ok (\\d)D (\\d+) maps sum=([-0-9.]+)"));
    QMap<QString, Sum> entries;
    for (auto it = good.globalMatch(cell); it.hasNext();) {
        const auto match = it.next();
        entries[match.captured(1).trimmed()] = {match.captured(2).toInt(), match.captured(3).toULongLong(),
                                                match.captured(4).toDouble()};
    }
    return entries;
}

} // namespace

class FractintCorpusTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (corpus().isEmpty()) QSKIP("BARYCAGE_CORPUS is not set: the real files are not tested");
        QVERIFY2(QDir(corpus() + QStringLiteral("/real")).exists(), qPrintable(corpus()));
    }

    void everyFileKeepsItsBytes() {
        int files = 0;
        for (const QString& path : filesIn(corpus())) {
            const QByteArray bytes = contentsOf(path);
            const FractalFile file = io::readFractint(bytes);
            QVERIFY2(support::joined(file) == bytes, qPrintable(path));
            QVERIFY2(io::writeFractint(file) == bytes, qPrintable(path));
            QVERIFY2(!file.entries.isEmpty() || !file.problems.isEmpty(), qPrintable(path));
            ++files;
        }
        QVERIFY(files > 100);
    }

    void edgeCasesAgreeWithTheReferencePrograms() {
        // Tokens on which readers disagree are refused: 5D-1 and 1/3.
        const QStringList refused{QStringLiteral("44_fortran_d.ifs"), QStringLiteral("46_fraction.ifs")};
        const QList<QByteArray> lines =
            contentsOf(corpus() + QStringLiteral("/edge/expected.tsv")).split('\n').mid(1);
        int compared = 0;
        for (const QByteArray& line : lines) {
            const QStringList cells = QString::fromUtf8(line).split(QLatin1Char('\t'));
            if (cells.size() < 3) continue;
            const FractalFile file =
                io::readFractint(contentsOf(corpus() + QStringLiteral("/edge/") + cells[0]));
            if (refused.contains(cells[0])) {
                QCOMPARE(document::dimension(*file.entries.value(0).fractal), 0);
                continue;
            }
            for (int program : {1, 2})
                for (const auto& [name, sum] : accepted(cells[program]).asKeyValueRange()) {
                    compareEntry(file, cells[0], name, sum);
                    ++compared;
                }
        }
        QVERIFY(compared > 60);
    }

    void realCollectionsLoad() {
        int entries = 0;
        int unreadable = 0;
        for (const QString& path : filesIn(corpus() + QStringLiteral("/real"))) {
            if (path.contains(QStringLiteral("/alien/")) ||
                !path.endsWith(QStringLiteral(".ifs"), Qt::CaseInsensitive))
                continue;
            const FractalFile file = io::readFractint(contentsOf(path));
            QVERIFY2(!file.entries.isEmpty(), qPrintable(path));
            for (const auto& entry : file.entries) {
                ++entries;
                if (document::dimension(*entry.fractal) != 0) continue;
                ++unreadable;
                const auto isError = [](const Problem& problem) {
                    return problem.severity == Problem::Severity::Error;
                };
                const auto found = std::find_if(entry.problems.begin(), entry.problems.end(), isError);
                QVERIFY2(found != entry.problems.end() && found->line > 0 && found->column > 0,
                         qPrintable(path));
                qInfo("%s", qPrintable(document::toText(*found, QFileInfo(path).fileName())));
            }
        }
        qInfo("%d entries, %d of them unreadable", entries, unreadable);
        QVERIFY(entries > 5000);
        QVERIFY(unreadable * 500 < entries);
    }

    void unrelatedFormatsAreNamed() {
        for (const QString& path : filesIn(corpus() + QStringLiteral("/real/alien"))) {
            const FractalFile file = io::readFractint(contentsOf(path));
            QVERIFY2(file.entries.isEmpty(), qPrintable(path));
            QCOMPARE(file.problems.size(), 1);
            QCOMPARE(file.problems[0].severity, Problem::Severity::Error);
            qInfo("%s: %s", qPrintable(QFileInfo(path).fileName()), qPrintable(file.problems[0].message));
        }
    }

private:
    void compareEntry(const FractalFile& file, const QString& path, const QString& name,
                      const Sum& expected) {
        const auto found =
            std::find_if(file.entries.begin(), file.entries.end(), [&](const document::Entry& entry) {
                const QString ours = entry.fractal->name;
                return ours.left(18).compare(name, Qt::CaseInsensitive) ==
                           0 || // the first of two equal names is reached
                       ours.section(QLatin1Char(' '), 0, 0) == name;
            });
        QVERIFY2(found != file.entries.end(), qPrintable(path + QLatin1Char(' ') + name));
        const Sum sum = sumOf(*found->fractal);
        QVERIFY2(sum.dimension == expected.dimension && sum.maps == expected.maps &&
                     std::abs(sum.coefficients - expected.coefficients) < 1e-5,
                 qPrintable(path + QLatin1Char(' ') + name));
    }
};

BARYCAGE_TEST(FractintCorpusTest);
#include "fractint_corpus_test.moc"
