// SPDX-License-Identifier: MIT
#include "shortage.h"

#include "document/background/background_threads.h"

#include <QApplication>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPointer>
#include <QSemaphore>
#include <QString>
#include <QThreadPool>

#include <atomic>
#include <cstdio>
#include <memory>
#include <new>
#include <system_error>

namespace shortage {

namespace {

std::atomic<bool> hasStarted = false;
QtMessageHandler handlerBefore = nullptr;

QString noThread() {
    return QCoreApplication::translate(
        "Application", "The system does not let Barycage start another thread. Close other programs, or "
                       "raise the limit on processes, and try again.");
}

void print(const QString& sentence) {
    std::fprintf(stderr, "barycage: error: %s\n", qPrintable(sentence));
}

[[noreturn]] void endUnopened() {
    print(noThread());
    document::quickExit(exitStatus);
}

// Shows one box at a time, however many threads are missing.
void say(const QString& sentence) {
    print(sentence);
    static QPointer<QMessageBox> shown;
    if (shown) return;
    shown = new QMessageBox(QMessageBox::Warning, QGuiApplication::applicationDisplayName(), sentence,
                            QMessageBox::Ok, QApplication::activeWindow());
    shown->setAttribute(Qt::WA_DeleteOnClose);
    shown->open();
}

// The one who starts the thread may hold locks: a box is shown later.
void hear(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (handlerBefore) handlerBefore(type, context, text);
    if (!text.startsWith(u"QThread::start: Thread creation error")) return;
    if (hasStarted && qApp) {
        QMetaObject::invokeMethod(qApp, sayNoThread, Qt::QueuedConnection);
        return;
    }
    endUnopened();
}

} // namespace

void watchThreads() {
    handlerBefore = qInstallMessageHandler(hear);
    try {
        document::startLanes();
    } catch (const std::system_error&) {
        endUnopened();
    }
}

// Qt cuts work on large pictures into pieces for its global pool, and waits for all of them.
void startThreads() {
    QThreadPool& pool = *QThreadPool::globalInstance();
    pool.setExpiryTimeout(-1);
    const int count = pool.maxThreadCount();
    struct Gates {
        QSemaphore begun, open;
    };
    const auto gates = std::make_shared<Gates>();
    for (int i = 0; i < count; ++i)
        pool.start([gates] {
            gates->begun.release();
            gates->open.acquire();
        });
    gates->begun.acquire(count);
    gates->open.release(count);
}

void everythingHasStarted() {
    hasStarted = true;
}

bool isOfThread(const std::system_error& error) {
    return error.code() == std::errc::resource_unavailable_try_again;
}

void sayNoThread() {
    say(noThread());
}

void sayNoMemory() try {
    say(QCoreApplication::translate("Application", "There is not enough memory for this."));
} catch (const std::bad_alloc&) {
    // No memory even for the message.
}

void endAtStart() {
    print(noThread());
    QMessageBox::critical(nullptr, QGuiApplication::applicationDisplayName(), noThread());
    document::quickExit(exitStatus);
}

} // namespace shortage
