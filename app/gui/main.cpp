// SPDX-License-Identifier: MIT
#include "application.h"

#include <QCommandLineParser>

int main(int argc, char** argv) {
    Application application(argc, argv);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        Application::tr("Take a fractal by its corners: an editor for iterated function systems."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"),
                                 Application::tr(".ifs files to open, a window each"),
                                 QStringLiteral("[files…]"));
    parser.process(application);

    application.openWindows(parser.positionalArguments());
    return Application::exec();
}
