// SPDX-License-Identifier: MIT
#include "reading.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QPointer>
#include <QProgressDialog>
#include <QThread>
#include <QTimer>

#include <chrono>
#include <future>
#include <memory>

using namespace std::chrono_literals;

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Reading)
};

constexpr auto moment = 100ms; // nobody needs to be told of less

Reading readNow(const QString& path) {
    Reading reading{io::loadFile(path), {}};
    if (!reading.loaded.failure) reading.collection = io::readCollection(reading.loaded.bytes, path);
    return reading;
}

} // namespace

Reading readFile(const QString& path, QWidget* window) {
    std::packaged_task<Reading()> task([path] { return readNow(path); });
    std::future<Reading> result = task.get_future();
    // Goes on unheard when nobody waits for it any more, but not beyond the end of the program.
    QThread* thread = QThread::create([own = std::move(task)]() mutable { own(); });
    QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
    QObject::connect(
        qApp, &QCoreApplication::aboutToQuit, thread, [thread] { thread->wait(); }, Qt::DirectConnection);
    thread->start();
    if (result.wait_for(moment) == std::future_status::ready) return result.get();

    const auto name = QFileInfo(path).fileName();
    const QPointer progress =
        new QProgressDialog(Text::tr("Reading “%1”…").arg(name), Text::tr("Cancel"), 0, 0, window);
    progress->setWindowModality(Qt::WindowModal);
    progress->show();
    QEventLoop loop;
    QTimer looking;
    bool isCancelled = false;
    QObject::connect(&looking, &QTimer::timeout, &loop, [&] {
        if (result.wait_for(0s) == std::future_status::ready) loop.quit();
    });
    const auto cancel = [&] {
        isCancelled = true;
        loop.quit();
    };
    QObject::connect(progress, &QProgressDialog::canceled, &loop, cancel);
    QObject::connect(progress, &QObject::destroyed, &loop, cancel);
    looking.start(10);
    loop.exec();
    if (progress) {
        progress->disconnect(&loop);
        delete progress.data();
    }
    if (!isCancelled) return result.get();
    return {{{}, Text::tr("Reading “%1” was cancelled.").arg(name)}, {}};
}
