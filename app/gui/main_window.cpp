// SPDX-License-Identifier: MIT
#include "main_window.h"

#include "actions/action_details.h"
#include "actions/tool_bar.h"
#include "bars/construction_bar.h"
#include "bars/tool_options_bar.h"
#include "bars/zoom_box.h"
#include "desktop/preferences.h"
#include "desktop/settings.h"
#include "desktop/shortcuts.h"
#include "dialogs/paste_table_dialog.h"
#include "files/collection_commands.h"
#include "files/dropped_picture.h"
#include "files/exports.h"
#include "files/file_commands.h"
#include "focus_walk.h"
#include "io/file/background.h"
#include "lessons/lesson_commands.h"
#include "menus/animation_menu.h"
#include "menus/cage_menu.h"
#include "menus/discover_menu.h"
#include "menus/edit_menu.h"
#include "menus/file_menu.h"
#include "menus/help_menu.h"
#include "menus/maps_menu.h"
#include "menus/saved_views_menu.h"
#include "menus/snapshot_commands.h"
#include "menus/teach_menu.h"
#include "menus/view_menu.h"
#include "messages/flame_banner.h"
#include "panels/analysis/analysis_panel.h"
#include "panels/appearance/appearance_panel.h"
#include "panels/cage/cage_panel.h"
#include "panels/collage/collage_panel.h"
#include "panels/collection/collection_panel.h"
#include "panels/entries/entries_panel.h"
#include "panels/exports/exports_panel.h"
#include "panels/history/history_panel.h"
#include "panels/lesson/lesson_panel.h"
#include "panels/links/links_panel.h"
#include "panels/maps/maps_panel.h"
#include "panels/problems/problems_panel.h"
#include "panels/snapshots/snapshots_panel.h"
#include "panels/timeline/timeline_panel.h"
#include "room_for_picture.h"
#include "session/stored_layout.h"
#include "session/window_place.h"
#include "stage/class_marks.h"
#include "stage/maps_connections.h"
#include "stage/opened_motion.h"
#include "stage/stage.h"
#include "stage/status_connections.h"
#include "stage/status_line.h"
#include "widgets/accept_as_copy.h"
#include "widgets/icon.h"
#include "widgets/layout/vertical_scroll_area.h"
#include "widgets/numbers/draggable_names.h"
#include "widgets/text/tooltip_text.h"
#include "widgets/whats_this.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QPointer>
#include <QResizeEvent>
#include <QScrollArea>
#include <QToolBar>
#include <QToolButton>

#include <utility>

namespace {

constexpr double usualLetter = 6;   // pixels; width of a letter in the font of the first sizes
constexpr int problemsHeight = 150; // a few lines, so that the picture stays the largest part of the window

// Layouts, lessons and small windows hide a panel; its button and its menu close it.
class ClosingWatch : public QObject {
public:
    explicit ClosingWatch(QWidget* panel) : QObject(panel) { panel->installEventFilter(this); }
    bool wasClosed() const { return m_wasClosed; }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        m_wasClosed = m_wasClosed || event->type() == QEvent::Close;
        return false;
    }

private:
    bool m_wasClosed = false;
};

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : SessionWindow(parent),
      m_file(&m_document, this),
      m_recovery(&m_document, &m_file, nullptr),
      m_bridge(new view::RenderBridge(&m_document, this)),
      m_solid(new view::SolidBridge(&m_document, this)),
      m_analysis(new view::AnalysisBridge(&m_document, this)),
      m_construction(new view::Construction(&m_document, m_bridge, this)),
      m_stage(new Stage(&m_document, m_bridge, m_solid, this)),
      m_room(new RoomForPicture(this, m_stage)),
      m_canvas(m_stage->plane()),
      m_timeline(new view::TimelinePanel(&m_document, this)),
      m_collage(new view::CollagePanel(&m_document, m_canvas, this)),
      m_status(new StatusLine(this)),
      m_messages(new WindowMessages(this)),
      m_fileCommands(
          new FileCommands({this, &m_document, m_canvas, m_messages, m_stage, &m_panels}, &m_file)),
      m_snapshots(
          new SnapshotCommands({this, &m_document, m_canvas, m_messages, m_stage, &m_panels}, m_bridge)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::West); // leaves room for the names in any language
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);
    setCentralWidget(m_stage);
    setStatusBar(m_status);
    m_status->follow(m_document);

    adopt(view::Preferences::stored());
    createMenus();
    createPanels();
    createTimeline();
    createLesson();
    m_snapshots->setDock(dock(Panel::Snapshots, m_snapshots->makePanel()));
    m_fileCommands->setSnapshots(m_snapshots->snapshots());
    createToolBar();
    auto* zoom = new view::ZoomBox(m_canvas);
    m_status->addPermanentWidget(zoom);
    m_viewMenu->savedViews()->serve(zoom);
    connect(m_stage, &Stage::switched, zoom, [this, zoom] { zoom->setVisible(!m_stage->showsSpace()); });
    connectStatus(m_status, m_stage, m_bridge, m_solid);
    connectDocument();
    view::explainByTips(this);
    view::makeNamesDraggable(this);
    restoreLayout();
    m_stage->takeFocus();
}

MainWindow::~MainWindow() {
    hide();                                   // commits fields being edited while there is still a document
    m_document.undoStack()->disconnect(this); // before the stack is cleared, because the title needs the file
    connect(this, &QObject::destroyed, qApp,
            [file = m_document.file()]() mutable { // runs after the panels have been destroyed
                io::freeInBackground(std::move(file));
            });
}

void MainWindow::createMenus() {
    const MenuContext context{this, &m_document, m_canvas, m_messages, m_stage, &m_panels};
    auto* file = new FileMenu(context, m_fileCommands, &m_file, [] {
        auto* window = new MainWindow;
        window->openFirstPicture();
        window->show();
    });
    auto* edit = new EditMenu(context, *m_snapshots);
    auto* cage = new CageMenu(context);
    auto* maps = new MapsMenu(context);
    m_animationMenu = new AnimationMenu(context, m_timeline);
    m_viewMenu = new ViewMenu(context);
    m_discoverMenu = new DiscoverMenu(context, [this] { showCollection(); });
    m_teachMenu = new TeachMenu(context, [this](bool on) { present(on); });
    m_lessons = new LessonCommands(context, {this, &m_document, m_stage, m_analysis, m_construction},
                                   m_teachMenu->presentation());
    createConstructionBar();
    m_teachMenu->addMenu(m_lessons);
    m_teachMenu->addHandout(&m_file);
    createOptionsBar();
    m_menus = {file,
               edit,
               cage,
               maps,
               m_animationMenu,
               m_viewMenu,
               m_discoverMenu,
               m_teachMenu,
               new HelpMenu(context)};
    for (ActionMenu* menu : m_menus)
        menuBar()->addMenu(menu);
}

QDockWidget* MainWindow::dock(Panel panel, QWidget* content) {
    const PanelFacts facts = factsOf(panel);
    auto* made = new QDockWidget(facts.title, this);
    m_panels.add(panel, made);
    made->setObjectName(QLatin1String(ifs::nameOf(panel)));
    made->setWidget(qobject_cast<QScrollArea*>(content) ? content : new view::PanelArea(content));
    made->setWhatsThis(facts.whatsThis);
    addDockWidget(facts.area, made);
    made->toggleViewAction()->setObjectName(QStringLiteral("panel-") + made->objectName());
    view::adoptShortcuts(*made->toggleViewAction());
    addAction(made->toggleViewAction()); // keeps the shortcut active while the menu bar is hidden
    m_viewMenu->panels()->addAction(made->toggleViewAction());
    made->toggleViewAction()->setStatusTip(tr("Show or hide the “%1” panel").arg(facts.title));
    made->toggleViewAction()->setToolTip(made->toggleViewAction()->statusTip());
    made->toggleViewAction()->setWhatsThis(made->toggleViewAction()->statusTip() + QStringLiteral(". ") +
                                           facts.whatsThis);
    // A panel behind another tab is shown, not hidden. Queued, so that the action sees the state before it.
    connect(
        made, &QDockWidget::visibilityChanged, made,
        [made](bool isSeen) { made->setProperty("isSeen", isSeen); }, Qt::QueuedConnection);
    connect(made->toggleViewAction(), &QAction::triggered, made, [made](bool on) {
        if (!on && made->property("isSeen").toBool()) return;
        made->show();
        made->raise();
    });
    // A panel behind another one would continue to receive keys unseen.
    connect(made, &QDockWidget::visibilityChanged, this, [this, made](bool visible) {
        if (!visible) takeFocusFrom(made);
    });
    return made;
}

void MainWindow::createPanels() {
    auto* entries = new view::EntriesPanel(&m_document);
    auto* collection = new view::CollectionPanel;
    auto* maps = new view::MapsPanel(&m_document);
    auto* cage = new view::CagePanel(&m_document);
    auto* appearance = new view::AppearancePanel(&m_document);
    auto* analysis = new view::AnalysisPanel(&m_document, m_analysis);
    analysis->addOutlineAction(m_viewMenu->numbers(), tr("Map numbers"));

    dock(Panel::Entries, entries);
    splitDockWidget(m_panels.dock(Panel::Entries), dock(Panel::Collection, collection), Qt::Vertical);
    QDockWidget* previous = dock(Panel::Maps, maps);
    for (QDockWidget* next :
         {dock(Panel::Cage, new view::VerticalScrollArea(cage)),
          dock(Panel::Appearance, new view::VerticalScrollArea(appearance)), dock(Panel::Analysis, analysis),
          dock(Panel::History, new view::HistoryPanel(&m_document))}) {
        tabifyDockWidget(previous, next);
        previous = next;
    }
    createCollage();
    for (const Panel late : {Panel::Analysis, Panel::History}) // created by View, Panels
        m_panels.dock(late)->hide();
    auto* links = new view::LinksPanel(&m_document);
    QDockWidget* linksDock = dock(Panel::Links, links);
    tabifyDockWidget(previous, linksDock);
    linksDock->hide();
    QDockWidget* exportsDock = dock(Panel::Exports, new view::ExportsPanel(exports::queue()));
    tabifyDockWidget(previous, exportsDock);
    exports::connectPanel(exportsDock, m_messages);
    m_panels.dock(Panel::Maps)->raise();
    createProblems();

    connectMaps(maps, m_canvas, m_stage, m_document, m_messages);
    connect(entries, &view::EntriesPanel::message, m_messages, &WindowMessages::say);
    connect(entries, &view::EntriesPanel::flamesPasted, this,
            [this](const QList<document::EntryId>& ids) { FlameBanner::offer(this, m_document, ids); });
    connect(links, &view::LinksPanel::message, m_messages, &WindowMessages::say);
    connect(cage, &view::CagePanel::message, m_messages, &WindowMessages::say);
    connect(analysis, &view::AnalysisPanel::message, m_messages, &WindowMessages::say);
    connect(appearance, &view::AppearancePanel::message, m_messages, &WindowMessages::say);
    connect(cage, &view::CagePanel::defineRequested, m_canvas,
            [this] { m_canvas->setTool(view::CanvasView::Tool::DefineTriangle); });
    connect(m_room, &RoomForPicture::hidden, m_messages, [this](const QStringList& titles) {
        m_messages->say(
            tr("Hidden in this small window: %1 (View › Panels).").arg(titles.join(QStringLiteral(", "))));
    });
    showEntriesWithSeveral();
    connectCollection(
        collection, {&m_document, &m_file, m_fileCommands, [this] { m_discoverMenu->showTransformation(); }});
}

// The list of entries appears with every file of several, but not with the first picture, whose other entries
// nobody asked for; nor in a window in which the user has closed it.
void MainWindow::showEntriesWithSeveral() {
    QDockWidget* entries = m_panels.dock(Panel::Entries);
    entries->hide();
    const auto* watch = new ClosingWatch(entries);
    connect(&m_document, &document::Document::changed, entries,
            [this, entries, watch](const document::Change& change) {
                using document::Change;
                const bool isNews = change.parts & (Change::File | Change::Entries) && !m_opensFirstPicture;
                if (!isNews || m_document.file().entries.size() < 2 || m_room->isSmall() ||
                    menuBar()->isHidden() || !entries->isHidden() || watch->wasClosed())
                    return;
                entries->show();
                resizeDocks({entries, m_panels.dock(Panel::Collection)}, {1, 1}, Qt::Vertical);
            });
}

void MainWindow::createProblems() {
    auto* problems = new view::ProblemsPanel(&m_document);
    QDockWidget* problemsDock = dock(Panel::Problems, problems);
    problemsDock->hide();
    connect(problems, &view::ProblemsPanel::countChanged, problemsDock, [this, problemsDock](int count) {
        const bool appears = count > 0 && problemsDock->isHidden();
        problemsDock->setVisible(count > 0);
        if (appears) resizeDocks({problemsDock}, {problemsHeight}, Qt::Vertical);
    });
    connect(&m_file, &OpenFile::pathChanged, problems,
            [this, problems] { problems->setFileName(m_file.name()); });
}

void MainWindow::createCollage() {
    QDockWidget* collage = dock(Panel::Collage, new view::VerticalScrollArea(m_collage));
    tabifyDockWidget(m_panels.dock(Panel::History), collage);
    collage->hide();
    m_discoverMenu->addCollage(collage->toggleViewAction());
    connect(m_collage, &view::CollagePanel::message, m_messages, &WindowMessages::say);
}

void MainWindow::createTimeline() {
    QDockWidget* timeline = dock(Panel::Timeline, m_timeline);
    timeline->hide();
    m_animationMenu->setDock(timeline);
    const auto count = [this] { m_timeline->timeline().playback().countPicture(); };
    connect(m_bridge, &view::RenderBridge::frameChanged, m_timeline, [this, count] {
        if (m_bridge->frame() && m_bridge->frame()->passes == 1) count();
    });
    connect(m_solid, &view::SolidBridge::frameChanged, m_timeline, count);
    new OpenedMotion({&m_document, &m_timeline->timeline().playback(),
                      [this] { m_animationMenu->showDock(); },
                      [this] { return m_lessons->player().isPlaying(); }},
                     this);
}

void MainWindow::createLesson() {
    QDockWidget* lesson = dock(Panel::Lesson, m_lessons->panel());
    tabifyDockWidget(m_panels.dock(Panel::History), lesson);
    lesson->hide();
    m_panels.dock(Panel::Maps)->raise(); // front of the new tabs
    m_lessons->setPanels(m_panels);
    m_lessons->setFiles(m_fileCommands, &m_file);
    m_recovery.follow(&m_lessons->notebook());
    m_lessons->addBuiltIn(m_lessons->addMenu(tr("&Ready-Made Lessons")), [] {
        auto* window = new MainWindow;
        window->show();
        return window->m_lessons;
    });
}

// Dialogs explain themselves before they are seen.
void MainWindow::childEvent(QChildEvent* event) {
    SessionWindow::childEvent(event);
    if (!event->polished() || !event->child()->isWidgetType()) return;
    if (auto* widget = static_cast<QWidget*>(event->child()); widget->isWindow()) {
        view::explainByTips(widget);
        view::makeNamesDraggable(widget);
    }
}

void MainWindow::createConstructionBar() {
    auto* bar = new QToolBar(tr("How It Is Built"), this);
    bar->setObjectName(QStringLiteral("construction"));
    bar->setMovable(false);
    bar->addWidget(new view::ConstructionBar(m_construction));
    addToolBar(Qt::BottomToolBarArea, bar);
    bar->hide();
    QAction* shown = bar->toggleViewAction();
    shown->setObjectName(QStringLiteral("how-it-is-built"));
    shown->setText(tr("How It Is &Built"));
    shown->setIcon(view::icon(QStringLiteral("construction")));
    shown->setShortcut(QKeySequence(tr("W")));
    shown->setStatusTip(
        tr("Watch the attractor being built: in steps of the deterministic algorithm, or by the chaos game"));
    shown->setWhatsThis(shown->statusTip() + QStringLiteral(". ") + actionDetails("construction"));
    bar->setWhatsThis(shown->whatsThis());
    m_teachMenu->addShared(shown);
    connect(bar, &QToolBar::visibilityChanged, this, [this, bar](bool visible) {
        if (!visible) takeFocusFrom(bar);
    });
    m_discoverMenu->alternateWith(m_construction);
    connect(shown, &QAction::toggled, m_construction, [this](bool on) {
        if (!on) m_construction->setMode(view::Construction::Mode::Density);
    });
}

void MainWindow::createOptionsBar() {
    m_optionsBar = new QToolBar(tr("Tool Options"), this);
    m_optionsBar->setObjectName(QStringLiteral("tool-options"));
    m_optionsBar->setMovable(false);
    auto* options = new view::ToolOptionsBar(&m_document, m_canvas);
    options->setSpaceView(m_stage->space());
    connect(m_stage->compare(), &view::ComparePane::created, options, &view::ToolOptionsBar::setBeside);
    m_optionsBar->addWidget(options);
    addToolBarBreak(Qt::BottomToolBarArea); // side by side the two bars would widen a small window
    addToolBar(Qt::BottomToolBarArea, m_optionsBar);
    connect(m_stage, &Stage::switched, options, [this, options] {
        if (m_stage->showsSpace())
            m_canvas->setTool(view::CanvasView::Tool::Cage); // most other tools need the plane
        options->setSpace(m_stage->showsSpace());
    });
    QAction* shown = m_optionsBar->toggleViewAction();
    shown->setStatusTip(tr("Show the options of the tool under the canvas"));
    shown->setToolTip(shown->statusTip());
    shown->setWhatsThis(tr("A bar with the options of the current tool, or a reminder of how to use it."));
    m_optionsBar->setWhatsThis(shown->whatsThis());
}

void MainWindow::createToolBar() {
    QList<QList<QAction*>> groups;
    for (const ActionMenu* menu : m_menus)
        groups << menu->toolBarGroups();
    m_toolBar = new ToolBar(tr("Tools"), groups, this);
    addToolBar(m_toolBar);
    m_viewMenu->panels()->addSeparator();
    m_viewMenu->panels()->addAction(m_toolBar->toggleViewAction());
    m_viewMenu->panels()->addAction(m_optionsBar->toggleViewAction());
}

void MainWindow::connectDocument() {
    connect(&m_document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        const bool isAnother = change.parts & (Change::System | Change::Current | Change::File);
        if (isAnother || (!change.live && change.parts & Change::Cage))
            QMetaObject::invokeMethod( // queued, since nothing depends on it
                m_status, [this] { m_status->showVerdict(m_document.fractal()); }, Qt::QueuedConnection);
        if (!change.live && change.parts & (Change::Name | Change::Current | Change::File)) updateTitle();
    });
    connect(m_document.undoStack(), &QUndoStack::cleanChanged, this, &MainWindow::updateTitle);
    connect(&m_file, &OpenFile::pathChanged, this, &MainWindow::updateTitle);
    connect(&m_file, &OpenFile::isOpenElsewhere, this, [this] {
        m_messages->say(
            tr("%1 is also open in another window of Barycage. Whichever saves last replaces what "
               "the other saved.")
                .arg(m_file.name()));
    });
    connect(&m_file, &OpenFile::orderAssumed, this, [this](const QString& table) {
        view::PasteTableDialog::askForColumns(&m_document, table, this);
    });
    connect(&m_file, &OpenFile::flamesOpened, this, [this] {
        QList<document::EntryId> flames;
        for (const document::Entry& entry : m_document.file().entries)
            flames << entry.id;
        FlameBanner::offer(this, m_document, flames);
    });
    connect(m_canvas, &view::CanvasView::message, m_messages, &WindowMessages::say);
    connect(m_stage->space(), &view::SpaceView::message, m_messages, &WindowMessages::say);
    connect(&m_recovery, &Recovery::cannotKeep, this,
            [this](const QString& sentence) { m_messages->fail(tr("Recovery Unavailable"), sentence); });
    connect(view::storingReport(), &view::StoringReport::cannotStore, m_messages, &WindowMessages::say);
    connect(&m_recovery, &Recovery::lateChanged, m_status, &StatusLine::showRecovery);
    addClassMarks(*m_canvas, *m_construction);
    connect(m_analysis, &view::AnalysisBridge::changed, m_canvas, [this] {
        const auto analysis = m_analysis->analysis();
        using Shapes = std::vector<document::OutlineShape>;
        m_canvas->showOutlines(analysis ? analysis->shapes : Shapes(),
                               analysis ? analysis->outerCylinders : Shapes());
        m_stage->views()->showOutlines(analysis ? analysis->shapesInSpace
                                                : std::vector<document::SpaceOutline>());
    });
    m_status->showVerdict(m_document.fractal());
    updateTitle();
}

void MainWindow::addRandom() {
    m_discoverMenu->addRandom();
}

void MainWindow::adopt(const view::Preferences& preferences) {
    m_bridge->setQuality(preferences.quality);
    m_stage->space()->navigation().setTrackball(preferences.trackball);
    m_stage->compare()->setTrackball(preferences.trackball);
    if (m_toolBar) m_toolBar->adopt(preferences); // created later otherwise, with the stored preferences
}

void MainWindow::showCollection() {
    m_panels.dock(Panel::Collection)->findChild<view::CollectionPanel*>()->browse();
}

void MainWindow::updateTitle() {
    setWindowTitle(tr("%1[*] — %2", "file, entry")
                       .arg(view::titleText(m_file.name()), view::titleText(m_document.fractal().name)));
    setWindowFilePath(m_file.path());
    setWindowModified(m_document.isModified());
}

void MainWindow::takeFocusFrom(const QWidget* hidden) {
    const QWidget* focused = QApplication::focusWidget();
    if (focused && hidden->isAncestorOf(focused)) m_stage->takeFocus();
}

bool MainWindow::mayClose(Leaving leaving) {
    const bool isReading = m_file.isReading();
    m_file.stopReading();
    m_mayClose =
        (!m_file.isBusy() || isReading) && m_fileCommands->maybeSave() && exports::mayEnd(this, leaving);
    return m_mayClose;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool isReading = m_file.isReading(); // such a reading still uses the window
    if (!std::exchange(m_mayClose, false) && !mayClose(Leaving::Window)) return event->ignore();
    m_mayClose = false;
    const bool presents = m_teachMenu->presentation()->isChecked();
    if (!presents) m_room->showHiddenPanels();
    view::store(QStringLiteral("window/geometry"), presents ? m_before.geometry : saveGeometry());
    view::store(QStringLiteral("window/state"), presents ? m_before.layout : saveState());
    session::remember();
    m_recovery.giveUp();
    if (isReading) {
        setAttribute(Qt::WA_DeleteOnClose, false);
        connect(&m_file, &OpenFile::stopped, this, &QObject::deleteLater);
    }
    event->accept();
}

void MainWindow::restoreLayout() {
    const double larger = fontMetrics().averageCharWidth() / usualLetter;
    resizeDocks({m_panels.dock(Panel::Entries), m_panels.dock(Panel::Maps)},
                {int(260 * larger), int(430 * larger)}, Qt::Horizontal);
    placeWindow(this, view::stored(QStringLiteral("window/geometry")).toByteArray());
    m_isAsItWasLeft = restoreStoredLayout(this, view::stored(QStringLiteral("window/state")).toByteArray());
    if (!toolBarBreak(m_optionsBar)) insertToolBarBreak(m_optionsBar); // as earlier versions left it
}

// The desktop, too, may fill the screen with the window.
void MainWindow::changeEvent(QEvent* event) {
    SessionWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange && m_viewMenu)
        m_viewMenu->fullScreen()->setChecked(isFullScreen());
}

void MainWindow::present(bool on) {
    auto* construction = findChild<QToolBar*>(QStringLiteral("construction"));
    const bool isBuilding = !construction->isHidden();
    if (on) {
        m_before = {saveGeometry(), saveState(), isFullScreen()};
        for (auto* panel : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
            panel->hide();
        findChild<QToolBar*>(QStringLiteral("tools"))->hide();
        m_optionsBar->hide();
        m_stage->takeFocus();
    }
    menuBar()->setVisible(!on);
    statusBar()->setVisible(!on);
    setWindowState(windowState().setFlag(Qt::WindowFullScreen, on || m_before.fullScreen));
    if (!on) {
        restoreState(m_before.layout);
        construction->setVisible(isBuilding);
    }
    m_canvas->setHint(on ? tr("Press Esc to bring back the menus and panels.") : QString());
}

// Whatever has the focus takes it first.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_teachMenu->presentation()->isChecked())
        m_teachMenu->presentation()->setChecked(false);
    else if (event->key() == Qt::Key_F6)
        walkFocus(*this, event->modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1);
    else
        SessionWindow::keyPressEvent(event);
}

void MainWindow::showEvent(QShowEvent* event) {
    SessionWindow::showEvent(event);
    m_room->windowShown(m_isAsItWasLeft);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    SessionWindow::resizeEvent(event);
    m_room->windowResized(event->oldSize());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) view::acceptAsCopy(*event);
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    if (paths.isEmpty()) return event->ignore();
    view::acceptAsCopy(*event);
    // Runs after the drop: questions may follow, and the source of the drag waits.
    QMetaObject::invokeMethod(
        this,
        [this, paths, self = QPointer(this)] {
            if (takeAsTarget(paths, *this, m_panels, *m_collage) || !self) return;
            const QStringList agreed = askWhichToOpen(paths, this);
            if (!agreed.isEmpty() && self && m_fileCommands->maybeSave()) openEach(agreed, this);
        },
        Qt::QueuedConnection);
}
