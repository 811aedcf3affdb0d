// SPDX-License-Identifier: MIT
#include "menus/file_menu.h"

#include "animation/paths/camera_path.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/export/copy_picture.h"
#include "dialogs/export/export_data_dialog.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/handout_dialog.h"
#include "dialogs/export/print_fractal.h"
#include "dialogs/export/space_export_dialog.h"
#include "document/edits/cage/cage_edits.h"
#include "document/moments/animated_fractal.h"
#include "files/exports.h"
#include "files/file_commands.h"
#include "files/open_file.h"
#include "files/recent_files.h"
#include "files/web_page.h"
#include "io/page/page_export.h"
#include "menus/latex_menu.h"
#include "session/session.h"
#include "stage/stage.h"
#include "widgets/menus/menu_placeholder.h"
#include "widgets/menus/menu_text.h"
#include "widgets/text/tooltip_text.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPointer>

FileMenu::FileMenu(const MenuContext& context, FileCommands* commands, const OpenFile* file,
                   const std::function<void()>& openWindow)
    : ActionMenu(context, tr("&File")), m_commands(commands), m_file(file) {
    addOpening(openWindow);
    addSeparator();
    addSaving();
    addSeparator();
    addPictures();
    addSeparator();
    add({"close", tr("C&lose"), QKeySequence::Close, tr("Close this window")},
        [this] { this->context().window->close(); });
    add({"quit", tr("&Quit"), QKeySequence::Quit, tr("Close all windows")}, &session::quit);
    addToolBarGroup({m_open, m_save, m_export});
}

void FileMenu::addOpening(const std::function<void()>& openWindow) {
    add({"new", tr("&New"), QKeySequence::New, tr("Start with a Sierpiński triangle")},
        [this] { m_commands->startNew(); });
    add({"new-window", tr("New &Window"), QKeySequence(tr("Ctrl+Shift+N")), tr("Open another window")},
        openWindow);
    m_open = add({"open", tr("&Open…"), QKeySequence::Open, tr("Open a collection of fractals")},
                 [this] { m_commands->chooseAndOpen(); });
    m_recent = addMenu(tr("Open &Recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &FileMenu::fillRecent);
}

void FileMenu::addSaving() {
    m_save = add({"save", tr("&Save"), QKeySequence::Save,
                  tr("Save the file; entries that you did not edit stay unchanged, byte for byte")},
                 [this] { m_commands->save(); });
    add({"save-as", tr("Save &As…"), QKeySequence(tr("Ctrl+Shift+S")),
         tr("Save the file under another name")},
        [this] { m_commands->saveAs(); });
    add({"save-for-other-programs",
         tr("Save a Copy &for Other Programs…"),
         {},
         tr("Save a copy with the placements written into the code and every map listed, so that other "
            "programs draw what you see")},
        [this] { m_commands->saveForOtherPrograms(); });
    QAction* revert =
        add({"revert", tr("Re&vert"), {}, tr("Discard your changes and reload the file from disk")},
            [this] { m_commands->revert(); });
    revert->setEnabled(false);
    connect(m_file, &OpenFile::pathChanged, revert,
            [this, revert] { revert->setEnabled(!m_file->path().isEmpty()); });
}

void FileMenu::addPictures() {
    m_export = add({"export-picture", tr("&Export Picture…"), QKeySequence(tr("Ctrl+E")),
                    tr("Export the picture as PNG, SVG or PDF, framed as on the screen, or a solid as a mesh "
                       "for 3D printing"),
                    nullptr, false, "export"},
                   [this] { exportPicture(); });
    add({"export-animation", tr("Export Ani&mation…"), QKeySequence(tr("Ctrl+Alt+E")),
         tr("Export the animation as a video, an animated image or frames, on this computer or on a "
            "cluster")},
        [this] { exportAnimation(); });
    add({"export-data", tr("Export &Data…"), QKeySequence(tr("Ctrl+Shift+E")),
         tr("Export the maps or points as a flame, for IFStile, as a table or a point cloud")},
        [this] { exportData(); });
    QAction* page =
        add({"export-web-page",
             tr("Export We&b Page…"),
             {},
             tr("Export the fractal in its cage as one file for browsers, in which it can be dragged")},
            [this] {
                const QString file = m_file->path();
                exportWebPage(context(), file.isEmpty() ? QString() : QFileInfo(file).path());
            });
    QAction* copy = add({"copy-picture", tr("&Copy Picture"), QKeySequence(tr("Ctrl+Shift+C")),
                         tr("Copy the picture to the clipboard"), nullptr, false, "copy"},
                        [this] { copyPicture(); });
    addMenu(new LatexMenu(context()));
    QAction* print = add(
        {"print", tr("&Print…"), QKeySequence::Print, tr("Print the picture, its name and its coefficients")},
        [this] { printPicture(); });
    add({"print-handout",
         tr("Print &Handout…"),
         {},
         tr("Print entries for a class: pictures with cage, maps and formulas, or a blank worksheet")},
        [this] {
            auto* dialog = new view::HandoutDialog(context().document, context().window);
            if (!m_file->path().isEmpty()) dialog->setName(QFileInfo(m_file->path()).completeBaseName());
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->open();
        });
    disableWhen(m_export, &document::cageObstacle);
    disableWhen(page, &io::pageObstacle);
    disableWhen(copy, &document::cageObstacle);
    disableWhen(print, &document::cageObstacle);
}

void FileMenu::fillRecent() {
    m_recent->clear();
    for (const QString& path : recent_files::list()) {
        QAction* action =
            m_recent->addAction(view::menuText(QFileInfo(path).fileName(), m_recent->fontMetrics()), this,
                                [this, path] { m_commands->openRecent(path); });
        action->setStatusTip(path);
        action->setToolTip(view::tooltipText(path)); // else it would be the name of the file
        action->setWhatsThis(action->toolTip());
    }
    if (m_recent->isEmpty()) view::addPlaceholder(*m_recent, tr("No recent files"));
    m_recent->addSeparator();
    m_recent->addAction(tr("Clear List"), this, [] { recent_files::clear(); });
}

namespace {

// So that there is one dialog, for the fractal as it is now; one that exports goes on.
template <class Dialog> void closeIdle(const QWidget& window) {
    for (auto* dialog : window.findChildren<Dialog*>())
        if (!dialog->isBusy()) dialog->close();
}

void present(view::ExportShell* dialog) {
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void showWithQueue(view::ExportShell* dialog, const QMainWindow* window) {
    dialog->setQueue(exports::queue());
    QObject::connect(dialog, &view::ExportShell::queued, window, [window] { exports::showPanel(*window); });
    present(dialog);
}

} // namespace

void FileMenu::exportPicture() {
    if (auto* transformation = context().stage->transformation(); transformation->isPainted())
        return transformation->chooseExport(); // what is shown
    closeIdle<view::SpaceExportDialog>(*context().window);
    closeIdle<view::ExportDialog>(*context().window);
    if (context().stage->showsSpace())
        return showWithQueue(new view::SpaceExportDialog(context().document,
                                                         context().stage->space()->navigation().camera(),
                                                         context().window),
                             context().window);
    auto* dialog = new view::ExportDialog(context().document, context().canvas->camera(), context().window);
    if (context().canvas->navigation().isFitted()) dialog->setSection(view::ExportDialog::Section::Attractor);
    dialog->suggestFolderOf(m_file->path());
    showWithQueue(dialog, context().window);
}

void FileMenu::printPicture() {
    const auto say = [messages = context().messages](const QString& sentence) { messages->say(sentence); };
    if (context().stage->showsSpace())
        view::printFractal(context().document, context().stage->space()->navigation().camera(),
                           context().window, say);
    else
        view::printFractal(context().document, context().canvas->camera(), context().window, say);
}

void FileMenu::exportAnimation() {
    if (!document::animationFacts(context().document->entryFractal()))
        return context().messages->say(tr(
            "Nothing moves in this entry yet. Choose a motion in the timeline first: Animation, Animate."));
    const attractor::Camera& canvas = context().canvas->camera();
    const bool isSpace = context().stage->showsSpace();
    view::AnimationExportDialog::Camera camera = attractor::viewOf(canvas);
    if (isSpace) { // as it would be at frame 0
        const auto& document = *context().document;
        const auto turns = document::frameAt(document.entryFractal(), document.moment()).orbit;
        camera = animation::orbitedBack(context().stage->space()->navigation().camera(), turns);
    }
    auto* dialog = new view::AnimationExportDialog(context().document, camera, context().window);
    if (!isSpace && context().canvas->navigation().isFitted())
        dialog->setSection(view::AnimationExportDialog::Section::Animation);
    present(dialog);
}

void FileMenu::exportData() {
    present(new view::ExportDataDialog(context().document, context().window));
}

void FileMenu::copyPicture() {
    if (context().stage->showsSpace()) {
        QGuiApplication::clipboard()->setImage(context().stage->picture());
        return context().messages->say(tr("The picture was copied to the clipboard."));
    }
    const attractor::Camera camera = context().canvas->camera();
    const auto picture = context().stage->picture();
    const QPointer<FileMenu> self(this); // the window may be closed while the lines are written
    view::copyPicture(context().document, camera, picture, context().window);
    if (self) context().messages->say(tr("The picture was copied to the clipboard."));
}
