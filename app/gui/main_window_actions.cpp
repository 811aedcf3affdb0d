// SPDX-License-Identifier: MIT
#include "cage_edits.h"
#include "canvas/cage_actions.h"
#include "dialogs/aifs_dialog.h"
#include "dialogs/command_palette.h"
#include "dialogs/export_data_dialog.h"
#include "dialogs/export_dialog.h"
#include "dialogs/guide.h"
#include "dialogs/mutate_dialog.h"
#include "dialogs/preferences_dialog.h"
#include "dialogs/print_fractal.h"
#include "dialogs/shortcuts_dialog.h"
#include "dialogs/transform_dialog.h"
#include "icon.h"
#include "main_window.h"
#include "panels/arising_bar.h"
#include "panels/branch_bar.h"
#include "panels/entries_panel.h"
#include "plain_tip.h"
#include "session.h"
#include "settings.h"
#include "theme.h"
#include "tour.h"

#include <QActionGroup>
#include <QApplication>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QShortcut>
#include <QToolBar>
#include <QWhatsThis>

QAction* MainWindow::action(QMenu* menu, const QString& icon, const QString& text,
                            const QKeySequence& shortcut, const QString& tip) {
    auto* action = new QAction(text, this);
    if (!icon.isEmpty()) action->setIcon(view::icon(icon));
    action->setShortcut(shortcut);
    action->setStatusTip(tip);
    const QString keys = shortcut.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? tip : tr("%1 (%2)", "what it does, shortcut").arg(tip, keys));
    menu->addAction(action);
    addAction(action); // in force while the menus are put away, too
    return action;
}

QAction* MainWindow::command(QMenu* menu, const QString& icon, const QString& text,
                             const QKeySequence& shortcut, const QString& tip,
                             const std::function<void()>& operation) {
    QAction* made = action(menu, icon, text, shortcut, tip);
    connect(made, &QAction::triggered, this, [operation] { operation(); });
    return made;
}

void MainWindow::possibleUnless(QAction* action, QString (*obstacle)(const document::Fractal&)) {
    action->setWhatsThis(action->statusTip());
    auto* asked = new QShortcut(action->shortcut(), this); // what is disabled has no key
    connect(asked, &QShortcut::activated, this, [this, obstacle] { say(obstacle(m_document.fractal())); });
    const auto follow = [this, action, asked, obstacle, tip = action->toolTip(),
                         status = action->statusTip()] {
        const QString why = obstacle(m_document.fractal());
        action->setEnabled(why.isEmpty());
        action->setToolTip(why.isEmpty() ? tip : why);
        action->setStatusTip(why.isEmpty() ? status : why);
        asked->setEnabled(!why.isEmpty());
    };
    connect(&m_document, &document::Document::changed, action, follow);
    follow();
}

QAction* MainWindow::toggle(QMenu* menu, const QString& icon, const QString& text,
                            const QKeySequence& shortcut, const QString& tip, const QString& setting,
                            bool initially, const std::function<void(bool)>& set) {
    QAction* made = action(menu, icon, text, shortcut, tip);
    made->setCheckable(true);
    connect(made, &QAction::toggled, this, [setting, set](bool on) {
        set(on);
        view::store(setting, on);
    });
    made->setChecked(view::stored(setting, initially).toBool());
    set(made->isChecked());
    return made;
}

void MainWindow::createFileActions() {
    m_fileMenu = menuBar()->addMenu(tr("&File"));
    command(m_fileMenu, QStringLiteral("new"), tr("&New"), QKeySequence::New,
            tr("Start with a Sierpiński triangle"), [this] {
                if (!maySpoil()) return;
                m_file.startNew();
                m_canvas->fit();
            });
    command(m_fileMenu, {}, tr("New &Window"), QKeySequence(tr("Ctrl+Shift+N")), tr("Open another window"),
            [] {
                auto* window = new MainWindow;
                window->openFirstPicture();
                window->show();
            });
    QAction* open = command(m_fileMenu, QStringLiteral("open"), tr("&Open…"), QKeySequence::Open,
                            tr("Open a collection of fractals"), [this] { chooseAndOpen(); });
    m_recentMenu = m_fileMenu->addMenu(tr("Open &Recent"));
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
    m_fileMenu->addSeparator();
    QAction* saveAction =
        command(m_fileMenu, QStringLiteral("save"), tr("&Save"), QKeySequence::Save,
                tr("Save the file; entries not edited keep every byte"), [this] { save(); });
    command(m_fileMenu, QStringLiteral("save-as"), tr("Save &As…"), QKeySequence(tr("Ctrl+Shift+S")),
            tr("Save the file under another name"), [this] { saveAs(); });
    QAction* revertAction = command(m_fileMenu, {}, tr("Re&vert"), {},
                                    tr("Go back to the file as it is on disk"), [this] { revert(); });
    revertAction->setEnabled(false);
    connect(&m_file, &OpenFile::pathChanged, revertAction,
            [this, revertAction] { revertAction->setEnabled(!m_file.path().isEmpty()); });
    m_fileMenu->addSeparator();
    QAction* exportAction =
        command(m_fileMenu, QStringLiteral("export"), tr("&Export Picture…"), QKeySequence(tr("Ctrl+E")),
                tr("Export the picture as PNG, SVG or PDF, framed as on the screen"), [this] {
                    auto* dialog = new view::ExportDialog(&m_document, m_canvas->camera(), this);
                    dialog->setAttribute(Qt::WA_DeleteOnClose);
                    const QString folder = QFileInfo(m_file.path()).absolutePath();
                    if (!m_file.path().isEmpty() && QFileInfo(folder).isWritable()) dialog->setFolder(folder);
                    dialog->show();
                });
    command(m_fileMenu, {}, tr("Export &Data…"), QKeySequence(tr("Ctrl+Shift+E")),
            tr("Export the maps or points as a flame, for IFStile, as a table or a point cloud"), [this] {
                auto* dialog = new view::ExportDataDialog(&m_document, this);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->show();
            });
    QAction* copyAction =
        command(m_fileMenu, QStringLiteral("copy"), tr("&Copy Picture"), QKeySequence(tr("Ctrl+Shift+C")),
                tr("Copy the picture to the clipboard"), [this] {
                    const attractor::Camera camera = m_canvas->camera();
                    const auto picture = m_canvas->picture();
                    const QPointer<MainWindow> here(this); // it may be closed while the lines are written
                    view::copyPicture(&m_document, camera, picture, this);
                    if (here) say(tr("The picture is on the clipboard."));
                });
    QAction* printAction = command(m_fileMenu, QStringLiteral("print"), tr("&Print…"), QKeySequence::Print,
                                   tr("Print the picture, its name and its coefficients"),
                                   [this] { view::printFractal(&m_document, m_canvas->camera(), this); });
    for (QAction* ofPictures : {exportAction, copyAction, printAction})
        possibleUnless(ofPictures, &view::planeObstacle);
    m_fileMenu->addSeparator();
    command(m_fileMenu, QStringLiteral("close"), tr("C&lose"), QKeySequence::Close, tr("Close this window"),
            [this] { close(); });
    command(m_fileMenu, {}, tr("&Quit"), QKeySequence::Quit, tr("Close all windows"),
            [] { session::quit(); });
    m_toolBarActions << open << saveAction << exportAction << nullptr;
}

void MainWindow::createEditActions() {
    m_editMenu = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_document.undoStack()->createUndoAction(this, tr("&Undo"));
    undo->setIconText(tr("&Undo").remove(u'&')); // whatever step it takes back
    undo->setShortcut(QKeySequence(tr("Ctrl+Z")));
    undo->setIcon(view::icon(QStringLiteral("undo")));
    undo->setStatusTip(tr("Take the last edit back"));
    QAction* redo = m_document.undoStack()->createRedoAction(this, tr("&Redo"));
    redo->setIconText(tr("&Redo").remove(u'&'));
    redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    redo->setIcon(view::icon(QStringLiteral("redo")));
    redo->setStatusTip(tr("Make the edit again that was taken back"));
    m_editMenu->addActions({undo, redo});
    addActions({undo, redo});
    // Names of entries are part of what is undone.
    const auto tell = [](QAction* action, const QString& step) {
        action->setToolTip(view::plainTip((action->iconText() + u' ' + step).trimmed()));
    };
    connect(m_document.undoStack(), &QUndoStack::undoTextChanged, undo,
            [undo, tell](const QString& step) { tell(undo, step); });
    connect(m_document.undoStack(), &QUndoStack::redoTextChanged, redo,
            [redo, tell](const QString& step) { tell(redo, step); });
    m_editMenu->addSeparator();
    command(m_editMenu, QStringLiteral("paste"), tr("P&aste"), QKeySequence::Paste,
            tr("Add the fractals on the clipboard to the file: entries of an .ifs file, flames or a table of "
               "numbers"),
            [this] { findChild<view::EntriesPanel*>()->paste(); });
    QAction* transform =
        command(m_editMenu, QStringLiteral("transform"), tr("&Transform…"), QKeySequence(tr("Ctrl+T")),
                tr("Rotate, scale, shear, reflect or move the whole fractal by numbers"), [this] {
                    auto* dialog = new view::TransformDialog(&m_document, this);
                    dialog->setAttribute(Qt::WA_DeleteOnClose);
                    dialog->open(); // another edit would end what it shows
                });
    QAction* mutate = command(m_editMenu, {}, tr("&Mutate…"), QKeySequence(tr("Ctrl+M")),
                              tr("Pick one of many variations of this fractal"),
                              [this] { pickFrom(view::MutateDialog::Source::Current); });
    possibleUnless(transform, &view::planeObstacle);
    possibleUnless(mutate, &view::planeObstacle);
    command(m_editMenu, {}, tr("Add Ra&ndom Fractal…"), QKeySequence(tr("Ctrl+Shift+M")),
            tr("Pick one of many fractals made by chance, and add it to the file"), [this] { addRandom(); });
    m_editMenu->addSeparator();
    toggle(m_editMenu, {}, tr("Allow Systems &without an Attractor"), {},
           tr("Let maps be dragged to where they no longer contract; otherwise the drag stops there"),
           QStringLiteral("edit/allowNoAttractor"), false,
           [this](bool on) { m_canvas->setAllowsNoAttractor(on); });
    command(m_editMenu, QStringLiteral("settings"), tr("&Preferences…"), QKeySequence(tr("Ctrl+,")),
            tr("Language, theme, quality of the picture at rest, what is opened at the start"),
            [this] { showPreferences(); });
    m_toolBarActions << undo << redo << nullptr;
}

void MainWindow::pickFrom(view::MutateDialog::Source source) {
    auto* dialog = new view::MutateDialog(&m_document, source, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::addRandom() {
    pickFrom(view::MutateDialog::Source::Chance);
}

void MainWindow::showPreferences() {
    auto* dialog = new view::PreferencesDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &view::PreferencesDialog::changed, dialog, [](const view::Preferences& preferences) {
        view::wear(preferences.theme);
        for (MainWindow* window : session::windows())
            window->m_bridge->setQuality(preferences.quality);
    });
    dialog->show();
}

void MainWindow::createCageActions() {
    using Tool = view::CanvasView::Tool;
    m_cageMenu = menuBar()->addMenu(tr("&Cage"));
    m_tools = new QActionGroup(this);
    const auto tool = [this](const QString& icon, const QString& text, const QKeySequence& shortcut,
                             const QString& tip, Tool which) {
        QAction* action =
            command(m_cageMenu, icon, text, shortcut, tip, [this, which] { m_canvas->setTool(which); });
        action->setCheckable(true);
        action->setChecked(m_canvas->tool() == which);
        m_tools->addAction(action);
        connect(m_canvas, &view::CanvasView::toolChanged, action,
                [action, which](Tool now) { action->setChecked(now == which); });
        return action;
    };
    QAction* drag = tool(QStringLiteral("cage"), tr("&Drag the Cage"), QKeySequence(tr("C")),
                         tr("Take the fractal by the vertices of its control triangle"), Tool::Cage);
    QAction* maps =
        tool(QStringLiteral("maps"), tr("Drag t&he Maps"), QKeySequence(tr("M")),
             tr("Show the maps as images of the cage and take them by their corners"), Tool::Maps);
    QAction* branch =
        tool(QStringLiteral("branch"), tr("Drag a Bra&nch"), QKeySequence(tr("B")),
             tr("Click a point of the attractor and take the branch that it belongs to"), Tool::Branch);
    QAction* define = tool(QStringLiteral("define"), tr("De&fine Triangle"), QKeySequence(tr("D")),
                           tr("Define the control triangle by three clicks"), Tool::DefineTriangle);
    m_cageMenu->addSeparator();
    const auto operate = [this](const QString& icon, const QString& text, const QKeySequence& shortcut,
                                const QString& tip, auto operation) {
        return command(m_cageMenu, icon, text, shortcut, tip, [this, operation] {
            if (const auto sentence = operation(m_document)) say(*sentence);
        });
    };
    QAction* fitSimplex = operate(QStringLiteral("fit-simplex"), tr("Fit &Minimal Canonical Simplex"), {},
                                  tr("Hold the attractor in the smallest isosceles right triangle around it"),
                                  &view::fitMinimalCanonicalSimplex);
    QAction* reset = operate(QStringLiteral("reset"), tr("&Reset"), {},
                             tr("Put the cage back to rest: the code is drawn as it is"), &view::resetCage);
    QAction* bake =
        operate(QStringLiteral("bake"), tr("&Bake"), QKeySequence(tr("Ctrl+B")),
                tr("Make the placement part of the code: the picture stays, the coefficients change"),
                &view::bakeCage);
    QAction* unbake = operate(
        {}, tr("&Unbake"), {},
        tr("Take the placement out of the code: the picture stays, the code becomes that of the triangle "
           "(0, 0), (1, 0), (0, 1)"),
        &view::unbakeCage);
    possibleUnless(reset, &view::resetObstacle);
    possibleUnless(bake, &view::bakeObstacle);
    possibleUnless(unbake, &view::unbakeObstacle);
    QAction* regular =
        operate({}, tr("Make Re&gular"), {}, tr("Put the vertices on the regular polygon nearest to them"),
                &view::makeCageRegular);
    QAction* aifs =
        command(m_cageMenu, {}, tr("Affine &Invariant Form…"), {},
                tr("Show every map as a row-stochastic matrix over the control triangle"), [this] {
                    auto* dialog = new view::AifsDialog(m_document.fractal(), this);
                    dialog->setAttribute(Qt::WA_DeleteOnClose);
                    dialog->show();
                });
    for (QAction* ofCages : {fitSimplex, regular, aifs})
        possibleUnless(ofCages, &view::planeObstacle);
    m_cageMenu->addSeparator();
    auto* modes = new QActionGroup(this);
    const auto mode = [this, modes](const QString& icon, const QString& text, const QString& tip,
                                    document::CageMode which) {
        QAction* action =
            command(m_cageMenu, icon, text, {}, tip, [this, which] { m_document.setCageMode(which); });
        action->setCheckable(true);
        action->setChecked(m_document.cageMode() == which);
        modes->addAction(action);
        connect(&m_document, &document::Document::cageModeChanged, action,
                [action, which](document::CageMode now) { action->setChecked(now == which); });
        return action;
    };
    QAction* place = mode(QStringLiteral("place"), tr("&Place"),
                          tr("Moving the cage moves the picture; the code stays"), document::CageMode::Place);
    QAction* rewrite = mode(QStringLiteral("rewrite"), tr("Re&write"),
                            tr("Moving the cage rewrites the code"), document::CageMode::Rewrite);
    m_toolBarActions << drag << maps << branch << define << fitSimplex << reset << bake << nullptr << place
                     << rewrite << nullptr;
}

void MainWindow::createViewActions() {
    m_viewMenu = menuBar()->addMenu(tr("&View"));
    QAction* fit = command(m_viewMenu, QStringLiteral("fit"), tr("&Fit"), QKeySequence(tr("F")),
                           tr("Show the whole fractal"), [this] { m_canvas->fit(); });
    QAction* in = command(m_viewMenu, QStringLiteral("zoom-in"), tr("Zoom &In"), QKeySequence::ZoomIn,
                          tr("Zoom in"), [this] { m_canvas->zoomBy(1.25); });
    QAction* out = command(m_viewMenu, QStringLiteral("zoom-out"), tr("Zoom &Out"), QKeySequence::ZoomOut,
                           tr("Zoom out"), [this] { m_canvas->zoomBy(1 / 1.25); });
    command(m_viewMenu, QStringLiteral("zoom-reset"), tr("&100 %"), QKeySequence(tr("1")),
            tr("Show one unit as one hundred pixels"), [this] { m_canvas->resetZoom(); });
    m_viewMenu->addSeparator();
    QAction* grid =
        toggle(m_viewMenu, QStringLiteral("grid"), tr("&Grid"), QKeySequence(tr("G")), tr("Show the grid"),
               QStringLiteral("canvas/grid"), true, [this](bool on) { m_canvas->setGridVisible(on); });
    connect(m_canvas, &view::CanvasView::gridVisibleChanged, grid, &QAction::setChecked);
    QAction* axes =
        toggle(m_viewMenu, QStringLiteral("axes"), tr("&Axes"), QKeySequence(tr("A")), tr("Show the axes"),
               QStringLiteral("canvas/axes"), true, [this](bool on) { m_canvas->setAxesVisible(on); });
    connect(m_canvas, &view::CanvasView::axesVisibleChanged, axes, &QAction::setChecked);
    QAction* down = action(m_viewMenu, QStringLiteral("y-axis"), tr("&Y Axis Down"), QKeySequence(tr("Y")),
                           tr("Let y grow downwards, as in window coordinates"));
    down->setCheckable(true);
    connect(down, &QAction::toggled, this,
            [this](bool on) { m_canvas->setYAxis(on ? attractor::YAxis::Down : attractor::YAxis::Up); });
    QAction* hide = action(m_viewMenu, QStringLiteral("hide"), tr("Only the Pi&cture"), QKeySequence(tr("H")),
                           tr("Hide everything on the canvas but the picture"));
    hide->setCheckable(true);
    connect(hide, &QAction::toggled, this, [this](bool on) { m_canvas->setOverlaysVisible(!on); });
    connect(m_canvas, &view::CanvasView::overlaysVisibleChanged, hide,
            [hide](bool on) { hide->setChecked(!on); });

    QMenu* snap = m_viewMenu->addMenu(view::icon(QStringLiteral("snap")), tr("&Snap To"));
    for (const auto& [flag, text, name] :
         {std::tuple{view::SnapTo::Grid, tr("&Grid"), QStringLiteral("grid")},
          std::tuple{view::SnapTo::Vertices, tr("&Vertices"), QStringLiteral("vertices")},
          std::tuple{view::SnapTo::Axes, tr("&Axes"), QStringLiteral("axes")}}) {
        QAction* made = action(snap, {}, text, {}, tr("Let dragged vertices snap to this"));
        made->setCheckable(true);
        const QString setting = QStringLiteral("canvas/snap/") + name;
        connect(made, &QAction::toggled, this, [this, flag = flag, setting](bool on) {
            m_canvas->setSnapping(m_canvas->snapping().setFlag(flag, on));
            view::store(setting, on);
        });
        made->setChecked(view::stored(setting, false).toBool());
    }
    m_viewMenu->addSeparator();
    m_panelMenu = m_viewMenu->addMenu(tr("&Panels"));
    m_fullScreen =
        action(m_viewMenu, {}, tr("F&ull Screen"), QKeySequence(tr("F11")), tr("Use the whole screen"));
    m_fullScreen->setCheckable(true);
    connect(m_fullScreen, &QAction::toggled, this,
            [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
    m_presentation =
        action(m_viewMenu, {}, tr("P&resentation"), QKeySequence(tr("Shift+F11")),
               tr("Leave the whole screen to the canvas, as for a projector; Esc brings the rest back"));
    m_presentation->setCheckable(true);
    connect(m_presentation, &QAction::toggled, this, &MainWindow::present);
    m_toolBarActions << fit << in << out << nullptr << createArisingBar();
    createBranchBar();
}

QAction* MainWindow::createArisingBar() {
    auto* bar = new QToolBar(tr("How It Arises"), this);
    bar->setObjectName(QStringLiteral("arising"));
    bar->setMovable(false);
    bar->addWidget(new view::ArisingBar(m_arising));
    addToolBar(Qt::BottomToolBarArea, bar);
    bar->hide();
    QAction* shown = bar->toggleViewAction();
    shown->setText(tr("&How It Arises"));
    shown->setIcon(view::icon(QStringLiteral("arising")));
    shown->setShortcut(QKeySequence(tr("W")));
    shown->setStatusTip(
        tr("Watch the attractor arise: by steps of the deterministic algorithm, or by the chaos "
           "game"));
    m_viewMenu->addAction(shown);
    addAction(shown);
    connect(bar, &QToolBar::visibilityChanged, this, [this, bar](bool visible) {
        if (!visible) takeFocusFrom(bar);
    });
    connect(shown, &QAction::toggled, m_arising, [this](bool on) {
        if (!on) m_arising->setMode(view::Arising::Mode::Density);
    });
    return shown;
}

void MainWindow::createBranchBar() {
    m_branchBar = new QToolBar(tr("Maps and Branches"), this);
    m_branchBar->setObjectName(QStringLiteral("branches"));
    m_branchBar->setMovable(false);
    m_branchBar->addWidget(new view::BranchBar(&m_document, m_canvas));
    m_branchBar->toggleViewAction()->setVisible(false); // it comes and goes with the tools
    addToolBarBreak(Qt::BottomToolBarArea); // side by side the two bars would widen a small window
    addToolBar(Qt::BottomToolBarArea, m_branchBar);
    connect(m_canvas, &view::CanvasView::toolChanged, m_branchBar, [this](view::CanvasView::Tool tool) {
        m_branchBar->setVisible(tool == view::CanvasView::Tool::Maps ||
                                tool == view::CanvasView::Tool::Branch);
    });
}

void MainWindow::createHelpActions() {
    m_helpMenu = menuBar()->addMenu(tr("&Help"));
    command(m_helpMenu, QStringLiteral("search"), tr("&Find a Command…"), QKeySequence(tr("Ctrl+K")),
            tr("Find any command by typing what it does"), [this] {
                auto* palette = new view::CommandPalette(view::actionsOf(*this), this);
                palette->setAttribute(Qt::WA_DeleteOnClose);
                palette->move(mapToGlobal(QPoint((width() - palette->width()) / 2, height() / 6)));
                palette->show();
            });
    command(m_helpMenu, QStringLiteral("help"), tr("&Keyboard and Mouse…"), QKeySequence(tr("Ctrl+/")),
            tr("Every shortcut and gesture"), [this] {
                auto* dialog = new view::ShortcutsDialog(view::actionsOf(*this), this);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->show();
            });
    command(m_helpMenu, {}, tr("&User Guide"), QKeySequence::HelpContents, tr("Read the user guide"),
            [this] { view::showGuide(this); });
    command(m_helpMenu, {}, tr("&Tour"), {},
            tr("Six short steps in this window: contraction, fixed point, chaos game, address, barycentric "
               "coordinates, dimension"),
            [this] { Tour::start(this); });
    QAction* what = QWhatsThis::createAction(this);
    what->setText(tr("&What’s This?"));
    what->setIcon(view::icon(QStringLiteral("help")));
    what->setStatusTip(tr("Click anything to read what it is for"));
    m_helpMenu->addAction(what);
    m_helpMenu->addSeparator();
    command(m_helpMenu, QStringLiteral("info"), tr("&About Barycage"), {}, tr("Version and licence"), [this] {
        QMessageBox box(
            QMessageBox::NoIcon, tr("About Barycage"),
            tr("<h3>Barycage %1</h3><p>Take a fractal by its corners: an editor for iterated function "
               "systems "
               "whose attractors are held in barycentric coordinates of a control triangle.</p>"
               "<p>After E. Hadzieva and M. Shuminoska, <i>Real-time Tool for Affine Transformations of Two "
               "Dimensional IFS Fractals</i>.</p><p>MIT licence.</p>")
                .arg(QApplication::applicationVersion()),
            QMessageBox::Ok, this);
        box.setTextFormat(Qt::RichText);
        box.setIconPixmap(windowIcon().pixmap(64));
        box.exec();
    });
    command(m_helpMenu, {}, tr("About &Qt"), {}, tr("The toolkit this program is built with"),
            &QApplication::aboutQt);
}

void MainWindow::createToolBar() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->setIconSize({22, 22});
    for (QAction* action : m_toolBarActions) {
        if (action)
            bar->addAction(action);
        else
            bar->addSeparator();
    }
    m_panelMenu->addSeparator();
    m_panelMenu->addAction(bar->toggleViewAction());
}
