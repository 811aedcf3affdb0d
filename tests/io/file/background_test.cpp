// SPDX-License-Identifier: MIT
#include "io/file/background.h"

#include "document/background/background_threads.h"
#include "document/background/work_in_order.h"
#include "document/disk/regular_file.h"
#include "io/file/save_file.h"
#include "support/named_test.h"

#include <QFile>
#include <QImage>
#include <QSemaphore>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <sys/stat.h>

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

using namespace std::chrono_literals;
using document::Lane;

// More work than there are cores hangs, as readers of a drive that does not answer do.
class BackgroundTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_gate = std::make_shared<QSemaphore>();
        m_begun = std::make_shared<QSemaphore>();
    }
    void cleanup() {
        m_gate->release(m_hanging);
        m_hanging = 0;
        QVERIFY(document::backgroundFinishes(60s));
    }

    // Qt shares the work on it among the threads of its global pool, and waits for them.
    void largePicturesArePainted() {
        hang(Lane::Reading);
        hang(Lane::Computing);
        const auto painted = std::make_shared<QSemaphore>();
        std::thread painter([painted] {
            QImage large(3000, 3000, QImage::Format_ARGB32);
            large.fill(Qt::red);
            const QImage scaled = large.scaled(2000, 2000, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
            if (scaled.convertToFormat(QImage::Format_RGBA64).pixelColor(9, 9) == Qt::red) painted->release();
        });
        const bool isPainted = painted->tryAcquire(1, 60'000);
        m_gate->release(isPainted ? 0 : m_hanging); // else the painter never ends
        painter.join();
        QVERIFY(isPainted);
    }
    void othersGoOn_data() {
        QTest::addColumn<Lane>("lane");
        for (const Lane lane : {Lane::Computing, Lane::Asking, Lane::Reading, Lane::Saving, Lane::Exporting})
            QTest::addRow("%d", int(lane)) << lane;
    }
    void othersGoOn() {
        QFETCH(const Lane, lane);
        hang(Lane::Reading);
        hang(Lane::Computing);
        const auto done = std::make_shared<QSemaphore>();
        document::startInLane(lane, [done] { done->release(); });
        QVERIFY(done->tryAcquire(1, 60'000));
    }
    void allThatReadsMayHangAndFilesAreSaved() {
        for (int i = 0; i < document::threadsOfLane + 8; ++i)
            startHanging(Lane::Reading);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.ifs"));
        QFuture<bool> saving = io::inBackground<bool>(Lane::Saving, [path](QPromise<bool>& promise) {
            promise.addResult(!io::saveFile(path, "leaf"));
        });
        QTRY_VERIFY_WITH_TIMEOUT(saving.isFinished(), 60'000);
        QVERIFY(saving.result());
        QCOMPARE(io::loadFile(path).bytes, QByteArray("leaf"));
    }
    void piecesAreDoneInTheirOrder() {
        const auto order = std::make_shared<std::vector<int>>(); // unguarded: never two at once
        document::WorkInOrder work(Lane::Saving);
        for (int i = 0; i < 1000; ++i)
            work.start([order, i] { order->push_back(i); });
        QVERIFY(work.finishes(60s));
        QCOMPARE(order->size(), std::size_t(1000));
        QVERIFY(std::ranges::is_sorted(*order));
        work.start([order] { order->clear(); });
        QVERIFY(work.finishes(60s));
        QVERIFY(order->empty());
    }
    // They go on when the drive answers after all.
    void piecesThatHangHoldNobodyUp() {
        const auto done = std::make_shared<QSemaphore>();
        {
            document::WorkInOrder work(Lane::Saving);
            ++m_hanging;
            work.start([gate = m_gate] { gate->acquire(); });
            work.start([done] { done->release(); });
            QVERIFY(!work.finishes(1ms));
        }
        QVERIFY(!document::laneFinishes(Lane::Saving, 1ms));
        QVERIFY(!done->tryAcquire());
        m_gate->release(std::exchange(m_hanging, 0));
        QVERIFY(done->tryAcquire(1, 60'000));
        QVERIFY(document::laneFinishes(Lane::Saving, 60s));
    }
    void whatHangsIsNotDone() {
        hang(Lane::Reading);
        QVERIFY(!document::backgroundFinishes(1ms));
    }
    // Nobody writes into it, and opening it would wait for that.
    void pipesAreNoFiles() {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath(QStringLiteral("pipe.ifs"));
        QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QFile file;
        QVERIFY(document::openRegular(file, QFile::encodeName(pipe)).isSpecial());
        QVERIFY(!file.isOpen());
        QFuture<QString> reading = io::inBackground<QString>(Lane::Reading, [pipe](QPromise<QString>& said) {
            said.addResult(io::loadFile(pipe).failure.value_or(QString()));
        });
        QTRY_VERIFY_WITH_TIMEOUT(reading.isFinished(), 30'000);
        QVERIFY(reading.result().contains(QStringLiteral("not a regular file")));
        QVERIFY(io::loadFile(QStringLiteral("/dev/zero")).failure);
        QVERIFY(document::openRegular(file, QFile::encodeName(folder.path())).error.size() > 0);
    }

private:
    void startHanging(Lane lane) {
        ++m_hanging;
        document::startInLane(lane, [gate = m_gate, begun = m_begun] {
            begun->release();
            gate->acquire();
        });
    }
    void hang(Lane lane) {
        const int count = 2 * QThread::idealThreadCount();
        for (int i = 0; i < count; ++i)
            startHanging(lane);
        QVERIFY(m_begun->tryAcquire(count, 60'000));
    }

    std::shared_ptr<QSemaphore> m_gate;
    std::shared_ptr<QSemaphore> m_begun;
    int m_hanging = 0;
};

BARYCAGE_TEST(BackgroundTest, QCoreApplication);
#include "background_test.moc"
