// SPDX-License-Identifier: MIT
#include "animation/keys/ease.h"
#include "animation/keys/moment.h"
#include "support/named_test.h"

#include <QtTest>

#include <random>

using namespace animation;

class EaseTest : public QObject {
    Q_OBJECT

private slots:
    void endsAreExact() {
        for (const auto kind : {Ease::Kind::Hold, Ease::Kind::Linear, Ease::Kind::In, Ease::Kind::Out,
                                Ease::Kind::Both, Ease::Kind::Cubic}) {
            const Ease ease{kind, 0.4, 0, 0.6, 1};
            QCOMPARE(eased(ease, 0), 0.0);
            QCOMPARE(eased(ease, 1), 1.0);
            QCOMPARE(eased(ease, -1), 0.0);
            QCOMPARE(eased(ease, 2), 1.0);
        }
        QCOMPARE(eased({Ease::Kind::Hold}, 0.999), 0.0);
        QCOMPARE(eased({Ease::Kind::In}, 0.5), 0.25);
        QCOMPARE(eased({Ease::Kind::Out}, 0.5), 0.75);
        QCOMPARE(eased({Ease::Kind::Both}, 0.5), 0.5);
        QVERIFY(std::abs(eased({Ease::Kind::Cubic, 0.4, 0, 0.6, 1}, 0.5) - 0.5) < 1e-15);
    }

    // |e(u + δ) − e(u)| ≤ Kδ, rising from 0 to 1 without overshooting, on 10⁵ random curves.
    void slopesAreLimited() {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> share(0, 1), beyond(-1, 2);
        int steep = 0;
        for (int n = 0; n < 100'000; ++n) {
            auto& range = n % 4 == 0 ? beyond : share;
            double handles[4];
            for (double& handle : handles) {
                handle = range(random);
                if (n % 7 == 0) handle = handle < 0.5 ? 0 : 1; // the corners
            }
            const Ease ease = cubicEase(handles[0], handles[1], handles[2], handles[3]);
            QVERIFY(isValid(ease));
            const Ease wanted{Ease::Kind::Cubic, handles[0], handles[1], handles[2], handles[3]};
            if (isValid(wanted))
                QCOMPARE(ease, wanted);
            else
                ++steep;
            for (int k = 0; k < 4; ++k) {
                const double u = share(random), delta = share(random) * (k == 0 ? 1e-6 : 1);
                const double before = eased(ease, u), after = eased(ease, u + delta);
                QVERIFY(before >= 0 && after <= 1);
                QVERIFY2(std::abs(after - before) <= maxSlope * delta + 1e-13,
                         qPrintable(QString::number(std::abs(after - before) / delta)));
            }
        }
        QVERIFY(steep > 1000);                              // the limit has been met
        QVERIFY(!isValid({Ease::Kind::Cubic, 1, 0, 0, 1})); // upright in the middle
        QVERIFY(!isValid({Ease::Kind::Cubic, -0.1, 0, 0.5, 1}));
        QVERIFY(!isValid({Ease::Kind::Cubic, 0.1, NAN, 0.5, 1}));
    }

    void momentsAreFractions() {
        QCOMPARE(*parseMoment("12"), moment(12));
        QCOMPARE(*parseMoment("12.25"), moment(49, 4));
        QCOMPARE(*parseMoment("49/4"), moment(49, 4));
        QCOMPARE(*parseMoment("0.10"), moment(1, 10));
        for (const char* wrong : {"", "-1", "1/0", "1/", "/2", "1.", ".5x", "1e3", "nan", " 1", "1 ", "+1",
                                  "1.5/2", "99999999999", "2000001", "0.1234567891"})
            QVERIFY2(!parseMoment(wrong), wrong);
        QCOMPARE(moment(6, 4), (Moment{3, 2}));
        QCOMPARE(moment(1, -2), (Moment{-1, 2}));
    }

    void loopsFoldTime() {
        QCOMPARE(folded(moment(60), Loop::Off, 48), moment(48));
        QCOMPARE(folded(moment(48), Loop::Cycle, 48), moment(0));
        QCOMPARE(folded(moment(97, 2), Loop::Cycle, 48), moment(1, 2));
        QCOMPARE(folded(moment(49), Loop::ThereAndBack, 48), moment(47));
        QCOMPARE(folded(moment(96), Loop::ThereAndBack, 48), moment(0));
        QCOMPARE(frameCount(Loop::Off, 48), 49);
        QCOMPARE(frameCount(Loop::Cycle, 48), 48);
        QCOMPARE(frameCount(Loop::ThereAndBack, 48), 96);
        for (int cycles = -7; cycles <= 7; ++cycles)
            QCOMPARE(phase(moment(48), 48, cycles), 0.0);
        QCOMPARE(phase(moment(12), 48, 3), 0.75);
        QCOMPARE(phase(moment(12), 48, -1), 0.75);
        QCOMPARE(phase(moment(1, 2), 1, 3), 0.5);
    }
};

BARYCAGE_TEST(EaseTest);
#include "ease_test.moc"
