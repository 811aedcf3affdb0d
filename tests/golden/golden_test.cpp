// SPDX-License-Identifier: MIT
#include "attractor/render/renderer.h"
#include "collection.h"
#include "document/moments/animated_fractal.h"
#include "support/named_test.h"
#include "support/paths.h"

#include <QGuiApplication>
#include <QPainter>
#include <QtTest>

// Every entry of the collection, drawn by the engine, against a committed contact sheet per theme. With
// BARYCAGE_REWRITE_GOLDEN set in the environment the sheets are written anew instead; look at them before
// committing.
class GoldenTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void entriesLookAsCommitted_data();
    void entriesLookAsCommitted();
    void noTwoEntriesLookAlike();
    void picturesFillTheirTile();
    void aSmallChangeIsNoticed();

private:
    struct Row {
        QString name;
        document::Fractal fractal;
        QImage committed; // null where the sheet is too short
        QImage drawn;
        bool isOfPair = false; // of a fractal transformation
    };
    QList<Row> m_rows;
};

namespace {

constexpr int columns = 6;

// Measured over the collection: pictures with other random numbers agree to 29 dB and better (39 dB but for
// one whose rows lie on pixel borders), while different entries, or a code moved by five pixels, reach 21 dB
// at most.
constexpr double threshold = 25;

QString sheetPath(const golden::Theme& theme) {
    return support::sourcePath(QStringLiteral("tests/golden/collection/%1.png"))
        .arg(theme.fileName.chopped(4));
}

QRect place(qsizetype index) {
    return QRect(int(index % columns) * golden::tileSize, int(index / columns) * golden::tileSize,
                 golden::tileSize, golden::tileSize);
}

QImage sheet(const QList<QImage>& tiles) {
    const qsizetype rows = (tiles.size() + columns - 1) / columns;
    QImage result(columns * golden::tileSize, int(rows) * golden::tileSize, QImage::Format_RGB32);
    result.fill(Qt::black);
    QPainter painter(&result);
    for (qsizetype i = 0; i < tiles.size(); ++i)
        painter.drawImage(place(i), tiles[i]);
    return result;
}

} // namespace

void GoldenTest::initTestCase() {
    const bool rewrite = qEnvironmentVariableIsSet("BARYCAGE_REWRITE_GOLDEN");
    for (const golden::Theme& theme : golden::collection()) {
        QList<QImage> tiles;
        for (const document::Entry& entry : theme.file.entries)
            tiles << golden::tile(*entry.fractal);
        if (rewrite) QVERIFY(sheet(tiles).save(sheetPath(theme)));
        const QImage committed = QImage(sheetPath(theme)).convertToFormat(QImage::Format_RGB32);
        for (qsizetype i = 0; i < tiles.size(); ++i)
            m_rows << Row{theme.file.entries[i].fractal->name, *theme.file.entries[i].fractal,
                          committed.rect().contains(place(i)) ? committed.copy(place(i)) : QImage(), tiles[i],
                          theme.fileName == QStringLiteral("transformations.ifs")};
    }
    QVERIFY(!m_rows.isEmpty());
}

void GoldenTest::entriesLookAsCommitted_data() {
    QTest::addColumn<int>("row");
    for (int i = 0; i < m_rows.size(); ++i)
        QTest::addRow("%s", qPrintable(m_rows[i].name)) << i;
}

void GoldenTest::entriesLookAsCommitted() {
    QFETCH(int, row);
    QVERIFY2(!m_rows[row].committed.isNull(),
             "no committed picture: set BARYCAGE_REWRITE_GOLDEN and run again");
    const double decibels = golden::psnr(m_rows[row].drawn, m_rows[row].committed);
    QVERIFY2(decibels > threshold, qPrintable(QStringLiteral("%1 dB").arg(decibels)));
}

// What moves is another entry at rest. Of fractal transformations, the colours are what is looked at.
void GoldenTest::noTwoEntriesLookAlike() {
    const auto moves = [this](qsizetype row) {
        return document::animationFacts(m_rows[row].fractal).has_value();
    };
    for (qsizetype i = 0; i < m_rows.size(); ++i)
        for (qsizetype j = 0; j < i; ++j) {
            if (moves(i) || moves(j) || m_rows[i].isOfPair || m_rows[j].isOfPair) continue;
            const double decibels = golden::psnr(m_rows[i].drawn, m_rows[j].drawn);
            QVERIFY2(
                decibels < threshold,
                qPrintable(
                    QStringLiteral("%1 and %2: %3 dB").arg(m_rows[i].name, m_rows[j].name).arg(decibels)));
        }
}

// What is lit reaches from margin to margin in one direction: the certified box is tight, and no part of the
// attractor is so thin in measure that it stays dark.
void GoldenTest::picturesFillTheirTile() {
    for (const Row& row : m_rows) {
        const QRgb ground = row.drawn.pixel(0, 0);
        QRect lit;
        for (int y = 0; y < golden::tileSize; ++y)
            for (int x = 0; x < golden::tileSize; ++x)
                if (std::abs(qGray(row.drawn.pixel(x, y)) - qGray(ground)) > 12) lit |= QRect(x, y, 1, 1);
        const int extent = std::max(lit.width(), lit.height());
        QVERIFY2(extent >= 0.84 * golden::tileSize && extent <= 0.94 * golden::tileSize,
                 qPrintable(QStringLiteral("%1: %2 × %3").arg(row.name).arg(lit.width()).arg(lit.height())));
    }
}

// The comparison is worth something: other random numbers pass it, and a code with its first translation
// moved by a twentieth of the box, drawn in the old frame, does not.
void GoldenTest::aSmallChangeIsNoticed() {
    for (qsizetype i = 0; i < m_rows.size(); i += 5) {
        const Row& row = m_rows[i];
        if (document::dimension(row.fractal) != 2) continue; // a solid has no random numbers
        attractor::RenderRequest request = golden::tileRequest(row.fractal);
        const double pixel = 1 / request.camera.pixelsPerUnit;
        request.seed = 2;
        const double otherSeed = golden::psnr(golden::picture(attractor::render(request)), row.drawn);
        for (ifs::WeightedMap<2>& map : request.system.maps)
            map.map.translation += ifs::Vector<2>(4 * pixel, 3 * pixel);
        const double otherCode = golden::psnr(golden::picture(attractor::render(request)), row.drawn);
        const QString said = QStringLiteral("%1: %2 dB, %3 dB").arg(row.name).arg(otherSeed).arg(otherCode);
        QVERIFY2(otherSeed > threshold && otherCode < threshold, qPrintable(said));
    }
}

BARYCAGE_TEST(GoldenTest, QCoreApplication);
#include "golden_test.moc"
