// SPDX-License-Identifier: MIT
#include "attractor/kernels/kernels.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "web/engine.h"
#include "web/entry_calls.h"
#include "web/tops_hash.h"

#include <QFile>
#include <QJsonDocument>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

// tests/data/hashes.txt: which pictures and certified numbers this program gives, wherever it runs. Browsers
// are compared with the same list by hashes.mjs.
class HashesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { QVERIFY(attractor::selectSimd(m_chosen)); }
    void theListIsThatOfEveryInstructionSet_data();
    void theListIsThatOfEveryInstructionSet();
    void otherPicturesHaveOtherHashes();
    void enginesAreOnTheirOwn();

private:
    std::string m_chosen;
};

namespace {

QByteArray bitsOf(double value) {
    return QByteArray::number(qulonglong(std::bit_cast<std::uint64_t>(value)), 16).rightJustified(16, '0');
}

QByteArray numberLine(const char* name, double value) {
    return ' ' + QByteArray(name) + ' ' + QByteArray::number(value, 'g', 17) + ' ' + bitsOf(value) + '\n';
}

// As barycage_camera() needs it: all of the box with a margin of a twentieth, or what the entry says.
std::vector<double> viewOf(const QJsonObject& entry, const std::vector<double>& box, int width, int height) {
    const std::vector<double> own = web::numbersOf(entry[u"view"]);
    if (!own.empty()) return own;
    const double across = .9 * width / (box[2] - box[0]), along = .9 * height / (box[3] - box[1]);
    return {(box[0] + box[2]) / 2, (box[1] + box[3]) / 2, std::min(across, along)};
}

// The vertices with some coordinates changed: dragged.
std::vector<double> dragged(std::vector<double> vertices) {
    vertices[0] += .1;
    vertices[2] += .7;
    vertices[5] -= .4;
    return vertices;
}

QByteArray picture(const QJsonObject& entry, int width, int height, double samples) {
    const web::EnginePointer engine(barycage_new(), barycage_free);
    web::Engine* const e = engine.get();
    const int dimension = web::load(e, entry);
    std::vector<double> box(std::size_t(2 * dimension + 1)),
        simplex(std::size_t(dimension * (dimension + 1)));
    barycage_extent(e, box.data(), simplex.data());
    const std::vector<double> view = viewOf(entry, box, width, height);
    barycage_camera(e, width, height, view.data());
    std::vector<double> rest = simplex, current = simplex;
    if (const QJsonObject cage = entry[u"cage"].toObject(); !cage.isEmpty()) {
        rest = web::numbersOf(cage[u"rest"]);
        current = web::numbersOf(cage[u"current"]);
    }
    const int corners = int(rest.size()) / dimension;
    barycage_cage(e, rest.data(), current.data(), corners, 1);
    barycage_draw(e, samples, 1, 0);

    QByteArray text = entry[u"name"].toString().toUtf8() + ' ' + QByteArray::number(width) + 'x' +
                      QByteArray::number(height) + ' ' + QByteArray::number(samples, 'f', 0) +
                      " samples hash " + web::hashOf(e) + '\n';
    // The error in space is computed with long double, which is not the same on every machine.
    if (dimension == 3) box.pop_back();
    for (const double number : box)
        text += numberLine("box", number);
    for (const double number : simplex)
        text += numberLine("tri", number);
    barycage_cage(e, rest.data(), dragged(current).data(), corners, 1);
    barycage_draw(e, samples, 1, 0);
    text += " dragged hash " + web::hashOf(e) + '\n';
    std::vector<double> stops(5 * 64), numbers = web::appearanceOf(entry);
    const int count = barycage_palette_stops(5, stops.data());
    numbers[1] = 8;  // brightness
    numbers[13] = 0; // opacity of the background
    barycage_appearance(e, numbers.data());
    barycage_stops(e, stops.data(), count);
    barycage_draw(e, samples, 1, 0);
    barycage_draw(e, samples, 0, 0);
    return text + " refined transparent hash " + web::hashOf(e) + '\n';
}

QJsonArray systems() {
    QFile file(support::testData(QStringLiteral("hash_systems.json")));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).array() : QJsonArray();
}

QByteArray list() {
    QByteArray text;
    for (const QJsonValue system : systems())
        for (const QJsonValue size : system[u"pictures"].toArray())
            text +=
                picture(system[u"entry"].toObject(), size[0].toInt(), size[1].toInt(), size[2].toDouble());
    return text + web::topsHashes().c_str();
}

} // namespace

void HashesTest::initTestCase() {
    m_chosen = attractor::simdName();
    QVERIFY(systems().size() > 8);
}

void HashesTest::theListIsThatOfEveryInstructionSet_data() {
    QTest::addColumn<QString>("set");
    for (const std::string& name : attractor::simdNames())
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

void HashesTest::theListIsThatOfEveryInstructionSet() {
    QFETCH(QString, set);
    QVERIFY(attractor::selectSimd(set.toStdString()));
    const QByteArray now = list();
    QFile file(support::testData(QStringLiteral("hashes.txt")));
    if (qEnvironmentVariableIsSet("BARYCAGE_REWRITE_HASHES")) {
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(now), now.size());
        return;
    }
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> expected = file.readAll().split('\n'), drawn = now.split('\n');
    for (qsizetype i = 0; i < std::min(expected.size(), drawn.size()); ++i)
        QVERIFY2(drawn[i] == expected[i],
                 "line " + QByteArray::number(i + 1) + " of tests/data/hashes.txt is “" + expected[i] +
                     "”, and this program gives “" + drawn[i] +
                     "”. If pixels are meant to change, raise pixelVersion and run BARYCAGE_REWRITE_HASHES=1 "
                     "ctest --preset release -R hashes_test, then ./dev web");
    QCOMPARE(drawn.size(), expected.size());
}

// What a hash that is always the same would hide.
void HashesTest::otherPicturesHaveOtherHashes() {
    QSet<QByteArray> seen;
    qsizetype hashes = 0;
    for (const QByteArray& line : list().split('\n'))
        if (const qsizetype at = line.indexOf("hash "); at >= 0) {
            seen.insert(line.sliced(at));
            ++hashes;
        }
    QVERIFY(hashes > 60);
    QCOMPARE(seen.size(), hashes);
}

// A second engine, and an entry loaded before, leave no trace.
void HashesTest::enginesAreOnTheirOwn() {
    const QJsonArray all = systems();
    const auto hash = [](web::Engine* engine, const QJsonObject& entry) {
        web::load(engine, entry);
        const double view[] = {0, 0, 40, 30, 20, 3, 0};
        barycage_camera(engine, 160, 120, view);
        barycage_draw(engine, 20'000, 1, 0);
        return web::hashOf(engine);
    };
    const web::EnginePointer used(barycage_new(), barycage_free);
    for (const QJsonValue system : all)
        hash(used.get(), system[u"entry"].toObject());
    for (const QJsonValue system : all) {
        const web::EnginePointer fresh(barycage_new(), barycage_free);
        const QJsonObject entry = system[u"entry"].toObject();
        QCOMPARE(hash(used.get(), entry), hash(fresh.get(), entry));
    }
}

BARYCAGE_TEST(HashesTest);
#include "hashes_test.moc"
