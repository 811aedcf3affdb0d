// SPDX-License-Identifier: MIT
#include "widgets/background/wait_for.h"
#include "document/text/text.h"

#include <QDeadlineTimer>
#include <QEventLoop>
#include <QFutureWatcher>
#include <QPointer>
#include <QProgressBar>
#include <QProgressDialog>

#include <chrono>
#include <thread>

namespace view {

namespace {

using namespace std::chrono_literals;

constexpr auto moment = 100ms; // shorter waits are not reported

} // namespace

bool waitFor(QFuture<void> work, const QString& label, QWidget* window) {
    for (const QDeadlineTimer soon(moment); !work.isFinished() && !soon.hasExpired();)
        std::this_thread::sleep_for(1ms);
    if (work.isFinished()) return true;

    const QPointer progress = new QProgressDialog(label, Text::tr("Cancel"), 0, 0, window);
    progress->setWindowModality(Qt::WindowModal);
    auto* bar = new QProgressBar(progress); // unlike the dialog's setValue(), handles no events
    bar->setRange(0, 0);
    progress->setBar(bar);
    QEventLoop loop;
    QFutureWatcher<void> watcher;
    bool isCancelled = false;
    const auto cancel = [&] {
        isCancelled = true;
        loop.quit();
    };
    QObject::connect(&watcher, &QFutureWatcherBase::progressRangeChanged, bar, &QProgressBar::setRange);
    QObject::connect(&watcher, &QFutureWatcherBase::progressValueChanged, bar, &QProgressBar::setValue);
    QObject::connect(&watcher, &QFutureWatcherBase::finished, &loop, &QEventLoop::quit);
    if (!work.isCanceled()) // still awaited after the cancellation
        QObject::connect(&watcher, &QFutureWatcherBase::canceled, &loop, cancel);
    QObject::connect(progress, &QProgressDialog::canceled, &loop, cancel);
    QObject::connect(progress, &QObject::destroyed, &loop, cancel);
    watcher.setFuture(work);
    progress->show();
    loop.exec();
    if (progress) {
        progress->disconnect(&loop);
        delete progress.data();
    }
    if (isCancelled) work.cancel();
    return !isCancelled;
}

} // namespace view
