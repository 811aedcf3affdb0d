// SPDX-License-Identifier: MIT
#include "application.h"

#include "desktop/preferences.h"
#include "desktop/settings.h"
#include "desktop/theme.h"
#include "files/exports.h"
#include "files/open_each.h"
#include "files/recovery.h"
#include "identity.h"
#include "io/exchange/entry_link.h"
#include "io/fractint/fractint_reader.h"
#include "main_window.h"
#include "portal/desktop_motion.h"
#include "session/session.h"
#include "shortage.h"
#include "welcome.h"
#include "widgets/layout/fit_screen.h"
#include "widgets/tooltips.h"
#include "widgets/wheel_needs_focus.h"

#include <QDialog>
#include <QDropEvent>
#include <QEvent>
#include <QFile>
#include <QFontMetrics>
#include <QIcon>
#include <QKeyEvent>
#include <QLabel>
#include <QLibraryInfo>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QScopeGuard>
#include <QTextEdit>
#include <QTimer>
#include <QTranslator>
#include <QUrl>

#include <algorithm>
#include <chrono>
#include <new>
#include <system_error>

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    setApplicationName(resources::applicationName());
    setOrganizationName(resources::applicationName());
    setApplicationDisplayName(resources::applicationName());
    setApplicationVersion(resources::version());
    setDesktopFileName(resources::applicationId());
    setWindowIcon(QIcon(QStringLiteral(":/icons/barycage.svg")));

    new view::Tooltips(this);
    new view::WheelNeedsFocus(this);
    new view::FitScreen(this);
    const view::Preferences preferences = view::Preferences::stored();
    view::applyTheme(preferences.theme);
    view::Preferences::setSpokenLanguage(preferences.language);
    speak(preferences.language);
    new DesktopMotion(this);
}

Application::~Application() {
    view::finishStoring(std::chrono::seconds(2)); // later writes go on for a while
}

void Application::speak(const QString& language) {
    const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
    // Sets numbers in all languages to the format of the files, with a decimal point.
    QLocale::setDefault(QLocale::c());
    const QString folder = QStringLiteral(":/translations");
    auto* own = new QTranslator(this);
    if (!own->load(locale, QStringLiteral("barycage"), QStringLiteral("_"), folder) &&
        !own->load(QStringLiteral("barycage_en"), folder))
        return;
    installTranslator(own);
    // Translates the buttons of the toolkit.
    auto* toolkit = new QTranslator(this);
    const QLocale spoken(own->language());
    if (toolkit->load(spoken, QStringLiteral("qtbase"), QStringLiteral("_"),
                      QLibraryInfo::path(QLibraryInfo::TranslationsPath)) ||
        toolkit->load(spoken, QStringLiteral("qtbase"), QStringLiteral("_"), folder))
        installTranslator(toolkit);
}

namespace {

// The text of a label may come from a file: it is plain text unless the label's maker set another format.
// Tool tips are escaped by view::tooltipText().
void makePlain(QLabel& label) {
    if (label.textFormat() == Qt::AutoText && !label.inherits("QTipLabel"))
        label.setTextFormat(Qt::PlainText);
}

// Returns true for keys of a command that a field would take: in X11, Ctrl+E goes to its end, as the End key
// does.
bool isForCommand(const QKeyEvent& event) {
    return event.modifiers() == Qt::ControlModifier && event.key() == Qt::Key_E;
}

// A message box takes a letter without Alt for the button that has it, and a question may appear while
// somebody types.
bool isBesideText(const QObject* receiver) {
    const auto* widget = qobject_cast<const QWidget*>(receiver);
    return widget && qobject_cast<const QMessageBox*>(widget->window()) &&
           !qobject_cast<const QTextEdit*>(widget);
}
bool isTyped(const QKeyEvent& event) {
    const auto command = Qt::AltModifier | Qt::ControlModifier | Qt::MetaModifier;
    const bool isLetter =
        !event.text().isEmpty() && event.text().front().isPrint() && !event.text().front().isSpace();
    return isLetter && !(event.modifiers() & command);
}

// Whoever takes a file that another program offers only reads it, fields for text included: for a move, that
// program would delete it.
void leaveFilesWhereTheyAre(QDropEvent& event) {
    const bool isFile = event.source() == nullptr && event.mimeData()->hasUrls();
    if (isFile && event.isAccepted() && event.dropAction() == Qt::MoveAction)
        event.setDropAction(Qt::CopyAction);
}

void makeRoomForTitle(QDialog& dialog) {
    if (!dialog.isWindow()) return;
    QFont font = QApplication::font("QMdiSubWindowTitleBar");
    font.setBold(true); // as most desktops show it, with the name of the program behind it
    const QFontMetrics letters(font);
    const QString shown =
        dialog.windowTitle() + QStringLiteral(" — ") + QGuiApplication::applicationDisplayName();
    const int buttons = 8 * letters.height(), longest = 60 * letters.averageCharWidth();
    const int title = std::min(letters.horizontalAdvance(shown), longest);
    dialog.setMinimumWidth(std::max(dialog.minimumWidth(), title + buttons));
}

struct LinksAndFiles {
    QList<QByteArray> links;
    QStringList files;
};

// Desktops pass the addresses of files and links alike. A file of that name goes before both.
LinksAndFiles linksAndFiles(const QStringList& arguments) {
    LinksAndFiles found;
    for (const QString& argument : arguments) {
        const QByteArray link = argument.toUtf8();
        const bool isAddress = argument.startsWith(u"file:/"), isLink = io::looksLikeLink(link);
        if ((!isAddress && !isLink) || QFile::exists(argument))
            found.files << argument;
        else if (isLink)
            found.links << link;
        else
            found.files << QUrl(argument).toLocalFile();
    }
    return found;
}

} // namespace

// Whatever the event began is left undone: a window is not opened, but those there are go on.
bool Application::notify(QObject* receiver, QEvent* event) try {
    if (event->type() == QEvent::ShortcutOverride && isForCommand(*static_cast<QKeyEvent*>(event))) {
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::KeyPress && isBesideText(receiver) &&
        isTyped(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::Polish) {
        if (auto* label = qobject_cast<QLabel*>(receiver)) makePlain(*label);
        if (auto* dialog = qobject_cast<QDialog*>(receiver)) makeRoomForTitle(*dialog);
    }
    const bool done = QApplication::notify(receiver, event);
    if (const QEvent::Type type = event->type();
        type == QEvent::DragEnter || type == QEvent::DragMove || type == QEvent::Drop)
        leaveFilesWhereTheyAre(*static_cast<QDropEvent*>(event));
    return done;
} catch (const std::system_error& error) {
    if (!shortage::isOfThread(error)) throw;
    shortage::sayNoThread();
    return true;
} catch (const std::bad_alloc&) {
    shortage::sayNoMemory();
    return true;
}

bool Application::event(QEvent* event) {
    const bool done = QApplication::event(event);
    if (event->type() == QEvent::ApplicationPaletteChange) view::completePalette();
    return done;
}

bool Application::openWindows(const QStringList& arguments, Start start) {
    constexpr auto soon = std::chrono::seconds(1);
    const auto resume = [] { exports::queue()->resume(); }; // shown in windows that report the queue
    const auto inTheEnd = qScopeGuard(resume);
    QList<WantedFile> wantedFiles;
    for (const document::Abandoned& abandoned : Recovery::ask())
        wantedFiles << WantedFile{abandoned.snapshot.path, abandoned};
    if (const QList<QVariantMap> places = session::takeRestartPlaces(); !places.isEmpty()) {
        MainWindow::openEach(wantedFiles);
        for (const QVariantMap& place : places) {
            auto* window = new MainWindow;
            window->show();
            window->returnTo(place);
        }
        return !session::allAreClosed();
    }
    const auto [links, files] = linksAndFiles(arguments);
    const bool again =
        arguments.isEmpty() && start == Start::AsLastTime && view::Preferences::stored().reopen;
    wantedFiles += wanted(again ? session::files() : askWhichToOpen(files, nullptr));
    QTimer::singleShot(soon, exports::queue(), resume); // also runs if a file does not answer
    MainWindow::openEach(wantedFiles);
    for (const QByteArray& link : links) {
        auto* window = new MainWindow;
        window->show();
        window->openLink(link);
    }
    if (start == Start::AsLastTime && !session::windows().isEmpty()) return !session::allAreClosed();
    auto* window = new MainWindow;
    window->openFirstPicture();
    window->show();
    if (start == Start::Collection)
        window->showCollection();
    else if (start == Start::Random)
        window->addRandom();
    else if (!window->beginFirstMinute())
        Welcome::offer(window);
    return true;
}
