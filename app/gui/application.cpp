// SPDX-License-Identifier: MIT
#include "application.h"

#include "identity.h"
#include "io/fractint_reader.h"
#include "main_window.h"
#include "recovery.h"

#include <QEvent>
#include <QIcon>
#include <QLibraryInfo>
#include <QLocale>
#include <QPalette>
#include <QTranslator>

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    setApplicationName(resources::applicationName());
    setOrganizationName(resources::applicationName());
    setApplicationDisplayName(resources::applicationName());
    setApplicationVersion(resources::version());
    setDesktopFileName(resources::applicationId());
    setWindowIcon(QIcon(QStringLiteral(":/icons/barycage.svg")));

    completePalette();

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

bool Application::event(QEvent* event) {
    const bool done = QApplication::event(event);
    if (event->type() == QEvent::ApplicationPaletteChange) completePalette();
    return done;
}

// Quiet text is the text colour of the desktop, fainter: some desktops leave this role black on black.
void Application::completePalette() {
    QColor quiet = palette().color(QPalette::Active, QPalette::Text);
    quiet.setAlpha(150);
    if (palette().color(QPalette::Active, QPalette::PlaceholderText) == quiet) return;
    QPalette completed;
    completed.setColor(QPalette::PlaceholderText, quiet);
    setPalette(completed);
}

void Application::openWindows(const QStringList& files) {
    for (const document::Abandoned& abandoned : Recovery::ask()) {
        auto* window = new MainWindow;
        window->show();
        window->openRecovered(abandoned);
    }
    MainWindow::openEach(files);
    if (topLevelWidgets().isEmpty()) {
        auto* window = new MainWindow;
        window->openFirstPicture();
        window->show();
    }
}
