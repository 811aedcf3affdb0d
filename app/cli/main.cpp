// SPDX-License-Identifier: MIT
#include "process/short_memory.h"
#include "run.h"

#include <QGuiApplication>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace {

// Keeps the lines of libraries off standard error: whatever fails is reported by the program.
void silenceLibraries() {
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        // Qt goes on, and waits without end for the work of the thread that the system did not start.
        if (text.startsWith(u"QThread::start: Thread creation error")) std::_Exit(cli::memoryIsShort());
        if (type != QtFatalMsg) return;
        std::fprintf(stderr, "barycage-cli: error: %s\n", qPrintable(text));
    });
}

} // namespace

int main(int argc, char** argv) try {
    qputenv("QT_NO_GLIB", "1"); // whose loop of events is never used
    silenceLibraries();
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is an error of writing, not the end
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    std::unique_ptr<QCoreApplication> application;
    if (cli::paintsLetters(words)) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application = std::make_unique<QGuiApplication>(argc, argv);
    } else {
        application = std::make_unique<QCoreApplication>(argc, argv);
    }
    return int(cli::run(words));
} catch (const std::bad_alloc&) { // before anything could be read
    return cli::memoryIsShort();
}
