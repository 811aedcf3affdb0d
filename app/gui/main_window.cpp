// SPDX-License-Identifier: MIT
#include "main_window.h"

#include "dialogs/paste_table_dialog.h"
#include "dialogs/save_file_dialog.h"
#include "flame_card.h"
#include "io/background.h"
#include "io/fractint_reader.h"
#include "panels/analysis_panel.h"
#include "panels/appearance_panel.h"
#include "panels/cage_panel.h"
#include "panels/collection_panel.h"
#include "panels/entries_edits.h"
#include "panels/entries_panel.h"
#include "panels/history_panel.h"
#include "panels/maps_panel.h"
#include "panels/problems_panel.h"
#include "preferences.h"
#include "recent_files.h"
#include "session.h"
#include "settings.h"
#include "status_line.h"
#include "whats_this.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QResizeEvent>
#include <QScreen>
#include <QToolBar>

namespace {

constexpr int cascade = 32;         // pixels from one window to the next
constexpr double usualLetter = 6;   // wide, in pixels: the font that first sizes are for
constexpr int problemsHeight = 150; // a few lines: the picture stays the largest thing in the window

QString fileFilter() {
    return MainWindow::tr("Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers "
                          "(*.csv *.tsv *.txt);;"
                          "Pictures that carry their fractal (*.png *.svg);;All files (*)");
}

// Adds the fractal to the file as a new entry and shows it: one undo step.
void addEntry(document::Document& document, const document::Fractal& fractal) {
    document::Entry entry;
    entry.fractal = std::make_shared<const document::Fractal>(fractal);
    view::Inserted added = view::inserted(document.file(), {entry}, document::EntryId::None);
    document.editFile(MainWindow::tr("Add %1").arg(fractal.name), std::move(added.file), added.ids.front());
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_file(&m_document, this),
      m_recovery(&m_document, &m_file, nullptr),
      m_bridge(new view::RenderBridge(&m_document, this)),
      m_analysis(new view::AnalysisBridge(&m_document, this)),
      m_arising(new view::Arising(&m_document, m_bridge, this)),
      m_canvas(new view::CanvasView(&m_document, m_bridge, this)),
      m_status(new StatusLine(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::West); // in any language there is room for the names
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
    setCentralWidget(m_canvas);
    setStatusBar(m_status);

    m_bridge->setQuality(view::Preferences::stored().quality);
    createFileActions();
    createEditActions();
    createCageActions();
    createViewActions();
    createPanels();
    explainPanels();
    createHelpActions();
    createToolBar();
    for (QMenu* menu : {m_fileMenu, m_editMenu, m_cageMenu, m_viewMenu, m_helpMenu})
        menu->setToolTipsVisible(true); // what is disabled says why
    connectDocument();
    view::explainByTips(this);
    restoreLayout();
    m_branchBar->hide();
    m_canvas->setFocus();
}

MainWindow::~MainWindow() {
    hide(); // fields being edited hand over what was typed, while there is a document to take it
    m_document.undoStack()->disconnect(this); // it is cleared when the file that the title names has gone
    connect(this, &QObject::destroyed, qApp,
            [file = m_document.file()]() mutable { // the panels are gone, too
                io::letGo(std::move(file));
            });
}

QDockWidget* MainWindow::dock(QWidget* panel, const QString& title, const QString& id,
                              Qt::DockWidgetArea area) {
    auto* made = new QDockWidget(title, this);
    made->setObjectName(id);
    made->setWidget(panel);
    addDockWidget(area, made);
    m_panelMenu->addAction(made->toggleViewAction());
    made->toggleViewAction()->setStatusTip(tr("Show or hide the panel “%1”").arg(title));
    made->toggleViewAction()->setToolTip(made->toggleViewAction()->statusTip());
    // Behind another panel it would go on taking keys that nobody sees arrive.
    connect(made, &QDockWidget::visibilityChanged, this, [this, made](bool visible) {
        if (!visible) takeFocusFrom(made);
    });
    return made;
}

void MainWindow::createPanels() {
    auto* entries = new view::EntriesPanel(&m_document);
    auto* collection = new view::CollectionPanel;
    auto* problems = new view::ProblemsPanel(&m_document);
    auto* maps = new view::MapsPanel(&m_document);
    auto* cage = new view::CagePanel(&m_document);
    auto* appearance = new view::AppearancePanel(&m_document);

    QDockWidget* entriesDock =
        dock(entries, tr("Entries"), QStringLiteral("entries"), Qt::LeftDockWidgetArea);
    QDockWidget* collectionDock =
        dock(collection, tr("Collection"), QStringLiteral("collection"), Qt::LeftDockWidgetArea);
    splitDockWidget(entriesDock, collectionDock, Qt::Vertical);
    QDockWidget* mapsDock = dock(maps, tr("Maps"), QStringLiteral("maps"), Qt::RightDockWidgetArea);
    QDockWidget* previous = mapsDock;
    for (QDockWidget* next :
         {dock(cage, tr("Cage"), QStringLiteral("cage"), Qt::RightDockWidgetArea),
          dock(appearance, tr("Appearance"), QStringLiteral("appearance"), Qt::RightDockWidgetArea),
          dock(new view::AnalysisPanel(&m_document, m_analysis), tr("Analysis"), QStringLiteral("analysis"),
               Qt::RightDockWidgetArea),
          dock(new view::HistoryPanel(&m_document), tr("History"), QStringLiteral("history"),
               Qt::RightDockWidgetArea)}) {
        tabifyDockWidget(previous, next);
        previous = next;
    }
    mapsDock->raise();
    QDockWidget* problemsDock =
        dock(problems, tr("Problems"), QStringLiteral("problems"), Qt::BottomDockWidgetArea);
    problemsDock->hide();

    // The rows of the table and the maps on the canvas are selected together.
    connect(maps, &view::MapsPanel::selectionChanged, m_canvas,
            [this, maps] { m_canvas->selectMaps(maps->selectedMaps()); });
    connect(m_canvas, &view::CanvasView::selectedMapsChanged, maps, [this, maps] {
        if (maps->selectedMaps() != m_canvas->selectedMaps()) maps->selectMaps(m_canvas->selectedMaps());
    });
    m_canvas->selectMaps(maps->selectedMaps());
    connect(entries, &view::EntriesPanel::message, this, &MainWindow::say);
    connect(entries, &view::EntriesPanel::flamesPasted, this,
            [this](const QList<document::EntryId>& ids) { FlameCard::offer(this, ids); });
    connect(maps, &view::MapsPanel::message, this, &MainWindow::say);
    connect(cage, &view::CagePanel::message, this, &MainWindow::say);
    connect(appearance, &view::AppearancePanel::message, this, &MainWindow::say);
    connect(cage, &view::CagePanel::defineRequested, m_canvas,
            [this] { m_canvas->setTool(view::CanvasView::Tool::DefineTriangle); });
    connect(problems, &view::ProblemsPanel::countChanged, problemsDock, [this, problemsDock](int count) {
        const bool appears = count > 0 && problemsDock->isHidden();
        problemsDock->setVisible(count > 0);
        if (appears) resizeDocks({problemsDock}, {problemsHeight}, Qt::Vertical);
    });
    connect(&m_file, &OpenFile::pathChanged, problems,
            [this, problems] { problems->setFileName(m_file.name()); });
    connect(collection, &view::CollectionPanel::openRequested, this,
            [this](const document::Fractal& fractal) {
                if (!maySpoil()) return;
                m_file.startFrom(document::fileOf(fractal), document::EntryId::None);
            });
    connect(collection, &view::CollectionPanel::addRequested, this,
            [this](const document::Fractal& fractal) { addEntry(m_document, fractal); });
}

void MainWindow::explainPanels() {
    for (const auto& [id, text] :
         {std::pair{"entries", tr("The fractals of the open file. The one chosen here is in the picture.")},
          {"collection", tr("Fractals to begin with, by theme, and your own folders of them.")},
          {"maps", tr("The maps of the fractal: its code, one map in a row.")},
          {"cage",
           tr("The control cage by numbers: where its vertices are, where they are at rest, what moving "
              "them does, and other cages to choose from.")},
          {"appearance",
           tr("Colours, brightness and background of the picture. They are saved with the fractal.")},
          {"analysis", tr("What mathematics knows of this fractal. Point at a name to read what it means.")},
          {"history", tr("Every step since the file was opened. Choose one to go back to it, or forward.")},
          {"problems", tr("What was odd in the file, with line and column. It is kept as it is.")}})
        if (auto* panel = findChild<QDockWidget*>(QLatin1String(id))) panel->setWhatsThis(text);
}

// Dialogs explain themselves before they are seen.
void MainWindow::childEvent(QChildEvent* event) {
    QMainWindow::childEvent(event);
    if (!event->polished() || !event->child()->isWidgetType()) return;
    if (auto* widget = static_cast<QWidget*>(event->child()); widget->isWindow()) view::explainByTips(widget);
}

void MainWindow::connectDocument() {
    connect(&m_document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        const bool isAnother = change.parts & (Change::System | Change::Current | Change::File);
        if (isAnother || (!change.live && change.parts & Change::Cage))
            QMetaObject::invokeMethod( // nobody waits for it
                m_status, [this] { m_status->showVerdict(m_document.fractal()); }, Qt::QueuedConnection);
        if (!change.live && change.parts & (Change::Name | Change::Current | Change::File)) updateTitle();
    });
    connect(m_document.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
    connect(&m_file, &OpenFile::pathChanged, this, &MainWindow::updateTitle);
    connect(&m_file, &OpenFile::orderAssumed, this, [this](const QString& table) {
        view::PasteTableDialog::askForColumns(&m_document, table, this);
    });
    connect(&m_file, &OpenFile::flamesOpened, this, [this] {
        QList<document::EntryId> flames;
        for (const document::Entry& entry : m_document.file().entries)
            flames << entry.id;
        FlameCard::offer(this, flames);
    });
    connect(m_canvas, &view::CanvasView::message, this, &MainWindow::say);
    connect(&m_recovery, &Recovery::cannotKeep, this,
            [this](const QString& sentence) { fail(tr("No recovery"), sentence); });
    connect(m_canvas, &view::CanvasView::pointerMoved, m_status, &StatusLine::showPointer);
    connect(m_canvas, &view::CanvasView::pointerLeft, m_status, &StatusLine::clearPointer);
    connect(m_bridge, &view::RenderBridge::frameChanged, m_status, [this] {
        if (m_bridge->frame()) m_status->showFrame(*m_bridge->frame());
    });
    connect(m_arising, &view::Arising::trailChanged, m_canvas,
            [this] { m_canvas->showTrail(m_arising->trail()); });
    connect(m_analysis, &view::AnalysisBridge::changed, m_canvas, [this] {
        const auto analysis = m_analysis->analysis();
        m_canvas->showOutlines(analysis ? analysis->shapes : std::vector<document::OutlineShape>());
    });
    m_status->showVerdict(m_document.fractal());
    updateTitle();
}

void MainWindow::openFirstPicture() {
    QFile resource(QStringLiteral(":/ifs_library/paper.ifs"));
    if (!resource.open(QIODevice::ReadOnly)) return;
    document::FractalFile file = io::readFractint(resource.readAll());
    document::EntryId maple = document::EntryId::None;
    for (const document::Entry& entry : file.entries)
        if (entry.fractal->name == QLatin1String("maple")) maple = entry.id;
    m_file.startFrom(std::move(file), maple);
    const QString seen = QStringLiteral("hints/firstDrag");
    if (!view::stored(seen, false).toBool()) {
        m_canvas->setHint(tr(
            "Take the maple by a corner and pull. Or press D and define another triangle by three clicks."));
        connect(m_canvas, &view::CanvasView::hintDismissed, this, [seen] { view::store(seen, true); });
    }
}

bool MainWindow::openPath(const QString& path) {
    if (const io::Failure failure = m_file.open(path)) {
        fail(tr("%1 could not be opened").arg(QFileInfo(path).fileName()), *failure);
        return false;
    }
    reportOpened();
    return true;
}

void MainWindow::openEach(const QStringList& paths, MainWindow* first) {
    MainWindow* unused = first;
    for (const QString& path : paths) {
        MainWindow* window = unused ? unused : new MainWindow;
        window->show();
        unused = window->openPath(path) ? nullptr : window;
    }
}

void MainWindow::openRecovered(const document::Abandoned& abandoned) {
    const std::optional<io::Failure> recovered = m_file.recover(abandoned.snapshot);
    m_canvas->fit();
    if (!recovered)
        return say(
            tr("%1 was not recovered. It is offered again at the next start.").arg(abandoned.snapshot.title));
    m_recovery.takeOver(abandoned);
    say(tr("Recovered %1. It is not saved yet.").arg(abandoned.snapshot.title));
    if (const io::Failure& failure = *recovered)
        fail(tr("%1 could not be opened").arg(QFileInfo(abandoned.snapshot.path).fileName()),
             *failure + u' ' + tr("The unsaved work is here all the same."));
}

void MainWindow::showCollection() {
    auto* dock = findChild<QDockWidget*>(QStringLiteral("collection"));
    dock->show();
    dock->raise();
    if (auto* search = dock->findChild<QLineEdit*>()) search->setFocus();
}

void MainWindow::reportOpened() {
    qsizetype broken = 0;
    qsizetype bent = 0;
    for (const document::Entry& entry : m_document.file().entries) {
        if (document::dimension(*entry.fractal) == 0)
            ++broken;
        else if (!entry.problems.isEmpty())
            ++bent;
    }
    QString sentence = tr("%n entries", nullptr, int(m_document.file().entries.size()));
    if (broken > 0)
        sentence += tr(", %n of them could not be read and are kept as they are", nullptr, int(broken));
    if (bent > 0) sentence += tr(", %n read with a remark", nullptr, int(bent));
    say(sentence + u'.');
}

void MainWindow::chooseAndOpen() {
    if (!maySpoil()) return;
    const QString folder = m_file.path().isEmpty() ? QString() : QFileInfo(m_file.path()).path();
    const QString path = QFileDialog::getOpenFileName(this, tr("Open"), folder, fileFilter());
    if (!path.isEmpty()) openPath(path);
}

void MainWindow::openRecent(const QString& path) {
    if (maySpoil()) openPath(path);
}

bool MainWindow::maySpoil() {
    m_canvas->cancelGesture();
    if (!m_document.isModified()) return true;
    QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                    tr("“%1” has changes that are not saved.").arg(m_file.name()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setInformativeText(tr("Do you want to save them?"));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        return true;
    default:
        return false;
    }
}

bool MainWindow::save() {
    if (m_file.path().isEmpty()) return saveAs();
    const std::optional<bool> isChanged = m_file.changedOnDisk();
    if (!isChanged) return false;
    if (*isChanged) {
        QMessageBox box(
            QMessageBox::Warning, tr("Changed on disk"),
            tr("“%1” was changed by another program since it was opened here.").arg(m_file.name()),
            QMessageBox::Cancel, this);
        box.setInformativeText(tr("Saving replaces what the other program wrote."));
        QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
        QPushButton* elsewhere = box.addButton(tr("Save As…"), QMessageBox::AcceptRole);
        box.exec();
        if (box.clickedButton() == elsewhere) return saveAs();
        if (box.clickedButton() != replace) return false;
    }
    if (const io::Failure failure = m_file.save()) {
        fail(tr("%1 was not saved").arg(m_file.name()), *failure);
        return false;
    }
    say(tr("Saved %1.").arg(m_file.name()));
    return true;
}

bool MainWindow::saveAs() {
    const QString suggestion =
        m_file.path().isEmpty() ? m_document.fractal().name + QStringLiteral(".ifs") : m_file.path();
    const QString path = view::chooseFileToSave(this, tr("Save As"), suggestion,
                                                tr("Fractint collections (*.ifs)"), QStringLiteral("ifs"));
    if (path.isEmpty()) return false;
    if (const io::Failure failure = m_file.saveAs(path)) {
        fail(tr("%1 was not saved").arg(QFileInfo(path).fileName()), *failure);
        return false;
    }
    say(tr("Saved %1.").arg(m_file.name()));
    return true;
}

void MainWindow::revert() {
    if (m_document.isModified()) {
        const auto answer = QMessageBox::question(
            this, tr("Revert"),
            tr("Go back to “%1” as it is on disk? The changes made since then are lost.").arg(m_file.name()),
            QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel);
        if (answer != QMessageBox::Discard) return;
    }
    if (const io::Failure failure = m_file.revert())
        fail(tr("%1 could not be read again").arg(m_file.name()), *failure);
}

void MainWindow::fillRecent() {
    m_recentMenu->clear();
    for (const QString& path : recent_files::list()) {
        QAction* action =
            m_recentMenu->addAction(QFileInfo(path).fileName().replace(u'&', QLatin1String("&&")), this,
                                    [this, path] { openRecent(path); });
        action->setStatusTip(path);
    }
    if (m_recentMenu->isEmpty()) m_recentMenu->addAction(tr("No recent files"))->setEnabled(false);
    m_recentMenu->addSeparator();
    m_recentMenu->addAction(tr("Clear this list"), this, [] { recent_files::clear(); });
}

void MainWindow::updateTitle() {
    setWindowTitle(tr("%1[*] — %2", "file, entry").arg(m_file.name(), m_document.fractal().name));
    setWindowFilePath(m_file.path());
    setWindowModified(m_document.isModified());
}

void MainWindow::say(const QString& sentence) {
    m_status->showMessage(sentence, 8000);
}

void MainWindow::fail(const QString& title, const QString& sentence) {
    auto* box = new QMessageBox(QMessageBox::Critical, QApplication::applicationDisplayName(), title + u'.',
                                QMessageBox::Ok, this);
    box->setInformativeText(sentence);
    box->setAttribute(Qt::WA_DeleteOnClose);
    // One after the other: of two that are open, keys would reach neither.
    connect(box, &QMessageBox::finished, this, [this, box] {
        m_failures.removeOne(box);
        if (!m_failures.isEmpty()) m_failures.first()->open();
    });
    m_failures << box;
    if (m_failures.size() == 1) box->open();
}

void MainWindow::takeFocusFrom(const QWidget* hidden) {
    const QWidget* focused = QApplication::focusWidget();
    if (focused && hidden->isAncestorOf(focused)) m_canvas->setFocus();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_file.isBusy() || !maySpoil()) {
        event->ignore();
        return;
    }
    const bool presents = m_presentation->isChecked();
    view::store(QStringLiteral("window/geometry"), presents ? m_before.geometry : saveGeometry());
    view::store(QStringLiteral("window/state"), presents ? m_before.layout : saveState());
    session::remember();
    m_recovery.giveUp();
    event->accept();
}

void MainWindow::restoreLayout() {
    const double larger = fontMetrics().averageCharWidth() / usualLetter;
    resizeDocks(
        {findChild<QDockWidget*>(QStringLiteral("entries")), findChild<QDockWidget*>(QStringLiteral("maps"))},
        {int(260 * larger), int(430 * larger)}, Qt::Horizontal);
    if (!restoreGeometry(view::stored(QStringLiteral("window/geometry")).toByteArray()))
        resize(QSize(1440, 900).boundedTo(screen()->availableSize() * 0.95));
    if (const QWidget* other = QApplication::activeWindow(); other && other->pos() == pos())
        move(pos() + QPoint(cascade, cascade)); // both are to be seen
    restoreState(view::stored(QStringLiteral("window/state")).toByteArray());
    if (!toolBarBreak(m_branchBar)) insertToolBarBreak(m_branchBar); // as earlier versions left it
}

// The desktop, too, may fill the screen with the window.
void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange && m_fullScreen) m_fullScreen->setChecked(isFullScreen());
}

void MainWindow::present(bool on) {
    const auto bars = {findChild<QToolBar*>(QStringLiteral("arising")), m_branchBar};
    QList<bool> shown;
    for (const QToolBar* bar : bars)
        shown << !bar->isHidden();
    if (on) {
        m_before = {saveGeometry(), saveState(), isFullScreen()};
        for (auto* panel : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
            panel->hide();
        findChild<QToolBar*>(QStringLiteral("tools"))->hide();
        m_canvas->setFocus();
    }
    menuBar()->setVisible(!on);
    statusBar()->setVisible(!on);
    setWindowState(windowState().setFlag(Qt::WindowFullScreen, on || m_before.fullScreen));
    if (!on) {
        restoreState(m_before.layout);
        for (QToolBar* bar : bars)
            bar->setVisible(shown.takeFirst());
    }
    m_canvas->setHint(on ? tr("Esc brings menus and panels back.") : QString());
}

// Whatever has the focus takes it first.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_presentation->isChecked())
        m_presentation->setChecked(false);
    else if (event->key() == Qt::Key_F6)
        m_canvas->setFocus(Qt::OtherFocusReason); // which leaves it by the same key
    else
        QMainWindow::keyPressEvent(event);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    makeRoomForPicture();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (width() < event->oldSize().width()) makeRoomForPicture();
}

// In a window that is made narrow the panels yield, so that half of it is left to the picture.
void MainWindow::makeRoomForPicture() {
    const int missing = width() / 2 - m_canvas->width();
    if (missing <= 0) return;
    QList<QDockWidget*> beside;
    int together = 0;
    for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
        for (auto* panel : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
            if (dockWidgetArea(panel) == area && !panel->isFloating() && !panel->visibleRegion().isEmpty()) {
                beside << panel;
                together += panel->width();
                break;
            }
    if (together <= 0) return;
    QList<int> widths;
    for (const QDockWidget* panel : beside)
        widths << panel->width() - missing * panel->width() / together;
    resizeDocks(beside, widths, Qt::Horizontal);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    if (paths.isEmpty()) return;
    // Once the drop is over: questions may follow, and the program that it came from waits.
    QMetaObject::invokeMethod(
        this,
        [this, paths] {
            if (maySpoil()) openEach(paths, this);
        },
        Qt::QueuedConnection);
}
