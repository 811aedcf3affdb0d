// SPDX-License-Identifier: MIT
#include "animation/frame_rate.h"
#include "support/named_test.h"

#include <QtTest>

using animation::FrameRate;

class FrameRateTest : public QObject {
    Q_OBJECT

private slots:
    void textsAreRates_data();
    void textsAreRates();
    void othersAreRefused_data();
    void othersAreRefused();
    void everyRateIsReadBack();
};

void FrameRateTest::textsAreRates_data() {
    QTest::addColumn<std::string>("text");
    QTest::addColumn<int>("frames");
    QTest::addColumn<int>("seconds");
    QTest::addColumn<std::string>("shown");
    const auto row = [](const char* text, int frames, int seconds, const char* shown) {
        QTest::newRow(text) << std::string(text) << frames << seconds << std::string(shown);
    };
    row("24", 24, 1, "24");
    row("48/2", 24, 1, "24");
    row("25/2", 25, 2, "12.5");
    row("12.5", 25, 2, "12.5");
    row("30000/1001", 30000, 1001, "29.97");
    row("29.97", 30000, 1001, "29.97");
    row("29.970", 30000, 1001, "29.97");
    row("23.976", 24000, 1001, "23.976");
    row("23.98", 24000, 1001, "23.976");
    row("59.94", 60000, 1001, "59.94");
    row("119.88", 120000, 1001, "119.88");
    row("2997/100", 2997, 100, "2997/100"); // not what 29.97 stands for
    row("29.96", 749, 25, "29.96");
    row("29.9", 299, 10, "29.9");
    row("10/3", 10, 3, "10/3");
    row("1/4", 1, 4, "0.25");
    row("1000", 1000, 1, "1000");
}

void FrameRateTest::textsAreRates() {
    QFETCH(std::string, text);
    QFETCH(int, frames);
    QFETCH(int, seconds);
    QFETCH(std::string, shown);
    const auto rate = animation::parseRate(text);
    QVERIFY(rate);
    QCOMPARE(*rate, (FrameRate{frames, seconds}));
    QCOMPARE(animation::rateText(*rate), shown);
}

void FrameRateTest::othersAreRefused_data() {
    QTest::addColumn<std::string>("text");
    for (const char* text :
         {"", "0", "-24", "24 fps", "1/0", "0/5", "1001", "1000.5", "24,5", "1e3", "1/2000000"})
        QTest::newRow(text) << std::string(text);
}

void FrameRateTest::othersAreRefused() {
    QFETCH(std::string, text);
    QVERIFY(!animation::parseRate(text));
}

void FrameRateTest::everyRateIsReadBack() {
    for (int seconds = 1; seconds <= 1100; seconds += 7)
        for (int frames = 1; frames <= 60'000; frames += 977) {
            if (frames > animation::maxRate * seconds) continue;
            const animation::Moment reduced = animation::moment(frames, seconds);
            const auto again = animation::parseRate(animation::rateText({frames, seconds}));
            QVERIFY(again);
            QCOMPARE(*again, (FrameRate{int(reduced.numerator), int(reduced.denominator)}));
        }
}

BARYCAGE_TEST(FrameRateTest);
#include "frame_rate_test.moc"
