// SPDX-License-Identifier: MIT
#include "attractor/request/pixel_version.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "web/engine.h"

#include <QCryptographicHash>
#include <QFile>
#include <QTest>

#include <zlib.h>

// The engines that are committed for browsers, app/web/built: whether they are made from what is here.
class EngineTest : public QObject {
    Q_OBJECT

private slots:
    void theBuiltEnginesAreOfThisProgram_data();
    void theBuiltEnginesAreOfThisProgram();
};

namespace {

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray unpacked(const QByteArray& packed) {
    constexpr int room = 1 << 24;
    QByteArray bytes(room, '\0');
    z_stream stream{};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = uInt(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = room;
    if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK || inflate(&stream, Z_FINISH) != Z_STREAM_END)
        return {};
    bytes.truncate(qsizetype(stream.total_out));
    inflateEnd(&stream);
    return bytes;
}

} // namespace

void EngineTest::theBuiltEnginesAreOfThisProgram_data() {
    QTest::addColumn<QString>("file");
    for (const char* name : {"engine", "engine_plane", "engine_moving", "engine_plane_moving"})
        QTest::newRow(name) << QStringLiteral("app/web/built/%1.wasm.gz").arg(QLatin1String(name));
}

void EngineTest::theBuiltEnginesAreOfThisProgram() {
    QFETCH(QString, file);
    const QByteArray engine = unpacked(contentsOf(support::sourcePath(file)));
    const qsizetype at = engine.indexOf("barycage web engine: ");
    QVERIFY2(at > 0, qPrintable(file + QStringLiteral(" is not an engine. To build it: ./dev web")));
    const QByteArray built(engine.constData() + at);
    const QByteArray list = contentsOf(support::testData(QStringLiteral("hashes.txt")));
    const QByteArray hash = QCryptographicHash::hash(list, QCryptographicHash::Sha256).toHex().left(16);
    const QByteArray wanted = "barycage web engine: interface " + QByteArray::number(webInterface) +
                              ", pixels " + QByteArray::number(attractor::pixelVersion) + ", hashes " + hash;
    QVERIFY2(built == wanted, "The engine in app/web/built is “" + built + "”, and this program is “" +
                                  wanted + "”. To build it anew: ./dev web");
    // The same text of the engine for this machine, which has no list.
    QVERIFY(wanted.startsWith(QByteArray(barycage_versions()).chopped(7)));
}

BARYCAGE_TEST(EngineTest);
#include "engine_test.moc"
