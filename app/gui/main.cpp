// SPDX-License-Identifier: MIT
#include "application.h"
#include "identity.h"

#include <QCommandLineParser>

#include <algorithm>
#include <string_view>

namespace {

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        Application::tr("Take a fractal by its corners: an editor for iterated function systems."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"),
                                 Application::tr(".ifs files to open, a window each"),
                                 QStringLiteral("[files…]"));
}

bool isAnsweredWithoutWindow(std::string_view argument) {
    return argument == "--version" || argument == "-v" || argument == "--help" || argument == "-h";
}

} // namespace

int main(int argc, char** argv) {
    QCommandLineParser parser;
    if (std::any_of(argv + 1, argv + argc, isAnsweredWithoutWindow)) { // and without a display
        const QCoreApplication application(argc, argv);
        QCoreApplication::setApplicationName(resources::applicationName());
        QCoreApplication::setApplicationVersion(resources::version());
        describe(parser);
        parser.process(application); // does not return
    }
    Application application(argc, argv);
    describe(parser);
    parser.process(application);
    application.openWindows(parser.positionalArguments());
    return Application::exec();
}
