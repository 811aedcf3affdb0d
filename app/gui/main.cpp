// SPDX-License-Identifier: MIT
#include "application.h"
#include "document/background/background_threads.h"
#include "first_picture.h"
#include "identity.h"
#include "session/session.h"
#include "shortage.h"
#include "sudden_end.h"

#include <QCommandLineParser>
#include <QEvent>
#include <QProcess>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>

namespace {

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        Application::tr("Grab a fractal by its corners: an editor for iterated function systems."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOption(
        {QStringLiteral("new"), Application::tr("start with the maple instead of the last session")});
    parser.addOption({QStringLiteral("collection"), Application::tr("open a window with the collection")});
    parser.addOption(
        {QStringLiteral("random"), Application::tr("open a window with random fractals to choose from")});
    parser.addOption({QStringLiteral("picture"),
                      Application::tr("draw the maple to a PNG file instead; needs no display"),
                      QStringLiteral("file")});
    parser.addPositionalArgument(QStringLiteral("files"),
                                 Application::tr(".ifs files to open, each in its own window"),
                                 QStringLiteral("[files…]"));
}

Application::Start startAskedFor(const QCommandLineParser& parser) {
    using enum Application::Start;
    if (parser.isSet(QStringLiteral("random"))) return Random;
    if (parser.isSet(QStringLiteral("collection"))) return Collection;
    return parser.isSet(QStringLiteral("new")) ? New : AsLastTime;
}

int run(Application& application, const QCommandLineParser& parser) try {
    shortage::startThreads();
    const SuddenEnd suddenEnd;
    const bool isOpen = application.openWindows(parser.positionalArguments(), startAskedFor(parser));
    shortage::everythingHasStarted();
    if (isOpen) return Application::exec();
    Application::sendPostedEvents(nullptr, QEvent::DeferredDelete); // same as at the end of exec()
    return EXIT_SUCCESS;
} catch (const std::system_error& error) {
    if (!shortage::isOfThread(error)) throw;
    shortage::endAtStart();
}

bool isAnsweredWithoutWindow(std::string_view argument) {
    return argument == "--version" || argument == "-v" || argument == "--help" || argument == "-h" ||
           argument.starts_with("--picture");
}

} // namespace

int main(int argc, char** argv) {
    QCommandLineParser parser;
    if (std::any_of(argv + 1, argv + argc, isAnsweredWithoutWindow)) { // needs no display
        const QCoreApplication application(argc, argv);
        QCoreApplication::setApplicationName(resources::applicationName());
        QCoreApplication::setApplicationVersion(resources::version());
        describe(parser);
        parser.process(application); // returns only for options that draw
        const io::Failure failure = drawFirstPicture(parser.value(QStringLiteral("picture")));
        if (failure) std::fprintf(stderr, "barycage: %s\n", qPrintable(*failure));
        return failure ? EXIT_FAILURE : EXIT_SUCCESS;
    }
    int code = 0;
    QString program;
    std::optional<QStringList> filesToReopen;
    {
        shortage::watchThreads();
        Application application(argc, argv);
        describe(parser);
        parser.process(application);
        code = run(application, parser);
        program = Application::applicationFilePath();
        filesToReopen = session::filesToReopen();
    }
    if (filesToReopen) QProcess::startDetached(program, *filesToReopen); // after the settings are stored
    // Ends the process: a thread that waits for a drive that does not answer cannot be stopped.
    if (!document::backgroundFinishes(std::chrono::milliseconds(0))) document::quickExit(code);
    return code;
}
