// SPDX-License-Identifier: MIT
#include "desktop/clipboard.h"

#include "document/fractal/fractal_geometry.h"
#include "io/fractint/fractint_reader.h"
#include "support/named_test.h"

#include <QMimeData>
#include <QTest>

using namespace Qt::StringLiterals;
using document::Entry;
using document::Fractal;

namespace {

Entry made(const Fractal& fractal) {
    Entry entry;
    entry.fractal = std::make_shared<const Fractal>(fractal);
    return entry;
}

Fractal elaborate() {
    Fractal fractal = document::sierpinskiTriangle();
    fractal.name = u"bent"_s;
    fractal.headerComment = u"A triangle, pulled"_s;
    fractal.comments = QStringList{u"first line"_s, u"second line: a = 0.5"_s};
    document::plane(fractal)->cage = document::effectiveCage(fractal);
    document::plane(fractal)->cage->current[1] = {1.25, 0.1};
    fractal.appearance.gamma = 1.7;
    fractal.appearance.background = {250, 248, 240, 255};
    fractal.appearance.colourBy = attractor::ColourBy::Map;
    document::system2(fractal)->maps[0].map.translation.x() = 0.1 + 0.2; // needs all its digits
    return fractal;
}

} // namespace

class ClipboardTest : public QObject {
    Q_OBJECT

private slots:
    void roundTripKeepsEverything();
    void severalEntriesInOrder();
    void unreadableTextIsKept();
    void plainTextOfOthers();
    void bareTable();
    void flames();
    void columnsThatSayNothing();
    void nothingToFind();
};

void ClipboardTest::roundTripKeepsEverything() {
    const auto mimeData = view::entriesMimeData({made(elaborate())});
    const view::FoundEntries found = view::entriesIn(*mimeData);
    QCOMPARE(found.entries.size(), 1);
    const Fractal& back = *found.entries.front().fractal;
    const Fractal sent = elaborate();
    QCOMPARE(back.name, sent.name);
    QCOMPARE(back.headerComment.trimmed(), sent.headerComment);
    QCOMPARE(back.comments, sent.comments);
    QVERIFY(document::plane(back)->cage == document::plane(sent)->cage);
    QVERIFY(back.appearance == sent.appearance);
    QVERIFY(document::system2(back));
    QVERIFY(ifs::mapsOf(*document::system2(back)) == ifs::mapsOf(*document::system2(sent)));
    QVERIFY(!found.entries.front().source);
    QVERIFY(view::mayHoldEntries(*mimeData));
    QVERIFY(mimeData->hasText());
}

void ClipboardTest::severalEntriesInOrder() {
    Fractal second = document::sierpinskiTriangle();
    second.name = u"second"_s;
    Fractal third = elaborate();
    third.name = u"third"_s;
    const view::FoundEntries found =
        view::entriesIn(view::entriesText({made(elaborate()), made(second), made(third)}));
    QCOMPARE(found.entries.size(), 3);
    QCOMPARE(found.entries[0].fractal->name, u"bent"_s);
    QCOMPARE(found.entries[1].fractal->name, u"second"_s);
    QCOMPARE(found.entries[2].fractal->comments.size(), 2);
    QVERIFY(found.problems.isEmpty());
}

void ClipboardTest::unreadableTextIsKept() {
    const document::FractalFile file =
        io::readFractint("good {\n .5 0 0 .5 0 0 1\n}\nbad { ; mine\n one two three\n}\n");
    QCOMPARE(file.entries.size(), 2);
    QCOMPARE(document::dimension(*file.entries[1].fractal), 0);
    const QByteArray text = view::entriesText({file.entries[1]});
    QCOMPARE(text, file.entries[1].source->text);
    const view::FoundEntries found = view::entriesIn(text);
    QCOMPARE(found.entries.size(), 1);
    QVERIFY(found.entries.front().source);
    QVERIFY(found.entries.front().source->text.contains("one two three"));
    QVERIFY(!found.problems.isEmpty());
}

void ClipboardTest::plainTextOfOthers() {
    QMimeData mimeData;
    mimeData.setText(u"fern {; Barnsley\r\n 0 0 0 .16 0 0 .01\r\n .85 .04 -.04 .85 0 1.6 .99 }\r\n"_s);
    const view::FoundEntries found = view::entriesIn(mimeData);
    QCOMPARE(found.entries.size(), 1);
    QCOMPARE(found.entries.front().fractal->name, u"fern"_s);
    QCOMPARE(document::system2(*found.entries.front().fractal)->maps.size(), std::size_t{2});
}

void ClipboardTest::bareTable() {
    const view::FoundEntries found =
        view::entriesIn("0.5\t0\t0\t0.5\t0\t0\t0.5\n0.5\t0\t0\t0.5\t0.5\t0\t0.5\n");
    QCOMPARE(found.entries.size(), 1);
    const auto* system = document::system2(*found.entries.front().fractal);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t{2});
    QCOMPARE(system->maps[1].map.translation.x(), 0.5);
    QVERIFY(system->maps[0].id != system->maps[1].id);
}

void ClipboardTest::flames() {
    const view::FoundEntries found =
        view::entriesIn(R"(<flame name="gasket" size="640 480" center="0 0" scale="100">)"
                        R"(<xform weight="0.5" linear="1" coefs="0.5 0 0 0.5 0 0"/>)"
                        R"(<xform weight="0.5" linear="1" coefs="0.5 0 0 0.5 0.25 0"/></flame>)");
    QCOMPARE(found.entries.size(), 1);
    QCOMPARE(found.entries.front().fractal->name, u"gasket"_s);
    const auto* system = document::system2(*found.entries.front().fractal);
    QVERIFY(system);
    QCOMPARE(system->maps.size(), std::size_t{2});
    QCOMPARE(system->maps[1].map.translation.x(), 0.25);
    QVERIFY(found.table.isEmpty());
}

// Only bare numbers leave open which column is which.
void ClipboardTest::columnsThatSayNothing() {
    const auto isOpen = [](const char* text) { return !view::entriesIn(text).table.isEmpty(); };
    QVERIFY(isOpen("0.5 0 0 0.5 0 0 0.5\n0.5 0 0 0.5 0.5 0 0.5\n"));
    QVERIFY(isOpen("0.5,0,0,0.5,0,0\n0.5,0,0,0.5,0.5,0\n"));
    QVERIFY(!isOpen("a,b,c,d,e,f\n0.5,0,0,0.5,0,0\n0.5,0,0,0.5,0.5,0\n"));
    QVERIFY(!isOpen("gasket {\n 0.5 0 0 0.5 0 0 0.5\n 0.5 0 0 0.5 0.5 0 0.5\n}\n"));
}

void ClipboardTest::nothingToFind() {
    // In a file such a number would be no entry, or one without a name.
    QVERIFY(view::entriesIn("1").entries.isEmpty());
    QVERIFY(!view::entriesIn("1").problems.isEmpty());
    QVERIFY(view::entriesIn("a sentence about ferns, nothing more").entries.isEmpty());
    QVERIFY(view::entriesIn("").entries.isEmpty());
    QVERIFY(view::entriesText({}).isEmpty());
    QVERIFY(!view::mayHoldEntries(QMimeData()));
}

BARYCAGE_TEST(ClipboardTest, QCoreApplication);
#include "clipboard_test.moc"
