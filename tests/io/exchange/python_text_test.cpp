// SPDX-License-Identifier: MIT
#include "io/exchange/python_text.h"
#include "io/fractint/entry_writer.h"
#include "support/named_test.h"

#include <QProcess>
#include <QTest>

using namespace Qt::StringLiterals;

// What Python makes of the lines: its own interpreter, with another package of this name, which prints what
// it is given.
class PythonTextTest : public QObject {
    Q_OBJECT

private slots:
    void theStringIsTheEntry_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("comment");
        QTest::newRow("plain") << u"maple"_s << QString();
        QTest::newRow("quotation marks") << u"a\"\"\"b"_s << u"\"\"\"; import os; \"\"\""_s;
        QTest::newRow("backslashes") << u"a\\n\\"_s << u"ends with \\"_s;
        QTest::newRow("apostrophes") << u"'''"_s << u"it's"_s;
        QTest::newRow("letters") << u"кленов лист"_s << u"½ “🍁” \x85\x2028\x7f"_s;
        QTest::newRow("control characters") << u"a\x01z"_s << u"bell \x07, escape \x1b"_s;
    }

    void theStringIsTheEntry() {
        QFETCH(const QString, name);
        QFETCH(const QString, comment);
        document::Fractal fractal = document::sierpinskiTriangle();
        fractal.name = name;
        fractal.comments = {comment};
        fractal.appearance.gamma = 3;
        QProcess python;
        python.start(u"python3"_s, {u"-I"_s, u"-c"_s, uR"(
import sys, types
def parse(text):
    sys.stdout.buffer.write(text.encode())
    return ["the first one"]
sys.modules["barycage"] = types.SimpleNamespace(parse=parse)
names = {}
exec(sys.stdin.buffer.read(), names)
assert names["entry"] == "the first one"
)"_s});
        python.write(io::pythonText(fractal));
        python.closeWriteChannel();
        QVERIFY(python.waitForFinished(120'000));
        QCOMPARE(python.readAllStandardError(), QByteArray());
        QCOMPARE(python.readAllStandardOutput(), "\n" + io::writeEntry(fractal));
    }

    void anEntryLooksLikeItsFile() {
        const QByteArray text = io::pythonText(document::sierpinskiTriangle());
        QVERIFY(text.startsWith("# "));
        QVERIFY(text.sliced(text.indexOf('\n'))
                    .startsWith("\nimport barycage as bc\n\nentry = bc.parse(\"\"\"\n"));
        QVERIFY(text.contains("\"\"\"\n" + io::writeEntry(document::sierpinskiTriangle()) + "\"\"\")[0]\n"));
    }
};

BARYCAGE_TEST(PythonTextTest, QCoreApplication);
#include "python_text_test.moc"
