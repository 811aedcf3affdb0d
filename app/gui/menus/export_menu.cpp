// SPDX-License-Identifier: MIT
#include "menus/export_menu.h"

#include "animation/paths/camera_path.h"
#include "dialogs/command_synonyms.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/export/copy_picture.h"
#include "dialogs/export/export_data_dialog.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/space_export_dialog.h"
#include "docks/panels.h"
#include "document/edits/cage/cage_edits.h"
#include "document/moments/animated_fractal.h"
#include "files/exports.h"
#include "files/file_commands.h"
#include "files/open_file.h"
#include "files/web_page.h"
#include "io/exchange/entry_link.h"
#include "io/exchange/python_text.h"
#include "io/file/background.h"
#include "io/page/page_export.h"
#include "io/solid/mesh_writer.h"
#include "menus/latex_menu.h"
#include "stage/stage.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPointer>
#include <QPushButton>

#include <algorithm>
#include <optional>

ExportMenu::ExportMenu(const MenuContext& context, FileCommands* commands, const OpenFile* file)
    : ActionMenu(context, tr("&Export")), m_commands(commands), m_file(file) {
    m_picture =
        add({"export-picture", tr("&Export Picture…"), QKeySequence(tr("Ctrl+E")),
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
                const QString path = m_file->path();
                exportWebPage(this->context(), path.isEmpty() ? QString() : QFileInfo(path).path());
            });
    addSeparator();
    QAction* copy = add({"copy-picture", tr("&Copy Picture"), QKeySequence(tr("Ctrl+Shift+C")),
                         tr("Copy the picture to the clipboard"), nullptr, false, "copy"},
                        [this] { copyPicture(); });
    QAction* link = add({"copy-link",
                         tr("Copy &Link"),
                         {},
                         tr("Copy a link that holds the fractal: Barycage opens it when it is pasted")},
                        [this] { copyLink(); });
    addMenu(new LatexMenu(context));
    QAction* python = add({"copy-as-python",
                           tr("Copy as &Python"),
                           {},
                           tr("Copy lines for a notebook that make the fractal with the Python package "
                              "“barycage”")},
                          [this] { copyAsPython(); });
    addSeparator();
    add({"save-for-other-programs",
         tr("Save a Copy &for Other Programs…"),
         {},
         tr("Save a copy with the placements written into the code and every map listed, so that other "
            "programs draw what you see")},
        [this] { m_commands->saveForOtherPrograms(); });
    disableWhen(m_picture, &document::cageObstacle);
    disableWhen(page, &io::pageObstacle);
    disableWhen(copy, &document::cageObstacle);
    for (QAction* whole : {link, python})
        disableWhen(whole, &io::linkObstacle);
}

namespace {

// Closes idle dialogs, so that there is one, for the fractal as it is now; one that exports goes on.
template <class Dialog> void closeIdle(const QWidget& window) {
    for (auto* dialog : window.findChildren<Dialog*>())
        if (!dialog->isBusy()) dialog->close();
}

// What was typed to find the command.
QString searched(const QAction& action) {
    return action.property(view::searchedWords).toString().toLower();
}

std::optional<io::MeshFormat> searchedMesh(const QAction& action) {
    return ifs::named<io::MeshFormat>(searched(action).toStdString());
}

// Words of people who cut and draw with machines, in English and in the user's language.
bool isOfMachines(const QString& typed) {
    constexpr qsizetype fewest = 3; // letters
    const char* const words =
        QT_TRANSLATE_NOOP("MainWindow", "laser plotter cutter engrave dxf outline millimetres millimeters");
    const QStringList known =
        (QCoreApplication::translate("MainWindow", words) + u' ' + QLatin1String(words)).split(u' ');
    return std::ranges::any_of(typed.split(u' '), [&](const QString& part) {
        return part.size() >= fewest && std::ranges::any_of(known, [&](const QString& word) {
                   return word.startsWith(part, Qt::CaseInsensitive);
               });
    });
}

void present(view::ExportShell* dialog) {
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

} // namespace

void ExportMenu::showWithQueue(view::ExportShell* dialog) {
    dialog->setQueue(exports::queue());
    connect(dialog, &view::ExportShell::queued, context().window,
            [panels = context().panels] { panels->show(Panel::Exports); });
    offerAnimation(dialog);
    present(dialog);
}

// Who wants the motion and chose Export Picture is one click from it.
void ExportMenu::offerAnimation(view::ExportShell* dialog) {
    const auto* button = dialog->findChild<QPushButton*>(QStringLiteral("animation"));
    if (!button) return;
    connect(button, &QPushButton::clicked, this, [this, dialog] {
        dialog->close();
        exportAnimation();
    });
}

void ExportMenu::exportPicture() {
    if (auto* transformation = context().stage->transformation(); transformation->isPainted())
        return transformation->chooseExport(); // what is shown
    const auto mesh = searchedMesh(*m_picture);
    if (mesh && !context().stage->showsSpace())
        return context().messages->say(
            tr("A mesh needs a solid, and this entry lies in a plane: lift it to space first."));
    closeIdle<view::SpaceExportDialog>(*context().window);
    closeIdle<view::ExportDialog>(*context().window);
    if (context().stage->showsSpace()) {
        auto* dialog = new view::SpaceExportDialog(
            context().document, context().stage->space()->navigation().camera(), context().window);
        if (context().stage->space()->navigation().isFitted()) dialog->beginWithAttractor();
        if (mesh) dialog->setFormat(*mesh);
        return showWithQueue(dialog);
    }
    auto* dialog = new view::ExportDialog(context().document, context().canvas->camera(), context().window);
    if (context().canvas->navigation().isFitted()) dialog->setSection(view::ExportDialog::Section::Attractor);
    if (isOfMachines(searched(*m_picture))) dialog->beginAsOutline();
    dialog->suggestFolderOf(m_file->path());
    showWithQueue(dialog);
}

void ExportMenu::exportAnimation() {
    if (!document::animationFacts(context().document->entryFractal()))
        return context().messages->say(tr(
            "Nothing moves in this entry yet. Choose a motion in the timeline first: Animation, Animate."));
    const attractor::Camera& canvas = context().canvas->camera();
    const bool isSpace = context().stage->showsSpace();
    view::AnimationExportDialog::Camera camera = attractor::viewOf(canvas);
    if (isSpace) { // camera at frame 0
        const auto& document = *context().document;
        const auto turns = document::frameAt(document.entryFractal(), document.moment()).orbit;
        camera = animation::orbitedBack(context().stage->space()->navigation().camera(), turns);
    }
    auto* dialog = new view::AnimationExportDialog(context().document, camera, context().window);
    if (!isSpace && context().canvas->navigation().isFitted())
        dialog->setSection(view::AnimationExportDialog::Section::Animation);
    present(dialog);
}

void ExportMenu::exportData() {
    present(new view::ExportDataDialog(context().document, context().window));
}

// Copies in the background: an entry may have many maps.
void ExportMenu::copyLink() {
    io::inBackground<io::WrittenLink>([fractal = context().document->sharedFractal()](auto& promise) {
        promise.addResult(io::linkOf(*fractal));
    }).then(context().window, [messages = context().messages](const io::WrittenLink& written) {
        if (written.failure) return messages->say(*written.failure);
        QGuiApplication::clipboard()->setText(QString::fromLatin1(written.link));
        messages->say(tr("The link was copied to the clipboard. It holds the whole fractal."));
    });
}

// As above.
void ExportMenu::copyAsPython() {
    io::inBackground<QString>([fractal = context().document->sharedFractal()](auto& promise) {
        promise.addResult(QString::fromUtf8(io::pythonText(*fractal)));
    }).then(context().window, [messages = context().messages](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        messages->say(tr("Copied."));
    });
}

void ExportMenu::copyPicture() {
    if (context().stage->showsSpace()) {
        QGuiApplication::clipboard()->setImage(context().stage->picture());
        return context().messages->say(tr("The picture was copied to the clipboard."));
    }
    const attractor::Camera camera = context().canvas->camera();
    const auto picture = context().stage->picture();
    const QPointer<ExportMenu> self(this); // the window may close meanwhile
    view::copyPicture(context().document, camera, picture, context().window);
    if (self) context().messages->say(tr("The picture was copied to the clipboard."));
}
