// SPDX-License-Identifier: MIT
#include "attractor/threads/job_shares.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <new>

using namespace attractor;

class TestJobShares : public QObject {
    Q_OBJECT

private slots:
    void workersAllWorkOnce() {
        for (const std::size_t size : {1U, 2U, 5U}) {
            Workers workers(size);
            QCOMPARE(workers.size(), size);
            for (int round = 0; round < 100; ++round) {
                std::vector<std::atomic<int>> calls(size);
                workers.run([&](std::size_t thread) { ++calls[thread]; });
                QVERIFY(std::ranges::all_of(calls, [](const auto& n) { return n == 1; }));
            }
        }
    }

    void whatIsThrownReachesTheCaller() {
        Workers workers(3);
        for (const std::size_t thrower : {0U, 1U, 2U}) {
            std::atomic<int> calls = 0;
            const auto work = [&](std::size_t thread) {
                ++calls;
                if (thread == thrower) throw std::bad_alloc();
            };
            QVERIFY_THROWS_EXCEPTION(std::bad_alloc, workers.run(work));
            QCOMPARE(calls.load(), 3);
        }
        int calls = 0;
        workers.run([&](std::size_t thread) { calls += thread == 0; });
        QCOMPARE(calls, 1);
    }

    void everyJobIsDoneOnce() {
        for (const std::size_t size : {1U, 2U, 3U}) {
            Workers workers(size);
            JobShares shares;
            QVERIFY(!shares.left());
            for (const std::size_t jobs : {0U, 1U, 2U, 7U, 100U, 1000U}) {
                std::vector<std::atomic<int>> done(jobs);
                shares.reset(jobs, workers);
                QCOMPARE(shares.left(), jobs > 0);
                std::atomic<bool> isThread = true;
                shares.run(workers, {}, [&](std::size_t job, std::size_t thread) {
                    ++done[job];
                    if (thread >= size) isThread = false;
                });
                QVERIFY(isThread);
                QVERIFY(!shares.left());
                QVERIFY(std::ranges::all_of(done, [](const auto& n) { return n == 1; }));
            }
        }
    }

    // Stopped again and again, after every few jobs, and resumed.
    void aStopLeavesTheRest() {
        Workers workers(3);
        JobShares shares;
        std::vector<std::atomic<int>> done(500);
        shares.reset(done.size(), workers);
        int runs = 0;
        while (shares.left()) {
            std::stop_source stop;
            std::atomic<int> now = 0;
            shares.run(workers, stop.get_token(), [&](std::size_t job, std::size_t) {
                ++done[job];
                if (++now == 10) stop.request_stop();
            });
            QVERIFY(now <= 12); // every thread ends what it has begun
            ++runs;
        }
        QVERIFY(runs >= 40);
        QVERIFY(std::ranges::all_of(done, [](const auto& n) { return n == 1; }));
        shares.reset(10, workers);
        shares.clear();
        QVERIFY(!shares.left());
    }
};

BARYCAGE_TEST(TestJobShares);
#include "job_shares_test.moc"
