// SPDX-License-Identifier: MIT
#include "io/file/replacement_file.h"
#include "options/exit_status.h"
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
        // Qt would continue, and wait for ever for the work of a thread that the system did not start.
        if (text.startsWith(u"QThread::start: Thread creation error")) std::_Exit(cli::memoryIsShort());
        if (type != QtFatalMsg) return;
        // Such as no more open files; Qt would abort.
        std::fprintf(stderr, "barycage-cli: error: %s\n", qPrintable(text));
        io::removeUnfinished();
        std::_Exit(int(cli::ExitStatus::CannotReadOrWrite));
    });
}

} // namespace

int main(int argc, char** argv) try {
    qputenv("QT_NO_GLIB", "1"); // avoids GLib's event loop, which is never used
    silenceLibraries();
    // Turns a limit on file sizes into a write error instead of the end of the program.
    std::signal(SIGXFSZ, SIG_IGN);
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    std::unique_ptr<QCoreApplication> application;
    if (cli::paintsLetters(words)) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application = std::make_unique<QGuiApplication>(argc, argv);
    } else {
        application = std::make_unique<QCoreApplication>(argc, argv);
    }
    return int(cli::run(words));
} catch (const std::bad_alloc&) { // raised before any file was read
    return cli::memoryIsShort();
}
