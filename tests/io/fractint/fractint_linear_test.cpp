// SPDX-License-Identifier: MIT
#include "io/fractint/fractint_reader.h"
#include "io/fractint/fractint_strict.h"
#include "io/fractint/fractint_writer.h"
#include "support/named_test.h"
#include "support/thorough.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <malloc.h>

using document::Entry;
using document::Fractal;
using document::FractalFile;

namespace {

using TextLayout = QByteArray (*)(int count);
using FileChange = void (*)(FractalFile& file);

const QByteArray row = ".5 0 0 .5 0 0 .5";

QByteArray entry(int i) {
    return 'e' + QByteArray::number(i) + " { " + row + ' ' + row + " }";
}

QByteArray entries(int count, const QByteArray& odd, const QByteArray& even) {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += entry(i) + (i % 2 == 0 ? odd : even);
    return text;
}

QByteArray shareOneLine(int count) {
    return entries(count, " ", " ") + '\n';
}
QByteArray shareOneOpenLine(int count) {
    return "first {\n" + row + "\n}\n" + entries(count, "", "");
}
QByteArray standInPairs(int count) {
    return entries(count, " ", "\n");
}
QByteArray haveALineEach(int count) {
    return entries(count, "\r", "\r");
}
QByteArray areLeftOpen(int count) {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += "e" + QByteArray::number(i) + " {\n" + row + '\n';
    return text;
}
QByteArray areOtherBlocks(int count) {
    return QByteArray("frm:f { x = 1 } { } comment { x } p { x = 2 } } ").repeated(count) + '\n' + entry(1);
}
QByteArray areNoEntries(int count) {
    return QByteArray("word\n").repeated(count) + QByteArray("word ").repeated(count) + '\n' + entry(1);
}
QByteArray areRowsOnOneLine(int count) {
    return "rows { " + (row + ' ').repeated(count) + "}\n";
}
QByteArray areRows(int count) {
    return "rows {\n" + (row + '\n').repeated(count) + "}\n";
}
QByteArray areComments(int count) {
    return "comments {\n" + QByteArray("; \xc3\xbc\n").repeated(count) + row + "\n}\n";
}

void change(Entry& entry, const std::function<void(Fractal&)>& edit) {
    Fractal fractal = *entry.fractal;
    edit(fractal);
    entry.fractal = std::make_shared<const Fractal>(std::move(fractal));
}

void nothing(FractalFile& /*file*/) {}
void everyNumber(FractalFile& file) {
    for (Entry& entry : file.entries)
        change(entry, [](Fractal& fractal) {
            if (auto* system = document::system2(fractal))
                for (auto& map : system->maps)
                    map.map.translation[0] += 0.25;
        });
}
void everyName(FractalFile& file) {
    for (Entry& entry : file.entries)
        change(entry, [](Fractal& fractal) { fractal.name.prepend(u'x'); });
}
void everyComment(FractalFile& file) {
    for (Entry& entry : file.entries)
        change(entry, [](Fractal& fractal) {
            fractal.headerComment = QStringLiteral("new");
            fractal.comments.replaceInStrings(QStringLiteral("ü"), QStringLiteral("ö"));
            fractal.comments.append(QStringLiteral("last"));
        });
}
void rowsBackwards(FractalFile& file) {
    for (Entry& entry : file.entries)
        change(entry, [](Fractal& fractal) {
            if (auto* system = document::system2(fractal)) std::ranges::reverse(system->maps);
        });
}
void everySecondRow(FractalFile& file) {
    for (Entry& entry : file.entries)
        change(entry, [](Fractal& fractal) {
            if (auto* system = document::system2(fractal))
                std::erase_if(system->maps, [](const auto& map) { return std::uint32_t(map.id) % 2 == 0; });
        });
}
void everySecondEntry(FractalFile& file) {
    file.entries.removeIf([](const Entry& entry) { return std::uint32_t(entry.id) % 2 == 0; });
}
void entriesBackwards(FractalFile& file) {
    std::ranges::reverse(file.entries);
}
void everyEntryTwice(FractalFile& file) {
    QList<Entry> twice;
    for (const Entry& entry : std::as_const(file.entries))
        twice << entry << Entry{entry.id, entry.fractal, nullptr, {}};
    file.entries = twice;
}

// Of this thread alone, in seconds: what else the machine does hardly matters, nor what was freed before,
// which the next large allocation would put together again.
double effort(const std::function<void()>& task) {
    const auto now = [] {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    ::malloc_trim(0);
    const double began = now();
    task();
    return now() - began;
}

constexpr double linear = 1.5; // nearer to it than to quadratic

// The exponent of the growth from a few to 32 times as many: 1 where the time is linear, more on a machine
// whose memory is slower than its caches, and 2 where the time is quadratic.
double growth(const std::function<double(int)>& effortFor) {
    constexpr int attempts = 12; // for the least of either, whatever else the machine does
    const int few = support::isThorough() ? 2'000 : 800, factor = 32;
    double least = std::numeric_limits<double>::infinity(), most = least, exponent = least;
    for (int i = 0; i < attempts && !(exponent < linear); ++i) {
        least = std::min(least, effortFor(few));
        most = std::min(most, effortFor(factor * few));
        exponent = std::log(most / least) / std::log(double(factor));
    }
    return exponent;
}

} // namespace

// However the entries of a file are laid out, 32 times as many take about 32 times as long.
class FractintLinearTest : public QObject {
    Q_OBJECT

private slots:
    void reading_data() { layouts(); }
    void reading();
    void writing_data();
    void writing();
    void writingForOthers_data() { layouts(); }
    void writingForOthers();
    void choosingForOthers();

private:
    static void layouts();
};

void FractintLinearTest::layouts() {
    QTest::addColumn<TextLayout>("layout");
    QTest::newRow("one line") << &shareOneLine;
    QTest::newRow("one line without an end") << &shareOneOpenLine;
    QTest::newRow("two on each line") << &standInPairs;
    QTest::newRow("one on each line") << &haveALineEach;
    QTest::newRow("never closed") << &areLeftOpen;
    QTest::newRow("other blocks") << &areOtherBlocks;
    QTest::newRow("free text") << &areNoEntries;
    QTest::newRow("rows on one line") << &areRowsOnOneLine;
    QTest::newRow("rows") << &areRows;
    QTest::newRow("comments") << &areComments;
}

void FractintLinearTest::reading() {
    QFETCH(TextLayout, layout);
    const double exponent = growth([layout](int count) {
        const QByteArray bytes = layout(count);
        return effort([&] { io::readFractint(bytes); });
    });
    QVERIFY2(exponent < linear, qPrintable(QString::number(exponent)));
}

void FractintLinearTest::writing_data() {
    QTest::addColumn<TextLayout>("layout");
    QTest::addColumn<FileChange>("change");
    const std::pair<const char*, TextLayout> layouts[] = {
        {"one line", &shareOneLine}, {"one open line", &shareOneOpenLine},    {"pairs", &standInPairs},
        {"lines", &haveALineEach},   {"rows on one line", &areRowsOnOneLine}, {"rows", &areRows},
        {"comments", &areComments}};
    const std::pair<const char*, FileChange> changes[] = {{"as it was", &nothing},
                                                          {"numbers", &everyNumber},
                                                          {"names", &everyName},
                                                          {"comments", &everyComment},
                                                          {"rows backwards", &rowsBackwards},
                                                          {"every second row gone", &everySecondRow},
                                                          {"every second entry gone", &everySecondEntry},
                                                          {"entries backwards", &entriesBackwards},
                                                          {"duplicates", &everyEntryTwice}};
    // Every fourth pair, so that each change meets some layouts; or all.
    int number = 0;
    for (const auto& [layoutName, layout] : layouts)
        for (const auto& [changeName, change] : changes)
            if (support::isThorough() || number++ % 4 == 0)
                QTest::addRow("%s: %s", layoutName, changeName) << layout << change;
}

void FractintLinearTest::writing() {
    QFETCH(TextLayout, layout);
    QFETCH(FileChange, change);
    const double exponent = growth([layout, change](int count) {
        FractalFile file = io::readFractint(layout(count));
        change(file);
        return effort([&] { io::writeFractint(file); });
    });
    QVERIFY2(exponent < linear, qPrintable(QString::number(exponent)));
}

void FractintLinearTest::writingForOthers() {
    QFETCH(TextLayout, layout);
    const double exponent = growth([layout](int count) {
        const FractalFile file = io::readFractint(layout(count));
        return effort([&] { io::writeStrict(file); });
    });
    QVERIFY2(exponent < linear, qPrintable(QString::number(exponent)));
}

// Looking for each of the entries among those that are wanted is not to be more work than writing it.
void FractintLinearTest::choosingForOthers() {
    const double exponent = growth([](int count) {
        const FractalFile file = io::readFractint(entries(count, "\n", "\n"));
        QList<document::EntryId> wanted;
        for (int i = 0; i < count; ++i)
            wanted << document::EntryId(2 * count - i); // none is in the file: nothing else is measured
        return effort([&] { io::writeStrict(file, wanted); });
    });
    QVERIFY2(exponent < linear, qPrintable(QString::number(exponent)));
}

BARYCAGE_TEST(FractintLinearTest, QCoreApplication);
#include "fractint_linear_test.moc"
