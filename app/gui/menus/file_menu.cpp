// SPDX-License-Identifier: MIT
#include "menus/file_menu.h"

#include "dialogs/export/print_fractal.h"
#include "document/edits/cage/cage_edits.h"
#include "files/file_commands.h"
#include "files/open_file.h"
#include "files/recent_files.h"
#include "menus/export_menu.h"
#include "messages/written_banner.h"
#include "session/session.h"
#include "stage/stage.h"
#include "widgets/menus/menu_placeholder.h"
#include "widgets/menus/menu_text.h"
#include "widgets/text/tooltip_text.h"

#include <QFileInfo>

FileMenu::FileMenu(const MenuContext& context, FileCommands* commands, const OpenFile* file,
                   const std::function<void()>& openWindow)
    : ActionMenu(context, tr("&File")), m_commands(commands), m_file(file) {
    addOpening(openWindow);
    addSeparator();
    addSaving();
    addSeparator();
    auto* exports = new ExportMenu(context, commands, file);
    addMenu(exports);
    QAction* print = add(
        {"print", tr("&Print…"), QKeySequence::Print, tr("Print the picture, its name and its coefficients")},
        [this] { printPicture(); });
    disableWhen(print, &document::cageObstacle);
    addSeparator();
    add({"close", tr("C&lose"), QKeySequence::Close, tr("Close this window")},
        [this] { this->context().window->close(); });
    add({"quit", tr("&Quit"), QKeySequence::Quit, tr("Close all windows")}, &session::quit);
    addToolBarGroup({{m_open, tr("Open")}, {m_save, tr("Save")}, {exports->picture(), tr("Export")}});
}

void FileMenu::addOpening(const std::function<void()>& openWindow) {
    add({"new", tr("&New"), QKeySequence::New, tr("Start with a Sierpiński triangle")},
        [this] { m_commands->startNew(); });
    add({"new-window", tr("New &Window"), QKeySequence(tr("Ctrl+Shift+N")), tr("Open another window")},
        openWindow);
    m_open = add({"open", tr("&Open…"), QKeySequence::Open, tr("Open a collection of fractals")},
                 [this] { m_commands->chooseAndOpen(); });
    m_recent = addMenu(tr("Open &Recent"));
    m_recent->setObjectName(QStringLiteral("recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &FileMenu::fillRecent);
}

void FileMenu::addSaving() {
    m_save = add({"save", tr("&Save"), QKeySequence::Save,
                  tr("Save the file; entries that you did not edit stay unchanged, byte for byte")},
                 [this] { m_commands->save(); });
    add({"save-as", tr("Save &As…"), QKeySequence(tr("Ctrl+Shift+S")),
         tr("Save the file under another name")},
        [this] { m_commands->saveAs(); });
    QAction* revert =
        add({"revert", tr("Re&vert"), {}, tr("Discard your changes and reload the file from disk")},
            [this] { m_commands->revert(); });
    revert->setEnabled(false);
    connect(m_file, &OpenFile::pathChanged, revert,
            [this, revert] { revert->setEnabled(!m_file->path().isEmpty()); });
}

void FileMenu::fillRecent() {
    m_recent->clear();
    for (const QString& path : recent_files::list()) {
        QAction* action =
            m_recent->addAction(view::menuText(QFileInfo(path).fileName(), m_recent->fontMetrics()), this,
                                [this, path] { m_commands->openRecent(path); });
        action->setStatusTip(path);
        action->setToolTip(view::tooltipText(path)); // default would be the name of the file
        action->setWhatsThis(action->toolTip());
    }
    if (m_recent->isEmpty()) view::addPlaceholder(*m_recent, tr("No recent files"));
    m_recent->addSeparator();
    m_recent->addAction(tr("Clear List"), this, [] { recent_files::clear(); });
}

void FileMenu::printPicture() {
    const auto say = [context = context()](const QString& sentence, const QString& path) {
        context.messages->say(sentence);
        WrittenBanner::offerPrinted(context.window, *context.document, path);
    };
    if (context().stage->showsSpace())
        view::printFractal(context().document, context().stage->space()->navigation().camera(),
                           context().window, say);
    else
        view::printFractal(context().document, context().canvas->camera(), context().window, say);
}
