// SPDX-License-Identifier: MIT
#include "application.h"

#include "identity.h"
#include "io/fractint_reader.h"
#include "main_window.h"
#include "recovery.h"

#include <QIcon>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    setApplicationName(resources::applicationName());
    setOrganizationName(resources::applicationName());
    setApplicationDisplayName(resources::applicationName());
    setApplicationVersion(resources::version());
    setDesktopFileName(resources::applicationId());
    setWindowIcon(QIcon(QStringLiteral(":/icons/barycage.svg")));

    const QString folder = QStringLiteral(":/translations");
    auto* own = new QTranslator(this);
    if (!own->load(QLocale(), QStringLiteral("barycage"), QStringLiteral("_"), folder) &&
        !own->load(QStringLiteral("barycage_en"), folder))
        return;
    installTranslator(own);
    // The buttons of the toolkit speak the language of the rest.
    auto* toolkit = new QTranslator(this);
    if (toolkit->load(QLocale(own->language()), QStringLiteral("qtbase"), QStringLiteral("_"),
                      QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        installTranslator(toolkit);
}

void Application::openWindows(const QStringList& files) {
    for (const document::Abandoned& abandoned : Recovery::ask()) {
        auto* window = new MainWindow;
        window->show();
        window->openRecovered(abandoned);
    }
    for (const QString& file : files) {
        auto* window = new MainWindow;
        window->show();
        window->openPath(file);
    }
    if (topLevelWidgets().isEmpty()) {
        auto* window = new MainWindow;
        window->openFirstPicture();
        window->show();
    }
}
